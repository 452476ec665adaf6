"""Write the reference of the interface into ``docs/api``: a page for each class and each command.

The page of a package has its functions, values and errors and leads to the pages of its classes. A last page
has the names of other systems, so that the search finds ours by them.
"""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from importlib import import_module
from inspect import isclass, ismodule, isroutine
from pathlib import Path
from typing import Any

import hfield.hints as hints_of_algebras
import rotation.hints as hints_of_rotations
from hfield.cli.catalogue import command, groups

PACKAGES = {
    "hfield": "Quaternion algebras, their fields, statements and verdicts.",
    "rotation": "Rotations and rigid motions of space, one or a million.",
    "anim": "The spinning top: its shape, its motion, its pictures.",
}
LONG = 12


def write(app: Any) -> None:
    """Write the pages into ``api``, each where it changed."""
    folder = Path(app.srcdir) / "api"
    pages = {"other-names": "\n".join(_other_names())}
    for package, text in PACKAGES.items():
        pages |= _pages_of_package(package, text)
    pages |= _pages_of_commands()
    for name, page in pages.items():
        path = folder / f"{name}.md"
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text(encoding="utf-8") != page:
            path.write_text(page, encoding="utf-8")


def _pages_of_package(package: str, text: str) -> dict[str, str]:
    """Return the page of a package and the pages of its classes, by name."""
    module = import_module(package)
    directives: dict[str, list[str]] = {"Functions": [], "Values": [], "Errors": []}
    classes: dict[str, str] = {}
    for name in dir(module):
        value = getattr(module, name)
        if ismodule(value):
            continue
        if isclass(value) and issubclass(value, Exception):
            directives["Errors"].append(_directive("autoexception", package, name))
        elif isclass(value):
            classes[name] = _class_page(package, name)
        elif isroutine(value):
            directives["Functions"].append(_directive("autofunction", package, name))
        else:
            directives["Values"].append(_directive("autodata", package, name))
    listed = "\n".join(f"{package}/{name}" for name in classes)
    parts = [f"# {package}", text, "## Classes", f"```{{toctree}}\n:maxdepth: 1\n\n{listed}\n```"]
    for kind, entries in directives.items():
        if entries:
            parts += [f"## {kind}", *entries]
    return {package: "\n\n".join(parts) + "\n"} | {
        f"{package}/{name}": page for name, page in classes.items()
    }


def _class_page(package: str, name: str) -> str:
    """Return the page of a class."""
    options = "\n   :members:\n   :inherited-members: tuple, Enum"
    return f"# {name}\n\n{_directive('autoclass', package, name, options)}\n"


def _directive(kind: str, package: str, name: str, options: str = "") -> str:
    """Return a directive of autodoc."""
    return f"```{{eval-rst}}\n.. {kind}:: {package}.{name}{options}\n```"


def _pages_of_commands() -> dict[str, str]:
    """Return the page that lists all commands, and for each command a page with its help."""
    pages = {}
    lines = [
        "# Commands",
        "",
        "The lines that `hfield --help` prints, and a page for each command.",
    ]
    for title, group in groups().items():
        rows = [f"| [`{name}`](commands/{name}.md) | {text} |" for name, text in group.items()]
        lines += ["", f"## {title}", "", "| command | |", "|---|---|", *rows]
        for name in group:
            _, parser = command(name)
            pages[f"commands/{name}"] = f"# hfield {name}\n\n```\n{parser.format_help()}```\n"
    listed = "\n".join(pages)
    lines += ["", f"```{{toctree}}\n:hidden:\n\n{listed}\n```", ""]
    return {"commands": "\n".join(lines)} | pages


def _other_names() -> list[str]:
    """Return the lines of a page that says, class by class, what to write for the names of other systems."""
    lines = ["# What others call it", ""]
    lines += ["Names of Sage, Magma, PARI, GAP, scipy and their like, and what to write here."]
    for package in PACKAGES:
        module = import_module(package)
        for name in dir(module):
            hints = getattr(getattr(module, name), "foreign_names", {})
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
