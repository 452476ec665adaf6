"""Properties that are computed once."""

from __future__ import annotations

import functools
from typing import Any, TypeVar, overload

T = TypeVar("T")


class WithoutCaches:
    """A class whose pickles and copies leave out the values of cached properties.

    For large tables and compiled functions, which are computed again when they are needed.
    """

    __slots__ = ()

    def __getstate__(self) -> dict[str, object]:
        kind = type(self)
        return {
            name: value
            for name, value in vars(self).items()
            if not isinstance(getattr(kind, name, None), functools.cached_property)
        }


class cached_property(functools.cached_property[T]):  # noqa: N801  # it stands for that of functools
    """A cached property without a lock: the first access takes a third of the time of functools's.

    Python takes no lock since 3.12: two threads may compute a value twice.
    """

    @overload
    def __get__(self, instance: None, parent: type[Any] | None = None) -> cached_property[T]: ...
    @overload
    def __get__(self, instance: object, parent: type[Any] | None = None) -> T: ...
    def __get__(self, instance: Any, parent: type[Any] | None = None) -> Any:
        if instance is None:
            return self
        value = instance.__dict__[self.attrname] = self.func(instance)
        return value
