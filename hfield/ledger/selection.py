"""Select claims, and their rows, for a run."""

from __future__ import annotations

from collections.abc import Sequence

from hfield.errors import HFieldError, shorten
from hfield.ledger.claim import NO_FIELD, Claim


class SelectionError(HFieldError, ValueError):
    """Claims, sections or fields that do not exist or cannot be combined.

    >>> issubclass(SelectionError, ValueError)
    True
    """


def in_section(section: str, ledger: Sequence[Claim]) -> list[Claim]:
    """Return the claims of a section and of its subsections. Raises :class:`SelectionError`."""
    wanted = section.strip().rstrip(".")
    found = [c for c in ledger if f"{c.section}.".startswith(f"{wanted}.")]
    if wanted and found:
        return found
    sections = ", ".join(dict.fromkeys(c.section for c in ledger))
    raise SelectionError(f"there is no section {shorten(section)!r}; there are {sections}")


def rows_to_decide(
    chosen: Sequence[Claim], fields: Sequence[str], strict: bool = False
) -> list[tuple[Claim, str]]:
    """Pair claims with fields; without fields, with all columns of each claim.

    A claim that is not about a field has a single row ``-`` and no other; a claim about fields has no row
    ``-``. With ``strict`` (claims named one by one) the former gets its row whatever field is given, and the
    latter raises :class:`SelectionError` for ``-``.
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
