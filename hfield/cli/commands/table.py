"""``hfield table``: the multiplication table of an algebra, Table 1.1 of the thesis for H(F)."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial

from hfield.cli.answer_formats import OutputDocument, answer_one
from hfield.cli.parser import add_algebra, add_format, add_output, algebra_of

HELP = "Print the products of the basis e, i, j, k: row times column."
EXAMPLES = ("hfield table GF9 --format unicode",)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_algebra(parser, first=True)
    add_format(parser, "plain", "unicode", "latex", "json")
    add_output(parser)


def run(args: Namespace) -> int:
    """Print the table."""
    from hfield.notation import BASIS, element_text

    A = algebra_of(args)

    def data() -> dict[str, object]:
        rows = [
            [element_text(A.ring, q.coordinates, "plain", "e") for q in row]
            for row in A.multiplication_table()
        ]
        head = {"schema": "hfield-table/1", "algebra": A.name, "field": A.ring.name}
        return {**head, "basis": BASIS, "table": rows}

    styles = {style: partial(A.table_text, style) for style in ("unicode", "latex")}
    return answer_one(args, lambda: OutputDocument(data, lambda _: A.table_text(), styles))
