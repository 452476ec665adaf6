"""Orders over the integers of a number field: maximal ones, as ℤ-modules and with pseudo-bases.

An order in (a, b | K), K of degree n, is a lattice of rank 4n. It is made larger prime ideal by prime ideal,
as over ℤ (:mod:`hfield.lattices.maximal_orders`): the left order of the radical at P, the x with
tr(x·O) ⊂ P and N(x) ∈ P, is larger until the order is hereditary at P; then one of two maximal ideals has
a maximal left order, unless the algebra ramifies at P (Voight, *Quaternion Algebras*, sections 15.5, 21.2,
24.4).
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Any

import flint

from hfield.errors import LatticeError, TooLargeError, shorten
from hfield.fields.number_fields.integers import left_kernel
from hfield.fields.number_fields.integral_basis import coordinate_rows
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, primes_above
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.residues import local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates, finite_ramified
from hfield.lattices.dedekind_modules import hermite
from hfield.lattices.integral_coordinates import Frame
from hfield.primality import WORD
from hfield.rings.residue_polynomials import coefficients

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.lattices.dedekind_modules import PseudoBasis

TRIALS = 1_000


class IntegersOrder:
    """An order over the integers of a number field; ``rows`` are a basis over ℤ, see :class:`Frame`.

    It is checked to be a ring with 1, and to have the discriminant that the ramified places ask for.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ[s]/(s^3-2)", -1, -1).maximal_order()
    >>> O.discriminant(), len(O.basis), O.is_maximal()
    (((2, s),), 12, True)
    """

    def __init__(self, frame: Frame, rows: flint.fmpq_mat, finite: tuple[PrimeIdeal, ...]) -> None:
        self._frame, self._rows = frame, rows
        self.algebra, self.field = frame.algebra, frame.field
        self._ramified = finite
        frame.check_ring(rows)
        if self.norm_of_discriminant() != math.prod(P.norm for P in finite):
            raise AssertionError("a maximal order has the discriminant of its algebra")

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """A basis over ℤ, of 4n quaternions."""
        return tuple(self._frame.quaternion(row) for row in self._rows.tolist())

    def __contains__(self, x: object) -> bool:
        row = self._frame.row(self.algebra(x))
        return all(c.q == 1 for c in (row * self._rows.inv()).entries())

    def pseudo_basis(self) -> PseudoBasis:
        """Return four pairs (basis over ℤ of an ideal, quaternion): O is the direct sum of their products."""
        return self._frame.pseudo_basis(self._rows)

    def discriminant(self) -> tuple[PrimeIdeal, ...]:
        """Return the prime ideals whose product is the reduced discriminant."""
        return tuple(self.algebra.discriminant())

    def norm_of_discriminant(self) -> int:
        """Return the norm of the reduced discriminant, from the determinant of tr(x·conj(y)), traced to ℚ."""
        size = abs(self._frame.gram_determinant(self._rows)) / self.field.discriminant() ** 4
        root = int(size.p.isqrt())
        assert size == root * root, "the discriminant of an order is a square"
        return root

    def is_maximal(self) -> bool:
        """Tell whether the order is maximal: whether its discriminant is that of the algebra."""
        return self.norm_of_discriminant() == math.prod(P.norm for P in self._ramified)

    def __repr__(self) -> str:
        return f"the maximal order of {self.algebra} with the discriminant {self.discriminant()}"


def maximal_order_over_integers(algebra: Any) -> IntegersOrder:
    """Return a maximal order over the integers of a number field, always the same.

    Raises :class:`LatticeError` for a degenerate algebra, :class:`UnfactoredError` where a norm or the
    discriminant of the field is too hard to factor, :class:`TooLargeError` at primes of 64 bits and more.
    """
    ring = algebra.ring
    if not isinstance(ring, NumberField | QuadraticField) or not algebra.is_central_simple():
        raise LatticeError(
            f"{shorten(algebra)} has no maximal order here: expected a nondegenerate algebra over QQ or over "
            "another number field"
        )
    frame = Frame(algebra, ring)
    bad = sorted({2} | candidates(frame.field, frame.a) | candidates(frame.field, frame.b))
    finite = tuple(finite_ramified(frame.a, frame.b, set(bad)))
    rows = frame.start
    for p in bad:
        for prime in primes_above(frame.field, p):
            rows = _Local(frame, prime).maximal(rows, prime in finite)
    return IntegersOrder(frame, rows, finite)


class _Local:
    """What makes an order larger at one prime ideal."""

    def __init__(self, frame: Frame, prime: PrimeIdeal) -> None:
        self.frame, self.prime, self.p = frame, prime, prime.p
        self.place = local_place(prime)
        self._residues = [self._digits(prime.residue_of(w)) for w in frame.omega]

    def maximal(self, rows: flint.fmpq_mat, ramified: bool) -> flint.fmpq_mat:
        """Return an order that contains the given one, is maximal at P, and the same elsewhere."""
        frame, prime = self.frame, self.prime
        level = prime.valuation(frame.a * frame.b * 4)
        if level > int(ramified) and self.p >= WORD:
            raise TooLargeError(
                f"an order is not enlarged at {shorten(prime)}, whose residues exceed a machine's word"
            )
        while level > int(ramified):
            radical = self._radical(rows)
            larger = self._left_order(radical)
            if larger.det() == rows.det():  # hereditary, of level P
                larger = self._left_order(self._maximal_ideal(rows, radical))
            index = abs(rows.det() / larger.det())
            level -= int(math.log2(int(index.p)) / math.log2(prime.norm) + 0.5)
            rows = larger
        return rows

    def _digits(self, residue: flint.nmod_poly) -> list[int]:
        found = coefficients(residue)
        return found + [0] * (self.prime.f - len(found))

    def _radical(self, rows: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return the x with tr(x·O) ⊂ P and N(x) ∈ P, a lattice between O and p·O."""
        frame, n, f = self.frame, self.frame.n, self.prime.f
        residues = flint.nmod_mat(n, f, [c for row in self._residues for c in row], self.p)
        entries: list[list[int]] = [[] for _ in range(frame.size)]
        for row in rows.tolist():
            products = (rows * frame.right(row)).tolist()
            for k, product in enumerate(products):
                trace = [
                    int((2 * c).p) * pow(int((2 * c).q), -1, self.p) % self.p for c in product[:n]
                ]
                entries[k] += [
                    int(c) for c in (flint.nmod_mat(1, n, trace, self.p) * residues).entries()
                ]
        vectors = left_kernel(self._matrix(entries))
        if self.p == 2 and vectors:  # N is additive on these, and so is the root of its residue
            roots = [self._digits(self.place.sqrt(self._norm_residue(v, rows))) for v in vectors]
            chosen = left_kernel(self._matrix(roots))
            vectors = [
                [sum(c * v[k] for c, v in zip(u, vectors, strict=True)) for k in range(frame.size)]
                for u in chosen
            ]
        return self._above(rows, vectors)

    def _norm_residue(self, vector: list[int], rows: flint.fmpq_mat) -> flint.nmod_poly:
        row = (flint.fmpq_mat(flint.fmpz_mat(1, self.frame.size, vector)) * rows).entries()
        return self.prime.residue_of(self.frame.norm(row))

    def _matrix(self, rows: list[list[int]]) -> flint.nmod_mat:
        return flint.nmod_mat(len(rows), len(rows[0]), [c for row in rows for c in row], self.p)

    def _above(self, rows: flint.fmpq_mat, vectors: Iterable[list[int]]) -> flint.fmpq_mat:
        """Return the lattice of some combinations of a basis, and p times this."""
        size = self.frame.size
        whole = [*vectors, *([self.p * int(i == j) for j in range(size)] for i in range(size))]
        return flint.fmpq_mat(hermite(whole, size)) * rows

    def _left_order(self, ideal: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return the x with x·I ⊂ I, for an ideal I between an order and p times it."""
        frame, inverse = self.frame, ideal.inv()
        columns: list[list[int]] = [[] for _ in range(frame.size)]
        for row in ideal.tolist():
            products = (ideal * frame.right(row) * inverse).tolist()
            for k, product in enumerate(products):
                columns[k] += [int(c.p) % self.p for c in product]
        return self._above(ideal, left_kernel(self._matrix(columns))) * flint.fmpq(1, self.p)

    def _maximal_ideal(self, rows: flint.fmpq_mat, radical: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return one of the two maximal ideals at P of an order that is hereditary there, and not maximal."""
        frame, place, rng = self.frame, self.place, random.Random(1)
        inverse = rows.inv()
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
            if (root + root - trace) % place.modulus == 0:
                continue
            shift = coordinate_rows(frame.field, [place.lift(root)]).entries()
            moved = [c - s for c, s in zip(row, [*shift, *[0] * (3 * frame.n)], strict=True)]
            both = [rows * frame.right(moved) * inverse, radical * inverse]
            return self._above(rows, [[int(c.p) for c in v] for m in both for v in m.tolist()])
        raise LatticeError(f"no idempotent was found in the residues of an order at {self.prime}")
