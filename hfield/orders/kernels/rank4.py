"""Faster algorithms for lattices over ℤ of rank 4."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from flint import fmpz, fmpz_mat, fmpz_poly

from hfield.core.product import Constants
from hfield.fields.rationals.whole_numbers import fraction
from hfield.orders import enumeration
from hfield.orders.hermite import integral

if TYPE_CHECKING:
    from hfield.orders.base_values import BaseNumber, Integer, IntegerMatrix
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.lattice_values import LatticeValue


def first_order(ambient: AlgebraBasis) -> tuple[int, fmpz_mat]:
    """Return rows over a denominator that span a maximal order: the even Clifford algebra of a form."""
    from hfield.orders.kernels.even_clifford import maximal_basis

    den, rows = integral(maximal_basis(Constants(*map(fraction, ambient.constants))))
    return den, fmpz_mat(rows)


def content(gram: fmpz_mat) -> fmpz:
    """Return the gcd of half the diagonal of a matrix and its other entries."""
    g = gram
    squares = [g[0, 0] // 2, g[1, 1] // 2, g[2, 2] // 2, g[3, 3] // 2]
    mixed = [g[0, 1], g[0, 2], g[0, 3], g[1, 2], g[1, 3], g[2, 3]]
    return fmpz_poly(squares + mixed).content()  # the gcd of a list, as flint has it


def norm(ambient: AlgebraBasis, grams: Sequence[fmpz_mat], content: fmpz, den: int) -> Fraction:
    """Return the gcd of all norms, which equals the content."""
    return Fraction(int(content), ambient.scale * den * den)


def volume(ambient: AlgebraBasis, matrix: fmpz_mat, den: int) -> Fraction:
    """Return the determinant of a triangular matrix over ``den``."""
    return Fraction(int(_determinant(matrix)), den**4)


def index(lattice: LatticeValue, other: LatticeValue) -> Fraction:
    """Return the ratio of the determinants as a fraction."""
    volume = int(_determinant(other.matrix)) * lattice.den**4
    return Fraction(volume, int(_determinant(lattice.matrix)) * other.den**4)


def order_rows(lattice: LatticeValue, pairs: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return seven rows over a denominator that span ``L·conj(L)/N(L)``."""
    whole = int(lattice.content) * lattice.ambient.conjugate_scale
    return whole, fmpz_mat(7, 4, [whole, 0, 0, 0, *pairs.entries()])


def is_locally_principal(ideal: LatticeValue, order: LatticeValue) -> bool:
    """Return whether the index is the square of the norm, by determinants, which are products of
    diagonals.
    """
    content, scale = ideal.content, order.den**4 * ideal.ambient.scale**2
    index = _determinant(ideal.matrix) * scale
    return bool(index == content * content * _determinant(order.matrix))


def has_norm(ambient: AlgebraBasis, den: Integer, row: IntegerMatrix, norm: BaseNumber) -> bool:
    """Return True: in degree 1 the value of the form is the norm."""
    return True


def _determinant(matrix: fmpz_mat) -> fmpz:
    return matrix[0, 0] * matrix[1, 1] * matrix[2, 2] * matrix[3, 3]


def combination(x: Sequence[int], columns: Sequence[Sequence[int]]) -> tuple[int, ...]:
    """Return a combination of four rows."""
    p, q, r, s = x
    return tuple([p * a + q * b + r * c + s * d for a, b, c, d in columns])


def theta_series(
    ambient: AlgebraBasis,
    den: int,
    rows: fmpz_mat,
    gram: enumeration.Gram,
    unit: fmpz,
    step: Fraction,
    bound: int,
) -> list[int]:
    """Count vectors by the values of the form; the value 2m belongs to the norm ``m·step``."""
    return enumeration.theta_series(gram, bound, "elements as short as")
