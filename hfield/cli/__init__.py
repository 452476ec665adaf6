"""The command ``hfield``: find the command, run it, print each error as one line.

No heavy module is imported here, so ``--help`` and ``--version`` are quick. A command is a module with
``HELP``, ``configure(parser)`` and ``run(args) -> int``, either in :mod:`hfield.cli.commands` or in another
package. Other packages name their commands in the entry points ``hfield.commands``; there ``SUMMARY`` is one
line for the help, and ``HEADING`` is the group in the help. A slow command prints ``DOING`` on a terminal
while it runs.
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

TRACEBACK = "HFIELD_TRACEBACK"  # set it to see the origin of an error

PURPOSE = (
    "Compute in quaternion algebras over arbitrary fields, prove or refute statements about them, "
    "rotate points, and draw the spinning top."
)
FIRST_COMMAND = "hfield prove 'p*q == q*p'"

BAD_USAGE, INTERNAL, INTERRUPTED, BROKEN_PIPE = 2, 70, 130, 141


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line ``argv`` and return its exit status: 2 for bad usage, 130 for Ctrl-C."""
    for name in ("stdout", "stderr"):  # None if the shell has closed them: `hfield … >&-`
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
    except OSError as error:  # files report their own errors: this is standard output
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
    """Redirect stdout to the null device, so that Python does not complain when it flushes stdout at exit."""
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
