"""The order of a unit: the least n > 0 with ``qⁿ = 1``, or a proof that there is none.

q is a root of ``X² − tr(q)·X + N(q)``. Over a domain of characteristic 0 it has finite order if and only if q
itself is a root of unity, or the two roots of this polynomial are distinct roots of unity. A field of bounded
degree has few roots of unity.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import prod
from typing import TYPE_CHECKING

from hfield.algebra.structure.elements.closed_orders import closed_order
from hfield.core.factorisation import factorise
from hfield.core.primality import primes
from hfield.core.product import Constants, Coordinates, Scalar, multiply, norm, trace
from hfield.errors import NotInvertibleError, UndecidedError, shorten
from hfield.fields.base.ring import Ring, WithIntegers
from hfield.fields.quadratic_forms.normal_forms import basis_of

if TYPE_CHECKING:
    pass


SEARCHED_ORDERS = 120
"""Orders up to this are tried over infinite rings of which nothing is known."""


def multiplicative_order(ring: Ring, c: Constants, q: Coordinates) -> int | None:
    """Return the least n > 0 with ``qⁿ = 1``, or None if there is none.

    Raises :class:`NotInvertibleError` if q is not a unit, and :class:`UndecidedError` if the order is
    unknown: for transcendental numbers, over user-defined infinite rings, and if a factorisation is out of
    reach.
    """
    n, t = norm(c, q), trace(c, q)
    if not ring.is_unit(n):
        raise NotInvertibleError("an element without inverse has no order: its norm is not a unit")
    if not ring.is_exact:
        raise UndecidedError(f"orders of units over {ring.name} are not decided: it is inexact")
    if ring.closure is not None:
        scalar = q[0] if all(map(ring.is_zero, q[1:])) else None
        return closed_order(ring, t, n, scalar)
    if ring.constants is not None:
        return _over_constants(ring, ring.constants, q, t, n)
    primes = _exponent(ring)
    if primes is None:
        return _searched(ring, c, q)
    exponent: int = prod(p**k for p, k in primes.items())
    if not _is_one(ring, c, q, exponent):
        return None
    for p in primes:
        while exponent % p == 0 and _is_one(ring, c, q, exponent // p):
            exponent //= p
    return exponent


def _over_constants(ring: Ring, base: Ring, q: Coordinates, t: Scalar, n: Scalar) -> int | None:
    """Return the order over k(x) or k[x, …], where sums and products of roots of unity are constants."""
    values = [ring.as_constant(x) for x in (q[0], t, n)]
    scalar = all(map(ring.is_zero, q[1:]))
    if (values[0] if scalar else values[1]) is None or values[2] is None:
        return None
    o = base.zero
    # in k + k·i with i² = −n + t·i the element i has the trace and norm of q
    element = (values[0], o, o, o) if scalar else (o, base.one, o, o)
    algebra = Constants(o, o, o) if scalar else Constants(o - values[2], values[1], o)
    return multiplicative_order(base, algebra, element)


def _is_one(ring: Ring, c: Constants, q: Coordinates, n: int) -> bool:
    one = basis_of(ring)[0]
    result = one
    for bit in bin(n)[2:]:
        result = multiply(c, result, result)
        if bit == "1":
            result = multiply(c, result, q)
    return all(ring.equal(x, y) for x, y in zip(result, one, strict=True))


def _exponent(ring: Ring) -> Mapping[int, int] | None:
    """Return the prime factors of a multiple of every finite order; None if no such multiple is known.

    Over a number field of degree n, and over ℤ, the multiple covers all roots of unity of degree at most 2n.
    Over a ring of m elements, q generates a ring of at most m² elements. Its residue fields are at most
    quadratic over those of the base ring, and its units that are 1 modulo the radical have orders that divide
    m².
    """
    if ring.order is not None:
        m = int(ring.order)
        if ring.is_field:
            p = ring.characteristic
            return {**_factors_of_power(p, 2 * len(_digits(m - 1, p))), p: 1}
        found: dict[int, int] = {}
        for p, k in factorise(m).items():
            residue = 1 if m == ring.characteristic else k
            parts = [_factors_of_power(p, 2 * f) for f in range(1, residue + 1)]
            for part in [*parts, {p: 2 * k}]:
                found = {
                    r: max(part.get(r, 0), found.get(r, 0)) for r in part.keys() | found.keys()
                }
        return found
    field = ring.fractions or ring
    return orders_of_roots_of_unity(2 * field.degree) if isinstance(field, WithIntegers) else None


def orders_of_roots_of_unity(degree: int) -> dict[int, int]:
    """Return, as {p: exponent}, a common multiple of the orders of all roots of unity of the given degree."""
    orders = {}
    for p in primes(degree + 2):
        k = 0
        while p**k * (p - 1) <= degree:
            k += 1
        orders[p] = k
    return orders


def _digits(n: int, p: int) -> list[int]:
    out = []
    while n:
        n, digit = divmod(n, p)
        out.append(digit)
    return out


def _factors_of_power(p: int, n: int) -> dict[int, int]:
    """Return the prime factors of pⁿ − 1, from values of cyclotomic polynomials."""
    found: dict[int, int] = {}
    for value in _cyclotomic_values(p, n):
        for r, k in factorise(value).items():
            found[r] = found.get(r, 0) + k
    return found


def _cyclotomic_values(p: int, n: int) -> Iterable[int]:
    """Return Φ_d(p) for the divisors d of n; their product is pⁿ − 1."""
    values: dict[int, int] = {}
    for d in (d for d in range(1, n + 1) if n % d == 0):
        values[d] = (p**d - 1) // prod(v for e, v in values.items() if d % e == 0)
    return [v for v in values.values() if v > 1]


def _searched(ring: Ring, c: Constants, q: Coordinates) -> int:
    for n in range(1, SEARCHED_ORDERS + 1):
        if _is_one(ring, c, q, n):
            return int(n)
    raise UndecidedError(
        f"the order over {shorten(ring.name)} is infinite or greater than {SEARCHED_ORDERS}: not decided"
    )
