"""The values of forms of weight k over ℚ in a rational basis, for certificates.

The checker's module :mod:`hfield.checker.orders.weights` describes the representation: polynomials of degree
m = k/2 − 1 in a basis X, Y, Z of the elements of trace 0, modulo Z² = β·X² + α·Y², where α = X² and β = Y². A
value is a row of k − 1 coefficients: of Xᵐ, Xᵐ⁻¹·Y, …, Yᵐ, then of Z·Xᵐ⁻¹, …, Z·Yᵐ⁻¹.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import lcm
from typing import TYPE_CHECKING

from flint import fmpq, fmpq_mat, fmpq_poly

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Parent, Quaternion

Pair = tuple[fmpq_poly, fmpq_poly]
"""The polynomials p and q of p + Z·q in Y, for X = 1."""


class WeightValues:
    """The values of forms of a weight k, and the action of quaternions on them."""

    def __init__(self, algebra: Parent, weight: int) -> None:
        self._degree, self.dimension = weight // 2 - 1, weight - 1
        if not self._degree:
            return
        a, t, b = (fmpq(x) for x in algebra.constants)
        s = lcm(*(int(x.q) for x in (a, t, b, a * b, t * b)))
        X, Y = algebra(-s * t, 2 * s, 0, 0), algebra(0, 0, s, 0)
        self._basis = X, Y, X * Y
        self._scales, self._shift = (fmpq(1, 2 * s), fmpq(1, s), fmpq(1, 2 * s * s)), t / 2
        self._square = fmpq_poly([s * s * b, 0, s * s * (t * t + 4 * a)])

    def action(self, x: Quaternion) -> fmpq_mat:
        """Return the matrix by which conjugation by x acts on rows."""
        if not self._degree:
            return fmpq_mat(1, 1, [1])
        m, inverse = self._degree, x.inverse()
        X, Y, Z = (self._linear(x * basis * inverse) for basis in self._basis)
        first, second = self._powers(X), self._powers(Y)
        found = [self._product(first[m - n], second[n]) for n in range(m + 1)]
        for n in range(m):
            found.append(self._product(Z, self._product(first[m - 1 - n], second[n])))
        return fmpq_mat([[*padded(p, m + 1), *padded(q, m)] for p, q in found])

    def _linear(self, x: Quaternion) -> Pair:
        """Return an element of trace 0 in terms of X, Y and Z."""
        _, i, j, k = (fmpq(c) for c in x.coordinates)
        of_i, of_j, of_k = self._scales
        return fmpq_poly([i * of_i, (j + k * self._shift) * of_j]), fmpq_poly([k * of_k])

    def _product(self, x: Pair, y: Pair) -> Pair:
        (p, q), (u, v) = x, y
        return p * u + q * v * self._square, p * v + q * u

    def _powers(self, x: Pair) -> list[Pair]:
        found = [(fmpq_poly([1]), fmpq_poly([]))]
        for _ in range(self._degree):
            found.append(self._product(found[-1], x))
        return found

    def fixed(self, units: Sequence[Quaternion]) -> fmpq_mat:
        """Return a basis of the values that some elements fix, in reduced echelon form."""
        width = self.dimension
        moved = list[list[fmpq]]()
        for unit in units:
            matrix = self.action(unit)
            for n in range(width):
                matrix[n, n] -= 1
            moved += matrix.transpose().tolist()
        if not moved:
            return fmpq_mat(width, width, [int(i == j) for i in range(width) for j in range(width)])
        whole, _ = fmpq_mat(moved).numer_denom()
        kernel, rank = whole.nullspace()
        columns = [kernel[n, k] for k in range(rank) for n in range(width)]
        return fmpq_mat(rank, width, columns).rref()[0] if rank else fmpq_mat(0, width)


def padded(x: fmpq_poly, d: int) -> list[fmpq]:
    """Return the coefficients of a polynomial of degree below d, low degree first."""
    found: list[fmpq] = x.coeffs()
    return found + [fmpq(0)] * (d - len(found))
