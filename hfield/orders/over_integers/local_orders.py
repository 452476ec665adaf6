"""Orders at one prime ideal: made larger until they are maximal there, and smaller, to Eichler orders.

The first goes as over ℤ (:mod:`hfield.orders.maximal_orders`): the left order of the radical at P, the x
with tr(x·O) ⊂ P and N(x) ∈ P, is larger until the order is hereditary at P; then one of two maximal ideals
has a maximal left order, unless the algebra ramifies at P (Voight, *Quaternion Algebras*, 15.5, 21.2,
24.4).
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING

import flint

from hfield.errors import LatticeError, TooLargeError, shorten
from hfield.fields.number_fields.integers import left_kernel
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.residues import local_place
from hfield.fields.number_fields.symbols import square_class
from hfield.orders.over_integers.dedekind_modules import hermite, unique_rows
from hfield.orders.over_integers.frames import Frame
from hfield.primality import WORD
from hfield.rings.residue_polynomials import coefficients

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import Ideal

Rows = list[list[flint.fmpq]]
TRIALS = 1_000


def maximal(frame: Frame, rows: flint.fmpq_mat, level: Ideal) -> flint.fmpq_mat:
    """Return a maximal order that contains an order whose index in it is known."""
    for prime, e in level.factorisation():
        P = frame.prime(prime)
        rows = Local(frame, P).maximal(rows, e)
    return rows


def eichler(frame: Frame, rows: flint.fmpq_mat, level: Ideal) -> flint.fmpq_mat:
    """Return an Eichler order in an order that is maximal and split at the primes of the level."""
    for prime, k in level.factorisation():
        rows = Local(frame, frame.prime(prime)).eichler_suborder(rows, k)
    return rows


class Local:
    """Orders at one prime ideal P; they are given by rows, a basis over ℤ."""

    def __init__(self, frame: Frame, prime: PrimeIdeal) -> None:
        self.frame, self.prime, self.p = frame, prime, prime.p
        if self.p >= WORD:
            raise TooLargeError(
                f"orders are not looked at {shorten(prime)}, whose residues exceed a machine's word"
            )
        self.place = local_place(prime)
        self._residues = [self._digits(prime.residue_of(w)) for w in frame.omega]

    def maximal(self, rows: flint.fmpq_mat, level: int) -> flint.fmpq_mat:
        """Return an order that contains the given one, is maximal at P, and the same elsewhere.

        ``level`` is the valuation of the index of the given one in it. Raises :class:`TooLargeError`.
        """
        while level > 0:
            radical = self.radical(rows)
            larger = self.left_order(radical)
            if larger.det() == rows.det():  # hereditary, of level P
                larger = self.left_order(self._maximal_ideal(rows, radical))
            index = abs(rows.det() / larger.det())
            level -= int(math.log2(int(index.p)) / math.log2(self.prime.norm()) + 0.5)
            rows = larger
        return rows

    def lift(self, residue: flint.nmod_poly) -> FieldElement:
        """Return an integer of the field with a given residue."""
        return self.integral(self.prime.lift(residue), 1)

    def integral(self, x: FieldElement, k: int) -> FieldElement:
        """Return an integer of the field that is x modulo pᵏ, where x may not be integral away from p."""
        (row,) = coordinate_rows(self.frame.field, [x]).tolist()
        modulus = self.p**k
        digits = [int(c.p) * pow(int(c.q), -1, modulus) % modulus for c in row]
        return element_of(self.frame.field, [flint.fmpq(c) for c in digits])

    def _digits(self, residue: flint.nmod_poly) -> list[int]:
        found = coefficients(residue)
        return found + [0] * (self.prime.f - len(found))

    def radical(self, rows: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return the x with tr(x·O) ⊂ P and N(x) ∈ P, a lattice between O and p·O."""
        frame, other = self.frame, rows.transpose()
        traces = [self._modulo(rows * form * other) for form in frame.gram]
        entries: list[list[int]] = [[] for _ in range(frame.size)]
        for digits in zip(*self._residues, strict=True):
            total = flint.nmod_mat(frame.size, frame.size, self.p)
            for matrix, c in zip(traces, digits, strict=True):
                total += matrix * c
            for row, found in zip(entries, total.tolist(), strict=True):
                row += map(int, found)
        vectors = left_kernel(flint.nmod_mat(entries, self.p))
        if self.p == 2 and vectors:  # N is additive on these, and so is the root of its residue
            roots = [self._digits(self.place.sqrt(self._norm_residue(v, rows))) for v in vectors]
            chosen = left_kernel(flint.nmod_mat(roots, self.p))
            vectors = [
                [sum(c * v[k] for c, v in zip(u, vectors, strict=True)) for k in range(frame.size)]
                for u in chosen
            ]
        return self._above(rows, vectors)

    def _modulo(self, matrix: flint.fmpq_mat) -> flint.nmod_mat:
        """Return an integral matrix modulo p."""
        return flint.nmod_mat(matrix.numer_denom()[0], self.p)

    def _norm_residue(self, vector: list[int], rows: flint.fmpq_mat) -> flint.nmod_poly:
        row = (flint.fmpq_mat(flint.fmpz_mat(1, self.frame.size, vector)) * rows).entries()
        return self.prime.residue_of(self.frame.norm(row))

    def _above(self, rows: flint.fmpq_mat, vectors: Iterable[list[int]]) -> flint.fmpq_mat:
        """Return the lattice of some combinations of a basis, and p times this."""
        size = self.frame.size
        whole = [*vectors, *([self.p * int(i == j) for j in range(size)] for i in range(size))]
        return flint.fmpq_mat(hermite(whole, size)) * rows

    def left_order(self, ideal: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return the x with x·I ⊂ I, for an ideal I between an order and p times it."""
        inverse = ideal.inv()
        products = [
            self._modulo(ideal * self.frame.right(row) * inverse).tolist()
            for row in self._generators(ideal, inverse)
        ]
        columns = [[int(c) for part in row for c in part] for row in zip(*products, strict=True)]
        vectors = left_kernel(flint.nmod_mat(columns, self.p))
        return self._above(ideal, vectors) * flint.fmpq(1, self.p)

    def _generators(self, rows: flint.fmpq_mat, inverse: flint.fmpq_mat) -> Rows:
        """Return some rows that generate a lattice over the integers of the field, modulo p times it."""
        found: Rows = []
        vectors: list[list[int]] = []
        for row in rows.tolist():
            multiples = [(flint.fmpq_mat([row]) * m).entries() for m in self.frame.scalars]
            more = self._modulo(flint.fmpq_mat(multiples) * inverse).tolist()
            reduced, rank = flint.nmod_mat([*vectors, *map(_ints, more)], self.p).rref()
            if rank > len(vectors):
                vectors = list(map(_ints, reduced.tolist()[:rank]))
                found.append(row)
        return found

    def _maximal_ideal(self, rows: flint.fmpq_mat, radical: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return one of the two maximal ideals at P of an order that is hereditary there, and not maximal."""
        moved, _ = self.split_element(rows)
        inverse = rows.inv()
        both = [rows * self.frame.right(moved) * inverse, radical * inverse]
        return self._above(rows, [[int(c.p) for c in v] for m in both for v in m.tolist()])

    def split_element(self, rows: flint.fmpq_mat) -> tuple[list[flint.fmpq], FieldElement]:
        """Return x in the order, and r in K, with x² ≡ r·x and r ≢ 0 modulo P: x/r is idempotent modulo P.

        The order is M₂(ℤ_P) or has the Eichler symbol 1 at P, else none is found and :class:`LatticeError`
        raised.
        """
        frame, place, rng = self.frame, self.place, random.Random(1)
        for _ in range(TRIALS):
            vector = [rng.randrange(self.p) for _ in range(frame.size)]
            row = (flint.fmpq_mat(flint.fmpz_mat(1, frame.size, vector)) * rows).entries()
            trace = self.prime.residue_of(frame.parts(row)[0] * 2)
            found = place.quadratic_root(
                place.one, place.zero - trace, self._norm_residue(vector, rows)
            )
            if found is None or found[1] == 0:
                continue
            root = place.multiply(found[0], place.inverse(found[1]))
            other = (trace - root) % place.modulus
            if (other - root) % place.modulus == 0:
                continue
            shift = coordinate_rows(frame.field, [self.lift(root)]).entries()
            moved = [c - s for c, s in zip(row, [*shift, *[0] * (3 * frame.n)], strict=True)]
            return moved, self.lift((other - root) % place.modulus)
        raise LatticeError(f"no idempotent was found in the residues of an order at {self.prime}")

    def symbol(self, rows: flint.fmpq_mat) -> int:
        """Return 1, 0 or −1 where the residues modulo the radical are split, ramified or inert at P.

        Outside of what is central modulo the radical a polynomial x² − tr(x)·x + N(x) is separable.
        """
        place = self.place
        for row in rows.tolist():
            trace = self.prime.residue_of(self.frame.parts(row)[0] * 2)
            norm = self.prime.residue_of(self.frame.norm(row))
            if (trace if place.even else (trace * trace - norm * 4) % place.modulus) != 0:
                root = place.quadratic_root(place.one, place.zero - trace, norm)
                return -1 if root is None else 1
        return 0

    def norm_index(self, rows: flint.fmpq_mat) -> int:
        """Return the index of the norms of units of an order with the symbol 0 in the units of ℤ_P.

        With J the radical they are, modulo squares, the norms of 1 + J, which the 1 + b for bases of all Jᵏ
        generate. J⁴ is in P·O, so the last ones are 1 modulo 4P, and the norms are squares there.
        """
        digits, e = (self.prime.e * self.prime.f + 1, self.prime.e) if self.p == 2 else (1, 0)
        radical, classes = self.radical(rows), [0]
        power, one = radical, self.frame.row(1)
        for _ in range(4 * (2 * e + 1)):
            for row in power.tolist():
                unit = (flint.fmpq_mat([row]) + one).entries()
                c = square_class(self.prime, self.frame.norm(unit))
                if c not in classes:
                    classes += [c ^ other for other in classes]
            if self.p > 2 or len(classes) == 2**digits:
                break
            power = self.frame.product(power, radical)
        return int(2**digits // len(classes))

    @cached_property
    def representatives(self) -> list[FieldElement]:
        """Integers of the field, one of each class modulo P, 0 first."""
        digits = product(range(self.p), repeat=self.prime.f)
        return [self.lift(flint.nmod_poly(list(c), self.p)) for c in digits]

    def times_prime(self, rows: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return P·L."""
        return unique_rows(self.frame.multiple(rows, self.frame.integers.prime(self.prime)))

    def independent(self, larger: flint.fmpq_mat, below: flint.fmpq_mat) -> Rows:
        """Return elements of a lattice that are a basis of it modulo another, which contains P times it."""
        found: Rows = []
        inverse = below.inv()
        for row in larger.tolist():
            if any(c.q != 1 for c in (flint.fmpq_mat([row]) * inverse).entries()):
                found.append(row)
                multiples = [(flint.fmpq_mat([row]) * m).entries() for m in self.frame.scalars]
                below = unique_rows(flint.fmpq_mat([*below.tolist(), *multiples]))
                inverse = below.inv()
        return found

    def corners(
        self, rows: flint.fmpq_mat, e: flint.fmpq_mat
    ) -> tuple[flint.fmpq_mat, flint.fmpq_mat]:
        """Return e·b·(1 − e) and (1 − e)·b·e for the basis b of a lattice."""
        frame = self.frame
        left = flint.fmpq_mat([(e * frame.right(row)).entries() for row in rows.tolist()])
        other = frame.right((frame.row(1) - e).entries())
        return left * other, (rows - left) * frame.right(e.entries())

    def idempotent(self, rows: flint.fmpq_mat, k: int) -> flint.fmpq_mat:
        """Return e in an order that has matrices of rank 1 modulo P, with e² ≡ e modulo Pᵏ and e ≢ 0, 1.

        Raises :class:`LatticeError` as :meth:`split_element` does.
        """
        frame, place = self.frame, self.place
        element, r = self.split_element(rows)
        scale = self.lift(place.inverse(self.prime.residue_of(r)))
        e = flint.fmpq_mat([element]) * frame.scalar(scale)
        modulus = self.p ** -(-k // self.prime.e)
        inverse = rows.inv()
        known = 1
        while known < k:  # e ↦ 3e² − 2e³ doubles what is known
            square = e * frame.right(e.entries())
            coordinates = ((square * 3 - square * frame.right(e.entries()) * 2) * inverse).entries()
            e = flint.fmpq_mat(1, frame.size, [int(c.p) % modulus for c in coordinates]) * rows
            known *= 2
        return e

    def eichler_suborder(self, rows: flint.fmpq_mat, k: int) -> flint.fmpq_mat:
        """Return the x in an order that is maximal and split at P with e·x·(1 − e) ∈ Pᵏ·O."""
        frame = self.frame
        e = self.idempotent(rows, k)
        # these are (1 − e)·O + O·e + Pᵏ·O, and the conjugate of e is 1 − e modulo Pᵏ
        ideal = (rows * frame.right(e.entries())).tolist()
        parts = frame.multiple(rows, frame.integers.prime(self.prime) ** k).tolist()
        return unique_rows(flint.fmpq_mat([*ideal, *frame.conjugate(ideal), *parts]))


def _ints(row: list[flint.nmod]) -> list[int]:
    return list(map(int, row))
