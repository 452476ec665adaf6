"""The value ζ_K(−1) of a totally real field, by Siegel's formula (cited), a sum over totally positive
numbers.

σ₁(νD) is summed over all ν in the inverse of the different D with Tr ν = l and positive conjugates. The sums
for the first few l, with coefficients that depend only on the degree of the field, give ζ_K(−1).
"""

from fractions import Fraction
from math import comb

from hfield.checker.budget import spend
from hfield.checker.number_fields.enumeration import short_vectors
from hfield.checker.number_fields.factoring import factored
from hfield.checker.number_fields.integers import Primes, RingOfIntegers
from hfield.checker.scalars.matrices import inverse_matrix


def zeta_minus_one(integers: RingOfIntegers, factors: Primes) -> Fraction:
    """Return ζ_K(−1) of a totally real field. Rejects if required prime ideals are missing."""
    n = integers.n
    if n == 1:  # where Siegel's sum does not begin
        return Fraction(-1, 12)
    coefficients = _coefficients(2 * n)
    sums = _sums(integers, factors, len(coefficients) - 1)
    total = sum((c * s for c, s in zip(coefficients[1:], sums, strict=True)), Fraction(0))
    return Fraction(-(2**n)) * total / coefficients[0]


def _coefficients(weight: int) -> list[Fraction]:
    """Return the coefficients of q⁰, q⁻¹, …, q⁻ʳ of E_w/Δʳ, where r is the dimension in this weight."""
    r = weight // 12 + (weight % 12 != 2)
    w = 12 * r - weight + 2
    series = [Fraction(1)] + [Fraction(0)] * r
    if w:
        factor = Fraction(-2 * w) / _bernoulli(w)
        for k in range(1, r + 1):
            series[k] = factor * sum(d ** (w - 1) for d in range(1, k + 1) if k % d == 0)
    for m in range(1, r + 1):  # times (1 − q^m)^(−24r)
        for _ in range(24 * r):
            for k in range(m, r + 1):
                series[k] += series[k - m]
    return series[::-1]


def _bernoulli(w: int) -> Fraction:
    found: list[Fraction] = []
    for m in range(w + 1):
        rest = sum((comb(m + 1, k) * b for k, b in enumerate(found)), Fraction(0))
        found.append((int(m == 0) - rest) / (m + 1))
    return found[w]


def _sums(integers: RingOfIntegers, factors: Primes, most: int) -> list[int]:
    """Return Σ σ₁(ν·D) for the traces l = 1, …, ``most``; the squares of the conjugates of ν sum to at most
    l².
    """
    n, d = integers.n, abs(integers.discriminant)
    form = [[integers.trace(integers.table[k][m]) for m in range(n)] for k in range(n)]
    dual = inverse_matrix([[Fraction(c) for c in row] for row in form])
    assert dual is not None, "the discriminant is not 0"
    rows = [tuple(int(c * d) for c in row) for row in dual]  # d times the dual basis
    gram = tuple(rows)  # and d·Tr(x·y) on it
    ones = [integers.trace(tuple(int(k == m) for m in range(n))) for k in range(n)]
    found = [0] * most
    for x, _ in short_vectors(gram, most * most * d):
        row = tuple(sum(c * r[k] for c, r in zip(x, rows, strict=True)) for k in range(n))
        trace = Fraction(sum(c * t for c, t in zip(row, ones, strict=True)), d)
        if trace < 0:
            row, trace = tuple(-c for c in row), -trace
        if 1 <= trace <= most and _positive(integers, row):
            found[int(trace) - 1] += _divisor_sum(integers, factors, row, rows)
    return found


def _positive(integers: RingOfIntegers, row: tuple[int, ...]) -> bool:
    """Return whether all conjugates of an integer of a totally real field are positive (by Newton)."""
    n, power, sums = integers.n, row, []
    for _ in range(n):
        sums.append(integers.trace(power))
        power = integers.mul(power, row)
    elementary = [Fraction(1)]
    for k in range(1, n + 1):
        total = sum(
            ((-1) ** (m - 1) * elementary[k - m] * sums[m - 1] for m in range(1, k + 1)),
            Fraction(0),
        )
        elementary.append(total / k)
    return all(e > 0 for e in elementary)


def _divisor_sum(
    integers: RingOfIntegers, factors: Primes, row: tuple[int, ...], dual: list[tuple[int, ...]]
) -> int:
    """Return the sum of the norms of the divisors of ν·D, given d·ν, and d·D⁻¹ by a basis."""
    d = abs(integers.discriminant)
    size, out = abs(integers.norm(row)) * d // d**integers.n, 1
    for p, e in factored(size).items():
        if e == 1:
            out *= 1 + p
            continue
        spend(50)
        for P in factors.at(p):
            v = P.valuation(row) - min(map(P.valuation, dual))
            out *= (P.norm ** (v + 1) - 1) // (P.norm - 1)
    return out
