"""List the commands of hfield and those in entry points of other packages."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

from hfield.cli.parser import Parser, UsageError, suggest
from hfield.errors import shorten

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint
    from types import ModuleType


# The groups of `hfield --help`, with their commands and descriptions.
GROUPS: dict[str, dict[str, str]] = {
    "Decide": {
        "prove": "prove or refute a statement",
        "check": "check certificates with an independent program",
        "export": "write theorems for Coq or Lean",
        "upgrade": "rewrite certificates of the first schema in the current one",
    },
    "Compute": {
        "info": "describe an algebra: division or split, ramification, orders",
        "eval": "evaluate an expression exactly",
        "table": "print the multiplication table of an algebra",
        "count": "count elements by norm over a finite ring",
        "list": "list units, zero divisors, ideals … of a finite algebra",
        "draw": "draw products, norms, ideals or graphs of a finite algebra",
        "roots": "find all roots of a polynomial over an algebra",
        "solve": "solve linear equations in unknown quaternions",
        "matrix": "compute with matrices over an algebra",
        "four-squares": "write an integer as a sum of four squares",
    },
    "Orders and fields": {
        "field": "class group and unit group of a number field",
        "order": "basis, discriminant and units of an order",
        "ideal": "an ideal of an order, and whether two are equivalent",
        "embed": "embed a quadratic order in an order",
        "classes": "ideal classes of an order",
        "brandt": "Brandt matrices and isogeny graphs",
        "newforms": "newforms of an order, their eigenvalues and fields",
        "domain": "unit group of an indefinite order, and its fundamental domain",
        "survey": "tables of class numbers or unit groups over ranges",
    },
    "Ledgers": {
        "verify": "decide all claims of the thesis, or of your own ledger",
        "claims": "list the claims of the thesis",
        "explain": "show one decision in full",
        "init": "write a small ledger as a start for your own",
        "report": "write a decided ledger as a web page or a paper",
    },
    "Tools": {
        "repl": "start an interactive session",
        "docs": "open the documentation in a browser",
        "doctor": "list which libraries are installed and which are missing",
        "completion": "print the completion script of a shell",
        "precompile": "compile the loops over arrays ahead of time",
    },
}
LINES_OF_OTHER_NAMES = {
    "hilbert": "hfield eval 'hilbert(2,5,5)'",
    "ramified": "hfield info '(-1,-1|QQ)'",
    "discriminant": "hfield info '(-1,-1|QQ)'",
    "factor": "hfield roots 'x^2+1'",
    "units": "hfield order 2 --units",
    "test": "hfield verify",
    "version": "hfield --version",
    "rotate": "python, with the package rotation",
}
"""Names that are no commands, with the line to type instead."""
RENAMED = {"warm": "precompile"}
"""Former names of commands, which still run with a warning."""
COMMANDS = {name: text for group in GROUPS.values() for name, text in group.items()}
LAST, OTHER = "Tools", "Other packages"
GROUP = "hfield.commands"


def command(name: str) -> tuple[ModuleType, Parser]:
    """Return the module of a command and the parser of its arguments. Raises :class:`UsageError`."""
    module = _load(name)
    parser = Parser(f"hfield {name}", module.HELP, getattr(module, "EXAMPLES", ()))
    module.configure(parser)
    return module, parser


def names() -> list[str]:
    """Return the names of all commands."""
    return [*COMMANDS, *_foreign()]


def groups() -> dict[str, dict[str, str]]:
    """Return the groups of the help, each with its commands and their one-line summaries.

    The group of a foreign command is its module's ``HEADING``.
    """
    found = {title: dict(group) for title, group in GROUPS.items() if title != LAST}
    for name, point in _foreign().items():
        title, summary = _described(point)
        found.setdefault(title, {})[name] = summary
    return found | {LAST: GROUPS[LAST]}


def _load(name: str) -> ModuleType:
    if name in COMMANDS:
        return import_module(f"hfield.cli.commands.{name.replace('-', '_')}")
    foreign = _foreign()
    if name in foreign:
        module: ModuleType = foreign[name].load()
        return module
    if name.startswith("-"):
        raise UsageError(
            f"unknown option {shorten(name)!r}; expected a command first, `hfield --help` lists them"
        )
    if name in LINES_OF_OTHER_NAMES:
        raise UsageError(f"there is no command {name!r}: write {LINES_OF_OTHER_NAMES[name]}")
    hint = suggest(name, names()) or "`hfield --help` lists them"
    raise UsageError(f"there is no command {shorten(name)!r}: {hint}")


@cache
def _foreign() -> dict[str, EntryPoint]:
    """Return the entry points of other packages by command name."""
    from importlib.metadata import entry_points

    return {point.name: point for point in entry_points(group=GROUP)}


def _described(point: EntryPoint) -> tuple[str, str]:
    """Return ``HEADING`` and ``SUMMARY`` of a command of another package, or defaults."""
    try:
        module = point.load()
    except Exception as error:  # one broken package must not disable the help for the others
        return OTHER, f"(cannot be loaded: {error})"
    summary = getattr(module, "SUMMARY", f"(see `hfield {point.name} --help`)")
    return str(getattr(module, "HEADING", OTHER)), str(summary)
