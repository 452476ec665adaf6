"""``hfield claims``: list the claims with their ids and names."""

from __future__ import annotations

import textwrap
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, answer_one
from hfield.cli.output import note
from hfield.cli.parser import add_format, add_output, add_standalone
from hfield.errors import shorten

if TYPE_CHECKING:
    from hfield.ledger.claim import Claim
    from hfield.ledger.claims_table import TerminalStyle

HELP = (
    "List the claims of the thesis: id, name, kind and statement. A star marks the headline claims."
)
EXAMPLES = (
    "hfield claims --search centre",
    "hfield claims --section 1.3.1",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("--section", metavar="S", help="only claims of this section, such as 1.3.1")
    parser.add_argument(
        "--search",
        metavar="WORD",
        help="only claims with this word in name, kind, statement or note",
    )
    add_format(parser, "table", "json", "markdown", "latex")
    add_standalone(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """List the claims."""
    from hfield.ledger.registry import claims
    from hfield.ledger.selection import in_section

    chosen = in_section(args.section, claims()) if args.section is not None else claims()
    if args.search is not None:
        chosen = [claim for claim in chosen if _speaks_of(claim, args.search)]
        if not chosen:
            note(f"no claim contains {shorten(args.search)!r}; `hfield claims` lists all")

    def latex() -> str:
        from hfield.ledger import paper

        return paper.claims(chosen)

    answer = OutputDocument(
        lambda: {"schema": "hfield-claims/1", "claims": [_json(c) for c in chosen]},
        lambda style: _table(chosen, style),
        {"markdown": lambda: _markdown(chosen), "latex": latex},
    )
    return answer_one(args, lambda: answer)


def _speaks_of(claim: Claim, word: str) -> bool:
    texts = (claim.id, claim.name, claim.kind, claim.statement, claim.printed, claim.note)
    return word.casefold() in " ".join(text or "" for text in texts).casefold()


def _json(claim: Claim) -> dict[str, object]:
    names = ("id", "name", "section", "kind", "statement", "printed", "headline", "checkable")
    return {name: getattr(claim, name) for name in names}


def _markdown(chosen: Sequence[Claim]) -> str:
    from hfield.ledger.markdown import table

    return table(
        [
            ["claim", "name", "kind", "statement"],
            *([c.id, c.name, c.kind, c.statement] for c in chosen),
        ]
    )


def _table(chosen: Sequence[Claim], style: TerminalStyle) -> str:
    from hfield.presenting import hanging

    ids, names, kinds = (
        max((len(getattr(c, a)) for c in chosen), default=0) for a in ("id", "name", "kind")
    )
    lines, section = [], ""
    for claim in chosen:
        if claim.section != section:
            section = claim.section
            lines += ["", style.bold(f"Section {section}")]
        star = "*" if claim.headline else " "
        start = f"{star} {claim.id:<{ids}}  {claim.name:<{names}}  {claim.kind:<{kinds}}  "
        if len(start) > style.width - 25:  # too narrow for four columns: the statement goes below
            start = " " * (ids + 4)
            title = f"{star} {claim.id:<{ids}}  {claim.name}  ({claim.kind})"
            lines += textwrap.wrap(title, style.width, subsequent_indent=start)
            lines += textwrap.wrap(
                claim.statement, style.width, initial_indent=start, subsequent_indent=start
            )
            continue
        lines += hanging(start, claim.statement, style.width) or [start]
    return "\n".join(line.rstrip() for line in lines).lstrip("\n")
