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
from typing import TYPE_CHECKING, Any

import flint

from hfield.errors import LatticeError, TooLargeError, shorten
from hfield.fields.number_fields.ideals import Ideal, integers
from hfield.fields.number_fields.integers import left_kernel
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, primes_above
from hfield.fields.number_fields.quadratic.as_number_field import (
    as_number_field,
    from_number_field,
    into_number_field,
)
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.residues import local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates, finite_ramified
from hfield.lattices.enumeration import short_vectors
from hfield.lattices.over_integers.dedekind_modules import hermite, multiplication, pseudo_basis
from hfield.lattices.over_integers.lattices import IntegersLattice
from hfield.primality import WORD
from hfield.product import Constants, Scalar, multiply, norm
from hfield.rings.residue_polynomials import coefficients
from hfield.structure.forms import NormalForm, normal_form

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.lattices.over_integers.dedekind_modules import PseudoBasis


class Frame:
    """Coordinates: those of w, x, y, z in the integral basis of K, for w + x·I + y·J + z·IJ.

    I² = a and J² = b are multiples by squares of the constants of the normal form, and integral.
    """

    def __init__(self, algebra: Any, ring: NumberField | QuadraticField) -> None:
        self.algebra = algebra
        self.field = field = ring if isinstance(ring, NumberField) else as_number_field(ring)
        self.n = field.degree
        self.omega = field.integral_basis()
        self.size = 4 * self.n
        self.form: NormalForm = normal_form(field, Constants(*map(self._inside, algebra.constants)))
        self.scales = [_multiple(field, x) for x in self.form.constants]
        self.a, self.b = (
            x * (m * m) for x, m in zip(self.form.constants, self.scales, strict=True)
        )
        self.start = multiplication(field, field.one, 4)
        self.constants = Constants(self.a, 0, self.b)
        scalars = [multiplication(field, w, 4) for w in self.omega]
        self._right = [self._by_right(u) * scalar for u in range(4) for scalar in scalars]

    def _by_right(self, unit: int) -> flint.fmpq_mat:
        """Return the matrix of the multiplication by e, I, J or IJ from the right."""
        units: list[Any] = [tuple(int(m == n) for n in range(4)) for m in range(4)]
        products = [multiply(self.constants, left, units[unit]) for left in units]
        elements = [w * x for q in products for w in self.omega for x in q]
        entries = coordinate_rows(self.field, elements).entries()
        return flint.fmpq_mat(self.size, self.size, entries)

    def right(self, row: list[flint.fmpq]) -> flint.fmpq_mat:
        """Return the matrix of the multiplication by an element from the right."""
        total = flint.fmpq_mat(self.size, self.size)
        for c, matrix in zip(row, self._right, strict=True):
            if c != 0:
                total = total + matrix * c
        return total

    def parts(self, row: list[flint.fmpq]) -> Any:
        """Return w, x, y, z."""
        return [element_of(self.field, row[k * self.n : (k + 1) * self.n]) for k in range(4)]

    def quaternion(self, row: list[flint.fmpq]) -> Quaternion:
        """Return the element of the algebra."""
        w, x, y, z = self.parts(row)
        r, s = self.scales
        found = self.form.back((w, x * r, y * s, z * (r * s)))
        q: Quaternion = self.algebra(*map(self._outside, found))
        return q

    def _outside(self, x: FieldElement) -> Scalar:
        """Return an element of the number field as one of the base field."""
        ring = self.algebra.ring
        return from_number_field(ring, x) if isinstance(ring, QuadraticField) else x

    def _inside(self, x: Any) -> Any:
        """Return an element of the base field as one of the number field, which may be written otherwise."""
        ring = self.algebra.ring
        return into_number_field(self.field, x, ring.d) if isinstance(ring, QuadraticField) else x

    def row(self, q: Quaternion) -> Any:
        """Return the coordinates of an element of the algebra."""
        a, b, c, d = map(self._inside, q.coordinates)
        w, x, y, z = self.form.forth((a, b, c, d))
        r, s = (flint.fmpq(1, m) for m in self.scales)
        block = coordinate_rows(self.field, [w, x * r, y * s, z * (r * s)])
        return flint.fmpq_mat(1, self.size, block.entries())

    def norm(self, row: list[flint.fmpq]) -> Any:
        """Return the reduced norm."""
        return norm(self.constants, self.parts(row))

    def discriminant_norm(self, rows: flint.fmpq_mat) -> flint.fmpq:
        """Return the norm of the reduced discriminant, N(4ab) on ⟨1, I, J, IJ⟩ over the integers of K."""
        return abs((4 * self.a * self.b).norm() * rows.det())

    def pseudo_basis(self, rows: flint.fmpq_mat) -> PseudoBasis:
        """Return ideals and quaternions."""
        return tuple(
            (tuple(map(self._outside, ideal)), self.quaternion(row))
            for ideal, row in pseudo_basis(self.field, rows)
        )


def _multiple(field: NumberField, x: FieldElement) -> int:
    """Return a positive integer m for which m·x is an integer of the field."""
    return math.lcm(*(int(c.q) for c in coordinate_rows(field, [x]).entries()))


TRIALS = 1_000


