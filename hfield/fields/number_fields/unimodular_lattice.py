"""Isometries of the pure quaternions of two isomorphic algebras over a number field, by lattice reduction.

As over ℚ (:mod:`hfield.fields.rationals.embedding`) an isometry is the graph of a totally
isotropic subspace of A₀ ⊥ −B₀, where the difference of the norms is hyperbolic at every place. On some
module it is even and unimodular: at a prime ideal the standard lattice is enlarged by vectors v/π with Q(v/π)
integral, v in the radical modulo the prime, and ends at a maximal lattice, which is unimodular, above 2 as
elsewhere. Zeros are met on a walk through its reduced bases, one of them, u, and another on u⊥/u; the third
is a square root. So nothing is factored but the norms of the constants, and images are about as long.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator
from random import Random
from typing import Any

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
from hfield.fields.number_fields.walk import Walk, expect_small_degree, not_met
from hfield.fields.quadratic_forms.minimal_conics import Vector, adapt, kernel_at


def isometry(
    field: NumberField, source: Vector, target: Vector, primes: Iterable[int]
) -> list[Vector]:
    """Return the rows of a matrix that takes a diagonal form in three variables to another over K.

    Row n holds the image of the n-th basis vector of the source. The forms have integral coefficients, units
    outside ``primes``, which contain 2, and are isometric. Raises :class:`UndecidedError` where none was met.
    """
    none = f"two algebras over {field.name} are isomorphic, but no isomorphism"
    expect_small_degree(field, none)
    form = [*source, *(-g for g in target)]
    basis = unimodular_module(field, form, primes)
    for u in Walk(field, form, basis).zeros():
        for v in Walk(field, form, _complement(field, form, basis, u), u).zeros():
            for w in _last(field, form, u, v):
                found = _graph(field, [u, v, w])
                if found is not None:
                    return found
    raise not_met(none)


def _complement(field: NumberField, form: Vector, basis: list[Vector], u: Vector) -> list[Vector]:
    """Return vectors orthogonal to u that are modulo u a basis over ℤ of what the module has of such.

    They are determined by four coordinates: the i-th is made 0 by a multiple of u, the j-th follows.
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
    """Run through the isotropic vectors orthogonal to u and v: two, up to factors and modulo these."""
    i, j = next(
        (i, j) for i, j in itertools.combinations(range(len(u)), 2) if u[i] * v[j] - u[j] * v[i]
    )
    rows = [[f * x for f, x in zip(form, w, strict=True)] for w in (u, v)]
    rows += [[field.one if k == m else field.zero for k in range(len(u))] for m in (i, j)]
    g, h = kernel(field, rows, len(u))  # a complement of u and v in what is orthogonal to them
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
    """Return the matrix of which a space is the graph, or None if it is none."""
    columns = kernel(field, [[*w[:3], *(-x for x in w[3:])] for w in isotropic], 6)
    if any(v[3:].count(field.zero) < 2 for v in columns):
        return None
    return [[v[n] for v in columns] for n in range(3)]


def unimodular_module(field: NumberField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a module in Kⁿ on which a diagonal form is unimodular at each prime ideal.

    The coefficients are integers of the field, and units outside ``primes``, which contain 2. The form must
    be hyperbolic in each completion.
    """
    n = len(form)
    standard = [[field.one if i == j else field.zero for j in range(n)] for i in range(n)]
    rows = list(standard)
    for p in primes:
        for prime in primes_above(field, p):
            basis = _enlarged(form, standard, local_place(prime))
            rows += [v for v in basis if v not in standard]
    return module_basis(field, rows)


def _enlarged(form: Vector, standard: list[Vector], place: LocalPlace) -> list[Vector]:
    """Return a basis of a maximal lattice at a place; it is integral at all other primes."""
    basis = [list(v) for v in standard]
    while True:
        modulo = [[place.reduce(_value(form, u, v) * 2) for v in basis] for u in basis]
        vectors = kernel_at(place, modulo, len(form))
        if not vectors:
            return basis
        at = _singular(form, basis, place, vectors)
        basis[at] = [x * place.inverse_uniformiser for x in basis[at]]


def _value(form: Vector, u: Vector, v: Vector) -> Any:
    """Return half of Q(u + v) − Q(u) − Q(v), which is Q(u) for u = v."""
    return dot([f * x for f, x in zip(form, u, strict=True)], v)


def _singular(form: Vector, basis: list[Vector], place: LocalPlace, radical: list[Vector]) -> int:
    """Change the basis so that in it is a v of the radical with Q(v) in P²; return its index."""
    at = adapt(basis, place, radical)
    if place.even:  # on the radical Q is additive modulo P
        roots = [place.sqrt(place.reduce(_value(form, basis[i], basis[i]))) for i in at]
        at = _within(basis, place, at, kernel_at(place, [roots], len(at)))
    inverse, inside = place.inverse_uniformiser, [basis[i] for i in at]
    squares = [place.reduce(_value(form, v, v) * inverse) for v in inside]
    mixed = [[place.reduce(_value(form, u, v) * 2 * inverse) for v in inside] for u in inside]
    return _within(basis, place, at, [_zero(place, squares, mixed)])[0]


def _within(
    basis: list[Vector], place: LocalPlace, at: list[int], vectors: list[Vector]
) -> list[int]:
    """Put combinations of some vectors of the basis into it; return their indices."""
    wide = []
    for v in vectors:
        row = [place.zero] * len(basis)
        for i, x in zip(at, v, strict=True):
            row[i] = x
        wide.append(row)
    return adapt(basis, place, wide)


def _zero(place: LocalPlace, squares: Vector, mixed: list[Vector]) -> Vector:
    """Return a zero modulo the prime of ``Σ squares[i]·xᵢ² + Σ mixed[i][j]·xᵢxⱼ``, i < j."""
    n, rng = len(squares), Random(1)

    def value(x: Vector) -> Any:
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
    planes: Iterable[Any] = itertools.combinations(unit, 2)
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

    Both are isomorphic, with t = 0. Raises :class:`UnfactoredError`, and :class:`UndecidedError` where no
    isometry was met.
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
