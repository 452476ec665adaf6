"""Many rotations gathered: finite groups, means, running products, best fits to vectors."""

from typing import Any, Self

import numpy as np

from rotation import groups, quaternions
from rotation.batch import Batch, expect_rotations
from rotation.conversions import Conversions
from rotation.errors import RotationError
from rotation.namespaces import expect_numpy


class Gathering(Conversions):
    """What `Rotation` makes of many rotations, or of many vectors."""

    __slots__ = ()

    @classmethod
    def create_group(cls, group: str, axis: str = "Z") -> Self:
        """Return the rotations of a finite group, shape (order,); the identity comes first.

        Parameters
        ----------
        group : str
            ``"I"``, ``"O"`` or ``"T"``, of the icosahedron, octahedron, tetrahedron; ``"Cn"`` of order n or
            ``"Dn"`` of order 2n.
        axis : "X", "Y" or "Z"
            The axis of C and D.

        Raises
        ------
        RotationError
            No such group or axis.

        Examples
        --------
        >>> from rotation import Rotation
        >>> Rotation.create_group("D3").shape
        (6,)
        """
        return cls._of(groups.elements(group, axis))

    def mean(self, weights: Any = None, axis: Any = None) -> Self:
        """Return the mean rotation, the one with the least sum of squared chordal distances.

        Parameters
        ----------
        weights : array_like, optional
            Not negative, not all zero; the shape broadcasts to that of the rotations.
        axis : int or tuple of int, optional
            The batch axes to average over; by default all.

        Raises
        ------
        RotationError
            Nothing to average, bad weights, or a mean that is not determined (such as that of
            half turns about two perpendicular axes).
        """
        from rotation.averaging import mean

        return self._of(mean(self._q, weights, axis))

    def cumprod(self, frame: str = "world") -> Self:
        """Return the running products along the first axis, each of norm 1 to rounding.

        Parameters
        ----------
        frame : "world" or "body"
            In ``"world"`` every next rotation turns about fixed axes, ``r[n]·…·r[0]``; in
            ``"body"`` about the axes already turned, ``r[0]·…·r[n]``.
        """
        from rotation.products import running_products

        return self._of(running_products(self._q, frame))

    def reduce(
        self,
        left: Batch | None = None,
        right: Batch | None = None,
        return_indices: bool = False,
    ) -> Any:
        """Return of all ``l·p·r`` the one of the smallest angle, for each of the rotations p.

        Parameters
        ----------
        left, right : Rotation, shapes (m,) and (n,), optional
            Such as `create_group` returns; by default the identity.
        return_indices : bool
            Return the indices (…) of l and r as well.

        Raises
        ------
        RotationError
            Left or right is no list of rotations.
        ForeignArrayError
            Arrays that are not numpy's.
        """
        one = self._of(np.eye(1, 4))
        ls, rs = (one if side is None else side for side in (left, right))
        expect_rotations(left=ls, right=rs)
        expect_numpy("reduce", self._q, ls._q, rs._q)
        if ls.ndim != 1 or rs.ndim != 1 or not ls.size or not rs.size:
            raise RotationError("left and right are lists, each of at least one rotation")
        m, n = groups.nearest(self._q, ls._q, rs._q)
        reduced = self._of(quaternions.product(quaternions.product(ls._q[m], self._q), rs._q[n]))
        return (reduced, m, n) if return_indices else reduced

    @classmethod
    def align_vectors(
        cls, a: Any, b: Any, weights: Any = None, return_sensitivity: bool = False
    ) -> Any:
        """Return the rotation that takes vectors ``b`` closest to vectors ``a``, and how close.

        Minimises ``Σ w‖a − R·b‖²`` (Wahba's problem); see `rotation.align`.

        Parameters
        ----------
        a, b : array_like, shape (…, N, 3) or (3,)
        weights : array_like, shape (…, N), optional
            Not negative. One may be infinite, in one set of numpy arrays: its pair is aligned exactly.
        return_sensitivity : bool
            Return the sensitivity as well.

        Returns
        -------
        rotation : Rotation, shape (…)
        rssd : array (…)
            The square root of that sum at its least, without the pair of infinite weight.
        sensitivity : array (…, 3, 3)
            Only if asked for: times the variance of the vectors' errors the covariance of the error of R,
            a rotation vector in the axes of a.

        Raises
        ------
        RotationError
            Shapes or weights that do not fit, or vectors that determine no rotation.
        """
        from rotation.wahba import checked, fitted, sensitivity

        vectors = checked(a, b, weights)
        q, rssd = fitted(*vectors)
        if return_sensitivity:
            return cls._of(q), rssd, sensitivity(q, *vectors)
        return cls._of(q), rssd
