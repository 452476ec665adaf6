"""`Rotation`: one rotation of space or an immutable array of them, on any array library."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Literal, Self, overload

import numpy as np
import numpy.typing as npt

from rotation import groups, hints, pytrees, quaternions, sampling
from rotation.action import BY_INVERSE, BY_MATRIX, BY_QUATERNION, FEW, FEW_OWN, write
from rotation.array_types import Array, ArrayLike, Axes, Seed
from rotation.arrays import common_batch, destination, precision, real
from rotation.batch import Batch, expect_rotations
from rotation.conversions import Conversions
from rotation.errors import ForeignArrayError, RotationError
from rotation.matrices import TO_MATRIX, to_matrix
from rotation.namespaces import (
    expect_numpy,
    floats,
    is_numpy,
    namespace,
    points_of,
    quiet,
)
from rotation.native import tensors
from rotation.pytrees import known
from rotation.quaternions import INVERSE, PRODUCT, SHORTER_POWER

if TYPE_CHECKING:
    from mpl_toolkits.mplot3d.axes3d import Axes3D

    from hfield.algebra.quaternion import Quaternion


@pytrees.register_pytree("_q")
class Rotation(Conversions):
    """Rotations of space, stored as unit quaternions, scalar first (thesis, section 2.2.5).

    A single rotation has the shape ``()``; batches have any number of axes. Method names are those of scipy,
    conventions are those of the thesis: quaternions are (w, x, y, z), angles are in radians, and ``p * q``
    applies q first. Numpy rotations are stored in float64, or in float32 if ``dtype`` says so; arrays of
    other libraries keep their library, device and precision. Rows that contain NaN or inf become NaN; other
    rows are not affected.

    Parameters
    ----------
    quat : array_like, shape (…, 4)
        This and all others as in `from_quat`.

    Examples
    --------
    >>> r = Rotation.from_euler("ZYX", [90, 0, 0], degrees=True)
    >>> r.apply([1, 0, 0]).round(15)
    array([0., 1., 0.])
    >>> (r * r).apply([1, 2, 3]).round(12)
    array([-1., -2.,  3.])
    """

    __slots__ = ()
    foreign_names = hints.ROTATION

    def __new__(
        cls, quat: ArrayLike, *, scalar_first: bool = True, dtype: npt.DTypeLike | None = None
    ) -> Self:
        """Make rotations from quaternions, as `from_quat` does."""
        return cls.from_quat(quat, scalar_first=scalar_first, dtype=dtype)

    # Making

    @classmethod
    def identity(
        cls,
        shape: int | Sequence[int] | None = None,
        *,
        dtype: npt.DTypeLike | None = None,
        **others: object,
    ) -> Self:
        """Return the identity rotation, or a batch of it: ``shape`` is a number or a tuple.

        ``dtype`` as in `from_quat`; other arguments are rejected as in `random`.
        """
        hints.refuse_arguments("identity", others)
        q = np.zeros((*sampling.as_shape(shape), 4), dtype and precision(dtype))
        q[..., 0] = 1.0
        return cls._of(q)

    @classmethod
    def from_exact(
        cls, quaternions: Quaternion | list[Quaternion] | tuple[Quaternion, ...]
    ) -> Self:
        """Return the rotations of exact quaternions of hfield, as :func:`rotation.from_exact` does.

        Examples
        --------
        >>> from hfield import H
        >>> q = H("QQ(cos(t/2),sin(t/2))").euler("Z", ["t"])
        >>> Rotation.from_exact(q.subs(t="pi/3")).as_rotvec(degrees=True).round(9)
        array([ 0.,  0., 60.])
        """
        quat = import_module("rotation.exact").exact_coordinates(quaternions)
        return cls.from_quat(quat)

    @classmethod
    def random(
        cls,
        shape: int | Sequence[int] | None = None,
        rng: Seed | None = None,
        *,
        seed: Seed | None = None,
        dtype: npt.DTypeLike | None = None,
        **others: object,
    ) -> Self:
        """Return uniformly distributed rotations (Haar measure).

        Parameters
        ----------
        shape : int or tuple of int, optional
            How many; by default a single one.
        rng, seed : int or numpy.random.Generator, optional
            One of the two names: an argument of `numpy.random.default_rng`. The same seed gives the same
            rotations.
        dtype
            As in `from_quat`.

        Raises
        ------
        RotationError
            No shape, no seed, or two.
        ArgumentError
            Unknown arguments, such as scipy's ``random_state``; the message gives the correct call.
        """
        hints.refuse_arguments("random", others)
        q = sampling.uniform(sampling.as_shape(shape), sampling.generator(rng, seed))
        return cls._stored(q, dtype)

    @classmethod
    def super_fibonacci(cls, n: int) -> Self:
        """Return n evenly distributed rotations, always the same ones, shape (n,).

        They lie on a spiral on the sphere of quaternions, and are as even as the best grids, for any n, at
        negligible cost (M. Alexa, "Super-Fibonacci spirals", CVPR 2022).

        Raises
        ------
        RotationError
            ``n`` is not an integer, or is negative.

        Examples
        --------
        >>> grid = Rotation.super_fibonacci(1000)
        >>> bool(abs(grid.as_matrix().mean(axis=0)).max() < 0.01)  # no direction is favoured
        True
        """
        return cls._of(sampling.super_fibonacci(n))

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
        >>> Rotation.create_group("D3").shape
        (6,)
        """
        return cls._of(groups.elements(group, axis))

    @overload
    @classmethod
    def align_vectors(
        cls,
        a: ArrayLike,
        b: ArrayLike,
        weights: ArrayLike | None = None,
        return_sensitivity: Literal[False] = False,
    ) -> tuple[Self, Array]: ...
    @overload
    @classmethod
    def align_vectors(
        cls,
        a: ArrayLike,
        b: ArrayLike,
        weights: ArrayLike | None = None,
        *,
        return_sensitivity: Literal[True],
    ) -> tuple[Self, Array, Array]: ...
    @overload
    @classmethod
    def align_vectors(
        cls,
        a: ArrayLike,
        b: ArrayLike,
        weights: ArrayLike | None = None,
        return_sensitivity: bool = False,
    ) -> tuple[Self, Array] | tuple[Self, Array, Array]: ...
    @classmethod
    def align_vectors(
        cls,
        a: ArrayLike,
        b: ArrayLike,
        weights: ArrayLike | None = None,
        return_sensitivity: bool = False,
    ) -> tuple[Self, Array] | tuple[Self, Array, Array]:
        """Return the rotation that brings vectors ``b`` closest to vectors ``a``, and the residual.

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
            Only if requested. Multiplied by the variance of the vectors' errors, it is the covariance of the
            error of R, a rotation vector in the axes of a.

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

    # The group

    def __mul__(self, other: object) -> Self:
        if not isinstance(other, Rotation):
            self._refuse_factor(other)
            return NotImplemented
        p, q = self._q, other._q
        made = PRODUCT.function(type(self), p, q)
        return self._of(quaternions.product(p, q)) if made is None else known(made)

    def __pow__(self, exponent: ArrayLike) -> Self:
        if not isinstance(exponent, int | float):
            exponent = floats(exponent, "exponent", namespace(self._q, exponent))
        elif abs(exponent) == 1:  # no rounding; the sign is the same as for all other powers
            q = quaternions.canonical(self._q)
            return self._of(quaternions.inverse(q) if exponent < 0 else q)
        made = SHORTER_POWER.function(type(self), self._q, exponent)
        return self._of(quaternions.power(self._q, exponent)) if made is None else known(made)

    def inverse(self) -> Self:
        """Return the inverse rotations."""
        made = INVERSE.function(type(self), self._q)
        return self._of(quaternions.inverse(self._q)) if made is None else known(made)

    inv = inverse  # as scipy calls it

    def outer(self, other: Rotation) -> Self:
        """Return all products, with shape ``self.shape + other.shape``.

        ``p.outer(q)[i, j]`` is ``p[i] * q[j]``, which applies ``q[j]`` first.
        """
        expect_rotations(other=other)
        q = self._q[(..., *(None,) * other.ndim, slice(None))]
        return self._of(quaternions.product(q, other._q))

    def __eq__(self, other: object) -> Array:  # type: ignore[override]  # entry by entry
        """Compare entry by entry, exactly: q and −q are the same rotation."""
        if not isinstance(other, Rotation):
            return NotImplemented

        p, q = self._q, other._q
        if p.shape != q.shape:
            common_batch(left=self.shape, right=other.shape)
        xp = namespace(p, q)
        return xp.all(p == q, axis=-1) | xp.all(p == -q, axis=-1)

    def __ne__(self, other: object) -> Array:  # type: ignore[override]
        """Compare entry by entry: the negation of ``==``."""
        equal = self.__eq__(other)
        return equal if equal is NotImplemented else namespace(equal).logical_not(equal)

    def __hash__(self) -> int:
        if not self.single:
            raise TypeError("a batch of rotations is compared entry by entry and has no hash")
        return hash(tuple(float(c) for c in quaternions.canonical(self._q)))

    def approx_equal(self, other: Rotation, atol: float = 1e-8, degrees: bool = False) -> Array:
        """Return whether the angle between the rotations is at most ``atol``, elementwise.

        ``atol`` is in radians, or in degrees with ``degrees=True``.
        """
        expect_rotations(other=other)
        return (self.inv() * other).magnitude(degrees) <= atol

    # Many of them

    def mean(self, weights: ArrayLike | None = None, axis: Axes | None = None) -> Self:
        """Return the mean rotation, which minimises the sum of squared chordal distances.

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

        return self._alike(mean(self._double, weights, axis))

    def median(self, weights: ArrayLike | None = None, axis: Axes | None = None) -> Self:
        """Return the geodesic median, which minimises the sum of angles to the rotations.

        A few outliers among many rotations do not move the median far, unlike the mean. If the median is one
        of the given rotations, it is returned exactly. The minimum is global, to 1e-7 of the largest weight:
        if one of the rotations lies a quarter turn or more from the median, branch and bound compares it with
        all others. That takes milliseconds for ten evenly spread rotations, and seconds for a thousand.

        Parameters
        ----------
        weights, axis
            As for `mean`; numpy's arrays only.

        Raises
        ------
        RotationError
            No rotations, an axis that does not exist, negative weights or weights that are all zero; or
            different rotations have the same least sum, so that none of them is the median.
        ForeignArrayError
            Arrays that are not numpy's.

        Examples
        --------
        >>> turns = Rotation.from_euler("Z", [0, 1, 2, 3, 170], degrees=True)
        >>> turns.median().magnitude(degrees=True).round(9)
        np.float64(2.0)
        """
        from rotation.averaging import median

        return self._alike(median(self._double, weights, axis))

    def cumprod(self, frame: str = "world") -> Self:
        """Return the running products along the first axis, each of norm 1 up to rounding.

        Parameters
        ----------
        frame : "world" or "body"
            With ``"world"`` each rotation is about fixed axes, ``r[n]·…·r[0]``; with ``"body"`` about the
            already rotated axes, ``r[0]·…·r[n]``.
        """
        from rotation.products import running_products

        return self._alike(running_products(self._double, frame))

    @overload
    def reduce(
        self,
        left: Batch | None = None,
        right: Batch | None = None,
        return_indices: Literal[False] = False,
    ) -> Self: ...
    @overload
    def reduce(
        self,
        left: Batch | None = None,
        right: Batch | None = None,
        *,
        return_indices: Literal[True],
    ) -> tuple[Self, Array, Array]: ...
    @overload
    def reduce(
        self,
        left: Batch | None = None,
        right: Batch | None = None,
        return_indices: bool = False,
    ) -> Self | tuple[Self, Array, Array]: ...
    def reduce(
        self,
        left: Batch | None = None,
        right: Batch | None = None,
        return_indices: bool = False,
    ) -> Self | tuple[Self, Array, Array]:
        """Return, for each rotation p, the product of least angle among all ``l·p·r``.

        Parameters
        ----------
        left, right : Rotation, shapes (m,) and (n,), optional
            Such as `create_group` returns; by default the identity.
        return_indices : bool
            Return the indices (…) of l and r as well.

        Raises
        ------
        RotationError
            ``left`` or ``right`` is not a list of rotations.
        ForeignArrayError
            Arrays that are not numpy's.
        """
        one = self._of(np.eye(1, 4))
        ls, rs = (one if side is None else side for side in (left, right))
        expect_rotations(left=ls, right=rs)
        expect_numpy("reduce", self._q, ls._q, rs._q)
        if ls.ndim != 1 or rs.ndim != 1 or not ls.size or not rs.size:
            raise RotationError("left and right are lists, each of at least one rotation")
        left_q, q, right_q = ls._double, self._double, rs._double
        m, n = groups.nearest(q, left_q, right_q)
        found = quaternions.product(quaternions.product(left_q[m], q), right_q[n])
        reduced = self._alike(found)
        return (reduced, m, n) if return_indices else reduced

    def disorientation(
        self,
        other: Rotation,
        group: str | Rotation,
        other_group: str | Rotation | None = None,
    ) -> Self:
        """Return the least rotation from one crystal to another, among all those equivalent by symmetry.

        Rotations map crystal axes to world axes, and ``p·g`` is equivalent to p for g in its group. The
        result is the product of least angle among all ``l·p⁻¹·q·r`` with l in ``group`` and r in
        ``other_group``. Among those with the same angle, the quaternion (w ≥ 0) with the largest x is chosen,
        then the largest y, then the largest z; numbers within 2⁻⁴⁰ count as equal. So equivalent crystals
        have the same result.

        Parameters
        ----------
        other : Rotation
            The shapes broadcast.
        group, other_group : str or Rotation
            As in `create_group`, or the result of `create_group` for other axes; ``other_group`` defaults to
            ``group``.

        Raises
        ------
        RotationError
            No such group, or rotations that are not a group; shapes that do not fit.
        ForeignArrayError
            Arrays that are not numpy's.

        Examples
        --------
        >>> p, q = Rotation.identity(), Rotation.from_euler("Z", 100, degrees=True)
        >>> p.disorientation(q, "O").magnitude(degrees=True).round(9)
        np.float64(10.0)
        """
        from rotation.disorientation import least

        expect_rotations(other=other)
        expect_numpy("disorientation", self._q, other._q)
        sides = [
            groups.elements(g)
            if isinstance(g, str)
            else g._double
            if isinstance(g, Rotation)
            else g
            for g in (group, group if other_group is None else other_group)
        ]
        between = quaternions.product(quaternions.inverse(self._double), other._double)
        return self._stored(least(between, *sides), np.result_type(self._q, other._q))

    # Pictures

    def plot(self, ax: Axes3D | None = None, points: ArrayLike | None = None) -> Axes3D:
        """Draw one rotation in space: its axis, its angle, and points before and after.

        Parameters
        ----------
        ax : mpl_toolkits.mplot3d.axes3d.Axes3D, optional
            The axes to draw in, with the first two colours of their cycle; their settings are not changed. By
            default a new pyplot figure with a title, independent of the matplotlibrc.
        points : array_like, shape (n, 3), optional
            Points in any unit of length, by default the three unit vectors. Paths are drawn for up to 24
            points.

        Returns
        -------
        Axes3D
            The axes; ``.figure.savefig(…)`` writes the picture to a file.

        Raises
        ------
        RotationError
            An array of rotations, a rotation or points that are not finite, points of another shape.
        DTypeError
            ``ax`` is not three-dimensional axes, or ``points`` is not an array of points.
        ForeignArrayError
            The rotation is not stored in a numpy array.

        Examples
        --------
        >>> from matplotlib.figure import Figure
        >>> ax = Figure().add_subplot(projection="3d")
        >>> r = Rotation.from_rotvec([0, 0, 120], degrees=True)
        >>> r.plot(ax, points=[[1, 0, 0], [2, 0, 1]]).get_legend_handles_labels()[1]
        ['axis', 'points', 'turned']
        """
        from rotation.figures.space import plot_rotation

        return plot_rotation(self._q, ax, points)

    # Points

    def apply(self, points: ArrayLike, inverse: bool = False, out: Array | None = None) -> Array:
        """Rotate points: ``R·v``.

        Parameters
        ----------
        points : array_like, shape (…, 3)
            Batch shapes broadcast: one rotation with many points, many with one, or pairwise. float32 and
            float64 are kept, integers become float64; strides are arbitrary.
        inverse : bool
            Apply the inverse rotations.
        out : array, optional
            Where to write, of the result's shape and dtype; it may be ``points`` itself.

        Raises
        ------
        RotationError
            Shapes that do not fit, or an ``out`` that overlaps the points in part; then nothing
            has been written.
        DTypeError
            Points or ``out`` of another type.
        """
        q = self._q
        if type(q) is np.ndarray and type(points) in (np.ndarray, list, tuple):
            v = points if type(points) is np.ndarray else real(points, "points")
            if (
                v.dtype.char in "df"
                and q.dtype.char == "d"
                and v.ndim
                and v.shape[-1] == 3
                and v.size <= 3 * (FEW if q.ndim == 1 else FEW_OWN)
                and (q.ndim == 1 or v.ndim == 1 or q.shape[:-1] == v.shape[:-1])
            ):
                if q.ndim > 1:
                    formula, turn = (BY_INVERSE if inverse else BY_QUATERNION), q
                else:
                    formula, turn = BY_MATRIX, TO_MATRIX(INVERSE(q) if inverse else q)
                if out is not None:
                    batch = q.shape[:-1] or v.shape[:-1]
                    result, target = destination(out, batch, v, (q,), "aos")
                    write(formula, target, turn, v)
                    return result
                w = v if v.dtype.char == "d" else v.astype(np.float64)
                image = formula(turn, w)
                return image if w is v else image.astype(np.float32)
        return self._applied(points, inverse, out)

    @quiet
    def _applied(self, points: ArrayLike, inverse: bool, out: Array | None) -> Array:
        q = quaternions.inverse(self._double) if inverse else self._double
        xp = namespace(q, points)
        if not is_numpy(xp) and out is not None:
            raise ForeignArrayError("out is for numpy arrays; other libraries return new ones")
        v = points_of(points, xp)
        common_batch(points=tuple(v.shape[:-1]), rotations=self.shape)
        if is_numpy(xp):
            from rotation.fused import rotate_quat

            return rotate_quat(v, q, out=out)
        if tensors.readable((q, v)):
            return BY_QUATERNION(q, v)
        # A product of matrices could be computed in reduced precision on a GPU; these sums are not.
        turned = xp.sum(to_matrix(q) * v[..., None, :], axis=-1)
        return xp.astype(turned, v.dtype)

    def apply_outer(self, points: ArrayLike) -> Array:
        """Rotate every point by every rotation; the result has shape ``self.shape + points.shape``."""
        v = points_of(points, namespace(self._q, points))
        q = self._q[(..., *(None,) * (len(v.shape) - 1), slice(None))]
        return self._of(q).apply(v)
