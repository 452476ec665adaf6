"""A maximal order over the completion at a place, and two elements of it that show that the norm has no zero.

If the algebra is a division algebra over the completion, the elements with integral norm form its maximal
order M. Modulo the prime of the place, the norm on M involves only two coordinates; on the other two it is
divisible by the prime. Both halves are forms without zeros over the residue field (Voight, *Quaternion
Algebras*, theorem 13.3.11). M is found from any lattice inside it by adding missing elements step by step. It
is spanned by elements of the field itself, because these approximate those of the completion.

If the algebra splits over the completion, the same steps end at a plane on which the norm has a zero by
Hensel's lemma. Nothing is factored, and neither the characteristic of the field nor that of the residue field
matters.
"""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, TypeAlias

from hfield.core.product import Constants, Scalar, norm
from hfield.errors import UndecidedError
from hfield.fields.base.ring import E
from hfield.fields.linear_algebra.vectors import dot
from hfield.fields.quadratic_forms.minimal_conics import Vector, adapt, kernel_at

if TYPE_CHECKING:
    from hfield.fields.base.finite_places import FinitePlace


MAX_STEPS = 1_000

Form: TypeAlias = dict[tuple[int, int], E]


@dataclass(frozen=True)
class Halves:
    """A basis of a lattice, and the norm form on it in two halves that have no zeros over the residue field
    where they are additive.

    ``outside`` belongs to the norm itself and ``inside`` to the norm divided by the prime; each contains the
    form and the indices of its coordinates.
    """

    basis: list[Vector]
    outside: tuple[Form, list[int]]
    inside: tuple[Form, list[int]]


def unit_and_prime(place: FinitePlace, c: Constants, one: Scalar) -> tuple[Vector, Vector] | None:
    """Return quaternions u, j in M: u generates its residue field, and the prime divides N(j) exactly once.

    None means that the norm form has a zero over the completion. The residue field is finite; ``one`` is the
    1 of the field.
    """
    found = _enlarged(place, c, one)
    if not isinstance(found, Halves) or _zero_of_halves(place, c, found) is not None:
        return None
    # 1 is in M, so one of the two vectors that span the residue field is not a multiple of it
    basis, (_, outside), (_, inside) = found.basis, found.outside, found.inside
    return next(basis[n] for n in outside if _generates(place, c, basis[n], one)), basis[inside[0]]


def hyperbolic_plane(place: FinitePlace, c: Constants, one: Scalar) -> tuple[Vector, Vector] | None:
    """Return quaternions q, u such that the norm has a zero on their span over the completion, by Hensel's
    lemma.

    There ``N(X·q + Y·u) = N(q)·X² + T·XY + N(u)·Y²`` with T = tr(q·conj(u)) ≠ 0, and the prime divides
    N(q)·N(u)/T², which may be 0. None means that the norm form has no zero there. The arguments are as above.
    """
    found = _enlarged(place, c, one)
    return _zero_of_halves(place, c, found) if isinstance(found, Halves) else found


