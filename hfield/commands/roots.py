"""``hfield roots``: all roots of a polynomial over a quaternion algebra."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial
from typing import TYPE_CHECKING

from hfield.commands.answers import Answer
from hfield.commands.many import add_inputs, answer_all
from hfield.commands.parser import add_algebra, add_output, algebra_of

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra

HELP = (
    "Find all roots of a polynomial such as 'x^2 + i*x + 1' over an algebra. The variable "
    "commutes with the coefficients, which stand on the left."
)
DOING = "looking for roots"
EXAMPLES = ("hfield roots 'x^2 + 1'", "hfield roots 'x^2 + i*x + 1' --field RR")
COLUMNS = ("polynomial", "algebra", "field", "spheres", "isolated", "families", "error")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_inputs(parser, "POLYNOMIAL", "the polynomial, in quotes", "plain", "unicode", "json")
    parser.add_argument(
        "--variable", metavar="X", default="x", help="the name of the variable (default: x)"
    )
    add_algebra(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Find the roots and print."""
    return answer_all(args, partial(_roots, algebra_of(args), args.variable), COLUMNS, apart=False)


def _roots(A: QuaternionAlgebra, variable: str, text: str) -> Answer:
    P = A.polynomials(variable)
    left, _, right = text.replace("==", "=").partition("=")
    found = (P.parse(left) - P.parse(right or "0")).roots()
    scalar = A.ring.text

    def data() -> dict[str, object]:
        return {
            "schema": "hfield-roots/1",
            "polynomial": text,
            "algebra": A.name,
            "field": A.ring.name,
            "spheres": [[scalar(t), scalar(n)] for t, n in found.spheres],
            "isolated": [q.text() for q in found.isolated],
            "families": [
                {"trace": scalar(m.t), "norm": scalar(m.n), "example": m.example.text()}
                for m in found.families
            ],
        }

    def page(style: str) -> str:
        lines = [f"all q of trace {scalar(t)} and norm {scalar(n)}" for t, n in found.spheres]
        lines += [q.text(style) for q in found.isolated]
        lines += [
            f"several of trace {scalar(m.t)} and norm {scalar(m.n)}, such as {m.example.text(style)}"
            for m in found.families
        ]
        return "\n".join(lines) or "no root"

    return Answer(data, lambda _: page("plain"), {"unicode": partial(page, "unicode")})
