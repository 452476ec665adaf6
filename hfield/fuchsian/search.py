"""Find units of norm 1 that move a point near others, as short vectors of many definite forms, in arrays.

For g of norm 1, ``cosh d(g·c, w)`` and the norms at the other real places are definite forms in g. The units
that are needed are long as seen from the centre, but short as seen from suitable random points w (Page,
*Math. Comp.* 84, 2015, section 5; Rickards, *Math. Comp.* 91, 2022). The forms are computed in floats, which
may miss a unit; the exact proof later decides whether enough were found.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise

import numpy as np
from flint import fmpz_mat
from numpy.typing import NDArray

from hfield.algebra.quaternion import Quaternion
from hfield.errors import TooLargeError
from hfield.fuchsian.plane import Plane
from hfield.fuchsian.split_order import SplitOrder
from hfield.orders import hermite
from hfield.orders.base_values import BaseNumber
from hfield.orders.lattice_values import LatticeValue

Rows = NDArray[np.int64]
"""An array of integers: coordinates with respect to the basis of the order, one element a row."""
Floats = NDArray[np.float64]
Points = NDArray[np.complex128]
"""Points of the disc, or entries of matrices that move it."""
Flags = NDArray[np.bool_]
VECTORS_PER_POINT = 200
"""About so many vectors are looked at for each point."""
EQUAL_WITHIN = 1e-6
TRIES, LEVELS = 300, 10
"""So often elements of a norm are looked for from eight points, which come as near as 2⁻¹⁰ to the circle."""
MANIFOLD = 7.0
"""Lattices that have e⁷ times as many short vectors as another one are left out."""
MAX_RADIUS = 1e3
"""Lattices with a vector shorter than the others by this factor are left out: the point is in a cusp."""
MAX_ENTRY = 2.0**32
"""The largest entry of vectors: 2³⁰ times this bound fits into an integer of 64 bits."""
MAX_COSH = 1e9
"""Units that move the centre so far, by the hyperbolic cosine, are left out."""


class Sight:
    """An order in float coordinates around the centre of a plane.

    At the split place, x is the matrix ``[[a, b], [conj(b), conj(a)]]``, which moves 0 in the disc to
    b/conj(a).
    """

    def __init__(
        self,
        plane: Plane,
        basis: Sequence[Quaternion] | None = None,
        norm: BaseNumber | None = None,
    ) -> None:
        self.plane, order, real = plane, plane.order, plane.order.real
        self.basis = basis = order.basis if basis is None else tuple(basis)
        n, m = real(plane.norms[0]), -real(plane.norms[1])
        w, p, q, r = (
            np.array([real(x) for x in column])
            for column in zip(
                *((order.scalar(x.trace()) / 2, *plane.vector(x)) for x in basis), strict=True
            )
        )
        self.a = w + 1j * math.sqrt(n) * p
        self.b = math.sqrt(m) * (math.sqrt(n) * r - 1j * q)
        self.rank = len(basis)
        self.empty = np.empty((0, self.rank), dtype=np.int64)
        # the norms at the other places, one form each
        traces = np.array(order.traces_at_other_places(basis), dtype=float)
        self.other_norms: Floats = np.moveaxis(traces.reshape(self.rank, self.rank, -1), 2, 0) / 2
        if norm is not None:  # elements of this norm, of another lattice, look as units do
            size = math.sqrt(abs(real(norm)))
            self.a, self.b = self.a / size, self.b / size
            self.other_norms = self.other_norms / np.reshape(
                order.values_at_other_places(norm), (-1, 1, 1)
            )
        values, vectors = np.linalg.eigh(self.other_norms.sum(axis=0))
        self._others = (vectors * np.sqrt(np.maximum(values, 0)))[:, 4:]
        covolume = abs(np.linalg.det(self.forms(np.zeros(1), 1.0)[0]))
        size = len(self.other_norms) + 1
        ball = math.pi ** (2 * size) / math.gamma(2 * size + 1) * size ** (2 * size)
        self.cosh = max(2.0, math.sqrt(VECTORS_PER_POINT * covolume / ball))
        """Units within this distance of a point are found, by the hyperbolic cosine."""
        self._turns: tuple[Rows, Rows] | None = None

    @cached_property
    def products(self) -> Rows:
        """The products of the basis of the order."""
        return np.array(self.plane.order.products).reshape(self.rank, self.rank, self.rank)

    @cached_property
    def bar(self) -> Rows:
        """The matrix of the conjugation."""
        return np.array(self.plane.order.bars)

    def motions(self, rows: Rows) -> tuple[Points, Points]:
        """Return the matrix entries a and b of elements."""
        # one thread: starting as many as BLAS would takes longer than the products
        a, b = (np.einsum("ni,i->n", rows, x) for x in (self.a, self.b))
        return a, b

    def turn_about_center(self, rotation: Quaternion, order: int) -> None:
        """Set the rotation around the centre that :meth:`turned` uses, and its order."""
        powers = np.array(self.plane.order.rows([rotation**n for n in range(order)]))
        # x ↦ gⁿ·x, and x ↦ x·gⁿ
        self._turns = self.left(powers), np.einsum("nj,ijk->nik", powers, self.products)

    def turned(self, rows: Rows) -> Rows:
        """Return units together with their products with rotations around the centre on the left.

        Rotations are left out, and for each image of the centre only one unit is kept.
        """
        if self._turns is None:
            return distinct(rows)
        left, right = self._turns
        rows = rows[abs(self.motions(rows)[1]) > EQUAL_WITHIN]
        images = np.einsum("ni,mij->nmj", rows, left).reshape(-1, self.rank)
        same = positive(np.einsum("ni,mij->nmj", images, right).reshape(-1, self.rank))
        groups = same.reshape(-1, len(right), self.rank).tolist()
        return distinct(np.array([min(group) for group in groups] or self.empty))

    def left(self, rows: Rows) -> Rows:
        """Return the matrices of left multiplication by these elements."""
        found: Rows = np.einsum("ni,ijk->njk", rows, self.products)
        return found

    def times(self, matrices: Rows, rows: Rows) -> Rows:
        """Return the products of rows with elements on the left, given by their matrices."""
        found: Rows = np.einsum("nj,njk->nk", rows, matrices)
        return found

    def forms(self, points: Points | Floats, cosh: float) -> Floats:
        """Return linear forms, as columns, whose squares sum to cosh d(g·0, w)/cosh plus the norms at other
        places.
        """
        alpha = 1 / np.sqrt((1 - abs(points) ** 2) * cosh)[:, None]
        beta = alpha * points[:, None]
        a = alpha * self.a - beta * self.b.conj()
        b = alpha * self.b - beta * self.a.conj()
        others = np.broadcast_to(self._others, (len(points), *self._others.shape))
        return np.concatenate([np.stack([a.real, a.imag, b.real, b.imag], axis=2), others], axis=2)

    def carrying(self, points: Points | Floats, cosh: float | None = None) -> Rows:
        """Return units of norm 1, other than ±1 and up to sign, that move the centre near one of
        the points.
        """
        return distinct(self.units(self.near(points, cosh)))

    def near(self, points: Points | Floats, cosh: float | None = None) -> Rows:
        """Return nonzero elements, up to sign, that are short as seen from one of the points of the disc."""
        forms = self.forms(points, self.cosh if cosh is None else cosh)
        steps = np.array([reduction(form) for form in forms])
        which, vectors = short_vectors(steps @ forms, len(self.other_norms) + 1 + 1e-9)
        # in the order of the forms
        starts = np.searchsorted(which, np.arange(len(steps) + 1))
        rows = [vectors[s:e] @ steps[n] for n, (s, e) in enumerate(pairwise(starts))]
        return np.concatenate(rows)

    def of_norm(self, rows: Rows, sign: int) -> Flags:
        """Return a mask of the elements with norm ±1 that have this sign at the split place."""
        a, b = self.motions(rows)
        good = abs(abs(a) ** 2 - abs(b) ** 2 - sign) < 0.2
        for form in self.other_norms:
            good &= abs(np.einsum("ni,ij,nj->n", rows, form, rows) - 1) < 0.2
        return good

    def units(self, rows: Rows) -> Rows:
        """Return the elements of norm 1 other than ±1 that move the centre by a bounded distance."""
        a, b = self.motions(rows)
        far = abs(a) ** 2 > MAX_COSH
        return rows[
            self.of_norm(rows, 1) & ~far & ((abs(b) > EQUAL_WITHIN) | (abs(a.imag) > EQUAL_WITHIN))
        ]


def element_of_norm(
    order: SplitOrder, basis: Sequence[Quaternion], norm: BaseNumber
) -> Quaternion | None:
    """Return an element of a lattice with this exact norm that is short from some point, or None.

    The norm is positive at the other real places. Every element is short from some points.
    """
    basis = short_basis(order, basis)
    sight = Sight(Plane(order, next(free_centers(order))), basis, norm)
    rng = np.random.default_rng(1)
    for n in range(TRIES):
        radius, turn = np.sqrt(rng.random(8)) * (1 - 0.5 ** (n % LEVELS + 1)), rng.random(8)
        rows = sight.near(radius * np.exp(2j * np.pi * turn))
        for row in rows[sight.of_norm(rows, order.sign(norm))].tolist():
            terms = (x * c for x, c in zip(sight.basis, row, strict=True))
            found: Quaternion = sum(terms, order.algebra(0))
            if order.scalar(found.norm()) == norm:
                return found
    return None


def split_order(order: LatticeValue) -> SplitOrder:
    """Return an order with its split place, in a basis that is short as seen from a point.

    In this basis products have small coordinates. Raises :class:`IndefiniteError`.
    """
    return SplitOrder(order, short_basis(SplitOrder(order), order.basis))


def short_basis(order: SplitOrder, basis: Sequence[Quaternion]) -> tuple[Quaternion, ...]:
    """Return a basis of the same lattice that looks short from a point.

    The matrix of the form on the basis of the algebra is rounded. Everything else is exact, so a basis of any
    size can be reduced.
    """
    ambient = order.order.ambient
    units = [ambient.element(row) for row in hermite.tuples(ambient.identity)]
    seen = Sight(first_plane(order), units).forms(np.zeros(1), 1.0)[0]
    size = ambient.size
    form = fmpz_mat(size, size, [round(x) for x in (seen @ seen.T * 2.0**30).ravel().tolist()])
    rows, den = ambient.rows(basis).numer_denom()
    _, steps = (rows * form * rows.transpose()).lll(transform=True, rep="gram")
    found = steps * rows
    return tuple(ambient.element(row, int(den)) for row in hermite.tuples(found))


def is_fixed(order: SplitOrder, center: Quaternion) -> bool:
    """Return whether a unit other than ±1 fixes the centre, up to rounding."""
    sight = Sight(Plane(order, center))
    found = sight.motions(sight.carrying(np.zeros(1), 1.01))[1]
    return bool((abs(found) < EQUAL_WITHIN).any())


def first_plane(order: SplitOrder) -> Plane:
    """Return the plane around the fixed point of the simplest element of trace 0."""
    _, i, j, _ = order.algebra.basis
    u = i - i.trace() / 2
    centers = (c for c in (u, j, u * j) if order.sign(order.scalar(c.norm())) > 0)
    return Plane(order, next(centers))


def free_centers(order: SplitOrder) -> Iterator[Quaternion]:
    """Yield elements of trace 0 and positive norm whose point is apparently fixed by no unit but ±1."""
    if len(order.basis) == 4:
        candidates = _small(order)
    else:  # small elements are mostly fixed by units
        plane = first_plane(order)
        rng = random.Random(1)
        turns = (2 * cmath.pi * rng.random() for _ in range(1000))
        candidates = (plane.nearby(cmath.rect(rng.random() / 2, turn), 5) for turn in turns)
    return (c for c in candidates if not is_fixed(order, c))


def _small(order: SplitOrder) -> Iterator[Quaternion]:
    """Yield elements of trace 0 and positive norm in an order over ℤ, one of each norm, in order of
    the norm.
    """
    twice = fmpz_mat(order.rows([2 * x - x.trace() for x in order.basis])).hnf().tolist()
    without_trace = [order.element([int(c) for c in row]) for row in twice[:3]]
    basis = short_basis(order, without_trace)
    pairs = ((x * y.conjugate()).trace() for x in basis for y in basis)
    traces = [int(order.base.trace(order.scalar(t)).p) for t in pairs]  # of any size
    gram = np.array(traces, dtype=object).reshape(3, 3)
    for reach in (3, 8, 20):
        cube = np.indices((reach + 1, 2 * reach + 1, 2 * reach + 1)).reshape(3, -1).T
        cube -= [0, reach, reach]
        rows = cube[np.gcd.reduce(cube, axis=1) == 1]
        norms, first = np.unique((rows @ gram * rows).sum(axis=1), return_index=True)
        for row in rows[first[norms > 0]].tolist():
            yield sum((x * c for x, c in zip(basis, row, strict=True)), order.algebra(0))


def reduction(vectors: Floats) -> Rows:
    """Return the change to a reduced basis of the lattice spanned by rows.

    Raises :class:`TooLargeError` for rows so long that floats do not tell the short ones.
    """
    if abs(vectors).max() > MAX_ENTRY:
        raise TooLargeError(
            "this centre is too deep in a cusp for floats: expected one nearer to that of domain()"
        )
    whole = np.rint(vectors * 2.0**30).astype(np.int64).tolist()
    _, steps = fmpz_mat(whole).lll(transform=True)
    return np.array([int(x) for x in steps.entries()]).reshape(len(whole), -1)


def positive(rows: Rows) -> Rows:
    """Return the rows, negated where the first nonzero entry is negative."""
    first = rows[np.arange(len(rows)), (rows != 0).argmax(axis=1)]
    return rows * np.where(first < 0, -1, 1)[:, None]


def distinct(rows: Rows) -> Rows:
    """Return the rows without repetitions up to sign."""
    found = list(dict.fromkeys(map(tuple, positive(rows).tolist())))
    return np.array(found, dtype=np.int64).reshape(len(found), rows.shape[1])


def short_vectors(bases: Floats, bound: float) -> tuple[Rows, Rows]:
    """Return the combinations of vectors, up to sign, with squared length up to a bound, in many lattices.

    The result has the index of the lattice of each combination, ascending, and its coefficients. The method
    is that of Fincke and Pohst, breadth first: each step chooses the last remaining coefficient of all
    combinations at once.
    """
    count, rank, _ = bases.shape
    lower = np.linalg.cholesky(bases @ bases.transpose(0, 2, 1))
    scale = np.einsum("nii->ni", lower)
    mu = lower / scale[:, None, :]  # q(x) = Σ scaleₖ²·(xₖ + Σ_{j>k} mu[j, k]·xⱼ)²
    # near a cusp there are very many, and they all give the same information
    many = np.log1p(2 * math.sqrt(bound) / scale).sum(axis=1)
    which = np.flatnonzero(many < many.min() + MANIFOLD)
    count = len(which)
    chosen = np.zeros((count, rank), dtype=np.int64)
    left = np.full(count, bound)
    for k in range(rank - 1, -1, -1):
        radius = np.sqrt(np.maximum(left, 0)) / scale[which, k]
        near = radius < MAX_RADIUS
        which, chosen, left, radius = which[near], chosen[near], left[near], radius[near]
        shift = np.einsum("nj,nj->n", chosen[:, k + 1 :], mu[which, k + 1 :, k])
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
