"""`Rotation` with the names, conventions and behaviour of scipy's."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence
from typing import Literal, Self, cast, overload

import numpy as np
import numpy.typing as npt

from rotation import davenport, quaternions
from rotation import rotation as ours
from rotation.array_types import Array, ArrayLike, Axes, Index, Seed
from rotation.compat import answers, checks
from rotation.compat.assignable import Assignable
from rotation.errors import RotationError
from rotation.euler import sequence
from rotation.matrices import from_matrix
from rotation.namespaces import quiet
from rotation.sampling import generator

_LOCKED = (
    "Gimbal lock detected. Setting third angle to zero since it is not possible to "
    "uniquely determine all angles."
)
_LOCK = 1e-7


class Rotation(Assignable):
    """One rotation or an array of them: scalar last, and items can be assigned.

    Parameters
    ----------
    quat : array_like, shape (…, 4)
        (x, y, z, w), or (w, x, y, z) with ``scalar_first``.
    normalize, copy : bool
        Without ``normalize``, quaternions are assumed to be unit quaternions.
    """

    _axes, _called = 1, "rotation"

    def __init__(
        self, quat: ArrayLike, normalize: bool = True, copy: bool = True, scalar_first: bool = False
    ) -> None:
        q = checks.numbers(quat, "quat", "(..., 4)", (4,))
        q = q if scalar_first else np.roll(q, 1, axis=-1)
        if normalize and np.isnan(q).any():
            raise RotationError("Found NaN among the quaternions of `quat`.")
        q = quaternions.normalised(q) if normalize else q
        self._q = np.array(q)

    @classmethod
    def _of(cls, q: Array) -> Self:
        self = object.__new__(cls)
        self._q = q if q.flags.writeable else q.copy()
        return self

    @property
    def _ours(self) -> ours.Rotation:
        return ours.Rotation._of(self._q.copy())

    @property
    def _quat(self) -> Array:
        return self.as_quat()

    # Making

    @classmethod
    def from_quat(cls, quat: ArrayLike, *, scalar_first: bool = False) -> Self:
        """Make rotations from quaternions, scalar last."""
        return cls(quat, scalar_first=scalar_first)

    @classmethod
    @quiet
    def from_matrix(cls, matrix: ArrayLike, *, assume_valid: bool = False) -> Self:
        """Make rotations from matrices; a matrix that is not a rotation is replaced by the nearest
        rotation.
        """
        m = checks.numbers(matrix, "matrix", "(..., 3, 3)", (3, 3))
        if assume_valid:
            return cls._of(answers.unchecked(m))
        if np.any(np.linalg.det(m) <= 0.0):
            raise RotationError("Non-positive determinant (left-handed or null coordinate frame)")
        try:
            return cls._of(from_matrix(m))
        except RotationError:
            return cls._of(from_matrix(m, orthonormalize=True))

    @classmethod
    def from_rotvec(cls, rotvec: ArrayLike, degrees: bool = False) -> Self:
        """Make rotations from rotation vectors."""
        v = checks.numbers(rotvec, "rot_vec", "(..., 3)", (3,))
        return cls._of(ours.Rotation.from_rotvec(v, degrees)._q)

    @classmethod
    def from_mrp(cls, mrp: ArrayLike) -> Self:
        """Make rotations from modified Rodrigues parameters."""
        v = checks.numbers(mrp, "mrp", "(..., 3)", (3,))
        return cls._of(ours.Rotation.from_mrp(v)._q)

    @classmethod
    def from_euler(cls, seq: str, angles: ArrayLike, degrees: bool = False) -> Self:
        """Make rotations from Euler angles."""
        a = _angles(angles, len(sequence(seq).axes))
        return cls._of(ours.Rotation.from_euler(seq, a[None], degrees)._q[0])

    @classmethod
    def from_davenport(
        cls, axes: ArrayLike, order: str, angles: ArrayLike, degrees: bool = False
    ) -> Self:
        """Make rotations from angles about one to three axes."""
        e = _davenport_axes(axes, order)
        return cls._of(davenport.from_davenport(e, order, _angles(angles, e.shape[-2]), degrees))

    @staticmethod
    def identity(num: int | None = None, *, shape: int | Sequence[int] | None = None) -> Rotation:
        """Return the identity, or a batch of it."""
        return Rotation._of(ours.Rotation.identity(checks.batch(num, shape))._q)

    @staticmethod
    def random(
        num: int | None = None,
        rng: Seed | None = None,
        *,
        shape: int | Sequence[int] | None = None,
        random_state: Seed | None = None,
    ) -> Rotation:
        """Return uniformly distributed rotations; ``random_state`` is the older name of ``rng``."""
        size = checks.batch(num, shape)
        rng = random_state if rng is None else rng
        legacy = (
            cast(np.random.RandomState, rng)
            if hasattr(rng, "random_sample")
            else generator(rng, None)
        )
        sample = legacy.normal(size=(*size, 4))
        return Rotation.from_quat(sample)

    @classmethod
    def create_group(cls, group: str, axis: str = "Z") -> Self:
        """Return the rotations of a finite group."""
        if not isinstance(group, str):
            raise RotationError("`group` argument must be a string")
        if not isinstance(axis, str) or axis not in tuple("xyzXYZ"):
            raise RotationError("`axis` must be one of x, y, z, X, Y, Z")
        if group not in ("I", "O", "T") and not (group[:1] in ("C", "D") and group[1:].isdigit()):
            raise RotationError("`group` must be one of 'I', 'O', 'T', 'Dn', 'Cn'")
        if group[1:].isdigit() and int(group[1:]) < 1:
            raise RotationError("Group order must be positive")
        return cls._of(answers.group_elements(group, axis))

    # Reading

    def as_quat(self, canonical: bool = False, *, scalar_first: bool = False) -> Array:
        """Return the quaternions, scalar last."""
        q = quaternions.canonical(self._q) if canonical else self._q
        return np.array(q) if scalar_first else np.roll(q, -1, axis=-1)

    def as_matrix(self) -> Array:
        """Return the matrices."""
        return self._ours.as_matrix()

    def as_rotvec(self, degrees: bool = False) -> Array:
        """Return the rotation vectors."""
        return self._ours.as_rotvec(degrees)

    def as_mrp(self) -> Array:
        """Return the modified Rodrigues parameters."""
        return self._ours.as_mrp()

    def as_euler(
        self, seq: str, degrees: bool = False, *, suppress_warnings: bool = False
    ) -> Array:
        """Return Euler angles; in gimbal lock the third angle is 0, with a warning."""
        axes, intrinsic = sequence(seq)
        if len(axes) != 3:
            raise RotationError(f"Expected 3 axes, got {seq}.")
        order = "intrinsic" if intrinsic else "extrinsic"
        _, locked = davenport.to_davenport(self._q, np.eye(3)[list(axes)], order, tolerance=_LOCK)
        if not np.any(locked):
            return self._ours.as_euler(seq, degrees)
        return self.as_davenport(
            np.eye(3)[list(axes)], order, degrees, suppress_warnings=suppress_warnings
        )

    def as_davenport(
        self, axes: ArrayLike, order: str, degrees: bool = False, *, suppress_warnings: bool = False
    ) -> Array:
        """Return the angles about three axes; in gimbal lock the third angle is 0, with a warning."""
        unit = _davenport_axes(axes, order)
        angles, locked = davenport.to_davenport(self._q, unit, order, degrees, _LOCK)
        if np.any(locked) and not suppress_warnings:
            warnings.warn(_LOCKED, UserWarning, stacklevel=2)
        return angles

    def magnitude(self) -> Array:
        """Return the angles of rotation."""
        return self._ours.magnitude()

    # The group

    def __mul__(self, other: object) -> Self:
        q = checks.quaternions(other)
        if q is None:
            checks.refuse_factor(self, other)
            return NotImplemented
        checks.common(self.shape, q.shape[:-1])
        return self._of(quaternions.product(self._q, q))

    def __rmul__(self, other: object) -> Self:
        p = checks.quaternions(other)  # of ours or scipy's
        if p is None:
            checks.refuse_factor(self, other)
            return NotImplemented
        return self._of(p) * self

    def __pow__(self, n: npt.ArrayLike, modulus: object = None) -> Self:
        e = checks.exponent(n, modulus)
        if e == 1.0:
            return self._of(self._q.copy())
        return self.inv() if e == -1.0 else self._of((self._ours**e)._q)

    def inv(self) -> Self:
        """Return the inverse rotations."""
        return self._of(quaternions.inverse(self._q))

    def apply(self, vectors: ArrayLike, inverse: bool = False) -> Array:
        """Rotate vectors."""
        v = checks.doubles(vectors, "vectors")
        if not v.ndim or v.shape[-1] != 3:
            raise RotationError(f"Expected input of shape (..., 3), got {v.shape}.")
        checks.common(v.shape[:-1], self.shape)
        return self._ours.apply(v, inverse)

    def approx_equal(
        self, other: Rotation, atol: float | None = None, degrees: bool = False
    ) -> Array:
        """Return whether the angle between the rotations is less than ``atol``, elementwise."""
        q = checks.expected(checks.quaternions(other), other, "other must be a Rotation")
        checks.common(self.shape, q.shape[:-1], "Expected broadcastable shapes")
        if atol is None:
            if degrees:
                warnings.warn(
                    "atol must be set to use the degrees flag, defaulting to 1e-8 radians.",
                    stacklevel=2,
                )
            atol = 1e-8
        elif degrees:
            atol = np.deg2rad(atol)
        return (self._of(q) * self.inv()).magnitude() < atol

    # Many into one

    def mean(self, weights: ArrayLike | None = None, axis: Axes | None = None) -> Self:
        """Return the mean rotation."""
        if not self._q.size:
            raise RotationError("Mean of an empty rotation set is undefined.")
        axes = checks.averaged(axis, len(self.shape))
        return self._of(answers.averaged(self._q, checks.weighted(weights, self.shape), axes))

    @overload
    def reduce(
        self,
        left: Rotation | None = None,
        right: Rotation | None = None,
        return_indices: Literal[False] = False,
    ) -> Self: ...
    @overload
    def reduce(
        self,
        left: Rotation | None = None,
        right: Rotation | None = None,
        *,
        return_indices: Literal[True],
    ) -> tuple[Self, Array | None, Array | None]: ...
    @overload
    def reduce(
        self,
        left: Rotation | None = None,
        right: Rotation | None = None,
        return_indices: bool = False,
    ) -> Self | tuple[Self, Array | None, Array | None]: ...
    def reduce(
        self,
        left: Rotation | None = None,
        right: Rotation | None = None,
        return_indices: bool = False,
    ) -> Self | tuple[Self, Array | None, Array | None]:
        """Return the product of least angle among all products ``l·p·r``."""
        if left is None and right is None:
            reduced = self._of(self._q.copy())
            return (reduced, None, None) if return_indices else reduced
        sides = (self.identity() if side is None else side for side in (left, right))
        words = "left and right must be Rotations"
        p, q = (checks.expected(checks.quaternions(s), s, words).reshape(-1, 4) for s in sides)
        m, n = answers.nearest(self._q, p, q)
        reduced = self._of(quaternions.product(quaternions.product(p[m], self._q), q[n]))
        if not return_indices:
            return reduced
        return reduced, None if left is None else m, None if right is None else n

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
    ) -> tuple[Self, Array, Array | None]: ...
    @overload
    @classmethod
    def align_vectors(
        cls,
        a: ArrayLike,
        b: ArrayLike,
        weights: ArrayLike | None = None,
        return_sensitivity: bool = False,
    ) -> tuple[Self, Array] | tuple[Self, Array, Array | None]: ...
    @classmethod
    def align_vectors(
        cls,
        a: ArrayLike,
        b: ArrayLike,
        weights: ArrayLike | None = None,
        return_sensitivity: bool = False,
    ) -> tuple[Self, Array] | tuple[Self, Array, Array | None]:
        """Return the rotation that brings vectors b closest to vectors a."""
        q, rssd, sensitivity = answers.aligned(a, b, weights, return_sensitivity)
        return (cls._of(q), rssd, sensitivity) if return_sensitivity else (cls._of(q), rssd)

    @staticmethod
    def concatenate(rotations: Iterable[Rotation]) -> Rotation:
        """Join rotations along their first axis."""
        members = [rotations] if checks.quaternions(rotations) is not None else list(rotations)
        words = "input must contain Rotation objects only"
        found = [checks.expected(checks.quaternions(r), r, words) for r in members]
        return Rotation._of(np.concatenate([np.atleast_2d(q) for q in found]))

    # As an array

    @property
    def _array(self) -> Array:
        return self._q

    def __getitem__(self, index: object) -> Self:
        self._expect_many()
        index = index if isinstance(index, tuple) else (index,)
        if Ellipsis not in [i for i in index if i is Ellipsis]:
            index = (*index, Ellipsis)
        return self._of(np.array(self._q[(*index, slice(None))]))

    def __setitem__(self, index: Index, value: object) -> None:
        self._expect_many()
        words = "value must be a Rotation object"
        self._q[index] = checks.expected(checks.quaternions(value), value, words)

    def __repr__(self) -> str:
        matrix = repr(self.as_matrix()).replace("\n", "\n" + " " * len("Rotation.from_matrix("))
        return f"Rotation.from_matrix({matrix})"


def _angles(angles: ArrayLike, number: int) -> Array:
    """Return angles with a last axis of length ``number``; for one axis a single number is also accepted."""
    a = checks.doubles(angles, "angles")
    if number == 1 and a.ndim == 0:
        a = a[..., None]
    if not a.ndim or a.shape[-1] != number:
        raise RotationError(
            f"Expected last dimension of `angles` to match number of sequence axes: "
            f"Expected `angles` to have {number}, got shape {a.shape}."
        )
    return a


def _davenport_axes(axes: ArrayLike, order: str) -> Array:
    if order not in ("e", "extrinsic", "i", "intrinsic"):
        raise RotationError("order should be 'e'/'extrinsic' or 'i'/'intrinsic'")
    try:
        return davenport.checked_axes(checks.doubles(axes, "axes"), order)[0]
    except RotationError as error:
        if "perpendicular" in str(error):
            raise RotationError(f"Consecutive axes must be orthogonal: {error}") from None
        raise
