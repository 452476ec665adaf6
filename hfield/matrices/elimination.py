"""Gaussian elimination over an algebra with unit pivots, and in coordinates where there are none.

Rows are multiplied from the left, so that solutions are preserved; if an entry is a unit, its column becomes
a column of the identity. Over a division algebra this is complete. Otherwise m rows of n entries without a
unit remain, which form a 4m × 4n matrix over the field. If flint supports such matrices, it does all the
work.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import flint

from hfield.algebra.quaternion import Parent, Quaternion, product_plus
from hfield.core.product import Scalar
from hfield.errors import CoercionError
from hfield.fields.linear_algebra.echelon import echelon, null_space, solution

Rows = Sequence[Sequence[Quaternion]]
Vector = tuple[Quaternion, ...]


def over_ring(rows: Rows) -> list[list[Scalar]]:
    """Return the matrix of x ↦ M·x on coordinates, 4m × 4n over the base ring."""
    out: list[list[Scalar]] = []
    for row in rows:
        blocks = [q.matrix() for q in row]
        out += [[x for block in blocks for x in block[r]] for r in range(4)]
    return out


def transposed(rows: Sequence[Sequence[Scalar]]) -> list[list[Scalar]]:
    """Return the transposed matrix, as rows."""
    return [list(column) for column in zip(*rows, strict=True)]


def vector(A: Parent, values: Sequence[Scalar]) -> Vector:
    """Return the elements with these coordinates."""
    return tuple(A(*values[n : n + 4]) for n in range(0, len(values), 4))


def by_functional(A: Parent, values: Sequence[Scalar]) -> Vector:
    """Return the row y such that λ(y·v) is the sum of ``values`` times coordinates of v.

    λ(q) is the coordinate at k. With ji = t·j − k, the values λ(y·e), λ(y·i), λ(y·j), λ(y·k) are y₃, −y₂, y₁
    and y₀ + t·y₁, over every ring and for every a, t, b. So every functional is given by one y.
    """
    t = A.constants.t
    blocks = (values[n : n + 4] for n in range(0, len(values), 4))
    return tuple(A(at_k - t * at_j, at_j, -at_i, at_e) for at_e, at_i, at_j, at_k in blocks)


class Cleared:
    """``rows`` after elimination: ``done`` rows, each with a pivot 1 at ``pivots``, and ``rest`` without
    units.

    Only the first ``width`` columns are searched for pivots; ``free`` are those of them without a pivot. The
    columns to the right are transformed along. With ``leftmost``, columns are processed in order.
    """

    def __init__(self, A: Parent, rows: Rows, width: int, leftmost: bool = False) -> None:
        if any(q.shape for row in rows for q in row):
            raise CoercionError(
                "elimination needs single quaternions as entries, and some entries are arrays"
            )
        self.algebra, self.width = A, width
        self.done, self.pivots = list[list[Quaternion]](), list[int]()
        self.rest = [list(row) for row in rows]
        quick = isinstance(A.ring.one, flint.fmpq | flint.nmod) or not A.ring.is_exact
        while leftmost or not quick:
            columns = [c for c in range(width) if c not in self.pivots]
            places = ((r, c) for c in columns for r in range(len(self.rest)))
            at = next((at for at in places if self.rest[at[0]][at[1]].is_unit()), None)
            if at is None:
                break
            self._clear(*at)
        self.free = [c for c in range(width) if c not in self.pivots]

    def _clear(self, r: int, column: int) -> None:
        row = self.rest.pop(r)
        back = row[column].inverse()
        row = [back * x if x else x for x in row]
        for other in (*self.rest, *self.done):
            factor = other[column]
            if factor:
                other[:] = [x - factor * y if y else x for x, y in zip(other, row, strict=True)]
        self.done.append(row)
        self.pivots.append(column)

    @property
    def core(self) -> list[list[Scalar]]:
        """The remaining equations over the base ring, in the free columns."""
        return over_ring([[row[c] for c in self.free] for row in self.rest])

    def rank(self) -> Fraction:
        """Return dim_F(M·Aⁿ)/4."""
        return len(self.pivots) + Fraction(len(echelon(self.algebra.ring, self.core)[1]), 4)

    def _lifted(self, z: Sequence[Quaternion], at: int | None = None) -> Vector:
        """Return the x with M·x = 0, or the column ``at``, whose entries at the free columns are z."""
        x = dict(zip(self.free, z, strict=True))
        for row, pivot in zip(self.done, self.pivots, strict=True):
            value = self.algebra.scalar(0) if at is None else row[at]
            for c, y in zip(self.free, z, strict=True):
                value = value - row[c] * y
            x[pivot] = value
        return tuple(x[c] for c in range(self.width))

    def right_kernel(self) -> list[Vector]:
        """Return vectors that generate the right module of all x with M·x = 0."""
        width = 4 * len(self.free)
        found = null_space(self.algebra.ring, self.core, width)
        return [self._lifted(z) for z in generators(self.algebra, found, right=True)]

    def solution(self) -> list[Vector] | None:
        """Return the columns x with M·x = b, where b are the columns to the right of M, or None."""
        A, count = self.algebra, len((self.rest or self.done)[0]) - self.width
        right = [
            list(row)
            for q in self.rest
            for row in zip(*(x.coordinates for x in q[self.width :]), strict=True)
        ]
        found: list[list[Scalar]] | None = [[]] * 0
        if self.rest and self.free:
            found = solution(A.ring, self.core, right)
        elif self.rest and any(not A.ring.is_zero(x) for row in right for x in row):
            found = None
        if found is None:
            return None
        zero = [A.scalar(0)] * len(self.free)
        columns = [vector(A, z) for z in transposed(found)] if found else [zero] * count
        return [self._lifted(z, self.width + n) for n, z in enumerate(columns)]


def left_kernel(A: Parent, rows: Rows) -> list[Vector]:
    """Return vectors that generate the left module of all y with y·M = 0."""
    # λ(y·M·v) = 0 for all v, where λ is the last coordinate, a form without kernel; see
    # `by_functional`
    m, width = len(rows), len(rows[0])
    one = [[A.scalar(r == c) for c in range(m)] for r in range(m)]
    of = Cleared(A, [[*row, *unit] for row, unit in zip(rows, one, strict=True)], width)
    values = null_space(A.ring, transposed(of.core), 4 * len(of.rest))
    vectors = [[x for q in by_functional(A, v) for x in q.coordinates] for v in values]
    found = generators(A, vectors, right=False)
    if not of.pivots:
        return found
    return [
        tuple(dot(y, column) for column in zip(*(row[width:] for row in of.rest), strict=True))
        for y in found
    ]


def dot(row: Sequence[Quaternion], column: Sequence[Quaternion]) -> Quaternion:
    """Return Σ x·y."""
    total = row[0] * column[0]
    for x, y in zip(row[1:], column[1:], strict=True):
        total = product_plus(x, y, total)
    return total


def generators(A: Parent, basis: list[list[Scalar]], right: bool) -> list[Vector]:
    """Choose from an F-basis of a module, given by coordinates, vectors that generate it over A."""
    F, chosen = A.ring, list[Vector]()
    span: list[list[Scalar]] = []
    for v in basis:
        x = vector(A, v)
        reduced = echelon(F, [*span, v])[0]
        if len(reduced) == len(span):
            continue
        chosen.append(x)
        for u in A.basis:
            multiple = [q * u if right else u * q for q in x]
            span.append([c for q in multiple for c in q.coordinates])
        span = echelon(F, span)[0]
        if len(span) == len(basis):
            break
    return chosen
