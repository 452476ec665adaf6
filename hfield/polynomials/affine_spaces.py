"""Solutions of a + b·q = 0 with given trace and norm, in every algebra over a field.

The trace and b·q are linear in q. The norm is constant along the radical. Modulo the radical the algebra is
simple, or of dimension at most 2 with a nonzero trace, so that a line remains, on which the norm has degree
2. In characteristic 2 with t = 0 the trace is 0 and the norm is additive, hence linear after taking roots.
"""

from __future__ import annotations

from collections.abc import Sequence

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.algebra.structure import is_central_simple
from hfield.algebra.structure.elements.trace_and_norm import element_of
from hfield.algebra.structure.invariants.radical import square_parts
from hfield.core.product import Scalar
from hfield.fields.base.ring import Ring
from hfield.fields.base.roots import stripped
from hfield.fields.linear_algebra.echelon import null_space, solution
from hfield.fields.quadratic_forms import is_division
from hfield.fields.quadratic_forms.normal_forms import pairing_matrix

Spaces = tuple[
    list[Quaternion], list[Quaternion]
]  # each of these points plus the span of directions


def of_trace_and_norm(A: Parent, t: Scalar, n: Scalar) -> Quaternion | None:
    """Return a nonscalar element of trace t and norm n, or None. Raises :class:`UndecidedError`."""
    if is_central_simple(A.ring, A.constants):
        q = element_of(A.ring, A.constants, t, n)
        return None if q is None else A(*q)
    points, directions = on_spaces(A, A.scalar(0), A.scalar(0), t, n)
    found = (q + v for q in points for v in (A.scalar(0), *directions))
    return next((q for q in found if any(not A.ring.is_zero(x) for x in q.coordinates[1:])), None)


def on_spaces(A: Parent, a: Quaternion, b: Quaternion, t: Scalar, n: Scalar) -> Spaces:
    """Return all q of trace t and norm n with a + b·q = 0, if x² − t·x + n divides norm(a + b·x).

    If b is a unit, there is one q, because norm(a + b·x) is N(b)·(x² − tr(q)·x + N(q)).
    """
    F, c = A.ring, A.constants
    if b.is_unit():
        double = F.characteristic != 2 and F.equal(t * t, n * 4) and is_division(F, c)
        return [A.scalar(t / F(2)) if double else -(b.inverse() * a)], []
    rows: list[list[Scalar]] = [list(row) for row in b.matrix()]
    rows.append([F(2), c.t, F.zero, F.zero])
    start = solution(F, rows, [*([-x] for x in a.coordinates), [t]])
    if start is None:
        return [], []
    q = A(*(row[0] for row in start))
    free = _elements(A, null_space(F, rows, 4))
    if F.characteristic == 2 and F.is_zero(c.t):
        return _additive(q, free, n)
    pairing = pairing_matrix(F, c)
    radical = _elements(A, null_space(F, [*rows, *pairing], 4))
    if len(free) == len(radical):
        return [q] if F.equal(q.norm(), n) else [], radical
    v = next(v for v in free if any(not F.is_zero(x) for x in _times(F, pairing, v)))
    along = [q.norm() - n, (q * v.conjugate()).trace(), v.norm()]
    if all(map(F.is_zero, along)):
        return [q], [v]  # the radical is 0: a norm is constant on no line modulo it
    if F.is_zero(along[1]) and F.is_zero(along[2]):
        return [], []
    factors = F.irreducible_factors(stripped(F, along))
    return [q - v * g[0] for g in factors if len(g) == 2], radical


def _additive(q: Quaternion, free: list[Quaternion], n: Scalar) -> Spaces:
    """Return the elements q + Σ s·v with N(q) + Σ s²·N(v) = n."""
    A, F = q.algebra, q.algebra.ring
    *parts, right = ([*square_parts(F, x)] for x in (*(v.norm() for v in free), n - q.norm()))
    rows = [[part[m] for part in parts] for m in range(len(right))]
    if not free:
        return ([] if any(not F.is_zero(x) for x in right) else [q]), []
    start = solution(F, rows, [[x] for x in right])
    if start is None:
        return [], []

    def combined(scalars: Sequence[Scalar]) -> Quaternion:
        total = A.scalar(0)
        for s, v in zip(scalars, free, strict=True):
            total = total + v * s
        return total

    return [q + combined([row[0] for row in start])], [
        combined(row) for row in null_space(F, rows, len(free))
    ]


def _elements(A: Parent, rows: Sequence[Sequence[Scalar]]) -> list[Quaternion]:
    return [A(*row) for row in rows]


def _times(F: Ring, rows: Sequence[Sequence[Scalar]], v: Quaternion) -> list[Scalar]:
    return [sum((x * y for x, y in zip(row, v.coordinates, strict=True)), F.zero) for row in rows]
