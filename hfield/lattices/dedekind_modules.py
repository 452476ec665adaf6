"""Modules over the integers of a number field K, as lattices in Kᵐ: pseudo-bases, inverse ideals.

Rows are coordinates in an integral basis of K, n for each of the m coordinates.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import flint

from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.ring import NumberField

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion

    PseudoBasis = tuple[tuple[tuple[Any, ...], Quaternion], ...]


def hermite(rows: list[list[int]], size: int) -> flint.fmpz_mat:
    """Return the Hermite normal form, square, of integer rows of full rank."""
    whole = flint.fmpz_mat(len(rows), size, [c for row in rows for c in row]).hnf()
    return flint.fmpz_mat(size, size, whole.entries()[: size * size])


def rational_hermite(rows: list[list[flint.fmpq]], size: int) -> list[list[flint.fmpq]]:
    """Return a basis in Hermite's form of the lattice that rational rows of full rank span."""
    below = math.lcm(*(int(flint.fmpq(c).q) for row in rows for c in row))
    found = hermite([[int((flint.fmpq(c) * below).p) for c in row] for row in rows], size)
    return [[flint.fmpq(c, below) for c in row] for row in found.tolist()]


def inverse_ideal(field: NumberField, ideal: list[Any]) -> list[Any]:
    """Return a basis over ℤ of the x with x·I integral, for the basis of an ideal I."""
    n = field.degree
    # coordinates v with v·B integral for all columns B: v is in the inverse of the lattice of these
    columns: list[list[Any]] = []
    for y in ideal:
        columns += (
            coordinate_rows(field, [w * y for w in field.integral_basis()]).transpose().tolist()
        )
    lattice = flint.fmpq_mat(n, n, [c for row in rational_hermite(columns, n) for c in row])
    return [element_of(field, row) for row in lattice.transpose().inv().tolist()]


def pseudo_basis(
    field: NumberField, rows: flint.fmpq_mat
) -> list[tuple[tuple[Any, ...], list[Any]]]:
    """Return ideals Iₜ and vectors xₜ: a module of full rank in Kᵐ is the direct sum of the Iₜ·xₜ.

    From the last coordinate on: the coordinates there are an ideal I, and I⁻¹ times the module has a vector
    whose coordinate is 1; what is left are the vectors where it is 0 (Voight, *Quaternion Algebras*, 9.3.6).
    """
    n, size = field.degree, rows.nrows()
    out = []
    # the last coordinate first, so that Hermite's form sets aside the vectors where it is 0
    module = [_turned(row, n) for row in rows.tolist()]
    while size:
        module = rational_hermite(module, size)
        ideal = [element_of(field, row[:n]) for row in module[:n]]
        larger = [
            [c for k in range(0, size, n) for c in _scaled(field, x, row[k : k + n])]
            for x in inverse_ideal(field, ideal)
            for row in module
        ]
        basis = rational_hermite(larger, size)
        one = coordinate_rows(field, [field.one])
        block = flint.fmpq_mat(n, n, [c for row in basis[:n] for c in row[:n]])
        combination = (one * block.inv()).entries()
        assert all(c.q == 1 for c in combination), "I⁻¹·I contains 1"
        vector = [
            sum((c * row[k] for c, row in zip(combination, basis[:n], strict=True)), flint.fmpq(0))
            for k in range(size)
        ]
        out.append((tuple(ideal), _turned([*[flint.fmpq(0)] * (rows.nrows() - size), *vector], n)))
        module = [row[n:] for row in module[n:]]
        size -= n
    return out[::-1]


def _turned(row: list[flint.fmpq], n: int) -> list[flint.fmpq]:
    """Return the coordinates, n numbers each, in the opposite order."""
    return [c for k in range(len(row) - n, -1, -n) for c in row[k : k + n]]


def _scaled(field: NumberField, x: Any, row: list[flint.fmpq]) -> list[flint.fmpq]:
    return list(coordinate_rows(field, [x * element_of(field, row)]).entries())
