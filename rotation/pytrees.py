"""Rotations, motions and curves as containers of arrays, for the transformations of JAX and torch.

`jit`, `vmap`, `grad` and `scan` take pytrees apart into arrays and reassemble them. A class is registered
with each library that has been imported, when the next value is made; nothing is imported here.
"""

import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from importlib import import_module
from typing import TypeVar

_modules = sys.modules
_Class = TypeVar("_Class", bound=type)
_Value = TypeVar("_Value")
_Kind = tuple[type, tuple[str, ...]]
_kinds: list[_Kind] = []
_for_jax: list[_Kind] = []  # not yet registered with it
_for_torch: list[_Kind] = []
number_of_modules = 0  # when the libraries were last looked for


def register_pytree(*names: str) -> Callable[[_Class], _Class]:
    """Register a class as a pytree of these attributes: arrays, containers of such, or None."""

    def register(kind: _Class) -> _Class:
        global number_of_modules
        number_of_modules = 0
        for kinds in (_kinds, _for_jax, _for_torch):
            kinds.append((kind, names))
        return kind

    return register


def known(value: _Value) -> _Value:
    """Register the classes as pytrees with the imported libraries; return the value."""
    global number_of_modules
    if len(_modules) != number_of_modules:
        number_of_modules = len(_modules)
        if "jax" in _modules:
            _announce(_for_jax, _jax)
        if "torch" in _modules:
            _announce(_for_torch, _torch)
    return value


def _announce(kinds: list[_Kind], register: Callable[[type, tuple[str, ...]], None]) -> None:
    with suppress(IndexError):  # one thread takes each
        while True:
            register(*kinds.pop())


def _parts(names: tuple[str, ...]) -> Callable[[object], tuple[object, ...]]:
    return lambda value: tuple(getattr(value, name) for name in names)


def _whole(kind: type, names: tuple[str, ...]) -> Callable[[Iterable[object]], object]:
    """Return the function that rebuilds an object from its leaves, which may be any objects."""

    def made(parts: Iterable[object]) -> object:
        value: object = object.__new__(kind)
        for name, part in zip(names, parts, strict=True):
            object.__setattr__(value, name, part)
        return value

    return made


def _jax(kind: type, names: tuple[str, ...]) -> None:
    register_pytree_node = import_module("jax.tree_util").register_pytree_node
    parts, whole = _parts(names), _whole(kind, names)
    register_pytree_node(kind, lambda value: (parts(value), None), lambda _, found: whole(found))


def _torch(kind: type, names: tuple[str, ...]) -> None:
    register_pytree_node = import_module("torch.utils._pytree").register_pytree_node
    parts, whole = _parts(names), _whole(kind, names)
    register_pytree_node(
        kind, lambda value: (list(parts(value)), None), lambda found, _: whole(found)
    )
