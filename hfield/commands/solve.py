"""``hfield solve``: all solutions of an equation that is linear in one unknown quaternion."""

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
    "Solve an equation that is linear over the field in one unknown, such as 'i*x - x*j = k', with conj, "
    "trace, scalar and vector of it. Exit status: 0 there are solutions, 1 there are none, 2 bad usage."
)
DOING = "solving"
EXAMPLES = (
    "hfield solve 'i*x - x*j == i - j'",
    "hfield solve 'i*q + conj(q)*j = 1' --field GF7 --unknown q",
)
COLUMNS = ("equation", "algebra", "field", "particular", "kernel", "reason", "error")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_inputs(parser, "EQUATION", "the equation, in quotes", "plain", "unicode", "json")
    parser.add_argument(
        "--unknown", metavar="X", default="x", help="the name of the unknown (default: x)"
    )
    add_algebra(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Solve and print."""
    return answer_all(args, partial(_solve, algebra_of(args), args.unknown), COLUMNS, apart=False)


def _solve(A: QuaternionAlgebra, unknown: str, text: str) -> Answer:
    from hfield.modules.equations import read_equation

    found = read_equation(A, text, unknown)

    def data() -> dict[str, object]:
        return {
            "schema": "hfield-solve/1",
            "equation": text,
            "algebra": A.name,
            "field": A.ring.name,
            "particular": None if found.particular is None else found.particular.text(),
            "kernel": [q.text() for q in found.kernel],
            "reason": found.reason or None,
        }

    def page(style: str) -> str:
        if found.particular is None:
            return f"no solution: {found.reason}"
        lines = [f"{unknown} = {found.particular.text(style)}"]
        if found.kernel:
            lines.append(f"and plus any combination over {A.ring.name} of")
            lines += [f"    {q.text(style)}" for q in found.kernel]
        return "\n".join(lines)

    forms = {"unicode": partial(page, "unicode")}
    return Answer(data, lambda _: page("plain"), forms, 0 if found else 1)
