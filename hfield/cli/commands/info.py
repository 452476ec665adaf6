"""``hfield info``: the page about an algebra."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.cli.answer_formats import OutputDocument, of_parts
from hfield.cli.batch import add_inputs, answer_all
from hfield.cli.parser import add_factors, add_output, add_standalone, given_factors
from hfield.cli.status import Waiting

HELP = (
    "Describe an algebra: multiplication table, centre, radical, division or split (with "
    "the isomorphism or the reason), ramified places, a maximal order, and counts over "
    "finite rings."
)
DOING = "describing"
EXAMPLES = (
    "hfield info '(-1,-3|QQ)'",
    "hfield info 'H(GF(9))' '[1,t|GF(4)(t))'",
    "hfield info --from algebras.txt --format jsonl",
)
COLUMNS = (
    *("algebra", "field", "commutative", "central_simple", "division", "reason"),
    *("ramified_places", "discriminant", "undecided", "error"),
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    what = "such as '(-1,-3|QQ)', '[1,t|GF(4)(t))', 'H(GF(9))', or a discriminant, 11"
    add_inputs(parser, "ALGEBRA", what, "plain", "json", "latex")
    add_standalone(parser)
    add_factors(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Collect the facts, and print the pages."""
    with given_factors(args):
        return answer_all(args, _describe, COLUMNS)


def _describe(text: str) -> OutputDocument:
    from hfield.cli.commands import count
    from hfield.description import info
    from hfield.description.page import parts

    Waiting.at(f"describing {text}")
    description = info(text)
    A = description.algebra
    counted = count.counts(A, quick=True) if A.ring.order is not None else None
    return of_parts(
        lambda: {**description.to_json(), "counts": counted and counted.to_json()},
        lambda: [*parts(description), *(count.parts(counted) if counted else ())],
    )
