"""Recognise sums of squares, and polynomials without roots in a field."""

from __future__ import annotations

from collections.abc import Sequence
from math import isqrt
from typing import TYPE_CHECKING

from hfield.fields.base.powers import power
from hfield.fields.base.ring import Ring
from hfield.prover.evaluation.scalars import constant
from hfield.prover.polynomials.field_rules import Rule

if TYPE_CHECKING:
    import flint


MAX_DEGREE = 16


def as_squares(f: flint.fmpz_mpoly, rule: Rule) -> list[tuple[int, flint.fmpz_mpoly]] | None:
    """Write f, up to its sign, as Σ c·m² with monomials m to which the rule applies, or None."""
    terms = [(tuple(map(int, m)), int(c)) for m, c in f.terms()]
    if not 1 <= len(terms) <= rule.most or any(e % 2 for m, _ in terms for e in m):
        return None
    if all(e == 0 for m, _ in terms for e in m):
        return None
    sign = 1 if terms[0][1] > 0 else -1
    if any(c * sign < 0 for _, c in terms):
        return None
    context = f.context()
    out = []
    for m, c in terms:
        half = context.from_dict({tuple(e // 2 for e in m): 1})
        root = isqrt(c * sign)
        if root * root == c * sign:
            out.append((1, root * half))
        elif rule.positive:
            out.append((c * sign, half))
        else:
            return None
    return out


def has_no_root(f: flint.fmpz_mpoly, variables: Sequence[str], unknowns: int, field: Ring) -> bool:
    """Return whether f is a polynomial in one unknown that provably has no root in the field.

    The variables from ``unknowns`` on that ``variables`` names are constants of the field; any further ones
    are unknowns.
    """
    degrees = [int(d) for d in f.degrees()]
    known = slice(unknowns, len(variables))
    free = degrees[:unknowns] + degrees[len(variables) :]
    degree = max(free, default=0)
    if sum(map(bool, free)) != 1 or not 2 <= degree <= MAX_DEGREE:
        return False
    c = [field.zero] * (degree + 1)
    for exponents, coefficient in f.terms():
        value = field(int(coefficient))
        for text, n in zip(variables[known], exponents[known], strict=True):
            value = value * power(field.one, constant(field, text), n)
        at = sum(exponents) - sum(exponents[known])
        c[at] = c[at] + value
    return field.is_rootless(c)


def polynomial_text(polynomial: flint.fmpz_mpoly, names: Sequence[str]) -> str:
    """Write a polynomial in the grammar of statements, such as ``p[0]*q[1]**2 - 2``."""
    terms = []
    for exponents, coefficient in polynomial.terms():
        c = int(coefficient)
        powers = [
            name if e == 1 else f"{name}**{int(e)}"
            for name, e in zip(names, exponents, strict=False)
            if e
        ]
        if abs(c) != 1 or not powers:
            powers.insert(0, str(abs(c)))
        terms.append(("-" if c < 0 else "+", "*".join(powers)))
    if not terms:
        return "0"
    head = ("-" if terms[0][0] == "-" else "") + terms[0][1]
    return head + "".join(f" {sign} {body}" for sign, body in terms[1:])
