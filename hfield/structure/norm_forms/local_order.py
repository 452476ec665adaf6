"""A maximal order over the completion at a place, and two elements of it that show the norm to have no zero.

Where the algebra is a division algebra over the completion, the elements with integral norm are its maximal
order M. Modulo the prime of the place, the norm on M involves two coordinates alone; on the other two it is
divisible by the prime, and both halves are forms without zero over the residue field (Voight,
*Quaternion Algebras*, theorem 13.3.11). M is found from any lattice inside it, by adding what is missing step
by step; elements of the field itself span it, as they lie close to those of the completion.
"""

from collections.abc import Iterable
from itertools import combinations
from typing import Any

from hfield.product import Constants, norm
from hfield.structure.minimise import Vector, adapt, kernel_at

MAX_STEPS = 1_000

Form = dict[tuple[int, int], Any]


def unit_and_prime(place: Any, c: Constants, one: Any) -> tuple[Vector, Vector] | None:
    """Return quaternions u, j in M: u generates its residue field, and N(j) is divisible by the prime once.

    None says that the norm form has a zero over the completion. ``place`` is a :class:`ResidueField` or a
    :class:`PrimePlace` with a finite residue field, and ``one`` the 1 of its field.
    """
    zero = one - one
    basis = [[one if m == n else zero for n in range(4)] for m in range(4)]
    for v in basis:
        size = _norm(c, v)
        if size == zero:
            return None
        _scale(v, place, -(place.valuation(size) // 2))
    for _ in range(MAX_STEPS):
        form = _form(c, basis)
        if not _divisible(place, form, 0):
            return None
        inside = adapt(basis, place, _zeros(place, form, range(4)))
        outside = [n for n in range(4) if n not in inside]
        form = _form(c, basis)
        if not _divisible(place, {key: f for key, f in form.items() if {*key} & {*inside}}, 1):
            return None
        divided = {key: f * place.inverse_uniformiser for key, f in form.items()}
        smaller = _zeros(place, divided, inside)
        if smaller:
            for n in adapt(basis, place, smaller):
                _scale(basis[n], place, -1)
            continue
        halves = ((form, outside), (divided, sorted(inside)))
        if len(inside) != 2 or any(_has_zero(place, f, *ns) for f, ns in halves):
            return None
        # 1 is in M, so one of the two that span the residue field is no multiple of it
        u = next(basis[n] for n in outside if _generates(place, c, basis[n], one))
        return u, basis[inside[0]]
    return None


def _generates(place: Any, c: Constants, u: Vector, one: Any) -> bool:
    """Tell whether X² − tr(u)·X + N(u) has no root in the residue field."""
    trace = u[0] + u[0] + c.t * u[1]
    a, b, d = (place.reduce(x) for x in (one, trace, _norm(c, u)))
    return place.quadratic_root(a, b, d) is None


def _norm(c: Constants, v: Vector) -> Any:
    w, x, y, z = v
    return norm(c, (w, x, y, z))


def _scale(v: Vector, place: Any, n: int) -> None:
    """Multiply a vector by something of the valuation n."""
    factor = place.uniformiser if n > 0 else place.inverse_uniformiser
    for _ in range(abs(n)):
        v[:] = [factor * x for x in v]


def _form(c: Constants, basis: list[Vector]) -> Form:
    """Return the coefficients of the norm form in coordinates with respect to a basis."""
    form = {(n, n): _norm(c, v) for n, v in enumerate(basis)}
    for m, n in combinations(range(len(basis)), 2):
        total = [x + y for x, y in zip(basis[m], basis[n], strict=True)]
        form[m, n] = _norm(c, total) - form[m, m] - form[n, n]
    return form


def _divisible(place: Any, form: Form, power: int) -> bool:
    """Tell whether all coefficients are divisible by that power of the prime."""
    return all(f == f - f or place.valuation(f) >= power for f in form.values())


def _zeros(place: Any, form: Form, coordinates: Iterable[int]) -> list[Vector]:
    """Return a basis, in k⁴, of the zeros over the residue field of a form in some of the coordinates.

    They are a subspace if the rest has no zero: the radical of the polar form, or in even characteristic the
    zeros of the form on it, where it is additive.
    """
    used = sorted(coordinates)
    k = {key: place.reduce(f) for key, f in form.items() if {*key} <= {*used}}
    rows = [[k[m, m] + k[m, m] if m == n else k[min(m, n), max(m, n)] for m in used] for n in used]
    radical = kernel_at(place, rows, len(used))
    if place.even:
        roots = [[place.sqrt(_value(k, used, v) % place.modulus) for v in radical]]
        combinations_of = kernel_at(place, roots, len(radical))
        radical = [
            [
                sum((s * v[n] for s, v in zip(u, radical, strict=True)), place.zero) % place.modulus
                for n in range(len(used))
            ]
            for u in combinations_of
        ]
    return [[dict(zip(used, v, strict=True)).get(n, place.zero) for n in range(4)] for v in radical]


def _value(form: Form, used: list[int], v: Vector) -> Any:
    at = dict(zip(used, v, strict=True))
    return sum((f * at[m] * at[n] for (m, n), f in form.items()), at[used[0]] * 0)


def _has_zero(place: Any, form: Form, m: int, n: int) -> bool:
    a, b, c = (place.reduce(form[key]) for key in ((m, m), (m, n), (n, n)))
    return place.quadratic_root(a, b, c) is not None
