"""How an algebra makes arrays of its elements, and products of many."""

from __future__ import annotations

from typing import Any

from hfield.errors import NotFiniteError, TooLargeError
from hfield.quaternion import Parent, Quaternion, held_by

MOST = 10**8  # elements of an array that lists all


class ArrayMakers(Parent):
    """The part of an algebra's methods that are about arrays."""

    def from_array(self, values: object) -> Quaternion:
        """Return the array of quaternions with these integers, as :meth:`Quaternion.to_array` gives them.

        They are copied. Integers of one element give that element. Raises :class:`CoercionError` for
        what stands for no elements.

        >>> import numpy as np
        >>> from hfield import H
        >>> H("GF(7)").from_array(np.array([[1, 2], [0, 6], [0, 0], [5, 0]]))[0]
        1 + 5k
        """
        how = self.array_holding
        held = how.from_array(values)
        return held_by(self, how, held) if how.shape(held) else self(*how.single(held))

    def product(self, values: Any, axis: int | None = None) -> Quaternion:
        """Return the ordered product of an array, or of a list of elements, from left to right.

        An array is multiplied along an axis, or all of it in order, neighbour by neighbour in a tree.

        >>> from hfield import H
        >>> H("QQ").product(["i", "j", "k"])
        −1
        """
        if isinstance(values, Quaternion) and values.shape:
            found: Quaternion = self(values).product(axis)
            return found
        parts = [self(x) for x in values] or [self.basis[0]]
        while len(parts) > 1:  # factors of equal size multiply fastest
            pairs = zip(parts[::2], parts[1::2], strict=False)
            parts = [p * q for p, q in pairs] + parts[len(parts) // 2 * 2 :]
        return parts[0]

    def element_array(self) -> Quaternion:
        """Return all q⁴ elements over a finite ring as one array, in the order of :meth:`elements`.

        Raises :class:`NotFiniteError`, and :class:`TooLargeError` beyond 10⁸ elements.

        >>> from hfield import H
        >>> p = H("GF(3)").element_array()
        >>> int(p.units().sum()), int((p * p == -1).sum())
        (48, 6)
        """
        if self.ring.order is None:
            raise NotFiniteError(f"{self} is infinite, so its elements cannot be listed")
        if self.ring.order**4 > MOST:
            raise TooLargeError(
                f"{self} has more than 10^8 elements; A.elements() runs through them"
            )
        import numpy as np

        scalars = self(list(self.ring.elements()), 0, 0, 0)
        w, x, y, z = (scalars[n.ravel()] for n in np.indices((len(scalars),) * 4, np.uint32))
        _, i, j, k = self.basis
        return w + x * i + y * j + z * k
