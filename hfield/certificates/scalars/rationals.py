"""ℚ, and ℤ in it: fractions of integers; ℚ at a prime number."""

from fractions import Fraction
from itertools import product
from math import isqrt, prod

from hfield.certificates.rejection import reject
from hfield.certificates.scalars.finite import is_prime
from hfield.certificates.scalars.place import Place
from hfield.certificates.scalars.residues import ModuloNumber, modulo, two_or_odd
from hfield.certificates.scalars.ring import ReadRing, Ring
from hfield.certificates.work import charge

MAX_BITS = 100_000


class Rationals(Ring):
    """ℚ; or ℤ, of which nothing but integers can be named, and where only ±1 are units."""

    characteristic = 0
    is_integral = True
    roots_by = "factors"

    def __init__(self, is_field: bool) -> None:
        self.is_field, self.name = is_field, "QQ" if is_field else "ZZ"
        self.zero, self.one = Fraction(0), Fraction(1)
        self.fractions = None if is_field else "QQ"

    def number(self, n: int) -> Fraction:
        """Return n."""
        return Fraction(n)

    def add(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x + y."""
        return bounded(x + y)

    def neg(self, x: Fraction) -> Fraction:
        """Return −x."""
        return -x

    def mul(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x·y."""
        return bounded(x * y)

    def inverse(self, x: Fraction) -> Fraction | None:
        """Return 1/x, None if there is none."""
        return 1 / x if x and (self.is_field or abs(x) == 1) else None

    def sign(self, x: Fraction) -> int:
        """Return the sign of x."""
        return (x > 0) - (x < 0)

    def maps_modulo(self, n: int) -> bool:
        """Tell whether this is ℤ."""
        return self.name == "ZZ"

    def is_square(self, x: Fraction) -> bool:
        """Tell whether numerator and denominator are squares."""
        return x >= 0 and all(isqrt(n) ** 2 == n for n in (x.numerator, x.denominator))

    def has_no_root(self, c: list[Fraction]) -> bool:
        """Prove it for the polynomial with integer coefficients."""
        below = prod(x.denominator for x in c)
        return has_no_rational_root([int(x * below) for x in c])

    def place(self, text: str) -> Place:
        """Read a place such as ``7``."""
        return Number(two_or_odd("".join(text.split()))) if self.is_field else super().place(text)


class Number(ModuloNumber):
    """ℚ at n: integral are the fractions whose denominator is prime to n."""

    def __init__(self, n: int) -> None:
        self.n, self.odd = n, Fraction(n)

    def residue(self, x: Fraction) -> int | None:
        """Return the class modulo n."""
        return modulo(x, self.n)


def bounded(x: Fraction) -> Fraction:
    """Return a number; rejects one that has grown too large."""
    bits = x.numerator.bit_length() + x.denominator.bit_length()
    charge(5 + bits * bits // 500_000)
    if bits > MAX_BITS:
        reject("a number has grown too large")
    return x


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


QQ, ZZ = Rationals(True), Rationals(False)


def read(name: str, ring: ReadRing) -> Ring | None:
    """Return ``QQ`` or ``ZZ``."""
    return {"QQ": QQ, "ZZ": ZZ}.get(name)
