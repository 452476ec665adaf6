"""Sums of rational multiples of square roots of integers: exact, canonical, hashable, without sympy.

QQ(sqrt(d)), QQ(I) and most numbers that anyone types into RR or CC lie in these fields, the fields
ℚ(√n₁, √n₂, …). The square roots of different squarefree integers are linearly independent over ℚ
(Besicovitch, 1940), so a number is 0 exactly when all its coefficients are.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import gcd, isqrt
from typing import Any

import flint

from hfield.errors import NotInvertibleError, TooLargeError, shorten
from hfield.rings.balls import fingerprint
from hfield.rings.modular import factored
from hfield.rings.printing import Factor, number_text, sum_text
from hfield.rings.rational import fmpq, rational

MAX_TERMS = 1024

_ZERO = flint.fmpq(0)


class Surd:
    """An immutable number ``Σ cₙ·√n`` over squarefree integers n; ``√−n`` is ``i·√n`` for n > 0.

    ``terms`` maps n to the rational cₙ ≠ 0. The √n are the principal roots.
    """

    __slots__ = ("terms",)

    terms: dict[int, Any]

    def __init__(self, terms: dict[int, Any]) -> None:
        object.__setattr__(self, "terms", terms)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("numbers are immutable")

    def __reduce__(self) -> Any:
        pairs = [(n, int(c.p), int(c.q)) for n, c in self.terms.items()]
        return _restore, (pairs,)

    # --- arithmetic ----------------------------------------------------------------------------

    def __add__(self, other: Any) -> Any:
        o = as_surd(other)
        if o is None:
            return NotImplemented
        terms = dict(self.terms)
        for n, c in o.terms.items():
            total = terms.get(n, _ZERO) + c
            if total == 0:
                del terms[n]
            else:
                terms[n] = total
        return Surd(terms)

    __radd__ = __add__

    def __neg__(self) -> Surd:
        return Surd({n: -c for n, c in self.terms.items()})

    def __pos__(self) -> Surd:
        return self

    def __sub__(self, other: Any) -> Any:
        o = as_surd(other)
        return NotImplemented if o is None else self + -o

    def __rsub__(self, other: Any) -> Any:
        o = as_surd(other)
        return NotImplemented if o is None else o + -self

    def __mul__(self, other: Any) -> Any:
        o = as_surd(other)
        if o is None:
            return NotImplemented
        if len(self.terms) * len(o.terms) > MAX_TERMS**2:
            raise TooLargeError(
                f"a number with more than {MAX_TERMS} square roots; compute in parts"
            )
        terms: dict[int, Any] = {}
        for m, c in self.terms.items():
            for n, d in o.terms.items():
                factor, root = _product(m, n)
                terms[root] = terms.get(root, _ZERO) + c * d * factor
        return Surd({n: c for n, c in terms.items() if c != 0})

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        o = as_surd(other)
        return NotImplemented if o is None else self * o.inverse()

    def __rtruediv__(self, other: Any) -> Any:
        o = as_surd(other)
        return NotImplemented if o is None else o * self.inverse()

    def __pow__(self, n: int) -> Surd:
        from hfield.rings.base import power

        return power(ONE, self if n >= 0 else self.inverse(), abs(n))  # type: ignore[no-any-return]

    def inverse(self) -> Surd:
        """Return 1/self: times the conjugates, one prime under the roots after the other."""
        if not self.terms:
            raise NotInvertibleError("cannot divide by 0")
        top, bottom = ONE, self
        while not bottom.is_rational():
            n = next(n for n in bottom.terms if n != 1)
            p = -1 if n < 0 else _prime_of(n)
            conjugate = bottom.conjugate_at(p)
            top, bottom = top * conjugate, bottom * conjugate
        c = 1 / bottom.terms[1]
        return Surd({n: c * d for n, d in top.terms.items()})

    def conjugate_at(self, p: int) -> Surd:
        """Return the number with √p replaced by −√p; p is a prime or −1 (complex conjugation)."""
        return Surd(
            {n: -c if (n < 0 if p == -1 else n % p == 0) else c for n, c in self.terms.items()}
        )

    def __eq__(self, other: object) -> bool:
        o = as_surd(other)
        if o is None:
            return NotImplemented
        return self.terms == o.terms

    def __hash__(self) -> int:
        if self.is_rational():
            return hash(self.terms.get(1, _ZERO))
        return hash(fingerprint(self.ball))

    # --- what it is ----------------------------------------------------------------------------

    def is_rational(self) -> bool:
        """Tell whether the number is rational."""
        return all(n == 1 for n in self.terms)

    def is_real(self) -> bool:
        """Tell whether the number is real."""
        return all(n > 0 for n in self.terms)

    def real(self) -> Surd:
        """Return the real part."""
        return Surd({n: c for n, c in self.terms.items() if n > 0})

    def imaginary(self) -> Surd:
        """Return the imaginary part, a real number."""
        return Surd({-n: c for n, c in self.terms.items() if n < 0})

    def ball(self, bits: int) -> Any:
        """Return a complex ball of flint around the number, computed with that many bits."""
        with flint.ctx.workprec(bits):
            re, im = flint.arb(0), flint.arb(0)
            for n, c in self.terms.items():
                part = flint.arb(abs(n)).sqrt() * flint.arb(c)
                re, im = (re + part, im) if n > 0 else (re, im + part)
            return flint.acb(re, im)

    def sign(self, flipped: int = 0) -> int:
        """Return the sign of a real number; with ``flipped`` = d, of the one with −√d for √d."""
        x = Surd({n: -c if n == flipped else c for n, c in self.terms.items()}) if flipped else self
        if len(x.terms) <= 1:
            return next((1 if c > 0 else -1 for c in x.terms.values()), 0)
        bits = 64
        while True:  # ends, for the number is not 0
            value = x.ball(bits).real
            if value > 0:
                return 1
            if value < 0:
                return -1
            bits *= 2

    def sqrt(self) -> Surd | None:
        """Return the principal square root if it is a sum of two surds or simpler; else None.

        ``√(a + b√n) = √((a+s)/2) ± √((a−s)/2)`` with ``s² = a² − b²n`` does it where s is rational.
        """
        if self.is_rational():
            return sqrt_rational(self.terms.get(1, _ZERO))
        others = [n for n in self.terms if n != 1]
        if len(others) > 1:
            return None
        n, a = others[0], self.terms.get(1, _ZERO)
        s = _rational_root(a * a - self.terms[n] ** 2 * n)
        if s is None:
            return None
        u, v = sqrt_rational((a + s) / 2), sqrt_rational((a - s) / 2)
        return principal(u + v if u * v * 2 == Surd({n: self.terms[n]}) else u - v)

    def text(self, style: str = "plain", imaginary: bool = True) -> str:
        """Write ``1/2+3*sqrt(2)``; ``√−7`` is ``I*sqrt(7)``, or ``sqrt(-7)`` if not ``imaginary``."""
        order = sorted(self.terms, key=lambda n: (n < 0, abs(n)))
        return sum_text(
            ((number_text(self.terms[n], style), _factors(n, style, imaginary)) for n in order),
            style,
        )

    def __repr__(self) -> str:
        return self.text()


ONE = Surd({1: flint.fmpq(1)})


def as_surd(x: Any) -> Surd | None:
    """Return a surd or a rational number as a surd; None for all else."""
    if type(x) is Surd:
        return x
    number = rational(x)
    return None if number is None else from_rational(number)


def from_rational(x: int | Fraction) -> Surd:
    """Return a rational number as a surd."""
    return Surd({1: fmpq(x)} if x else {})


def sqrt_rational(x: Any) -> Surd:
    """Return the principal root of flint's rational x; ``√−n`` is ``i·√n``."""
    if x == 0:
        return Surd({})
    outside, inside = squarefree(int(x.p) * int(x.q))
    return Surd({inside: flint.fmpq(outside, int(x.q))})


