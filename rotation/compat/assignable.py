"""Array methods shared by scipy's rotations and transforms: lengths, and item assignment."""

from abc import abstractmethod
from collections.abc import Iterator
from typing import ClassVar, Self

from rotation.array_types import Array


class Assignable:
    """One rotation or transform, or an array of them, each stored in ``_axes`` axes of an array."""

    __array_ufunc__ = None

    _axes: ClassVar[int]
    _called: ClassVar[str]  # the name of a single object, for error messages

    @property
    @abstractmethod
    def _array(self) -> Array:
        """The array in which they are stored."""

    @classmethod
    @abstractmethod
    def _of(cls, array: Array) -> Self:
        """Return the object stored in an array."""

    @property
    def single(self) -> bool:
        """Whether this is a single rotation or transform rather than an array."""
        return not self.shape

    @property
    def shape(self) -> tuple[int, ...]:
        """The batch shape."""
        shape: tuple[int, ...] = self._array.shape[: -self._axes]
        return shape

    def __len__(self) -> int:
        if self.single:
            raise TypeError(f"Single {self._called} has no len().")
        return len(self._array)

    def __bool__(self) -> bool:
        return True

    def _expect_many(self) -> None:
        if self.single:
            raise TypeError(f"Single {self._called} is not subscriptable.")

    @abstractmethod
    def __getitem__(self, index: object) -> Self:
        """Return the elements at an index."""

    def __iter__(self) -> Iterator[Self]:
        return (self[n] for n in range(len(self)))

    def __reduce__(self) -> tuple[object, ...]:
        return type(self)._of, (self._array.copy(),)
