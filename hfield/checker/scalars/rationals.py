"""The rings ℚ and ℤ, the places of ℚ, and floats as far as their arithmetic is exact."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from math import isqrt, lcm

from hfield.checker.budget import spend, spend_products
from hfield.checker.rejection import an_object, keyed, reject
from hfield.checker.scalars.finite import is_prime
from hfield.checker.scalars.names import only
from hfield.checker.scalars.place import AnyPlace
from hfield.checker.scalars.residues import ModuloNumber, modulo, two_or_odd
from hfield.checker.scalars.ring import AnyRing, Ring

MAX_BITS = 100_000


class Rationals(Ring[Fraction]):
    """The field ℚ, or the ring ℤ with the units ±1."""

    characteristic = 0
    is_integral = True
    roots_by = "factors"

    def __init__(self, is_field: bool) -> None:
        self.is_field, self.name = is_field, "QQ" if is_field else "ZZ"
        self.words = "the rational numbers" if is_field else "the integers"
        self.zero, self.one = Fraction(0), Fraction(1)

    def number(self, n: int) -> Fraction:
        """Return n."""
        return Fraction(n)

    def add(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x + y."""
        _spend_for(x, y)
        return bounded(x + y)

    def neg(self, x: Fraction) -> Fraction:
        """Return −x."""
        return -x

    def mul(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x·y."""
        _spend_for(x, y)
        return bounded(x * y)

    def inverse(self, x: Fraction) -> Fraction | None:
        """Return 1/x, None if there is none."""
        return 1 / x if x and (self.is_field or abs(x) == 1) else None

    def sign(self, x: Fraction) -> int:
        """Return the sign of x."""
        return (x > 0) - (x < 0)

    def coefficients(self, x: Fraction) -> tuple[Fraction, ...]:
        """Return the number alone."""
        return (x,)

    def maps_modulo(self, n: int) -> bool:
        """Return whether this is ℤ."""
        return self.name == "ZZ"

    def is_square(self, x: Fraction) -> bool:
        """Return whether numerator and denominator are squares."""
        return x >= 0 and root(x) is not None

    def has_no_root(self, c: list[Fraction]) -> bool:
        """Prove that the polynomial with integer coefficients has no rational root."""
        return has_no_rational_root(over_one_denominator(c)[0])

    def contains(self, x: Fraction) -> bool:
        """Return whether x is an integer, for ℤ."""
        return self.is_field or x.denominator == 1

    def is_fraction_field_of(self, ring: AnyRing) -> bool:
        """Return whether this is ℚ and the ring is ℤ."""
        return self is QQ and ring is ZZ

    def place(self, data: object) -> AnyPlace[Fraction]:
        """Return a place of the kind ``number``."""
        if not self.is_field or keyed(data, "a place").get("kind") != "number":
            return super().place(data)
        return RationalPlace(two_or_odd(an_object(data, "kind n", "a place")["n"]))


class RationalPlace(ModuloNumber[Fraction]):
    """ℚ at n: the fractions with denominator prime to n are integral."""

    def __init__(self, n: int) -> None:
        self.n, self.odd, self.name = n, Fraction(n), f"({n})"

    def residue(self, x: Fraction) -> int | None:
        """Return the class modulo n."""
        return modulo(x, self.n)


def _spend_for(x: Fraction, y: Fraction) -> None:
    """Spend the cost of a sum or a product."""
    bits = x.numerator.bit_length() + x.denominator.bit_length()
    more = y.numerator.bit_length() + y.denominator.bit_length()
    spend(5 + (bits + more) // 1_000 + bits * more // 500_000)


def bounded(x: Fraction) -> Fraction:
    """Return a number; rejects one that has grown too large."""
    if x.numerator.bit_length() + x.denominator.bit_length() > MAX_BITS:
        reject("a number has grown too large")
    return x


def root(x: Fraction) -> Fraction | None:
    """Return the square root of a nonnegative number, if it is rational."""
    parts = x.numerator, x.denominator
    spend_products(parts, parts)
    u, v = map(isqrt, parts)
    return Fraction(u, v) if (u * u, v * v) == parts else None


def over_one_denominator(values: Sequence[Fraction]) -> tuple[list[int], int]:
    """Return numbers as integers over their least common denominator, and the denominator."""
    denominators = {x.denominator for x in values}
    spend(len(values))
    spend_products(denominators, denominators)
    least = lcm(*denominators)
    spend_products([*denominators, *(x.numerator for x in values)], [least])
    return [x.numerator * (least // x.denominator) for x in values], least


def has_no_rational_root(c: list[int]) -> bool:
    """Prove that Σ cₙ·xⁿ has no rational root: by its roots modulo a prime, or by testing all candidates."""
    lead, last = c[-1], c[0]
    if last == 0 or lead == 0:
        return False
    for p in (n for n in range(2, 200) if is_prime(n)):
        spend_products([p], c)
        spend(p * len(c))
        classes = [a % p for a in c]
        if classes[-1] and all(value_modulo(classes, x, p) for x in range(p)):
            return True
    tops, belows = divisors(abs(last)), divisors(abs(lead))
    if len(tops) * len(belows) > 20_000:
        reject("a polynomial has too many candidates for rational roots")
    longest = max(tops[-1], belows[-1]).bit_length() * len(c)
    cost = 20 * len(c) + sum(map(int.bit_length, c)) * longest // 250_000
    spend(cost * len(tops) * len(belows))
    for u, v in product(tops, belows):
        for top in (u, -u):
            if sum(a * top**n * v ** (len(c) - 1 - n) for n, a in enumerate(c)) == 0:
                return False
    return True


def value_modulo(c: list[int], x: int, p: int) -> int:
    """Return the value of a polynomial at x, modulo p."""
    total = 0
    for a in reversed(c):
        total = (total * x + a) % p
    return total


def divisors(n: int) -> list[int]:
    """Return all divisors of a positive integer of bounded size."""
    if n > 10**10:
        reject("a polynomial's coefficients are too large to list their divisors")
    spend(isqrt(n))
    small = [d for d in range(1, isqrt(n) + 1) if n % d == 0]
    return sorted({*small, *(n // d for d in small)})


class Floats(Rationals):
    """Floats: not a ring; only integers below 2⁵³ are used, on which their arithmetic is exact."""

    is_exact = False

    def __init__(self, name: str, words: str) -> None:
        super().__init__(False)
        self.name, self.words, self.is_integral = name, words, False

    def number(self, n: int) -> Fraction:
        """Return n."""
        return self._exact(Fraction(n))

    def add(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x + y."""
        return self._exact(x + y)

    def mul(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x·y."""
        return self._exact(x * y)

    def inverse(self, x: Fraction) -> Fraction | None:
        """Raise :class:`Rejected`: a quotient of floats is rounded."""
        reject("quotients of floats are not exact")

    def fraction(self, value: int | Fraction) -> Fraction:
        """Return an integer, perhaps written with a decimal point."""
        return self._exact(Fraction(value))

    def _exact(self, x: Fraction) -> Fraction:
        if x.denominator != 1 or abs(x) >= 1 << 53:
            reject("floats are taken only where they are integers below 2^53")
        return x


QQ, ZZ = Rationals(True), Rationals(False)


KINDS = {
    "rationals": only(QQ),
    "integers": only(ZZ),
    "floats": only(Floats("RDF", "floating-point numbers")),
    "complex floats": only(Floats("CDF", "complex floating-point numbers")),
}
