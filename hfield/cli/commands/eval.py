"""``hfield eval``: compute an expression in a quaternion algebra, exactly."""

from __future__ import annotations

import re
from argparse import ArgumentParser, Namespace
from functools import partial
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument
from hfield.cli.batch import add_inputs, answer_all
from hfield.cli.parser import UsageError, add_algebra, add_output, algebra_of

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra

HELP = (
    "Evaluate an expression such as '(1+i)*(j-k)**-1' exactly. It may contain the basis e i "
    "j k, the generator of the field, and the functions conj norm trace inv scalar vector "
    "comm. hilbert(a, b, P) is the Hilbert symbol at a place of the field."
)
DOING = "computing"
EXAMPLES = (
    "hfield eval '(1+i)*(j-k)**-1' --field GF7",
    "hfield eval 'norm(1+2*i)' 'inv(1+i)' --format jsonl",
    "hfield eval 'hilbert(2,5,5)' 'hilbert(-1,-1,inf)'",
    "hfield eval 'hilbert(s,-1,(2,s))' --field 'QQ[s]/(s^3-2)'",
)


_SYMBOL = re.compile(r"hilbert(?:_symbol)?\s*\((.*)\)", re.DOTALL)
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


def _compute(A: QuaternionAlgebra, text: str) -> OutputDocument:
    symbol = _SYMBOL.fullmatch(text.strip())
    value = A.parse(text) if symbol is None else A.scalar(_hilbert_symbol(A, symbol[1]))

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
    return OutputDocument(data, lambda _: value.text(), styles)


def _hilbert_symbol(A: QuaternionAlgebra, arguments: str) -> int:
    """Return the Hilbert symbol for a text ``a, b, place``: two elements of the field and a place."""
    from hfield.fields.quadratic_forms.ramification import hilbert_symbol
    from hfield.syntax.brackets import split

    parts = [part.strip() for part in split(arguments, ",")]
    if len(parts) != 3 or not all(parts):
        raise UsageError(
            "hilbert takes two elements of the field and a place: hilbert(2,5,5), hilbert(-1,-1,inf)"
        )
    a, b = map(A.ring, parts[:2])
    place = int(parts[2]) if parts[2].isdecimal() and parts[2].isascii() else parts[2]
    return hilbert_symbol(a, b, place)
