"""The order of a unit: the least n > 0 with ``qⁿ = 1``, or the proof that there is none.

q is a root of ``X² − tr(q)·X + N(q)``. Over a domain of characteristic 0 it has finite order exactly when
q is a root of unity itself, or the two roots of this polynomial are different roots of unity: there are few
of them in fields of bounded degree.

Orders of units over the real and the complex numbers.

The roots λ, μ of ``X² − T·X + N`` have degree at most 2d over ℚ if T and N lie in a field of degree d, and
the orders n of roots of unity of such a degree satisfy ``φ(n) ≤ 2d``, so that ``n ≤ 2·(2d)²``. If T and N are
sums of square roots, n divides 240: the Galois group of ℚ(√…, λ) has exponent 4, and so has (ℤ/n)ˣ.
Enclosures of λ and μ leave one candidate each, or none, and the candidates are compared exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from math import lcm, prod
from typing import TYPE_CHECKING, Any

import flint

from hfield.core.factorisation import factorise
from hfield.core.primality import primes
from hfield.core.product import Constants, Coordinates, Scalar, multiply, norm, trace
from hfield.errors import NotInvertibleError, UndecidedError, shorten
from hfield.rings.balls import precision
from hfield.rings.base import Ring, WithIntegers
from hfield.rings.closed_fields.surds import Surd
from hfield.structure.linear_algebra.centre import basis_of

if TYPE_CHECKING:
    from hfield.rings.closed_fields.closed_forms import Closed


SEARCHED_ORDERS = 120
"""Orders up to this are tried over infinite rings of which nothing is known."""


def multiplicative_order(ring: Ring, c: Constants, q: Coordinates) -> int | None:
    """Return the least n > 0 with ``qⁿ = 1``, or None if there is none.

    Raises :class:`NotInvertibleError` when q is no unit, and :class:`UndecidedError` where it is not known:
    for transcendental numbers, over infinite rings of one's own, and where a factorisation is out of reach.
    """
    n, t = norm(c, q), trace(c, q)
    if not ring.is_unit(n):
        raise NotInvertibleError("an element without inverse has no order: its norm is no unit")
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
    """Answer over k(x) or k[x, …], where sums and products of roots of unity are constants."""
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
    """Return the primes of a number that every finite order divides; None where none is known.

    Over a number field of degree n, and over ℤ, they are those of roots of unity of degree at most 2n. Over
    a ring of m elements q generates a ring of at most m². Its residue fields are at most quadratic over those
    of the ring, and its units that are 1 modulo its radical have orders that divide m².
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
    """Return the primes of a number that the order of every root of unity of such a degree divides."""
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
    """Return the primes of pⁿ − 1, from those of the values of cyclotomic polynomials."""
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


SURDS = 240  # the orders of roots of unity that are quadratic over sums of square roots divide it
GREATEST = 10**9  # greater orders are not looked for
UNKNOWN = 1000  # up to this order roots of unity are compared with numbers not seen to be algebraic
BITS = 2**14

Enclosure = Callable[[int], Any]


def closed_order(ring: Ring, t: Surd | Closed, n: Surd | Closed, scalar: Any = None) -> int | None:
    """Return the order of an element with trace t and norm n, or of a scalar; None if it is infinite.

    Raises :class:`UndecidedError` where a number is neither seen to be algebraic, nor to be no root of
    unity, and where the degree is so large that its roots of unity are out of reach.
    """
    numbers = [t, n] if scalar is None else [scalar]
    if scalar is None and not n.ball(128).abs_lower() <= 1 <= n.ball(128).abs_upper():
        return None
    degree = _degree(numbers)
    surds = all(isinstance(x, Surd) for x in numbers)
    known = surds or (degree is not None and 2 * (2 * degree) ** 2 <= GREATEST)
    greatest = SURDS if surds else 2 * (2 * (degree or 0)) ** 2 if known else UNKNOWN
    if scalar is not None:
        roots: list[Enclosure] = [scalar.ball]
    else:
        if _root_ball(t, n, 1, 128) is None and ring.is_zero(t * t - n * 4):
            return None  # λ = μ, and q is no scalar
        roots = [lambda bits, s=s: _root_ball(t, n, s, bits) for s in (1, -1)]  # type: ignore[misc]
    angles = []
    for enclosure in roots:
        unit, angle = _angle(enclosure, greatest)
        if not unit:
            return None
        angles.append(angle)
    found = [r for r in angles if r is not None]
    if known:
        bound = 2 * (degree or 0)
        if len(found) < len(angles) or any(
            SURDS % d if surds else flint.fmpz(d).euler_phi() > bound
            for d in (r.denominator for r in found)
        ):
            return None
    order = lcm(*(r.denominator for r in found))
    if len(found) == len(angles) and _agrees(ring, t, n, scalar, found, order if surds else None):
        return order
    if known:
        return None
    raise UndecidedError(
        f"the order over {ring.name} of an element with {_shown(t, n, scalar)} is infinite or greater than "
        f"{UNKNOWN}: not decided, for these are not seen to be algebraic numbers of small degree"
    )


