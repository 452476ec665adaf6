"""Writes one page of reference for each package: every public name, with what its docstring says."""

from importlib import import_module
from inspect import isclass, ismodule, isroutine
from pathlib import Path
from typing import Any

PACKAGES = {
    "hfield": "Quaternion algebras, their fields, statements and verdicts.",
    "rotation": "Rotations and rigid motions of space, one or a million.",
    "anim": "The spinning top: its shape, its motion, its pictures.",
}


def write(app: Any) -> None:
    """Write ``reference/PACKAGE.md`` for each package, where it changed."""
    folder = Path(app.srcdir) / "reference"
    folder.mkdir(exist_ok=True)
    for package, text in PACKAGES.items():
        path = folder / f"{package}.md"
        page = f"# {package}\n\n{text}\n\n" + "\n\n".join(_entries(package)) + "\n"
        if not path.exists() or path.read_text(encoding="utf-8") != page:
            path.write_text(page, encoding="utf-8")


def _entries(package: str) -> list[str]:
    module = import_module(package)
    entries = []
    for name in dir(module):
        value = getattr(module, name)
        if ismodule(value):
            continue
        members = ""
        if isclass(value):
            directive = "autoclass"
            members = "\n   :members:\n   :inherited-members: Exception, BaseException, tuple, Enum"
        else:
            directive = "autofunction" if isroutine(value) else "autodata"
        entries.append(f"```{{eval-rst}}\n.. {directive}:: {package}.{name}{members}\n```")
    return entries


def setup(app: Any) -> dict[str, bool]:
    """Join Sphinx."""
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True}
