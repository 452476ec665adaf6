"""The errata: what the thesis prints, where and why it fails, the smallest witness, the correction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Claim, Row, by_claim
from hfield.ledger.columns import panel_order
from hfield.ledger.decision_lines import worked_out
from hfield.ledger.wording import STATED_FIELD, name_fields, pretty, witness_text
from hfield.prover.decision import REFUTED


@dataclass(frozen=True)
class Erratum:
    """One claim that is refuted over some field: its rows and the correction."""

    claim: Claim
    rows: tuple[Row, ...]

    @cached_property
    def refuted(self) -> list[Row]:
        """The rows in which the printed claim is refuted."""
        return [row for row in self.rows if row.as_printed.verdict == REFUTED]

    @cached_property
    def telling(self) -> Row:
        """The refuted row with the smallest witness: fewest nonzero values, then shortest text."""
        return min(self.refuted, key=_size)

    @property
    def witness(self) -> str:
        """The smallest witness with its field; nothing for a statement without unknowns."""
        witness, field = self.telling.as_printed.witness, self.telling.field
        shown = witness_text(witness, field)
        stated = not witness or STATED_FIELD in witness or field in (UNIVERSAL, NO_FIELD)
        return shown if stated else f"{shown} over {field}"

    @property
    def failures(self) -> list[str]:
        """The failing comparisons at the witness; for a claim in words, the last step."""
        decision, printed = self.telling.as_printed, self.claim.as_printed
        text = printed.text if printed else ""
        return worked_out(text, decision.witness, self.telling.field) or [
            step.strip() for step in decision.steps[-1:]
        ]

    @property
    def lines(self) -> list[tuple[str, str]]:
        """The erratum as pairs of a label and a text."""
        claim, (first, *rest) = self.claim, self._outcome(corrected=False)
        lines = [("claim", claim.statement)] if claim.statement != claim.printed else []
        lines += [("prints", claim.quotation)] if claim.printed not in ("", "—") else []
        lines.append(("refuted", first.removeprefix("refuted ")))
        lines += [("elsewhere", "; ".join(rest))] if rest else []
        lines += [("why", claim.note)] if claim.note else []
        lines += [("witness", self.witness)] if self.witness else []
        lines += [("" if n else "there", text) for n, text in enumerate(self.failures)]
        if claim.corrected:
            lines.append(("corrected", pretty(claim.corrected.text)))
            lines.append(("", "; ".join(self._outcome(corrected=True))))
        return lines

    def _outcome(self, corrected: bool) -> list[str]:
        """Return each verdict with the columns that have it, ``refuted`` first."""
        rows = self.refuted if corrected else self.rows
        columns: dict[str, list[str]] = {}
        for row in rows:
            decision = row.as_corrected if corrected else row.as_printed
            if decision is not None:
                columns.setdefault(decision.verdict, []).append(row.field)
        if corrected and len(columns) == 1 and len(self.refuted) > 1:
            return [f"{verdict} over the same columns" for verdict in columns]
        every = [row.field for row in self.rows]
        return [
            f"{verdict.replace('-', ' ')} "
            + ("as it stands" if fields == [NO_FIELD] else f"over {name_fields(fields, every)}")
            for verdict, fields in sorted(columns.items(), key=lambda item: item[0] != REFUTED)
        ]


def errata(rows: Sequence[Row]) -> list[Erratum]:
    """Return the claims that are refuted in some row, in the order of the ledger."""
    found = (Erratum(group[0].claim, tuple(group)) for group in by_claim(rows))
    return [erratum for erratum in found if erratum.refuted]


def _size(row: Row) -> tuple[int, int, int, int]:
    """Return a sort key of refuted rows: the size of the witness."""
    witness = row.as_printed.witness
    texts = [text for values in (witness or {}).values() for text in values]
    general = row.field == UNIVERSAL or witness is None
    nonzero = sum(text != "0" for text in texts)
    return int(general), nonzero, sum(map(len, texts)), panel_order(row.field)
