"""One decision in full, for ``hfield explain``."""

from __future__ import annotations

from dataclasses import dataclass

from hfield.errors import NotationError
from hfield.fields.base.latex_names import latex_name
from hfield.fields.names import RingName
from hfield.latex import words
from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Proposition, Row
from hfield.ledger.claims_table import TerminalStyle
from hfield.ledger.columns import split_columns
from hfield.ledger.decision_lines import decision_lines, wrapped
from hfield.ledger.registry import find_all
from hfield.ledger.run import decide_row
from hfield.ledger.selection import SelectionError, rows_to_decide
from hfield.ledger.wording import over, pretty, witness_text
from hfield.prover.decision import Decision
from hfield.prover.statements.printing import to_latex
from hfield.prover.statements.trees import conjuncts
from hfield.syntax import parse

SCHEMA = "hfield-explain/1"


@dataclass(frozen=True)
class Explanation:
    """Complete rows of the ledger: the row of a claim, or one row for each claim of a section.

    It prints itself, and displays as LaTeX in a notebook. ``row`` is the first row, which is the only one for
    a single claim.
    """

    rows: tuple[Row, ...]

    @property
    def row(self) -> Row:
        """The first row."""
        return self.rows[0]

    def text(self, style: TerminalStyle | None = None) -> str:
        """Write statement, reading, verdict, steps and witness, then the same for the correction."""
        return "\n\n".join(_text(row, style or TerminalStyle()) for row in self.rows)

    def latex(self) -> str:
        """Write statements and verdicts as one formula of LaTeX."""
        body = r" \\ ".join(line for row in self.rows for line in _formulas(row))
        return rf"\begin{{array}}{{ll}} {body} \end{{array}}"

    def to_json(self) -> dict[str, object]:
        """Return everything as plain data, schema ``hfield-explain/1``; for several rows, a list."""
        if len(self.rows) == 1:
            return _data(self.row)
        return {"schema": SCHEMA, "results": [_data(row) for row in self.rows]}

    def __str__(self) -> str:
        return self.text()

    __repr__ = __str__

    def _repr_html_(self) -> str:
        from html import escape

        return f"<pre>{escape(str(self))}</pre>"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"


def explain(claim: str, field: RingName | None = None) -> Explanation:
    """Decide a claim over one field (an object or a name, QQ by default), and show each step.

    ``claim`` is an id, a name or a number in the thesis; the number of a section stands for all its claims.

    >>> explain("centre", "GF(4)").row.as_printed.verdict
    'proved'
    >>> [row.claim.id for row in explain("twierdzenie 3").rows], len(explain("1.3.1", "GF(4)").rows)
    (['C1.3.1-z'], 27)

    Raises :class:`hfield.errors.HFieldError` for a claim or field that does not exist.
    """
    column = split_columns("QQ" if field is None else field)
    if len(column) > 1:
        raise SelectionError(
            f"only one decision is explained at a time; {len(column)} fields were given"
        )
    pieces = rows_to_decide(find_all(claim), column, strict=True)
    return Explanation(tuple(decide_row(found, name) for found, name in pieces))


def _text(row: Row, style: TerminalStyle) -> str:
    claim = row.claim
    title = f"{claim.id}  {claim.name}"
    lines = [
        style.bold(title),
        f"thesis {claim.section}, {claim.kind}; {over(row.field)}",
        "",
        *wrapped("statement", claim.statement, style),
        *wrapped("printed", claim.quotation, style),
    ]
    if claim.as_printed:
        lines += wrapped("read as", pretty(claim.as_printed.text), style)
    if claim.note:
        lines += wrapped("note", claim.note, style)
    text = claim.as_printed.text if claim.as_printed else ""
    lines += ["", *decision_lines(text, row.as_printed, row.field, style)]
    if row.as_corrected is not None and claim.corrected:
        lines += ["", *wrapped("corrected", pretty(claim.corrected.text), style)]
        lines += ["", *decision_lines(claim.corrected.text, row.as_corrected, row.field, style)]
    return "\n".join(lines)


def _formulas(row: Row) -> list[str]:
    claim = row.claim
    text = claim.as_printed.text if claim.as_printed else claim.statement
    lines = [_formula(text, row.as_printed, row.field)]
    if row.as_corrected is not None and claim.corrected:
        lines.append(_formula(claim.corrected.text, row.as_corrected, row.field))
    return lines


def _data(row: Row) -> dict[str, object]:
    claim, corrected = row.claim, row.as_corrected
    return {
        "schema": SCHEMA,
        **{k: getattr(claim, k) for k in ("id", "name", "section", "kind", "statement", "printed")},
        "note": claim.note,
        "field": row.field,
        "as_printed": _json(claim.as_printed, row.as_printed),
        "as_corrected": None if corrected is None else _json(claim.corrected, corrected),
    }


def _formula(text: str, decision: Decision, field: str) -> str:
    try:
        lines = [to_latex(node) for node in conjuncts(parse(text))]
    except NotationError:
        lines = [rf"\text{{{words(text)}}}"]
    symbol = r"\mathbb{Z}[\ldots]" if field == UNIVERSAL else latex_name(field)
    witness = witness_text(decision.witness, field)
    verdict = rf"\text{{{words(decision.verdict + (f': {witness}' if witness else ''))}}}"
    lines[-1] += "" if field == NO_FIELD else rf"\;({symbol})"
    return r" \land \\ ".join(lines) + f" & {verdict}"


def _json(proposition: Proposition | None, decision: Decision) -> dict[str, object]:
    return {
        "text": proposition.text if proposition else None,
        "verdict": decision.verdict,
        "method": decision.method,
        "scope": decision.scope,
        "steps": list(decision.steps),
        "witness": decision.witness,
        "assumes": list(decision.assumes),
        "tried": list(decision.tried),
    }
