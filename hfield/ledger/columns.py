"""The columns of the ledger: reading their names, and short headings."""

from __future__ import annotations

import re
from collections.abc import Iterable

from hfield.fields.base.ring import Ring
from hfield.fields.names import RingName, ring
from hfield.ledger.claim import NO_FIELD, PANEL, UNIVERSAL
from hfield.syntax.brackets import split


def read_column(text: str) -> str:
    """Return the canonical name of a column: a ring in any notation, ``universal`` or ``-``.

    Raises :class:`hfield.errors.RingError` for a field that does not exist.
    """
    word = text.strip()
    return word.lower() if word.lower() in (UNIVERSAL, NO_FIELD) else ring(word).name


def split_columns(fields: RingName | Iterable[RingName]) -> list[str]:
    """Read fields or names of fields, also separated by commas; duplicates are removed."""
    several = isinstance(fields, Iterable) and not isinstance(fields, (Ring, str, type))
    each: Iterable[RingName] = fields if several else [fields]  # type: ignore[assignment]
    texts = (field if isinstance(field, str) else ring(field).name for field in each)
    parts = [part for text in texts for part in split(text, ",")]
    return list(dict.fromkeys(read_column(part) for part in parts))


_LETTERS = [("QQ", "ℚ"), ("ZZ", "ℤ"), ("RR", "ℝ"), ("CC", "ℂ")]
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def head(field: str, ascii_only: bool = False) -> str:
    """Return a short head for a column, such as ``F₉`` or ``ℚ√2``."""
    if field == UNIVERSAL:
        return "all" if ascii_only else "∀"
    text = re.sub(r"\(sqrt\((-?\d+)\)\)", r"V\1" if ascii_only else r"√\1", field)
    text = text.replace("(I)", "(i)")
    text = re.sub(
        r"GF\((\d+)\)",
        lambda m: f"F{m[1]}" if ascii_only else f"F{m[1].translate(_SUBSCRIPTS)}",
        text,
    )
    for plain, letter in _LETTERS:
        text = text.replace(plain, plain[0] if ascii_only else letter)
    return text if ascii_only else text.replace("-", "−") if field != NO_FIELD else text


def panel_order(field: str) -> int:
    """Return the position of a column in the panel; a field outside the panel comes last."""
    return PANEL.index(field) if field in PANEL else len(PANEL)
