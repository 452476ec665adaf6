"""Arrays over ℤ as rows of integers of 8 to 64 bits; the width follows from bounds for the results.

Overflow of 64 bits is detected, and the computation then continues with the representation of single
elements.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property, partial
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from hfield.compiling import machine_code
from hfield.compiling.arithmetics.machine_integers import (
    CheckedWholeNumbers,
    TooWideError,
    holds,
    widest,
)
from hfield.compiling.calling import ArrayProgram
from hfield.compiling.instructions import Code
from hfield.compiling.loops import Operand, emit_body
from hfield.compiling.memory import Rows, rows_of
from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import Program, pattern
from hfield.errors import CoercionError
from hfield.fields.base.array_storage.object_arrays import ObjectArrays, each
from hfield.fields.base.array_storage.rows import Row, RowArrays
from hfield.fields.base.arrays import objects, read_only
from hfield.fields.base.coercion import is_plain_array

if TYPE_CHECKING:
    from hfield.compiling.arithmetic import Arithmetic
    from hfield.fields.base.arrays import Index
    from hfield.fields.base.ring import Ring


OPERATIONS = ("product", "sum", "difference", "negative", "conjugate", "norm", "trace", "adjoint")
WORD = np.dtype(np.int64)
NARROW = ("i1", "i2", "i4")


class WordArrays(RowArrays):
    """The common part of arrays over ℤ and ℚ: rows of words, or one row of stored values.

    One row of stored values is used if a number is larger than a word. An operation runs without checks if
    the operands are small; otherwise with overflow checks; and if a check fails, as for single elements. The
    types are chosen so that negatives fit as well: −128 is stored in 16 bits.
    """

    dtype = "i8"
    dtypes: tuple[str, ...] = (dtype,)  # all types that rows of integers may have
    integral: Constants  # the structure constants, as ints

    def __init__(self, ring: Ring, constants: Constants) -> None:
        super().__init__(ring, constants)
        self.compiles = machine_code.available()
        self._kernels: dict[tuple[str, str], list[ArrayProgram]] = {}

    # --- loops ---------------------------------------------------------------------------------

    def pattern(self) -> Constants[str]:
        """Return which of the structure constants are 0, 1 or −1, in the scaled basis over ℚ."""
        return pattern(self.integral, lambda x, n: x == n)

    def kernels(self, name: str, dtype: str = "i8") -> list[ArrayProgram]:
        """Return the loops of an operation on rows of a given type, the faster one first.

        None if the constants are too large.
        """
        key = name, dtype
        if key not in self._kernels:
            program, sides = self.program(name)
            given = zip(("a", "t", "b"), self.integral, strict=True)
            literals = {n: x for n, x in given if n in program.inputs}
            operands = tuple(Operand(side, False) for side in sides)
            fits = partial(_fits, program, operands, literals)
            quick = widest(fits, dtype)
            found = [] if quick is None else [ArrayProgram(program, quick, sides, literals)]
            if dtype != "i8":
                found += self.kernels(name)
            else:
                try:
                    fits(CheckedWholeNumbers())
                except TooWideError:
                    found = []
                else:
                    found.append(ArrayProgram(program, CheckedWholeNumbers(), sides, literals))
            self._kernels[key] = found
        return self._kernels[key]

    def in_words(self, name: str, *operands: Rows) -> Rows | None:
        """Run an operation in words; return None if it overflows."""
        if self.compiles and all(is_words(p) for p in operands):
            dtype = f"i{max(p[0].itemsize for p in operands)}"
            for kernel in self.kernels(name, dtype):
                rows, overflowed = kernel(*(of_type(p, kernel.arithmetic.dtype) for p in operands))
                if not overflowed:
                    return rows
        return None

    # --- larger numbers ------------------------------------------------------------------------

    @cached_property
    def plain(self) -> ObjectArrays:
        """The storage that computes with the stored values of single elements."""
        return ObjectArrays(self.ring, self.constants)

    def values(self, p: Rows) -> Row:
        """Return an array of the stored values of single elements: numerators over a denominator."""
        if not is_words(p):
            return p[0]
        ones = () if len(p) == 5 else (np.ones(p[0].shape, object),)
        return each(lambda *numbers: numbers, *(row.astype(object) for row in p), *ones)[0]

    def packed(self, values: Row) -> Rows:
        """Return an array of stored single elements as rows of words, or unchanged if a number is larger."""
        try:
            block = np.array(values.ravel().tolist(), WORD).reshape(-1, 5)
        except OverflowError:
            return (values,)
        return self.in_rows(np.ascontiguousarray(block.T).reshape(5, *values.shape))

    def in_rows(self, block: Row) -> Rows:
        """Return the rows of a block of words: numerators and denominators."""
        return rows_of(block)

    def by_arrays(self, operation: str, *operands: Rows) -> np.ndarray:
        """Apply an operation to the stored values of single elements."""
        found: np.ndarray = getattr(self.plain, operation)(*map(self.values, operands))
        return found

    def elementwise(self, name: str, *operands: Rows) -> Rows:
        """Run an operation on words, or on the stored values of single elements if words overflow."""
        rows = self.in_words(name, *operands)
        return self.packed(self.by_arrays(name, *operands)) if rows is None else rows

    def coordinates(self, stored: Rows) -> Coordinates:
        """Return the coordinates as arrays of objects."""
        return self.plain.coordinates(self.values(stored))

    def single(self, p: Rows) -> Coordinates:
        """Return the coordinates of an array of no dimensions."""
        return self.plain.single(self.values(p))

    def part(self, p: Rows, index: Index) -> Rows:
        """Return the elements at a numpy index."""
        return super().part(p, index) if is_words(p) else (self.plain.part(p[0], index),)

    # --- what is equal -------------------------------------------------------------------------

    def equal(self, p: Rows, q: Rows) -> np.ndarray:
        """Return a bool array that marks the entries with p = q."""
        words = is_words(p) and is_words(q)
        same: np.ndarray = super().equal(p, q) if words else self.by_arrays("equal", p, q)
        return same

    def is_zero(self, p: Rows) -> np.ndarray:
        """Return a bool array that marks the entries with p = 0."""
        words = is_words(p)
        zero: np.ndarray = super().is_zero(p[:4]) if words else self.by_arrays("is_zero", p)
        return zero

    def check_numbers(self, block: Row) -> None:
        """Raise an error for numbers that do not fit into a word."""
        if block.dtype == np.uint64 and block.size and int(block.max()) >= 2**63:
            raise CoercionError(
                "numbers of 2^63 and more do not fit int64: expected an array of int64"
            )

    def to_array(self, p: Rows) -> Row:
        """Return the rows as one array of int64. Raises :class:`CoercionError` for larger numbers."""
        if not is_words(p):
            raise CoercionError(
                f"the array over {self.ring} holds numbers of more than 64 bits, which no array of int64 "
                "holds: pickle it"
            )
        return read_only(super().to_array(p).astype(WORD, copy=False))

    def prepare(self) -> None:
        """Compile every loop, or load it from the disk."""
        for name, dtype in product(OPERATIONS, self.dtypes):
            for kernel in self.kernels(name, dtype):
                kernel.prepare()


class WholeArrays(WordArrays):
    """Arrays over ℤ."""

    dtypes = (*NARROW, "i8")

    def __init__(self, ring: Ring, constants: Constants) -> None:
        super().__init__(ring, constants)
        self.integral = Constants(*map(int, constants))

    def row(self, values: object) -> Row:
        """Return a row of words, or of objects if a number is larger."""
        if is_plain_array(values) and (
            values.dtype.kind in "ib"
            or (values.dtype.kind == "u" and not (values >= np.uint64(2**63)).any())
        ):
            return narrowed(values)
        made = objects(values, self.ring)
        try:
            return narrowed(np.array([int(x) for x in made.ravel()], WORD).reshape(made.shape))
        except OverflowError:
            return made

    def encode(self, coordinates: Coordinates) -> Rows:
        """Encode four arrays: all as words, or all as objects."""
        return self._alike([self.row(c) for c in coordinates])

    def read(self, values: tuple[object, ...]) -> Rows:
        """Encode four values that ℤ reads. Raises :class:`CoercionError`."""
        return self._alike(super().read(values))

    def in_rows(self, block: Row) -> Rows:
        """Return the rows of a block of words, in narrow types except the denominators, which are 1."""
        return alike(map(narrowed, block[:4]))

    def _alike(self, rows: Sequence[Row]) -> Rows:
        if all(row.dtype != object for row in rows):
            return alike(rows)
        w, x, y, z = map(self.ring_array, rows)
        return (self.plain.encode((w, x, y, z)),)

    def ring_array(self, row: Row) -> np.ndarray:
        """Return a row as an array of flint's integers."""
        return row if row.dtype == object else objects(row, lambda n: self.ring(int(n)))

    def norm(self, p: Rows) -> np.ndarray:
        """Return the reduced norms, an array of flint's integers."""
        rows = self.in_words("norm", p)
        return self.by_arrays("norm", p) if rows is None else self.ring_array(rows[0])

    def trace(self, p: Rows) -> np.ndarray:
        """Return the reduced traces, an array of flint's integers."""
        rows = self.in_words("trace", p)
        return self.by_arrays("trace", p) if rows is None else self.ring_array(rows[0])

    def inverse(self, p: Rows) -> Rows | None:
        """Return the inverses, or None if some norm is neither 1 nor −1."""
        rows = self.in_words("adjoint", p)
        if rows is None:
            found = self.plain.inverse(self.values(p))
            return None if found is None else self.packed(found)
        *conjugate, norms = rows
        if not (np.abs(norms) == 1).all():
            return None
        return tuple(np.asarray(row * norms) for row in conjugate)

    def block(self, values: Row) -> Row:
        """Return int64 unchanged, and other integers in the smallest type that fits."""
        return values if values.dtype == WORD else narrowed(values)


def is_words(p: Rows) -> bool:
    """Return whether the rows consist of machine integers, not of objects."""
    return p[0].dtype != object


def narrowed(row: Row) -> Row:
    """Return a new row of the smallest type that fits these integers."""
    size = max(-int(row.min()), int(row.max())) if row.size else 0
    return np.array(row, next((t for t in NARROW if size <= holds(t)), WORD))


def of_type(p: Rows, dtype: str) -> Rows:
    """Return rows of integers converted to a type that fits them."""
    return p if p[0].dtype == dtype else tuple(row.astype(dtype) for row in p)


def alike(rows: Iterable[Row]) -> Rows:
    """Return rows converted to a common type, the widest."""
    rows = tuple(rows)
    dtype = max((row.dtype for row in rows), key=lambda t: t.itemsize)
    return tuple(row.astype(dtype, copy=False) for row in rows)


def _fits(
    program: Program,
    operands: tuple[Operand, ...],
    literals: dict[str, int],
    arithmetic: Arithmetic,
) -> object:
    return emit_body(Code(), program, arithmetic, operands, literals)
