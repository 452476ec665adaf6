"""Storage of elements of an algebra: encode four coordinates as one value, and compute with such values.

:meth:`~hfield.fields.base.ring.Ring.storage` of a ring returns the storage of single elements, and
:meth:`~hfield.fields.base.ring.Ring.array_storage` the storage of arrays. :class:`Storage` stores the tuple
of the coordinates and works for every ring, also for user-defined ones; the storage of a ring with a compact
form is a subclass.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable
from typing import TYPE_CHECKING, Any, Generic

from hfield.core import product
from hfield.core.product import Constants, Coordinates
from hfield.errors import CoercionError
from hfield.fields.base.powers import MAX_UNCHECKED_POWER, bits, check_growth

if TYPE_CHECKING:
    import numpy as np
    from typing_extensions import TypeVar

    from hfield.fields.base.arrays import Index
    from hfield.fields.base.ring import Ring

    H = TypeVar("H", default=Any)  # ``Storage`` alone: of values that nobody checks
    S = TypeVar("S", default=Any)
else:
    from typing import TypeVar

    H = TypeVar("H")  # the type of a stored value
    S = TypeVar("S")  # that of an element of the ring, or of an array of elements


class Storage(Generic[H, S]):
    """Storage of elements over one ring with given structure constants, here as tuples of coordinates.

    A stored value represents an element. It is immutable: no operation changes it. The operands of an
    operation are values of this storage or of an equal one (of an equal ring with equal constants); this is
    not checked.
    """

    is_batch = False
    is_unique = False  # whether stored values of equal elements are equal

    def __init__(self, ring: Ring, constants: Constants) -> None:
        self.ring, self.constants = ring, constants

    # --- in and out ----------------------------------------------------------------------------

    def encode(self, coordinates: Coordinates) -> H:
        """Return the stored value of the element with these coordinates, elements of the ring."""
        return coordinates  # type: ignore[return-value]  # H is the tuple, where this serves

    def coordinates(self, stored: H) -> Coordinates:
        """Return the coordinates as elements of the ring: plain values of its library."""
        return stored  # type: ignore[return-value]

    def scalar(self, s: S) -> H:
        """Encode s·e for an element s of the ring."""
        zero = self.ring.zero
        return self.encode((s, zero, zero, zero))

    def read(self, values: tuple[object, ...]) -> H:
        """Encode four values that the ring reads. Raises :class:`CoercionError` as the ring does."""
        w, x, y, z = map(self.ring, values)
        return self.encode((w, x, y, z))

    def explain(self, operation: str) -> str:
        """Return the source text of the function that computes an operation, such as ``product``."""
        return f"# the formula of hfield.core.product, on the coordinates: {operation}"

    # --- elements to elements ------------------------------------------------------------------

    def product(self, p: H, q: H, /) -> H:
        """Return p·q."""
        return self.encode(
            product.multiply(self.constants, self.coordinates(p), self.coordinates(q))
        )

    def sum(self, p: H, q: H, /) -> H:
        """Return p + q."""
        (w1, x1, y1, z1), (w2, x2, y2, z2) = self.coordinates(p), self.coordinates(q)
        return self.encode((w1 + w2, x1 + x2, y1 + y2, z1 + z2))

    def difference(self, p: H, q: H, /) -> H:
        """Return p − q."""
        (w1, x1, y1, z1), (w2, x2, y2, z2) = self.coordinates(p), self.coordinates(q)
        return self.encode((w1 - w2, x1 - x2, y1 - y2, z1 - z2))

    def negative(self, p: H, /) -> H:
        """Return −p."""
        w, x, y, z = self.coordinates(p)
        return self.encode((-w, -x, -y, -z))

    def conjugate(self, p: H, /) -> H:
        """Return the standard involution of p."""
        return self.encode(product.conjugate(self.constants, self.coordinates(p)))

    def scaled(self, p: H, s: S) -> H:
        """Return s·p for an element s of the ring."""
        w, x, y, z = self.coordinates(p)
        return self.encode((w * s, x * s, y * s, z * s))

    def divided(self, p: H, s: S) -> H | None:
        """Return p/s, or None if s is not a unit of the ring."""
        return self.scaled(p, self.ring.inverse(s)) if self.ring.is_unit(s) else None

    def inverse(self, p: H, /) -> H | None:
        """Return p⁻¹, or None if the norm is not a unit of the ring."""
        return self.divided(self.conjugate(p), self.norm(p))

    def one(self, p: H) -> H:
        """Encode e, as an array of the shape of p."""
        return self.scalar(self.ring.one)

    def power(self, p: H, n: int) -> H:
        """Return pⁿ for n ≥ 0, by repeated squaring. Raises :class:`TooLargeError`."""
        if n == 0:
            return self.one(p)
        result = p
        start = bits(p) if n > MAX_UNCHECKED_POWER else None
        for bit in bin(n)[3:]:
            if start is not None:
                check_growth(start, result)
            result = self.product(result, result)
            if bit == "1":
                result = self.product(result, p)
        return result

    # --- elements to the ring ------------------------------------------------------------------

    def norm(self, p: H, /) -> S:
        """Return the reduced norm, an element of the ring."""
        norm: S = product.norm(self.constants, self.coordinates(p))
        return norm

    def trace(self, p: H, /) -> S:
        """Return the reduced trace, an element of the ring."""
        trace: S = product.trace(self.constants, self.coordinates(p))
        return trace

    # --- what is equal -------------------------------------------------------------------------

    def equal(self, p: H, q: H) -> bool | np.ndarray:
        """Return whether p = q."""
        return all(map(self.ring.equal, self.coordinates(p), self.coordinates(q)))

    def is_zero(self, p: H) -> bool | np.ndarray:
        """Return whether p = 0."""
        return all(map(self.ring.is_zero, self.coordinates(p)))

    def key(self, p: H) -> Hashable:
        """Return a hashable key that is the same for equal elements, however they were computed."""
        return tuple(map(self.ring.key, self.coordinates(p)))

    def state(self, p: H) -> tuple[object, ...]:
        """Return four values that can be pickled and that ``read`` reads back."""
        return tuple(map(self.ring.state, self.coordinates(p)))


class BatchStorage(Storage[H, "np.ndarray"]):
    """Storage of arrays of elements, here as four arrays of one shape that compute elementwise.

    A single operand is first converted to a 0-dimensional array. Shapes broadcast as in numpy; if they do
    not, the operations raise :class:`CoercionError`. ``norm`` and ``trace`` return arrays of the ring,
    ``equal`` and ``is_zero`` bool arrays.
    """

    is_batch = True

    def __init__(self, ring: Ring, constants: Constants) -> None:
        super().__init__(ring, Constants(*map(ring.array, constants)))

    # --- in and out ----------------------------------------------------------------------------

    def read(self, values: tuple[object, ...]) -> H:
        """Encode four arrays that the ring reads, broadcast to one shape. Raises :class:`CoercionError`."""
        from hfield.fields.base.arrays import one_shape, owned

        w, x, y, z = one_shape([owned(self.ring.array(v), v) for v in values])
        return self.encode((w, x, y, z))

    def read_only_coordinates(self, stored: H) -> Coordinates:
        """Return the coordinates as arrays that cannot be written to."""
        from hfield.fields.base.arrays import read_only

        w, x, y, z = map(read_only, self.coordinates(stored))
        return w, x, y, z

    def lift(self, coordinates: Coordinates) -> H:
        """Encode one element, given by its coordinates in the ring, as an array of no dimensions."""
        w, x, y, z = map(self.ring.array, coordinates)
        return self.encode((w, x, y, z))

    def shape(self, p: H) -> tuple[int, ...]:
        """Return the shape of the array."""
        shape: tuple[int, ...] = getattr(self.coordinates(p)[0], "shape", ())
        return shape

    def part(self, p: H, index: Index) -> H:
        """Return the elements at a numpy index; if its result has shape (), only ``single`` accepts it."""
        w, x, y, z = (c[index] for c in self.coordinates(p))
        return self.encode((w, x, y, z))

    def single(self, p: H) -> Coordinates:
        """Return the coordinates, elements of the ring, of a 0-dimensional part."""
        w, x, y, z = map(self.ring.scalar, self.coordinates(p))
        return w, x, y, z

    def reshaped(self, p: H, shape: tuple[int, ...]) -> H:
        """Return the elements in another shape. Raises ValueError."""
        w, x, y, z = (c.reshape(shape) for c in self.coordinates(p))
        return self.encode((w, x, y, z))

    def to_array(self, p: H) -> np.ndarray:
        """Return the elements as one array of numbers. Raises :class:`CoercionError` if there is none."""
        raise CoercionError(self._no_integers())

    def from_array(self, values: object, copy: bool = True) -> H:
        """Encode an array that ``to_array`` returned. Raises :class:`CoercionError`.

        Without ``copy`` the memory is shared if the storage uses numbers of this type.
        """
        raise CoercionError(self._no_integers())

    def prepare(self) -> None:
        """Compile the code of the operations, if they need a compiler."""

    # --- arithmetic ----------------------------------------------------------------------------

    def elementwise(self, name: str, *operands: H) -> H:
        """Apply an operation on elements to operands whose shapes broadcast."""
        found: H = getattr(super(), name)(*operands)
        return found

    def product(self, p: H, q: H, /) -> H:
        """Return p·q, elementwise."""
        self._check(p, q, "multiply")
        return self.elementwise("product", p, q)

    def sum(self, p: H, q: H, /) -> H:
        """Return p + q, elementwise."""
        self._check(p, q, "add")
        return self.elementwise("sum", p, q)

    def difference(self, p: H, q: H, /) -> H:
        """Return p − q, elementwise."""
        self._check(p, q, "subtract")
        return self.elementwise("difference", p, q)

    def negative(self, p: H, /) -> H:
        """Return −p."""
        return self.elementwise("negative", p)

    def conjugate(self, p: H, /) -> H:
        """Return the standard involution of p."""
        return self.elementwise("conjugate", p)

    def units(self, p: H) -> np.ndarray:
        """Return a bool array that marks the invertible elements."""
        return self.ring.array_units(self.norm(p))

    def inverse(self, p: H, /) -> H | None:
        """Return the inverses, or None if some norm is not a unit of the ring."""
        n = self.norm(p)
        if not self.ring.array_units(n).all():
            return None
        return self.scaled(self.conjugate(p), self.ring.array_inverse(n))

    def one(self, p: H) -> H:
        """Encode an array of the shape of p with all entries e."""
        return self._filled(1, self.shape(p))

    def total(self, p: H, axis: int | None) -> H:
        """Return the sum along an axis, or of all elements. Raises :class:`CoercionError`."""
        return self._folded(p, axis, self.sum, 0, in_order=False)

    def ordered_product(self, p: H, axis: int | None) -> H:
        """Return the product along an axis, or of all elements, in their order. Raises as ``total`` does."""
        return self._folded(p, axis, self.product, 1, in_order=True)

    def _folded(
        self, p: H, axis: int | None, combine: Callable[[H, H], H], neutral: int, in_order: bool
    ) -> H:
        """Combine the elements along an axis in a tree; only neighbours if ``in_order``."""
        shape = self.shape(p)
        if axis is None:
            p, shape, axis = self.reshaped(p, (-1,)), (math.prod(shape),), 0
        if not -len(shape) <= axis < len(shape):
            raise CoercionError(f"an array of quaternions of shape {shape} has no axis {axis}")
        axis %= len(shape)
        n = shape[axis]
        if not n:
            return self._filled(neutral, (*shape[:axis], *shape[axis + 1 :]))

        def part(x: H, index: slice | int) -> H:
            return self.part(x, (*(slice(None),) * axis, index))

        tail = None  # the factor behind the last of the remaining ones
        while n > 1:
            half = n // 2
            if n % 2:
                last = part(p, slice(n - 1, n))
                tail = last if tail is None else combine(last, tail)
            if in_order:
                pairs = slice(0, 2 * half, 2), slice(1, 2 * half, 2)
            else:
                pairs = slice(half), slice(half, 2 * half)
            p = combine(part(p, pairs[0]), part(p, pairs[1]))
            n = half
        return part(p if tail is None else combine(p, tail), 0)

    def _filled(self, number: int, shape: tuple[int, ...]) -> H:
        import numpy as np

        zeros = np.zeros(shape, int)
        return self.read((zeros + number, zeros, zeros, zeros))

    # --- what is equal -------------------------------------------------------------------------

    def equal(self, p: H, q: H) -> np.ndarray:
        """Return a bool array that marks the entries with p = q."""
        import numpy as np

        self._check(p, q, "compare")
        pairs = zip(self.coordinates(p), self.coordinates(q), strict=True)
        same: np.ndarray = np.logical_and.reduce([np.asarray(x == y, bool) for x, y in pairs])
        return same

    def is_zero(self, p: H) -> np.ndarray:
        """Return a bool array that marks the entries with p = 0."""
        zero = self.ring.zero
        return self.equal(p, self.lift((zero, zero, zero, zero)))

    def _no_integers(self) -> str:
        return f"arrays of quaternions over {self.ring} have no form of integers: pickle them"

    def _check(self, p: H, q: H, operation: str) -> None:
        """Raise an error if the shapes of two arrays do not broadcast."""
        left, right = self.shape(p), self.shape(q)
        if left != right and left and right:
            from hfield.fields.base.arrays import check_shapes

            check_shapes(left, right, operation)
