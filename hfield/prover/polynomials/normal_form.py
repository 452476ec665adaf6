"""Formulas about zeros of polynomials, and their clauses.

A statement over a field becomes a combination by "and" and "or" of two kinds of literals: all polynomials of
a tuple are 0, or some is not 0. Its clauses are then: if all of these polynomials are 0, then one of those
tuples is 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from hfield.errors import TooLargeError

if TYPE_CHECKING:
    import flint


MAX_CLAUSES = 256


@dataclass(frozen=True)
class Literal:
    """A literal: the ``polynomials`` are all 0 (``zero``), or not all of them are 0; ``key`` is
    their text.
    """

    polynomials: tuple[flint.fmpz_mpoly, ...] = field(compare=False)
    zero: bool
    key: tuple[str, ...]


@dataclass(frozen=True)
class Formula:
    """A literal, or ``and``/``or`` of formulas; ``and`` without parts is true, and ``or`` without parts
    false.
    """

    op: str
    parts: tuple[Formula, ...] = ()
    literal: Literal | None = None

    def __and__(self, other: Formula) -> Formula:
        return Formula("and", (self, other))

    def __or__(self, other: Formula) -> Formula:
        return Formula("or", (self, other))

    def __invert__(self) -> Formula:
        if self.literal is not None:
            return literal(self.literal.polynomials, not self.literal.zero)
        return Formula("or" if self.op == "and" else "and", tuple(~f for f in self.parts))


TRUE, FALSE = Formula("and"), Formula("or")


def literal(polynomials: Iterable[flint.fmpz_mpoly], zero: bool) -> Formula:
    """Return the formula "all are 0" or its opposite; trivial ones become true or false."""
    rest = tuple(p for p in polynomials if p != 0)
    if not rest:
        return TRUE if zero else FALSE
    return Formula("literal", (), Literal(rest, zero, tuple(map(str, rest))))


@dataclass(frozen=True)
class PolynomialClause:
    """If all polynomials of ``zeros`` vanish, then so do all polynomials of one of the tuples ``goals``."""

    zeros: tuple[flint.fmpz_mpoly, ...]
    goals: tuple[tuple[flint.fmpz_mpoly, ...], ...]


def clauses(formula: Formula) -> tuple[PolynomialClause, ...]:
    """Return clauses whose conjunction is the formula. Raises TooLargeError for more than 256."""
    return tuple(_clause(c) for c in _conjunction(formula) if not _tautology(c))


def branches(formula: Formula) -> Iterator[tuple[Literal, ...]]:
    """Yield the conjunctions of literals of the disjunctive normal form."""
    for c in _conjunction(~formula):
        if not _tautology(c):
            yield tuple(Literal(x.polynomials, not x.zero, x.key) for x in c)


def _conjunction(f: Formula) -> list[tuple[Literal, ...]]:
    if f.literal is not None:
        return [(f.literal,)]
    if f.op == "and":
        out = [c for part in f.parts for c in _conjunction(part)]
    else:
        out = [()]
        for part in f.parts:
            right = _conjunction(part)
            _bound(len(out) * len(right))
            out = [a + tuple(x for x in b if x not in a) for a in out for b in right]
    _bound(len(out))
    return list(dict.fromkeys(out))


def _bound(count: int) -> None:
    if count > MAX_CLAUSES:
        raise TooLargeError(
            f"the statement has {count} or more clauses, more than the {MAX_CLAUSES} that are tried"
        )


def _tautology(literals: tuple[Literal, ...]) -> bool:
    zeros = {x.key for x in literals if x.zero}
    return any(not x.zero and x.key in zeros for x in literals)


def _clause(literals: tuple[Literal, ...]) -> PolynomialClause:
    zeros: dict[str, flint.fmpz_mpoly] = {}
    for x in literals:
        if not x.zero:
            zeros.update(zip(x.key, x.polynomials, strict=True))
    return PolynomialClause(tuple(zeros.values()), tuple(x.polynomials for x in literals if x.zero))
