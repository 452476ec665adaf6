"""The part of `Rotation` that converts between representations: ``from_…`` and ``as_…``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Self

import numpy as np
import numpy.typing as npt

from rotation import davenport, euler, hints, matrices, quaternions, vectors
from rotation.array_types import Array, ArrayLike
from rotation.batch import Batch
from rotation.errors import DTypeError
from rotation.namespaces import copied, expect_last, expect_numpy, floats, namespace, refuse_rows

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation as ScipyRotation


class Conversions(Batch):
    """Unit quaternions, scalar first, with all conversions ``from_…`` and ``as_…``."""

    __slots__ = ()

    @classmethod
    def from_quat(
        cls, quat: ArrayLike, *, scalar_first: bool = True, dtype: npt.DTypeLike | None = None
    ) -> Self:
        """Make rotations from quaternions, which are normalised.

        Parameters
        ----------
        quat : array_like, shape (…, 4)
            (w, x, y, z), the coordinates over e, i, j, k; of any length from 1e-300 to 1e300.
        scalar_first : bool
            ``False`` takes (x, y, z, w), as scipy does by default.
        dtype : float32 or float64, optional
            The type in which numpy rotations are stored, by default float64. float32 is rounded to at the end
            and kept by later operations (see `astype`).

        Raises
        ------
        RotationError
            A quaternion is zero (the message names its row), or the shape is wrong.
        DTypeError, ForeignArrayError
            Another dtype, or any dtype for arrays that are not numpy's.
        """
        if not scalar_first:
            quat = floats(quat, "quaternions")
            expect_last(quat, (4,), "quaternions")
            quat = namespace(quat).roll(quat, 1, axis=-1)
        return cls._stored(quaternions.normalised(quat), dtype)

    @classmethod
    def from_matrix(
        cls,
        matrix: ArrayLike,
        *,
        orthonormalize: bool = False,
        dtype: npt.DTypeLike | None = None,
        **others: object,
    ) -> Self:
        """Make rotations from matrices.

        Parameters
        ----------
        matrix : array_like, shape (…, 3, 3)
            Orthogonal to within 1e-6 (float32: 1e-3), of determinant 1.
        orthonormalize : bool
            Use the rotation nearest to each matrix, which must have a positive determinant.
        dtype
            As in `from_quat`.

        Raises
        ------
        RotationError
            A reflection; a matrix too far from orthogonal, or with ``orthonormalize`` a singular one.
        ArgumentError
            Unknown arguments, such as scipy's ``assume_valid``; the message gives the correct call.
        """
        hints.refuse_arguments("from_matrix", others)
        return cls._stored(matrices.from_matrix(matrix, orthonormalize), dtype)

    @classmethod
    def from_euler(
        cls,
        seq: str,
        angles: ArrayLike,
        degrees: bool = False,
        *,
        dtype: npt.DTypeLike | None = None,
    ) -> Self:
        """Make rotations from Euler angles in any of the 24 conventions, or about one or two axes.

        Parameters
        ----------
        seq : str
            Uppercase is intrinsic, ``ZYX = R_z(a₀)·R_y(a₁)·R_x(a₂)``; lowercase extrinsic,
            ``zyx = R_x(a₂)·R_y(a₁)·R_z(a₀)``.
        angles : array_like, shape (…, len(seq))
            For one letter also a number, or a one-dimensional array of angles.
        degrees : bool
            The angles are in degrees, not radians.
        dtype
            As in `from_quat`.

        Raises
        ------
        RotationError
            No such sequence, or angles that do not fit it.
        """
        return cls._stored(euler.from_euler(seq, angles, degrees), dtype)

    @classmethod
    def from_davenport(
        cls,
        axes: ArrayLike,
        order: str,
        angles: ArrayLike,
        degrees: bool = False,
        *,
        dtype: npt.DTypeLike | None = None,
    ) -> Self:
        """Make rotations from angles about one to three axes, each perpendicular to the next.

        Parameters
        ----------
        axes : array_like, shape (3,) or (…, n, 3), n at most 3
            Of any length but 0; the batch shapes of axes and angles broadcast.
        order : "extrinsic" or "intrinsic"
            About fixed axes, or about axes that rotate with the body; "e" and "i" are also accepted.
        angles : array_like, shape (…, n)
            For one axis also a number, or a one-dimensional array of angles.
        degrees : bool
            The angles are in degrees, not radians.
        dtype
            As in `from_quat`.

        Raises
        ------
        RotationError
            Axes, an order or angles that do not fit.
        """
        return cls._stored(davenport.from_davenport(axes, order, angles, degrees), dtype)

    @classmethod
    def from_rotvec(
        cls, rotvec: ArrayLike, degrees: bool = False, *, dtype: npt.DTypeLike | None = None
    ) -> Self:
        """Make rotations from vectors (…, 3) whose length is the angle and direction the axis.

        ``dtype`` as in `from_quat`.
        """
        return cls._stored(vectors.from_rotvec(rotvec, degrees), dtype)

    @classmethod
    def exp(cls, tangent: ArrayLike) -> Self:
        """Make rotations from rotation vectors in radians, as `from_rotvec` does."""
        return cls.from_rotvec(tangent)

    def log(self) -> Array:
        """Return the rotation vectors in radians, as `as_rotvec` does."""
        return self.as_rotvec()

    def adjoint(self) -> Array:
        """Return the matrices (…, 3, 3) with ``p·exp(x)·p⁻¹ = exp(Ad·x)``: those of `as_matrix`."""
        return self.as_matrix()

    @classmethod
    def from_axis_angle(
        cls,
        axis: ArrayLike,
        angle: ArrayLike,
        degrees: bool = False,
        *,
        dtype: npt.DTypeLike | None = None,
    ) -> Self:
        """Make rotations by ``angle`` (…) about ``axis`` (…, 3); the batch shapes broadcast.

        ``dtype`` as in `from_quat`.

        Raises
        ------
        RotationError
            An axis is zero; any other length is allowed.
        """
        return cls._stored(vectors.from_axis_angle(axis, angle, degrees), dtype)

    @classmethod
    def from_mrp(cls, mrp: ArrayLike, *, dtype: npt.DTypeLike | None = None) -> Self:
        """Make rotations from modified Rodrigues parameters (…, 3), ``tan(angle/4)·axis``.

        ``dtype`` as in `from_quat`.
        """
        return cls._stored(vectors.from_mrp(mrp), dtype)

    @classmethod
    def from_6d(cls, numbers: ArrayLike, *, dtype: npt.DTypeLike | None = None) -> Self:
        """Make rotations from six numbers (…, 6): two vectors, which are orthonormalised in order.

        They become the first two columns of the matrix. This map is continuous, unlike any map from three or
        four numbers: Y. Zhou et al., "On the continuity of rotation representations in neural networks"
        (2019). ``dtype`` as in `from_quat`.

        Raises
        ------
        RotationError
            The first vector is zero, or the second is a multiple of it.
        """
        return cls._stored(matrices.from_columns(numbers), dtype)

    @classmethod
    def between(cls, source: ArrayLike, target: ArrayLike) -> Self:
        """Make the rotations of least angle that map directions ``source`` (…, 3) to ``target`` (…, 3).

        Opposite directions are related by half turns about many axes; the axis used is perpendicular to
        ``source`` and to the coordinate axis farthest from it.

        Raises
        ------
        RotationError
            A direction is zero.
        """
        return cls._of(vectors.between(source, target))

    @classmethod
    def from_scipy(cls, rotation: ScipyRotation) -> Self:
        """Make rotations from scipy's or from `rotation.compat`'s. Raises DTypeError for anything else."""
        if not hints.is_scipys(rotation, "Rotation"):
            raise DTypeError(
                f"{hints.described(rotation)}; expected a scipy.spatial.transform.Rotation"
            )
        return cls.from_quat(rotation.as_quat(), scalar_first=False)

    def to_scipy(self) -> ScipyRotation:
        """Return the rotations as a `scipy.spatial.transform.Rotation`; scipy must be installed.

        Raises
        ------
        RotationError
            A row is NaN, which scipy's rotations cannot represent.
        ForeignArrayError
            The rotations are not stored in numpy arrays.
        """
        from scipy.spatial.transform import Rotation

        q = self.as_quat(scalar_first=False)
        expect_numpy("to_scipy", q)
        invalid = namespace(q).isnan(q[..., 0])
        refuse_rows(invalid, "the rotation", "is NaN, which scipy does not take; leave it out")
        return Rotation.from_quat(q)

    def as_quat(self, *, scalar_first: bool = True, canonical: bool = False) -> Array:
        """Return the unit quaternions, shape (…, 4).

        Parameters
        ----------
        scalar_first : bool
            ``False`` returns (x, y, z, w).
        canonical : bool
            Return the one of q and −q whose first nonzero coordinate (w, x, y, z) is positive; otherwise the
            sign is the one that was computed.
        """
        q = quaternions.canonical(self._q) if canonical else self._q
        return copied(q) if scalar_first else quaternions.scalar_last(q)

    def as_matrix(self) -> Array:
        """Return the matrices, shape (…, 3, 3), that rotate column vectors."""
        return matrices.to_matrix(self._q)

    def as_6d(self) -> Array:
        """Return the first two columns of the matrices, one after the other, shape (…, 6)."""
        m = self.as_matrix()
        return namespace(m).concat([m[..., :, 0], m[..., :, 1]], axis=-1)

    def as_euler(self, seq: str, degrees: bool = False, **others: object) -> Array:
        """Return Euler angles, shape (…, 3), for a sequence of three letters.

        The first and third angle lie in [−π, π]. The second lies in [0, π] if the first and the last letter
        agree, else in [−π/2, π/2]. In gimbal lock the third angle is 0, without error or warning, and the
        angles give the same rotation up to rounding.

        Raises
        ------
        RotationError
            No such sequence.
        ArgumentError
            Unknown arguments, such as scipy's ``suppress_warnings``; the message gives the correct call.
        """
        hints.refuse_arguments("as_euler", others)
        return euler.to_euler(self._q, seq, degrees)

    def as_davenport(self, axes: ArrayLike, order: str, degrees: bool = False) -> Array:
        """Return the angles about three axes (…, 3, 3), shape (…, 3); see `from_davenport`.

        The first and third angle lie in [−π, π], the second in an interval of length π. In gimbal lock the
        third angle is 0.

        Raises
        ------
        RotationError
            The number of axes is not three, or the axes are not perpendicular as required.
        """
        return davenport.to_davenport(self._q, axes, order, degrees)[0]

    def as_rotvec(self, degrees: bool = False) -> Array:
        """Return the rotation vectors, shape (…, 3), with lengths in [0, π]."""
        return vectors.to_rotvec(self._q, degrees)

    def as_axis_angle(self, degrees: bool = False) -> tuple[Array, Array]:
        """Return unit axes (…, 3) and angles (…) in [0, π]; the identity has the axis z."""
        return vectors.to_axis_angle(self._q, degrees)

    def as_columns(self, degrees: bool = False) -> dict[str, Array]:
        """Return the rotations as columns by name, for a table: ``pandas.DataFrame(r.as_columns())``.

        The columns are ``angle``, ``axis_x``, ``axis_y``, ``axis_z``, as in `as_axis_angle`, and ``w``,
        ``x``, ``y``, ``z``, as in `as_quat`. Each has the shape (size,), with one row per rotation, in C
        order. The angles are in radians, or in degrees with ``degrees=True``.

        Raises
        ------
        ForeignArrayError
            The rotations are not stored in numpy arrays.
        """
        expect_numpy("as_columns", self._q)
        q = self._q.reshape(-1, 4)
        axes, angles = vectors.to_axis_angle(q, degrees)
        names = ("angle", "axis_x", "axis_y", "axis_z", "w", "x", "y", "z")
        return dict(zip(names, np.column_stack([angles, axes, q]).T.copy(), strict=True))

    def as_mrp(self) -> Array:
        """Return the modified Rodrigues parameters, shape (…, 3), with lengths in [0, 1]."""
        return vectors.to_mrp(self._q)

    def magnitude(self, degrees: bool = False) -> Array:
        """Return the angles of rotation, in [0, π]."""
        return quaternions.angle(self._q, degrees)
