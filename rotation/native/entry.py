"""The entry of a compiled formula, a builtin function in LLVM: check the arguments, make the result.

`rotation.native.builtins.compile_builtin` documents its arguments and results.
"""

from collections.abc import Callable
from functools import reduce

import numpy as np

from hfield.compiling.instructions import Code

MUCH = 200_000  # numbers that are worth asking whether a second thread pays
HEAD = object.__basicsize__
KIND = HEAD - 8  # the offset of an object's class
# Where numpy's header has them:
DATA, NDIM, LENGTHS, DTYPE, FLAGS = (HEAD + n for n in (0, 8, 16, 40, 48))
USABLE, WRITEABLE = 0x0001 | 0x0100, 0x0400  # C order, aligned
NUMBERS = {"double": 12, "float": 11}  # of numpy's types
MAX_AXES = 64  # axes of an array of numpy's
METHOD = 32  # bytes of a PyMethodDef

Shape = tuple[int, ...]


class Entry(Code):
    """The builtin function: it checks the arrays, allocates the result and fills it."""

    def __init__(
        self, shapes: tuple[Shape, ...], moving: list[int], words: tuple[str, ...], slot: int
    ) -> None:
        super().__init__("ptr @entry(ptr %self, ptr %args, i64 %nargs)")
        (*shapes_in, self.row), self.word = shapes, words[-1]
        self.lengths = self.allocate(f"[{MAX_AXES} x i64]")
        method = self.load("ptr", self.at("i8", "%self", DATA))
        known = self.entries("ptr", self.at("i8", method, METHOD), 6)
        self.ndarray, self.number, self.none, self.one = known[:4]
        self.dtypes = dict(zip(NUMBERS, known[4:], strict=True))
        self.require(self.value(f"icmp eq i64 %nargs, {len(shapes)}"))
        where, *given = self.entries("ptr", "%args", len(shapes))
        filling = self.is_a(where, self.ndarray)
        data, axes, starts = self.arguments(given, shapes_in, words)
        ones, rows, batch, start = self.common(axes, starts, shapes_in, moving)
        total = self.value(f"mul i64 {rows}, {int(np.prod(self.row))}")
        making = self.value(f"xor i1 {filling}, true")
        (out,) = self.when(making, lambda: [("ptr", self.new(total, batch, start), where)])
        count, lengths, fits = self.header(out, self.word)
        numbers = self.once(f"call i64 @product(ptr {lengths}, i64 {count})")
        self.require(fits, self.value(f"icmp eq i64 {numbers}, {total}"))
        passed = "".join(f", ptr {d}, i1 {one}" for d, one in zip(data, ones, strict=True))
        target = self.load("ptr", self.at("i8", out, DATA))
        flag = self.once(f"call i1 @rows(i64 {rows}{passed}, ptr {target})")
        self.answer(where, filling, out, flag, slot)

    def require(self, *conditions: str) -> None:
        """Emit code that returns None, meaning "nothing was done", unless all conditions hold."""
        self.leave(self.value(f"xor i1 {self.every(*conditions)}, true"), self.nothing)

    def every(self, *conditions: str) -> str:
        """Return whether all conditions hold."""
        return reduce(lambda a, b: self.value(f"and i1 {a}, {b}"), conditions, "true")

    def nothing(self) -> str:
        """Return None."""
        self.call("void", "Py_IncRef", ("ptr", self.none))
        return f"ptr {self.none}"

    def is_a(self, thing: str, kind: str) -> str:
        """Return whether an object is of exactly this class."""
        return self.value(f"icmp eq ptr {self.load('ptr', self.at('i8', thing, KIND))}, {kind}")

    def header(self, array: str, word: str) -> tuple[str, str, str]:
        """Return the number of axes, the address of their lengths, and whether the array is readable."""
        axes = self.value(f"sext i32 {self.load('i32', self.at('i8', array, NDIM))} to i64")
        bits = self.value(f"and i32 {self.load('i32', self.at('i8', array, FLAGS))}, {USABLE}")
        dtype = self.load("ptr", self.at("i8", array, DTYPE))
        usable = self.value(f"icmp eq i32 {bits}, {USABLE}")
        fits = self.every(usable, self.value(f"icmp eq ptr {dtype}, {self.dtypes[word]}"))
        return axes, self.load("ptr", self.at("i8", array, LENGTHS)), fits

    def arguments(
        self, given: list[str], shapes: list[Shape], words: tuple[str, ...]
    ) -> tuple[list[str], list[str], list[str]]:
        """Return the address of the data, the number of batch axes, and the address of their lengths."""
        v, arrays, floats, right = self.value, list(given), dict[int, str](), list[str]()
        for n, thing in enumerate(given):
            readable = self.is_a(thing, self.ndarray)
            if shapes[n] == () and words[n] == "double":
                floats[n] = self.is_a(thing, self.number)
                arrays[n] = v(f"select i1 {floats[n]}, ptr {self.one}, ptr {thing}")
                readable = v(f"or i1 {readable}, {floats[n]}")
            right.append(readable)
        self.require(*right)
        data, axes, starts, right = list[str](), list[str](), list[str](), list[str]()
        for n, (array, shape) in enumerate(zip(arrays, shapes, strict=True)):
            count, lengths, fits = self.header(array, words[n])
            starts.append(lengths)
            axes.append(v(f"sub i64 {count}, {len(shape)}"))
            right += [fits, v(f"icmp sge i64 {axes[n]}, 0")]
            data.append(self.load("ptr", self.at("i8", array, DATA)))
            if n in floats:
                inside = self.at("i8", given[n], HEAD)
                data[n] = v(f"select i1 {floats[n]}, ptr {inside}, ptr {data[n]}")
        self.require(*right)
        return data, axes, starts

    def common(
        self, axes: list[str], starts: list[str], shapes: list[Shape], moving: list[int]
    ) -> tuple[list[str], str, str, str]:
        """Return which arrays have one row for all, and the rows, axes and lengths of the other arrays'
        batch.
        """
        v, right = self.value, list[str]()
        batch, start = axes[moving[0]], starts[moving[0]]
        for n in moving[1:]:
            more = v(f"icmp sgt i64 {axes[n]}, {batch}")
            batch = v(f"select i1 {more}, i64 {axes[n]}, i64 {batch}")
            start = v(f"select i1 {more}, ptr {starts[n]}, ptr {start}")
        for own, lengths, shape in zip(axes, starts, shapes, strict=True):
            for k, length in enumerate(shape):
                found = self.load("i64", self.at("i64", self.at("i64", lengths, own), k))
                right.append(v(f"icmp eq i64 {found}, {length}"))
        ones = [v(f"icmp eq i64 {own}, 0") for own in axes]
        for n, (own, lengths) in enumerate(zip(axes, starts, strict=True)):
            if n not in moving:
                right.append(ones[n])
            elif len(moving) > 1:
                alike = self.once(f"call i1 @alike(ptr {lengths}, ptr {start}, i64 {own})")
                same = self.every(alike, v(f"icmp eq i64 {own}, {batch}"))
                right.append(v(f"or i1 {ones[n]}, {same}"))
        self.require(*right)
        return ones, self.once(f"call i64 @product(ptr {start}, i64 {batch})"), batch, start

    def new(self, total: str, batch: str, start: str) -> str:
        """Return a new array for the result, or nothing if it would have too many entries or axes."""
        v = self.value
        self.require(
            v(f"icmp sle i64 {total}, {MUCH}"),
            v(f"icmp sle i64 {batch}, {MAX_AXES - len(self.row)}"),
        )
        self.copy(self.lengths, start, v(f"mul i64 {batch}, 8"))
        for k, length in enumerate(self.row):
            place = self.at("i64", self.at("i64", self.lengths, batch), k)
            self.store("i64", str(length), place)
        axes = v(f"trunc i64 {v(f'add i64 {batch}, {len(self.row)}')} to i32")
        number = ("i32", str(NUMBERS[self.word]))
        kind = [("ptr", self.ndarray), ("i32", axes), ("ptr", self.lengths), number]
        rest = [("ptr", "null"), ("ptr", "null"), ("i32", "0"), ("i32", "0"), ("ptr", "null")]
        made = self.call("ptr", "PyArray_New", *kind, *rest)
        self.leave(v(f"icmp eq ptr {made}, null"), lambda: "ptr null")
        return made

    def answer(self, where: str, filling: str, out: str, flag: str, slot: int) -> None:
        """Return whether a row was flagged, or the values, or an object that contains them."""

        def dropped(result: Callable[[], str]) -> str:
            self.call("void", "Py_DecRef", ("ptr", out))
            return result()

        def said() -> str:
            flag_word = self.value(f"zext i1 {flag} to i64")
            return f"ptr {self.call('ptr', 'PyBool_FromLong', ('i64', flag_word))}"

        self.leave(filling, said)
        self.leave(flag, lambda: dropped(self.nothing))
        plain = self.value(f"icmp eq ptr {where}, {self.none}")
        self.leave(plain, lambda: f"ptr {self.call('ptr', 'PyArray_Return', ('ptr', out))}")
        flags = self.at("i8", out, FLAGS)
        closed = self.value(f"and i32 {self.load('i32', flags)}, {~WRITEABLE}")
        self.store("i32", closed, flags)
        holder = self.call("ptr", "PyType_GenericAlloc", ("ptr", where), ("i64", "0"))
        self.leave(self.value(f"icmp eq ptr {holder}, null"), lambda: dropped(lambda: "ptr null"))
        self.store("ptr", out, self.at("i8", holder, slot))
        self.end(f"ptr {holder}")


def product() -> Code:
    """Emit the function that multiplies lengths, to count rows and entries."""
    code = Code("internal i64 @product(ptr %lengths, i64 %count)")

    def length(i: str, size: str) -> list[str]:
        return [code.value(f"mul i64 {size}, {code.load('i64', code.at('i64', '%lengths', i))}")]

    (size,) = code.loop("0", "%count", length, first=[("i64", "1")])
    code.end(f"i64 {size}")
    return code


def alike() -> Code:
    """Emit the function that compares lengths."""
    code = Code("internal i1 @alike(ptr %a, ptr %b, i64 %count)")

    def length(i: str, same: str) -> list[str]:
        a, b = (code.load("i64", code.at("i64", lengths, i)) for lengths in ("%a", "%b"))
        return [code.value(f"and i1 {same}, {code.value(f'icmp eq i64 {a}, {b}')}")]

    (same,) = code.loop("0", "%count", length, first=[("i1", "true")])
    code.end(f"i1 {same}")
    return code
