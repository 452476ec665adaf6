"""``hfield repl``: an interactive session."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.commands.parser import add_algebra, algebra_of

HELP = (
    "Start an interactive session with H, GF, QQ, prove, explain and the basis e, i, j, k "
    "of an algebra. It uses IPython where that is installed. Piped lines run without "
    "prompts."
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
