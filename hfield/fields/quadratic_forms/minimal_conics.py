"""Quadratic forms in three variables, minimised at a place of ℚ or of k(t).

At the place a lattice is enlarged, and the form on it scaled, until the half-discriminant is a unit there.
This fails exactly if the form has no zero over the completion, that is, if the algebra ramifies. Nothing
depends on the characteristic of the field or of the residue field.

The form of an algebra is ``w² + t·wx − a·x² − b·y²``, the norm on ⟨e, i, j⟩; it has a zero exactly if the
algebra splits.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic, TypeAlias

from hfield.core.product import Constants
from hfield.fields.base.ring import E, Ring
from hfield.fields.linear_algebra.vectors import dot

if TYPE_CHECKING:
    from hfield.fields.base.finite_places import FinitePlace


Vector: TypeAlias = list[E]
Form: TypeAlias = tuple[E, E, E, E, E, E]
"""The coefficients of x², y², z², yz, xz, xy."""


@dataclass
class ConicLattice(Generic[E]):
    """A basis of a lattice in k(t)³, and the scale by which the form is multiplied."""

    basis: list[Vector[E]]
    scale: E


class Conic(Generic[E]):
    """A nondegenerate quadratic form in three variables over a field with the given 0 and 1."""

    def __init__(self, form: Form[E], zero: E, one: E) -> None:
        self.form, self.zero, self.one = form, zero, one

    def value(self, v: Vector[E]) -> E:
        """Return f(v)."""
        return dot(v, self._half(v))

    def coefficients(self, lattice: ConicLattice[E]) -> Form[E]:
        """Return the coefficients of the scaled form in the basis."""
        s, basis = lattice.scale, lattice.basis
        halves = [self._half(v) for v in basis]
        f, g, h = (s * dot(v, half) for v, half in zip(basis, halves, strict=True))
        p, q, r = (
            s * (dot(basis[m], halves[n]) + dot(basis[n], halves[m]))
            for m, n in ((1, 2), (0, 2), (0, 1))
        )
        return f, g, h, p, q, r

    def _half(self, v: Vector[E]) -> Vector[E]:
        """Return a vector, linear in v, whose product with v is f(v)."""
        x, y, z = v
        a, b, c, r, s, t = self.form
        return [a * x + t * y + s * z, b * y + r * z, c * z]

    def start(self) -> ConicLattice[E]:
        """Return the standard lattice."""
        o, e = self.zero, self.one
        return ConicLattice([[e, o, o], [o, e, o], [o, o, e]], e)


def norm_form(field: Ring[E], c: Constants[E]) -> Form[E]:
    """Return the norm form of an algebra on ⟨e, i, j⟩."""
    o, (a, t, b) = field.zero, c
    return field.one, -a, -b, o, o, t


def half_discriminant(form: Form[E]) -> E:
    """Return half the determinant of the bilinear form; in this form it is also defined in
    characteristic 2.
    """
    a, b, c, r, s, t = form
    four = a * b * c
    four = four + four
    return four + four + r * s * t - a * (r * r) - b * (s * s) - c * (t * t)


def minimise(conic: Conic[E], lattice: ConicLattice[E], place: FinitePlace) -> bool:
    """Change the lattice at a place until the half-discriminant is a unit there; return True.

    If the place is ramified, this is impossible: then the half-discriminant ends with valuation 1, and False
    is returned.
    """
    pi = place.uniformiser
    inverse = place.inverse_uniformiser
    worst = min(place.valuation(f) for f in conic.coefficients(lattice) if f != conic.zero)
    for _ in range(abs(worst)):
        lattice.scale = lattice.scale * (pi if worst < 0 else inverse)
    while True:
        form = conic.coefficients(lattice)
        if place.valuation(half_discriminant(form)) == 0:
            return True
        radical = _radical(place, [place.reduce(f) for f in form])
        vectors = adapt(lattice.basis, place, radical)
        if len(vectors) == 1:
            size = conic.value(lattice.basis[vectors[0]]) * lattice.scale
            if size == conic.zero or place.valuation(size) >= 2:
                lattice.basis[vectors[0]] = [inverse * x for x in lattice.basis[vectors[0]]]
                continue
            line = _split_complement(conic, lattice, place, vectors[0])
            if line is None:
                return False
            vectors = line
        for index in range(3):
            if index not in vectors:
                lattice.basis[index] = [pi * x for x in lattice.basis[index]]
        lattice.scale = lattice.scale * inverse


def _radical(kappa: FinitePlace, form: Vector) -> list[Vector]:
    """Return a basis of the vectors r with f(r) = 0 and f(r, ·) = 0 over the residue field."""
    a, b, c, r, s, t = form
    if all(x == 0 for x in form):
        return [[kappa.one if i == j else kappa.zero for j in range(3)] for i in range(3)]
    if kappa.even:
        if r != 0 or s != 0 or t != 0:
            return [[r, s, t]]
        lines = [kappa.sqrt(x) for x in (a, b, c)]
        return kernel_at(kappa, [lines], 3)
    return kernel_at(kappa, [[a + a, t, s], [t, b + b, r], [s, r, c + c]], 3)


def kernel_at(kappa: FinitePlace, rows: list[Vector], columns: int) -> list[Vector]:
    """Return a basis of the kernel of a matrix over the residue field."""
    rows = [[x % kappa.modulus for x in row] for row in rows]
    pivots: dict[int, Vector] = {}
    for column in range(columns):
        row = next((r for r in rows if r[column] != 0), None)
        if row is None:
            continue
        inverse = kappa.inverse(row[column])
        row[:] = [kappa.multiply(inverse, x) for x in row]
        rows = [r for r in rows if r is not row]
        for other in [*rows, *pivots.values()]:
            factor = other[column]
            other[:] = [(x - factor * y) % kappa.modulus for x, y in zip(other, row, strict=True)]
        pivots[column] = row
    basis = []
    for free in range(columns):
        if free not in pivots:
            v = [kappa.zero] * columns
            v[free] = kappa.one
            for column, row in pivots.items():
                v[column] = kappa.zero - row[free]
            basis.append(v)
    return basis


def adapt(basis: list[Vector], kappa: FinitePlace, vectors: list[Vector]) -> list[int]:
    """Change a basis so that it contains lifts of the given vectors; return their indices."""
    indices: list[int] = []
    vectors = [list(v) for v in vectors]
    for v in vectors:
        index = next(i for i in range(len(v)) if v[i] != 0 and i not in indices)
        inverse = kappa.inverse(v[index])
        v[:] = [kappa.multiply(inverse, x) for x in v]
        for other in vectors:
            if other is not v:
                factor = other[index]
                other[:] = [(x - factor * y) % kappa.modulus for x, y in zip(other, v, strict=True)]
        indices.append(index)
    old = [list(v) for v in basis]
    for index, v in zip(indices, vectors, strict=True):
        basis[index] = _combination([kappa.lift(x) for x in v], old)
    return indices


def _combination(scalars: Vector, basis: list[Vector]) -> Vector:
    columns = (
        [s * x for s, x in zip(scalars, row, strict=True)] for row in zip(*basis, strict=True)
    )
    return [sum(column[1:], column[0]) for column in columns]


def _split_complement(
    conic: Conic[E], lattice: ConicLattice[E], kappa: FinitePlace, vertex: int
) -> list[int] | None:
    """Find a line on the form modulo p through its vertex; return the indices of both vectors."""
    form = conic.coefficients(lattice)
    i, j = (n for n in range(3) if n != vertex)
    pair = form[{(1, 2): 3, (0, 2): 4, (0, 1): 5}[i, j]]
    root = kappa.quadratic_root(*(kappa.reduce(f) for f in (form[i], pair, form[j])))
    if root is None:
        return None
    v = [kappa.zero] * 3
    v[i], v[j] = root
    return [vertex, *adapt(lattice.basis, kappa, [v])]
