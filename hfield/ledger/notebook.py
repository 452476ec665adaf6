"""Reports as objects, for sessions and notebooks: they print themselves and display as LaTeX."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from hfield.core.executors import InProcess
from hfield.fields.base.latex_names import latex_name
from hfield.fields.base.ring import Ring
from hfield.fields.names import RingName
from hfield.latex import words
from hfield.ledger.claim import Row
from hfield.ledger.claims_table import LATEX_MARKS, TerminalStyle, marked
from hfield.ledger.columns import split_columns
from hfield.ledger.registry import claims, find_all
from hfield.ledger.report import report
from hfield.ledger.run import decide_rows
from hfield.ledger.selection import rows_to_decide


@dataclass(frozen=True)
class Report:
    """Decided rows of the ledger; ``rows`` are :class:`hfield.ledger.claim.Row` objects."""

    rows: tuple[Row, ...]
    chosen: bool = False

    def latex(self) -> str:
        """Write the table of verdicts as an array of LaTeX."""
        fields, claims = marked(self.rows, LATEX_MARKS)
        lines = [" & ".join(["", *map(latex_name, fields)]) + r" \\ \hline"]
        for claim, marks in claims:
            name = rf"\text{{{words(f'{claim.id} {claim.name}')}}}"
            lines.append(" & ".join([name, *marks]) + r" \\")
        return rf"\begin{{array}}{{l|{'c' * len(fields)}}}" + "\n".join(lines) + r"\end{array}"

    def __str__(self) -> str:
        return report(self.rows, TerminalStyle(), chosen=self.chosen)

    __repr__ = __str__

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"


def verify(*names: str | Iterable[str], field: RingName | Iterable[RingName] = ()) -> Report:
    """Decide claims of the thesis and show the table, with the errata.

    ``names`` are ids, names or numbers, or lists of them (by default all claims). ``field`` is a field, its
    name, several names separated by commas, or a list of these (by default the whole panel).

    >>> [row.as_printed.verdict for row in verify("centre", field="GF4,QQ").rows]
    ['proved', 'proved']

    Raises :class:`hfield.errors.HFieldError` for claims or fields that do not exist.
    """
    selected = [name for one in names for name in ([one] if isinstance(one, str | Ring) else one)]
    chosen = [claim for name in selected for claim in find_all(name)]
    fields = split_columns(field)
    pieces = rows_to_decide(chosen or claims(), fields, strict=bool(chosen))
    return Report(tuple(decide_rows(pieces, InProcess())), bool(chosen))
