"""`RigidTransform`: one rigid motion of space or a whole array of them, immutable."""

from collections.abc import Iterable, Sequence
from typing import Any, Self

import numpy as np

from rotation import rigid_motions as motions
from rotation import sampling, vectors
from rotation.alignment import align_points
from rotation.arrays import common_batch
from rotation.batch import expect_rotations
from rotation.errors import DTypeError, RotationError
from rotation.matrices import from_matrix
from rotation.namespaces import Array, copied, expect_last, floats, is_numpy, namespace, spread
from rotation.rotation import Rotation
from rotation.screws import Screw, from_screw, to_screw
from rotation.shaped import Shaped

HELD = 16_384  # transforms whose matrices, once computed, are held: 2 MB


class RigidTransform(Shaped):
    """Rigid motions ``v ↦ R·v + t``: a `Rotation` and translations (…, 3), of one batch shape.

    Method names are those of scipy; conventions are those of `Rotation`: ``p * q`` applies q first, dual
    quaternions have the scalar first. Rows with NaN or inf are NaN, and no other row is.

    Parameters
    ----------
    matrix : array_like, shape (…, 4, 4)
        As in `from_matrix`.

    Examples
    --------
    >>> turn = Rotation.from_euler("Z", 90, degrees=True)
    >>> move = RigidTransform.from_components([1, 0, 0], turn)
    >>> move.apply([1, 0, 0]).round(12)
    array([1., 1., 0.])
    >>> (move * move.inv()).translation.round(12) + 0.0
    array([0., 0., 0.])
    """

    __slots__ = ("_matrix", "_t")

    _t: Array
    _matrix: Array | None  # when it was asked for, of not too many
    _called = "transform"

    def __new__(cls, matrix: Any) -> Self:
        """Make transforms from matrices, as `from_matrix` does."""
        return cls.from_matrix(matrix)

    @classmethod
    def _of(cls, q: Array, t: Array) -> Self:
        """Wrap unit quaternions and translations that nobody else writes to, of shapes that broadcast."""
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
        return self

    @classmethod
    def _of_rows(cls, rows: Array) -> Self:
        return cls._of(rows[..., :4], rows[..., 4:])

    # Making

    @classmethod
    def identity(cls, shape: int | Sequence[int] | None = None) -> Self:
        """Return the motion that moves nothing, or a batch of it: ``shape`` is a number or a tuple."""
        batch = sampling.as_shape(shape)
        return cls._of(Rotation.identity(batch)._q, np.zeros((*batch, 3)))

    @classmethod
    def from_matrix(cls, matrix: Any, *, orthonormalize: bool = False) -> Self:
        """Make transforms from homogeneous matrices (…, 4, 4), whose last row is 0, 0, 0, 1.

        Raises
        ------
        RotationError
            Another last row, or the upper left 3 × 3 block is no rotation; see `Rotation.from_matrix`.
        """
        m = floats(matrix, "matrices")
        motions.expect_affine(m)
        q = from_matrix(m[..., :3, :3], orthonormalize)
        return cls._of(q, copied(m[..., :3, 3]))

    @classmethod
    def from_rotation(cls, rotation: Rotation) -> Self:
        """Make transforms that turn and do not shift."""
        expect_rotations(rotation=rotation)
        return cls._of(rotation._q, 0.0 * rotation._q[..., 1:])

    @classmethod
    def from_translation(cls, translation: Any) -> Self:
        """Make transforms that shift by ``translation`` (…, 3) and do not turn."""
        t = _copied(translation, "translations")
        xp = namespace(t)
        one, zero = xp.ones_like(t[..., :1]), xp.zeros_like(t)
        return cls._of(xp.concat([one, zero], axis=-1), t)

    @classmethod
    def from_components(cls, translation: Any, rotation: Rotation) -> Self:
        """Make transforms that turn first, then shift; the batch shapes broadcast."""
        expect_rotations(rotation=rotation)
        t = _copied(translation, "translations")
        common_batch(translation=tuple(t.shape[:-1]), rotation=rotation.shape)
        return cls._of(rotation._q, t)

    @classmethod
    def from_exp_coords(cls, exp_coords: Any) -> Self:
        """Make transforms from exponential coordinates (…, 6): a rotation vector, then ``J⁻¹·t``."""
        x = _copied(exp_coords, "exponential coordinates", 6)
        v, u = x[..., :3], x[..., 3:]
        return cls._of(vectors.from_rotvec(v), motions.SWEPT(v, u))

    @classmethod
    def from_dual_quat(cls, dual_quat: Any, *, scalar_first: bool = True) -> Self:
        """Make transforms from dual quaternions (…, 8): ``q``, then ``½·t·q``; they are made unit.

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
        return cls._of(*motions.from_dual(d))

    @classmethod
    def from_screw(
        cls, axis: Any, point: Any, angle: Any, displacement: Any, degrees: bool = False
    ) -> Self:
        """Make the motions along screws: a turn about a line and a shift along it.

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
        return cls._of(*from_screw(axis, point, angle, displacement, degrees))

    # Reading

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
        if self._matrix is not None:
            return self._matrix.copy()
        m = motions.MATRIX(self._q, self._t)
        if type(m) is np.ndarray and m.size <= 16 * HELD:
            object.__setattr__(self, "_matrix", m)
            return m.copy()
        return m

    def as_exp_coords(self) -> Array:
        """Return the exponential coordinates, shape (…, 6), of angles in [0, π]."""
        v = vectors.to_rotvec(self._q)
        return namespace(v).concat([v, motions.UNSWEPT(v, self._t)], axis=-1)

    def as_dual_quat(self, *, scalar_first: bool = True) -> Array:
        """Return the unit dual quaternions, shape (…, 8): ``q``, then ``½·t·q``."""
        d = motions.DUAL(self._q, self._t)
        xp = namespace(d)
        if scalar_first:
            return d
        return xp.concat(
            [xp.roll(d[..., :4], -1, axis=-1), xp.roll(d[..., 4:], -1, axis=-1)], axis=-1
        )

    def as_screw(self, degrees: bool = False) -> Screw:
        """Return the screws of the motions: every rigid motion is along one (Chasles)."""
        return to_screw(self._q, self._t, degrees)

    # The group

    def __mul__(self, other: object) -> Self:
        if not isinstance(other, RigidTransform):
            if isinstance(other, Rotation):
                raise DTypeError(
                    "a Rotation beside a RigidTransform; write RigidTransform.from_rotation(r)"
                )
            return NotImplemented
        common_batch(left=self.shape, right=other.shape)
        return self._of_rows(motions.COMPOSED(self._q, self._t, other._q, other._t))

    def __rmul__(self, other: object) -> Any:
        if isinstance(other, Rotation):
            return self * other  # which refuses it
        return NotImplemented

    def __pow__(self, exponent: Any) -> Self:
        """Return the motion along the same screw, ``exponent`` times as far; the shapes broadcast."""
        if not isinstance(exponent, int | float):
            exponent = floats(exponent, "exponent", namespace(self._q, exponent))
            common_batch(transforms=self.shape, exponents=tuple(exponent.shape))
            exponent = exponent[..., None]
        return self.from_exp_coords(self.as_exp_coords() * exponent)

    def inverse(self) -> Self:
        """Return the inverse motions."""
        return self._of_rows(motions.INVERTED(self._q, self._t))

    inv = inverse  # as scipy calls it

    def apply(self, points: Any, inverse: bool = False) -> Array:
        """Move points (…, 3): ``R·v + t``, or back again; the batch shapes broadcast.

        Raises
        ------
        RotationError
            Shapes that do not fit.
        """
        v = floats(points, "points", namespace(self._q, points))
        expect_last(v, (3,), "points")
        common_batch(points=tuple(v.shape[:-1]), transforms=self.shape)
        return (motions.MOVED_BACK if inverse else motions.MOVED)(self._q, self._t, v)

    def __eq__(self, other: object) -> Any:
        """Compare entry by entry, exactly: q and −q are the same rotation."""
        if not isinstance(other, RigidTransform):
            return NotImplemented
        same = namespace(self._t, other._t).all(self._t == other._t, axis=-1)
        return (Rotation._of(self._q) == Rotation._of(other._q)) & same

    def __hash__(self) -> int:
        if not self.single:
            raise TypeError("a batch of transforms is compared entry by entry and has no hash")
        return hash((self.rotation, tuple(float(c) + 0.0 for c in self._t)))

    def approx_equal(self, other: "RigidTransform", atol: float = 1e-8) -> Any:
        """Return where the angle (radians) and the distance from one to the other are at most ``atol``."""
        between = self.inv() * other
        xp = namespace(between._t)
        near = xp.sqrt(xp.sum(between._t**2, axis=-1)) <= atol
        return near & (between.rotation.magnitude() <= atol)

    # Many into one

    @classmethod
    def concatenate(cls, transforms: Any) -> Self:
        """Join transforms along their first axis; a single one counts as a batch of one.

        Raises
        ------
        RotationError
            There are none, or their other axes differ.
        DTypeError
            Something among them is no RigidTransform.
        """
        if not isinstance(transforms, RigidTransform | Iterable):
            raise DTypeError(f"concatenate takes transforms, not a {type(transforms).__name__}")
        members = [transforms] if isinstance(transforms, RigidTransform) else list(transforms)
        for n, member in enumerate(members):
            if not isinstance(member, RigidTransform):
                raise DTypeError(
                    f"concatenate takes transforms; number {n} is a {type(member).__name__}"
                )
        turns = Rotation.concatenate([m.rotation for m in members])
        xp = namespace(turns._q)
        return cls._of(
            turns._q, xp.concat([m._t[None, :] if m.single else m._t for m in members], axis=0)
        )

    def mean(self, weights: Any = None, axis: Any = None) -> Self:
        """Return the mean of the rotations with the mean of the translations; see `Rotation.mean`."""
        turn = self.rotation.mean(weights, axis)
        xp = namespace(self._t, weights)
        axes = tuple(range(self.ndim)) if axis is None else axis
        w = xp.ones_like(self._t[..., 0])
        if weights is not None:
            w = spread(xp, floats(weights, "weights", xp), self.shape, "weights")
        w = w[..., None]
        axes = tuple(a - 1 if a < 0 else a for a in ((axes,) if isinstance(axes, int) else axes))
        if not axes:
            return self._of(turn._q, self._t)
        return self._of(turn._q, xp.sum(w * self._t, axis=axes) / xp.sum(w, axis=axes))

    @classmethod
    def align(cls, source: Any, target: Any, weights: Any = None) -> tuple[Self, Array]:
        """Return the motion that takes points closest to others, and how close; see `align_points`."""
        turn, shift, rssd = align_points(source, target, weights)
        return cls._of(turn._q, shift), rssd

    # As an array

    def __getitem__(self, index: Any) -> Self:
        if self.single:
            raise TypeError("a single transform cannot be indexed")
        turns = Rotation._of(self._q)[index]
        index = index if isinstance(index, tuple) else (index,)
        if not any(i is Ellipsis for i in index) and not hasattr(index[0], "dtype"):
            index = (*index, Ellipsis)
        if any(i is Ellipsis for i in index):
            index = (*index, slice(None))
        return self._of(turns._q, self._t[index])

    def __repr__(self) -> str:
        return f"RigidTransform.from_components({self._t!r}, {Rotation._of(self._q)!r})"

    def _repr_html_(self) -> str | None:
        from rotation.shown import table

        return table(self._q, self._t)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._of, (self._q, self._t)


def sclerp(p: RigidTransform, q: RigidTransform, t: Any) -> RigidTransform:
    """Return the motion at ``t`` on the way from ``p`` (t = 0) to ``q`` (t = 1), along one screw.

    At constant rate: ``p·(p⁻¹·q)ᵗ``, the shorter way round. The shapes of p, q and t broadcast. L. Kavan et
    al., "Dual quaternions for rigid transformation blending" (2006), screw linear interpolation.

    Examples
    --------
    >>> move = RigidTransform.from_translation([2, 0, 0])
    >>> sclerp(RigidTransform.identity(), move, 0.5).translation
    array([1., 0., 0.])
    """
    for name, value in (("p", p), ("q", q)):
        if not isinstance(value, RigidTransform):
            raise DTypeError(f"{name} is a {type(value).__name__}; expected a RigidTransform")
    path: RigidTransform = p * (p.inv() * q) ** t
    return path


def _copied(value: Any, what: str, length: int = 3) -> Array:
    array = floats(value, what)
    if not array.ndim:
        raise RotationError(f"{what} has shape (); expected (…, {length})")
    expect_last(array, (length,), what)
    return copied(array)
