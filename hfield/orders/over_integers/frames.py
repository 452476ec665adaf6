"""Coordinates of a quaternion algebra over a number field, and what is asked of the field through them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any

import flint

from hfield.errors import LatticeError, RingError, shorten
from hfield.fields.number_fields.ideals import Ideal, ideal, integers
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.quadratic.places import QuadraticPlace
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates, finite_ramified
from hfield.orders.over_integers.dedekind_modules import multiplication, pseudo_basis, unique_rows
from hfield.product import Constants, multiply, norm
from hfield.structure.forms import NormalForm, normal_form

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.orders.over_integers.dedekind_modules import PseudoBasis


@lru_cache(maxsize=64)
def frame_of(algebra: Any) -> Frame:
    """Return the frame of an algebra. Raises :class:`LatticeError` for one that has none."""
    ring = algebra.ring
    if not isinstance(ring, NumberField | QuadraticField) or not algebra.is_central_simple():
        raise LatticeError(
            f"{shorten(algebra)} has no orders here: expected a nondegenerate algebra over QQ or over "
            "another number field"
        )
    return Frame(algebra, ring)


class Frame:
    """Coordinates: those of w, x, y, z in the integral basis of K, for w + x·I + y·J + z·IJ.

    I² = a and J² = b are multiples by squares of the constants of the normal form, and integral.
    """

    def __init__(self, algebra: Any, ring: NumberField | QuadraticField) -> None:
        self.algebra, self.integers = algebra, integers(ring)
        self.field = field = self.integers.field
        self.n = field.degree
        self.omega = field.integral_basis()
        self.size = 4 * self.n
        self.form: NormalForm = normal_form(
            field, Constants(*map(self.integers.inside, algebra.constants))
        )
        self.scales = [_multiple(field, x) for x in self.form.constants]
        self.a, self.b = (
            x * (m * m) for x, m in zip(self.form.constants, self.scales, strict=True)
        )
        self.start = multiplication(field, field.one, 4)
        self.constants = Constants(self.a, 0, self.b)
        self.scalars = [multiplication(field, w, 4) for w in self.omega]
        self._right = [self._by_right(u) * scalar for u in range(4) for scalar in self.scalars]

    # --- the base ----------------------------------------------------------------------------------

    def ideal(self, x: object) -> Ideal:
        """Return the ideal that a number, an ideal, a prime, or a list of them generates."""
        return ideal(self.integers.ring, x)

    def prime(self, x: object) -> PrimeIdeal:
        """Return a prime ideal of QQ[s]/(f), which may be given as an ideal or a prime number that is inert.

        Raises :class:`LatticeError` for what is none.
        """
        place = x
        if not isinstance(x, QuadraticPlace | PrimeIdeal):
            factors = self.ideal(x).factorisation()
            if len(factors) == 1 and factors[0][1] == 1:
                place = factors[0][0]
        with suppress(RingError):
            return self.integers.prime_inside(place)
        raise LatticeError(
            f"{shorten(x)} is no prime ideal of {shorten(self.integers.ring.name)}; "
            "see primes_above(p) of the field"
        )

    @cached_property
    def ramified(self) -> tuple[PrimeIdeal, ...]:
        """The prime ideals at which the algebra ramifies. Raises :class:`UnfactoredError`."""
        field, a, b = self.field, self.a, self.b
        return tuple(finite_ramified(a, b, {2} | candidates(field, a) | candidates(field, b)))

    @cached_property
    def is_definite(self) -> bool:
        """Whether the field is totally real and the algebra ramifies at all its real places."""
        return len(self.field.real_places()) == self.n and not self.split_places

    @cached_property
    def split_places(self) -> tuple[Any, ...]:
        """The real places at which the algebra splits."""
        places = self.field.real_places()
        return tuple(v for v in places if max(v.sign(self.a), v.sign(self.b)) > 0)

    @property
    def is_fuchsian(self) -> bool:
        """Whether the field is totally real and the algebra splits at one of its real places alone."""
        return len(self.field.real_places()) == self.n and len(self.split_places) == 1

    @cached_property
    def discriminant(self) -> Ideal:
        """The product of the prime ideals at which the algebra ramifies."""
        return math.prod(map(self.integers.prime, self.ramified), start=self.integers.one)

    # --- elements ----------------------------------------------------------------------------------

    def _by_right(self, unit: int) -> flint.fmpq_mat:
        """Return the matrix of the multiplication by e, I, J or IJ from the right."""
        units: list[Any] = [tuple(int(m == n) for n in range(4)) for m in range(4)]
        products = [multiply(self.constants, left, units[unit]) for left in units]
        elements = [w * x for q in products for w in self.omega for x in q]
        entries = coordinate_rows(self.field, elements).entries()
        return flint.fmpq_mat(self.size, self.size, entries)

    def right(self, row: Sequence[Any]) -> flint.fmpq_mat:
        """Return the matrix of the multiplication by an element from the right."""
        return self._combination(row, self._right)

    @cached_property
    def _left(self) -> list[flint.fmpq_mat]:
        """The matrices of the multiplication by a basis from the left: x·y is conj(conj(y)·conj(x))."""
        unit = [[int(k == m) for m in range(self.size)] for k in range(self.size)]
        flip = flint.fmpq_mat(self.conjugate(unit))
        return [flip * self.right(row) * flip for row in self.conjugate(unit)]

    def left(self, row: Sequence[Any]) -> flint.fmpq_mat:
        """Return the matrix of the multiplication by an element from the left."""
        return self._combination(row, self._left)

    def _combination(self, row: Sequence[Any], matrices: list[flint.fmpq_mat]) -> flint.fmpq_mat:
        total = flint.fmpq_mat(self.size, self.size)
        for c, matrix in zip(row, matrices, strict=True):
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
        q: Quaternion = self.algebra(*map(self.integers.outside, found))
        return q

    def row(self, x: object) -> flint.fmpq_mat:
        """Return the coordinates of what the algebra reads as an element, a matrix of one row."""
        q = self.algebra(x)
        if q.is_batch:
            raise LatticeError("expected single elements, and this is an array of them")
        a, b, c, d = map(self.integers.inside, q.coordinates)
        w, x, y, z = self.form.forth((a, b, c, d))
        r, s = (flint.fmpq(1, m) for m in self.scales)
        block = coordinate_rows(self.field, [w, x * r, y * s, z * (r * s)])
        return flint.fmpq_mat(1, self.size, block.entries())

    def conjugate(self, table: list[list[flint.fmpq]]) -> list[list[flint.fmpq]]:
        """Return the coordinates of the conjugates of the elements with these coordinates."""
        return [[c if k < self.n else -c for k, c in enumerate(row)] for row in table]

    def is_integral(self, row: flint.fmpq_mat) -> bool:
        """Tell whether an element has an integral trace and norm."""
        trace, norm = self.parts(row.entries())[0] * 2, self.norm(row.entries())
        return bool(self.field.is_integral(trace) and self.field.is_integral(norm))

    def scalar(self, x: Any) -> flint.fmpq_mat:
        """Return the matrix of the multiplication by an element of QQ[s]/(f)."""
        return self._combination(coordinate_rows(self.field, [x]).entries(), self.scalars)

    def norm(self, row: list[flint.fmpq]) -> Any:
        """Return the reduced norm."""
        return norm(self.constants, self.parts(row))

    @cached_property
    def gram(self) -> list[flint.fmpq_mat]:
        """The coordinates of tr(x·conj(y)) in the integral basis, n bilinear forms in those of x and y."""
        n, units = self.n, (self.field.one, -self.a, -self.b, self.a * self.b)
        forms = [flint.fmpq_mat(self.size, self.size) for _ in range(n)]
        for k, u in enumerate(units):
            products = [2 * u * v * w for v in self.omega for w in self.omega]
            for m, row in enumerate(coordinate_rows(self.field, products).tolist()):
                for form, c in zip(forms, row, strict=True):
                    form[k * n + m // n, k * n + m % n] = c
        return forms

    def norm_ideal(self, rows: flint.fmpq_mat) -> Ideal:
        """Return the ideal that the reduced norms of a lattice over the integers generate."""
        size, other = range(self.size), rows.transpose()
        forms = [(rows * form * other).tolist() for form in self.gram]
        # tr(x·conj(y)) is the norm of a sum less two norms; these forms are stable under the integers
        mixed = [[form[k][m] for form in forms] for k in size for m in range(k)]
        norms = flint.fmpq_mat([[form[k][k] / 2 for form in forms] for k in size])
        for w in self.omega:
            mixed += (norms * multiplication(self.field, w)).tolist()
        return self.integers.ideal(flint.fmpq_mat(mixed))

    # --- lattices, by rows of coordinates --------------------------------------------------------

    def product(self, first: flint.fmpq_mat, second: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return the product of two lattices."""
        factors = map(self.right, second.tolist())
        return unique_rows(flint.fmpq_mat([row for m in factors for row in (first * m).tolist()]))

    def multiple(self, rows: flint.fmpq_mat, ideal: Ideal) -> flint.fmpq_mat:
        """Return rows that span an ideal of the field times what the given rows span."""
        factors = map(self.scalar, ideal.elements)
        return flint.fmpq_mat([row for m in factors for row in (rows * m).tolist()])

    def dual(self, rows: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return the x with tr(x·L) in the integers of the field."""
        columns: list[list[flint.fmpq]] = []
        for row in rows.tolist():
            columns += (self.right(row) * 2).transpose().tolist()[: self.n]
        return unique_rows(flint.fmpq_mat(columns)).inv().transpose()

    def scalars_into(self, first: flint.fmpq_mat, second: flint.fmpq_mat) -> Ideal:
        """Return the x of the field with x·L ⊂ M."""
        inverse = second.inv()
        images = [(first * m * inverse).entries() for m in self.scalars]
        return self.integers.ideal(
            unique_rows(flint.fmpq_mat(images).transpose()).inv().transpose()
        )

    def volume(self, rows: flint.fmpq_mat) -> Ideal:
        """Return the index ideal of a lattice in ⟨1, I, J, IJ⟩; rows are its Hermite normal form.

        Where the first k coordinates are 0 the next ones are an ideal; the index is the product of the four.
        """
        n, table = self.n, rows.tolist()
        blocks = ([row[k : k + n] for row in table[k : k + n]] for k in range(0, self.size, n))
        ideals = (self.integers.ideal(flint.fmpq_mat(block)) for block in blocks)
        return math.prod(ideals, start=self.integers.one)

    def reduced_discriminant(self, rows: flint.fmpq_mat) -> Ideal:
        """Return the reduced discriminant of an order, 4ab for ⟨1, I, J, IJ⟩."""
        return self.integers.principal(4 * self.a * self.b) * self.volume(rows)

    def pseudo_basis(self, rows: flint.fmpq_mat) -> PseudoBasis:
        """Return ideals and quaternions."""
        return tuple(
            (tuple(map(self.integers.outside, ideal)), self.quaternion(row))
            for ideal, row in pseudo_basis(self.field, rows)
        )


def _multiple(field: NumberField, x: FieldElement) -> int:
    """Return a positive integer m for which m·x is an integer of the field."""
    return math.lcm(*(int(c.q) for c in coordinate_rows(field, [x]).entries()))
