"""The errata: what the thesis prints, where and why it fails, the smallest witness, the correction."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from hfield.errors import HFieldError
from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Claim, Row
from hfield.ledger.columns import name_fields, panel_order
from hfield.notation import element_text
from hfield.proving.decision import REFUTED
from hfield.rings import ring

STATED_FIELD = "F"  # the key of a witness that names the field it lives in


@dataclass(frozen=True)
class Erratum:
    """One claim that is refuted somewhere: its rows, and what follows from them."""

    claim: Claim
    rows: tuple[Row, ...]

    @property
    def refuted(self) -> list[Row]:
        """The rows in which the print is refuted."""
        return [row for row in self.rows if row.as_printed.verdict == REFUTED]

    @property
    def telling(self) -> Row:
        """The refuted row with the smallest witness: fewest nonzero values, then shortest text."""
        return min(self.refuted, key=_size)

    @property
    def reason(self) -> str:
        """Why the print fails: the note of the claim, else the last step of its refutation."""
        steps = self.telling.as_printed.steps
        return self.claim.note or (steps[-1].strip() if steps else "")

    @property
    def witness(self) -> str:
        """The smallest witness with its field, or nothing for a statement without unknowns."""
        row = self.telling
        shown = witness_text(row.as_printed.witness, row.field)
        field = _home(row.as_printed.witness, row.field)
        return f"{shown} over {field}" if shown and field else shown

    def outcome(self, corrected: bool = False) -> list[tuple[str, str]]:
        """Return pairs (verdict, the columns that share it), for the print or its correction."""
        columns: dict[str, list[str]] = {}
        for row in self.refuted if corrected else self.rows:
            decision = row.as_corrected if corrected else row.as_printed
            if decision is not None:
                columns.setdefault(decision.verdict, []).append(row.field)
        every = [row.field for row in self.rows]
        return [(verdict, name_fields(fields, every)) for verdict, fields in columns.items()]


def errata(rows: Sequence[Row]) -> list[Erratum]:
    """Return the claims that are refuted in some row, in the order of the ledger."""
    by_claim: dict[str, list[Row]] = {}
    for row in rows:
        by_claim.setdefault(row.claim.id, []).append(row)
    found = (Erratum(group[0].claim, tuple(group)) for group in by_claim.values())
    return [erratum for erratum in found if erratum.refuted]


def witness_text(witness: Mapping[str, Sequence[str]] | None, field: str) -> str:
    """Write a witness in one line with quaternions as elements: ``p = i, q = 1 + j``."""
    home = _home(witness, field)
    parts = [
        f"{name} = {_value(values, home)}"
        for name, values in (witness or {}).items()
        if name != STATED_FIELD
    ]
    return ", ".join(parts) or ("F = " + home if witness and home else "")


def _home(witness: Mapping[str, Sequence[str]] | None, field: str) -> str:
    """Return the field in which the values of a witness live; none for a claim about no field."""
    if witness and STATED_FIELD in witness:
        return witness[STATED_FIELD][0]
    return "" if field in (UNIVERSAL, NO_FIELD) else field


def _value(values: Sequence[str], home: str) -> str:
    if home and len(values) == 4:
        try:
            F = ring(home)
            return element_text(F, [F(text) for text in values], "unicode", "e")
        except HFieldError:  # values of another kind than coordinates are shown as they are
            return f"({', '.join(values)})"
    return values[0] if len(values) == 1 else f"({', '.join(values)})"


def _size(row: Row) -> tuple[int, int, int, int]:
    """Order refuted rows by how telling their witness is."""
    witness = row.as_printed.witness
    texts = [text for values in (witness or {}).values() for text in values]
    general = row.field == UNIVERSAL or witness is None
    nonzero = sum(text != "0" for text in texts)
    return int(general), nonzero, sum(map(len, texts)), panel_order(row.field)
