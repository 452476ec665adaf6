"""Arrays of matrices of float quaternions as pairs of complex matrices: U + V·J, J·z = z̄·J, J² = −1.

A column p + q·J is stored as (p, −q̄), so that its image is [[U, V], [−V̄, Ū]] times it, and complex numbers
act on it from the right (F. Zhang, "Quaternions and matrices of quaternions", Linear Algebra Appl. 251,
1997).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from hfield.errors import CoercionError
from hfield.fields.floats import RDF

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import EllipsisType

    from numpy.typing import NDArray

    from hfield.algebra.quaternion import Parent, Quaternion

    Complex: TypeAlias = NDArray[np.complex128]
    Place: TypeAlias = tuple[int | slice | EllipsisType, ...]


@dataclass(frozen=True)
class Pair:
    """The matrix U + V·J, as two arrays of complex matrices of the same shape."""

    u: Complex
    v: Complex

    def __matmul__(self, other: Pair) -> Pair:
        u, v, x, y = self.u, self.v, other.u, other.v
        return Pair(u @ x - v @ y.conj(), u @ y + v @ x.conj())

    def copy(self) -> Pair:
        """Return a copy with its own arrays."""
        return Pair(self.u.copy(), self.v.copy())

    def scaled(self, factors: float | NDArray[np.float64]) -> Pair:
        """Return the matrix with its columns, or the whole matrix, multiplied by real numbers."""
        return Pair(self.u * factors, self.v * factors)

    def minus(self, other: Pair) -> Pair:
        """Return the difference."""
        return Pair(self.u - other.u, self.v - other.v)

    @property
    def H(self) -> Pair:
        """The conjugate transpose."""
        return Pair(self.u.conj().mT, -self.v.mT)

    def __getitem__(self, place: Place) -> Pair:
        return Pair(self.u[place], self.v[place])

    def __setitem__(self, place: Place, part: Pair) -> None:
        self.u[place], self.v[place] = part.u, part.v

    @property
    def matrices(self) -> Complex:
        """The complex matrices of twice the size."""
        u, v = self.u, self.v
        return np.concatenate(
            [np.concatenate([u, v], -1), np.concatenate([-v.conj(), u.conj()], -1)], -2
        )

    @property
    def sizes(self) -> NDArray[np.float64]:
        """The Frobenius norms."""
        found: NDArray[np.float64]
        found = np.sqrt((abs(self.u) ** 2 + abs(self.v) ** 2).sum((-1, -2)))
        return found


def column(v: Complex) -> Pair:
    """Return the unit column represented by complex vectors of twice the size."""
    n = v.shape[-1] // 2
    x = v / np.linalg.norm(v, axis=-1, keepdims=True)
    return Pair(x[..., :n, None], -x[..., n:, None].conj())


def identity(shape: Sequence[int], n: int) -> Pair:
    """Return identities."""
    one = np.broadcast_to(np.eye(n, dtype=complex), (*shape, n, n)).copy()
    return Pair(one, np.zeros_like(one))


def beginning_with(x: Pair) -> Pair:
    """Return unitary matrices that begin with the given unit columns: reflections, up to a factor."""
    n = x.u.shape[-2]
    first = x[..., :1, :]
    size = first.sizes[..., None, None]
    safe = np.where(size > 0, size, 1)
    a = Pair(-np.where(size > 0, first.u / safe, 1), -first.v / safe)
    w = x.copy()
    w[..., :1, :] = first.minus(a)
    # 1 − 2·w·w*/|w|² takes x to e₁·a, and is its own inverse
    scale = 2 / (w.sizes**2)[..., None, None]
    made = identity(x.u.shape[:-2], n).minus((w @ w.H).scaled(scale))
    turned = made[..., :, :1] @ a
    made[..., :1] = turned
    return made


# --- matrices of the algebra ----------------------------------------------------------------------


def _units(algebra: Parent) -> tuple[float, float, float]:
    """Return t/2, and the lengths of i − t/2 and j; their normalised multiples I and J have square −1."""
    if algebra.ring != RDF:
        raise CoercionError(
            f"eigenvalues and singular values are computed for matrices over H('RDF'), not over {algebra}"
        )
    a, t, b = map(float, algebra.constants)
    square = a + t * t / 4
    if square >= 0 or b >= 0:
        raise CoercionError(
            f"{algebra} has zero divisors: eigenvalues and singular values are computed for matrices over "
            "Hamilton's algebra, such as H('RDF')"
        )
    return t / 2, (-square) ** 0.5, (-b) ** 0.5


def pair_of(algebra: Parent, rows: Sequence[Sequence[Quaternion]]) -> Pair:
    """Return a matrix, whose entries may be arrays, as arrays of complex matrices."""
    half, i, j = _units(algebra)
    parts = [q.coordinates for row in rows for q in row]
    shape = np.broadcast_shapes(*(np.shape(x) for q in parts for x in q))
    full = np.empty((4, len(parts), *shape))
    for n, q in enumerate(parts):
        for m, x in enumerate(q):
            full[m, n] = x
    w, x, y, z = np.moveaxis(full, 1, -1).reshape(4, *shape, len(rows), len(rows[0]))
    return Pair(w + half * x + 1j * (i * x), j * (y + half * z) + 1j * (i * j * z))


def rows_of(algebra: Parent, pair: Pair) -> list[list[Quaternion]]:
    """Return the rows of a matrix over the algebra, with arrays as entries if there are several matrices."""
    half, i, j = _units(algebra)
    z = pair.v.imag / (i * j)
    x = pair.u.imag / i
    full = pair.u.real - half * x, x, pair.v.real / j - half * z, z
    m, n = pair.u.shape[-2:]

    def entry(r: int, c: int) -> Quaternion:
        values = [f[..., r, c] for f in full]
        return algebra(*(values if values[0].ndim else map(float, values)))

    return [[entry(r, c) for c in range(n)] for r in range(m)]
