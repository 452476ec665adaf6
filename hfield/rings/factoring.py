"""Polynomials in one variable over fields, as lists of coefficients from low to high: their factors."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from hfield.errors import UndecidedError

if TYPE_CHECKING:
    from hfield.rings.base import Ring


def by_square_roots(ring: Any, coefficients: Sequence[Any]) -> list[list[Any]]:
    """Factor a polynomial of degree 1 or 2, or of degree 4 in x², over a field whose squares are known.

    Raises :class:`UndecidedError` for others, and in characteristic 2 where roots are not computed.
    """
    *c, _ = monic(ring, coefficients)
    one, zero = ring.one, ring.zero
    if len(c) < 2:
        return [[*c, one]] if c else []
    if len(c) == 2 and ring.characteristic == 2 and not ring.is_zero(c[1]):
        roots = ring.roots([*c, one])
        return [[-x, one] for x in roots] or [[*c, one]]
    if len(c) == 2:
        n, p = c
        if ring.characteristic == 2:
            root = ring.sqrt(n)
            return [[*c, one]] if root is None else [[-root, one]]
        root = ring.sqrt(p * p - ring(4) * n)
        if root is None:
            return [[*c, one]]
        half = ring.inverse(ring(2))
        return distinct(ring, [[(p - root) * half, one], [(p + root) * half, one]])
    if ring.characteristic == 2 or len(c) != 4 or not all(map(ring.is_zero, c[1::2])):
        raise UndecidedError(
            f"a polynomial of degree {len(c)} over {ring.name} is not factored here: over others than number "
            "fields, fields of functions and finite fields, those of degree 2, and of degree 4 in x^2, are"
        )
    squares = by_square_roots(ring, [c[0], c[2], one])
    if all(len(f) == 2 for f in squares):  # (x² − y)·(x² − z)
        return [g for f in squares for g in by_square_roots(ring, [f[0], zero, one])]
    w = ring.sqrt(c[0])
    for product in () if w is None else (w, -w):  # (x² − t·x + w)·(x² + t·x + w)
        t = ring.sqrt(product + product - c[2])
        if t is not None:
            return [[product, -t, one], [product, t, one]]
    return [[*c, one]]


def monic(ring: Ring, coefficients: Sequence[Any]) -> list[Any]:
    """Return the coefficients of a polynomial that is not 0, divided by the last that is not 0."""
    c = list(coefficients)
    while ring.is_zero(c[-1]):
        c.pop()
    back = ring.inverse(c[-1])
    return [x * back for x in c[:-1]] + [ring.one]


def distinct(ring: Ring, factors: list[list[Any]]) -> list[list[Any]]:
    """Return factors without those that come again."""
    found: list[list[Any]] = []
    for f in factors:
        if not any(len(f) == len(g) and all(map(ring.equal, f, g)) for g in found):
            found.append(f)
    return found


def of_flint(ring: Ring, polynomial: Any, read: Callable[[Any], Any]) -> list[list[Any]]:
    """Return the factors that flint finds of a polynomial, their coefficients read by the ring."""
    return [
        monic(ring, [read(factor[n]) for n in range(factor.degree() + 1)])
        for factor, _ in polynomial.factor()[1]
    ]


def divided(ring: Ring, f: Sequence[Any], g: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """Return quotient and remainder, [] for 0, by a polynomial g whose last coefficient is not 0."""
    rest, back = list(f), ring.inverse(g[-1])
    quotient: list[Any] = []
    while len(rest) >= len(g):
        quotient.append(rest[-1] * back)
        for k, x in enumerate(g, len(rest) - len(g)):
            rest[k] = rest[k] - quotient[-1] * x
        rest.pop()
    while rest and ring.is_zero(rest[-1]):
        rest.pop()
    return quotient[::-1], rest


def common_divisor(ring: Ring, f: Sequence[Any], g: Sequence[Any]) -> list[Any]:
    """Return the monic greatest common divisor, [] of two polynomials that are 0."""
    one, two = ([*f], [*g])
    for h in (one, two):
        while h and ring.is_zero(h[-1]):
            h.pop()
    while two:
        one, two = two, divided(ring, one, two)[1]
    return monic(ring, one) if one else []
