"""Write the table of all methods of lattices, orders, ideals and class sets into docs/reference/orders.md.

    python -m scripts.list_methods

A row is a public name with its arguments, and the first sentence of its docstring.
"""

import inspect
import re
import sys
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from types import FunctionType

from hfield import ClassSet, Ideal, Lattice, Order
from hfield.hints import Hinted

PAGE = Path(__file__).parents[1] / "docs" / "reference" / "orders.md"
BEGIN = "<!-- written by python -m scripts.list_methods -->\n"
END = "<!-- end of what is written -->\n"
CLASSES: tuple[tuple[str, type[Hinted]], ...] = (
    ("L", Lattice), ("O", Order), ("I", Ideal), ("C", ClassSet)
)  # fmt: skip


def own_names(kind: type[Hinted]) -> Iterator[tuple[str, object]]:
    """Yield the public methods and properties of a class but those that it shares with Lattice."""
    shared = set(dir(Lattice)) if kind is not Lattice and issubclass(kind, Lattice) else set()
    for name in sorted(set(dir(kind)) - shared - set(kind.foreign_names)):
        found = inspect.getattr_static(kind, name)
        if not name.startswith("_") and isinstance(
            found, FunctionType | property | cached_property
        ):
            yield name, found


def signature(name: str, found: object) -> str:
    """Return a name with its arguments, where it is called."""
    if not isinstance(found, FunctionType):
        return name
    arguments = []
    for parameter in list(inspect.signature(found).parameters.values())[1:]:
        default = "" if parameter.default is parameter.empty else f"={parameter.default!r}"
        arguments.append(f"{parameter.name}{default}")
    return f"{name}({', '.join(arguments)})"


def first_sentence(found: object) -> str:
    """Return the first sentence of a docstring on one line, with bars that a table keeps."""
    text = " ".join((inspect.getdoc(found) or "").split("\n\n")[0].split())
    sentence = re.split(r"(?<=[.])\s(?=[A-Z:])", text)[0]
    return re.sub(r":\w+:`~?([^`]*)`", r"`\1`", sentence).replace("``", "`").replace("|", "\\|")


def table() -> str:
    """Return the table."""
    lines = ["| method or property | what it returns |", "|---|---|"]
    for letter, kind in CLASSES:
        lines.append(f"| **{kind.__name__}** `{letter}` | |")
        for name, found in own_names(kind):
            lines.append(f"| `{letter}.{signature(name, found)}` | {first_sentence(found)} |")
    return "\n".join(lines) + "\n"


def written(page: str) -> str:
    """Return a page with the table of today."""
    before, rest = page.split(BEGIN)
    _, after = rest.split(END)
    return f"{before}{BEGIN}\n{table()}\n{END}{after}"


def main() -> int:
    """Write the table."""
    PAGE.write_text(written(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
