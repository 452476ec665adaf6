"""The kinds of elements that can be counted: one list for formulas, enumeration, methods and tables.

To add a kind, add a line here, its formulas in ``formulas_finite`` and a field of ``tally.Tally``.
"""

from typing import NamedTuple

from hfield.errors import CoercionError


class CountedKind(NamedTuple):
    """A kind of elements: its name, synonyms, and the scalar parameter, if it has one."""

    name: str
    words: tuple[str, ...] = ()
    needs: str = ""
    """The argument of ``A.count()`` that gives the scalar; empty for a kind without one."""
    label: str = ""
    """The line of a table for a scalar, with {} for the scalar."""
    scalars: tuple[int, ...] = ()
    """The scalars that have a line in a table; empty for all of the ring."""


KINDS = {
    kind.name: kind
    for kind in (
        CountedKind("elements", ("element",)),
        CountedKind("units", ("unit",)),
        CountedKind("norm", needs="norm=0", label="norm {}"),
        CountedKind("nilpotent", ("nilpotents",)),
        CountedKind("idempotent", ("idempotents",)),
        CountedKind("square roots", needs="square=-1", label="square roots of {}", scalars=(1, -1)),
    )
}
_BY_WORD = {word: kind for kind in KINDS.values() for word in (kind.name, *kind.words)}


def counted_kind(word: str) -> CountedKind:
    """Return the kind with a name (singular or plural). Raises :class:`CoercionError` if there is none."""
    kind = _BY_WORD.get(word)
    if kind is None:
        raise CoercionError(f"there is no count of {word!r}: expected one of {', '.join(KINDS)}")
    return kind