def squarefree(n: int) -> tuple[int, int]:
    """Return (s, f) with n = s²·f and f squarefree. Raises :class:`TooLargeError`."""
    root = isqrt(abs(n))
    if root * root == abs(n):
        return root, 1 if n > 0 else -1
    factors = factored(abs(n))
    if factors is None:
        raise TooLargeError(
            f"the square root of {shorten(number_text(n), 30)} needs its factors, which are out of "
            "quick reach"
        )
    outside, inside = 1, 1 if n > 0 else -1
    for p, exponent in factors:
        outside *= p ** (exponent // 2)
        inside *= p ** (exponent % 2)
    return outside, inside


def principal(x: Surd) -> Surd:
    """Return x or −x: the one with positive real part, or with real part 0 and positive imaginary."""
    sign = x.real().sign() or x.imaginary().sign()
    return x if sign >= 0 else -x


def _restore(pairs: list[tuple[int, int, int]]) -> Surd:
    return Surd({n: flint.fmpq(p, q) for n, p, q in pairs})


def _rational_root(x: Any) -> Any:
    if x < 0 or not (x.p.is_square() and x.q.is_square()):
        return None
    return flint.fmpq(x.p.isqrt(), x.q.isqrt())


@lru_cache(maxsize=65536)
def _product(m: int, n: int) -> tuple[int, int]:
    """Return (c, r) with √m·√n = c·√r for squarefree m, n, roots principal: √−2·√−3 = −√6."""
    common = gcd(m, n)
    root = (m // common) * (n // common)
    return (-common if m < 0 and n < 0 else common), root


@lru_cache(maxsize=4096)
def _prime_of(n: int) -> int:
    factors = factored(abs(n))
    if factors is None:
        raise TooLargeError(
            f"inverting needs the factors of {shorten(number_text(n), 30)}, which are out of reach"
        )
    return factors[0][0]


def _factors(n: int, style: str, imaginary: bool) -> list[Factor]:
    """Return √n as factors of a term."""
    out = []
    if n < 0 and (imaginary or n == -1):
        out.append(("I", 1))
        n = -n
    if n != 1:
        shown = f"√{n}" if n > 0 else f"√(−{-n})"
        out.append(({"plain": f"sqrt({n})", "latex": rf"\sqrt{{{n}}}"}.get(style, shown), 1))
    return out
