"""Number the elements of an algebra over a finite ring, for numpy.

The label of a scalar is its index in ``ring.elements()``. An element is given by the four labels of its
coordinates, or by a number below q⁴ with these labels as digits in base q. The numbers are in the order of
``A.elements()``.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Parent, Quaternion, from_stored
from hfield.algebra.structure.counting.tally import (
    MIN_COMPILED,
    Indices,
    RingTables,
    compiled_loops,
)
from hfield.core import product
from hfield.core.product import Constants, Scalar
from hfield.errors import NotFiniteError, TooLargeError, shorten

if TYPE_CHECKING:
    import numpy as np

    from hfield.fields.base.array_storage.labels import LabelArrays
    from hfield.fields.base.ring import Ring

Rows = tuple["np.ndarray", "np.ndarray", "np.ndarray", "np.ndarray"]
"""The labels of the four coordinates of an array of elements."""
MAX_ORDER = 2048
"""The greatest order of a ring with tables of sums and products."""
MAX_ELEMENTS = 10**6
"""The greatest number of elements of an algebra that are compared with each other."""


class LabelledAlgebra:
    """An algebra over a finite ring, with arithmetic by tables of scalar labels."""

    def __init__(self, algebra: Parent) -> None:
        self.algebra = algebra
        self.ring: Ring = algebra.ring
        self.q = order_of_ring(algebra)
        if self.q > MAX_ORDER:
            raise TooLargeError(
                f"{algebra} has tables of scalars only up to {MAX_ORDER} of them, and {self.ring} has "
                f"{shorten(self.q)}"
            )
        self.size = self.q**4
        self.tables = RingTables(self.ring)
        self.constants = Constants(*map(self.tables.of, algebra.constants))
        self._parts = [algebra.storage.encode((x, x, x, x)) for x in self.tables.elements]

    # --- labels and elements -------------------------------------------------------------------

    def label(self, x: Scalar) -> int:
        """Return the label of a scalar."""
        return self.tables.index[self.ring.key(x)]

    def number(self, element: Quaternion) -> int:
        """Return the number of an element."""
        total = 0
        for x in element.coordinates:
            total = total * self.q + self.label(x)
        return total

    def element(self, number: int) -> Quaternion:
        """Return the element with a number."""
        first, second = divmod(number, self.q**2)
        return self.of_labels(*divmod(first, self.q), *divmod(second, self.q))

    def of_labels(self, w: int, x: int, y: int, z: int) -> Quaternion:
        """Return the element with these labels of coordinates."""
        parts = self._parts
        together = (parts[w][0], parts[x][1], parts[y][2], parts[z][3])
        return from_stored(self.algebra, self.algebra.storage, together)

    def rows(self, numbers: np.ndarray) -> Rows:
        """Return the labels of the coordinates of elements given by numbers."""
        import numpy as np

        if self.size <= np.iinfo(np.int32).max:
            numbers = numbers.astype(np.int32)  # divided several times faster than int64
        first, second = np.divmod(numbers, self.q**2)
        return *np.divmod(first, self.q), *np.divmod(second, self.q)

    def numbers(self, rows: Rows) -> np.ndarray:
        """Return the numbers of elements with these labels."""
        import numpy as np

        w, x, y, z = (row.astype(np.int64) for row in rows)
        return ((w * self.q + x) * self.q + y) * self.q + z

    def array(self, numbers: np.ndarray) -> Quaternion:
        """Return elements given by numbers as one array of quaternions."""
        import numpy as np

        from hfield.fields.base.array_storage.labels import LabelArrays

        rows = self.rows(numbers)
        if isinstance(self.algebra.array_storage, LabelArrays):
            return self.algebra.from_array(np.stack(rows))
        scalars = self.ring.array(self.tables.elements)
        w, x, y, z = (scalars[row.astype(np.intp)] for row in rows)
        return Quaternion(self.algebra, (w, x, y, z))

    # --- arithmetic ----------------------------------------------------------------------------

    def _indices(self, rows: Rows) -> tuple[Indices, Indices, Indices, Indices]:
        w, x, y, z = (Indices(self.tables, row) for row in rows)
        return w, x, y, z

    @cached_property
    def _loops(self) -> LabelArrays | None:
        """The compiled loops of the algebra, or None."""
        return compiled_loops(self.ring, self.algebra.constants)

    def product(self, p: Rows, q: Rows) -> Rows:
        """Return the elementwise products, by compiled loops for many elements and by tables for few."""
        if max(p[0].size, q[0].size) >= MIN_COMPILED and self._loops is not None:
            dtype = self._loops.dtype
            left, right = (tuple(row.astype(dtype) for row in rows) for rows in (p, q))
            w, x, y, z = (row.astype("i4") for row in self._loops.product(left, right))
            return w, x, y, z
        found = product.multiply(self.constants, self._indices(p), self._indices(q))
        w, x, y, z = (c.values for c in found)
        return w, x, y, z

    def sum(self, p: Rows, q: Rows) -> Rows:
        """Return the sums, elementwise."""
        sums = zip(self._indices(p), self._indices(q), strict=True)
        w, x, y, z = ((u + v).values for u, v in sums)
        return w, x, y, z

    def products(self, p: np.ndarray, q: np.ndarray) -> np.ndarray:
        """Return the numbers of the elementwise products of elements given by numbers."""
        return self.numbers(self.product(self.rows(p), self.rows(q)))

    def norm(self, rows: Rows) -> np.ndarray:
        """Return the labels of the norms."""
        found: np.ndarray = product.norm(self.constants, self._indices(rows)).values
        return found

    def trace(self, rows: Rows) -> np.ndarray:
        """Return the labels of the traces."""
        found: np.ndarray = product.trace(self.constants, self._indices(rows)).values
        return found

    def determinant(self, rows: Sequence[Sequence[np.ndarray]]) -> np.ndarray:
        """Return the labels of the determinants of 3 × 3 matrices of labels."""
        (a, b, c), (d, e, f), (g, h, i) = (
            [Indices(self.tables, entry) for entry in row] for row in rows
        )
        found = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
        determinants: np.ndarray = found.values
        return determinants

    def conjugation(self, unit: Quaternion) -> np.ndarray:
        """Return the permutation x ↦ u·x·u⁻¹ of the numbers of all elements.

        Raises :class:`TooLargeError` beyond :data:`MAX_ELEMENTS` elements.
        """
        import numpy as np

        self.check_size("conjugates of all elements are computed")
        everything = self.rows(np.arange(self.size))
        left, right = (self._one(u) for u in (unit, unit.inverse()))
        return self.numbers(self.product(self.product(left, everything), right))

    def _one(self, element: Quaternion) -> Rows:
        import numpy as np

        w, x, y, z = (np.array([self.label(u)], dtype=np.int32) for u in element.coordinates)
        return w, x, y, z

    def check_size(self, what: str) -> None:
        """Raise :class:`TooLargeError` for an algebra of more than :data:`MAX_ELEMENTS` elements."""
        if self.size > MAX_ELEMENTS:
            raise TooLargeError(
                f"{self.algebra} has {shorten(self.size)} elements, and {what} for at most {MAX_ELEMENTS}"
            )


def order_of_ring(algebra: Parent) -> int:
    """Return the order of the base ring. Raises :class:`NotFiniteError`."""
    if algebra.ring.order is None:
        raise NotFiniteError(
            f"{algebra} is infinite: expected an algebra over a finite ring, such as H(GF(7))"
        )
    return int(algebra.ring.order)


def labelled(algebra: Parent) -> LabelledAlgebra:
    """Return the labels of an algebra; equal algebras share one object.

    Raises :class:`NotFiniteError` over an infinite ring, :class:`TooLargeError` beyond :data:`MAX_ORDER`.
    """
    return _labelled(algebra)


@lru_cache(maxsize=8)
def _labelled(algebra: Parent) -> LabelledAlgebra:
    return LabelledAlgebra(algebra)
