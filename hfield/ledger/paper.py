r"""Decisions, claims and reports as LaTeX for papers: formulas, steps, witnesses, scopes.

The results are for a document with amsmath, amssymb and longtable, such as that of
:func:`hfield.latex.document`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from hfield.errors import NotationError, shorten
from hfield.fields.base.latex_names import latex_name
from hfield.latex import enumeration, long_table, words
from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Claim, Row
from hfield.ledger.claims_table import LATEX_MARKS, marked
from hfield.ledger.decision_lines import scope_text, worked_out
from hfield.ledger.errata import Erratum, errata
from hfield.ledger.report import totals
from hfield.ledger.wording import witness_text
from hfield.prover.decision import NOT_APPLICABLE, REFUTED, VERDICTS, Decision
from hfield.prover.statements.printing import to_latex
from hfield.prover.statements.trees import conjuncts
from hfield.syntax import parse

MAX_STEPS, MAX_LETTERS = 12, 600  # of one proof; its certificate contains all of them
MAX_INLINE_LENGTH = 60  # letters of a statement on a line of its own


def statement(text: str) -> str:
    """Typeset a statement: a short one as a display, a long one broken over lines; words as words."""
    try:
        parts = [to_latex(part) for part in conjuncts(parse(text))]
    except NotationError:
        return rf"\begin{{quote}}{words(text)}\end{{quote}}"
    if len(parts) == 1 and len(text) <= MAX_INLINE_LENGTH:
        return rf"\[ {parts[0]} \]"
    # TeX breaks no line between \left and \right.
    flat = (part.replace(r"\left", "").replace(r"\right", "") for part in parts)
    return (
        "\\begin{quote}\\raggedright\n"
        + ", \\\\\n".join(f"${part}$" for part in flat)
        + "\n\\end{quote}"
    )


def decision(text: str, decided: Decision, field: str, algebra: str | None = None) -> str:
    """Typeset a statement, its verdict with method and scope, the evaluated witness, and the steps."""
    parts = [statement(text), rf"\noindent {_verdict(decided, field, algebra)}"]
    witness = witness_text(decided.witness, field)
    if witness:
        there = (
            worked_out(text, decided.witness, field, algebra) if decided.verdict == REFUTED else []
        )
        shown = f"{words(witness)}" + (f"; there {words('; '.join(there))}" if there else "")
        parts.append(rf"\noindent\emph{{Witness.}} {shown}.")
    steps = [words(shorten(step.strip(), MAX_LETTERS)) for step in decided.steps]
    if len(steps) > MAX_STEPS:
        steps = [*steps[: MAX_STEPS - 1], rf"\ldots{{}} and {len(steps) - MAX_STEPS + 1} more"]
    parts.append(enumeration(steps))
    parts += [rf"\noindent\emph{{Cited.}} {words(theorem)}." for theorem in decided.assumes]
    parts += [rf"\noindent\emph{{Tried.}} {words(attempt)}." for attempt in decided.tried]
    return "\n\n".join(filter(None, parts))


def _verdict(decided: Decision, field: str, algebra: str | None) -> str:
    where = {UNIVERSAL: "", NO_FIELD: ""}.get(field, f" over ${latex_name(field)}$")
    inside = f" in the algebra ${latex_name(algebra)}$" if algebra else ""
    word = decided.verdict.replace("-", " ").capitalize()
    if decided.verdict == NOT_APPLICABLE:
        return rf"\textbf{{{word}}}{where}."
    return rf"\textbf{{{word}}}{where}{inside}, by {words(decided.method + scope_text(decided))}."


def explanation(row: Row) -> str:
    """Typeset a row of the ledger in full: the claim, its decision, and that of its correction."""
    claim = row.claim
    parts = [rf"\paragraph{{{words(claim.id)} {words(claim.name)}}} {words(claim.statement)}."]
    if claim.printed not in ("", "—"):
        parts.append(rf"\noindent\emph{{Printed.}} {words(claim.quotation)}")
    if claim.note:
        parts.append(rf"\noindent\emph{{Remark.}} {words(claim.note)}")
    if claim.as_printed is None:
        parts.append(rf"\noindent {_verdict(row.as_printed, row.field, None)}")
    else:
        parts.append(decision(claim.as_printed.text, row.as_printed, row.field))
    if row.as_corrected is not None and claim.corrected:
        parts += [
            r"\noindent\emph{Corrected.}",
            decision(claim.corrected.text, row.as_corrected, row.field),
        ]
    return "\n\n".join(parts)


def marks(rows: Sequence[Row]) -> str:
    """Typeset the claims × fields table of symbols, with their meaning below."""
    fields, lines = marked(rows, {v: f"${mark}$" for v, mark in LATEX_MARKS.items()})
    head = ["", *(rf"\scriptsize${_head(field)}$" for field in fields)]
    body = ([words(claim.id), *own] for claim, own in lines)
    legend = ", ".join(f"${LATEX_MARKS[v]}$ {v.replace('-', ' ')}" for v in VERDICTS)
    table = long_table(f"l{'c' * len(fields)}", head, body)
    return rf"{{\small\setlength{{\tabcolsep}}{{2pt}}{table}}}" + f"\n\n\\noindent {legend}."


def _head(field: str) -> str:
    return {NO_FIELD: "-", UNIVERSAL: r"\forall"}.get(field) or latex_name(field)


def slips(rows: Sequence[Row]) -> str:
    """Typeset the errata; nothing if there are none."""
    return "\n\n".join(map(_erratum, errata(rows)))


def _erratum(erratum: Erratum) -> str:
    claim = erratum.claim
    lines = [rf"\paragraph{{{words(claim.id)} {words(claim.name)}}} ({words(claim.kind)})"]
    pairs = [(label, text) for label, text in erratum.lines if label != "corrected"]
    if claim.corrected:  # the line of its verdicts comes last
        *pairs, last = pairs
    lines += [rf"\noindent\emph{{{label or 'and'}}}: {words(text)}" for label, text in pairs]
    if claim.corrected:
        lines += [r"\noindent\emph{corrected}:", statement(claim.corrected.text), words(last[1])]
    return "\n\n".join(lines)


def report(rows: Sequence[Row], everything: bool = False) -> str:
    """Typeset the report of ``hfield verify``: symbols, totals, errata; with ``everything`` each row."""
    parts = [r"\section*{Claims, as printed}", marks(rows), words(totals(rows))]
    shown = slips(rows)
    if shown:
        parts += [r"\section*{Errata}", shown]
    if everything:
        parts += [r"\section*{Every decision}", *map(explanation, rows)]
    return "\n\n".join(parts)


def claims(chosen: Iterable[Claim]) -> str:
    """Typeset a list of claims: id, name, kind and statement."""
    body = ([words(c.id), words(c.name), words(c.kind), words(c.statement)] for c in chosen)
    head = ("claim", "name", "kind", "statement")
    columns = "lp{32mm}p{22mm}p{78mm}"
    return rf"{{\small {long_table(columns, head, body)}}}"
