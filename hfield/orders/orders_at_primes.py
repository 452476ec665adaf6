"""Orders at one prime ideal: made larger until they are maximal there, and smaller, to Eichler orders.

The first goes as over ℤ (:mod:`hfield.orders.maximal_orders`): the left order of the radical at P, the x
with tr(x·O) ⊂ P and N(x) ∈ P, is larger until the order is hereditary at P; then one of two maximal ideals
has a maximal left order, unless the algebra ramifies at P (Voight, *Quaternion Algebras*, 15.5, 21.2,
24.4).
"""

from __future__ import annotations

import random
from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING

import flint

from hfield.errors import LatticeError
from hfield.fields.number_fields.integers import left_kernel
from hfield.fields.number_fields.integral_basis import coordinate_rows
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.residues import local_place
from hfield.fields.number_fields.symbols import square_class
from hfield.orders.base import expect_small
from hfield.orders.basis import AlgebraBasis
from hfield.orders.hermite import stacked
from hfield.orders.invariants import level
from hfield.orders.lattice_values import (
    LatticeValue,
    add,
    add_elements,
    add_rows,
    conjugate,
    hermite_form,
    times_ideal,
)
from hfield.orders.lattice_values import product as lattice_product
from hfield.rings.residue_polynomials import coefficients

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import Ideal

Rows = list[list[flint.fmpq]]
TRIALS = 1_000


def maximal(order: LatticeValue) -> LatticeValue:
    """Return a maximal order that contains an order."""
    for prime, e in order.ambient.base.factorisation(level(order)):
        order = Local(order.ambient, prime).maximal(order, e)
    return order


def eichler(order: LatticeValue, index: Ideal) -> LatticeValue:
    """Return an Eichler order of some index in an order, maximal and split at the primes of the index."""
    for prime, k in index.factorisation():
        order = Local(order.ambient, order.ambient.base.prime(prime)).eichler_suborder(order, k)
    return order


