"""A catalogue of the objects that the modules of a folder define, one per module, by module name."""

import ast
from collections.abc import Iterator, Mapping
from functools import cached_property
from importlib import import_module
from importlib.util import find_spec
from pkgutil import iter_modules, resolve_name
from typing import TypeVar

T = TypeVar("T", covariant=True)


class Catalogue(Mapping[str, T]):
    """The objects named ``attribute`` in the modules of a package, by module name.

    Names are read from the folder, and a module is imported when its object is first needed. To add an entry,
    add a file to the folder; nothing else needs to be changed.
    """

    def __init__(self, package: str, attribute: str) -> None:
        self.package, self.attribute = package, attribute

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names of the modules, in order."""
        folders = import_module(self.package).__path__
        return tuple(sorted(module.name for module in iter_modules(folders)))

    @cached_property
    def summaries(self) -> dict[str, str]:
        """The first lines of the docstrings by module name; the modules are not imported."""
        return {name: _summary(f"{self.package}.{name}") for name in self.names}

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


def _summary(module: str) -> str:
    spec = find_spec(module)
    assert spec is not None
    assert spec.origin is not None
    with open(spec.origin, encoding="utf-8") as source:
        docstring = ast.get_docstring(ast.parse(source.read())) or ""
    return docstring.partition("\n")[0].rstrip(".")
