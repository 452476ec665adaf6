"""``hfield solve``: solve linear equations in unknown quaternions, and with matrices."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, of_styles
from hfield.cli.batch import add_inputs, answer_all
from hfield.cli.parser import add_algebra, add_output, algebra_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from hfield.algebra import QuaternionAlgebra
    from hfield.algebra.quaternion import Quaternion
    from hfield.matrices.matrix import Matrix

    Value = Quaternion | Matrix

HELP = (
    "Solve linear equations in unknown quaternions. An equation such as 'i*x - x*j = k' may "
    "contain conj, trace, scalar and vector of the unknown. A system is 'i*x + y = j; x - "
    "y*i = 0', a matrix equation '[[1,i],[j,k]]*x = [i,j]'. Exit status: 0 there are "
    "solutions; 1 there are none; 2 bad usage."
)
DOING = "solving"
EXAMPLES = (
    "hfield solve 'i*x - x*j == i - j'",
    "hfield solve 'i*x + y = j; x - y*i = 0' --field GF7",
    "hfield solve '[[1,i],[j,k]]*x = [i,j]'",
)
COLUMNS = ("equation", "algebra", "field", "particular", "kernel", "reason", "error")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_inputs(parser, "EQUATION", "the equation, in quotes", "plain", "unicode", "json")
    parser.add_argument(
        "--unknown",
        metavar="X,…",
        help="the names of the unknowns (default: the letters from p to z that mean nothing else)",
    )
    add_algebra(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Solve and print."""
    return answer_all(args, partial(_solve, algebra_of(args), args.unknown), COLUMNS, apart=False)


def _solve(A: QuaternionAlgebra, unknown: str | None, text: str) -> OutputDocument:
    from hfield.matrices.equations import read_system, unknowns_in
    from hfield.matrices.texts import has_matrix, read_matrix_equation

    particular: Mapping[str, Value] | None
    kernel: Sequence[Mapping[str, Value]]
    if has_matrix(text):
        one = unknown or next(iter(unknowns_in(A, [text])), "x")
        solved = read_matrix_equation(A, text, one)
        reason, kernel = solved.reason, [{one: x} for x in solved.kernel]
        particular = None if solved.particular is None else {one: solved.particular}
        scalars = f"{A} on the {'left' if solved.from_right else 'right'}"
    else:
        equations = [part for part in text.split(";") if part.strip()]
        names = unknowns_in(A, equations) or ["x"] if unknown is None else unknown.split(",")
        found = read_system(A, equations, [name.strip() for name in names])
        particular, kernel, reason = found.particular, found.kernel, found.reason
        scalars = A.ring.name

    def data() -> dict[str, object]:
        return {
            "schema": "hfield-solve/1",
            "equation": text,
            "algebra": A.name,
            "field": A.ring.name,
            "particular": None if particular is None else _plain(particular),
            "kernel": [_plain(v) for v in kernel],
            "reason": reason or None,
        }

    def page(style: str) -> str:
        if particular is None:
            return f"no solution: {reason}"
        lines = [f"{name} = {x.text(style)}" for name, x in particular.items()]
        if kernel:
            lines.append(f"and plus any combination over {scalars} of")
            for v in kernel:
                shown = [x.text(style) for x in v.values()]
                pairs = [f"{name} = {x}" for name, x in zip(v, shown, strict=True)]
                lines.append(f"    {', '.join(pairs) if len(v) > 1 else shown[0]}")
        return "\n".join(lines)

    return of_styles(data, page, 1 if particular is None else 0)


def _plain(v: Mapping[str, Value]) -> object:
    """Return a mapping of texts by name, or a single text."""
    shown = {name: x.text() for name, x in v.items()}
    return shown if len(shown) > 1 else next(iter(shown.values()))
