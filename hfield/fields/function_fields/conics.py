"""Conics over k(t): minimise at every place, reduce at infinity, solve over k.

A form that is minimal everywhere lives on a vector bundle of rank 3 over the projective line without bad
places. Such a bundle is a sum of line bundles. Therefore either some vector has such a small degree that the
form is 0 on it, or the form has constant coefficients. (For odd characteristic compare Cremona and van Hoeij,
"Trivial points on conics over function fields", J. Théor. Nombres Bordeaux 18 (2006).)
"""

from __future__ import annotations

import itertools
from fractions import Fraction
from typing import TYPE_CHECKING

from hfield.core.product import Constants
from hfield.errors import UndecidedError
from hfield.fields.function_fields.places import FunctionPlace, prime_divisors
from hfield.fields.function_fields.residues import ResidueField, residues_at
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.linear_algebra.kernels import kernel
from hfield.fields.quadratic_forms.minimal_conics import (
    Conic,
    ConicLattice,
    Form,
    Vector,
    half_discriminant,
    minimise,
    norm_form,
)
from hfield.fields.rationals.conics import diagonalise, solve_conic
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.fields.rationals.whole_numbers import fraction

if TYPE_CHECKING:
    import flint

    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.fields.function_fields.ring import FunctionField


class RamifiedError(ArithmeticError):
    """Raised inside this module when places turn out to be ramified."""

    def __init__(self, *places: object) -> None:
        super().__init__(", ".join(map(str, places)))
        self.places = places


def solve_conic_functions(
    field: FunctionField, c: Constants
) -> tuple[RationalFunction, RationalFunction, RationalFunction]:
    """Return ``(w, x, y)`` ≠ 0 in k(t) with ``w² + t·wx − a·x² − b·y² = 0``.

    Raises :class:`RamifiedError` with a place if there is none; over ℚ(x) they may be the places of ℚ where a
    constant conic has no point.
    """
    form = norm_form(field, c)
    conic = Conic(form, field.zero, field.one)
    lattice = conic.start()
    # elsewhere the standard lattice is good
    bad = prime_divisors(field, (*(f.den for f in form), half_discriminant(form).num))
    for place in bad:
        if not minimise(conic, lattice, residues_at(place)):
            raise RamifiedError(place)
    basis = _reduce(field, lattice.basis, _at_infinity(field, conic))
    for v in basis:
        if conic.value(v).num == 0:
            return v[0], v[1], v[2]
    if field.base.order is None:
        constants = _specialised_zero(field, form, basis)
    else:
        constants = _constant_zero(field, conic.coefficients(ConicLattice(basis, lattice.scale)))
    scaled = [[s * x for x in v] for s, v in zip(constants, basis, strict=True)]
    x, y, z = (sum(column[1:], column[0]) for column in zip(*scaled, strict=True))
    return x, y, z


def _at_infinity(field: FunctionField, conic: Conic) -> list[Vector]:
    """Return a basis of a lattice at infinity on which the form is minimal."""
    lattice, place = conic.start(), FunctionPlace(field)
    if not minimise(conic, lattice, residues_at(place)):
        raise RamifiedError(place)
    return lattice.basis


def _reduce(field: FunctionField, basis: list[Vector], local: list[Vector]) -> list[Vector]:
    """Reduce a basis over k[t] with respect to the degree that a lattice at infinity defines."""
    vectors = [list(v) for v in basis]
    inverse = _inverse(field, local)
    kappa = ResidueField(field, field.gen.num)
    while True:
        images = [_apply(inverse, v) for v in vectors]
        degrees = [max(_degree(x) for x in image) for image in images]
        leading = [
            [
                field.base(x.num.leading_coefficient()) if _degree(x) == n else field.base.zero
                for x in image
            ]
            for image, n in zip(images, degrees, strict=True)
        ]
        relations = kernel(field.base, [list(row) for row in zip(*leading, strict=True)], 3)
        if not relations:
            return vectors
        relation = [kappa.scalar(x) for x in relations[0]]
        top = max((i for i in range(3) if relation[i] != 0), key=lambda i: degrees[i])
        combined = [field.zero] * 3
        for i in range(3):
            if relation[i] != 0:
                factor = field.constant(relations[0][i]) * field.power(
                    field.gen, degrees[top] - degrees[i]
                )
                combined = [x + factor * y for x, y in zip(combined, vectors[i], strict=True)]
        vectors[top] = combined


