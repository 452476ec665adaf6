"""The base class of immutable arrays of rotations and rigid motions: shapes, lengths, copies."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator
from typing import ClassVar, NoReturn, Self

import numpy as np

from hfield.hints import Hinted
from rotation import hints
from rotation.array_types import Array, ArrayLike
from rotation.errors import DTypeError, RotationError


class ImmutableArray(Hinted):
    """An immutable array of shape (…), stored as unit quaternions (…, 4), scalar first."""

    __slots__ = ("__weakref__", "_q")
    # numpy must not distribute `array * rotation` over the array's entries.
    __array_ufunc__ = None

    _q: Array
    _called: ClassVar[str]  # the name of a single object, for error messages

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a {self._called} is immutable: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a {self._called} is immutable: {name} cannot be deleted")

    @property
    def shape(self) -> tuple[int, ...]:
        """The batch shape, ``()`` for a single element."""
        return tuple(self._q.shape[:-1])

    @property
    def ndim(self) -> int:
        """The number of batch axes."""
        return len(self.shape)

    @property
    def size(self) -> int:
        """The number of elements."""
        return int(np.prod(self.shape, dtype=np.int64))

    @property
    def single(self) -> bool:
        """Whether this is a single element rather than an array."""
        return not self.shape

    def __len__(self) -> int:
        if self.single:
            raise TypeError(f"a single {self._called} has no length")
        return self.shape[0]

    def __bool__(self) -> bool:
        return True

    @abstractmethod
    def __getitem__(self, index: object) -> Self:
        """Return the elements at an index."""

    @abstractmethod
    def __mul__(self, other: object) -> Self:
        """Return the products; ``other`` is applied first."""

    @abstractmethod
    def inverse(self) -> Self:
        """Return the inverses."""

    @classmethod
    @abstractmethod
    def exp(cls, tangent: ArrayLike) -> Self:
        """Return the exponentials of tangents."""

    @abstractmethod
    def log(self) -> Array:
        """Return the logarithms: the tangents whose exponentials are these rotations or motions."""

    @abstractmethod
    def adjoint(self) -> Array:
        """Return the matrices Ad with ``p·exp(x)·p⁻¹ = exp(Ad·x)``."""

    def plus(self, tangent: ArrayLike, side: str = "right") -> Self:
        """Return the elements reached along a tangent: ``p·exp(x)``, or on the left ``exp(x)·p``.

        Parameters
        ----------
        tangent : array_like, shape (…, 3) for rotations, (…, 6) for rigid motions
            A rotation vector, in radians, or exponential coordinates; the batch shapes broadcast.
        side : "right" or "left"
            A right tangent is in body axes, a left tangent in world axes.

        Raises
        ------
        RotationError
            Another side, or shapes that do not fit.
        """
        step = self.exp(tangent)
        return self * step if on_the_right(side) else step * self

    def minus(self, other: ImmutableArray, side: str = "right") -> Array:
        """Return the tangents from another element to this one: ``other.plus(x, side) == self``.

        The result is ``log(other⁻¹·self)``, or on the left ``log(self·other⁻¹)``; see `plus`.

        Raises
        ------
        RotationError
            Another side, or shapes that do not fit.
        DTypeError
            The other is of another kind.
        """
        if not isinstance(other, ImmutableArray) or other._called != self._called:
            own = "Rotation" if self._called == "rotation" else "RigidTransform"
            raise DTypeError(hints.refusal(other, "other", own))
        back = other.inverse()
        return (back * self if on_the_right(side) else self * back).log()

    def __iter__(self) -> Iterator[Self]:
        return (self[n] for n in range(len(self)))

    def _refuse_factor(self, other: object) -> None:
        """Raise `DTypeError`, with advice, unless the other factor may implement the product itself."""
        found = hints.kind(other)
        if found is not None:
            own = "Rotation" if self._called == "rotation" else "RigidTransform"
            if found == (hints.COMPAT, own) or (
                found.name == "RigidTransform" and found.home in (hints.COMPAT, hints.OURS)
            ):
                return  # the other class accepts ours, or reports an error about ours
            wanted = max(own, found.name, key=hints.NAMES.index)
            raise DTypeError(hints.refusal(other, "the other factor", wanted))
        if isinstance(other, list | tuple) or hasattr(other, "__array__"):
            raise DTypeError(f"a {self._called} is not multiplied by points; write r.apply(points)")
        if isinstance(other, int | float):
            raise DTypeError(f"a {self._called} is not multiplied by numbers; write r**n")

    def __rmul__(self, other: object) -> Self:
        self._refuse_factor(other)
        return NotImplemented

    def __matmul__(self, other: object) -> NoReturn:
        if hints.kind(other) is not None:
            self._undefined("p @ q", "p * q, which applies q first")
        self._undefined("r @ points", "r.apply(points)")

    def __rmatmul__(self, other: object) -> NoReturn:
        if hints.kind(other) is not None:
            self._undefined("p @ q", "p * q, which applies q first")
        self._undefined("points @ r", "r.apply(points, inverse=True)")

    def __truediv__(self, other: object) -> NoReturn:
        self._undefined("p / q", "p * q.inv()")

    def __rtruediv__(self, other: object) -> NoReturn:
        self._undefined("1 / r", "r.inv()")

    def __add__(self, other: object) -> NoReturn:
        self._undefined("p + q", "p * q, which applies q first")

    __radd__ = __add__

    def __sub__(self, other: object) -> NoReturn:
        self._undefined("q - p", "p.inv() * q, which leads from p to q")

    __rsub__ = __sub__

    def __invert__(self) -> NoReturn:
        self._undefined("~r", "r.inv()")

    def __neg__(self) -> NoReturn:
        self._undefined("-r", "r.inv()")

    def __abs__(self) -> NoReturn:
        self._undefined("abs(r)", "r.magnitude() for the angle")

    def _undefined(self, form: str, advice: str) -> NoReturn:
        raise DTypeError(f"{form} is not defined for {self._called}s; write {advice}")

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: object) -> Self:
        return self


def on_the_right(side: str) -> bool:
    """Return whether the side is "right". Raises `RotationError` for an invalid side."""
    if side not in ("left", "right"):
        raise RotationError(f'side {side!r}: "left" or "right" is expected')
    return side == "right"
