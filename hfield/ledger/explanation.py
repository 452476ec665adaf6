"""One decision in full, as one would put it on a blackboard: ``hfield explain``."""

from __future__ import annotations

from dataclasses import dataclass

from hfield.errors import NotationError
from hfield.latex import words
from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Proposition, Row
from hfield.ledger.columns import split_columns
from hfield.ledger.decision_lines import decision_lines, wrapped
from hfield.ledger.matrix import Style
from hfield.ledger.registry import find
from hfield.ledger.run import decide_row
from hfield.ledger.selection import SelectionError, rows_to_decide
from hfield.ledger.wording import over, pretty, witness_text
from hfield.proving.decision import Decision
from hfield.proving.statements.printing import to_latex
from hfield.proving.statements.trees import conjuncts
from hfield.rings.latex_names import latex_name
from hfield.syntax import parse


@dataclass(frozen=True)
class Explanation:
    """A row of the ledger, told in full; prints itself, and shows as LaTeX in a notebook."""

    row: Row

    def text(self, style: Style | None = None) -> str:
        """Write statement, reading, verdict, steps and witness, then the same of the correction."""
        style = style or Style()
        claim, row = self.row.claim, self.row
        title = f"{claim.id}  {claim.name}"
        lines = [
            style.bold(title),
            f"thesis {claim.section}, {claim.kind}; {over(row.field)}",
            "",
            *wrapped("statement", claim.statement, style),
            *wrapped("printed", claim.printed, style),
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

    def latex(self) -> str:
        """Write statement and verdict as one formula of LaTeX."""
        claim, row = self.row.claim, self.row
        text = claim.as_printed.text if claim.as_printed else claim.statement
        lines = [_formula(text, row.as_printed, row.field)]
        if row.as_corrected is not None and claim.corrected:
            lines.append(_formula(claim.corrected.text, row.as_corrected, row.field))
        body = r" \\ ".join(lines)
        return rf"\begin{{array}}{{ll}} {body} \end{{array}}"

    def to_json(self) -> dict[str, object]:
        """Return all of it as plain data, schema ``hfield-explain/1``."""
        claim, row, corrected = self.row.claim, self.row, self.row.as_corrected
        return {
            "schema": "hfield-explain/1",
            **{
                k: getattr(claim, k)
                for k in ("id", "name", "section", "kind", "statement", "printed")
            },
            "note": claim.note,
            "field": row.field,
            "as_printed": _json(claim.as_printed, row.as_printed),
            "as_corrected": None if corrected is None else _json(claim.corrected, corrected),
        }

    def __str__(self) -> str:
        return self.text()

    __repr__ = __str__

    def _repr_html_(self) -> str:
        from html import escape

        return f"<pre>{escape(str(self))}</pre>"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"


def explain(claim: str, field: str | None = None) -> Explanation:
    """Decide a claim, given by its id or name, over one field (a text; QQ by default), and show each step.

    >>> explain("centre", "GF(4)").row.as_printed.verdict
    'proved'

    Raises :class:`hfield.errors.HFieldError` for a claim or field that does not exist.
    """
    found = find(claim)
    column = split_columns(["QQ" if field is None else field])
    if len(column) > 1:
        raise SelectionError(
            f"one decision is explained at a time; {len(column)} fields were given"
        )
    ((_, name),) = rows_to_decide([found], column, strict=True)
    return Explanation(decide_row(found, name))


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
