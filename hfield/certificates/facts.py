"""What may be used of a field: forms that represent 0 only trivially, polynomials without roots.

Each fact is verified here. Where that takes a theorem which is not proved here, its text is returned
and has to stand in the certificate's ``assumes``.
"""

from fractions import Fraction
from itertools import product
from math import isqrt
from typing import Any

from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars.finite import is_prime
from hfield.certificates.scalars.functions import MAX_DEGREE, Functions
from hfield.certificates.scalars.numbers import Rationals, Surds
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.work import charge


def is_ordered(field: Ring) -> bool:
    """Tell whether the field is one of those in which ``sign`` is that of an ordering."""
    return field.is_field and field.sign(field.one) == 1 and field.name != "RDF"


def level_above(field: Ring, bound: int) -> bool:
    """Prove that −1 is not a sum of ``bound`` squares in a field; False says nothing.

    ℚ(√d) with d ≡ 1 modulo 8 lies in ℚ₂. A sum of four squares that is 0 there could be divided until one
    of its terms is odd; but then it is not 0 modulo 8.
    """
    if bound < 1 or is_ordered(field):
        return True
    base = field
    while isinstance(base, Functions):  # a constant that is a sum of squares in F(t) is one in F
        base = base.base
    if is_ordered(base):
        return True
    if base.order is not None and base.is_field:
        return bound == 1 and base.order % 4 == 3
    if not isinstance(base, Surds) or base.d is None:
        return False
    if bound == 1:
        return base.d != -1
    return bound <= 3 and base.d % 8 == 1 and _odd_squares_modulo_8()


def _odd_squares_modulo_8() -> bool:
    """Try all: a sum of four squares, not all of even numbers, is never 0 modulo 8."""
    return all(
        (w * w + x * x + y * y + z * z) % 8
        for w, x, y, z in product(range(8), repeat=4)
        if (w | x | y | z) & 1
    )


def is_square(field: Ring, x: Any) -> bool:
    """Tell whether x is a square in the field; rejects where that is not decided here."""
    if field.is_zero(x):
        return True
    if isinstance(field, Rationals):
        return (
            bool(x > 0)
            and isqrt(x.numerator) ** 2 == x.numerator
            and isqrt(x.denominator) ** 2 == x.denominator
        )
    if field.order is not None and field.is_field:
        q = field.order
        return q % 2 == 0 or field.equal(field.power(x, (q - 1) // 2), field.one)
    if isinstance(field, Surds):
        return _is_square_surd(field, x)
    if isinstance(field, Functions) and field.characteristic != 2:
        return _is_square_function(field, x)
    reject(f"squares in {field.name} are not decided here")


def _is_square_surd(field: Surds, x: Any) -> bool:
    rationals = Rationals(True)
    if field.name == "CC":
        return True
    if field.name == "RR":
        sign = field.sign(x)
        if sign is None:
            reject(f"the sign of {shown(x)} is not decided here")
        return sign >= 0
    d = field.d or 0
    values = dict(x)
    u = values.pop((), Fraction(0))
    v = next(iter(values.values()), Fraction(0))
    if not v:
        return is_square(rationals, u) or is_square(rationals, u / d)
    norm = u * u - d * v * v
    if not is_square(rationals, norm):
        return False
    root = Fraction(isqrt(norm.numerator), isqrt(norm.denominator))
    return any(is_square(rationals, (u + s * root) / 2) for s in (1, -1))


def _is_square_function(field: Functions, x: Any) -> bool:
    """x = f/g is a square when f·g is: its leading coefficient is, and it has a root as a polynomial."""
    base, polynomials = field.base, field.polynomials
    f = dict(polynomials.mul(*x))
    degree = max(f)[0]
    if degree > MAX_DEGREE:
        reject(f"squares are not told above the degree {MAX_DEGREE}")
    charge(5 * degree**2)
    lead = f[(degree,)]
    if degree % 2 or not is_square(base, lead):
        return False
    scale = base.inverse(lead)
    monic = {m: base.mul(c, scale) for m, c in f.items()}
    half = degree // 2
    below_two = base.inverse(base.number(2))
    root = [base.zero] * half + [base.one]
    for n in range(half - 1, -1, -1):  # the coefficient of degree half + n tells root[n]
        total = monic.get((half + n,), base.zero)
        for m in range(n + 1, half):
            total = base.add(total, base.neg(base.mul(root[m], root[half + n - m])))
        root[n] = base.mul(total, below_two)
    text = tuple(((n,), c) for n, c in enumerate(root) if not base.is_zero(c))
    return bool(dict(polynomials.mul(text, text)) == monic)


def has_no_rational_root(c: list[int]) -> bool:
    """Prove that Σ cₙ·xⁿ has no rational root: by its roots modulo a prime, or by trying them."""
    lead, last = c[-1], c[0]
    if last == 0 or lead == 0:
        return False
    for p in (n for n in range(2, 200) if is_prime(n)):
        charge(p * len(c))
        if lead % p and all(_value(c, x, p) for x in range(p)):
            return True
    tops, belows = _divisors(abs(last)), _divisors(abs(lead))
    if len(tops) * len(belows) > 20_000:
        reject("a polynomial has too many candidates for rational roots")
    charge(20 * len(tops) * len(belows) * len(c))
    for u, v in product(tops, belows):
        for top in (u, -u):
            if sum(a * top**n * v ** (len(c) - 1 - n) for n, a in enumerate(c)) == 0:
                return False
    return True


def _value(c: list[int], x: int, p: int) -> int:
    total = 0
    for a in reversed(c):
        total = (total * x + a) % p
    return total


def _divisors(n: int) -> list[int]:
    charge(isqrt(n))
    if n > 10**10:
        reject("a polynomial's coefficients are too large to list their divisors")
    small = [d for d in range(1, isqrt(n) + 1) if n % d == 0]
    return sorted({*small, *(n // d for d in small)})
