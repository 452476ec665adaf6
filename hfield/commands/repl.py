"""``hfield repl``: an interactive session."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.commands.parser import add_algebra, algebra_of

HELP = (
    "An interactive session (IPython where it is installed) with H, GF, QQ, prove, explain and "
    "e, i, j, k of the chosen algebra. Lines piped in are run without prompts."
)
EXAMPLES = (
    "hfield repl --field GF9",
    "echo 'print(i*j)' | hfield repl",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_algebra(parser, first=True)


def run(args: Namespace) -> int:
    """Run the session."""
    from hfield.repl import start

    return start(algebra_of(args))