class Local:
    """Orders at one prime ideal P; they are lattices as values."""

    def __init__(self, ambient: AlgebraBasis, prime: PrimeIdeal) -> None:
        self.ambient, self.prime, self.p = ambient, prime, prime.p
        expect_small(prime)
        self.place = local_place(prime)
        self._residues = [self._digits(prime.residue_of(w)) for w in ambient.base.integral_basis]

    def maximal(self, order: LatticeValue, level: int) -> LatticeValue:
        """Return an order that contains the given one, is maximal at P, and the same elsewhere.

        ``level`` is the valuation of the index of the given one in it. Raises :class:`TooLargeError`.
        """
        while level > 0:
            radical = self.radical(order)
            larger = self.left_order(radical)
            if larger == order:  # hereditary, of level P
                larger = self.left_order(self._maximal_ideal(order, radical))
            level -= (order.volume / larger.volume).valuation(self.prime)
            order = larger
        return order

    def lift(self, residue: flint.nmod_poly) -> FieldElement:
        """Return an integer of the field with a given residue."""
        found: FieldElement = self.ambient.base.lift(self.prime, residue)
        return found

    def _digits(self, residue: flint.nmod_poly) -> list[int]:
        found = coefficients(residue)
        return found + [0] * (self.prime.f - len(found))

    def radical(self, order: LatticeValue) -> LatticeValue:
        """Return the x with tr(x·O) ⊂ P and N(x) ∈ P, a lattice between O and p·O."""
        ambient, rows = self.ambient, order.rows
        below = flint.fmpq(1, ambient.scale * order.den**2)
        traces = [self._modulo(form * below) for form in ambient.grams(order.matrix)]
        entries: list[list[int]] = [[] for _ in range(ambient.size)]
        for digits in zip(*self._residues, strict=True):
            total = flint.nmod_mat(ambient.size, ambient.size, self.p)
            for matrix, c in zip(traces, digits, strict=True):
                total += matrix * c
            for row, found in zip(entries, total.tolist(), strict=True):
                row += map(int, found)
        vectors = left_kernel(flint.nmod_mat(entries, self.p))
        if self.p == 2 and vectors:  # N is additive on these, and so is the root of its residue
            roots = [self._digits(self.place.sqrt(self._norm_residue(v, rows))) for v in vectors]
            chosen = left_kernel(flint.nmod_mat(roots, self.p))
            vectors = [
                [
                    sum(c * v[k] for c, v in zip(u, vectors, strict=True))
                    for k in range(ambient.size)
                ]
                for u in chosen
            ]
        return self._above(order, vectors)

    def _modulo(self, matrix: flint.fmpq_mat) -> flint.nmod_mat:
        """Return an integral matrix modulo p."""
        return flint.nmod_mat(matrix.numer_denom()[0], self.p)

    def _norm_residue(self, vector: list[int], rows: flint.fmpq_mat) -> flint.nmod_poly:
        row = (flint.fmpq_mat(flint.fmpz_mat(1, self.ambient.size, vector)) * rows).entries()
        return self.prime.residue_of(self.ambient.norm(row))

    def _above(
        self, lattice: LatticeValue, vectors: Iterable[list[int]], divisor: int = 1
    ) -> LatticeValue:
        """Return the lattice of some combinations of a basis, and p times this, over a divisor."""
        some, rows = list(vectors), lattice.matrix
        parts = [flint.fmpz_mat(some) * rows] if some else []
        whole = stacked(*parts, rows * self.p)
        return hermite_form(self.ambient, lattice.den * divisor, whole)

    def left_order(self, ideal: LatticeValue) -> LatticeValue:
        """Return the x with x·I ⊂ I, for an ideal I between an order and p times it."""
        rows, inverse = ideal.rows, ideal.inverse_rows
        products = [
            self._modulo(rows * self.ambient.times(row) * inverse).tolist()
            for row in self._generators(ideal)
        ]
        columns = [[int(c) for part in row for c in part] for row in zip(*products, strict=True)]
        vectors = left_kernel(flint.nmod_mat(columns, self.p))
        return self._above(ideal, vectors, self.p)

    def _generators(self, lattice: LatticeValue) -> Rows:
        """Return some rows that generate a lattice over the integers of the field, modulo p times it."""
        found: Rows = []
        vectors: list[list[int]] = []
        for row in lattice.rows.tolist():
            multiples = [(flint.fmpq_mat([row]) * m).entries() for m in self.ambient.scalars]
            more = self._modulo(flint.fmpq_mat(multiples) * lattice.inverse_rows).tolist()
            reduced, rank = flint.nmod_mat([*vectors, *map(_ints, more)], self.p).rref()
            if rank > len(vectors):
                vectors = list(map(_ints, reduced.tolist()[:rank]))
                found.append(row)
        return found

    def _maximal_ideal(self, order: LatticeValue, radical: LatticeValue) -> LatticeValue:
        """Return one of the two maximal ideals at P of an order that is hereditary there, and not maximal."""
        moved, _ = self.split_element(order)
        both = [order.rows * self.ambient.times(moved), radical.rows]
        vectors = [v for m in both for v in (m * order.inverse_rows).tolist()]
        return self._above(order, [[int(c.p) for c in v] for v in vectors])

    def split_element(self, order: LatticeValue) -> tuple[list[flint.fmpq], FieldElement]:
        """Return x in the order, and r in K, with x² ≡ r·x and r ≢ 0 modulo P: x/r is idempotent modulo P.

        The order is M₂(ℤ_P) or has the Eichler symbol 1 at P, else none is found and :class:`LatticeError`
        raised.
        """
        ambient, place, rng, rows = self.ambient, self.place, random.Random(1), order.rows
        for _ in range(TRIALS):
            vector = [rng.randrange(self.p) for _ in range(ambient.size)]
            row = (flint.fmpq_mat(flint.fmpz_mat(1, ambient.size, vector)) * rows).entries()
            trace = self.prime.residue_of(ambient.parts(row)[0] * 2)
            found = place.quadratic_root(
                place.one, place.zero - trace, self._norm_residue(vector, rows)
            )
            if found is None or found[1] == 0:
                continue
            root = place.multiply(found[0], place.inverse(found[1]))
            other = (trace - root) % place.modulus
            if (other - root) % place.modulus == 0:
                continue
            shift = coordinate_rows(ambient.base.field, [self.lift(root)]).entries()
            moved = [c - s for c, s in zip(row, [*shift, *[0] * (3 * ambient.degree)], strict=True)]
            return moved, self.lift((other - root) % place.modulus)
        raise LatticeError(f"no idempotent was found in the residues of an order at {self.prime}")

    def norm_index(self, order: LatticeValue) -> int:
        """Return the index of the norms of units of an order with the symbol 0 in the units of ℤ_P.

        With J the radical they are, modulo squares, the norms of 1 + J, which the 1 + b for bases of all Jᵏ
        generate. J⁴ is in P·O, so the last ones are 1 modulo 4P, and the norms are squares there.
        """
        digits, e = (self.prime.e * self.prime.f + 1, self.prime.e) if self.p == 2 else (1, 0)
        radical, classes = self.radical(order), [0]
        power, one = radical, self.ambient.row(1)
        for _ in range(4 * (2 * e + 1)):
            for row in power.rows.tolist():
                unit = (flint.fmpq_mat([row]) + one).entries()
                c = square_class(self.prime, self.ambient.norm(unit))
                if c not in classes:
                    classes += [c ^ other for other in classes]
            if self.p > 2 or len(classes) == 2**digits:
                break
            power = lattice_product(power, radical)
        return int(2**digits // len(classes))

    @cached_property
    def representatives(self) -> list[FieldElement]:
        """Integers of the field, one of each class modulo P, 0 first."""
        return self.ambient.base.residues(self.prime)

    def times_prime(self, lattice: LatticeValue) -> LatticeValue:
        """Return P·L."""
        return times_ideal(lattice, self.ambient.base.prime_ideal(self.prime))

    def independent(self, larger: flint.fmpq_mat, below: LatticeValue) -> Rows:
        """Return some rows that are a basis of what rows span modulo a lattice, which contains P times it."""
        return independent(larger, below)

    def corners(
        self, lattice: LatticeValue, e: flint.fmpq_mat
    ) -> tuple[flint.fmpq_mat, flint.fmpq_mat]:
        """Return e·b·(1 − e) and (1 − e)·b·e for the basis b of a lattice."""
        ambient, rows = self.ambient, lattice.rows
        left = flint.fmpq_mat([(e * ambient.times(row)).entries() for row in rows.tolist()])
        other = ambient.times((ambient.row(1) - e).entries())
        return left * other, (rows - left) * ambient.times(e.entries())

    def idempotent(self, order: LatticeValue, k: int) -> flint.fmpq_mat:
        """Return e in an order that has matrices of rank 1 modulo P, with e² ≡ e modulo Pᵏ and e ≢ 0, 1.

        Raises :class:`LatticeError` as :meth:`split_element` does.
        """
        ambient, place = self.ambient, self.place
        element, r = self.split_element(order)
        scale = self.lift(place.inverse(self.prime.residue_of(r)))
        e = flint.fmpq_mat([element]) * ambient.scalar(scale)
        modulus = self.p ** -(-k // self.prime.e)
        known = 1
        while known < k:  # e ↦ 3e² − 2e³ doubles what is known
            square = e * ambient.times(e.entries())
            coordinates = (
                (square * 3 - square * ambient.times(e.entries()) * 2) * order.inverse_rows
            ).entries()
            e = (
                flint.fmpq_mat(1, ambient.size, [int(c.p) % modulus for c in coordinates])
                * order.rows
            )
            known *= 2
        return e

    def eichler_suborder(self, order: LatticeValue, k: int) -> LatticeValue:
        """Return the x in an order that is maximal and split at P with e·x·(1 − e) ∈ Pᵏ·O."""
        ambient = self.ambient
        e = self.idempotent(order, k)
        # these are (1 − e)·O + O·e + Pᵏ·O, and the conjugate of e is 1 − e modulo Pᵏ
        below = times_ideal(order, ambient.base.prime_ideal(self.prime) ** k)
        left = add_rows(below, order.rows * ambient.times(e))
        return add(left, conjugate(left))


def independent(larger: flint.fmpq_mat, below: LatticeValue) -> Rows:
    """Return some rows that are a basis of what rows span modulo a lattice, over the residues of a prime."""
    found: Rows = []
    for row in larger.tolist():
        if any(c.q != 1 for c in (flint.fmpq_mat([row]) * below.inverse_rows).entries()):
            found.append(row)
            below = add_elements(below, flint.fmpq_mat([row]))
    return found


def _ints(row: list[flint.nmod]) -> list[int]:
    return list(map(int, row))
