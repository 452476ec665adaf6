"""The columns of the ledger: reading field names, choosing rows, short heads, sets of fields in words."""

from __future__ import annotations

import re
from collections.abc import Sequence

from hfield.errors import HFieldError, shorten
from hfield.ledger.claim import NO_FIELD, PANEL, UNIVERSAL, Claim
from hfield.ledger.registry import claims
from hfield.notation import split_commas
from hfield.rings import ring


class SelectionError(HFieldError, ValueError):
    """Claims, sections or fields that do not exist or do not go together."""


def read_column(text: str) -> str:
    """Return the name of a column: of a ring in any spelling, ``universal`` or ``-``.

    Raises :class:`hfield.errors.RingError` for a field that does not exist.
    """
    word = text.strip()
    return word.lower() if word.lower() in (UNIVERSAL, NO_FIELD) else ring(word).name


def split_columns(texts: Sequence[str]) -> list[str]:
    """Read field names given one by one or with commas between them; the same one counts once."""
    parts = [part for text in texts for part in split_commas(text)]
    return list(dict.fromkeys(read_column(part) for part in parts))


def in_section(section: str) -> list[Claim]:
    """Return the claims of a section and of its subsections. Raises :class:`SelectionError`."""
    wanted = section.strip().rstrip(".")
    found = [c for c in claims() if f"{c.section}.".startswith(f"{wanted}.")]
    if wanted and found:
        return found
    sections = ", ".join(dict.fromkeys(c.section for c in claims()))
    raise SelectionError(f"there is no section {shorten(section)!r}; there are {sections}")


def rows_to_decide(
    chosen: Sequence[Claim], fields: Sequence[str], strict: bool = False
) -> list[tuple[Claim, str]]:
    """Pair claims with fields; no fields means all columns of each claim.

    A claim about no field has its one row ``-`` and takes no field, another takes no ``-``. With
    ``strict`` (claims named one by one) a claim about no field is given its row whatever field was
    asked for, and a claim about fields refuses ``-`` with :class:`SelectionError`.
    """
    if not fields:
        return [(claim, field) for claim in chosen for field in claim.fields]
    rows = []
    for claim in chosen:
        fits = [field for field in fields if (field == NO_FIELD) == claim.fieldless]
        if strict and not fits and claim.fieldless:
            fits = [NO_FIELD]
        if strict and not fits:
            raise SelectionError(
                f"{claim.id} is about fields and has no row {NO_FIELD!r}; name a field such as QQ"
            )
        rows += [(claim, field) for field in fits]
    if not rows:
        raise SelectionError(f"none of the claims chosen has a row for {', '.join(fields)}")
    return rows


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
    """Return the place of a column in the panel; a field outside it comes last."""
    return PANEL.index(field) if field in PANEL else len(PANEL)