def _degree(x: RationalFunction) -> int:
    """Return the degree of a rational function; a very small number for 0."""
    return int(x.num.degree()) - int(x.den.degree()) if x.num != 0 else -(10**9)


def _apply(rows: list[Vector], v: Vector) -> Vector:
    return [row[0] * v[0] + row[1] * v[1] + row[2] * v[2] for row in rows]


def _inverse(field: FunctionField, columns: list[Vector]) -> list[Vector]:
    """Return the rows of the inverse of the matrix with the given columns, by cofactors."""
    u, v, w = columns
    rows = [_cross(v, w), _cross(w, u), _cross(u, v)]
    scale = field.inverse(rows[0][0] * u[0] + rows[0][1] * u[1] + rows[0][2] * u[2])
    return [[scale * x for x in row] for row in rows]


def _cross(u: Vector, v: Vector) -> Vector:
    return [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]


def _constant_zero(
    field: FunctionField, form: tuple[RationalFunction, ...]
) -> list[RationalFunction]:
    """Return a zero in k³, as constants of k(t), of a nondegenerate form with coefficients in a finite k."""
    base = field.base
    a, b, c, r, s, t = (base(f.num[0]) for f in form)
    kappa = ResidueField(field, field.gen.num)
    # on the line through (0, 0, 1) and (1, x, 0): about half of these lines contain a zero
    for x in base.elements():
        p = a + b * (x * x) + t * x
        q = s + r * x
        root = kappa.quadratic_root(*(kappa.scalar(f) for f in (p, q, c)))
        if root is not None:
            u, v = (field.quotient(f, field.one.num) for f in root)
            return [u, u * field.constant(x), v]
    raise UndecidedError(f"a conic over {base.name} without a point was met")


def _specialised_zero(
    field: FunctionField, form: Form, basis: list[Vector]
) -> list[RationalFunction]:
    """Return coefficients in ℚ of a zero in a basis in which the form is constant up to scale.

    The form is the same at every point of the line. So a zero at a point with small values, where it is easy
    to find, is a zero everywhere. Raises :class:`RamifiedError` if there is none.
    """
    for n in itertools.count():
        point = field.base((n + 1) // 2 * (-1) ** n)
        if any(x.den(point) == 0 for v in [form, *basis] for x in v):
            continue
        a, b, c, r, s, t = (fraction(_at(x, point)) for x in form)
        special = (a, b, c, r, s, t)
        matrix = [[field.constant(_at(x, point)) for x in v] for v in basis]
        determinant = sum(
            (x * y for x, y in zip(_cross(matrix[1], matrix[2]), matrix[0], strict=True)),
            field.zero,
        )
        if half_discriminant(special) and not field.is_zero(determinant):
            target = [field(x) for x in _rational_zero(special)]
            return _apply(_inverse(field, matrix), target)
    raise AssertionError("all but finitely many points are good")


def _rational_zero(form: Form) -> list[Fraction]:
    """Return a rational zero of a nondegenerate form. Raises :class:`RamifiedError` if there is none."""
    a, b, c, r, s, t = form
    gram = [[a, t / 2, s / 2], [t / 2, b, r / 2], [s / 2, r / 2, c]]
    (p, q, n), rows = diagonalise(gram)
    places = ramified_places_q(-p / n, -q / n)
    if places:
        raise RamifiedError(*places)
    zero = solve_conic(-p / n, -q / n)
    return [
        sum((x * row[i] for x, row in zip(zero, rows, strict=True)), Fraction(0)) for i in range(3)
    ]


def _at(x: RationalFunction, point: flint.fmpq) -> flint.fmpq:
    """Return the value of a rational function at a point that is not a pole."""
    return x.num(point) / x.den(point)
