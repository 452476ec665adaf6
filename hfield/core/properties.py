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
        kind, state = type(self), vars(self).copy()  # another thread may compute a value meanwhile
        return {
            name: value
            for name, value in state.items()
            if not isinstance(getattr(kind, name, None), functools.cached_property)
        }


class cached_property(functools.cached_property[T]):  # noqa: N801  # it stands for that of functools
    """A cached property without a lock; its first access takes a third of the time of functools's.

    Python takes no lock since 3.12: two threads may compute a value twice. ``super().x`` computes the value
    of the base class each time: the cache belongs to the attribute of the object's own class. Raises
    TypeError where the property has no name.
    """

    @overload
    def __get__(self, instance: None, parent: type[object] | None = None) -> cached_property[T]: ...
    @overload
    def __get__(self, instance: object, parent: type[object] | None = None) -> T: ...
    def __get__(self, instance: Any, parent: type[object] | None = None) -> cached_property[T] | T:
        if instance is None:
            return self
        name = self.attrname
        if name is None:
            raise TypeError(
                "a cached_property that is set on a finished class has no name: define it in the body of the "
                "class, or call its __set_name__(cls, name)"
            )
        value = self.func(instance)
        if getattr(type(instance), name, None) is self:  # else it was called by super()
            instance.__dict__[name] = value
        return value
