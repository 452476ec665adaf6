"""The level of a number field, and −1 as a sum of few squares of small numbers."""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING

from hfield.core.factorisation import factorise
from hfield.fields.base.ring import INFINITY, Fact
from hfield.fields.number_fields.integers import small_integer
from hfield.fields.rationals.squares import minus_one

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ring import NumberField

SEARCHED = 6_000  # elements x tried for −1 = x² + y², fewer in degree 16 and more


def level(field: NumberField) -> Fact:
    """Return ∞ if there is a real place; else 1, 2 or 4, where 4 requires an odd local degree above 2."""
    if field.signature[0]:
        return Fact(INFINITY, f"{field.name} has a real place, so it has an ordering")
    squares = field.minus_one_as_squares()
    if len(squares) == 1:
        return field.level_of(squares)
    odd = [P for P in field.primes_above(2) if P.e * P.f % 2]
    fewer = "−1 itself is not a square"
    if odd:
        fewer = f"the completion at {odd[0]} has odd degree over ℚ₂, where fewer squares do not do"
    if squares:
        return field.level_of(squares, fewer)
    if odd:
        return Fact(4, fewer)
    return Fact(2, "every completion above 2 has even degree over ℚ₂ (Hasse and Minkowski)")


def minus_one_as_squares(field: NumberField) -> tuple[FieldElement, ...]:
    """Return numbers whose squares add up to −1, as many as the level, if small ones exist; else ()."""
    if field.signature[0]:
        return ()
    root = field.sqrt(field(-1))
    if root is not None:
        return (root,)
    odd = any(P.e * P.f % 2 for P in field.primes_above(2))
    for m in _divisors(field.discriminant()):
        if odd or m % 8 != 7:
            root = field.sqrt(field(-m))
            if root is not None:
                return tuple(map(field, minus_one(m, root)))
    others, rng = (3 if odd else 1), Random(1)
    for trial in range(SEARCHED // others // max(1, field.degree // 8) ** 3):
        chosen = [small_integer(field, 1 + trial // 2000, rng) for _ in range(others)]
        below = small_integer(field, 1, rng) if trial > 500 else field.one
        y = field.sqrt(sum((-x * x for x in chosen), -below * below)) if below else None
        if y is not None:
            return tuple(field.divide(x, below) for x in (*chosen, y))
    return ()


def _divisors(n: int) -> list[int]:
    """Return the products, other than 1, of distinct numbers among the six smallest of 2 and the
    primes of n.
    """
    out = [1]
    for p in sorted({2, *factorise(n)})[:6]:
        out += [p * m for m in out]
    return sorted(out)[1:]
