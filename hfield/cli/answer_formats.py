"""Write the answer of a command in the format that ``--format`` names: text, JSON, LaTeX."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from hfield.cli.output import Sink, open_output

if TYPE_CHECKING:
    from hfield.ledger.claims_table import TerminalStyle
    from hfield.presenting import AnswerSection


@dataclass(frozen=True)
class OutputDocument:
    """An answer in JSON, text and other formats, with an exit status; only the requested format is
    computed.
    """

    data: Callable[[], Mapping[str, object]]
    page: Callable[[TerminalStyle], str]
    forms: Mapping[str, Callable[[], str]] = field(default_factory=dict)
    status: int = 0

    def write(self, out: Sink, args: Namespace) -> None:
        """Write the answer in ``args.format``."""
        if args.format == "json":
            out.write_json(self.data())
        elif args.format == "latex":
            out.write_latex(self.forms["latex"](), getattr(args, "standalone", False))
        else:
            form = self.forms.get(args.format)
            out.write(self.page(out.style()) if form is None else form())


def of_parts(
    data: Callable[[], Mapping[str, object]], parts: Callable[[], Sequence[AnswerSection]]
) -> OutputDocument:
    """Return the answer whose text and LaTeX are laid out from sections."""
    from hfield import presenting

    return OutputDocument(
        data,
        lambda style: presenting.page(parts(), style.width),
        {"latex": lambda: presenting.latex(parts())},
    )


def of_styles(
    data: Callable[[], Mapping[str, object]], page: Callable[[str], str], status: int = 0
) -> OutputDocument:
    """Return the answer whose text is written in a style of elements, plain or unicode."""
    return OutputDocument(
        data, lambda _: page("plain"), {"unicode": lambda: page("unicode")}, status
    )


def answer_one(args: Namespace, answer: Callable[[], OutputDocument]) -> int:
    """Open the output, compute the answer, write it, and return its exit status."""
    with open_output(args.output) as out:
        found = answer()
        found.write(out, args)
    return found.status
