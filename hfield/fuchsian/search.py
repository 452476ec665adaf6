"""Units of norm 1 that carry a point near others: short vectors of many definite forms at once, in arrays.

For g of norm 1, the cosine ``cosh d(g·c, w)`` and the norms at the other real places are definite
forms in g.
Seen from the centre alone the units that are needed are long; seen from one random point w after
the other they
are short (Page, *Math. Comp.* 84, 2015, section 5; Rickards, *Math. Comp.* 91, 2022). The forms
are computed in floats, which lose a unit now and then; whether enough were found is decided exactly, later.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np
from flint import fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.fuchsian.plane import Plane
from hfield.fuchsian.split_order import SplitOrder

Rows = Any
"""An array of integers: coordinates with respect to the basis of the order, one element a row."""
MANY = 60
"""About so many vectors are looked at for each point."""
NEAR = 1e-6
FAR = 1e6
"""Units that move the centre so far, by the hyperbolic cosine, are left out."""


class Sight:
    """An order as it looks from the centre of a plane, in floats.

    At the place that splits, x is the matrix ``[[a, b], [conj(b), conj(a)]]`` that moves 0 in the disc
    to b/conj(a).
    """

    def __init__(self, plane: Plane) -> None:
        self.plane, order = plane, plane.order
        basis, real = order.basis, order.real
        n, m = real(plane.norms[0]), -real(plane.norms[1])
        w, p, q, r = (
            np.array([real(x) for x in column])
            for column in zip(
                *((order.scalar(x.scalar_part), *plane.vector(x)) for x in basis), strict=True
            )
        )
        self.a = w + 1j * math.sqrt(n) * p
        self.b = math.sqrt(m) * (math.sqrt(n) * r - 1j * q)
        self.rank = len(basis)
        self.empty = np.empty((0, self.rank), dtype=np.int64)
        # the norms at the other places, one form each
        traces = np.array(order.traces_elsewhere, dtype=float)
        self.elsewhere = np.moveaxis(traces.reshape(self.rank, self.rank, -1), 2, 0) / 2
        self.products = np.array(order.products).reshape(self.rank, self.rank, self.rank)
        self.bar = np.array(order.bars)
        covolume = math.sqrt(np.linalg.det(self.forms(np.zeros(1), 1.0)[0]))
        size = len(self.elsewhere) + 1
        ball = math.pi ** (2 * size) / math.gamma(2 * size + 1) * size ** (2 * size)
        self.cosh = max(2.0, math.sqrt(MANY * covolume / ball))
        """Units within this distance of a point are found, by the hyperbolic cosine."""

    def motions(self, rows: Rows) -> tuple[Any, Any]:
        """Return a and b of elements."""
        return rows @ self.a, rows @ self.b

    def left(self, rows: Rows) -> Any:
        """Return the matrices by which these elements multiply rows from the left."""
        return np.einsum("ni,ijk->njk", rows, self.products)

    def forms(self, points: Any, cosh: float) -> Any:
        """Return the matrices of cosh d(g·0, w)/cosh plus the norms elsewhere, for points w of the disc."""
        alpha = 1 / np.sqrt(1 - abs(points) ** 2)[:, None]
        beta = alpha * points[:, None]
        a = alpha * self.a - beta * self.b.conj()
        b = alpha * self.b - beta * self.a.conj()
        parts = np.stack([a.real, a.imag, b.real, b.imag], axis=1)
        return np.einsum("npi,npj->nij", parts, parts) / cosh + self.elsewhere.sum(axis=0)

    def carrying(self, points: Any, cosh: float | None = None) -> Rows:
        """Return units of norm 1, other than ±1 and up to the sign, that move the centre near some point."""
        cosh = self.cosh if cosh is None else cosh
        forms = self.forms(np.asarray(points), cosh)
        steps = np.array([reduction(form) for form in forms])
        reduced = steps @ forms @ steps.transpose(0, 2, 1)
        which, vectors = short_vectors(reduced, len(self.elsewhere) + 1 + 1e-9)
        # sorted by the form
        starts = np.searchsorted(which, np.arange(len(forms) + 1))
        rows = [vectors[s:e] @ steps[n] for n, (s, e) in enumerate(pairwise(starts))]
        return distinct(self.units(np.concatenate(rows)))

    def units(self, rows: Rows) -> Rows:
        """Return those of norm 1 that are not ±1 and do not go too far."""
        a, b = self.motions(rows)
        size = abs(a) ** 2
        good = (abs(size - abs(b) ** 2 - 1) < 0.2) & (size < FAR)
        good &= (abs(b) > NEAR) | (abs(a.imag) > NEAR)
        for form in self.elsewhere:
            good &= abs(np.einsum("ni,ij,nj->n", rows, form, rows) - 1) < 0.2
        return rows[good]


def is_fixed(order: SplitOrder, center: Quaternion) -> bool:
    """Tell whether some unit other than ±1 seems to fix the centre."""
    sight = Sight(Plane(order, center))
    found = sight.motions(sight.carrying(np.zeros(1), 1.01))[1]
    return bool((abs(found) < NEAR).any())


def centers(order: SplitOrder) -> Iterator[Quaternion]:
    """Yield elements of trace 0 and positive norm at the place: points to look from, simple ones first."""
    _, i, j, _ = order.algebra.basis
    u = i - i.trace() / 2
    first = next(c for c in (u, j, u * j) if order.sign(order.scalar(c.norm())) > 0)
    plane = Plane(order, first)
    if len(order.basis) > 4:  # small elements are mostly fixed by units
        rng = random.Random(1)
        for n in range(1000):
            yield plane.nearby(
                cmath.rect(rng.random() / 2, 2 * cmath.pi * rng.random()), 5 + n // 10
            )
        return
    sight = Sight(plane)
    twice = fmpz_mat(order.rows([2 * x - x.trace() for x in order.basis])).hnf().tolist()
    rows = np.array([[int(c) for c in row] for row in twice[:3]])
    form = rows @ sight.forms(np.zeros(1), 1.0)[0] @ rows.T
    rows = reduction(form) @ rows
    for reach in (3, 8, 20):
        cube = np.indices((reach + 1, 2 * reach + 1, 2 * reach + 1)).reshape(3, -1).T
        cube -= [0, reach, reach]
        some = cube[np.gcd.reduce(cube, axis=1) == 1] @ rows
        a, b = sight.motions(some)
        size = abs(a) ** 2 - abs(b) ** 2
        for n in np.argsort(size, kind="stable").tolist():
            if size[n] > NEAR:
                yield order.element(some[n].tolist())


def reduction(form: Any) -> Any:
    """Return the matrix of a change to a reduced basis for a definite form, as rows."""
    whole = np.rint(form * 2.0**32).astype(np.int64).tolist()
    _, steps = fmpz_mat(whole).lll(transform=True, rep="gram")
    return np.array([int(x) for x in steps.entries()]).reshape(form.shape)


def distinct(rows: Rows) -> Rows:
    """Return rows that differ by more than the sign."""
    found: dict[tuple[int, ...], None] = {}
    for row in map(tuple, rows.tolist()):
        other = tuple(-x for x in row)
        found[max(row, other)] = None
    return np.array(list(found), dtype=np.int64).reshape(len(found), rows.shape[1])


def short_vectors(forms: Any, bound: float) -> tuple[Any, Any]:
    """Return short vectors of definite forms, up to the sign: the number of each one's form, and rows.

    After Fincke and Pohst, breadth first: the last coordinates that are left over are chosen for all at once.
    """
    count, rank, _ = forms.shape
    lower = np.linalg.cholesky(forms)
    scale = np.einsum("nii->ni", lower)
    mu = lower / scale[:, None, :]  # q(x) = Σ scaleₖ²·(xₖ + Σ_{j>k} mu[j, k]·xⱼ)²
    which = np.arange(count)
    chosen = np.zeros((count, rank), dtype=np.int64)
    left = np.full(count, bound)
    for k in range(rank - 1, -1, -1):
        shift = np.einsum("nj,nj->n", chosen[:, k + 1 :], mu[which, k + 1 :, k])
        radius = np.sqrt(np.maximum(left, 0)) / scale[which, k]
        low = np.ceil(-shift - radius).astype(np.int64)
        if k == rank - 1:
            low = np.maximum(low, 0)
        number = np.maximum(np.floor(radius - shift).astype(np.int64) - low + 1, 0)
        parent = np.repeat(np.arange(len(which)), number)
        first = np.repeat(np.cumsum(number) - number, number)
        value = low[parent] + np.arange(len(parent)) - first
        which, chosen = which[parent], chosen[parent]
        chosen[:, k] = value
        left = left[parent] - ((value + shift[parent]) * scale[which, k]) ** 2
    return which, chosen
