"""Linear algebra over ℤ/p, and roots of quadratic polynomials modulo prime powers."""

from __future__ import annotations

from collections.abc import Sequence

import flint
from flint import fmpz_mat, fmpz_mod_ctx, fmpz_mod_mat

from hfield.core.primality import WORD
from hfield.fields.rationals.whole_numbers import sqrt_mod


def echelon(rows: Sequence[Sequence[int]], p: int) -> list[list[int]]:
    """Return the nonzero rows of the reduced echelon form modulo a prime."""
    found, rank = fmpz_mod_mat([list(row) for row in rows], fmpz_mod_ctx(p)).rref()
    return [[int(x) for x in row] for row in found.tolist()[:rank]]


def lead(row: Sequence[int], p: int) -> int:
    """Return the first column with a nonzero entry modulo p, or the number of columns."""
    return next((n for n, x in enumerate(row) if x % p), len(row))


def kernel(rows: fmpz_mat | Sequence[Sequence[int]], p: int) -> list[list[int]]:
    """Return a basis of the vectors v with row·v ≡ 0 for every row of a matrix."""
    matrix = rows if isinstance(rows, fmpz_mat) else fmpz_mat([list(row) for row in rows])
    if p < WORD:
        found, size = flint.nmod_mat(matrix, p).nullspace()
        return [[int(x) for x in row] for row in found.transpose().tolist()[:size]]
    table = matrix.tolist()
    pivots = {lead(row, p): row for row in echelon(table, p)}
    width = range(matrix.ncols())
    return [
        [-pivots[n][free] % p if n in pivots else int(n == free) for n in width]
        for free in width
        if free not in pivots
    ]


def roots(a: int, b: int, c: int, p: int) -> list[int]:
    """Return the roots of ``a·x² + b·x + c`` modulo a prime; the polynomial must not be constant."""
    if p == 2:
        return [x for x in (0, 1) if (a * x + b * x + c) % 2 == 0]
    if a % p == 0:
        return [-c * pow(b, -1, p) % p] if b % p else []
    d = (b * b - 4 * a * c) % p
    if d and flint.fmpz(d).jacobi(p) != 1:
        return []
    r = sqrt_mod(d, p) if d else 0
    half = pow(2 * a, -1, p)
    return sorted({(r - b) * half % p, (-r - b) * half % p})


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
    simple = [x for x in roots(a, b, c, p) if (2 * a * x + b) % p]
    return lifted(a, b, c, simple[0], p, e) if simple else None


def kronecker(d: int, p: int) -> int:
    """Return the Kronecker symbol (d / p) at a prime."""
    if p != 2:
        return int(flint.fmpz(d).jacobi(p))
    return 0 if d % 2 == 0 else 1 if d % 8 in (1, 7) else -1


def rational_residue(x: flint.fmpq, p: int) -> int:
    """Return the residue modulo p of a rational number with denominator prime to p."""
    return int(x.p) * pow(int(x.q), -1, p) % p
