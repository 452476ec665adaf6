"""``hfield repl``: an interactive session."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.cli.parser import add_algebra, algebra_of

HELP = (
    "Start an interactive session with H, GF, QQ, prove, explain and the basis e, i, j, k "
    "of an algebra. It uses IPython where that is installed. Piped lines run without "
    "prompts."
)
EXAMPLES = (
    "hfield repl --field GF9",
    "echo 'print(i*j)' | hfield repl",
    "echo 'print((a + b*i).norm())' | hfield repl --symbols 'a b'",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_algebra(parser, first=True)
    parser.add_argument(
        "--symbols",
        metavar="NAMES",
        help='symbols of sympy, such as "a b t"; the field becomes that of the rational functions in them',
    )


def run(args: Namespace) -> int:
    """Run the session."""
    from hfield.repl import start, with_symbols

    names = args.symbols.replace(",", " ").split() if args.symbols else []
    return start(with_symbols(algebra_of(args), names), names)
