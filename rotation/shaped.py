"""What immutable arrays of rotations and of rigid motions share: shapes, lengths, copies."""

from abc import abstractmethod
from collections.abc import Iterator
from typing import Any, ClassVar, Self

import numpy as np

from rotation.errors import DTypeError
from rotation.namespaces import Array


class Shaped:
    """Holds unit quaternions (…, 4), scalar first, and behaves as an array of shape (…)."""

    __slots__ = ("__weakref__", "_q")
    # numpy must not distribute `array * rotation` over the array's entries.
    __array_ufunc__ = None

    _q: Array
    _called: ClassVar[str]  # what one of them is, for errors

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a {self._called} is immutable: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a {self._called} is immutable: {name} cannot be deleted")

    @property
    def shape(self) -> tuple[int, ...]:
        """The batch shape, ``()`` for a single one."""
        return tuple(self._q.shape[:-1])

    @property
    def ndim(self) -> int:
        """The number of batch axes."""
        return len(self.shape)

    @property
    def size(self) -> int:
        """How many there are."""
        return int(np.prod(self.shape, dtype=np.int64))

    @property
    def single(self) -> bool:
        """Whether this is one and not an array of them."""
        return not self.shape

    def __len__(self) -> int:
        if self.single:
            raise TypeError(f"a single {self._called} has no length")
        return self.shape[0]

    def __bool__(self) -> bool:
        return True

    @abstractmethod
    def __getitem__(self, index: Any) -> Self:
        """Return some of them."""

    def __iter__(self) -> Iterator[Self]:
        return (self[n] for n in range(len(self)))

    def _refuse_factor(self, other: object) -> None:
        """Raise `DTypeError` for points beside ``*``, and for scipy's classes of the same names."""
        if type(other).__module__.startswith("scipy."):
            way = (
                "Rotation.from_scipy(r) or r.to_scipy()"
                if hasattr(self, "from_scipy")
                else f"{type(self).__name__}.from_matrix(t.as_matrix())"
            )
            raise DTypeError(
                f"one {self._called} is scipy's, the other is ours: convert with {way}"
            )
        if isinstance(other, list | tuple) or hasattr(other, "__array__"):
            raise DTypeError(f"a {self._called} is not multiplied by points; write r.apply(points)")

    def __rmul__(self, other: object) -> Any:
        self._refuse_factor(other)
        return NotImplemented

    def __matmul__(self, other: object) -> Any:
        if isinstance(other, Shaped):
            raise DTypeError(
                f"p @ q is not defined for {self._called}s; write p * q, which applies q first"
            )
        raise DTypeError(f"r @ points is not defined for {self._called}s; write r.apply(points)")

    def __rmatmul__(self, other: object) -> Any:
        raise DTypeError(
            f"points @ r is not defined for {self._called}s; write r.apply(points, inverse=True)"
        )

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: Any) -> Self:
        return self
