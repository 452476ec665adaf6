"""``hfield eval``: compute an expression in a quaternion algebra, exactly."""

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
    "Evaluate an expression such as '(1+i)*(j-k)**-1' exactly. It may contain the basis e i "
    "j k, the generator of the field, and the functions conj norm trace inv scalar vector "
    "comm."
)
DOING = "computing"
EXAMPLES = (
    "hfield eval '(1+i)*(j-k)**-1' --field GF7",
    "hfield eval 'norm(1+2*i)' 'inv(1+i)' --format jsonl",
)


COLUMNS = ("expression", "algebra", "field", "value", "coordinates", "error")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    what = "the expression, in quotes"
    add_inputs(parser, "EXPR", what, "plain", "unicode", "latex", "json")
    add_algebra(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Compute and print."""
    return answer_all(args, partial(_compute, algebra_of(args)), COLUMNS, apart=False)


def _compute(A: QuaternionAlgebra, text: str) -> Answer:
    value = A.parse(text)

    def data() -> dict[str, object]:
        return {
            "schema": "hfield-eval/1",
            "expression": text,
            "algebra": A.name,
            "field": A.ring.name,
            "value": value.text(),
            "coordinates": [A.ring.text(x) for x in value.coordinates],
        }

    styles = {style: partial(value.text, style) for style in ("unicode", "latex")}
    return Answer(data, lambda _: value.text(), styles)
