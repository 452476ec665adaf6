"""Coordinates of a quaternion algebra over a number field K, of degree n over ℚ: 4n rational numbers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import flint

from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.quadratic.as_number_field import (
    as_number_field,
    from_number_field,
    into_number_field,
)
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.ring import NumberField
from hfield.lattices.dedekind_modules import pseudo_basis
from hfield.product import Constants, Scalar
from hfield.structure.forms import NormalForm, normal_form

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.lattices.dedekind_modules import PseudoBasis


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
        self.start = flint.fmpq_mat(
            self.size, self.size, [int(i == j) for i in range(self.size) for j in range(self.size)]
        )
        self._right = [self._by_right(u, w) for u in range(4) for w in self.omega]

    def _by_right(self, unit: int, w: FieldElement) -> flint.fmpq_mat:
        """Return the matrix of the multiplication by w·unit from the right."""
        a, b, n = self.a, self.b, self.n
        # unit·unit' = factor·unit″, for rows e, I, J, IJ and columns alike
        table = (
            ((0, 1), (1, 1), (2, 1), (3, 1)),
            ((1, 1), (0, a), (3, 1), (2, a)),
            ((2, 1), (3, -1), (0, b), (1, -b)),
            ((3, 1), (2, -a), (1, b), (0, -a * b)),
        )
        out = [flint.fmpq(0)] * self.size**2
        for left in range(4):
            target, factor = table[left][unit]
            block = coordinate_rows(self.field, [v * w * factor for v in self.omega])
            for i in range(n):
                for j in range(n):
                    out[(left * n + i) * self.size + target * n + j] = block[i, j]
        return flint.fmpq_mat(self.size, self.size, out)

    def right(self, row: list[flint.fmpq]) -> flint.fmpq_mat:
        """Return the matrix of the multiplication by an element from the right."""
        total = flint.fmpq_mat(self.size, self.size, [0] * self.size**2)
        for c, matrix in zip(row, self._right, strict=True):
            if c != 0:
                total = total + matrix * c
        return total

    def parts(self, row: list[flint.fmpq]) -> list[FieldElement]:
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
        w, x, y, z = self.parts(row)
        return w * w - self.a * (x * x) - self.b * (y * y - self.a * (z * z))

    def check_ring(self, rows: flint.fmpq_mat) -> None:
        """Check that 1 is in the lattice, and with two elements their product."""
        inverse = rows.inv()
        one = coordinate_rows(self.field, [self.field.one]).entries() + [flint.fmpq(0)] * (
            3 * self.n
        )
        matrices = [flint.fmpq_mat(1, self.size, one) * inverse]
        matrices += [rows * self.right(row) * inverse for row in rows.tolist()]
        if any(c.q != 1 for m in matrices for c in m.entries()):
            raise AssertionError("an order is closed under multiplication")

    def gram_determinant(self, rows: flint.fmpq_mat) -> flint.fmpq:
        """Return the determinant of the form tr(x·conj(y)), traced down to ℚ, on a lattice."""
        n, out = self.n, [flint.fmpq(0)] * self.size**2
        for unit, factor in enumerate(
            (self.field(2), -2 * self.a, -2 * self.b, 2 * self.a * self.b)
        ):
            for i, v in enumerate(self.omega):
                for j, w in enumerate(self.omega):
                    out[(unit * n + i) * self.size + unit * n + j] = (factor * v * w).trace()
        return flint.fmpq_mat(self.size, self.size, out).det() * rows.det() ** 2

    def pseudo_basis(self, rows: flint.fmpq_mat) -> PseudoBasis:
        """Return ideals and quaternions."""
        return tuple(
            (tuple(map(self._outside, ideal)), self.quaternion(row))
            for ideal, row in pseudo_basis(self.field, rows)
        )


def _multiple(field: NumberField, x: FieldElement) -> int:
    """Return a positive integer m for which m·x is an integer of the field."""
    return math.lcm(*(int(c.q) for c in coordinate_rows(field, [x]).entries()))
