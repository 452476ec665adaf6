"""The exact value ζ_K(−1) for a totally real field K, by Siegel's formula.

Restricted to the diagonal, Hecke's Eisenstein series of weight 2 is a modular form of weight 2n for SL₂(ℤ).
Its constant term is ζ_K(−1), and its l-th coefficient is 2ⁿ·Σ σ₁(ν·D), summed over the totally positive ν of
trace l in the inverse of the different D. The product with E_w/Δʳ has weight 2 and constant term 0, so the r
coefficients after the constant term determine the constant term (C. L. Siegel, *Nachr. Akad. Wiss.
Göttingen*, 1969).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from operator import mul
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import factorise
from hfield.errors import RingError, TooLargeError, shorten
from hfield.fields.base.balls import precision
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ideals import MaximalOrder, integers
from hfield.fields.number_fields.integral_basis import element_of

if TYPE_CHECKING:
    from hfield.fields.number_fields.prime_ideals import PrimeIdeal
    from hfield.fields.number_fields.ring import NumberField

DIGITS = 64
"""Binary digits of conjugates that tell that a number is not totally positive."""
MAX_ELEMENTS = 2_000_000
"""So many lattice points at most are gone through for a value."""


@lru_cache(maxsize=1024)
def zeta_minus_one(ring: NumberField) -> Fraction:
    """Return ζ_K(−1). Raises :class:`RingError` if K is not totally real, and :class:`TooLargeError`."""
    frame = integers(ring)
    n = frame.n
    if frame.field.signature != (n, 0):
        raise RingError(
            f"ζ_K(−1) is 0 for {shorten(ring.name)}, which is not totally real; expected one that is"
        )
    if n == 1:
        return Fraction(-1, 12)  # of weight 2 Hecke's series is no modular form
    if math.isqrt(frame.field.discriminant()) * 2 ** (n - 2) > MAX_ELEMENTS:
        raise TooLargeError(
            f"ζ_K(−1) of {shorten(ring.name)} is a sum over too many elements: the discriminant is too large"
        )
    sums = _Sums(frame)
    c = _pole(2 * n)
    total = sum((c[k] * sums.coefficient(k) for k in range(1, len(c))), Fraction(0))
    found: Fraction = -(2**n) * total / c[0]
    return found


def _pole(weight: int) -> list[Fraction]:
    """Return the coefficients of q⁰, q⁻¹, …, q⁻ʳ of E_w/Δʳ, where r is the dimension in this weight."""
    r = weight // 12 + (weight % 12 != 2)
    w = 12 * r - weight + 2
    series = [Fraction(1)] + [Fraction(0)] * r
    if w:
        b = flint.fmpq.bernoulli(w)
        factor = Fraction(-2 * w * int(b.q), int(b.p))
        for k in range(1, r + 1):
            series[k] = factor * sum(d ** (w - 1) for d in range(1, k + 1) if k % d == 0)
    for m in range(1, r + 1):  # times (1 − q^m)^(−24r)
        for _ in range(24 * r):
            for k in range(m, r + 1):
                series[k] += series[k - m]
    return series[::-1]


class _Sums:
    """Sums of σ₁(ν·D) over totally positive ν in D⁻¹ of given trace."""

    def __init__(self, frame: MaximalOrder) -> None:
        self.frame, n = frame, frame.n
        self.different = frame.codifferent.inverse()
        self.exponents = dict(self._different_exponents())
        rows = frame.codifferent.rows
        form = frame.trace_form
        traces = [int(element_of(frame.field, row).trace().p) for row in rows.tolist()]
        both = [[t, *(int(i == j) for j in range(n))] for i, t in enumerate(traces)]
        change = [row[1:] for row in flint.fmpz_mat(both).hnf().tolist()]
        basis = flint.fmpq_mat(flint.fmpz_mat(change)) * rows  # traces 1, 0, …, 0
        first, rest = basis.tolist()[0], flint.fmpq_mat(basis.tolist()[1:])
        gram, _ = (rest * form * rest.transpose()).numer_denom()
        reduction = gram.lll(transform=True, rep="gram")[1]
        rest = flint.fmpq_mat(reduction) * rest
        self.basis = flint.fmpq_mat([*rest.tolist(), first])
        whole = (self.basis * form * self.basis.transpose()).tolist()
        self.gram = [[Fraction(int(c.p), int(c.q)) for c in row] for row in whole]
        self.conjugates = self._conjugates()

    def _conjugates(self) -> list[list[int]]:
        """Return the conjugates of the basis times 2^DIGITS, place by place, with errors below 1."""
        embeddings, places = self.frame.field.embeddings, range(self.frame.n)
        elements = [element_of(self.frame.field, row) for row in self.basis.tolist()]
        values = [[embeddings.value(x.poly, k, 2 * DIGITS).real for x in elements] for k in places]
        with precision(2 * DIGITS):
            return [[_near(c * flint.arb(2) ** DIGITS) for c in row] for row in values]

    def _different_exponents(self) -> Iterator[tuple[PrimeIdeal, int]]:
        for p in factorise(int(self.different.norm())) if self.different.norm() != 1 else ():
            for prime in self.frame.field.primes_above(p):
                e = min(prime.valuation(x) for x in self.different.basis)
                if e:
                    yield prime, e

    def coefficient(self, trace: int) -> int:
        """Return the sum of the divisor sums over the totally positive elements of a given trace."""
        return sum(self._divisor_sum(x) for x in self._positive(trace))

    def _positive(self, trace: int) -> Iterator[FieldElement]:
        """Yield the totally positive elements; the squares of their conjugates add up to at most l²."""
        for row in _points(self.gram, trace, Fraction(trace * trace)):
            error = sum(map(abs, row))
            if any(sum(map(mul, row, c)) < -error for c in self.conjugates):
                continue
            whole = flint.fmpq_mat(flint.fmpz_mat(1, self.frame.n, row)) * self.basis
            x = element_of(self.frame.field, whole.entries())
            signs = self.frame.field.multiplication(x).charpoly().coeffs()
            if all(c * (-1) ** (self.frame.n - k) > 0 for k, c in enumerate(signs)):
                yield x

    def _divisor_sum(self, x: FieldElement) -> int:
        """Return the sum of the norms of the ideals that divide x·D."""
        size = abs(x.norm()) * flint.fmpq(int(self.different.norm()))
        out = 1
        for p, k in factorise(int(size.p)).items() if size != 1 else ():
            if k == 1:
                out *= 1 + p
                continue
            for prime in self.frame.field.primes_above(p):
                e = prime.valuation(x) + self.exponents.get(prime, 0)
                out *= (prime.norm() ** (e + 1) - 1) // (prime.norm() - 1)
        return out


def _near(x: flint.arb) -> int:
    """Return an integer at distance less than 1 from the number enclosed in a narrow ball."""
    assert x.rad() < 0.5
    return int((x.mid() + flint.arb(0.5)).mid().floor().unique_fmpz())


def _points(gram: list[list[Fraction]], last: int, bound: Fraction) -> Iterator[list[int]]:
    """Yield the integer vectors with a given last entry at which a definite form is at most a given bound.

    The form is a sum of dₖ·(xₖ + Σ m[k][j]·xⱼ)², j > k; entries are chosen from the last to the first (Fincke
    and Pohst).
    """
    n = len(gram)
    g = [row[:] for row in gram]
    for k in range(n):
        for i in range(k + 1, n):
            factor = g[k][i] / g[k][k]
            for j in range(i, n):
                g[i][j] -= factor * g[k][j]
                g[j][i] = g[i][j]
    m = [[g[k][j] / g[k][k] for j in range(n)] for k in range(n)]
    x = [0] * n
    x[n - 1] = last

    def choose(k: int, left: Fraction) -> Iterator[list[int]]:
        if k < 0:
            yield x
            return
        shift = sum((m[k][j] * x[j] for j in range(k + 1, n)), Fraction(0))
        # |x + u/v| ≤ √(left/d): exact integer roots
        u, v = shift.numerator, shift.denominator
        ratio = left / g[k][k]
        radius = math.isqrt(ratio.numerator * v * v // ratio.denominator)
        for value in range(-((u + radius) // v), (radius - u) // v + 1):
            x[k] = value
            yield from choose(k - 1, left - g[k][k] * (value + shift) ** 2)

    yield from choose(n - 2, bound - g[n - 1][n - 1] * last * last)
