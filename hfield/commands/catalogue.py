"""The commands there are: this package's, and what other packages name in their entry points."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from hfield.commands.parser import Parser, UsageError, suggest
from hfield.errors import shorten

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


COMMANDS = {
    "verify": "decide the claims of the thesis over a panel of fields",
    "claims": "list the claims",
    "init": "write a small ledger of your own to begin with",
    "report": "write the ledger as one page, or as a paper",
    "explain": "show one decision in full",
    "prove": "prove or refute a statement of your own",
    "check": "re-check certificates, independently",
    "upgrade": "write certificates of the first schema in today's",
    "export": "write what is proved for all fields as theorems for Coq",
    "info": "tell what an algebra is",
    "field": "tell classes of ideals and units of a number field",
    "order": "show an order over the integers",
    "ideal": "show an ideal of an order, and compare it with another",
    "domain": "draw the domain of the units of an indefinite order",
    "classes": "enumerate the ideal classes of an order",
    "brandt": "print Brandt matrices and isogeny graphs",
    "survey": "tell class numbers over ranges, in parallel",
    "count": "count elements of an algebra over a finite field",
    "four-squares": "write an integer as a sum of four squares",
    "table": "print the multiplication table of an algebra",
    "eval": "compute an expression exactly",
    "roots": "find all roots of a polynomial over an algebra",
    "solve": "solve linear equations in unknown quaternions",
    "matrix": "compute with matrices over an algebra",
    "warm": "compile the loops over arrays beforehand",
    "docs": "open the documentation in the browser",
    "doctor": "tell what is installed, what is missing and what it would add",
    "completion": "print the completion script of a shell",
    "repl": "an interactive session with e, i, j, k at hand",
}
GROUP = "hfield.commands"


def command(name: str) -> tuple[Any, Parser]:
    """Return the module of a command and the parser of its arguments. Raises :class:`UsageError`."""
    module = _load(name)
    parser = Parser(f"hfield {name}", module.HELP, getattr(module, "EXAMPLES", ()))
    module.configure(parser)
    return module, parser


def names() -> list[str]:
    """Return the names of all commands."""
    return [*COMMANDS, *_foreign()]


def summaries() -> dict[str, str]:
    """Return what each command does, in a line."""
    return COMMANDS | {name: _summary(point) for name, point in _foreign().items()}


def _load(name: str) -> Any:
    if name in COMMANDS:
        return import_module(f"hfield.commands.{name.replace('-', '_')}")
    foreign = _foreign()
    if name in foreign:
        return foreign[name].load()
    if name.startswith("-"):
        raise UsageError(
            f"unknown option {shorten(name)!r}; expected a command first, `hfield --help` lists them"
        )
    hint = suggest(name, names()) or "`hfield --help` lists them"
    raise UsageError(f"there is no command {shorten(name)!r}: {hint}")


def _foreign() -> dict[str, EntryPoint]:
    """Return the entry points of other packages by the name of their command."""
    from importlib.metadata import entry_points

    return {point.name: point for point in entry_points(group=GROUP)}


def _summary(point: EntryPoint) -> str:
    """Say in a line what a command of another package does: its own ``SUMMARY``, if it has one."""
    try:
        return str(point.load().SUMMARY)
    except Exception as error:  # one broken package does not take the help away from the others
        missing = isinstance(error, AttributeError)
        return f"(see `hfield {point.name} --help`)" if missing else f"(cannot be loaded: {error})"
