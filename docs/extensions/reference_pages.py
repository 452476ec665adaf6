"""Writes one page of reference for each package: every public name, with what its docstring says.

A last page has the names of other systems, so that the search finds ours by them.
"""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from importlib import import_module
from inspect import isclass, ismodule, isroutine
from pathlib import Path
from typing import Any

import hfield.hints as hints_of_algebras
import rotation.hints as hints_of_rotations

PACKAGES = {
    "hfield": "Quaternion algebras, their fields, statements and verdicts.",
    "rotation": "Rotations and rigid motions of space, one or a million.",
    "anim": "The spinning top: its shape, its motion, its pictures.",
}
LONG = 12


def write(app: Any) -> None:
    """Write ``reference/PACKAGE.md`` for each package, where it changed."""
    folder = Path(app.srcdir) / "reference"
    folder.mkdir(exist_ok=True)
    pages = {
        package: f"# {package}\n\n{text}\n\n" + "\n\n".join(_sections(package)) + "\n"
        for package, text in PACKAGES.items()
    }
    for name, page in (pages | {"other-names": "\n".join(_other_names())}).items():
        path = folder / f"{name}.md"
        if not path.exists() or path.read_text(encoding="utf-8") != page:
            path.write_text(page, encoding="utf-8")


def _sections(package: str) -> list[str]:
    """Return classes, functions, values and errors, each under a heading."""
    module = import_module(package)
    found: dict[str, list[str]] = {"Classes": [], "Functions": [], "Values": [], "Errors": []}
    for name in dir(module):
        value = getattr(module, name)
        if ismodule(value):
            continue
        if isclass(value) and issubclass(value, Exception):
            kind, directive = "Errors", "autoexception"
        elif isclass(value):
            kind, directive = "Classes", "autoclass"
        else:
            kind, directive = (
                ("Functions", "autofunction") if isroutine(value) else ("Values", "autodata")
            )
        members = "\n   :members:\n   :inherited-members: tuple, Enum" if kind == "Classes" else ""
        found[kind].append(f"```{{eval-rst}}\n.. {directive}:: {package}.{name}{members}\n```")
    return [f"## {kind}\n\n" + "\n\n".join(entries) for kind, entries in found.items() if entries]


def _other_names() -> list[str]:
    """Return the lines of a page that says, class by class, what to write for the names of other systems."""
    lines = ["# What others call it", ""]
    lines += ["Names of Sage, Magma, PARI, GAP, scipy and their like, and what to write here."]
    for package in PACKAGES:
        module = import_module(package)
        for name in dir(module):
            hints = getattr(getattr(module, name), "elsewhere", {})
            lines += _table(f"{package}.{name}", hints)
    lines += _table("Functions of Magma and PARI", hints_of_algebras.CALLS)
    lines += _table("Functions that turn points, and names of best fits", hints_of_rotations.CALLS)
    return [*lines, ""]


def _table(title: str, hints: Mapping[str, str]) -> list[str]:
    """Return a heading and a table of what is written there and here; nothing where there is nothing."""
    rows = [f"| `{there}` | `{here}` |" for there, here in sorted(hints.items())]
    return ["", f"## {title}", "", "| there | here |", "|---|---|", *rows] if rows else []


def _answer(app: Any, what: str, name: str, value: Any, *signature: Any) -> tuple[str, None] | None:
    """Leave out how a long record is called: it is an answer, which nobody makes by hand."""
    if what == "class" and is_dataclass(value) and len(fields(value)) > LONG:
        return "", None
    return None


def _prose(self: Any) -> list[str]:
    """Read the docstring of a property, in which what stands before a colon is no type."""
    lines: list[str] = self._format_field("", "", self._dedent(self._consume_to_end()))
    return lines


def setup(app: Any) -> dict[str, bool]:
    """Join Sphinx."""
    from sphinx.ext.napoleon.docstring import GoogleDocstring

    GoogleDocstring._parse_attribute_docstring = _prose
    app.connect("builder-inited", write)
    app.connect("autodoc-process-signature", _answer)
    return {"parallel_read_safe": True}
