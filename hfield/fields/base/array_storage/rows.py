"""Arrays of quaternions as four rows of integers of one shape; the rows of a result are parts of
one block.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from hfield.compiling import memory
from hfield.compiling.memory import Rows, address, rows_of
from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import FIRST, SECOND, Program, pattern, specialise
from hfield.errors import CoercionError
from hfield.fields.base.array_storage import programs
from hfield.fields.base.array_storage.programs import Sides
from hfield.fields.base.arrays import one_shape, owned, read_only
from hfield.fields.base.storage.base import BatchStorage, Storage

if TYPE_CHECKING:
    from hfield.fields.base.arrays import Index
    from hfield.fields.base.ring import Ring

Row = np.ndarray


class RowArrays(BatchStorage[Rows]):
    """Base class for storage as four rows; each ring determines the numbers in the rows.

    A stored value is a tuple of four numpy arrays of one shape and of type ``dtype``.
    """

    dtype: str

    def __init__(self, ring: Ring, constants: Constants) -> None:
        Storage.__init__(self, ring, constants)

    @cached_property
    def plain(self) -> BatchStorage:
        """The storage by arrays of the ring: the reference, and the fallback without LLVM."""
        return BatchStorage(self.ring, self.constants)

    def by_arrays(self, operation: str, *operands: Rows) -> np.ndarray:
        """Return the norms, traces, units or zeros as the plain storage does, by arrays of the ring."""
        found: np.ndarray = getattr(self.plain, operation)(*map(self.coordinates, operands))
        return found

    def program(self, name: str) -> tuple[Program, Sides]:
        """Return the program of an operation, and the names of the rows of its operands in it."""
        if name in programs.COORDINATEWISE:
            return programs.COORDINATEWISE[name]
        program = specialise(name, self.pattern(), 2 if self.ring.characteristic == 2 else 0)
        return program, (FIRST, SECOND) if name == "product" else (FIRST,)

    def pattern(self) -> Constants[str]:
        """Return which of the structure constants are 0, 1 or −1."""
        return pattern(self.constants, lambda x, n: bool(self.ring.equal(x, self.ring(n))))

    # --- what a ring gives ---------------------------------------------------------------------

    def row(self, values: object) -> Row:
        """Return a row of values that the ring reads. Raises :class:`CoercionError` as the ring does."""
        raise NotImplementedError

    def ring_array(self, row: Row) -> Row:
        """Return a row as an array of the ring."""
        raise NotImplementedError

    # --- in and out ----------------------------------------------------------------------------

    def encode(self, coordinates: Coordinates) -> Rows:
        """Encode four arrays of the ring, of one shape."""
        return tuple(self.row(c) for c in coordinates)

    def read(self, values: tuple[object, ...]) -> Rows:
        """Encode four values that the ring reads. Raises :class:`CoercionError` as the ring does."""
        return tuple(one_shape([owned(self.row(v), v) for v in values]))

    def lift(self, coordinates: Coordinates) -> Rows:
        """Encode one element as an array of no dimensions."""
        return self.encode(coordinates)

    def coordinates(self, stored: Rows) -> Coordinates:
        """Return the coordinates as arrays of the ring."""
        w, x, y, z = map(self.ring_array, stored)
        return w, x, y, z

    def shape(self, p: Rows) -> tuple[int, ...]:
        """Return the shape of the array."""
        shape: tuple[int, ...] = p[0].shape
        return shape

    def part(self, p: Rows, index: Index) -> Rows:
        """Return the elements at a numpy index; the rows are views if numpy makes them."""
        return tuple(np.asarray(row[index]) for row in p)

    def single(self, p: Rows) -> Coordinates:
        """Return the coordinates of an array of no dimensions."""
        w, x, y, z = (self.ring.scalar(self.ring_array(row)) for row in p)
        return w, x, y, z

    def reshaped(self, p: Rows, shape: tuple[int, ...]) -> Rows:
        """Return the elements in another shape."""
        return tuple(row.reshape(shape) for row in p)

    # --- what is equal -------------------------------------------------------------------------

    def equal(self, p: Rows, q: Rows) -> np.ndarray:
        """Return a bool array that marks the entries with p = q."""
        self._check(p, q, "compare")
        pairs = zip(p, q, strict=True)
        same: np.ndarray = np.logical_and.reduce([np.equal(x, y) for x, y in pairs])
        return same

    def is_zero(self, p: Rows) -> np.ndarray:
        """Return a bool array that marks the entries with p = 0."""
        nonzero: np.ndarray = np.logical_or.reduce([row.astype(bool) for row in p])
        return ~nonzero

    # --- plain arrays --------------------------------------------------------------------------

    def to_array(self, p: Rows) -> Row:
        """Return the rows as one read-only array of shape (4, …); without a copy if they already are one."""
        block = block_of(p)
        return read_only(np.stack(p) if block is None else block)

    def from_array(self, values: object, copy: bool = True) -> Rows:
        """Encode a copy of an array of shape (4, …), made by ``to_array``. Raises :class:`CoercionError`."""
        return self.checked_block(values, 4)

    def checked_block(self, values: object, count: int) -> Rows:
        """Return the rows of an array of integers. Raises :class:`CoercionError`."""
        given = np.asarray(values)
        if given.ndim == 0 or given.shape[0] != count or given.dtype.kind not in "iu":
            raise CoercionError(
                f"an array of {given.dtype} of shape {given.shape} does not hold quaternions over "
                f"{self.ring}: expected an array of integers (dtype int64, for example) of shape "
                f"({count}, …), as to_array() returns them"
            )
        block, _ = memory.block(given.shape, given.dtype.str)
        block[...] = given  # a copy: nobody changes it after it has been checked
        self.check_numbers(block)
        return rows_of(self.block(block))

    def block(self, values: Row) -> Row:
        """Return an array of integers as a contiguous array of the stored type."""
        return values.astype(self.dtype, copy=False)

    def check_numbers(self, block: Row) -> None:
        """Raise an error for numbers that do not encode an element."""


def block_of(rows: Sequence[Row]) -> Row | None:
    """Return the contiguous array that consists of exactly these rows, in order; None if there is none."""
    first, base = rows[0], rows[0].base
    if not (isinstance(base, np.ndarray) and base.flags.c_contiguous and first.flags.c_contiguous):
        return None
    start = address(first)
    for n, row in enumerate(rows):
        alike = row.base is base and row.dtype == first.dtype and row.shape == first.shape
        if not alike or row.strides != first.strides or address(row) != start + n * first.nbytes:
            return None
    shape = (len(rows), *first.shape)
    return np.ndarray(shape, first.dtype, base, start - address(base))


def inverses(
    row: Row,
    multiply: Callable[[Row, Row], Row],
    invert: Callable[[Row], Row],
    few: int = 8,
) -> Row:
    """Return the inverses of a row of units by three products per element and a few inversions.

    Pairs are multiplied until few numbers are left. The inverse of a pair's product, times one member of the
    pair, is the inverse of the other (P. L. Montgomery, Mathematics of Computation 48, 1987, arranged as a
    tree).
    """
    n = len(row)
    if n <= few:
        return invert(row)
    half = n // 2
    left, right = row[:half], row[half : 2 * half]
    products = np.concatenate([multiply(left, right), row[2 * half :]])
    found = inverses(products, multiply, invert, few)
    inverse = found[:half]
    return np.concatenate([multiply(inverse, right), multiply(inverse, left), found[half:]])
