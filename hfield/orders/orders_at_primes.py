"""An order at one prime P of its base: its radical, larger orders, idempotents and zero divisors.

The radical at P consists of all x with tr(x·O) ⊂ P and N(x) ∈ P. Its left order is larger than O unless O is
hereditary at P. A hereditary order is maximal at P, or an Eichler order of level P there, the intersection of
two maximal ones (Voight, *Quaternion Algebras*, 15.5, 21.2, 24.4). All computations are linear algebra modulo
the prime number p below P, which may be large.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import count, islice, product
from typing import TYPE_CHECKING

from flint import fmpq_mat, fmpz_mat

from hfield.core.properties import cached_property
from hfield.errors import LatticeError
from hfield.fields.base.finite_places import Residue
from hfield.orders import hermite
from hfield.orders.base_values import BaseIdeal, BaseNumber, Prime
from hfield.orders.domains import EuclideanDomain
from hfield.orders.kernels.general import ideal_multiples
from hfield.orders.lattice_values import (
    LatticeValue,
    add_elements,
    hermite_form,
    order_of,
    times_ideal,
)
from hfield.orders.lattice_values import product as lattice_product

if TYPE_CHECKING:
    from _typeshed import SupportsRichComparison

Vector = Sequence[int]
Line = tuple[int, Vector]
"""A number of a basis element, and coordinates of another element, with 0 there."""
TRIALS = 1_000


class OrderAtPrime:
    """An order at a prime P above the prime number p; P has ``norm`` residues.

    Vectors are coordinates in the basis of the order over ℤ.
    """

    def __init__(self, order: LatticeValue, prime: Prime) -> None:
        self.order, self.prime, self.ambient = order, prime, order.ambient
        self.base = base = order.ambient.base
        self.place = base.place(prime)
        self.p = self.place.below
        self.ideal = base.prime_ideal(prime)
        self.norm = base.absolute_norm(self.ideal)
        self.domain = order.ambient.domain
        self.traces, self.forms = order.integral_grams, order.integral_forms
        self._zero_divisors: dict[int, fmpz_mat] = {}

    # --- traces, norms and residues --------------------------------------------------------------

    @cached_property
    def _one(self) -> fmpz_mat:
        """The coordinates of 1, as a column."""
        row = self.ambient.one * self.order.inverse_rows
        return row.numer_denom()[0].transpose()

    def trace(self, v: Vector) -> list[int]:
        """Return the coordinates of the trace of an element."""
        row = self.domain.matrix([list(v)])
        return [(row * form * self._one)[0, 0] for form in self.traces]

    def norm_of(self, v: Vector) -> list[int]:
        """Return the coordinates of the norm of an element."""
        row = self.domain.matrix([list(v)])
        column, factor = row.transpose(), self.domain.form_factor
        return [(row * form * column)[0, 0] // factor for form in self.forms]

    @cached_property
    def _basis_residues(self) -> list[Residue]:
        """The residues of the integral basis."""
        return [self.place.reduce(w) for w in self.base.integral_basis]

    def residue(self, coordinates: Iterable[int]) -> Residue:
        """Return the residue of an integer of the base with these coordinates."""
        pairs = zip(coordinates, self._basis_residues, strict=True)
        integer = self.domain.integer
        total = sum((w * integer(c % self.p) for c, w in pairs), self.place.zero)
        found: Residue = total % self.place.modulus
        return found

    def digits(self, residue: Residue) -> list[int]:
        """Return the coordinates of a residue over the prime field."""
        return self.base.digits(self.prime, residue)

    def _sort_key(self, residue: Residue) -> SupportsRichComparison:
        return self.domain.sort_key(tuple(self.digits(residue)))

    def lift(self, residue: Residue) -> BaseNumber:
        """Return an integer of the field with a given residue."""
        found: BaseNumber = self.base.lift(self.prime, residue)
        return found

    @cached_property
    def representatives(self) -> list[BaseNumber]:
        """Integers of the field, one for each residue class modulo P, 0 first."""
        return self.base.residues(self.prime)

    def power_of_p(self, k: int) -> int:
        """Return the least power of p that lies in Pᵏ."""
        power: int = self.p ** -(-k // self.place.index)
        return power

    # --- larger orders ---------------------------------------------------------------------------

    @cached_property
    def radical(self) -> LatticeValue:
        """The x with tr(x·O) ⊂ P and N(x) ∈ P, a lattice between O and p·O; it is P·O if O is M₂(ℤ_P)."""
        digits = zip(*map(self.digits, self._basis_residues), strict=True)
        # tr(x·conj(O)) is the same, as conj(O) = O
        forms = [self._combined(c) for c in digits]
        vectors = self.domain.kernel(hermite.stacked(*forms), self.p)
        if self.place.even and vectors:  # N is additive on these, and so is the root of its residue
            roots = (self.place.sqrt(self.residue(self.norm_of(v))) for v in vectors)
            known = (r for r in roots if r is not None)  # each has one, in characteristic 2
            columns = list(zip(*map(self.digits, known), strict=True))
            matrix = self.domain.matrix
            chosen = self.domain.kernel(matrix(columns), self.p)
            vectors = (matrix(chosen) * matrix(vectors)).tolist() if chosen else []
        own = self.order.matrix
        rows = [self.domain.matrix(vectors) * own] if vectors else []
        return hermite_form(self.ambient, self.order.den, hermite.stacked(*rows, own * self.p))

    def _combined(self, factors: Sequence[int]) -> fmpz_mat:
        """Return a linear combination of the trace matrices."""
        total = self.traces[0] * factors[0]
        for form, c in zip(self.traces[1:], factors[1:], strict=True):
            total += form * c
        return total

    @cached_property
    def larger(self) -> LatticeValue:
        """The left order of the radical, which is O if O is hereditary at P."""
        return order_of(self.radical, "left")

    # --- elements with two eigenvalues modulo P --------------------------------------------------

    @cached_property
    def split_element(self) -> tuple[fmpq_mat, Residue, Residue]:
        """An element x, as one row, and distinct roots r, s of its characteristic polynomial modulo P.

        Raises :class:`LatticeError` unless the order is M₂(ℤ_P) or has Eichler symbol 1 at P.
        """
        rng, size = random.Random(1), self.ambient.size
        some, draw = self.domain.few_residues(self.p), self.domain.random
        small = islice(product(some, repeat=size), TRIALS)
        others = ([draw(rng, self.p) for _ in range(size)] for _ in range(TRIALS))
        for vectors in (small, others):
            for v in vectors:
                roots = self._roots(v)
                if roots is not None:
                    return self.order_row(v), *roots
        raise LatticeError(f"this order is not an Eichler order at {self.prime}")

    def coordinates(self, rows: fmpq_mat) -> fmpz_mat:
        """Return the coordinates of elements of the order."""
        return (rows * self.order.inverse_rows).numer_denom()[0]

    def order_row(self, v: Vector) -> fmpq_mat:
        """Return the element with these coordinates, as a row of rational numbers."""
        domain = self.domain
        return domain.matrix([list(v)]) * self.order.matrix * domain.fraction(1, self.order.den)

    def _roots(self, v: Vector) -> tuple[Residue, Residue] | None:
        """Return the two roots modulo P of x² − tr(x)·x + N(x), or None unless there are two."""
        place, trace = self.place, self.residue(self.trace(v))
        found = place.quadratic_root(place.one, place.zero - trace, self.residue(self.norm_of(v)))
        if found is None or found[1] == 0:
            return None
        root = place.multiply(found[0], place.inverse(found[1]))
        other = (trace - root) % place.modulus
        if (other - root) % place.modulus == 0:
            return None
        first, second = sorted((root, other), key=self._sort_key)
        return first, second

    def idempotent(self, k: int) -> fmpq_mat:
        """Return e in the order with e² ≡ e modulo Pᵏ and e neither 0 nor 1 modulo P.

        Raises :class:`LatticeError` as :attr:`split_element` does.
        """
        ambient, place = self.ambient, self.place
        x, r, s = self.split_element
        modulus = self.power_of_p(k)
        scale = self.lift(place.inverse((r - s) % place.modulus))
        e = self._small((x - self._number(self.lift(s))) * ambient.scalar(scale), modulus)
        known = 1
        while known < k:  # e ↦ 3e² − 2e³ doubles the known digits
            square = e * ambient.times(e)
            e = self._small(square * 3 - square * ambient.times(e) * 2, modulus)
            known *= 2
        return e

    def _number(self, x: BaseNumber) -> fmpq_mat:
        """Return a number of the field as an element with one row."""
        return self.ambient.one * self.ambient.scalar(x)

    def _small(self, x: fmpq_mat, modulus: int) -> fmpq_mat:
        """Return an element of the order with coordinates reduced modulo ``modulus``."""
        coordinates = (x * self.order.inverse_rows).entries()
        return self.order_row([self.domain.numerator(c) % modulus for c in coordinates])

    def corners(self, e: fmpq_mat) -> tuple[fmpq_mat, fmpq_mat]:
        """Return e·b·(1 − e) and (1 − e)·b·e for all b in the basis of the order."""
        ambient, rows = self.ambient, self.order.rows
        left = rows * ambient.times(e, "left")
        return left * ambient.times(ambient.one - e), (rows - left) * ambient.times(e)

    def ends(self, k: int) -> tuple[LatticeValue, LatticeValue]:
        """Return the two orders, maximal at P, whose intersection is the Eichler order of level Pᵏ."""
        first, second = self.corners(self.idempotent(k))
        above = self.base.inverse(self.ideal**k)
        return self._with(second, above), self._with(first, above)

    def _with(self, rows: fmpq_mat, ideal: BaseIdeal) -> LatticeValue:
        """Return the sum of the order and an ideal times the span of rows."""
        den, whole = hermite.rational(rows)
        below, multiples = ideal_multiples(self.ambient, whole, ideal)
        own = self.order
        joined = hermite.joined(own.den, own.matrix, den * below, multiples)
        return hermite_form(self.ambient, *joined)

    # --- zero divisors ---------------------------------------------------------------------------

    def zero_divisor(self, e: int) -> fmpz_mat:
        """Return an element outside P·O with norm in Pᵉ, as a row over the denominator; O must be M₂(ℤ_P)."""
        found = self._zero_divisors.get(e)
        if found is None:
            found = self._zero_divisors[e] = self._new_zero_divisor(e)
        return found

    def _new_zero_divisor(self, e: int) -> fmpz_mat:
        """Find the element on a line with small coordinates.

        On this line the norm is a quadratic polynomial. An element at a simple root modulo P does not lie in
        P·O.
        """
        size = self.ambient.size
        factor, matrix = self.domain.form_factor, self.domain.matrix
        squares = [[form[n, n] // factor for form in self.forms] for n in range(size)]
        for n, v in small_lines(self.domain, size):
            row = matrix(1, size, list(v))
            column = row.transpose()
            slopes = [(form * column)[n, 0] for form in self.traces]
            polynomial = squares[n], slopes, self.norm_of(v)
            root = self._simple_root(*map(self.residue, polynomial))
            if root is not None:
                x = self._lifted(polynomial, self.lift(root), e)
                factor, _ = self.base.coordinate_rows([x]).numer_denom()
                own = matrix(1, size, [int(m == n) for m in range(size)]) * self.order.matrix
                return self.ambient.times_scalar(own, factor.entries()) + row * self.order.matrix
        raise AssertionError(
            "the norm form modulo P is that of 2 × 2 matrices, which has such zeros"
        )

    def random_unit(self, rng: random.Random, e: int) -> fmpz_mat:
        """Return a uniformly random unit of O/Pᵉ, as a row over the denominator."""
        size, modulus = self.ambient.size, self.power_of_p(e)
        while True:
            v = [self.domain.random(rng, modulus) for _ in range(size)]
            if self.residue(self.norm_of(v)) != 0:
                return self.domain.matrix([v]) * self.order.matrix

    def times(self, rows: fmpz_mat, x: fmpz_mat) -> fmpz_mat:
        """Return rows times an element x of the order, over the order's denominator."""
        ambient, den = self.ambient, self.order.den
        return hermite.divided(rows * ambient.right_matrix(x.entries()), den * ambient.scale)

    def _simple_root(self, a: Residue, b: Residue, c: Residue) -> Residue | None:
        """Return the first simple root of a·x² + b·x + c among the residues, or None."""
        place = self.place
        if a == 0:
            return (
                place.multiply(place.zero - c, place.inverse(b)) % place.modulus if b != 0 else None
            )
        found = place.quadratic_root(a, b, c)
        if found is None:
            return None
        root = place.multiply(found[0], place.inverse(found[1]))
        other = (place.zero - place.multiply(b, place.inverse(a)) - root) % place.modulus
        return min(root, other, key=self._sort_key) if root != other else None

    def _lifted(self, polynomial: Sequence[list[int]], root: BaseNumber, e: int) -> BaseNumber:
        """Return the root of a·x² + b·x + c modulo Pᵉ above a simple root modulo P (Hensel)."""
        if e == 1:
            return root
        fraction = self.domain.fraction
        a, b, c = (self.base.element_of([fraction(x) for x in number]) for number in polynomial)
        near, modulus = self.base.integer_near, self.power_of_p(e)
        slope = self.place.reduce(a * root * 2 + b)
        inverse, known = self.lift(self.place.inverse(slope)), 1
        while known < e:
            root = near(root - (a * root * root + b * root + c) * inverse, modulus)
            inverse = near(inverse * 2 - (a * root * 2 + b) * inverse * inverse, modulus)
            known *= 2
        return root

    # --- elements outside P times a lattice -------------------------------------------------------

    def times_prime(self, lattice: LatticeValue) -> LatticeValue:
        """Return P·L."""
        return times_ideal(lattice, self.ideal)

    @cached_property
    def basis_modulo_prime(self) -> list[fmpq_mat]:
        """Elements, one per row, that form a basis of the order modulo P."""
        return independent(self.order.rows, self.times_prime(self.order))

    def norm_index(self) -> int:
        """Return the index, in the units of ℤ_P, of the norms of units of an order with Eichler symbol 0.

        Let J be the radical. Modulo squares the norms are those of 1 + J, which are generated by the norms of
        1 + b for b in bases of all Jᵏ. J⁴ is in P·O, so from some k on these are 1 modulo 4P, hence squares.
        """
        digits, square_class = self.base.square_classes(self.prime)
        e = self.place.index if self.p == 2 else 0
        radical, classes = self.radical, [0]
        power, one = radical, self.ambient.one
        for _ in range(4 * (2 * e + 1)):
            for row in power.rows.tolist():
                unit = (fmpq_mat([row]) + one).entries()
                c = square_class(self.ambient.norm(unit))
                if c not in classes:
                    classes += [c ^ other for other in classes]
            if self.p > 2 or len(classes) == 2**digits:
                break
            power = lattice_product(power, radical)
        return int(2**digits // len(classes))


def independent(larger: fmpq_mat, below: LatticeValue) -> list[fmpq_mat]:
    """Return rows that form a basis of the span of ``larger`` modulo a lattice, over the residue field of a
    prime.
    """
    found = []
    for row in larger.tolist():
        x = below.ambient.domain.fraction_matrix([row])
        if (x * below.inverse_rows).numer_denom()[1] != 1:
            found.append(x)
            below = add_elements(below, x)
    return found


def small_lines(domain: EuclideanDomain, size: int) -> Iterator[Line]:
    """Yield infinitely many lines: one coordinate is free, the others have small values."""
    for largest in count(1):
        smaller = set(domain.small(largest - 1))
        for rest in product(list(domain.small(largest)), repeat=size - 1):
            if not smaller.issuperset(rest):
                for n in range(size):
                    yield n, [*rest[:n], 0, *rest[n:]]


@lru_cache(maxsize=64)
def order_at_prime(order: LatticeValue, prime: Prime) -> OrderAtPrime:
    """Return an order at a prime, from a cache."""
    return OrderAtPrime(order, prime)
