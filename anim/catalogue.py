"""List what the modules of a folder define, one thing for each module, by the names of the modules."""

import ast
from collections.abc import Iterator, Mapping
from functools import cached_property
from importlib import import_module
from importlib.util import find_spec
from pkgutil import iter_modules, resolve_name
from typing import TypeVar

T = TypeVar("T", covariant=True)


class Catalogue(Mapping[str, T]):
    """The things called ``attribute`` in the modules of a package, by the modules' names.

    Names are read from the folder; a module is imported when its thing is first asked for. A new file in
    the folder is a new entry, and nothing else has to know of it.
    """

    def __init__(self, package: str, attribute: str) -> None:
        self.package, self.attribute = package, attribute

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names of the modules, in order."""
        folders = import_module(self.package).__path__
        return tuple(sorted(module.name for module in iter_modules(folders)))

    def summary(self, name: str) -> str:
        """Return the first line of a module's docstring, without importing it."""
        spec = find_spec(f"{self.package}.{name}")
        assert spec is not None
        assert spec.origin is not None
        with open(spec.origin, encoding="utf-8") as source:
            return (
                (ast.get_docstring(ast.parse(source.read())) or "").partition("\n")[0].rstrip(".")
            )

    def __getitem__(self, name: str) -> T:
        if name not in self.names:
            raise KeyError(name)
        found: T = resolve_name(f"{self.package}.{name}:{self.attribute}")
        return found

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)
