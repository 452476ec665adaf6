"""Convert rigid motions to and from matrices, components, twists, dual quaternions and screws."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Self

import numpy as np

from rotation import pytrees, sampling, vectors
from rotation import rigid_motions as motions
from rotation.array_types import Array, ArrayLike
from rotation.arrays import common_batch
from rotation.batch import expect_rotations
from rotation.errors import RotationError
from rotation.immutable_arrays import ImmutableArray
from rotation.matrices import from_matrix
from rotation.namespaces import copied, expect_last, floats, is_numpy, namespace
from rotation.rotation import Rotation

MAX_STORED_MATRICES = (
    16_384  # matrices that a batch keeps once they are computed a second time: 2 MB
)
_COMPUTED_ONCE = np.empty(0)  # marks matrices that were computed once


class Forms(ImmutableArray):
    """Unit quaternions (…, 4) and translations (…, 3), with a cache of matrices that were computed twice."""

    __slots__ = ("_matrix", "_t")

    _t: Array
    _matrix: Array | None  # if it was computed twice, of at most MAX_STORED_MATRICES
    _called = "transform"

    @classmethod
    def _of(cls, q: Array, t: Array) -> Self:
        """Wrap unit quaternions and translations of broadcastable shapes, without copying."""
        xp = namespace(q, t)
        batch = np.broadcast_shapes(tuple(q.shape[:-1]), tuple(t.shape[:-1]))
        self = object.__new__(cls)
        for name, array, length in (("_q", q, 4), ("_t", t, 3)):
            if tuple(array.shape) != (*batch, length):
                array = xp.broadcast_to(array, (*batch, length))
            if is_numpy(xp) and array.flags.writeable:
                array.flags.writeable = False
            object.__setattr__(self, name, array)
        object.__setattr__(self, "_matrix", None)
        return pytrees.known(self)

    @classmethod
    def _of_rows(cls, rows: Array) -> Self:
        return cls._of(rows[..., :4], rows[..., 4:])

    @classmethod
    def identity(cls, shape: int | Sequence[int] | None = None) -> Self:
        """Return the identity motion, or a batch of it: ``shape`` is a number or a tuple."""
        batch = sampling.as_shape(shape)
        return cls._of(Rotation.identity(batch)._q, np.zeros((*batch, 3)))

    @classmethod
    def from_matrix(cls, matrix: ArrayLike, *, orthonormalize: bool = False) -> Self:
        """Make transforms from homogeneous matrices (…, 4, 4), whose last row is 0, 0, 0, 1.

        Raises
        ------
        RotationError
            The last row is different, or the upper left 3 × 3 block is not a rotation; see
            `Rotation.from_matrix`.
        """
        m = floats(matrix, "matrices")
        motions.expect_affine(m)
        q = from_matrix(m[..., :3, :3], orthonormalize)
        return cls._of(q, copied(m[..., :3, 3]))

    @classmethod
    def from_rotation(cls, rotation: Rotation) -> Self:
        """Make transforms that rotate without translating."""
        expect_rotations(rotation=rotation)
        q = rotation._double
        return cls._of(q, 0.0 * q[..., 1:])

    @classmethod
    def from_translation(cls, translation: ArrayLike) -> Self:
        """Make transforms that translate by ``translation`` (…, 3) without rotating."""
        t = _copied(translation, "translations")
        xp = namespace(t)
        one, zero = xp.ones_like(t[..., :1]), xp.zeros_like(t)
        return cls._of(xp.concat([one, zero], axis=-1), t)

    @classmethod
    def from_components(cls, translation: ArrayLike, rotation: Rotation) -> Self:
        """Make transforms that rotate first, then translate; the batch shapes broadcast."""
        expect_rotations(rotation=rotation)
        t = _copied(translation, "translations")
        common_batch(translation=tuple(t.shape[:-1]), rotation=rotation.shape)
        return cls._of(rotation._double, t)

    @classmethod
    def from_exp_coords(cls, exp_coords: ArrayLike) -> Self:
        """Make transforms from exponential coordinates (…, 6): a rotation vector, then ``J⁻¹·t``."""
        x = _copied(exp_coords, "exponential coordinates", 6)
        v, u = x[..., :3], x[..., 3:]
        return cls._of(vectors.from_rotvec(v), motions.JACOBIAN_TIMES(v, u))

    @classmethod
    def from_dual_quat(cls, dual_quat: ArrayLike, *, scalar_first: bool = True) -> Self:
        """Make transforms from dual quaternions (…, 8): ``q``, then ``½·t·q``; they are normalised.

        Raises
        ------
        RotationError
            The first half is zero.
        """
        d = _copied(dual_quat, "dual quaternions", 8)
        xp = namespace(d)
        if not scalar_first:
            d = xp.concat(
                [xp.roll(d[..., :4], 1, axis=-1), xp.roll(d[..., 4:], 1, axis=-1)], axis=-1
            )
        return cls._of_rows(motions.from_dual(d))

    @classmethod
    def from_screw(
        cls,
        axis: ArrayLike,
        point: ArrayLike,
        angle: ArrayLike,
        displacement: ArrayLike,
        degrees: bool = False,
    ) -> Self:
        """Make the motions along screws: a rotation about a line and a translation along it.

        Parameters
        ----------
        axis : array_like, shape (…, 3)
            The direction of the line, of any length but 0.
        point : array_like, shape (…, 3)
            A point on it.
        angle, displacement : array_like, shape (…)
            The batch shapes broadcast.

        Raises
        ------
        RotationError
            An axis is zero.
        """
        return cls._of(*motions.from_screw(axis, point, angle, displacement, degrees))

    @property
    def rotation(self) -> Rotation:
        """The rotations, of the same batch shape."""
        return Rotation._of(copied(self._q))

    @property
    def translation(self) -> Array:
        """The translations, shape (…, 3), as a copy."""
        return copied(self._t)

    def as_components(self) -> tuple[Array, Rotation]:
        """Return the translations and the rotations."""
        return self.translation, self.rotation

    def as_matrix(self) -> Array:
        """Return the homogeneous matrices, shape (…, 4, 4)."""
        stored = self._matrix
        if stored is not None and stored is not _COMPUTED_ONCE:
            return stored.copy()
        m = motions.MATRIX(self._q, self._t)
        if type(m) is np.ndarray and m.size <= 16 * MAX_STORED_MATRICES:
            if stored is None:  # most callers need it once
                object.__setattr__(self, "_matrix", _COMPUTED_ONCE)
                return m
            object.__setattr__(self, "_matrix", m)
            return m.copy()
        return m

    def as_exp_coords(self) -> Array:
        """Return the exponential coordinates, shape (…, 6), with angles in [0, π]."""
        v = vectors.to_rotvec(self._q)
        return namespace(v).concat([v, motions.INVERSE_JACOBIAN_TIMES(v, self._t)], axis=-1)

    @classmethod
    def exp(cls, tangent: ArrayLike) -> Self:
        """Make transforms from exponential coordinates (…, 6), as `from_exp_coords` does."""
        return cls.from_exp_coords(tangent)

    def log(self) -> Array:
        """Return the exponential coordinates (…, 6), as `as_exp_coords` does."""
        return self.as_exp_coords()

    def adjoint(self) -> Array:
        """Return the matrices (…, 6, 6) with ``p·exp(x)·p⁻¹ = exp(Ad·x)``.

        As in exponential coordinates, the rotation comes first: ``[[R, 0], [[t]×·R, R]]``. The matrix
        converts a twist from body axes to world axes.
        """
        return motions.ADJOINT(self._q, self._t)

    def as_dual_quat(self, *, scalar_first: bool = True) -> Array:
        """Return the unit dual quaternions, shape (…, 8): ``q``, then ``½·t·q``."""
        d = motions.DUAL(self._q, self._t)
        xp = namespace(d)
        if scalar_first:
            return d
        return xp.concat(
            [xp.roll(d[..., :4], -1, axis=-1), xp.roll(d[..., 4:], -1, axis=-1)], axis=-1
        )

    def as_screw(self, degrees: bool = False) -> motions.Screw:
        """Return the screws of the motions; every rigid motion is a motion along a screw (Chasles)."""
        return motions.to_screw(self._q, self._t, degrees)


def _copied(value: object, what: str, length: int = 3) -> Array:
    array = floats(value, what)
    if not array.ndim:
        raise RotationError(f"{what} has shape (); expected (…, {length})")
    expect_last(array, (length,), what)
    return copied(array)
