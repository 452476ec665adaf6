"""`RigidTransform`: one rigid motion of space or an immutable array of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Self

from rotation import hints, pytrees
from rotation import rigid_motions as motions
from rotation.alignment import align_points
from rotation.array_types import Array, ArrayLike, Axes
from rotation.arrays import common_batch
from rotation.averaging import mean_of_vectors
from rotation.coordinates import length, split
from rotation.errors import DTypeError
from rotation.namespaces import (
    floats,
    namespace,
    number,
    points_of,
    quiet,
    spread,
)
from rotation.rigid_forms import Forms
from rotation.rotation import Rotation


@pytrees.register_pytree("_q", "_t", "_matrix")
class RigidTransform(Forms):
    """Rigid motions ``v ↦ R·v + t``: a `Rotation` and translations (…, 3) with the same batch shape.

    Method names are those of scipy; conventions are those of `Rotation`: ``p * q`` applies q first, and dual
    quaternions are scalar first. Rows that contain NaN or inf become NaN; other rows are not affected.

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

    __slots__ = ()
    foreign_names = hints.TRANSFORM

    def __new__(cls, matrix: ArrayLike) -> Self:
        """Make transforms from matrices, as `from_matrix` does."""
        return cls.from_matrix(matrix)

    # The group

    def __mul__(self, other: object) -> Self:
        """Return the products, which apply ``other`` first; a Rotation counts as a motion without
        translation.
        """
        if isinstance(other, Rotation):
            other = self.from_rotation(other)
        if not isinstance(other, RigidTransform):
            self._refuse_factor(other)
            return NotImplemented
        common_batch(left=self.shape, right=other.shape)
        return self._of_rows(motions.COMPOSED(self._q, self._t, other._q, other._t))

    def __rmul__(self, other: object) -> Self:
        if isinstance(other, Rotation):
            return self.from_rotation(other) * self
        self._refuse_factor(other)
        return NotImplemented

    @quiet
    def __pow__(self, exponent: ArrayLike) -> Self:
        """Return the motion along the same screw, ``exponent`` times as far; the shapes broadcast.

        Raises
        ------
        RotationError
            A whole number beyond the largest float, or shapes that do not fit.
        """
        if isinstance(exponent, int | float):
            return self.from_exp_coords(self.as_exp_coords() * number(exponent, "exponent"))
        exponents = floats(exponent, "exponent", namespace(self._q, exponent))
        common_batch(transforms=self.shape, exponents=tuple(exponents.shape))
        return self.from_exp_coords(self.as_exp_coords() * exponents[..., None])

    def inverse(self) -> Self:
        """Return the inverse motions."""
        return self._of_rows(motions.INVERTED(self._q, self._t))

    inv = inverse  # as scipy calls it

    def apply(self, points: ArrayLike, inverse: bool = False) -> Array:
        """Apply the motion, or its inverse, to points (…, 3): ``R·v + t``; the batch shapes broadcast.

        float32 and float64 are kept, integers become float64. All computations are in double precision.

        Raises
        ------
        RotationError
            Shapes that do not fit.
        """
        xp = namespace(self._q, points)
        given = points_of(points, xp)
        common_batch(points=tuple(given.shape[:-1]), transforms=self.shape)
        v = floats(given, "points", xp)
        moved = (motions.MOVED_BACK if inverse else motions.MOVED)(self._q, self._t, v)
        return moved if moved.dtype == given.dtype else xp.astype(moved, given.dtype)

    def __eq__(self, other: object) -> Array:  # type: ignore[override]  # entry by entry
        """Compare entry by entry, exactly: q and −q are the same rotation."""
        if not isinstance(other, RigidTransform):
            return NotImplemented
        same = namespace(self._t, other._t).all(self._t == other._t, axis=-1)
        return (Rotation._of(self._q) == Rotation._of(other._q)) & same

    def __hash__(self) -> int:
        if not self.single:
            raise TypeError("a batch of transforms is compared entry by entry and has no hash")
        return hash((self.rotation, tuple(float(c) + 0.0 for c in self._t)))

    @quiet
    def approx_equal(self, other: RigidTransform, atol: float = 1e-8) -> Array:
        """Return whether angle (in radians) and distance between the motions are at most ``atol``,
        elementwise.
        """
        expect_transforms(other=other)
        between = self.inv() * other
        near = length(namespace(between._t), split(between._t)) <= atol
        return near & (between.rotation.magnitude() <= atol)

    # Many into one

    @classmethod
    def concatenate(cls, transforms: RigidTransform | Iterable[RigidTransform]) -> Self:
        """Join transforms along their first axis; a single transform counts as a batch of one.

        Raises
        ------
        RotationError
            There are no arrays, or their other axes differ.
        DTypeError
            One of them is not a RigidTransform.
        """
        if not isinstance(transforms, RigidTransform | Iterable):
            raise DTypeError(f"concatenate takes transforms, not {hints.described(transforms)}")
        members = [transforms] if isinstance(transforms, RigidTransform) else list(transforms)
        for n, member in enumerate(members):
            expect_transforms(**{f"number {n}": member})
        turns = Rotation.concatenate([m.rotation for m in members])
        xp = namespace(turns._q)
        return cls._of(
            turns._q, xp.concat([m._t[None, :] if m.single else m._t for m in members], axis=0)
        )

    def mean(self, weights: ArrayLike | None = None, axis: Axes | None = None) -> Self:
        """Return the mean of the rotations with the mean of the translations; see `Rotation.mean`."""
        turn = self.rotation.mean(weights, axis)
        xp = namespace(self._t, weights)
        axes = tuple(range(self.ndim)) if axis is None else axis
        w = xp.ones_like(self._t[..., 0])
        if weights is not None:
            w = spread(xp, floats(weights, "weights", xp), self.shape, "weights")
        axes = tuple(a - 1 if a < 0 else a for a in ((axes,) if isinstance(axes, int) else axes))
        return self._of(turn._q, mean_of_vectors(self._t, w, axes) if axes else self._t)

    @classmethod
    def align(
        cls, source: ArrayLike, target: ArrayLike, weights: ArrayLike | None = None
    ) -> tuple[Self, Array]:
        """Return the motion that brings points closest to others, and the residual; see `align_points`."""
        turn, shift, rssd = align_points(source, target, weights)
        return cls._of(turn._q, shift), rssd

    # As an array

    def __getitem__(self, index: object) -> Self:
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
        from rotation.html_table import table

        return table(self._q, self._t)

    def __reduce__(self) -> tuple[object, ...]:
        return type(self)._of, (self._q, self._t)


def expect_transforms(**named: object) -> None:
    """Raise `DTypeError` unless all values are rigid transforms, rather than matrices."""
    for name, value in named.items():
        if not isinstance(value, RigidTransform):
            raise DTypeError(hints.refusal(value, name, "RigidTransform"))


def sclerp(p: RigidTransform, q: RigidTransform, t: ArrayLike) -> RigidTransform:
    """Return the motion at ``t`` on the path from ``p`` (t = 0) to ``q`` (t = 1) along one screw.

    It is ``p·(p⁻¹·q)ᵗ``, with constant velocity, on the shorter path. The shapes of p, q and t broadcast. L.
    Kavan et al., "Dual quaternions for rigid transformation blending" (2006), screw linear interpolation.

    Examples
    --------
    >>> move = RigidTransform.from_translation([2, 0, 0])
    >>> sclerp(RigidTransform.identity(), move, 0.5).translation
    array([1., 0., 0.])
    """
    expect_transforms(p=p, q=q)
    path: RigidTransform = p * (p.inv() * q) ** t
    return path
