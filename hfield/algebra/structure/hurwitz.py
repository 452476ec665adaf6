"""Division with remainder and greatest common divisors in the Hurwitz order, and sums of four squares.

Every rational quaternion has distance of norm at most 1/2 from a Hurwitz quaternion, so the order is
Euclidean on both sides (Conway and Smith, *On Quaternions and Octonions*, chapter 5). For odd n with ``x² +
y² + 1 ≡ 0 (mod n)``, the right greatest common divisor of n and ``1 + x·i + y·j`` has norm n. This proves
Lagrange's theorem, effectively if x² + y² is chosen to be a prime (Rabin and Shallit, 1986).
"""

import itertools
from collections.abc import Sequence
from fractions import Fraction

from hfield.core.product import Constants, conjugate, multiply, norm
from hfield.errors import CoercionError, NotInvertibleError
from hfield.fields.rationals.squares import two_squares
from hfield.fields.rationals.whole_numbers import fraction

HAMILTON = Constants(Fraction(-1), Fraction(0), Fraction(-1))
Vector = tuple[Fraction, Fraction, Fraction, Fraction]


def _vector(q: Sequence[Fraction | int]) -> Vector:
    w, x, y, z = (fraction(u) for u in q)
    return w, x, y, z


def is_hurwitz(q: Sequence[Fraction | int]) -> bool:
    """Return whether all coordinates are integers, or all are halves of odd integers."""
    doubled = [2 * fraction(x) for x in q]
    return all(x.denominator == 1 for x in doubled) and len({int(x) % 2 for x in doubled}) == 1


def nearest(q: Sequence[Fraction | int]) -> Vector:
    """Return the nearest Hurwitz quaternion; the difference has norm at most 1/2."""
    v = _vector(q)
    h = Fraction(1, 2)
    whole = _vector([round(x) for x in v])
    halves = _vector([round(x - h) + h for x in v])
    return min((whole, halves), key=lambda u: sum((x - y) ** 2 for x, y in zip(u, v, strict=True)))


def divide(
    a: Sequence[Fraction | int], b: Sequence[Fraction | int], side: str = "right"
) -> tuple[Vector, Vector]:
    """Return ``(q, r)`` with ``a = q·b + r`` (right) or ``a = b·q + r`` (left) and N(r) ≤ N(b)/2.

    All are Hurwitz quaternions. Raises :class:`CoercionError` for others, and
    :class:`NotInvertibleError` for b = 0.
    """
    p, d = _checked(a), _checked(b)
    n = norm(HAMILTON, d)
    if not n:
        raise NotInvertibleError("cannot divide by 0 in the Hurwitz order")
    inverse = conjugate(HAMILTON, d)
    product = _times(p, inverse) if side == "right" else _times(inverse, p)
    q = nearest([x / n for x in product])
    back = _times(q, d) if side == "right" else _times(d, q)
    r = _vector([x - y for x, y in zip(p, back, strict=True)])
    return q, r


def gcd(a: Sequence[Fraction | int], b: Sequence[Fraction | int], side: str = "right") -> Vector:
    """Return a greatest common right (or left) divisor of two Hurwitz quaternions, up to a unit."""
    p, q = _checked(a), _checked(b)
    while any(q):
        p, q = q, divide(p, q, side)[1]
    return p


def _times(p: Sequence[Fraction], q: Sequence[Fraction]) -> Vector:
    w, x, y, z = multiply(HAMILTON, _vector(p), _vector(q))
    return w, x, y, z


def _checked(q: Sequence[Fraction | int]) -> Vector:
    if len(q) != 4 or not is_hurwitz(q):
        raise CoercionError(
            "expected a Hurwitz quaternion: four integers, or four halves of odd integers"
        )
    return _vector(q)


def lipschitz_associate(q: Sequence[Fraction | int]) -> Vector:
    """Return q times a unit with integer coordinates; every Hurwitz quaternion has such an associate."""
    v = _checked(q)
    h = Fraction(1, 2)
    for signs in itertools.product((h, -h), repeat=4):
        if all(x.denominator == 1 for x in v):
            return v
        candidate = _times(v, signs)
        if all(x.denominator == 1 for x in candidate):
            return candidate
    raise AssertionError("every Hurwitz quaternion has an associate with integer coordinates")


def four_squares(n: int) -> tuple[int, int, int, int]:
    """Return a ≥ b ≥ c ≥ d ≥ 0 with ``a² + b² + c² + d² = n``; quick for hundreds of digits.

    Raises :class:`CoercionError` for a negative n or one that is not an integer.

    >>> sum(x * x for x in four_squares(10**40 + 7)) == 10**40 + 7
    True
    """
    if not isinstance(n, int) or n < 0:
        raise CoercionError(
            f"{n!r} is not a sum of four squares of integers: expected an integer ≥ 0"
        )
    if n == 0:
        return 0, 0, 0, 0
    twos = (n & -n).bit_length() - 1
    q = lipschitz_associate(_of_norm_odd(n >> twos))
    for _ in range(twos % 2):
        q = _times(q, _vector((1, 1, 0, 0)))
    a, b, c, d = sorted((abs(int(x)) << (twos // 2) for x in q), reverse=True)
    assert a * a + b * b + c * c + d * d == n
    return a, b, c, d


def _of_norm_odd(n: int) -> Vector:
    """Return a Hurwitz quaternion of odd norm n."""
    if n == 1:
        return _vector((1, 0, 0, 0))
    # u·n − 1 ≡ 1 (mod 4), tried until it is a prime, a sum of two squares
    u = 2 * pow(n, -1, 4) % 4
    while (squares := two_squares(u * n - 1)) is None:
        u += 4
    return gcd(_vector((n, 0, 0, 0)), _vector((1, *squares, 0)))
