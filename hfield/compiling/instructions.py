"""Write functions in LLVM's notation: values, memory, calls, branches and loops.

A value is a name such as ``%v3``, or the text of a constant; its type is given where it is used.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Sequence


class Code:
    """A function in LLVM's language under construction: its lines, and the functions that it calls.

    Repeating a text returns the same value, until memory is written or another block begins.
    """

    def __init__(self, head: str = "") -> None:
        """Begin with the header: linkage, type, name, parameters ``%…`` and attributes."""
        self.head = head
        self.lines: list[str] = []
        self.declared: set[str] = set()
        self.conditions: list[
            str
        ] = []  # values that the writer of the loop combines into one result
        self._known: dict[str, str] = {}
        self._count = 0
        self._label = "start"

    def value(self, text: str) -> str:
        """Return the name of the value computed by ``text``."""
        name = self._known.get(text)
        if name is None:
            name = self._known[text] = f"%v{self._number()}"
            self.lines.append(f"{name} = {text}")
        return name

    def once(self, text: str) -> str:
        """Return the name of the value that ``text`` computes this time, for instance a call that writes."""
        self._known.clear()
        return self.value(text)

    def do(self, text: str) -> None:
        """Add a line without a value."""
        self._known.clear()
        self.lines.append(text)

    def call(self, kind: str, name: str, *arguments: tuple[str, str]) -> str:
        """Emit a call of an external function, with types and values; return the name of its result."""
        given = ", ".join(f"{k} {value}" for k, value in arguments)
        self.declared.add(f"declare {kind} @{name}({', '.join(k for k, _ in arguments)})")
        text = f"call {kind} @{name}({given})"
        if kind != "void":
            return self.value(text)
        self.do(text)
        return ""

    def end(self, result: str = "void") -> None:
        """Return from the function, with a type and a value."""
        self.do(f"ret {result}")

    def _number(self) -> int:
        self._count += 1
        return self._count

    # --- memory --------------------------------------------------------------------------------

    def at(self, kind: str, pointer: str, index: str | int) -> str:
        """Return the address of the array entry with an index."""
        return self.value(f"getelementptr {kind}, ptr {pointer}, i64 {index}")

    def load(self, kind: str, pointer: str, align: int = 0) -> str:
        """Read a value at an address that is a multiple of ``align``; 0 means the alignment of its type."""
        return self.value(f"load {kind}, ptr {pointer}" + (f", align {align}" if align else ""))

    def store(self, kind: str, value: str, pointer: str, align: int = 0, how: str = "") -> None:
        """Write a value."""
        self.do(f"store {kind} {value}, ptr {pointer}{f', align {align}' if align else ''}{how}")

    def entries(self, kind: str, table: str, count: int) -> list[str]:
        """Read the first entries of an array."""
        return [self.load(kind, self.at(kind, table, n)) for n in range(count)]

    def allocate(self, kind: str) -> str:
        """Return the address of memory that belongs to the function."""
        return self.once(f"alloca {kind}, align 64")

    def copy(self, to: str, start: str, size: str | int) -> None:
        """Copy bytes."""
        flags = ("i64", str(size)), ("i1", "false")
        self.call("void", "llvm.memcpy.p0.p0.i64", ("ptr", to), ("ptr", start), *flags)

    def ahead(self, place: str, writing: bool = False) -> None:
        """Prefetch a cache line, which may lie outside the array."""
        flags = (("i32", str(n)) for n in (int(writing), 3, 1))
        self.call("void", "llvm.prefetch.p0", ("ptr", place), *flags)

    # --- vectors -------------------------------------------------------------------------------

    def spread(self, kind: str, number: str, lanes: int) -> str:
        """Return the vector with the same number in each lane."""
        whole = vector(kind, lanes)
        first = self.value(f"insertelement {whole} poison, {kind} {number}, i32 0")
        return self.value(
            f"shufflevector {whole} {first}, {whole} poison, {vector('i32', lanes)} zeroinitializer"
        )

    def shuffled(self, kind: str, a: str, b: str, places: Iterable[int]) -> str:
        """Gather numbers from two vectors of one kind, by their positions in both."""
        numbers = list(places)
        mask = ", ".join(f"i32 {n}" for n in numbers)
        return self.value(
            f"shufflevector {kind} {a}, {kind} {b}, {vector('i32', len(numbers))} <{mask}>"
        )

    # --- branches and loops --------------------------------------------------------------------

    def _begin(self, label: str) -> None:
        self._known.clear()
        self.lines.append(f"{label}:")
        self._label = label

    def when(
        self,
        condition: str,
        then: Callable[[], Iterable[tuple[str, str, str]] | None],
        rarely: bool = False,
    ) -> list[str]:
        """Emit a conditional block; return the value that it computes, or the alternative.

        ``then`` returns types, values, and the values if the condition does not hold. With ``rarely``, the
        block must not take registers from the code that always runs.
        """
        n, before = self._number(), self._label
        seldom = ', !prof !{!"branch_weights", i32 1, i32 100000}' if rarely else ""
        self.do(f"br i1 {condition}, label %then{n}, label %join{n}{seldom}")
        self._begin(f"then{n}")
        found = list(then() or ())
        after = self._label
        self.do(f"br label %join{n}")
        self._begin(f"join{n}")
        return [
            self.once(f"phi {kind} [ {there}, %{after} ], [ {here}, %{before} ]")
            for kind, there, here in found
        ]

    def leave(self, condition: str, result: Callable[[], str]) -> None:
        """Return from the function if a condition holds."""
        n = self._number()
        self.do(f"br i1 {condition}, label %leave{n}, label %stay{n}")
        self._begin(f"leave{n}")
        self.end(result())
        self._begin(f"stay{n}")

    def repeat(
        self,
        first: Sequence[tuple[str, str]],
        turn: Callable[..., tuple[str, Sequence[str]]],
        marks: str = "",
    ) -> Sequence[str]:
        """Write a loop that runs at least once; return its values after the last iteration.

        Parameters
        ----------
        first : sequence of pairs of str
            The types of the values that are passed from one iteration to the next, and their initial values.
        turn : callable
            ``turn(*values)`` writes one iteration; it returns the condition for another iteration, and the
            values passed to it.
        marks : str
            The metadata of the loop.
        """
        n, before = self._number(), self._label
        names = [f"%s{n}.{k}" for k in range(len(first))]
        self.do(f"br label %turn{n}")
        self._begin(f"turn{n}")
        top = len(self.lines)
        again, later_values = turn(*names)
        after = self._label
        self.lines[top:top] = [
            f"{name} = phi {kind} [ {value}, %{before} ], [ {later}, %{after} ]"
            for name, (kind, value), later in zip(names, first, later_values, strict=True)
        ]
        self.do(f"br i1 {again}, label %turn{n}, label %over{n}{marks}")
        self._begin(f"over{n}")
        return later_values

    def loop(
        self,
        start: str,
        end: str,
        turn: Callable[..., Sequence[str] | None],
        step: int = 1,
        first: Sequence[tuple[str, str]] = (),
        marks: str = "",
    ) -> list[str]:
        """Write a loop over i = start, start + step, … below ``end``, of 64 bits.

        ``turn(i, *values)`` writes one iteration and returns the values of the next; see `repeat` for the
        rest.
        """

        def turned(i: str, *values: str) -> tuple[str, Sequence[str]]:
            later_values = turn(i, *values) or ()
            beyond = self.value(f"add nuw nsw i64 {i}, {step}")
            return self.value(f"icmp slt i64 {beyond}, {end}"), (beyond, *later_values)

        def turns() -> list[tuple[str, str, str]]:
            _, *found = self.repeat([("i64", start), *first], turned, marks)
            return [(kind, late, here) for (kind, here), late in zip(first, found, strict=True)]

        return self.when(self.value(f"icmp slt i64 {start}, {end}"), turns)


def module(*functions: Code, notes: Iterable[str] = ()) -> str:
    """Write a program of functions, with declarations of the functions that they call."""
    declared = sorted(set().union(*(f.declared for f in functions)))
    defined = (line for f in functions for line in (f"define {f.head} {{", "start:", *f.lines, "}"))
    return "\n".join([*declared, *defined, *notes]) + "\n"


def vector(kind: str, lanes: int) -> str:
    """Return LLVM's name of the vector type with so many numbers."""
    return f"<{lanes} x {kind}>"


def alike(kind: str, number: object, lanes: int) -> str:
    """Write the vector with one number, known at compile time, in each lane."""
    return f"<{', '.join([f'{kind} {number}'] * lanes)}>"


def raw_type(dtype: str, lanes: int = 1) -> str:
    """Return LLVM's name of the integer type for a numpy type such as ``u2``, or of a vector of them."""
    kind = f"i{8 * int(dtype[1])}"
    return kind if lanes == 1 else vector(kind, lanes)


def floating(x: float, word: str) -> str:
    """Write a number as LLVM's ``float`` or ``double``, with exactly the value rounded to that type."""
    if word == "float":
        (x,) = struct.unpack("<f", struct.pack("<f", x))
    return f"0x{struct.unpack('<Q', struct.pack('<d', x))[0]:016X}"