class IntegersOrder(IntegersLattice):
    """An order over the integers of a number field; ``rows`` are a basis over ℤ, see :class:`Frame`.

    It is checked to be a ring with 1, and to have the discriminant that the ramified places ask for.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ[s]/(s^3-2)", -1, -1).maximal_order()
    >>> O.discriminant(), len(O.basis), O.is_maximal()
    (ideal(2, s), 12, True)
    """

    def __init__(self, frame: Frame, rows: flint.fmpq_mat, finite: tuple[PrimeIdeal, ...]) -> None:
        super().__init__(frame, rows)
        rows = self.rows
        self._ramified = finite
        inverse = rows.inv()
        products = [rows * frame.right(row) * inverse for row in rows.tolist()]
        if 1 not in self or any(c.q != 1 for m in products for c in m.entries()):
            raise AssertionError("an order is closed under multiplication")
        if not self.is_maximal():
            raise AssertionError("a maximal order has the discriminant of its algebra")

    def discriminant(self) -> Ideal:
        """Return the reduced discriminant, an ideal of the integers of the field."""
        K: Any = self.algebra.ring
        found: Ideal = math.prod(map(K.ideal, self.algebra.discriminant()), start=K.ideal(1))
        return found

    def norm_of_discriminant(self) -> int:
        """Return the norm of the reduced discriminant."""
        return int(self.frame.discriminant_norm(self.rows).p)

    def is_maximal(self) -> bool:
        """Tell whether the order is maximal: whether its discriminant is that of the algebra."""
        return self.norm_of_discriminant() == math.prod(P.norm for P in self._ramified)

    def unit_index(self) -> int:
        """Return [Oˣ : ℤ_Kˣ], of a totally definite algebra: units are enumerated in the form Tr(N(x)).

        Raises :class:`LatticeError` for other algebras, whose units are infinitely many.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().unit_index()
        60
        """
        field = self.field
        signs = [
            field.multiplication(x).charpoly().coeffs() for x in (-self.frame.a, -self.frame.b)
        ]
        positive = all(c * (-1) ** (len(p) - 1 - k) > 0 for p in signs for k, c in enumerate(p))
        if field.signature != (field.degree, 0) or not positive:
            raise LatticeError(
                f"the units of orders in {shorten(self.algebra)} modulo those of the field are not finitely "
                "many; expected a totally definite algebra over a totally real field"
            )
        # the units of norm u, up to sign, for u in the totally positive units modulo squares of units
        norms = [field.one]
        inside = integers(self.algebra.ring).inside
        for g in map(inside, self.algebra.ring.totally_positive_units()):
            if all((g * u).sqrt() is None for u in norms):
                norms += [g * u for u in norms]
        rows = self.rows.tolist()
        values = [self.frame.norm(row) for row in rows]

        def both(i: int, j: int) -> Any:
            total = self.frame.norm([x + y for x, y in zip(rows[i], rows[j], strict=True)])
            return total - values[i] - values[j]

        size = range(len(rows))
        gram = flint.fmpz_mat([[int(both(i, j).trace().p) for j in size] for i in size])
        change = gram.lll(transform=True, rep="gram")[1]
        form = (change * gram * change.transpose()).tolist()
        basis = flint.fmpq_mat(change) * self.rows
        bound = max(2 * int(u.trace().p) for u in norms)
        count = 0
        for x, _ in short_vectors([list(map(int, row)) for row in form], bound):
            row = flint.fmpq_mat(flint.fmpz_mat(1, len(x), x)) * basis
            count += self.frame.norm(row.entries()) in norms
        return count

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
        frame, n = self.frame, self.frame.n
        residues = flint.nmod_mat(self._residues, self.p)
        entries: list[list[int]] = [[] for _ in range(frame.size)]
        for row in rows.tolist():
            products = (rows * frame.right(row)).tolist()
            traces = flint.nmod_mat([list(map(self._twice, q[:n])) for q in products], self.p)
            for k, found in enumerate((traces * residues).tolist()):
                entries[k] += map(int, found)
        vectors = left_kernel(flint.nmod_mat(entries, self.p))
        if self.p == 2 and vectors:  # N is additive on these, and so is the root of its residue
            roots = [self._digits(self.place.sqrt(self._norm_residue(v, rows))) for v in vectors]
            chosen = left_kernel(flint.nmod_mat(roots, self.p))
            vectors = [
                [sum(c * v[k] for c, v in zip(u, vectors, strict=True)) for k in range(frame.size)]
                for u in chosen
            ]
        return self._above(rows, vectors)

    def _twice(self, c: flint.fmpq) -> int:
        """Return 2c modulo p, which does not divide the denominator."""
        double = 2 * c
        return int(double.p) * pow(int(double.q), -1, self.p) % self.p

    def _norm_residue(self, vector: list[int], rows: flint.fmpq_mat) -> flint.nmod_poly:
        row = (flint.fmpq_mat(flint.fmpz_mat(1, self.frame.size, vector)) * rows).entries()
        return self.prime.residue_of(self.frame.norm(row))

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
        vectors = left_kernel(flint.nmod_mat(columns, self.p))
        return self._above(ideal, vectors) * flint.fmpq(1, self.p)

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
