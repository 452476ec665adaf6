"""Conics over a rational function field k(t): minimise at every place, reduce at infinity, solve over k.

The form of an algebra is ``w² + t·wx − a·x² − b·y²``, the norm on ⟨e, i, j⟩; it has a zero exactly when
the algebra splits. At each place a lattice is enlarged until f on it, scaled, has unit half-discriminant; a
place where this fails is a ramified one. What is left is a form without bad places on a vector
bundle of rank 3 over the projective line, and such a bundle is a sum of line bundles: either
some vector has too small a degree for f to be anything but 0 there, or f has constant
coefficients. Nothing here depends on the characteristic. (For odd characteristic compare Cremona and van
Hoeij, "Trivial points on conics over function fields", J. Théor. Nombres Bordeaux 18 (2006).)
"""

from dataclasses import dataclass
from typing import Any

from hfield.product import Constants
from hfield.structure.residue import ResidueField

Vector = list[Any]
Form = tuple[Any, Any, Any, Any, Any, Any]
"""The coefficients of x², y², z², yz, xz, xy."""


class RamifiedError(ArithmeticError):
    """Raised inside this room when a place turns out to be ramified."""

    def __init__(self, place: Any) -> None:
        super().__init__(str(place))
        self.place = place


@dataclass
class Lattice:
    """A basis of a lattice in k(t)³ and the scale by which the form is multiplied."""

    basis: list[Vector]
    scale: Any


class Conic:
    """A nondegenerate quadratic form in three variables over the function field ``field``."""

    def __init__(self, field: Any, form: Form) -> None:
        self.field, self.form = field, form

    def value(self, v: Vector) -> Any:
        """Return f(v)."""
        x, y, z = v
        a, b, c, r, s, t = self.form
        return a * (x * x) + b * (y * y) + c * (z * z) + r * (y * z) + s * (x * z) + t * (x * y)

    def coefficients(self, lattice: Lattice) -> Form:
        """Return the coefficients of the scaled form on the basis."""
        u, v, w = lattice.basis
        s = lattice.scale
        f, g, h = self.value(u), self.value(v), self.value(w)
        return (
            s * f,
            s * g,
            s * h,
            *(s * p for p in (self._pair(v, w), self._pair(u, w), self._pair(u, v))),
        )

    def _pair(self, u: Vector, v: Vector) -> Any:
        total = [x + y for x, y in zip(u, v, strict=True)]
        return self.value(total) - self.value(u) - self.value(v)

    def start(self) -> Lattice:
        """Return the standard lattice."""
        o, e = self.field.zero, self.field.one
        return Lattice([[e, o, o], [o, e, o], [o, o, e]], e)

    def bad_primes(self) -> list[Any]:
        """Return the monic irreducible polynomials at which the standard lattice may not be good."""
        found: dict[Any, Any] = {}
        for x in (*(f.den for f in self.form), half_discriminant(self.form).num):
            for p, _ in x.factor()[1]:
                monic = self.field.quotient(self.field.one.num, p).den
                found[str(monic)] = monic
        return list(found.values())


def norm_form(field: Any, c: Constants) -> Form:
    """Return the norm form of an algebra on ⟨e, i, j⟩."""
    o, (a, t, b) = field.zero, c
    return field.one, -a, -b, o, o, t


def valuation(x: Any, p: Any) -> int:
    """Return the order of a nonzero rational function at the irreducible polynomial p."""
    if x.num % p == 0:
        return _order(x.num, p)
    return -_order(x.den, p)


def _order(poly: Any, p: Any) -> int:
    n = 0
    while True:
        quotient, rest = divmod(poly, p)
        if rest != 0:
            return n
        poly, n = quotient, n + 1


def half_discriminant(form: Form) -> Any:
    """Return half the determinant of the bilinear form, which makes sense in characteristic 2."""
    a, b, c, r, s, t = form
    four = a * b * c
    four = four + four
    return four + four + r * s * t - a * (r * r) - b * (s * s) - c * (t * t)


