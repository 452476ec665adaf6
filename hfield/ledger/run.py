"""Decide claims × fields with an executor, and find contradictions among the results."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor

from hfield.checker.glossary import GAVE_UP
from hfield.core.executors import collecting_rarely, unordered
from hfield.errors import HFieldError
from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Claim, Row, decide
from hfield.ledger.registry import claims, find
from hfield.prover.decision import PROVED, REFUTED, UNDECIDED, VACUOUS, Decision

Piece = tuple[Claim, str]
Verdicts = tuple[Decision, Decision | None]
Progress = Callable[[int, int, str], None]
TASKS = 48  # enough for progress and even shares
MIN_ROWS_PER_TASK = 6  # rows a task, which have to outweigh its journey


def decide_rows(
    pieces: Sequence[Piece], executor: Executor, progress: Progress | None = None
) -> list[Row]:
    """Decide every piece (a claim and the name of a field), in the given order.

    The work is divided by claim, so that a general proof of a claim is found once and transferred to the
    fields by the same worker. ``progress`` is called with the number of finished rows, their total, and the
    current claim.
    """
    chunks = _chunks(pieces)
    known = set(map(id, claims()))  # every process has these: their ids suffice
    sent = [(claim.id if id(claim) in known else claim, field) for claim, field in pieces]
    tasks = [tuple(sent[n] for n in indices) for indices in chunks]
    decided: dict[int, Verdicts] = {}
    for number, verdicts in unordered(executor, _decide_chunk, tasks):
        indices = chunks[number]
        decided.update(zip(indices, verdicts, strict=True))
        if progress:
            progress(len(decided), len(pieces), pieces[indices[-1]][0].id)
    return [Row(claim, field, *decided[n]) for n, (claim, field) in enumerate(pieces)]


def _chunks(pieces: Sequence[Piece]) -> list[range]:
    """Return the indices of the pieces in groups, beginning with claims that are computed without a field.

    These take longest, and long tasks must not come last, when the other workers have nothing to do. A group
    ends where a claim ends, unless it would exceed twice the group length.
    """
    size = max(MIN_ROWS_PER_TASK, -(-len(pieces) // TASKS))
    runs, start = [], 0
    for m in range(1, len(pieces) + 1):
        ends = m == len(pieces) or pieces[m][0] is not pieces[m - 1][0]
        if m == len(pieces) or m - start >= (size if ends else 2 * size):
            runs.append(range(start, m))
            start = m
    return sorted(runs, key=lambda run: all(pieces[n][1] != NO_FIELD for n in run))


def _decide_chunk(task: Sequence[tuple[str | Claim, str]]) -> list[Verdicts]:
    """Decide some rows; the decisions are plain data."""
    with collecting_rarely():  # in every process that works for one
        rows = (decide_row(find(x) if isinstance(x, str) else x, field) for x, field in task)
        return [(row.as_printed, row.as_corrected) for row in rows]


def decide_row(claim: Claim, field: str) -> Row:
    """Decide one claim over one field; an undecided result includes the reason."""
    try:
        return decide(claim, field)
    except HFieldError as error:
        return Row(claim, field, Decision(UNDECIDED, GAVE_UP, tried=(str(error),)), None)


def contradictions(rows: Sequence[Row]) -> list[str]:
    """Return contradictions: a claim proved in general but refuted over one field, or a refuted
    correction.
    """
    everywhere = {row.claim.id: row for row in rows if row.field == UNIVERSAL}
    fields = {name for name in {row.field for row in rows} if _is_field(name)}
    found: dict[str, list[str]] = {}
    for row in rows:
        if row.as_corrected is not None and row.as_corrected.verdict == REFUTED:
            found.setdefault(f"{row.claim.id}: its correction is refuted", []).append(row.field)
        universal = everywhere.get(row.claim.id)
        if universal is None or row.field not in fields:
            continue
        pairs = {
            "printed": (universal.as_printed, row.as_printed),
            "corrected": (universal.as_corrected, row.as_corrected),
        }
        for kind, (general, special) in pairs.items():
            if general is None or special is None or special.verdict != REFUTED:
                continue
            if general.verdict in (PROVED, VACUOUS):
                scope = f" (over {general.scope})" if general.scope else ""
                text = f"{row.claim.id} as {kind}: {general.verdict} in general{scope}, but refuted"
                found.setdefault(text, []).append(row.field)
    return [f"{text} over {', '.join(fields)}" for text, fields in found.items()]


def as_expected(rows: Sequence[Row]) -> bool:
    """Return whether every row has a verdict, there are no contradictions, and every correction holds."""
    return all(row.settled for row in rows) and not contradictions(rows)


def _is_field(name: str) -> bool:
    from hfield.fields.names import ring

    return name not in (UNIVERSAL, NO_FIELD) and bool(ring(name).is_field)
