"""`RigidTransform` with the names, conventions and behaviour of scipy's; it stores matrices."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Self

import numpy as np
import numpy.typing as npt

from rotation import rigid
from rotation import rotation as ours
from rotation.array_types import Array, ArrayLike, Axes, Index
from rotation.averaging import mean_of_vectors
from rotation.compat import answers, checks
from rotation.compat.assignable import Assignable
from rotation.compat.rotations import Rotation
from rotation.errors import RotationError
from rotation.namespaces import quiet


class RigidTransform(Assignable):
    """One rigid motion or an array of them; items can be assigned."""

    _axes, _called = 2, "transform"

    def __init__(self, matrix: ArrayLike, normalize: bool = True, copy: bool = True) -> None:
        m = checks.numbers(matrix, "matrix", "(..., 4, 4)", (4, 4))
        wrong = np.any(m[..., 3, :] != [0.0, 0.0, 0.0, 1.0], axis=-1)
        if np.any(wrong):
            row = tuple(int(i) for i in np.argwhere(wrong)[0])
            raise RotationError(
                f"Expected last row of transformation matrix {row} to be exactly [0, 0, 0, 1], "
                f"got {m[(*row, 3)]}"
            )
        self._matrix = np.array(m) if normalize or copy else m
        if normalize:
            self._matrix[..., :3, :3] = Rotation.from_matrix(m[..., :3, :3]).as_matrix()

    @classmethod
    def _of(cls, m: Array) -> Self:
        self = object.__new__(cls)
        self._matrix = m if m.flags.writeable else m.copy()
        return self

    @classmethod
    def _from_ours(cls, transform: rigid.RigidTransform) -> Self:
        return cls._of(transform.as_matrix())

    @property
    def _ours(self) -> rigid.RigidTransform:
        return rigid.RigidTransform._of(self.rotation._q.copy(), self.translation)

    # Making

    @classmethod
    def from_matrix(cls, matrix: ArrayLike) -> Self:
        """Make transforms from homogeneous matrices."""
        return cls(matrix)

    @classmethod
    def from_rotation(cls, rotation: Rotation) -> Self:
        """Make transforms that rotate without translating."""
        words = "Expected `rotation` to be a `Rotation` instance"
        q = checks.expected(checks.quaternions(rotation), rotation, words)
        return cls._from_ours(rigid.RigidTransform.from_rotation(ours.Rotation._of(q.copy())))

    @classmethod
    def from_translation(cls, translation: ArrayLike) -> Self:
        """Make transforms that translate without rotating."""
        t = checks.numbers(translation, "translation", "(..., 3)", (3,))
        return cls._from_ours(rigid.RigidTransform.from_translation(t))

    @classmethod
    def from_components(cls, translation: ArrayLike, rotation: Rotation) -> Self:
        """Make transforms that rotate first, then translate."""
        return cls.from_translation(translation) * cls.from_rotation(rotation)

    @classmethod
    def from_exp_coords(cls, exp_coords: ArrayLike) -> Self:
        """Make transforms from exponential coordinates."""
        x = checks.numbers(exp_coords, "exp_coords", "(..., 6)", (6,))
        return cls._from_ours(rigid.RigidTransform.from_exp_coords(x))

    @classmethod
    def from_dual_quat(cls, dual_quat: ArrayLike, *, scalar_first: bool = False) -> Self:
        """Make transforms from dual quaternions; a zero real part counts as the identity rotation."""
        d = checks.numbers(dual_quat, "dual_quat", "(..., 8)", (8,)).copy()
        nothing = ~d[..., :4].any(axis=-1)
        d[..., 0 if scalar_first else 3][nothing] = 1.0
        made = rigid.RigidTransform.from_dual_quat(d, scalar_first=scalar_first)
        return cls._from_ours(made)

    @staticmethod
    def identity(
        num: int | None = None, *, shape: int | Sequence[int] | None = None
    ) -> RigidTransform:
        """Return the identity, or a batch of it."""
        if num is not None and shape is not None:
            raise RotationError("Only one of `num` and `shape` can be specified.")
        return RigidTransform._from_ours(rigid.RigidTransform.identity(checks.batch(num, shape)))

    @staticmethod
    def concatenate(transforms: Iterable[RigidTransform]) -> RigidTransform:
        """Join transforms along their first axis."""
        members = [transforms] if checks.matrices(transforms) is not None else list(transforms)
        words = "input must contain RigidTransform objects only"
        found = [checks.expected(checks.matrices(t), t, words) for t in members]
        return RigidTransform._of(np.concatenate([m[None] if m.ndim == 2 else m for m in found]))

    # Reading

    @property
    def rotation(self) -> Rotation:
        """The rotations."""
        return Rotation.from_matrix(self._matrix[..., :3, :3])

    @property
    def translation(self) -> Array:
        """The translations."""
        return np.array(self._matrix[..., :3, 3])

    def as_matrix(self) -> Array:
        """Return the homogeneous matrices."""
        return np.array(self._matrix)

    def as_components(self) -> tuple[Array, Rotation]:
        """Return the translations and the rotations."""
        return self.translation, self.rotation

    def as_exp_coords(self) -> Array:
        """Return the exponential coordinates."""
        return self._ours.as_exp_coords()

    def as_dual_quat(self, *, scalar_first: bool = False) -> Array:
        """Return the unit dual quaternions."""
        return self._ours.as_dual_quat(scalar_first=scalar_first)

    # The group

    @quiet
    def __mul__(self, other: object) -> Self:
        m = checks.motions(other)
        if m is None:
            checks.refuse_factor(self, other)
            return NotImplemented
        checks.common(self.shape, m.shape[:-2])
        product = np.matmul(self._matrix, m)
        product[..., 3, :] = [0.0, 0.0, 0.0, 1.0]
        return self._of(product)

    def __rmul__(self, other: object) -> Self:
        m = checks.motions(other)  # of ours or scipy's
        if m is None:
            checks.refuse_factor(self, other)
            return NotImplemented
        return self._of(m) * self

    def __pow__(self, n: npt.ArrayLike, modulus: object = None) -> Self:
        e = checks.exponent(n, modulus)
        if e in (1.0, -1.0):
            return self._of(self._matrix.copy()) if e > 0.0 else self.inv()
        return self._from_ours(self._ours**e)

    @quiet
    def inv(self) -> Self:
        """Return the inverse motions."""
        back = np.zeros_like(self._matrix)
        turn = np.swapaxes(self._matrix[..., :3, :3], -1, -2)
        back[..., :3, :3], back[..., 3, 3] = turn, 1.0
        back[..., :3, 3] = -np.matmul(turn, self._matrix[..., :3, 3, None])[..., 0]
        return self._of(back)

    @quiet
    def apply(self, vector: ArrayLike, inverse: bool = False) -> Array:
        """Move vectors."""
        v = checks.doubles(vector, "vector")
        if not v.ndim or v.shape[-1] != 3:
            raise RotationError(f"Expected vector to have shape (..., 3), got {v.shape}.")
        checks.common(v.shape[:-1], self.shape, "operands could not be broadcast together")
        m = self.inv()._matrix if inverse else self._matrix
        moved: Array = np.matmul(m[..., :3, :3], v[..., None])[..., 0] + m[..., :3, 3]
        return moved

    def mean(self, weights: ArrayLike | None = None, axis: Axes | None = None) -> Self:
        """Return the mean of the rotations with the mean of the translations."""
        if not self._matrix.size:
            raise RotationError("Mean of an empty rotation set is undefined.")
        axes = checks.averaged(axis, len(self.shape))
        w = checks.weighted(weights, self.shape)
        if w is not None and w.shape != self.shape:
            raise RotationError(f"Expected `weights` to have shape {self.shape}, got {w.shape}.")
        turn = answers.averaged(self.rotation._q, w, axes)
        share = np.ones(self.shape) if w is None else np.broadcast_to(w, self.shape)
        shift = mean_of_vectors(self._matrix[..., :3, 3], share, axes)
        return self._from_ours(rigid.RigidTransform._of(turn, shift))

    # As an array

    @property
    def _array(self) -> Array:
        return self._matrix

    def __getitem__(self, index: Any) -> Self:
        self._expect_many()
        return self._of(np.array(self._matrix[index]))

    def __setitem__(self, index: Index, value: object) -> None:
        self._expect_many()
        words = "value must be a RigidTransform object"
        self._matrix[index] = checks.expected(checks.matrices(value), value, words)

    def __repr__(self) -> str:
        matrix = repr(self._matrix).replace("\n", "\n" + " " * len("RigidTransform.from_matrix("))
        return f"RigidTransform.from_matrix({matrix})"
