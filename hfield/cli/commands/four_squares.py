"""``hfield four-squares``: Lagrange's theorem by greatest common divisors of Hurwitz quaternions."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.cli.answer_formats import OutputDocument, answer_one
from hfield.cli.parser import add_format, add_output
from hfield.errors import TooLargeError

HELP = (
    "Write an integer as a sum of four squares, by a greatest common divisor in the Hurwitz order."
)
DOING = "factoring"
EXAMPLES = ("hfield four-squares 1000003",)
DIGITS = 500


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("n", metavar="N", help="an integer ≥ 0, such as 2026 or 10**60+7")
    add_format(parser, "plain", "unicode", "json")
    add_output(parser)


def run(args: Namespace) -> int:
    """Compute, and print the squares in descending order."""
    from hfield.algebra.structure import four_squares
    from hfield.fields.names import ring

    n = int(ring("ZZ")(args.n))
    if abs(n) >= 10**DIGITS:
        raise TooLargeError(f"four-squares takes numbers of at most {DIGITS} digits")

    def answer() -> OutputDocument:
        squares = four_squares(n)
        return OutputDocument(
            lambda: {"schema": "hfield-four-squares/1", "n": n, "squares": squares},
            lambda _: f"{n} = {' + '.join(f'{x}^2' for x in squares)}",
            {"unicode": lambda: f"{n} = {' + '.join(f'{x}²' for x in squares)}"},
        )

    return answer_one(args, answer)
