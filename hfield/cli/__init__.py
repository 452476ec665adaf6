"""The command ``hfield``: find the command, run it, print each error as one line.

Nothing heavy is imported here, nor for ``--help`` and ``--version``. A command is a module with
``HELP``, ``configure(parser)`` and ``run(args) -> int``: one of :mod:`hfield.cli.commands`, or what
another package names in its entry points, group ``hfield.commands``, with a line ``SUMMARY`` and the
group of the help, ``HEADING``. ``DOING`` is what a slow command prints on a terminal meanwhile.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import nullcontext

from hfield import __version__
from hfield.cli.catalogue import RENAMED, command, groups
from hfield.cli.output import encodable, say, terminal_width
from hfield.cli.status import Waiting
from hfield.errors import HFieldError, shorten

TRACEBACK = "HFIELD_TRACEBACK"  # set it to see where an error came from

PURPOSE = (
    "Compute in quaternion algebras over arbitrary fields, prove or refute statements about them, "
    "rotate points, and draw the spinning top."
)
FIRST_COMMAND = "hfield prove 'p*q == q*p'"

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
    say("error", message)
    return status


def _dispatch(words: list[str]) -> int:
    if not words or words[0] in ("-h", "--help"):
        print(encodable(_help(), sys.stdout))
        return 0
    if words[0] == "--version":
        print(f"hfield {__version__}")
        return 0
    if words[0] == "help":
        return _dispatch([*words[1:2], "--help"])
    name = words[0]
    if name in RENAMED:
        name = RENAMED[name]
        say(
            "warning",
            f"`hfield {words[0]}` is now `hfield {name}`; the next version drops the old name",
        )
    module, parser = command(name)
    args = parser.read(words[1:])
    with Waiting(module.DOING) if hasattr(module, "DOING") else nullcontext():
        status: int = module.run(args)
    return status


def _help() -> str:
    from textwrap import fill

    width = terminal_width()
    lines = ["usage: hfield COMMAND [OPTION]…", "", fill(PURPOSE, width)]
    for title, commands in groups().items():
        lines += ["", f"{title}:"]
        for name, text in commands.items():
            lines.append(
                fill(text, width, initial_indent=f"  {name:<12} ", subsequent_indent=" " * 15)
            )
    below = "`hfield help COMMAND` describes a command. `hfield --version` prints the version."
    return "\n".join([*lines, "", fill(below, width), f"Start with: {FIRST_COMMAND}"])
