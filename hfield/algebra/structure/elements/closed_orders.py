"""Orders of units over the real and the complex numbers.

The roots λ, μ of ``X² − T·X + N`` have degree at most 2d over ℚ if T and N lie in a field of degree d, and
the orders n of roots of unity of such a degree satisfy ``φ(n) ≤ 2d``, so that ``n ≤ 2·(2d)²``. If T and N are
sums of square roots, n divides 240: the Galois group of ℚ(√…, λ) has exponent 4, and so has (ℤ/n)ˣ.
Enclosures of λ and μ leave one candidate each, or none, and the candidates are compared exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import lcm
from typing import TYPE_CHECKING

import flint

from hfield.errors import UndecidedError, shorten
from hfield.fields.algebraic.surds import Surd
from hfield.fields.base.balls import precision
from hfield.fields.base.ring import Ring

if TYPE_CHECKING:
    from hfield.fields.algebraic.closed_forms import Closed


SURDS = 240  # the orders of roots of unity that are quadratic over sums of square roots divide it
GREATEST = 10**9  # greater orders are not looked for
UNKNOWN = 1000  # up to this order roots of unity are compared with numbers not seen to be algebraic
BITS = 2**14

Enclosure = Callable[[int], flint.acb | None]


def closed_order(
    ring: Ring, t: Surd | Closed, n: Surd | Closed, scalar: Surd | Closed | None = None
) -> int | None:
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
            return None  # λ = μ, and q is not a scalar
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
        f"{UNKNOWN}: not decided, because these are not recognised as algebraic numbers of small degree"
    )


def _shown(t: Surd | Closed, n: Surd | Closed, scalar: Surd | Closed | None) -> str:
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
    scalar: Surd | Closed | None,
    angles: list[Fraction],
    power: int | None,
) -> bool:
    """Return whether the numbers equal these roots of unity, or their sum and product, exactly."""
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
    return bool(n == _unit_root(sum(angles, Fraction()))) and bool(t == _unit_root(*angles))


def _unit_root(*angles: Fraction) -> Surd | Closed:
    """Return the sum of the ``exp(2πi·r)``."""
    import sympy

    from hfield.fields.algebraic.closed_forms import number

    total = sympy.Integer(0)
    if len(angles) == 2 and (angles[0] + angles[1]) % 1 == 0:
        r = sympy.Rational(angles[0].numerator, angles[0].denominator)
        return number(2 * sympy.cos(2 * sympy.pi * r))
    for angle in angles:
        r = sympy.Rational(angle.numerator, angle.denominator)
        total += sympy.cos(2 * sympy.pi * r) + sympy.I * sympy.sin(2 * sympy.pi * r)
    return number(total)
