"""``hfield eval``: compute an expression in a quaternion algebra, exactly."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.commands.output import open_output
from hfield.commands.parser import add_algebra, add_format, add_output, algebra_of

HELP = (
    "Compute an expression such as '(1+i)*(j-k)**-1': the basis e i j k, the generator of the field, "
    "and conj norm trace inv scalar vector comm."
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("expression", metavar="EXPR", help="the expression, in quotes")
    add_algebra(parser)
    add_format(parser, "plain", "unicode", "latex", "json")
    add_output(parser)


def run(args: Namespace) -> int:
    """Compute and print."""
    A = algebra_of(args)
    with open_output(args.output) as out:
        value = A.parse(args.expression)
        if args.format == "json":
            head = {"schema": "hfield-eval/1", "expression": args.expression, "algebra": A.name}
            coordinates = [A.ring.text(x) for x in value.coordinates]
            out.write_json(
                {**head, "field": A.ring.name, "value": value.text(), "coordinates": coordinates}
            )
        else:
            out.write(value.text(args.format))
    return 0
