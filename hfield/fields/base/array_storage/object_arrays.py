"""Storage of arrays over any ring as object arrays whose entries are stored values of elements.

The entries are converted to ring elements when coordinates, norms or traces are needed.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from hfield.core.product import Constants, Coordinates
from hfield.fields.base.arrays import Objects, objects, one_shape, wrap
from hfield.fields.base.storage.base import BatchStorage, Storage

if TYPE_CHECKING:
    from hfield.fields.base.arrays import Index
    from hfield.fields.base.ring import Ring

Values = np.ndarray


class ObjectArrays(BatchStorage[Values]):
    """Arrays over any ring; ``entries`` encodes each element and computes with it.

    A stored value is an array of objects, each the stored value of an element.
    """

    def __init__(self, ring: Ring, constants: Constants) -> None:
        Storage.__init__(self, ring, constants)
        self.entries = ring.storage(constants)

    # --- in and out ----------------------------------------------------------------------------

    def encode(self, coordinates: Coordinates) -> Values:
        """Encode four arrays of the ring, of one shape."""
        scalar = self.ring.scalar
        elements = (c if type(c) is Objects else objects(c, scalar) for c in coordinates)
        every = (c.view(np.ndarray) for c in elements)
        return each(lambda *four: self.entries.encode(four), *every)[0]

    def read(self, values: tuple[object, ...]) -> Values:
        """Encode four values that the ring reads, entry by entry. Raises :class:`CoercionError`."""
        w, x, y, z = one_shape([objects(v, self.ring) for v in values])
        return self.encode((w, x, y, z))

    def lift(self, coordinates: Coordinates) -> Values:
        """Encode one element as an array of no dimensions."""
        return wrap(self.entries.encode(coordinates))

    def coordinates(self, stored: Values) -> Coordinates:
        """Return the coordinates as new arrays of the ring."""
        w, x, y, z = map(self._of_the_ring, each(self.entries.coordinates, stored, results=4))
        return w, x, y, z

    def _of_the_ring(self, elements: Values) -> np.ndarray:
        """Return elements of the ring as one of its arrays."""
        return elements.view(Objects) if self._objects else self.ring.array(elements)

    @cached_property
    def _objects(self) -> bool:
        """Whether the ring's own arrays are of objects."""
        return type(self.ring.array(self.ring.zero)) is Objects

    def single(self, p: Values) -> Coordinates:
        """Return the coordinates of an array of no dimensions."""
        return self.entries.coordinates(p[()])

    def shape(self, p: Values) -> tuple[int, ...]:
        """Return the shape of the array."""
        shape: tuple[int, ...] = p.shape
        return shape

    def part(self, p: Values, index: Index) -> Values:
        """Return the elements at a numpy index."""
        found = p[index]
        return found if isinstance(found, np.ndarray) else wrap(found)

    def reshaped(self, p: Values, shape: tuple[int, ...]) -> Values:
        """Return the elements in another shape. Raises ValueError."""
        return p.reshape(shape)

    # --- arithmetic ----------------------------------------------------------------------------

    def elementwise(self, name: str, *operands: Values) -> Values:
        """Apply an operation of single elements to every entry."""
        return each(getattr(self.entries, name), *operands)[0]

    def inverse(self, p: Values) -> Values | None:
        """Return the inverses, or None if some norm is not a unit of the ring."""
        found = self.elementwise("inverse", p)
        return None if any(x is None for x in found.flat) else found

    def norm(self, p: Values) -> np.ndarray:
        """Return the reduced norms, an array of the ring."""
        return self._of_the_ring(self.elementwise("norm", p))

    def trace(self, p: Values) -> np.ndarray:
        """Return the reduced traces, an array of the ring."""
        return self._of_the_ring(self.elementwise("trace", p))

    def units(self, p: Values) -> Values:
        """Return a bool array that marks the invertible elements."""
        return each(lambda x: self.ring.is_unit(self.entries.norm(x)), p)[0].astype(bool)

    # --- what is equal -------------------------------------------------------------------------

    def equal(self, p: Values, q: Values) -> Values:
        """Return a bool array that marks the entries with p = q."""
        self._check(p, q, "compare")
        return self.elementwise("equal", p, q).astype(bool)

    def is_zero(self, p: Values) -> Values:
        """Return a bool array that marks the entries with p = 0."""
        return self.elementwise("is_zero", p).astype(bool)


def each(
    function: Callable[..., object], *operands: Values, results: int = 1
) -> tuple[Values, ...]:
    """Return the arrays of results of a function that is applied to object arrays entry by entry, with
    broadcasting.
    """
    shape = np.broadcast_shapes(*(x.shape for x in operands))
    found = tuple(np.empty(shape, object) for _ in range(results))
    np.frompyfunc(function, len(operands), results)(*operands, out=found)
    return found
