"""``hfield explain``: print decisions in full."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial

from hfield.cli.answer_formats import OutputDocument
from hfield.cli.batch import add_inputs, answer_all, check_given, texts
from hfield.cli.parser import add_output, add_standalone
from hfield.cli.status import Waiting

HELP = (
    "Show a decision in full: the statement, how the printed text was read, and each step of the "
    "proof or the witness."
)
DOING = "deciding"
EXAMPLES = (
    "hfield explain theorem-3 --field GF9",
    "hfield explain C1.2-a",
    "hfield explain 1.3.1 --format jsonl",
)
COLUMNS = ("id", "name", "field", "statement", "as_printed", "as_corrected", "error")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    what = "id, name or number, such as C1.2-a, centre, 'definition 2', or 1.3.1 for a section"
    add_inputs(parser, "CLAIM", what, "plain", "json", "latex")
    parser.add_argument("--field", metavar="F", help="the field, or `universal` (default: QQ)")
    add_standalone(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Decide claims over one field and print the proofs."""
    from hfield.ledger.registry import find_all

    check_given(args)
    args.inputs = [claim.id for text in texts(args) for claim in find_all(text)]
    args.source = None
    return answer_all(args, partial(_explain, args), COLUMNS)


def _explain(args: Namespace, claim: str) -> OutputDocument:
    from hfield.ledger.explanation import explain

    Waiting.at(f"deciding {claim}")
    explanation = explain(claim, args.field)

    def latex() -> str:
        from hfield.ledger import paper

        return paper.explanation(explanation.row)

    return OutputDocument(
        explanation.to_json,
        explanation.text,
        {"latex": latex},
        status=0 if explanation.row.settled else 1,
    )
