"""Rotations, motions and curves as containers of arrays, for the transformations of JAX and torch.

What `jit`, `vmap`, `grad` and `scan` take apart into arrays and put together again they call a pytree. A
class is announced to a library that somebody has imported, when the first value is made thereafter: nothing
is imported here.
"""

import sys
from collections.abc import Callable
from importlib import import_module
from typing import Any, TypeVar

_modules = sys.modules
_Class = TypeVar("_Class", bound=type)
_kinds: list[tuple[type, tuple[str, ...]]] = []
_announced: dict[str, int] = {"jax": 0, "torch": 0}  # how many of them are known there


def holding(*names: str) -> Callable[[_Class], _Class]:
    """Say of a class which attributes hold its arrays, or containers of such; it has no others but None."""

    def noted(kind: _Class) -> _Class:
        _kinds.append((kind, names))
        return kind

    return noted


def announce() -> None:
    """Make the classes known to those of the libraries that are there."""
    for library, known in _announced.items():
        if known < len(_kinds) and library in _modules:
            register = _jax if library == "jax" else _torch
            _announced[library] = len(_kinds)
            for kind, names in _kinds[known:]:
                register(kind, names)


def _parts(names: tuple[str, ...]) -> Callable[[Any], tuple[Any, ...]]:
    return lambda value: tuple(getattr(value, name) for name in names)


def _whole(kind: type, names: tuple[str, ...]) -> Callable[[Any], Any]:
    """How to put one together, of whatever stands for its arrays: a library may put there what it likes."""

    def made(parts: Any) -> Any:
        value: Any = object.__new__(kind)
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
