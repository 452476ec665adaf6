"""Isometries of the pure quaternions of two isomorphic algebras over a number field, by lattice reduction.

Let A₀ and B₀ be the quaternions of trace 0. An isometry between them is the graph of a totally isotropic
subspace of A₀ ⊥ −B₀, and on this space the difference of the norms is hyperbolic at every place. (In division
algebras all such subspaces are graphs, because only 0 has norm 0 in A₀ or B₀.) On some module this form is
even and unimodular. To find it, the standard lattice is enlarged at each prime ideal by vectors v/π with
Q(v/π) integral, v in the radical modulo the prime, until the lattice is maximal; then it is unimodular, also
above 2. A walk through reduced bases of the module finds a zero u, a second walk finds a zero in u⊥/u, and
the third zero requires only a square root. So only the norms of the constants are factored, and the images
are about as long as the constants.

Over ℚ, a number field of degree 1, a shortest vector of the module is a zero. The least value of the definite
form with the absolute values of the coefficients is at most γ₆/2 < 1, where γ₆ = (64/3)^(1/6) is Hermite's
constant; it bounds the absolute value of the form there, and the form is integral. The same holds on u⊥/u,
where γ₄/2 < 1.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Sequence
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.product import Constants, Coordinates
from hfield.fields.linear_algebra.kernels import kernel
from hfield.fields.linear_algebra.lattice_reduction import combination
from hfield.fields.linear_algebra.vectors import dot
from hfield.fields.number_fields.conics import module_basis
from hfield.fields.number_fields.elements import coefficients
from hfield.fields.number_fields.integral_basis import integral_multiple
from hfield.fields.number_fields.prime_ideals import primes_above
from hfield.fields.number_fields.residues import LocalPlace, local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates
from hfield.fields.number_fields.zeros_of_forms import ZeroSearch, expect_small_degree, not_met
from hfield.fields.quadratic_forms.minimal_conics import Vector, kernel_at

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Polynomial
    from hfield.fields.number_fields.elements import FieldElement


def isometry(
    field: NumberField, source: Vector, target: Vector, primes: Iterable[int]
) -> list[Vector]:
    """Return the rows of an isometry between diagonal ternary forms over K.

    Row n is the image of the n-th basis vector of the source. The forms have integral coefficients, units
    outside ``primes``, which include 2, and are isometric. Raises :class:`UndecidedError` if no isometry was
    found.
    """
    none = f"two algebras over {field.name} are isomorphic, but no isomorphism"
    expect_small_degree(field, none)
    form = [*source, *(-g for g in target)]
    basis = unimodular_module(field, form, primes)
    for u in ZeroSearch(field, form, basis).zeros():
        for v in ZeroSearch(field, form, _complement(field, form, basis, u), u).zeros():
            for w in _last(field, form, u, v):
                found = _graph(field, [u, v, w])
                if found is not None:
                    return found
    raise not_met(none)


def _complement(field: NumberField, form: Vector, basis: list[Vector], u: Vector) -> list[Vector]:
    """Return vectors orthogonal to u that form, modulo u, a basis over ℤ of the orthogonal part of the
    module.

    They are determined by four coordinates: the i-th is made 0 by subtracting a multiple of u, and the j-th
    follows.
    """
    n = field.degree
    weights = [f * x for f, x in zip(form, u, strict=True)]
    rows = [coefficients(_value(form, u, v)) for v in basis]
    below = math.lcm(*(int(c.q) for row in rows for c in row))
    unit = [[int(i == j) for j in range(len(basis))] for i in range(len(basis))]
    conditions = [[(c * below).p for c in row] + e for row, e in zip(rows, unit, strict=True)]
    inside = [r[n:] for r in flint.fmpz_mat(conditions).hnf().tolist() if not any(r[:n])]
    i, j = [k for k, x in enumerate(u) if x][:2]
    scale, rest = u[i].inverse(), [k for k in range(len(u)) if k not in (i, j)]
    short = []
    for row in inside:
        v = combination([int(c) for c in row], basis)
        factor = v[i] * scale
        short.append([v[k] - factor * u[k] for k in rest])
    back, out = -weights[j].inverse(), []
    for v in module_basis(field, short):
        wide = [field.zero] * len(u)
        for k, x in zip(rest, v, strict=True):
            wide[k] = x
        wide[j] = back * dot([weights[k] for k in rest], v)
        out.append(wide)
    return out


def _last(field: NumberField, form: Vector, u: Vector, v: Vector) -> Iterator[Vector]:
    """Yield the two isotropic vectors orthogonal to u and v, up to factors and modulo u and v."""
    i, j = next(
        (i, j) for i, j in itertools.combinations(range(len(u)), 2) if u[i] * v[j] - u[j] * v[i]
    )
    rows = [[f * x for f, x in zip(form, w, strict=True)] for w in (u, v)]
    rows += [[field.one if k == m else field.zero for k in range(len(u))] for m in (i, j)]
    g, h = kernel(field, rows, len(u))  # a complement of u and v in their orthogonal space
    f, mixed, last = (_value(form, x, y) for x, y in ((g, g), (g, h), (h, h)))
    if not f:
        pairs = [(field.one, field.zero), (last, mixed * -2)]
    else:
        root = field.sqrt(mixed * mixed - f * last)
        assert root is not None, "a hyperbolic plane is left"
        pairs = [(root - mixed, f), (-root - mixed, f)]
    for x, y in pairs:
        yield [x * s + y * t for s, t in zip(g, h, strict=True)]


def _graph(field: NumberField, isotropic: list[Vector]) -> list[Vector] | None:
    """Return the matrix whose graph is the space, or None if the space is not a graph."""
    columns = kernel(field, [[*w[:3], *(-x for x in w[3:])] for w in isotropic], 6)
    if any(v[3:].count(field.zero) < 2 for v in columns):
        return None
    return [[v[n] for v in columns] for n in range(3)]


def unimodular_module(field: NumberField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a module in Kⁿ on which a diagonal form is unimodular at each prime ideal.

    The coefficients are integers of the field, and units outside ``primes``, which include 2. The form must
    be hyperbolic in each completion.
    """
    n = len(form)
    standard = [[field.one if i == j else field.zero for j in range(n)] for i in range(n)]
    rows = list(standard)
    for p in primes:
        for prime in primes_above(field, p):
            rows += _enlarged(form, local_place(prime))
    return module_basis(field, rows)


