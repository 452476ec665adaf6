"""Sums of rational multiples of square roots of integers: exact, canonical, hashable, without sympy.

QQ(sqrt(d)), QQ(I) and most numbers that people type into RR or CC lie in these fields, ℚ(√n₁, √n₂, …). Square
roots of integers in different square classes are linearly independent over ℚ (Besicovitch, 1940), so a number
is 0 exactly if all its coefficients are. :mod:`.radicands` picks the representatives of the classes: they are
squarefree, apart from long ones that were not factored.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import flint

from hfield.errors import NotInvertibleError, TooLargeError
from hfield.fields.algebraic.radicands import independent, is_long, odd, product, ratio, reduced
from hfield.fields.base.balls import fingerprint, precision
from hfield.fields.base.coercion import fmpq, rational
from hfield.fields.base.printing import Factor, number_text, sum_text
from hfield.fields.base.registry import REGISTRY
from hfield.sympy_printing import PrintedBySympy

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.ring import Ring

MAX_TERMS = 1024

_ZERO = flint.fmpq(0)


class Surd(PrintedBySympy):
    """An immutable number ``Σ cₙ·√n`` over integers n; ``√−n`` is ``i·√n`` for n > 0.

    ``terms`` maps n to the rational cₙ ≠ 0. The √n are the principal roots. No product of two different n is
    a square, and no n but 1 is a square. They are squarefree if they could be factored.
    """

    __slots__ = ("terms",)

    terms: dict[int, flint.fmpq]

    def __init__(self, terms: dict[int, flint.fmpq]) -> None:
        object.__setattr__(self, "terms", terms)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("numbers are immutable")

    @staticmethod
    def common_field(*numbers: object) -> Ring | None:
        """Return the field ℚ(√d) of numbers with one square root. Raises :class:`RingError` for several
        roots.
        """
        return REGISTRY.functions.common_quadratic_field(*numbers)

    def __reduce__(self) -> tuple[object, ...]:
        pairs = [(n, int(c.p), int(c.q)) for n, c in self.terms.items()]
        return _restore, (pairs,)

    # --- arithmetic ----------------------------------------------------------------------------

    def __add__(self, other: object) -> Surd:
        o = as_surd(other)
        if o is None:
            return NotImplemented
        terms = dict(self.terms)
        for n, c in o.terms.items():
            if n not in terms:
                terms[n] = c
            elif total := terms[n] + c:
                terms[n] = total
            else:
                del terms[n]
        return Surd(_collected(terms) if is_long(terms) else terms)

    __radd__ = __add__

    def __neg__(self) -> Surd:
        return Surd({n: -c for n, c in self.terms.items()})

    def __pos__(self) -> Surd:
        return self

    def __sub__(self, other: object) -> Surd:
        o = as_surd(other)
        return NotImplemented if o is None else self + -o

    def __rsub__(self, other: object) -> Surd:
        o = as_surd(other)
        return NotImplemented if o is None else o + -self

    def __mul__(self, other: object) -> Surd:
        o = as_surd(other)
        if o is None:
            return NotImplemented
        if len(self.terms) * len(o.terms) > MAX_TERMS**2:
            raise TooLargeError(
                f"a number with more than {MAX_TERMS} square roots; compute in parts"
            )
        terms: dict[int, flint.fmpq] = {}
        for m, c in self.terms.items():
            for n, d in o.terms.items():
                factor, root = product(m, n)
                term = c * d if factor == 1 else c * d * factor
                terms[root] = terms[root] + term if root in terms else term
        if is_long(terms):
            return Surd(_collected(terms))
        return Surd({n: c for n, c in terms.items() if c})

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Surd:
        o = as_surd(other)
        return NotImplemented if o is None else self * o.inverse()

    def __rtruediv__(self, other: object) -> Surd:
        o = as_surd(other)
        return NotImplemented if o is None else o * self.inverse()

    def __pow__(self, n: int) -> Surd:
        from hfield.fields.base.powers import power

        return power(ONE, self if n >= 0 else self.inverse(), abs(n))

    def inverse(self) -> Surd:
        """Return 1/self, by multiplying by the conjugates with respect to one independent root
        after another.
        """
        if not self.terms:
            raise NotInvertibleError("cannot divide by 0")
        top, bottom = ONE, self
        while not bottom.is_rational():
            base = independent(frozenset(bottom.terms))  # anew: squares may have come out
            n = next(n for n in bottom.terms if n != 1)
            conjugate = bottom.conjugate_at(-1 if n < 0 else next(b for b in base if odd(n, b)))
            top, bottom = top * conjugate, bottom * conjugate
        c = 1 / bottom.terms[1]
        return Surd({n: c * d for n, d in top.terms.items()})

    def conjugate_at(self, b: int) -> Surd:
        """Return the number with √b replaced by −√b, where b is −1 (complex conjugation) or an independent
        radicand.
        """
        return Surd(
            {n: -c if (n < 0 if b == -1 else odd(n, b)) else c for n, c in self.terms.items()}
        )

    def __eq__(self, other: object) -> bool:
        o = as_surd(other)
        if o is None:
            return NotImplemented
        if self.terms == o.terms:
            return True
        return (is_long(self.terms) or is_long(o.terms)) and not (self - o).terms

    def __hash__(self) -> int:
        if self.is_rational():
            return hash(self.terms.get(1, _ZERO))
        return hash(fingerprint(self.ball))

    # --- what it is ----------------------------------------------------------------------------

    def is_rational(self) -> bool:
        """Return whether the number is rational."""
        return all(n == 1 for n in self.terms)

    def is_real(self) -> bool:
        """Return whether the number is real."""
        return all(n > 0 for n in self.terms)

    def real(self) -> Surd:
        """Return the real part."""
        return Surd({n: c for n, c in self.terms.items() if n > 0})

    def imaginary(self) -> Surd:
        """Return the imaginary part, a real number."""
        return Surd({-n: c for n, c in self.terms.items() if n < 0})

    def over(self, d: int) -> Surd | None:
        """Return the number written in terms of 1 and √d alone, if that is possible."""
        terms = {1: self.terms[1]} if 1 in self.terms else {}
        for n, c in self.terms.items():
            if n != 1:
                same = ratio(n, d)
                if same is None:
                    return None
                terms[d] = c * flint.fmpq(*same)
        return Surd(terms)

    def ball(self, bits: int) -> flint.acb:
        """Return a complex ball of flint around the number, computed with ``bits`` bits."""
        with precision(bits):
            re, im = flint.arb(0), flint.arb(0)
            for n, c in self.terms.items():
                part = flint.arb(abs(n)).sqrt() * flint.arb(c)
                re, im = (re + part, im) if n > 0 else (re, im + part)
            return flint.acb(re, im)

    def sign(self, flipped: int = 0) -> int:
        """Return the sign of a real number; with ``flipped`` = d, the sign of its image under √d ↦ −√d."""
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

    def sqrt(self, within: int | None = None) -> Surd | None:
        """Return the principal square root if it is a sum of at most two square roots of rational numbers;
        else None.

        With ``within`` = d, only if it lies in ℚ(√d); then nothing is factored. The formula is ``√(a + b√n) =
        √((a+s)/2) ± √((a−s)/2)`` with ``s² = a² − b²n``, if s is rational.
        """
        others = [n for n in self.terms if n != 1]
        if len(others) > 1:
            return None
        n, a = others[0] if others else 1, self.terms.get(1, _ZERO)
        s = _rational_root(a * a - self.terms[n] ** 2 * n) if others else a
        if s is None:
            return None
        halves = (a + s) / 2, (a - s) / 2
        if within is None:
            u, v = (sqrt_rational(x, n) for x in halves)
        else:
            near = [r for x in halves if (r := root_near(x, 1) or root_near(x, within)) is not None]
            if len(near) < 2:
                return None
            u, v = near
        return principal(u + v if not others or u * v * 2 == Surd({n: self.terms[n]}) else u - v)

    def text(self, style: str = "plain", imaginary: bool = True) -> str:
        """Write ``1/2+3*sqrt(2)``; ``√−7`` is ``I*sqrt(7)``, or ``sqrt(-7)`` if not ``imaginary``."""
        order = sorted(self.terms, key=lambda n: (n < 0, abs(n)))
        return sum_text(
            ((number_text(self.terms[n], style), _factors(n, style, imaginary)) for n in order),
            style,
        )

    def __repr__(self) -> str:
        """Write a number of QQ(sqrt(-7)) in the form that this field, which has no I, reads; CC
        reads it too.
        """
        return self.text(imaginary=not self.terms.keys() <= {1, min(self.terms, default=1)})

    def _repr_latex_(self) -> str:
        return f"${self.text('latex')}$"

    def _sympy_(self) -> sympy.Expr:
        return sympy_of(self)


ONE = Surd({1: flint.fmpq(1)})


def as_surd(x: object) -> Surd | None:
    """Return a surd or a rational number as a surd; None for anything else."""
    if type(x) is Surd:
        return x
    number = rational(x)
    return None if number is None else from_rational(number)


def sympy_of(x: Surd) -> sympy.Expr:
    """Return a surd as a sympy expression."""
    import sympy

    terms = (sympy.Rational(int(c.p), int(c.q)) * sympy.sqrt(n) for n, c in x.terms.items())
    return sympy.Add(*terms)


def from_rational(x: int | Fraction) -> Surd:
    """Return a rational number as a surd."""
    return Surd({1: fmpq(x)} if x else {})


def sqrt_rational(x: flint.fmpq, near: int = 1) -> Surd:
    """Return the principal root of a flint rational x; ``√−n`` is ``i·√n``.

    Nothing is factored if the root is a rational multiple of ``√near``.
    """
    root = root_near(x, near)
    if root is not None:
        return root
    outside, inside = reduced(int(x.p) * int(x.q))
    return Surd({inside: flint.fmpq(outside, int(x.q))})


def root_near(x: flint.fmpq, n: int) -> Surd | None:
    """Return the principal root of a flint rational x if it is a rational multiple of √n; else None."""
    if x == 0:
        return Surd({})
    same = ratio(int(x.p) * int(x.q), n)
    return None if same is None else Surd({n: flint.fmpq(same[0], same[1] * int(x.q))})


def principal(x: Surd) -> Surd:
    """Return whichever of x and −x has positive real part, or real part 0 and positive imaginary part."""
    sign = x.real().sign() or x.imaginary().sign()
    return x if sign >= 0 else -x


def _restore(pairs: list[tuple[int, int, int]]) -> Surd:
    return Surd({n: flint.fmpq(p, q) for n, p, q in pairs})


def _rational_root(x: flint.fmpq) -> flint.fmpq | None:
    if x < 0 or not (x.p.is_square() and x.q.is_square()):
        return None
    return flint.fmpq(x.p.isqrt(), x.q.isqrt())


def _collected(terms: dict[int, flint.fmpq]) -> dict[int, flint.fmpq]:
    """Return the terms with one radicand for each square class and without zero coefficients."""
    out: dict[int, flint.fmpq] = {}
    for n, c in sorted(terms.items(), key=lambda term: abs(term[0])):
        m, scale = next(((m, r) for m in out if (r := ratio(n, m))), (n, (1, 1)))
        out[m] = out.get(m, _ZERO) + c * flint.fmpq(*scale)
    return {n: c for n, c in out.items() if c != 0}


def _factors(n: int, style: str, imaginary: bool) -> list[Factor]:
    """Return √n as the factors of a term."""
    out = []
    if n < 0 and (imaginary or n == -1):
        out.append(("I", 1))
        n = -n
    if n != 1:
        shown = f"√{n}" if n > 0 else f"√(−{-n})"
        out.append(({"plain": f"sqrt({n})", "latex": rf"\sqrt{{{n}}}"}.get(style, shown), 1))
    return out
