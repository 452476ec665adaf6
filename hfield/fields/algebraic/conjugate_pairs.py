"""Sums and products of conjugate roots of a polynomial over ℚ, both in one field: the factors over ℝ."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import count
from typing import TYPE_CHECKING

import flint

from hfield.fields.algebraic.closed_forms import Closed, number
from hfield.fields.algebraic.in_fields import (
    Numbered,
    at,
    coefficients,
    inverse_modulo,
    located,
    monic,
    of_power_sums,
    trace,
    traces,
)
from hfield.fields.algebraic.polynomial_roots import NormOfPair, Root, TraceOfPair
from hfield.fields.algebraic.surds import Surd, from_rational
from hfield.fields.algebraic.text import closed_text
from hfield.fields.base.balls import precision
from hfield.fields.base.isolated_roots import isolated_roots

if TYPE_CHECKING:
    import sympy

MAX_PAIRED = 16  # the degree of polynomials for pairs of whose roots a field is made


def factors(
    g: flint.fmpq_poly, is_real: bool, short: Sequence[Closed]
) -> list[list[Surd | Closed]]:
    """Return the real factors, or the linear ones, of an irreducible polynomial over ℚ of degree 3 or more.

    ``short`` contains expressions for some of its roots, or none.
    """
    c = coefficients(g)
    spelled = {located([c], z.ball)[0]: z.expr for z in short}

    def linear(n: int) -> list[Surd | Closed]:
        root = (n, *c)
        return [-at(root, flint.fmpq_poly([0, 1]), spelled.get(n, Root(*root))), from_rational(1)]

    if not is_real:
        return [linear(n) for n in range(len(c) - 1)]
    real = isolated_roots(c).real_count
    quadratic = []
    for n in range(real, len(c) - 1, 2):
        t, norm = trace_and_norm((n, *c), [spelled[m] for m in (n, n + 1) if m in spelled])
        quadratic.append([norm, -t, from_rational(1)])
    return [linear(n) for n in range(real)] + quadratic


def trace_and_norm(
    root: Numbered, short: Sequence[sympy.Expr]
) -> tuple[Surd | Closed, Surd | Closed]:
    """Return the sum and the product of a root above the real axis and its conjugate, in one field if the
    field is small.

    ``short`` contains expressions for the two roots, or none.
    """
    spelled = [TraceOfPair(*root), NormOfPair(*root)]
    if short:
        of_short = (short[0] + short[1], (short[0] * short[1]).expand())
        pairs = zip(of_short, spelled, strict=True)
        spelled = [min(pair, key=lambda e: len(closed_text(e))) for pair in pairs]
    c = root[1:]
    if len(c) - 1 > MAX_PAIRED:
        return number(spelled[0]), number(spelled[1])
    shift, whole, trace, norm = _of_pairs(c)

    def alpha(bits: int) -> flint.acb:
        z = isolated_roots(c).numbered(root[0], bits)
        with precision(bits):
            return flint.acb(2 * (z + shift * z * z).real)

    of_pair = located([coefficients(h) for h, _ in whole.factor()[1]], alpha)
    modulus = monic(of_pair[1:])
    below = inverse_modulo(tuple((whole.derivative() % modulus).coeffs()), of_pair[1:])
    values = [part * below % modulus for part in (trace, norm)]
    t, n = (
        at(of_pair, value, None if _is_quadratic(value, modulus) else expr)
        for value, expr in zip(values, spelled, strict=True)
    )
    return t, n


def _is_quadratic(value: flint.fmpq_poly, modulus: flint.fmpq_poly) -> bool:
    """Return whether the square is one of the 1, x over ℚ."""
    square, top = value * value % modulus, max(value.degree(), 0)
    return bool(top == 0 or (square - value * (square[top] / value[top])).degree() < 1)


@lru_cache(maxsize=64)
def _of_pairs(c: tuple[int, ...]) -> tuple[int, flint.fmpq_poly, flint.fmpq_poly, flint.fmpq_poly]:
    """Return s, S, T and N: for two roots y, z, α = y + z + s·(y² + z²) is a root of S, and different pairs
    have different α.

    y + z = T(α)/S′(α), y·z = N(α)/S′(α) (F. Rouillier, AAECC 9 (1999)). Sums over pairs are computed from E =
    Σ exp(u·x) over the roots, with u = z + s·z², as E(x)² − E(2x).
    """
    f, x = monic(c), flint.fmpq_poly([0, 1])
    size = (d := f.degree()) * (d - 1) // 2 + 1
    of_basis, factorials = traces(f), [flint.fmpz.fac_ui(n) for n in range(size)]
    for shift in count():  # two pairs have one α for one s at most
        u, power = (x + shift * x * x) % f, flint.fmpq_poly([1])
        rows: list[list[flint.fmpq]] = [[], [], []]  # Σ zⁿ·uᵏ/k!
        for factorial in factorials:
            for n, row in enumerate(rows):
                row.append(trace(power * x**n % f, of_basis) / factorial)
            power = power * u % f
        one, z, square = map(flint.fmpq_poly, rows)
        weighted = (  # by 1, y + z and y·z
            (one * one - one(2 * x)) / 2,
            z * one - z(2 * x),
            (z * z - square(2 * x)) / 2,
        )
        sums, *others = ([w[k] * factorials[k] for k in range(size)] for w in weighted)
        whole = of_power_sums(sums)
        if whole.gcd(whole.derivative()).degree() == 0:
            t, n = (_numerator(whole, w) for w in others)
            return shift, whole, t, n
    raise AssertionError


def _numerator(f: flint.fmpq_poly, sums: Sequence[flint.fmpq]) -> flint.fmpq_poly:
    """Return Σ wᵢ·f/(x − zᵢ) over the roots zᵢ of f, given the sums Σ wᵢ·zᵢᵏ."""
    d = f.degree()
    return flint.fmpq_poly(
        [sum((f[k + 1 + j] * sums[j] for j in range(d - k)), flint.fmpq(0)) for k in range(d)]
    )
