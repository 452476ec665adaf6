"""``hfield explain``: one decision in full, as on a blackboard."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.commands.output import open_output
from hfield.commands.parser import add_format, add_output

HELP = "Show one decision in full: the statement, how it was read, each step or the witness."


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("claim", metavar="CLAIM", help="id or name, such as C1.2-a or centre")
    parser.add_argument("--field", metavar="F", help="the field, or `universal` (default: QQ)")
    add_format(parser, "plain", "json", "latex")
    add_output(parser)


def run(args: Namespace) -> int:
    """Decide one claim over one field and tell how."""
    from hfield.ledger.blackboard import explain

    with open_output(args.output) as out:
        explanation = explain(args.claim, args.field)
        if args.format == "json":
            out.write_json(explanation.to_json())
        elif args.format == "latex":
            out.write(explanation.latex())
        else:
            out.write(explanation.text(out.style()))
    return 0 if explanation.row.settled else 1
