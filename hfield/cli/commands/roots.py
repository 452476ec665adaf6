"""``hfield roots``: all roots of a polynomial over a quaternion algebra."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, of_styles
from hfield.cli.batch import add_inputs, answer_all
from hfield.cli.parser import add_algebra, add_output, algebra_of
from hfield.errors import NotFiniteError, TooLargeError

if TYPE_CHECKING:
    from collections.abc import Callable

    from hfield.algebra import QuaternionAlgebra

HELP = (
    "Find all roots of a polynomial such as 'x^2 + i*x + 1' over an algebra. The variable "
    "commutes with the coefficients, which stand on the left."
)
DOING = "looking for roots"
EXAMPLES = (
    "hfield roots 'x^2 + 1'",
    "hfield roots 'x^2 + i*x + 1' --field RR",
    "hfield roots 'x^2 + 1' --field GF3 --list",
)
COLUMNS = (
    "polynomial",
    "algebra",
    "field",
    "spheres",
    "isolated",
    "families",
    "scalars",
    "count",
    "error",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_inputs(parser, "POLYNOMIAL", "the polynomial, in quotes", "plain", "unicode", "json")
    parser.add_argument(
        "--variable",
        metavar="X",
        help="the name of the variable (default: the only letter from p to z without another meaning, or x)",
    )
    parser.add_argument(
        "--list",
        action="store_true",
        help="list all roots, one per line, if there are finitely many, as over a finite field",
    )
    add_algebra(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Find the roots and print them."""
    answer = partial(_roots, algebra_of(args), args.variable, args.list)
    return answer_all(args, answer, COLUMNS, apart=False)


def _roots(A: QuaternionAlgebra, variable: str | None, listed: bool, text: str) -> OutputDocument:
    from hfield.matrices.equations import unknowns_in

    letters = unknowns_in(A, [text])
    P = A.polynomials(variable or (letters[0] if len(letters) == 1 else "x"))
    left, _, right = text.replace("==", "=").partition("=")
    found = (P.parse(left) - P.parse(right or "0")).roots()
    scalar = A.ring.text
    roots = list(found.elements()) if listed else []

    def data() -> dict[str, object]:
        return {
            "schema": "hfield-roots/1",
            "polynomial": text,
            "algebra": A.name,
            "field": A.ring.name,
            "spheres": [[scalar(t), scalar(n)] for t, n in found.spheres],
            "isolated": [q.text() for q in found.isolated],
            "families": [
                {
                    "trace": None if m.t is None else scalar(m.t),
                    "norm": None if m.n is None else scalar(m.n),
                    "example": m.example.text(),
                    "count": _number(m.count),
                }
                for m in found.families
            ],
            "scalars": [q.text() for q in found.scalars],
            "count": _number(found.count),
            **({"roots": [q.text() for q in roots]} if listed else {}),
        }

    def page(style: str) -> str:
        if listed:
            return "\n".join(q.text(style) for q in roots) or "no root"
        lines = [q.text(style) for q in found.scalars]
        lines += [q.text(style) for q in found.isolated if q.vector_part]
        lines += [f"all q of trace {scalar(t)} and norm {scalar(n)}" for t, n in found.spheres]
        for m in found.families:
            number = _number(m.count) or "several"
            place = "" if m.t is None else f" of trace {scalar(m.t)} and norm {scalar(m.n)}"
            outside = " of other traces and norms" if m.t is None and found.spheres else ""
            lines.append(f"{number}{place}{outside}, such as {m.example.text(style)}")
        return "\n".join(lines) or "no root"

    return of_styles(data, page)


def _number(count: Callable[[], int]) -> int | None:
    """Return the number of roots; None if it is infinite or takes long to count."""
    try:
        return count()
    except (NotFiniteError, TooLargeError):
        return None
