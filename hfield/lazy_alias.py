"""A second name of a package, imported on first use."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module


def lazy_alias(package: str) -> tuple[Callable[[str], object], Callable[[], list[str]]]:
    """Return ``__getattr__`` and ``__dir__`` of a module that is an alias of a package.

    >>> get, _ = lazy_alias("math")
    >>> get("gcd")(6, 4)
    2
    """

    def get(name: str) -> object:
        if name.startswith("__"):  # attributes that the import system reads from every module
            raise AttributeError(name)
        return getattr(import_module(package), name)

    def names() -> list[str]:
        return dir(import_module(package))

    return get, names
