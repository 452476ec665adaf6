"""Reconstruct integers from residues modulo several primes; linear algebra modulo a prime."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from flint import nmod_mat


def lifted(residues: Iterable[tuple[int, Sequence[int]]], bound: int) -> list[int]:
    """Return the integers of absolute value up to a bound with given residues modulo primes.

    >>> lifted([(5, [2, 4]), (7, [3, 1]), (11, [4, 5])], 100)
    [-18, -6]
    """
    found: list[int] = []
    modulus = 1
    for p, values in residues:
        if modulus == 1:
            found = [0] * len(values)
        inverse = pow(modulus, -1, p)
        found = [x + modulus * ((r - x) * inverse % p) for x, r in zip(found, values, strict=True)]
        modulus *= p
        if modulus > 2 * bound:
            signed = [x - modulus if 2 * x > modulus else x for x in found]
            if any(abs(x) > bound for x in signed):
                raise AssertionError("residues belong to integers beyond their bound")
            return signed
    raise AssertionError("there are too few primes")


def echelon_form(rows: nmod_mat) -> nmod_mat:
    """Return the reduced echelon form of a matrix modulo a prime, without zero rows."""
    found, rank = rows.rref()
    p = int(rows.modulus())
    return nmod_mat(rank, rows.ncols(), found.entries()[: rank * rows.ncols()], p)


def pivots(rows: nmod_mat) -> list[int]:
    """Return the pivot columns of a matrix in reduced echelon form without zero rows."""
    return [next(k for k, c in enumerate(row) if c) for row in rows.tolist()]


def identity(size: int, p: int) -> nmod_mat:
    """Return the identity matrix modulo p."""
    return nmod_mat(size, size, [int(i == j) for i in range(size) for j in range(size)], p)


def fixed_by(matrix: nmod_mat, basis: nmod_mat) -> nmod_mat:
    """Return a basis, in echelon form, of the vectors in a row space that a matrix fixes."""
    rows = basis.nrows()
    moved = matrix * basis.transpose() - basis.transpose()
    kernel, rank = moved.nullspace()
    entries = kernel.transpose().entries()[: rank * rows]
    return echelon_form(nmod_mat(rank, rows, entries, int(basis.modulus())) * basis)
