"""Lattices over the integers of a number field in a quaternion algebra, as ℤ-lattices of rank 4n.

Rows are coordinates in the integral basis of K times 1, I, J, IJ, in Hermite normal form: unique, so lattices
are equal where rows are. Class numbers of K play no part (Voight, *Quaternion Algebras*, chapters 9, 10, 16).
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import flint

from hfield.errors import LatticeError, shorten
from hfield.fields.number_fields.ideals import Ideal, ideal
from hfield.lattices.over_integers.dedekind_modules import pseudo_basis

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.lattices.over_integers.dedekind_modules import PseudoBasis
    from hfield.lattices.over_integers.orders import Frame


def unique_rows(rows: flint.fmpq_mat) -> flint.fmpq_mat:
    """Return the Hermite normal form of a basis of what rows span over ℤ, of full rank."""
    whole, den = rows.numer_denom()
    n = rows.ncols()
    if whole.rank() != n:
        raise LatticeError(
            f"expected generators of a lattice of full rank {n} over ZZ; got {whole.rank()}"
        )
    return flint.fmpq_mat(flint.fmpz_mat(whole.hnf().tolist()[:n])) * flint.fmpq(1, int(den))


class IntegersLattice:
    """A lattice over the integers of a number field, of full rank; ``rows`` are a basis over ℤ.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order(); i = O.algebra(0, 1, 0, 0)
    >>> I = O.right_ideal([2, 1 + i]); J = O.left_ideal([3])
    >>> I.norm(), I.right_order() == O, I * I.inverse() == I.left_order()
    (ideal(2), True, True)
    >>> I + J == O, O.index(I & J), 1 + i in I, I.conjugate().left_order() == O
    (True, ideal(324), True, True)
    """

    def __init__(self, frame: Frame, rows: flint.fmpq_mat) -> None:
        self.frame, self.rows = frame, unique_rows(rows)
        self.algebra, self.field = frame.algebra, frame.field

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """A basis over ℤ, of 4n quaternions."""
        return tuple(self.frame.quaternion(row) for row in self.rows.tolist())

    @cached_property
    def _inverse_rows(self) -> flint.fmpq_mat:
        return self.rows.inv()

    def __contains__(self, x: object) -> bool:
        row = self.frame.row(self.algebra(x))
        return all(c.q == 1 for c in (row * self._inverse_rows).entries())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, IntegersLattice):
            return NotImplemented
        return bool(self.algebra == other.algebra and self.rows == other.rows)

    def __hash__(self) -> int:
        return hash((self.algebra, str(self.rows)))

    def _same(self, other: IntegersLattice) -> IntegersLattice:
        if not isinstance(other, IntegersLattice) or other.algebra != self.algebra:
            raise LatticeError(
                f"expected a lattice in {shorten(self.algebra)}, not {shorten(other)}"
            )
        return other

    def __add__(self, other: IntegersLattice) -> IntegersLattice:
        both = self.rows.tolist() + self._same(other).rows.tolist()
        return IntegersLattice(self.frame, flint.fmpq_mat(both))

    def __and__(self, other: IntegersLattice) -> IntegersLattice:
        # the dual of the sum of the duals, in the plain pairing of coordinates
        both = [*self._inverse_rows.transpose().tolist()]
        both += self._same(other)._inverse_rows.transpose().tolist()
        return IntegersLattice(self.frame, unique_rows(flint.fmpq_mat(both)).inv().transpose())

    def __mul__(self, other: IntegersLattice) -> IntegersLattice:
        rows: list[Any] = []
        for row in self._same(other).rows.tolist():
            rows += (self.rows * self.frame.right(row)).tolist()
        return IntegersLattice(self.frame, flint.fmpq_mat(rows))

    def conjugate(self) -> IntegersLattice:
        """Return the lattice of the conjugates."""
        n = self.frame.n
        flipped = [[c if k < n else -c for k, c in enumerate(r)] for r in self.rows.tolist()]
        return IntegersLattice(self.frame, flint.fmpq_mat(flipped))

    def colon(self, other: IntegersLattice) -> IntegersLattice:
        """Return the x with x·M ⊂ L, for another lattice M."""
        columns: list[Any] = []
        for row in self._same(other).rows.tolist():
            columns += (self.frame.right(row) * self._inverse_rows).transpose().tolist()
        return IntegersLattice(self.frame, unique_rows(flint.fmpq_mat(columns)).inv().transpose())

    def left_order(self) -> IntegersLattice:
        """Return the x with x·L ⊂ L."""
        return self.colon(self)

    def right_order(self) -> IntegersLattice:
        """Return the x with L·x ⊂ L."""
        return self.conjugate().left_order().conjugate()

    def inverse(self) -> IntegersLattice:
        """Return the x with L·x·L ⊂ L: the inverse, where L is invertible."""
        return self.right_order().colon(self)

    def norm(self) -> Ideal:
        """Return the ideal that the reduced norms generate."""
        found = []
        for k, row in enumerate(self.rows.tolist()):
            found.append(self.frame.norm(row))
            for other in self.rows.tolist()[:k]:
                both = [a + b for a, b in zip(row, other, strict=True)]
                found.append(self.frame.norm(both))
        return ideal(self.algebra.ring, found)

    def volume(self) -> Ideal:
        """Return the index of L in ⟨1, I, J, IJ⟩ over the integers, an ideal; not a whole one, perhaps."""
        out, matrix = ideal(self.algebra.ring, 1), []
        for factor, row in pseudo_basis(self.field, self.rows):
            out = out * ideal(self.algebra.ring, list(factor))
            matrix.append(list(self.frame.parts(row)))
        return out * ideal(self.algebra.ring, _determinant(matrix))

    def index(self, other: IntegersLattice) -> Ideal:
        """Return the index ideal [L : M], fractional where M is not in L."""
        return self._same(other).volume() / self.volume()

    def pseudo_basis(self) -> PseudoBasis:
        """Return four pairs (basis over ℤ of an ideal, quaternion): L is the direct sum of their products."""
        return self.frame.pseudo_basis(self.rows)

    def left_ideal(self, generators: Any) -> IntegersLattice:
        """Return the left ideal O·x + O·y + … of an order O."""
        rows: list[Any] = []
        for x in generators:
            row = self.frame.row(self.algebra(x)).entries()
            rows += (self.rows * self.frame.right(row)).tolist()
        if not rows:
            raise LatticeError("expected at least one generator of an ideal")
        return IntegersLattice(self.frame, flint.fmpq_mat(rows))

    def right_ideal(self, generators: Any) -> IntegersLattice:
        """Return the right ideal x·O + y·O + … of an order O."""
        conjugates = [self.algebra(x).conjugate() for x in generators]
        return self.conjugate().left_ideal(conjugates).conjugate()

    def __repr__(self) -> str:
        return f"a lattice of rank {self.frame.size} over ZZ in {self.algebra}"


def _determinant(matrix: list[list[Any]]) -> Any:
    """Return the determinant, by expansion along the first row."""
    if len(matrix) == 1:
        return matrix[0][0]
    minors = (
        x * _determinant([r[:k] + r[k + 1 :] for r in matrix[1:]]) * (-1) ** k
        for k, x in enumerate(matrix[0])
    )
    return sum(minors, matrix[0][0] * 0)
