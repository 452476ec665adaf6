"""Quadratic orders inside an order over ℤ as frames ``ℤ[α] + ℤ[α]·β`` with α small."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from flint import fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.orders import enumeration, hermite
from hfield.orders.lattice_values import LatticeValue, discriminant


@dataclass(frozen=True)
class QuadraticFrame:
    """Elements α and β of O with N(β) = ``norm`` and s·β = −β·s, for s = 2α − t, s² = d, t = d modulo 2."""

    discriminant: int
    norm: int
    alpha: Quaternion
    beta: Quaternion

    @property
    def t(self) -> int:
        """The trace of α."""
        return self.discriminant % 2

    @property
    def root(self) -> Quaternion:
        """The square root s = 2α − t of the discriminant."""
        return 2 * self.alpha - self.t

    @property
    def n(self) -> int:
        """The norm of α."""
        return (self.t - self.discriminant) // 4

    def binary(self, x: int, y: int) -> int:
        """Return the norm of x + y·α."""
        return x * x + self.t * x * y + self.n * y * y

    def element(self, x: int, y: int, z: int, w: int) -> Quaternion:
        """Return x + y·α + (z + w·α)·β."""
        return x + y * self.alpha + (z + w * self.alpha) * self.beta


@lru_cache(maxsize=64)
def frame(order: LatticeValue) -> QuadraticFrame:
    """Return the frame for the quadratic order of least discriminant in an order of a definite algebra."""
    _, _, gram = order.reduced_ternary
    return next(frames(order, min(gram[n][n] for n in range(3)) // 2))


@lru_cache(maxsize=64)
def extremal_frame(order: LatticeValue, largest: int) -> QuadraticFrame | None:
    """Return a frame with d ≥ −largest and N(β) = p, the discriminant of the order, or None."""
    p = discriminant(order)
    return next((f for f in frames(order, largest) if f.norm == p), None)


def frames(order: LatticeValue, largest: int) -> Iterator[QuadraticFrame]:
    """Yield the frames of all optimally embedded quadratic orders with d ≥ −largest, ordered by |d|."""
    _, _, gram = order.reduced_ternary
    short = sorted((value, v) for v, value in enumeration.short_vectors(gram, 2 * largest))
    yield from (_frame(order, v) for _, v in short if math.gcd(*v) == 1)


def _frame(order: LatticeValue, x: tuple[int, ...]) -> QuadraticFrame:
    den, rows, _ = order.reduced_ternary
    s = hermite.combination(x, rows)
    element = order.element(s, den)
    d = -int(str(element.norm()))
    alpha = (element + d % 2) / 2
    # elements with trace 0 and orthogonal to s
    r = order.ambient
    forms = order.matrix * r.trace_form
    conditions = forms * fmpz_mat([[1, s[0]], [0, s[1]], [0, s[2]], [0, s[3]]])
    stacked = [
        [*row, *(int(m == n) for n in range(4))] for m, row in enumerate(conditions.tolist())
    ]
    h = fmpz_mat(stacked).hnf()
    kernel = fmpz_mat([row[2:] for row in h.tolist()[2:]])
    plane = kernel * order.matrix
    small, steps = (plane * r.trace_form * plane.transpose()).lll(transform=True, rep="gram")
    rows2 = hermite.tuples(steps * plane)
    beta = order.element(rows2[0] if small[0, 0] <= small[1, 1] else rows2[1])
    return QuadraticFrame(d, int(str(beta.norm())), alpha, beta)
