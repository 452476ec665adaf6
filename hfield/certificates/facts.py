"""What may be used of a field: forms that represent 0 only trivially, polynomials without roots.

Each fact is verified here. Where that takes a theorem which is not proved here, its text is returned
and has to stand in the certificate's ``assumes``.
"""

from fractions import Fraction
from itertools import product
from math import isqrt
from typing import Any

from hfield.certificates.finite import is_prime
from hfield.certificates.functions import Functions
from hfield.certificates.numbers import Rationals, Surds
from hfield.certificates.rejection import reject, shown
from hfield.certificates.ring import Ring

HENSEL = "a number that is 1 modulo 8 is a square in the 2-adic numbers (Hensel)"
SERRE = (
    "the norm form of (a,b|Q_p) is anisotropic exactly when the Hilbert symbol (a,b)_p is -1, given by "
    "Serre's formulas (A Course in Arithmetic, III.1)"
)


def is_ordered(field: Ring) -> bool:
    """Tell whether the field is one of those in which ``sign`` is that of an ordering."""
    return field.is_field and field.sign(field.one) == 1 and field.name != "RDF"


def level_above(field: Ring, bound: int) -> tuple[str, ...] | None:
    """Prove that −1 is not a sum of ``bound`` squares; return the theorems used, None if it fails."""
    if bound < 1:
        return ()
    if is_ordered(field):
        return ()
    base = field
    while isinstance(base, Functions):  # a constant that is a sum of squares in F(t) is one in F
        base = base.base
    if is_ordered(base):
        return ()
    if base.order is not None and base.is_field:
        return () if bound == 1 and base.order % 4 == 3 else None
    if not isinstance(base, Surds) or base.d is None:
        return None
    if bound == 1:
        return () if base.d != -1 else None
    return (HENSEL,) if bound <= 3 and base.d % 8 == 1 and _odd_squares_modulo_8() else None


def _odd_squares_modulo_8() -> bool:
    """Try all: a sum of four squares, not all of even numbers, is never 0 modulo 8."""
    return all(
        (w * w + x * x + y * y + z * z) % 8
        for w, x, y, z in product(range(8), repeat=4)
        if (w | x | y | z) & 1
    )


def anisotropic(field: Ring, a: Any, t: Any, b: Any, places: list[str]) -> tuple[str, ...]:
    """Prove that the norm of (a, t, b) is 0 only at 0; return the theorems that are cited for it."""
    if not field.is_field or field.characteristic == 2 or field.order is not None:
        reject(f"that the norm is anisotropic over {field.name} cannot be verified here")
    # Completing the square: the norm form is that of (d, b) with d = t² + 4a.
    d = field.add(field.mul(t, t), field.mul(field.number(4), a))
    if is_ordered(field) and field.sign(d) == -1 and field.sign(b) == -1:
        return ()
    minus_one, four = field.number(-1), field.number(-4)
    if field.equal(d, four) and field.equal(b, minus_one):
        found = level_above(field, 2)
        if found is not None:
            return found
    if isinstance(field, Rationals):
        for place in places:
            if not (place.isascii() and place.isdigit() and len(place) < 30):
                continue
            if is_prime(int(place)) and hilbert(d, b, int(place)) == -1:
                return (SERRE,)
    reject(f"that the norm is anisotropic over {field.name} cannot be verified here")


def hilbert(a: Fraction, b: Fraction, p: int) -> int:
    """Return the Hilbert symbol (a, b) at the prime p."""
    if not a or not b:
        reject("a Hilbert symbol of 0")
    (m, u), (n, v) = _valuation(a, p), _valuation(b, p)
    if p == 2:
        sign = ((u - 1) // 2) * ((v - 1) // 2) + m * ((v * v - 1) // 8) + n * ((u * u - 1) // 8)
        return -1 if sign % 2 else 1
    sign = m * n * ((p - 1) // 2) % 2
    if n % 2 and pow(u, (p - 1) // 2, p) != 1:
        sign ^= 1
    if m % 2 and pow(v, (p - 1) // 2, p) != 1:
        sign ^= 1
    return -1 if sign else 1


def _valuation(x: Fraction, p: int) -> tuple[int, int]:
    """Return (n, u) with x = pⁿ·u up to squares of units: u modulo p, or modulo 8 for p = 2."""
    unit, n = x.numerator * x.denominator, 0
    while unit % p == 0:
        unit, n = unit // p, n + 1
    return n, unit % (8 if p == 2 else p)


def is_square(field: Ring, x: Any) -> bool:
    """Tell whether x is a square in the field; rejects where that is not decided here."""
    if field.is_zero(x):
        return True
    if isinstance(field, Rationals):
        return x > 0 and isqrt(x.numerator) ** 2 == x.numerator and isqrt(x.denominator) ** 2 == (
            x.denominator
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
        if lead % p and all(_value(c, x, p) for x in range(p)):
            return True
    tops, belows = _divisors(abs(last)), _divisors(abs(lead))
    if len(tops) * len(belows) > 20_000:
        reject("a polynomial has too many candidates for rational roots")
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
    if n > 10**12:
        reject("a polynomial's coefficients are too large to list their divisors")
    small = [d for d in range(1, isqrt(n) + 1) if n % d == 0]
    return sorted({*small, *(n // d for d in small)})
