"""Decide when an integer polynomial is 0 over a ring, as a polynomial or as a function."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, ParamSpec

from hfield.core.factorisation import factor
from hfield.core.product import Scalar
from hfield.errors import UndecidedError
from hfield.fields.base.powers import power
from hfield.fields.base.ring import Ring
from hfield.prover.evaluation.scalars import constant, some_nonzero
from hfield.prover.polynomials.expansion import Expanded

if TYPE_CHECKING:
    import flint


Monomial = tuple[int, ...]
P = ParamSpec("P")


def content(polynomial: flint.fmpz_mpoly) -> int:
    """Return the gcd of the coefficients, 0 for the polynomial 0."""
    return int(polynomial.content()) if polynomial != 0 else 0


def known(question: Callable[P, bool], *args: P.args, **kwargs: P.kwargs) -> bool | None:
    """Return the answer to a question, or None if it is not decided."""
    try:
        return question(*args, **kwargs)
    except UndecidedError:
        return None


def vanishes(polynomial: flint.fmpz_mpoly, x: Expanded, field: Ring) -> bool:
    """Return whether all coefficients are 0 in the ring, after substituting the constants of the field.

    Raises :class:`UndecidedError` if it is not known whether some coefficient is 0 and no coefficient is
    known to be nonzero.
    """
    if polynomial == 0:
        return True
    p = field.characteristic
    if p and content(polynomial) % p == 0:
        return True
    return x.has_constants and not some_nonzero(field, _collected(polynomial, x, field).values())


def is_nonzero_constant(polynomial: flint.fmpz_mpoly, x: Expanded, field: Ring) -> bool:
    """Return whether the polynomial contains no unknown and has a nonzero value, with constants
    substituted.
    """
    if any(polynomial.degrees()[: x.unknowns]):
        return False
    return not vanishes(polynomial, x, field)


def vanishes_as_function(polynomial: flint.fmpz_mpoly, x: Expanded, field: Ring) -> bool:
    """Return whether the polynomial is 0 as a function over a field.

    Over an infinite field only the polynomial 0 vanishes. Over GF(q) exponents are first reduced by ``x^q =
    x``; after that, too, only 0 vanishes.
    """
    if vanishes(polynomial, x, field):
        return True
    if field.order is None or max(polynomial.degrees(), default=0) < field.order:
        return False
    return not some_nonzero(field, _collected(polynomial, x, field, field.order).values())


def coefficients(
    polynomial: flint.fmpz_mpoly, x: Expanded, field: Ring, order: int | None = None
) -> Mapping[Monomial, Scalar]:
    """Return the nonzero coefficients in the ring, by exponents of the unknowns.

    With ``order`` q the exponents are reduced by ``x^q = x``. Raises :class:`UndecidedError` if a coefficient
    may be 0.
    """
    found = _collected(polynomial, x, field, order)
    return {m: c for m, c in found.items() if not field.is_zero(c)}


def _collected(
    polynomial: flint.fmpz_mpoly, x: Expanded, field: Ring, order: int | None = None
) -> Mapping[Monomial, Scalar]:
    """Return all coefficients, some of which may be 0."""
    out: dict[Monomial, Scalar] = defaultdict(lambda: field.zero)
    for exponents, coefficient in polynomial.terms():
        monomial = exponents[: x.unknowns]
        if order is not None:
            monomial = tuple((n - 1) % (order - 1) + 1 if n else 0 for n in monomial)
        value = field(int(coefficient))
        for text, n in zip(x.variables[x.unknowns :], exponents[x.unknowns :], strict=True):
            if n:
                value = value * power(field.one, constant(field, text), n)
        out[monomial] = out[monomial] + value
    return out


def collected(f: flint.fmpz_mpoly, variables: Iterable[int]) -> dict[Monomial, flint.fmpz_mpoly]:
    """Return the coefficients of f as a polynomial in some of its variables, by exponents of these."""
    parts: dict[Monomial, dict[Monomial, int]] = {}
    chosen = frozenset(variables)
    for exponents, c in f.terms():
        m = tuple(map(int, exponents))
        own = tuple([e if n in chosen else 0 for n, e in enumerate(m)])
        rest = tuple([0 if n in chosen else e for n, e in enumerate(m)])
        parts.setdefault(own, {})[rest] = int(c)
    return {m: f.context().from_dict(part) for m, part in parts.items()}


def value_at(f: flint.fmpz_mpoly, values: Mapping[int, Scalar], field: Ring) -> Scalar:
    """Return the value of a polynomial whose variables are given values by index."""
    total: Scalar = field.zero
    for exponents, c in f.terms():
        term = field(int(c))
        for n, value in values.items():
            if exponents[n]:
                term = term * power(field.one, value, int(exponents[n]))
        total = total + term
    return total


def factored(
    polynomial: flint.fmpz_mpoly, squarefree: bool = False
) -> tuple[int, list[tuple[flint.fmpz_mpoly, int]]]:
    """Return the constant and the factors, with exponents, of a nonzero polynomial.

    If flint fails because a coefficient exceeds a machine word, the polynomial itself is the only factor.
    """
    try:
        number, powers = polynomial.factor_squarefree() if squarefree else polynomial.factor()
    except OverflowError:
        n = int(polynomial.content())
        return n, [(polynomial / n, 1)]
    return int(number), [(g, int(e)) for g, e in powers]


def common_primes(polynomials: list[flint.fmpz_mpoly]) -> list[int] | None:
    """Return the primes that divide all coefficients: the characteristics in which all polynomials vanish.

    None means "all characteristics", or that the gcd is hard to factor.
    """
    g = math.gcd(*map(content, polynomials))
    return prime_factors(g) if g else None


def prime_factors(n: int) -> list[int] | None:
    """Return the primes that divide n ≥ 1, or None if that would take long."""
    found = factor(n)
    return None if found.rest else list(found.primes)
