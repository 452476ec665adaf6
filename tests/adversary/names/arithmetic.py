"""Elementary number theory for judges of names: primes, GF(q), polynomials over ℚ and over GF(q).

A polynomial is a tuple of coefficients, low degree first, without zeros at the end; () is 0.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import comb
from typing import Any

import sympy

Poly = tuple[Any, ...]


@cache
def prime_power(q: int) -> tuple[int, int] | None:
    """Return (p, n) with q = pⁿ, None for what is no power of a prime."""
    if q < 2:
        return None
    if sympy.isprime(q):
        return q, 1
    found = sympy.perfect_power(q)
    if not found or not sympy.isprime(found[0]):
        return None
    return int(found[0]), int(found[1])


@cache
def squarefree_kernel(n: int) -> int:
    """Return the squarefree d with n = d·m²."""
    d = -1 if n < 0 else 1
    for p, k in sympy.factorint(abs(n)).items():
        d *= int(p) if k % 2 else 1
    return d


class Field:
    """ℚ, by fractions."""

    zero: Any = Fraction(0)
    one: Any = Fraction(1)

    def number(self, x: Fraction) -> Any:
        """Return the element that a rational number is; ZeroDivisionError where it is none."""
        return x

    def add(self, x: Any, y: Any) -> Any:
        """Return x + y."""
        return x + y

    def neg(self, x: Any) -> Any:
        """Return −x."""
        return -x

    def mul(self, x: Any, y: Any) -> Any:
        """Return x·y."""
        return x * y

    def inverse(self, x: Any) -> Any:
        """Return 1/x; ZeroDivisionError for 0."""
        return 1 / x


QQ = Field()


@dataclass(frozen=True)
class Galois(Field):
    """GF(pⁿ): tuples of n numbers, polynomials in x modulo a monic ``modulus``; n = 1 takes the modulus x."""

    p: int
    modulus: tuple[int, ...] = (0, 1)

    @property
    def degree(self) -> int:
        """The degree n over GF(p)."""
        return len(self.modulus) - 1

    @property
    def order(self) -> int:
        """The number of elements."""
        return self.p**self.degree

    @property
    def zero(self) -> Any:  # type: ignore[override]
        """0."""
        return (0,) * self.degree

    @property
    def one(self) -> Any:  # type: ignore[override]
        """1."""
        return (1, *self.zero[1:])

    @property
    def x(self) -> Any:
        """The class of x."""
        return self._reduced([0, 1])

    def number(self, x: Fraction) -> Any:
        """Return a rational number modulo p."""
        if x.denominator % self.p == 0:
            raise ZeroDivisionError
        return (x.numerator * pow(x.denominator, -1, self.p) % self.p, *self.zero[1:])

    def add(self, x: Any, y: Any) -> Any:
        """Return x + y."""
        return tuple((a + b) % self.p for a, b in zip(x, y, strict=True))

    def neg(self, x: Any) -> Any:
        """Return −x."""
        return tuple(-a % self.p for a in x)

    def mul(self, x: Any, y: Any) -> Any:
        """Return x·y."""
        wide = [0] * (2 * self.degree - 1)
        for m, a in enumerate(x):
            for n, b in enumerate(y):
                wide[m + n] += a * b
        return self._reduced(wide)

    def inverse(self, x: Any) -> Any:
        """Return x^(q−2)."""
        if x == self.zero:
            raise ZeroDivisionError
        return powered(self.one, x, self.order - 2, self.mul)

    def _reduced(self, wide: list[int]) -> tuple[int, ...]:
        while len(wide) > self.degree:
            top = wide.pop()
            for k, c in enumerate(self.modulus[:-1]):
                wide[len(wide) - self.degree + k] -= top * c
        return tuple(c % self.p for c in wide) + (0,) * (self.degree - len(wide))


def powered(one: Any, x: Any, n: int, times: Callable[[Any, Any], Any]) -> Any:
    """Return xⁿ, n ≥ 0."""
    while n:
        one, x, n = times(one, x) if n & 1 else one, times(x, x) if n > 1 else x, n >> 1
    return one


# --- polynomials ---------------------------------------------------------------------------------


def plus(K: Field, f: Poly, g: Poly) -> Poly:
    """Return f + g."""
    size = max(len(f), len(g))
    return trimmed(
        K,
        [
            K.add(f[n] if n < len(f) else K.zero, g[n] if n < len(g) else K.zero)
            for n in range(size)
        ],
    )


def times(K: Field, f: Poly, g: Poly) -> Poly:
    """Return f·g."""
    out = [K.zero] * max(len(f) + len(g) - 1, 0)
    for m, a in enumerate(f):
        for n, b in enumerate(g):
            out[m + n] = K.add(out[m + n], K.mul(a, b))
    return trimmed(K, out)


def negative(K: Field, f: Poly) -> Poly:
    """Return −f."""
    return tuple(K.neg(c) for c in f)


def monic(K: Field, f: Poly) -> Poly:
    """Return f divided by its leading coefficient."""
    scale = K.inverse(f[-1])
    return tuple(K.mul(scale, c) for c in f)


def trimmed(K: Field, f: Sequence[Any]) -> Poly:
    """Leave out zeros at the end."""
    out = list(f)
    while out and out[-1] == K.zero:
        out.pop()
    return tuple(out)


def remainder(K: Field, f: Poly, g: Poly) -> Poly:
    """Return f modulo g."""
    rest, scale = list(f), K.inverse(g[-1])
    while len(rest) >= len(g):
        c, shift = K.mul(rest[-1], scale), len(rest) - len(g)
        for n, d in enumerate(g):
            rest[shift + n] = K.add(rest[shift + n], K.neg(K.mul(c, d)))
        rest = list(trimmed(K, rest))
    return tuple(rest)


def common(K: Field, f: Poly, g: Poly) -> Poly:
    """Return the greatest common divisor, monic, or ()."""
    while g:
        f, g = g, remainder(K, f, g)
    return monic(K, f) if f else ()


def irreducible(K: Galois, f: Poly) -> bool:
    """Rabin's test over GF(q), for degree 1 or more."""
    n = len(f) - 1
    if n < 1:
        return False
    x: Poly = (K.zero, K.one)

    def frobenius(k: int) -> Poly:
        y = remainder(K, x, f)
        for _ in range(k):
            y = powered((K.one,), y, K.order, lambda a, b: remainder(K, times(K, a, b), f))
        return y

    if plus(K, frobenius(n), negative(K, remainder(K, x, f))):
        return False
    return all(
        len(common(K, f, plus(K, frobenius(n // int(r)), negative(K, x)))) == 1
        for r in sympy.primefactors(n)
    )


def rational(f: Poly) -> sympy.Poly:
    """Return a polynomial over ℚ as one of sympy's."""
    coefficients = [sympy.Rational(c.numerator, c.denominator) for c in map(Fraction, f)]
    return sympy.Poly(coefficients[::-1], sympy.Symbol("X"), domain="QQ")


def dense(f: sympy.Poly) -> Poly:
    """Return a polynomial of sympy's over ℚ as a tuple."""
    return tuple(Fraction(int(c.p), int(c.q)) for c in f.all_coeffs()[::-1])


@cache
def irreducible_over_rationals(f: Poly) -> bool:
    """Tell whether f is irreducible over ℚ."""
    return bool(rational(f).is_irreducible)


@cache
def factors_modulo(f: Poly, p: int) -> tuple[tuple[tuple[int, ...], int], ...]:
    """Return the monic irreducible factors of f modulo p, and their powers; f is integral at p."""
    K = Galois(p)
    reduced = [K.number(Fraction(c))[0] for c in f]
    _, found = sympy.Poly(reduced[::-1], sympy.Symbol("X"), modulus=p).factor_list()
    return tuple((tuple(int(c) % p for c in g.all_coeffs()[::-1]), int(e)) for g, e in found)


@cache
def real_roots(f: Poly) -> tuple[float, ...]:
    """Return the real roots of f, of ℚ[X], ascending: as many as Sturm's theorem says."""
    whole = rational(f)
    found = sorted(map(complex, whole.nroots(n=20, maxsteps=500)), key=lambda z: abs(z.imag))
    return tuple(sorted(z.real for z in found[: int(whole.count_roots())]))


def divisors(n: int) -> Iterator[int]:
    """Run through the divisors of n, ascending."""
    return (d for d in range(1, n + 1) if n % d == 0)


@cache
def cyclotomic(n: int) -> Poly:
    """Return the polynomial of the primitive n-th roots of unity: Xⁿ − 1 without the others."""
    f: Poly = (Fraction(-1), *[Fraction(0)] * (n - 1), Fraction(1))
    for d in divisors(n):
        if d < n:
            f = dense(sympy.quo(rational(f), rational(cyclotomic(d))))
    return f


@cache
def twice_cosine(n: int) -> Poly:
    """Return the polynomial of c = ζₙ + 1/ζₙ: cᵏ = Σ C(k, m)·ζ^(k−2m), taken off Φₙ from the top."""
    whole = cyclotomic(n)
    half = (len(whole) - 1) // 2
    rest, out = list(whole[half:]), [Fraction(0)] * (half + 1)
    for k in range(half, -1, -1):
        out[k] = rest[k]
        for j in range(k % 2, k + 1, 2):
            rest[j] -= out[k] * comb(k, (k - j) // 2)
    return tuple(out)
