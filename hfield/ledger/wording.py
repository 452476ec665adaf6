"""Write statements, witnesses and sets of fields for people."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from hfield.errors import HFieldError, NotationError
from hfield.fields.names import ring
from hfield.ledger.claim import NO_FIELD, UNIVERSAL
from hfield.notation import element_text
from hfield.prover.statements.printing import to_unicode
from hfield.syntax import parse

STATED_FIELD = "F"  # the key of a witness that names the field it lives in


def pretty(text: str) -> str:
    """Write a statement of the language with mathematical signs; words are unchanged.

    >>> pretty("p*q == conj(q)*p**2")
    'p·q = q̄·p²'
    """
    try:
        return to_unicode(parse(text))
    except NotationError:
        return text


def over(field: str) -> str:
    """Return the ring over which a decision was made, in words."""
    named = {UNIVERSAL: "over every commutative ring", NO_FIELD: "about no field in particular"}
    return named.get(field, f"over {field}")


def name_fields(some: Sequence[str], every: Sequence[str]) -> str:
    """Return a text for some of the columns ``every``, in the shortest of three forms.

    >>> name_fields(["QQ", "RR"], ["QQ", "RR", "CC"])
    'QQ, RR'
    """
    rest = [field for field in every if field not in some]
    if len(some) > 1 and not rest:
        return f"all {len(some)} columns"
    if len(some) > 4 and len(rest) <= len(some) / 3:
        return f"all columns but {', '.join(rest)}"
    return ", ".join(some)


def witness_text(witness: Mapping[str, Sequence[str]] | None, field: str) -> str:
    """Write a witness on one line, with four coordinates as an element: ``p = i, q = 1 + j``.

    A witness with its own field names it: ``q = 1 + i over GF(2)``.
    """
    where = "" if field in (UNIVERSAL, NO_FIELD) else field
    if witness and STATED_FIELD in witness:
        where = witness[STATED_FIELD][0]
    parts = [
        f"{name} = {_value(values, where)}"
        for name, values in (witness or {}).items()
        if name != STATED_FIELD
    ]
    if not witness or STATED_FIELD not in witness:
        return ", ".join(parts)
    return f"{', '.join(parts)} over {where}" if parts else f"{STATED_FIELD} = {where}"


def _value(values: Sequence[str], where: str) -> str:
    raw = values[0] if len(values) == 1 else f"({', '.join(values)})"
    if not where or len(values) not in (1, 4):
        return raw
    try:
        F = ring(where)
        read = [F(text) for text in values]
    except HFieldError:  # a witness may hold texts of another kind, such as the name of a set
        return raw
    return F.text(read[0], "unicode") if len(read) == 1 else element_text(F, read, "unicode")
