"""Polynomials over a ring, and F(t): fractions of them, equal when they cross-multiply to the same."""

from itertools import zip_longest
from typing import Any

from hfield.certificates.language import Tree
from hfield.certificates.rejection import reject
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.work import charge

MAX_TERMS = 4_000

Poly = tuple[tuple[tuple[int, ...], Any], ...]  # exponents and nonzero coefficients, in order
Fraction = tuple[Poly, Poly]


class Polynomials(Ring):
    """``base[names]``, the base being a domain."""

    is_integral = True

    def __init__(self, base: Ring, names: tuple[str, ...], name: str) -> None:
        self.base, self.names, self.name = base, names, name
        self.characteristic = base.characteristic
        self.zero: Poly = ()
        self.one: Poly = self._constant(base.one)

    def number(self, n: int) -> Poly:
        """Return n·1."""
        return self._constant(self.base.number(n))

    def add(self, x: Poly, y: Poly) -> Poly:
        """Return x + y."""
        out = dict(x)
        for m, c in y:
            out[m] = self.base.add(out[m], c) if m in out else c
        return self._poly(out)

    def neg(self, x: Poly) -> Poly:
        """Return −x."""
        return tuple((m, self.base.neg(c)) for m, c in x)

    def mul(self, x: Poly, y: Poly) -> Poly:
        """Return x·y."""
        if len(x) * len(y) > MAX_TERMS**2 // 16:
            reject(f"an element of {self.name} has grown too large")
        charge(5 * len(x) * len(y))
        out: dict[tuple[int, ...], Any] = {}
        for m, c in x:
            for n, d in y:
                key = tuple([a + b for a, b in zip(m, n, strict=True)])
                term = self.base.mul(c, d)
                out[key] = self.base.add(out[key], term) if key in out else term
        return self._poly(out)

    def inverse(self, x: Poly) -> Poly | None:
        """Return 1/x for a constant unit (the base is a domain)."""
        if len(x) != 1 or any(x[0][0]):
            return None
        c = self.base.inverse(x[0][1])
        return None if c is None else self._constant(c)

    def constant(self, tree: Tree) -> Any:
        """Return a variable, or a constant of the base."""
        if tree[0] == "name" and tree[1] in self.names:
            place = self.names.index(tree[1])
            return ((tuple(int(n == place) for n in range(len(self.names))), self.base.one),)
        c = self.base.constant(tree)
        return None if c is None else self._constant(c)

    def _constant(self, c: Any) -> Poly:
        return () if self.base.is_zero(c) else (((0,) * len(self.names), c),)

    def _poly(self, values: dict[tuple[int, ...], Any]) -> Poly:
        out = tuple(sorted((m, c) for m, c in values.items() if not self.base.is_zero(c)))
        if len(out) > MAX_TERMS:
            reject(f"an element of {self.name} has more than {MAX_TERMS} terms")
        return out


class Functions(Ring):
    """``base(name)``, the rational functions in one variable over a field."""

    is_field = True

    def __init__(self, base: Ring, name: str, text: str) -> None:
        self.name, self.base = text, base
        self.polynomials = Polynomials(base, (name,), text)
        self.characteristic = base.characteristic
        self.zero: Fraction = ((), self.polynomials.one)
        self.one: Fraction = (self.polynomials.one, self.polynomials.one)

    def number(self, n: int) -> Fraction:
        """Return n·1."""
        return self._fraction(self.polynomials.number(n), self.polynomials.one)

    def add(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x + y."""
        p = self.polynomials
        if x[1] == y[1]:
            return self._fraction(p.add(x[0], y[0]), x[1])
        return self._fraction(p.add(p.mul(x[0], y[1]), p.mul(y[0], x[1])), p.mul(x[1], y[1]))

    def neg(self, x: Fraction) -> Fraction:
        """Return −x."""
        return (self.polynomials.neg(x[0]), x[1])

    def mul(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x·y."""
        p = self.polynomials
        return self._fraction(p.mul(x[0], y[0]), p.mul(x[1], y[1]))

    def inverse(self, x: Fraction) -> Fraction | None:
        """Return 1/x, None for 0."""
        return self._fraction(x[1], x[0]) if x[0] else None

    def is_zero(self, x: Fraction) -> bool:
        """Tell whether x is 0."""
        return not x[0]

    def constant(self, tree: Tree) -> Any:
        """Return the variable, or a constant of the base."""
        x = self.polynomials.constant(tree)
        return None if x is None else (x, self.polynomials.one)

    def sign(self, x: Fraction) -> int | None:
        """Return the sign for large values of the variable, where the base is ordered."""
        if self.base.sign(self.base.one) is None:
            return None
        if not x[0]:
            return 0
        signs = [self.base.sign(part[-1][1]) for part in x]
        return None if None in signs else (signs[0] or 0) * (signs[1] or 0)

    def signs(self, x: Fraction) -> tuple[int | None, ...]:
        """Return the signs for large and for small values of the variable, positive and negative."""
        sign = self.sign(x)
        if sign is None or not x[0]:
            return (sign,) * 4
        out = []
        for end in (-1, 0):
            terms = [part[end] for part in x]
            plus = (self.base.sign(terms[0][1]) or 0) * (self.base.sign(terms[1][1]) or 0)
            odd = (terms[0][0][0] + terms[1][0][0]) % 2
            out += [plus, -plus if odd else plus]
        return tuple(out)

    def _fraction(self, top: Poly, below: Poly) -> Fraction:
        """Divide by the greatest common divisor, so that sums stay small."""
        if not top:
            return self.zero
        if len(below) == 1 and not any(below[0][0]):
            return (self._scaled(top, below[0][1]), self.polynomials.one)
        divisor = self._gcd(dense(top, self.base), dense(below, self.base))
        f, g = (self.divided(dense(x, self.base), divisor)[0] for x in (top, below))
        lead = self.base.inverse(g[-1])
        return self._sparse(f, lead), self._sparse(g, lead)

    def _scaled(self, f: Poly, c: Any) -> Poly:
        inverse = self.base.inverse(c)
        return tuple((m, self.base.mul(d, inverse)) for m, d in f)

    def _sparse(self, f: list[Any], scale: Any) -> Poly:
        return tuple(
            ((n,), self.base.mul(c, scale)) for n, c in enumerate(f) if not self.base.is_zero(c)
        )

    def divided(self, f: list[Any], g: list[Any]) -> tuple[list[Any], list[Any]]:
        """Return quotient and remainder; low degree first, no leading zeros."""
        b, f = self.base, list(f)
        lead = b.inverse(g[-1])
        quotient = [b.zero] * max(len(f) - len(g) + 1, 0)
        while len(f) >= len(g):
            charge(10 * len(f))
            shift, c = len(f) - len(g), b.mul(f[-1], lead)
            quotient[shift] = c
            f = [
                b.add(u, b.neg(b.mul(c, v))) if v is not None else u
                for u, v in zip_longest(f, [None] * shift + g)
            ]
            while f and b.is_zero(f[-1]):
                f.pop()
        return quotient, f

    def _gcd(self, f: list[Any], g: list[Any]) -> list[Any]:
        while g:
            f, g = g, self.divided(f, g)[1]
        return f


MAX_DEGREE = 2_000


def dense(f: Poly, base: Ring) -> list[Any]:
    """Return the coefficients of a polynomial in one variable, low degree first."""
    if not f:
        return []
    if f[-1][0][0] > MAX_DEGREE:
        reject(f"a polynomial has a degree above {MAX_DEGREE}")
    out = [base.zero] * (f[-1][0][0] + 1)
    for (n,), c in f:
        out[n] = c
    return out
