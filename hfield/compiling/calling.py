"""Run loops over numpy arrays of any shape and stride, on several threads."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from ctypes import addressof, c_int64
from math import prod

import numpy as np

from hfield.compiling import machine_code, memory
from hfield.compiling.arithmetic import Arithmetic
from hfield.compiling.arithmetics.doubles import FloatFormula
from hfield.compiling.loops import Operand, emit_loop
from hfield.compiling.memory import Array, Rows, address, in_one_piece, rows_of
from hfield.compiling.threads import in_pieces, threads
from hfield.core.straight_line import Program

PIECE = 1 << 20  # elements that a thread takes at a time: for each it waits for the interpreter
THREADED_ELEMENTS = 500_000  # from so many elements on a second thread is woken
ELEMENTS_PER_THREAD = 1 << 16  # elements for which one more thread is woken
# The compiled loops of each program in each arithmetic, by which operands are single elements and
# whether results bypass the caches.
_loops: dict[Hashable, dict[tuple[tuple[bool, ...], bool], machine_code.Function]] = {}
_announce = machine_code.Announcer(
    "hfield: compiling a loop over arrays, once on this machine (`hfield precompile` does it beforehand)"
)


class ArrayProgram:
    """A program in an arithmetic, to be run on arrays.

    Parameters
    ----------
    sides : sequence of tuples of names
        For each operand, the names of its rows in the program.
    constants : mapping
        The numbers of the program's other inputs, the same for all elements.
    """

    def __init__(
        self,
        program: Program | FloatFormula,
        arithmetic: Arithmetic,
        sides: Sequence[tuple[str, ...]],
        constants: Mapping[str, float],
    ) -> None:
        self.program, self.arithmetic = program, arithmetic
        self.literals = (
            {name: int(x) for name, x in constants.items()} if arithmetic.literal else {}
        )
        named = {} if arithmetic.literal else constants
        self.sides = (*sides, tuple(named)) if named else tuple(sides)
        self.constants = tuple(np.array(x, arithmetic.dtype) for x in named.values())
        self.tables = arithmetic.tables()
        key = (program, arithmetic, self.sides, *self.literals.items())
        self._loops = _loops.setdefault(key, {})

    def __call__(self, *operands: Rows) -> tuple[Rows, int]:
        """Return the rows of the results, in the shape to which the operands broadcast, and the flags.

        The rows of an operand have one shape and the type that the arithmetic reads. Raises ValueError
        for shapes that do not broadcast.
        """
        shapes = [rows[0].shape for rows in operands]
        shape = shapes[0] if len(set(shapes)) == 1 else np.broadcast_shapes(*shapes)
        n = prod(shape)
        out, used = memory.block((len(self.program.outputs), *shape), self.arithmetic.result)
        results = rows_of(out)
        if n == 0:
            return results, 0
        singles = tuple(n > 1 and prod(s) == 1 for s in shapes)
        straight = [
            rows if single else tuple(in_one_piece(row, shape) for row in rows)
            for rows, single in zip(operands, singles, strict=True)
        ]
        if self.constants:
            straight.append(self.constants)
            singles = (*singles, True)
        streamed = used and self.arithmetic.waits_for_memory
        loop = self._loops.get((singles, streamed)) or self._compiled(singles, streamed)
        size = np.dtype(self.arithmetic.dtype).itemsize
        rows, steps = list[Array](), list[int]()
        for own, single in zip(straight, singles, strict=True):
            rows += own
            steps += [0 if single else size] * len(own)
        rows += [*self.tables, *results]
        steps += [0] * len(self.tables) + [out.itemsize] * len(results)
        return results, run(loop, n, tuple(rows), steps)

    def prepare(self) -> None:
        """Compile, or load from disk, the loops for arrays of one shape and for an element with an array."""
        count = len(self.sides) - bool(self.constants)
        for single in range(-1, count if count > 1 else 0):
            flags = tuple(n == single for n in range(count))
            for streamed in {False, self.arithmetic.waits_for_memory}:
                self._compiled(flags + (True,) * bool(self.constants), streamed)

    def _compiled(self, singles: tuple[bool, ...], streamed: bool) -> machine_code.Function:
        with machine_code.lock:
            if (singles, streamed) not in self._loops:
                operands = tuple(map(Operand, self.sides, singles))
                text = emit_loop(self.program, self.arithmetic, operands, self.literals, streamed)
                address = machine_code.compiled(text, "entry", True, _announce)
                self._loops[singles, streamed] = machine_code.function(address)
        return self._loops[singles, streamed]


def run(loop: machine_code.Function, n: int, rows: Rows, steps: Sequence[int]) -> int:
    """Run a loop over n elements, in threads if that is faster; return the bitwise or of the flags.

    ``steps`` are the byte distances between elements in each row, 0 if one element is used for all.
    """
    places = [address(row) for row in rows]
    table = c_int64 * len(places)
    if n < THREADED_ELEMENTS or threads() == 1:
        whole = table(*places)
        return loop(n, addressof(whole))

    def work(start: int, end: int) -> int:
        here = table(*(place + start * step for place, step in zip(places, steps, strict=True)))
        return loop(end - start, addressof(here))

    return in_pieces(work, n, PIECE, ELEMENTS_PER_THREAD, rows)
