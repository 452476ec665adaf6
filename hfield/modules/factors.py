"""The factors of degree 1 and 2 of a polynomial over a field, where flint factors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import flint

from hfield.errors import UndecidedError
from hfield.rings.base import Ring

Linear = list[Any]
Quadratic = list[tuple[Any, Any]]


def small_factors(ring: Ring, coefficients: Sequence[Any]) -> tuple[Linear, Quadratic]:
    """Return all roots, twice if multiple, and (t, n) for each irreducible factor x² − t·x + n, once.

    Over ℚ and finite fields by flint; over other fields, not of characteristic 2, of degree 2, and in x²
    of degree 4, by square roots. Raises :class:`UndecidedError` for others.
    """
    factors = _by_flint(ring, coefficients)
    if factors is None:
        lead = coefficients[-1]
        return _by_square_roots(ring, [ring.divide(c, lead) for c in coefficients[:-1]])
    linear, quadratic = [], []
    for factor, times in factors:
        lead = ring(factor[factor.degree()])
        c = [ring.divide(ring(factor[n]), lead) for n in range(factor.degree())]
        if len(c) == 1:
            linear += [-c[0]] * min(int(times), 2)
        elif len(c) == 2:
            quadratic.append((-c[1], c[0]))
    return linear, quadratic


def _by_flint(ring: Any, coefficients: Sequence[Any]) -> list[Any] | None:
    one = ring.one
    if isinstance(one, flint.fmpq):
        return list(flint.fmpq_poly(list(coefficients)).factor()[1])
    if isinstance(one, flint.nmod):
        return list(flint.nmod_poly([int(c) for c in coefficients], one.modulus()).factor()[1])
    if isinstance(one, flint.fq_default):
        return list(flint.fq_default_poly_ctx(ring.context)(list(coefficients)).factor()[1])
    return None


def _by_square_roots(ring: Ring, c: list[Any]) -> tuple[Linear, Quadratic]:
    """Factor a monic polynomial, its other coefficients given, of degree 1, 2, or 4 and in x²."""
    half = len(c) // 2
    if ring.characteristic == 2 or not (
        len(c) < 3 or (len(c) == 4 and all(map(ring.is_zero, c[1::2])))
    ):
        raise UndecidedError(
            f"a polynomial of degree {len(c)} over {ring.name} is not factored here: over QQ and finite "
            "fields all are, over others those of degree 2, and of degree 4 in x^2"
        )
    if len(c) < 2:
        return [-x for x in c], []
    n, p = c[0], c[half]
    root = ring.sqrt(p * p - ring(4) * n)
    if len(c) == 2:
        return ([], [(-p, n)]) if root is None else ([(root - p) / 2, (-root - p) / 2], [])
    linear: Linear = []
    quadratic: Quadratic = []
    if root is not None:  # (x² − y)·(x² − z)
        for y in ((root - p) / 2, (-root - p) / 2):
            s = ring.sqrt(y)
            if s is not None:
                linear += [s, -s]
            elif not quadratic or not ring.equal(quadratic[0][1], -y):
                quadratic.append((ring.zero, -y))
        return linear, quadratic
    w = ring.sqrt(n)
    for product in () if w is None else (w, -w):  # (x² − t·x + w)·(x² + t·x + w)
        t = ring.sqrt(product * 2 - p)
        if t is not None:
            quadratic += [(t, product), (-t, product)]
    return [], quadratic