def _enlarged(form: Vector, place: LocalPlace) -> list[Vector]:
    """Return vectors that enlarge the standard lattice to a maximal one at a place; they are integral
    elsewhere.

    If 2 is a unit, the coefficients that are units span a unimodular part, which cannot be enlarged.
    """
    valuations = [place.valuation(f) for f in form]
    chosen = [i for i, m in enumerate(valuations) if place.even or m]
    zero, n = form[0] * 0, len(chosen)
    units = [place.inverse_uniformiser ** (valuations[i] // 2) for i in chosen]
    basis = [
        [x if i == j else zero for j in range(len(form))]
        for i, x in zip(chosen, units, strict=True)
    ]
    gram = [
        [form[i] * x * x if i == j else zero for j in chosen]
        for i, x in zip(chosen, units, strict=True)
    ]
    enlarged = {k for k, i in enumerate(chosen) if valuations[i] > 1}
    while True:
        modulo = [[place.zero] * n for _ in range(n)]
        for i, j in itertools.combinations_with_replacement(range(n), 2):
            modulo[i][j] = modulo[j][i] = place.reduce(gram[i][j] * 2)
        radical = kernel_at(place, modulo, n)
        if not radical:
            return [basis[i] for i in enlarged]
        v = _singular(gram, place, radical)
        at = next(i for i, x in enumerate(v) if x != 0)
        unit = place.inverse(v[at])
        v = [place.lift(place.multiply(unit, x)) * place.inverse_uniformiser for x in v]
        basis[at], row = _combination(v, basis), _combination(v, gram)
        for j in range(n):
            gram[at][j] = gram[j][at] = row[j]
        gram[at][at] = dot(v, row)
        enlarged.add(at)


def _combination(scalars: Vector, rows: list[Vector]) -> Vector:
    """Return a linear combination of rows; rows with scalar 0 are skipped."""
    terms = [[c * x for x in row] for c, row in zip(scalars, rows, strict=True) if c]
    return [sum(column[1:], column[0]) for column in zip(*terms, strict=True)]


def _value(form: Vector, u: Vector, v: Vector) -> FieldElement:
    """Return half of Q(u + v) − Q(u) − Q(v), which equals Q(u) for u = v."""
    value: FieldElement = dot([f * x for f, x in zip(form, u, strict=True)], v)
    return value


def _singular(gram: list[Vector], place: LocalPlace, radical: list[Vector]) -> Vector:
    """Return a v in the radical modulo the prime with Q(v) in P², whichever number lifts it."""
    lifted = [[place.lift(x) for x in v] for v in radical]
    if place.even:  # on the radical Q is additive modulo P
        values = [dot(v, _combination(v, gram)) for v in lifted]
        roots = [place.sqrt(place.reduce(x)) for x in values]
        radical = [_residues(place, c, radical) for c in kernel_at(place, [roots], len(roots))]
        lifted = [[place.lift(x) for x in v] for v in radical]
    inverse, images = place.inverse_uniformiser, [_combination(v, gram) for v in lifted]
    values = [[dot(v, image) * inverse for image in images] for v in lifted]
    squares = [place.reduce(values[i][i]) for i in range(len(lifted))]
    mixed = [[place.reduce(x * 2) for x in row] for row in values]
    return _residues(place, _zero(place, squares, mixed), radical)


def _residues(place: LocalPlace, scalars: Vector, vectors: list[Vector]) -> Vector:
    """Return a combination of vectors over the residue field."""
    columns = zip(*vectors, strict=True)
    return [dot(scalars, column) % place.modulus for column in columns]


def _zero(place: LocalPlace, squares: Vector, mixed: list[Vector]) -> Vector:
    """Return a zero modulo the prime of ``Σ squares[i]·xᵢ² + Σ mixed[i][j]·xᵢxⱼ``, i < j."""
    n, rng = len(squares), Random(1)

    def value(x: Vector) -> Polynomial:
        terms = [a * s % place.modulus * s for a, s in zip(squares, x, strict=True)]
        terms += [
            mixed[i][j] * x[i] % place.modulus * x[j]
            for i, j in itertools.combinations(range(n), 2)
        ]
        return sum(terms[1:], terms[0]) % place.modulus

    unit = [[place.one if i == j else place.zero for j in range(n)] for i in range(n)]
    for x in unit:
        if value(x) == 0:
            return x
    planes: Iterable[Sequence[Vector]] = itertools.combinations(unit, 2)
    if n > 2:
        more = (
            [[place.random(rng) for _ in range(n)] for _ in range(2)] for _ in itertools.count()
        )
        planes = itertools.chain(planes, more)
    for u, v in planes:
        both = [(s + t) % place.modulus for s, t in zip(u, v, strict=True)]
        f, g = value(u), value(v)
        root = place.quadratic_root(f, (value(both) - f - g) % place.modulus, g)
        if root is not None:
            x = [(root[0] * s + root[1] * t) % place.modulus for s, t in zip(u, v, strict=True)]
            if any(s != 0 for s in x):
                return x
    raise AssertionError("the form is hyperbolic in every completion")


def embed_number_field(
    field: NumberField, outer: Constants, inner: Constants
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in the algebra ``inner`` that satisfy the relations of ``outer``.

    Both are isomorphic, with t = 0. Raises :class:`UnfactoredError`, and :class:`UndecidedError` if no
    isometry was found.
    """
    numbers = [outer.a, outer.b, inner.a, inner.b]
    r, s, x, y = map(integral_multiple, numbers)
    primes = sorted({2}.union(*(candidates(field, u) for u in numbers)))
    (a, b), (p, q) = ((c.a * m * m, c.b * n * n) for c, m, n in ((outer, r, s), (inner, x, y)))
    images = isometry(field, [-a, -b, a * b], [-p, -q, p * q], primes)
    found = [
        (field.zero, u * x * t, v * y * t, w * (x * y) * t)
        for (u, v, w), t in zip(images, (flint.fmpq(1, r), flint.fmpq(1, s)), strict=False)
    ]
    return found[0], found[1]