def _enlarged(place: FinitePlace, c: Constants, one: Scalar) -> Halves | tuple[Vector, Vector]:
    """Enlarge the lattice of the basis e, i, j, k until it splits into two halves, or an isotropic plane
    appears.
    """
    zero = one - one
    basis = [[one if m == n else zero for n in range(4)] for m in range(4)]
    for v in basis:
        size = _norm(c, v)
        if size != zero:
            _scale(v, place, -(place.valuation(size) // 2))
    for _ in range(MAX_STEPS):
        form = _form(c, basis)
        plane = _plane(place, form, basis)
        if plane is not None:
            return plane
        inside = adapt(basis, place, _zeros(place, form, range(4)))
        outside = [n for n in range(4) if n not in inside]
        form = _form(c, basis)
        divided = {key: f * place.inverse_uniformiser for key, f in form.items()}
        smaller = _zeros(place, divided, inside)
        if not smaller:
            return Halves(basis, (form, outside), (divided, sorted(inside)))
        for n in adapt(basis, place, smaller):
            _scale(basis[n], place, -1)
    raise UndecidedError(f"no maximal order at {place} was found in {MAX_STEPS} steps")


def _plane(place: FinitePlace, form: Form, basis: list[Vector]) -> tuple[Vector, Vector] | None:
    """Return two vectors of a basis that span a plane with a zero by Hensel's lemma, or None."""
    for m, n in combinations(range(len(basis)), 2):
        mixed, sizes = form[m, n], (form[m, m], form[n, n])
        if mixed != mixed - mixed:
            total = [place.valuation(f) for f in sizes if f != f - f]
            if len(total) < 2 or sum(total) > 2 * place.valuation(mixed):
                return (
                    (basis[m], basis[n]) if sizes[0] == 0 or sizes[1] != 0 else (basis[n], basis[m])
                )
    return None


def _zero_of_halves(
    place: FinitePlace, c: Constants, halves: Halves
) -> tuple[Vector, Vector] | None:
    """Return a plane with a zero if one of the halves has a zero over the residue field, else None."""
    for form, names in (halves.outside, halves.inside):
        v = _isotropic(place, form, names)
        if v is not None:
            basis = list(halves.basis)
            (n,) = adapt(basis, place, [v])
            basis = [basis[n], *(basis[m] for m in names if m != n)]
            plane = _plane(place, _form(c, basis), basis)
            assert plane is not None, "a zero that is not additive is smooth"
            return plane
    return None


def _isotropic(place: FinitePlace, form: Form, names: list[int]) -> Vector | None:
    """Return a zero over the residue field of a form in some coordinates; None is possible only for one or
    two of them.

    A regular form in three variables has zeros on half of all lines, so a few random lines suffice.
    """
    k = {key: place.reduce(f) for key, f in form.items() if {*key} <= {*names}}
    rng = random.Random(1)
    for attempt in range(MAX_STEPS if len(names) > 2 else len(names) - 1):
        ends = [[place.zero] * 4, [place.zero] * 4]
        ends[0][names[0]] = ends[1][names[1]] = place.one
        for n in names[2:]:
            for end in ends if attempt else ():
                end[n] = place.random(rng)
        first, last = (_value(place, k, end) for end in ends)
        both = _value(place, k, [x + y for x, y in zip(*ends, strict=True)])
        root = place.quadratic_root(first, (both - first - last) % place.modulus, last)
        if root is not None:
            return [(root[0] * x + root[1] * y) % place.modulus for x, y in zip(*ends, strict=True)]
    assert len(names) < 3, "a regular form in three variables has a zero over a finite field"
    return None


def _generates(place: FinitePlace, c: Constants, u: Vector, one: Scalar) -> bool:
    """Return whether X² − tr(u)·X + N(u) has no root in the residue field."""
    trace = u[0] + u[0] + c.t * u[1]
    a, b, d = (place.reduce(x) for x in (one, trace, _norm(c, u)))
    return place.quadratic_root(a, b, d) is None


def _norm(c: Constants[E], v: Vector[E]) -> E:
    w, x, y, z = v
    return norm(c, (w, x, y, z))


def _scale(v: Vector, place: FinitePlace, n: int) -> None:
    """Multiply a vector by an element of valuation n."""
    factor = place.uniformiser if n > 0 else place.inverse_uniformiser
    for _ in range(abs(n)):
        v[:] = [factor * x for x in v]


def _form(c: Constants, basis: list[Vector]) -> Form:
    """Return the coefficients of the norm form in coordinates with respect to a basis."""
    halves, zero = [_half(c, v) for v in basis], c.t - c.t
    form = {(n, n): dot(v, half) for n, (v, half) in enumerate(zip(basis, halves, strict=True))}
    for m, n in combinations(range(len(basis)), 2):
        there = dot(basis[m], halves[n])
        back = dot(basis[n], halves[m]) if c.t != zero else there
        form[m, n] = there + back
    return form


def _half(c: Constants, v: Vector) -> Vector:
    """Return a vector, linear in v, whose product with v is N(v)."""
    a, t, b = c
    w, x, y, z = v
    return [w + t * x, -(a * x), -(b * (y + t * z)), a * (b * z)]


def _zeros(place: FinitePlace, form: Form, coordinates: Iterable[int]) -> list[Vector]:
    """Return a basis, in k⁴, of the zeros over the residue field of a form in some of the coordinates.

    They form a subspace if the form has no other zeros: the radical of the polar form or, in even
    characteristic, the zeros on that radical, on which the form is additive.
    """
    used = sorted(coordinates)
    k = {key: place.reduce(f) for key, f in form.items() if {*key} <= {*used}}
    rows = [[k[m, m] + k[m, m] if m == n else k[min(m, n), max(m, n)] for m in used] for n in used]
    radical = [
        [dict(zip(used, v, strict=True)).get(n, place.zero) for n in range(4)]
        for v in kernel_at(place, rows, len(used))
    ]
    if not place.even or not radical:
        return radical
    roots = [[place.sqrt(_value(place, k, v)) for v in radical]]
    return [
        [
            sum((s * v[n] for s, v in zip(u, radical, strict=True)), place.zero) % place.modulus
            for n in range(4)
        ]
        for u in kernel_at(place, roots, len(radical))
    ]


def _value(place: FinitePlace, form: Form[E], v: Vector[E]) -> E:
    """Return the value of a form with coefficients in the residue field."""
    value: E = sum((f * v[m] * v[n] for (m, n), f in form.items()), place.zero) % place.modulus
    return value
