"""Compute the area, the elliptic points and the cusps of the group of an order by formulas."""

from __future__ import annotations

from fractions import Fraction
from functools import partial
from math import prod

from flint import fmpz

from hfield.core.factorisation import factorise
from hfield.fields.rationals.whole_numbers import fraction
from hfield.orders import elliptic_points as over_fields
from hfield.orders.invariants import eichler_symbol, is_eichler, level
from hfield.orders.lattice_values import LatticeValue, discriminant
from hfield.orders.linear_algebra_mod_p import kronecker
from hfield.orders.local_squares import is_square_modulo
from hfield.orders.orders_at_primes import OrderAtPrime


def area(order: LatticeValue) -> Fraction:
    """Return the area of the plane modulo the units of norm 1, in units of 2π.

    For Eichler orders over ℤ this is Shimizu's formula φ(D)·ψ(N)/6. For others the local index of the units
    is divided by that of their norms (Voight, theorem 39.1.8 and lemma 26.6.7).
    """
    base, whole = order.ambient.base, discriminant(order)
    found = abs(base.zeta_minus_one) * Fraction(4, 2**base.degree) * base.absolute_norm(whole)
    for P, _ in base.factorisation(whole):
        q, symbol = base.absolute_norm(base.prime_ideal(P)), eichler_symbol(order, P)
        assert symbol is not None
        found *= (1 - Fraction(1, q * q)) / (1 - Fraction(symbol, q))
        if symbol == 0:
            found /= OrderAtPrime(order, P).norm_index()
    return found


def elliptic_points(order: LatticeValue) -> dict[int, int] | None:
    """Return the number of elliptic points of each order; None for an order that is not Eichler.

    Over ℤ they are counted by optimal embeddings of ℤ[i] or ℤ[ω] (Voight, section 39.4).
    """
    base = order.ambient.base
    if not is_eichler(order):
        return None
    if base.degree > 1:
        return over_fields.elliptic_points(order)
    found, primes = {}, base.factorisation(level(order))
    for m, trace in ((2, 0), (3, 1)):
        if base.absolute_norm(level(order)) % (m * m):
            symbol = partial(base.quadratic_symbol, base.inside(trace), base.inside(1))
            found[m] = prod(1 - symbol(P) for P in order.ambient.ramified)
            found[m] *= prod(1 + symbol(P) for P, _ in primes)
    return found


def cusps(order: LatticeValue) -> int | None:
    """Return the number of cusps; None for an order in M₂(ℚ) that is not Eichler."""
    ambient, base = order.ambient, order.ambient.base
    if ambient.ramified or ambient.degree > 1:  # a division algebra
        return 0
    if not is_eichler(order):
        return None
    # Σ φ(gcd(d, N/d)) over the divisors d of the level
    return prod(
        sum(int(fmpz(base.absolute_norm(P) ** min(k, e - k)).euler_phi()) for k in range(e + 1))
        for P, e in ((base.prime_ideal(P), e) for P, e in base.factorisation(level(order)))
    )


def decides_traces(order: LatticeValue) -> bool:
    """Return whether :func:`is_hyperbolic_trace` decides traces: for Eichler orders over ℤ."""
    return order.ambient.base.is_rational and is_eichler(order)


def is_hyperbolic_trace(order: LatticeValue, t: int) -> bool:
    """Return whether an Eichler order has a unit of norm 1 with the trace t, |t| > 2.

    By strong approximation it has one if and only if ℤ[x]/(x² − tx + 1) embeds locally: no prime of D splits
    in its field, and the polynomial has a root modulo N (Voight, theorems 28.5.5 and 30.6.16).
    """
    d = t * t - 4
    for p in factorise(int(fraction(order.ambient.discriminant))):
        e, rest = 0, d
        while rest % (p * p) == 0:
            e, rest = e + 1, rest // (p * p)
        if p == 2 and e and rest % 4 != 1:
            rest *= 4
        if kronecker(rest, p) == 1:
            return False
    return all(
        is_square_modulo(d, p, e + 2 * (p == 2))
        for p, e in factorise(order.ambient.base.absolute_norm(level(order))).items()
    )
