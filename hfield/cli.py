"""The command ``hfield``: finds the command asked for, runs it, turns errors into one line.

Nothing heavy is imported here, nor for ``--help`` and ``--version``. A command is a module with
``HELP``, ``configure(parser)`` and ``run(args) -> int``: one of :mod:`hfield.commands`, or what
another package names in its entry points, group ``hfield.commands``, with a line ``SUMMARY``.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from hfield import __version__
from hfield.commands.output import encodable
from hfield.commands.parser import Parser, UsageError, suggest
from hfield.errors import HFieldError, shorten

COMMANDS = {
    "verify": "decide the claims of the thesis over a panel of fields",
    "claims": "list the claims",
    "explain": "show one decision in full",
    "prove": "prove or refute a statement of your own",
    "check": "re-check certificates, independently",
    "export": "write what is proved for all fields as theorems for Coq",
    "info": "tell what an algebra is",
    "order": "show an order over the integers",
    "classes": "enumerate the ideal classes of an order",
    "brandt": "print Brandt matrices and isogeny graphs",
    "survey": "tell class numbers over ranges, in parallel",
    "count": "count elements of an algebra over a finite field",
    "four-squares": "write an integer as a sum of four squares",
    "table": "print the multiplication table of an algebra",
    "eval": "compute an expression exactly",
    "warm": "compile the loops over arrays beforehand",
    "repl": "an interactive session with e, i, j, k at hand",
}
GROUP = "hfield.commands"
TRACEBACK = "HFIELD_TRACEBACK"  # set it to see where an error came from

BAD_USAGE, INTERNAL, INTERRUPTED, BROKEN_PIPE = 2, 70, 130, 141


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line ``argv`` and return its exit status: 2 for bad usage, 130 for Ctrl-C."""
    for name in ("stdout", "stderr"):  # None where the shell has closed them: `hfield … >&-`
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
    try:
        status = _dispatch(list(sys.argv[1:] if argv is None else argv))
        sys.stdout.flush()
        return status
    except SystemExit as stop:  # argparse leaves so after --help
        return stop.code if isinstance(stop.code, int) else int(stop.code is not None)
    except BrokenPipeError:
        _forget_stdout()  # the reader has left
        return BROKEN_PIPE
    except KeyboardInterrupt:
        return _fail("interrupted", INTERRUPTED)
    except HFieldError as error:
        return _fail(str(error), BAD_USAGE)
    except OSError as error:  # files say so themselves: this is the terminal, or where it leads
        _forget_stdout()
        return _fail(f"cannot write the output: {error.strerror or error}", BAD_USAGE)
    except RecursionError:
        return _fail("the input nests too deeply; write it in parts", BAD_USAGE)
    except MemoryError:
        return _fail("not enough memory for this computation; try a smaller one", BAD_USAGE)
    except Exception as error:
        what = f"{type(error).__name__}: {shorten(error, 200)}"
        return _fail(
            f"this is a fault of hfield itself ({what}); {TRACEBACK}=1 shows where", INTERNAL
        )


def _forget_stdout() -> None:
    """Lead stdout nowhere: Python would complain when it flushes it at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _fail(message: str, status: int) -> int:
    if os.environ.get(TRACEBACK):
        import traceback

        traceback.print_exc()
    line = " ".join(message.split())
    print(encodable(f"hfield: error: {line}", sys.stderr), file=sys.stderr)
    return status


def _dispatch(words: list[str]) -> int:
    if not words or words[0] in ("-h", "--help"):
        print(encodable(_help(), sys.stdout))
        return 0
    if words[0] == "--version":
        print(f"hfield {__version__}")
        return 0
    name, rest = words[0], words[1:]
    module = _load(name)
    parser = Parser(f"hfield {name}", module.HELP)
    module.configure(parser)
    status: int = module.run(parser.read(rest))
    return status


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
    hint = suggest(name, [*COMMANDS, *foreign]) or "`hfield --help` lists them"
    raise UsageError(f"there is no command {shorten(name)!r}: {hint}")


def _foreign() -> dict[str, Any]:
    """Return the entry points of other packages by the name of their command."""
    from importlib.metadata import entry_points

    return {point.name: point for point in entry_points(group=GROUP)}


def _summary(point: Any) -> str:
    """Say in a line what a command of another package does: its own ``SUMMARY``, if it has one."""
    try:
        return str(point.load().SUMMARY)
    except Exception as error:  # one broken package does not take the help away from the others
        missing = isinstance(error, AttributeError)
        return f"(see `hfield {point.name} --help`)" if missing else f"(cannot be loaded: {error})"


def _help() -> str:
    lines = [
        "usage: hfield COMMAND [OPTION]…",
        "",
        "Quaternion algebras over arbitrary fields, with statements about them decided.",
        "",
        *(f"  {name:<12} {text}" for name, text in COMMANDS.items()),
        *(f"  {name:<12} {_summary(point)}" for name, point in _foreign().items()),
        "",
        "`hfield COMMAND --help` tells more; `hfield --version` prints the version.",
        "Try: hfield verify",
    ]
    return "\n".join(lines)
