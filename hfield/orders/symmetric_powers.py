"""The algebra modulo a prime p of 62 bits as matrices at the real places, and symmetric powers of them.

Forms of weight k have values in a tensor product over the real places. Each factor is the space of harmonic
polynomials of degree k/2 − 1 on the elements of trace 0, on which a quaternion acts by conjugation; scalars
act trivially. Over a splitting field this is Symᵏ⁻²⊗N^(1−k/2). Let p be a prime that splits completely in the
field and does not divide the constants of the algebra. Then the prime ideals above p give embeddings of the
field into 𝔽_p, one for each real place, and the algebra modulo each of them is M₂(𝔽_p). So all computations
are done in 𝔽_p, without a number field.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import fmpz, nmod_mat, nmod_poly

from hfield.fields.rationals.whole_numbers import sqrt_mod
from hfield.orders.basis import AlgebraBasis
from hfield.orders.linear_algebra_mod_p import rational_residue

Square = tuple[int, int, int, int]
"""A 2 × 2 matrix, row by row."""


class SplittingModP(NamedTuple):
    """An embedding of the field into 𝔽_p: the images of the integral basis, and of 1, I, J, IJ in M₂."""

    numbers: list[int]
    units: list[Square]


def splittings(ambient: AlgebraBasis, p: int) -> list[SplittingModP]:
    """Return the embeddings of the field in 𝔽_p and the matrices of the algebra there."""
    rows = ambient.base.coordinate_rows(list(ambient.constants)).tolist()
    found = []
    for numbers in ambient.base.embeddings_modulo(p):
        a, t, b = (
            sum(rational_residue(c, p) * w for c, w in zip(row, numbers, strict=True)) % p
            for row in rows
        )
        found.append(SplittingModP(numbers, _matrix_units(a, t, b, p)))
    return found


def _matrix_units(a: int, t: int, b: int, p: int) -> list[Square]:
    """Return matrices of 1, I, J, IJ modulo p with I² = a + t·I and J² = b."""
    half = t * pow(2, -1, p) % p
    square = (a + half * half) % p
    # the square of (x, −b·y; y, −x) is x² − b·y², and it anticommutes with (0, b; 1, 0)
    y = next(y for y in range(p) if _is_square(square + b * y * y, p))
    x = sqrt_mod(square + b * y * y, p)
    first = (half + x) % p, -b * y % p, y, (half - x) % p
    second = 0, b, 1, 0
    return [(1, 0, 0, 1), first, second, _product(first, second, p)]


def _is_square(x: int, p: int) -> bool:
    return pow(x % p, (p - 1) // 2, p) <= 1


def _product(x: Square, y: Square, p: int) -> Square:
    a, b, c, d = x
    e, f, g, h = y
    return (a * e + b * g) % p, (a * f + b * h) % p, (c * e + d * g) % p, (c * f + d * h) % p


class SymmetricPower:
    """The action of quaternions on the tensor product of symmetric powers, for even weights, modulo p."""

    def __init__(self, ambient: AlgebraBasis, weight: int, p: int) -> None:
        self.p, self._weight = p, weight
        self._splittings = splittings(ambient, p)
        self._degree = ambient.degree
        self.dimension = (weight - 1) ** self._degree

    def matrix(self, row: Sequence[fmpz]) -> nmod_mat:
        """Return the matrix by which an element, given as an integer row, acts on columns."""
        whole = [[1]]
        for splitting in self._splittings:
            whole = _kronecker(whole, self._at(splitting, row), self.p)
        return nmod_mat(whole, self.p)

    def _at(self, splitting: SplittingModP, row: Sequence[fmpz]) -> list[list[int]]:
        p, n, s = self.p, self._degree, self._weight - 2
        a = b = c = d = 0
        for k, (e, f, g, h) in enumerate(splitting.units):
            part = row[k * n : (k + 1) * n]
            x = sum(int(u) * w for u, w in zip(part, splitting.numbers, strict=True)) % p
            a, b, c, d = a + x * e, b + x * f, c + x * g, d + x * h
        # X ↦ a·X + c·Y, Y ↦ b·X + d·Y on the polynomials Xˢ, Xˢ⁻¹·Y, …
        first, second = (_powers(nmod_poly([u % p, v % p], p), s) for u, v in ((a, c), (b, d)))
        factor = pow((a * d - b * c) % p, -s // 2, p)
        columns = []
        for k in range(s + 1):
            entries = (first[s - k] * second[k] * factor).coeffs()
            columns.append([*map(int, entries), *[0] * (s + 1 - len(entries))])
        return list(map(list, zip(*columns, strict=True)))


def _powers(x: nmod_poly, most: int) -> list[nmod_poly]:
    found = [x**0]
    for _ in range(most):
        found.append(found[-1] * x)
    return found


def _kronecker(first: list[list[int]], second: list[list[int]], p: int) -> list[list[int]]:
    return [[x * y % p for x in u for y in v] for u in first for v in second]
