"""Convert elements of a number field to coordinates in the integral basis, and back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import flint

from hfield.fields.number_fields.elements import FieldElement, coefficients
from hfield.fields.number_fields.integers import integral_generator
from hfield.fields.number_fields.ring import NumberField


@lru_cache(maxsize=64)
def _integral(field: NumberField) -> tuple[flint.fmpq_mat, flint.fmpq_mat]:
    """Return the matrix from coordinates in the integral basis to powers of s, and its inverse."""
    n = field.degree
    rows = [c for w in field.integral_basis() for c in coefficients(w)]
    matrix = flint.fmpq_mat(n, n, rows)
    return matrix, matrix.inv()


def coordinate_rows(field: NumberField, elements: Sequence[FieldElement]) -> flint.fmpq_mat:
    """Return a matrix whose rows are the coordinates of elements in the integral basis."""
    n = field.degree
    entries = [c for x in elements for c in coefficients(x)]
    return flint.fmpq_mat(len(elements), n, entries) * _integral(field)[1]


def element_of(field: NumberField, row: list[flint.fmpq]) -> FieldElement:
    """Return the element with the given coordinates in the integral basis."""
    powers = flint.fmpq_mat(1, field.degree, row) * _integral(field)[0]
    return FieldElement(field, flint.fmpq_poly(powers.entries()))


def integral_multiple(x: FieldElement) -> int:
    """Return a positive integer m for which m·x is an algebraic integer."""
    scale, _ = integral_generator(x.field)
    return math.lcm(*(int((c / flint.fmpq(scale) ** k).q) for k, c in enumerate(x.poly.coeffs())))
