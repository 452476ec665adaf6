"""How large the group of an order is, and how many elliptic points and cusps it has, by formulas over ℚ."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import prod

from flint import fmpz

from hfield.core.factorisation import factorise
from hfield.orders.invariants import eichler_symbol, is_eichler
from hfield.orders.linear_algebra_mod_p import kronecker
from hfield.orders.z_order import ZOrder


def area(order: ZOrder) -> Fraction:
    """Return the area of the plane modulo the units of norm 1, in units of 2π.

    Shimizu's formula, φ(D)·ψ(N)/6 for Eichler orders; for others by the local index of the units, divided
    by that of their norms (Voight, theorem 39.1.8 and lemma 26.6.7).
    """
    found = Fraction(order.discriminant, 6)
    for p in factorise(order.discriminant):
        symbol = eichler_symbol(order, p)
        assert symbol is not None
        found *= (1 - Fraction(1, p * p)) / (1 - Fraction(symbol, p))
        if symbol == 0:
            found /= _norm_index(order, p)
    return found


def _norm_index(order: ZOrder, p: int) -> int:
    """Return the index of the norms of local units in the units of ℤₚ, where the residue ring is 𝔽ₚ."""
    if p > 2:
        return 2  # modulo p the norm is a square
    norms = {order.trace_and_norm(x)[1] % 8 for x in product(range(8), repeat=4)}
    return 4 // len(norms & {1, 3, 5, 7})


def elliptic_points(order: ZOrder) -> dict[int, int] | None:
    """Return how many elliptic points there are of each order; None for an order that is not Eichler.

    They are counted by optimal embeddings of ℤ[i] or ℤ[ω] into an Eichler order (Voight, section 39.4).
    """
    if not is_eichler(order):
        return None
    D, level = order.ambient.discriminant, order.level
    return {
        m: prod(1 - kronecker(d, p) for p in factorise(D))
        * prod(1 + kronecker(d, q) for q in factorise(level))
        for m, d in ((2, -4), (3, -3))
        if level % (m * m)
    }


def cusps(order: ZOrder) -> int | None:
    """Return how many cusps there are; None for an order in M₂(ℚ) that is not Eichler."""
    if order.ambient.discriminant > 1:
        return 0
    if not is_eichler(order):
        return None
    # Σ φ(gcd(d, N/d)) over the divisors d of the level
    return prod(
        sum(int(fmpz(p ** min(k, e - k)).euler_phi()) for k in range(e + 1))
        for p, e in factorise(order.level).items()
    )


def is_hyperbolic_trace(order: ZOrder, t: int) -> bool:
    """Tell whether an Eichler order has a unit of norm 1 with the trace t, |t| > 2.

    By strong approximation it does where ℤ[x]/(x² − tx + 1) embeds locally: no prime of D splits in its
    field, and the polynomial has a root modulo N (Voight, theorems 28.5.5 and 30.6.16).
    """
    d = t * t - 4
    for p in factorise(order.ambient.discriminant):
        e, rest = 0, d
        while rest % (p * p) == 0:
            e, rest = e + 1, rest // (p * p)
        if p == 2 and e and rest % 4 != 1:
            rest *= 4
        if kronecker(rest, p) == 1:
            return False
    return all(
        any((x * x - t * x + 1) % p**e == 0 for x in range(p**e))
        for p, e in factorise(order.level).items()
    )