def minimise(conic: Conic, lattice: Lattice, p: Any) -> None:
    """Change the lattice at p until the half-discriminant is a unit there.

    Raises :class:`RamifiedError` when that is impossible.
    """
    field = conic.field
    kappa = ResidueField(field, p)
    pi = field.quotient(p, field.one.num)
    worst = min(valuation(f, p) for f in conic.coefficients(lattice) if f.num != 0)
    lattice.scale = lattice.scale * field.power(pi, -worst)
    while True:
        form = conic.coefficients(lattice)
        if valuation(half_discriminant(form), p) == 0:
            return
        radical = _radical(kappa, [kappa.reduce(f) for f in form])
        vectors = _adapt(conic, lattice, kappa, radical)
        if len(vectors) == 1:
            if valuation_at_least(conic.value(lattice.basis[vectors[0]]) * lattice.scale, p, 2):
                inverse = field.inverse(pi)
                lattice.basis[vectors[0]] = [inverse * x for x in lattice.basis[vectors[0]]]
                continue
            vectors = _split_complement(conic, lattice, kappa, vectors[0])
        for index in range(3):
            if index not in vectors:
                lattice.basis[index] = [pi * x for x in lattice.basis[index]]
        lattice.scale = lattice.scale * field.inverse(pi)


def valuation_at_least(x: Any, p: Any, n: int) -> bool:
    """Tell whether pⁿ divides x (0 is divisible by everything)."""
    return bool(x.num == 0) or valuation(x, p) >= n


def _radical(kappa: ResidueField, form: list[Any]) -> list[Vector]:
    """Return a basis of the vectors r with f(r) = 0 and f(r, ·) = 0 over the residue field."""
    a, b, c, r, s, t = form
    if all(x == 0 for x in form):
        return [[kappa.one if i == j else kappa.zero for j in range(3)] for i in range(3)]
    if kappa.base.characteristic == 2:
        if r != 0 or s != 0 or t != 0:
            return [[r, s, t]]
        lines = [kappa.sqrt(x) for x in (a, b, c)]
        return _kernel(kappa, [lines])
    return _kernel(kappa, [[a + a, t, s], [t, b + b, r], [s, r, c + c]])


def _kernel(kappa: ResidueField, rows: list[Vector]) -> list[Vector]:
    """Return a basis of the kernel of a matrix with three columns over the residue field."""
    rows = [[x % kappa.modulus for x in row] for row in rows]
    pivots: dict[int, Vector] = {}
    for column in range(3):
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
    for free in range(3):
        if free not in pivots:
            v = [kappa.zero] * 3
            v[free] = kappa.one
            for column, row in pivots.items():
                v[column] = kappa.zero - row[free]
            basis.append(v)
    return basis


def _adapt(conic: Conic, lattice: Lattice, kappa: ResidueField, vectors: list[Vector]) -> list[int]:
    """Change the basis so that lifts of the given vectors are in it; return their places."""
    indices: list[int] = []
    vectors = [list(v) for v in vectors]
    for v in vectors:
        index = next(i for i in range(3) if v[i] != 0 and i not in indices)
        inverse = kappa.inverse(v[index])
        v[:] = [kappa.multiply(inverse, x) for x in v]
        for other in vectors:
            if other is not v:
                factor = other[index]
                other[:] = [(x - factor * y) % kappa.modulus for x, y in zip(other, v, strict=True)]
        indices.append(index)
    old = [list(v) for v in lattice.basis]
    for index, v in zip(indices, vectors, strict=True):
        lattice.basis[index] = _combination(conic, v, old)
    return indices


def _combination(conic: Conic, coefficients: Vector, basis: list[Vector]) -> Vector:
    one = conic.field.one.num
    scalars = [conic.field.quotient(x, one) for x in coefficients]
    columns = ([s * v[i] for s, v in zip(scalars, basis, strict=True)] for i in range(3))
    return [sum(column[1:], column[0]) for column in columns]


def _split_complement(
    conic: Conic, lattice: Lattice, kappa: ResidueField, vertex: int
) -> list[int]:
    """Find a line of the form modulo p through its vertex; return the places of both vectors."""
    form = conic.coefficients(lattice)
    i, j = (n for n in range(3) if n != vertex)
    pair = form[{(1, 2): 3, (0, 2): 4, (0, 1): 5}[i, j]]
    root = kappa.quadratic_root(*(kappa.reduce(f) for f in (form[i], pair, form[j])))
    if root is None:
        raise RamifiedError(kappa.modulus)
    v = [kappa.zero] * 3
    v[i], v[j] = root
    return [vertex, *_adapt(conic, lattice, kappa, [v])]
