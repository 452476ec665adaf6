"""``hfield table``: the multiplication table of an algebra, Table 1.1 of the thesis for H(F)."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.commands.output import open_output
from hfield.commands.parser import add_algebra, add_format, add_output, algebra_of

HELP = "Print the products of the basis e, i, j, k: row times column."
EXAMPLES = ("hfield table --field GF9 --format unicode",)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_algebra(parser)
    add_format(parser, "plain", "unicode", "latex", "json")
    add_output(parser)


def run(args: Namespace) -> int:
    """Print the table."""
    from hfield.notation import BASIS, element_text

    A = algebra_of(args)
    with open_output(args.output) as out:
        if args.format == "json":
            rows = [
                [element_text(A.ring, q.coordinates, "plain", "e") for q in row]
                for row in A.multiplication_table()
            ]
            head = {"schema": "hfield-table/1", "algebra": A.name, "field": A.ring.name}
            out.write_json({**head, "basis": BASIS, "table": rows})
        else:
            out.write(A.table_text(args.format))
    return 0
