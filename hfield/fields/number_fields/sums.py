"""Sums of algebraic numbers: their minimal polynomials, and both numbers as polynomials in the sum."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import flint

from hfield.fields.base.balls import precision
from hfield.fields.base.roots import common_divisor, multiplied
from hfield.fields.number_fields.elements import FieldElement

if TYPE_CHECKING:
    from hfield.fields.number_fields.ring import NumberField

BITS = 256

Value = Callable[[int], flint.acb]


def factor_at(polynomial: flint.fmpq_poly, value: Value) -> flint.fmpq_poly:
    """Return the monic irreducible factor that has a given number as a root."""
    factors = [g / g.leading_coefficient() for g, _ in polynomial.factor()[1]]
    bits = BITS
    while len(factors) > 1:
        with precision(bits + 16):
            z = value(bits)
            factors = [g for g in factors if _at(g, z).contains(0)]
        bits *= 2
    return factors[0]


def _at(polynomial: flint.fmpq_poly, z: flint.acb) -> flint.acb:
    total = flint.acb(0)
    for c in reversed(polynomial.coeffs()):
        total = total * z + flint.acb(c)
    return total


def roots_in(field: NumberField, f: flint.fmpq_poly) -> list[FieldElement]:
    """Return the roots in the field of an irreducible polynomial over ℚ (Trager, 1976).

    The polynomial of all sums of a root of f and a multiple of s has, for each such root, a factor whose
    degree is that of the field.
    """
    f = f / f.leading_coefficient()
    for scale in range(1, 100):
        whole = sums_of_roots(f, field.polynomial, scale)
        if whole.gcd(whole.derivative()).degree() == 0:
            break
    out = []
    for factor, _ in whole.factor()[1]:
        if factor.degree() == field.degree:
            # h(β + k·s) = 0 as a condition on s + β/k
            stretched = flint.fmpq_poly([c * scale**n for n, c in enumerate(factor.coeffs())])
            out.append(common_root(field, f, stretched, flint.fmpq(-1, scale)))
    return out


def sums_of_roots(f: flint.fmpq_poly, g: flint.fmpq_poly, scale: int) -> flint.fmpq_poly:
    """Return the polynomial whose roots are α + scale·β for the roots α of f and β of g, by Newton's sums."""
    m, n = int(f.degree()), int(g.degree())
    size = m * n
    p, q = _newton_sums(f, size), _newton_sums(g, size)
    sums = [
        sum(
            (math.comb(k, j) * p[k - j] * q[j] * scale**j for j in range(k + 1)),
            flint.fmpq(0),
        )
        for k in range(size + 1)
    ]
    e = [flint.fmpq(1)]
    for k in range(1, size + 1):
        e.append(
            sum(((-1) ** (j - 1) * e[k - j] * sums[j] for j in range(1, k + 1)), flint.fmpq(0)) / k
        )
    return flint.fmpq_poly([(-1) ** k * e[k] for k in range(size, -1, -1)])


def _newton_sums(f: flint.fmpq_poly, count: int) -> list[flint.fmpq]:
    """Return the sums of the k-th powers of the roots of a monic polynomial, for k up to ``count``."""
    n = int(f.degree())
    e = [(-1) ** k * f[n - k] for k in range(n + 1)]
    sums = [flint.fmpq(n)]
    for k in range(1, count + 1):
        total = (-1) ** (k - 1) * k * e[k] if k <= n else flint.fmpq(0)
        for j in range(1, min(k, n + 1)):
            total = total + (-1) ** (j - 1) * e[j] * sums[k - j]
        sums.append(total)
    return sums


def common_root(
    field: NumberField, f: flint.fmpq_poly, g: flint.fmpq_poly, scale: flint.fmpq | int
) -> FieldElement:
    """Return the only common root β of f(x) and g(θ − scale·x), where θ is the generator."""
    line = [field.gen, field(-scale)]
    first = [field(c) for c in f.coeffs()]
    second = [field(0)]
    for c in reversed(g.coeffs()):
        second = multiplied(field, second, line)
        second[0] = second[0] + c
    root: FieldElement = -common_divisor(field, first, second)[0]
    return root


def evaluate(field: NumberField, poly: flint.fmpq_poly, x: FieldElement) -> FieldElement:
    """Return the value of a polynomial over ℚ at an element."""
    total: FieldElement = field.zero
    for c in reversed(poly.coeffs()):
        total = total * x + c
    return total