def _shown(t: Surd | Closed, n: Surd | Closed, scalar: Any) -> str:
    if scalar is not None:
        return f"the value {shorten(scalar)}"
    return f"trace {shorten(t)} and norm {shorten(n)}"


def _degree(numbers: list[Surd | Closed]) -> int | None:
    """Return a bound of the degree of the field of the numbers, or None."""
    degree = 1
    for x in numbers:
        if isinstance(x, Surd):
            degree *= 2 ** sum(n != 1 for n in x.terms)
        elif x.bounds is None:
            return None
        else:
            degree *= x.bounds.degree
    return degree


def _root_ball(t: Surd | Closed, n: Surd | Closed, sign: int, bits: int) -> flint.acb | None:
    """Enclose ``(T ± √(T² − 4N))/2``; None where the enclosure of the discriminant contains 0."""
    with precision(bits):
        trace = t.ball(bits)
        d = trace * trace - n.ball(bits) * 4
        if d.contains(0):
            return None
        # the branch cut of the root must not run through the ball
        root = (-d).sqrt() * flint.acb(0, 1) if d.real < 0 else d.sqrt()
        return (trace + root * sign) / 2


def _angle(enclosure: Enclosure, greatest: int) -> tuple[bool, Fraction | None]:
    """Return whether the number may have absolute value 1, and the only r it can be ``exp(2πi·r)`` for.

    r has a denominator up to ``greatest``; it is None where there is none.
    """
    bits = 128
    while bits <= BITS:
        z = enclosure(bits)
        with precision(bits):
            if z is not None and not z.abs_lower() <= 1 <= z.abs_upper():
                return False, None
            if z is not None and not z.contains(0):
                turned = z.real < 0  # keep the branch cut of the argument away
                turn = (-z if turned else z).log().imag / (2 * flint.arb.pi())
                turn = turn + flint.arb(1) / 2 if turned else turn
                if turn.rad() * 4 * greatest**2 < 1:
                    middle = turn.mid().fmpq()
                    near = Fraction(int(middle.p), int(middle.q)).limit_denominator(greatest)
                    # an enclosure of a fraction, that need not lie inside the other one
                    inside = turn.overlaps(flint.arb(flint.fmpq(near.numerator, near.denominator)))
                    return True, near % 1 if inside else None
        bits *= 2
    raise UndecidedError(
        "the order is not decided: two roots of the characteristic polynomial are too near to each other"
    )


def _agrees(
    ring: Ring,
    t: Surd | Closed,
    n: Surd | Closed,
    scalar: Surd | Closed,
    angles: list[Fraction],
    power: int | None,
) -> bool:
    """Tell whether the numbers are these roots of unity, or their sum and product, exactly."""
    if power is not None:  # sums of square roots: Xᵖ modulo X² − T·X + N, or the power of a scalar
        if scalar is not None:
            return ring.equal(ring.power(scalar, power), ring.one)
        u, v = ring.one, ring.zero  # u + v·X
        for bit in bin(power)[2:]:
            u, v = u * u - n * v * v, (u + u) * v + t * v * v
            if bit == "1":
                u, v = ring.zero - n * v, u + t * v
        return ring.equal(u, ring.one) and ring.is_zero(v)
    if scalar is not None:
        return bool(scalar == _unit_root(angles[0]))
    return bool(n == _unit_root(sum(angles))) and bool(t == _unit_root(*angles))


def _unit_root(*angles: Fraction) -> Surd | Closed:
    """Return the sum of the ``exp(2πi·r)``."""
    import sympy

    from hfield.rings.closed_fields.closed_forms import number

    total = sympy.Integer(0)
    if len(angles) == 2 and (angles[0] + angles[1]) % 1 == 0:
        r = sympy.Rational(angles[0].numerator, angles[0].denominator)
        return number(2 * sympy.cos(2 * sympy.pi * r))
    for angle in angles:
        r = sympy.Rational(angle.numerator, angle.denominator)
        total += sympy.cos(2 * sympy.pi * r) + sympy.I * sympy.sin(2 * sympy.pi * r)
    return number(total)
