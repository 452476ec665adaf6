"""What arrays of quaternions can do beside arithmetic: indexing, sums, ordered products, plain arrays."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, Self

from hfield.errors import CoercionError
from hfield.product import Scalar
from hfield.rings.holding import Batch
from hfield.rings.powers import FEW, bits, check_growth

if TYPE_CHECKING:
    import numpy as np

    from hfield.rings.arrays import Index


class BatchMethods:
    """The part of a quaternion's methods that are asked of an array of them."""

    __slots__ = ()

    _algebra: Any
    _how: Any
    _held: Any

    def _alike(self, held: Any) -> Self:
        raise NotImplementedError

    def _new(self, w: Scalar, x: Scalar, y: Scalar, z: Scalar) -> Self:
        raise NotImplementedError

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of an array of quaternions; ``()`` for a single one."""
        return self._how.shape(self._held) if isinstance(self._how, Batch) else ()

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("a single quaternion has no length; its coordinates are .coordinates")
        return self.shape[0]

    def __getitem__(self, index: Index) -> Self:
        """Take elements out of an array of quaternions, as numpy indexes arrays."""
        how = self._how
        if not isinstance(how, Batch) or not how.shape(self._held):
            raise TypeError("a single quaternion cannot be indexed; use q.coordinates[n]")
        return self._one_or_many(how, how.part(self._held, index))

    def _one_or_many(self, how: Batch, held: Any) -> Self:
        """Return what is held: without a dimension it is a single element."""
        return self._alike(held) if how.shape(held) else self._new(*how.single(held))

    def __iter__(self) -> Iterator[Self]:
        return (self[n] for n in range(len(self)))

    def _array(self, what: str) -> Batch:
        if not isinstance(self._how, Batch):
            raise CoercionError(f"a single quaternion has no {what}; arrays of quaternions have")
        return self._how

    def units(self) -> np.ndarray:
        """Return a bool array: which entries have an inverse."""
        return self._array("entries").units(self._held)

    def sum(self, axis: int | None = None) -> Any:
        """Return the sum along an axis, or of all entries.

        >>> from hfield import H
        >>> H("GF(7)")([1, 2, 3], 1, 0, [4, 4, 4]).sum()
        6 + 3i + 5k
        """
        how = self._array("sum")
        return self._folded(axis, how.sum, 0, False)

    def product(self, axis: int | None = None) -> Any:
        """Return the product along an axis, or of all entries, from left to right in their order.

        Pairs of neighbours are multiplied until one is left, so an array of n takes log n calls.

        >>> from hfield import H
        >>> H("QQ")(0, [1, 0, 0], [0, 1, 0], [0, 0, 1]).product()  # i·j·k
        −1
        """
        how = self._array("product")
        return self._folded(axis, how.product, 1, True)

    def dot(self, other: Any, axis: int | None = None) -> Any:
        """Return the sum of the products with the entries of another array, along an axis or of all."""
        self._array("dot product")
        return (self * other).sum(axis)

    def reshape(self, *shape: int | tuple[int, ...]) -> Any:
        """Return the same entries in another shape, as numpy does it. Raises :class:`CoercionError`."""
        how = self._array("shape")
        sizes: Any = shape[0] if len(shape) == 1 else shape
        try:
            return self._one_or_many(how, how.reshaped(self._held, sizes))
        except (ValueError, TypeError) as error:
            raise CoercionError(
                f"an array of quaternions of shape {self.shape} has no shape {shape}: {error}"
            ) from None

    def to_array(self) -> Any:
        """Return all coordinates as one numpy array of integers, which ``A.from_array`` takes back.

        Its shape is ``(4, *shape)``. Over ℤ/n they are residues, over GF(pⁿ) labels (the digits of an element
        in base p, as galois has them), over ℤ the numbers as int64, however few bits hold
        them. Over ℚ it is ``(5, *shape)``: four numerators over the denominator that comes last, after the
        basis is scaled to integral structure constants. It is
        read-only, and no copy where the array was computed. Raises :class:`CoercionError` over other
        rings, and for numbers of more than 64 bits.

        >>> from hfield import H
        >>> H("GF(9)")([1, 2], "x", 0, 0).to_array().tolist()
        [[1, 2], [3, 3], [0, 0], [0, 0]]
        """
        return self._array("array form").to_array(self._held)

    def _folded(
        self, axis: int | None, combine: Callable[[Any, Any], Any], neutral: int, ordered: bool
    ) -> Any:
        how, held, shape = self._how, self._held, self.shape
        if axis is None:
            held, shape, axis = how.reshaped(held, (-1,)), (math.prod(shape),), 0
        if not -len(shape) <= axis < len(shape):
            raise CoercionError(f"an array of quaternions of shape {shape} has no axis {axis}")
        axis %= len(shape)
        if shape[axis]:
            held = folded(how, held, axis, combine, ordered)
        else:
            held = _filled(how, neutral, (*shape[:axis], *shape[axis + 1 :]))
        return self._one_or_many(how, held)


def folded(
    how: Batch, held: Any, axis: int, combine: Callable[[Any, Any], Any], ordered: bool
) -> Any:
    """Combine the elements along an axis, in a tree; neighbours with each other if ``ordered``."""
    n = how.shape(held)[axis]

    def part(x: tuple[object, ...], index: slice | int) -> Any:
        return how.part(x, (*(slice(None),) * axis, index))

    tail = None  # what comes after the last of those that are left
    while n > 1:
        half = n // 2
        if n % 2:
            last = part(held, slice(n - 1, n))
            tail = last if tail is None else combine(last, tail)
        pairs = (
            (slice(0, 2 * half, 2), slice(1, 2 * half, 2))
            if ordered
            else (slice(half), slice(half, 2 * half))
        )
        held = combine(*(part(held, index) for index in pairs))
        n = half
    return part(held if tail is None else combine(held, tail), 0)


def raised(how: Batch, held: Any, n: int) -> Any:
    """Return the n-th powers of an array, by repeated squaring, n ≥ 0. Raises :class:`TooLargeError`."""
    if n == 0:
        return _filled(how, 1, how.shape(held))
    result = held
    start = bits(held) if n > FEW else None
    for bit in bin(n)[3:]:
        if start is not None:
            check_growth(start, result)
        result = how.product(result, result)
        if bit == "1":
            result = how.product(result, held)
    return result


def _filled(how: Batch, number: int, shape: tuple[int, ...]) -> Any:
    import numpy as np

    zeros = np.zeros(shape, int)
    return how.read((zeros + number, zeros, zeros, zeros))
