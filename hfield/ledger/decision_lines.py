"""One decision in lines of text: verdict, steps, witness, what is assumed; without the ledger's claims."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from dataclasses import replace

from hfield.errors import shorten
from hfield.fields.names import ring
from hfield.ledger.claim import UNIVERSAL
from hfield.ledger.matrix import Style
from hfield.ledger.wording import over, pretty, witness_text
from hfield.presenting import hanging
from hfield.proving.decision import FIELD, NOT_APPLICABLE, REFUTED, Decision, in_characteristics

_MOST = (
    600  # characters of a step; cofactors can fill pages, and JSON and certificates have them whole
)
_LABEL = 12


def decision_text(
    statement: str, decision: Decision, algebra: str, field: str | None, style: Style
) -> str:
    """Write a statement of the language in ``algebra`` and its decision; no field means all."""
    where = "for every F" if field is None else f"{over(field)}, {ring(field).in_words()}"
    place = textwrap.wrap(f"in the algebra {algebra}, {where}", style.width, subsequent_indent="  ")
    lines = [style.bold(pretty(statement)), *place, ""]
    told = decision_lines(statement, decision, field or UNIVERSAL, style, algebra)
    return "\n".join([*lines, *told])


def decision_lines(
    text: str, decision: Decision, field: str, style: Style, algebra: str | None = None
) -> Iterator[str]:
    """Yield verdict, steps, witness and what was assumed or tried, each wrapped beside its label."""
    mark = replace(style, colour=False).mark(decision.verdict)
    verdict = f"{mark} {decision.verdict.replace('-', ' ')}"
    if decision.verdict != NOT_APPLICABLE:
        verdict += f"  (by {decision.method}{scope_text(decision)})"
    first, *rest = wrapped("verdict", verdict, style)
    yield from (first.replace(mark, style.mark(decision.verdict), 1), *rest)
    for n, step in enumerate(decision.steps, 1):
        indent = len(step) - len(step.lstrip())
        told = shorten(step.strip(), _MOST)
        yield from wrapped(f"{n}. ".rjust(_LABEL), told, style, indent=indent)
    witness = witness_text(decision.witness, field)
    if witness:
        yield from wrapped("witness", witness, style)
    if decision.verdict == REFUTED:
        from hfield.ledger.worked_counterexamples import worked_out

        for n, line in enumerate(worked_out(text, decision.witness, field, algebra)):
            yield from wrapped("" if n else "there", line, style)
    for theorem in decision.assumes:
        yield from wrapped("assumes", theorem, style)
    for attempt in decision.tried:
        yield from wrapped("tried", attempt, style)


def scope_text(decision: Decision) -> str:
    """Say where the statement holds, beyond the field it was decided over."""
    scope = decision.scope
    if scope is None or scope == FIELD:
        return ""
    if scope.primes:
        return f"; it holds exactly in {in_characteristics(scope.primes)}"
    return f", over all {scope}"


def wrapped(label: str, text: str, style: Style, indent: int = 0) -> list[str]:
    """Return the label and the text beside it, wrapped to the width of the terminal."""
    return hanging(f"  {label:<{_LABEL}}" + " " * indent, text, style.width)
