"""Linear algebra over ℤ/p, and roots of quadratic polynomials modulo prime powers."""

from __future__ import annotations

from collections.abc import Sequence

import flint

from hfield.rings.whole_numbers import sqrt_mod

Row = list[int]


def echelon(rows: Sequence[Sequence[int]], p: int) -> dict[int, Row]:
    """Return the reduced echelon form modulo a prime: its rows by the column of their pivot."""
    pivots: dict[int, Row] = {}
    for given in rows:
        row = [x % p for x in given]
        for column, other in pivots.items():
            if f := row[column]:
                row = [(x - f * y) % p for x, y in zip(row, other, strict=True)]
        lead = next((n for n, x in enumerate(row) if x), None)
        if lead is None:
            continue
        inverse = pow(row[lead], -1, p)
        row = [x * inverse % p for x in row]
        for column, other in pivots.items():
            if f := other[lead]:
                pivots[column] = [(x - f * y) % p for x, y in zip(other, row, strict=True)]
        pivots[lead] = row
    return pivots


def kernel(rows: Sequence[Sequence[int]], width: int, p: int) -> list[Row]:
    """Return a basis of the vectors v with row·v ≡ 0 for every row."""
    pivots = echelon(rows, p)
    basis = []
    for free in range(width):
        if free not in pivots:
            v = [0] * width
            v[free] = 1
            for column, row in pivots.items():
                v[column] = -row[free] % p
            basis.append(v)
    return basis


def roots(t: int, n: int, p: int) -> list[int]:
    """Return the roots of ``x² − t·x + n`` modulo a prime."""
    if p == 2:
        return [x for x in (0, 1) if (x * x - t * x + n) % 2 == 0]
    d = (t * t - 4 * n) % p
    if d and flint.fmpz(d).jacobi(p) != 1:
        return []
    r = sqrt_mod(d, p) if d else 0
    half = (p + 1) // 2
    return sorted({(t + r) * half % p, (t - r) * half % p})


def lifted(a: int, b: int, c: int, root: int, p: int, e: int) -> int:
    """Return the root of ``a·x² + b·x + c`` modulo pᵉ above a simple root modulo p (Hensel)."""
    k = 1
    while k < e:
        k = min(2 * k, e)
        q = p**k
        slope = pow(2 * a * root + b, -1, q)
        root = (root - (a * root * root + b * root + c) * slope) % q
    return int(root % p**e)


def simple_root(a: int, b: int, c: int, p: int, e: int) -> int | None:
    """Return a root of ``a·x² + b·x + c`` modulo pᵉ that is simple modulo p, or None."""
    if p == 2:
        found = [x for x in (0, 1) if (a * x + b * x + c) % 2 == 0] if b % 2 else []
    elif a % p:
        inverse = pow(a, -1, p)
        found = roots(-b * inverse, c * inverse, p)
    else:
        found = [-c * pow(b, -1, p) % p] if b % p else []
    simple = [x for x in found if (2 * a * x + b) % p]
    return lifted(a, b, c, simple[0], p, e) if simple else None


def kronecker(d: int, p: int) -> int:
    """Return the Kronecker symbol (d / p) at a prime."""
    if p != 2:
        return int(flint.fmpz(d).jacobi(p))
    return 0 if d % 2 == 0 else 1 if d % 8 in (1, 7) else -1
