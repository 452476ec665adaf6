"""Right eigenvalues and decompositions of matrices over float quaternions; residuals are checked.

If M·x = x·λ, then x·q solves it for q⁻¹·λ·q, so a complex λ with Im λ ≥ 0 represents its class; there are n
of them (L. Brenner, Pacific J. Math. 1 (1951)). The Schur form and singular values are found one by one: an
eigenvector or singular vector of the complex matrices is completed to a unitary quaternion matrix.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from hfield.errors import CoercionError, UndecidedError
from hfield.fields.algebraic.ring import CC
from hfield.fields.base.roots import divided
from hfield.fields.quadratic_forms import is_division
from hfield.matrices.complex_form import Pair, beginning_with, column, identity, pair_of, rows_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from hfield.fields.algebraic.closed_forms import Closed
    from hfield.fields.algebraic.surds import Surd
    from hfield.matrices.matrix import Matrix

T = TypeVar("T")

ROUNDING = 64 * float(np.finfo(float).eps)  # relative to the size: the tolerance for residuals


class Schur(NamedTuple):
    """The Schur form M = ``unitary`` @ ``triangular`` @ ``unitary.conjugate_transpose()``, with complex
    diagonal.
    """

    unitary: Matrix
    triangular: Matrix


class SVD(NamedTuple):
    """M = ``left`` @ diag(``values``) @ ``right.conjugate_transpose()``, with left and right unitary."""

    left: Matrix
    values: np.ndarray
    right: Matrix


class PolarDecomposition(NamedTuple):
    """M = ``unitary`` @ ``positive``, where ``positive`` is hermitian with nonnegative eigenvalues."""

    unitary: Matrix
    positive: Matrix


def right_eigenvalues(M: Matrix) -> tuple[Surd | Closed, ...] | np.ndarray:
    """Return one complex λ with Im λ ≥ 0 for each class; see :meth:`Matrix.right_eigenvalues`."""
    F = M.algebra.ring
    if F.closure == "real closed":
        return _exactly(M)
    pair = _pair(M, square=True)
    matrices = pair.matrices
    values = _lapack(np.linalg.eigvals, matrices) * _scale(matrices)[..., None]
    size = np.linalg.norm(matrices, axis=(-1, -2))
    n = matrices.shape[-1]
    trace = abs(values.sum(-1) - np.trace(matrices, axis1=-1, axis2=-2))
    square = abs((values**2).sum(-1) - np.einsum("...rs,...sr->...", matrices, matrices))
    _check(trace, n * size, "the sum of the eigenvalues")
    _check(square, n * size**2, "the sum of their squares")
    return _paired(values)


def _paired(values: np.ndarray) -> np.ndarray:
    """Return one of each pair of conjugate eigenvalues; each value farthest from ℝ is paired first."""
    *shape, count = values.shape
    left, out = values.reshape(-1, count), []
    rows = np.arange(len(left))
    for size in range(count, 0, -2):
        first = abs(left.imag).argmax(-1)
        x = left[rows, first]
        distance = abs(left - x.conj()[:, None])
        distance[rows, first] = np.inf
        second = distance.argmin(-1)
        mean = (x + left[rows, second].conj()) / 2
        out.append(mean.real + 1j * abs(mean.imag))
        kept = np.ones(left.shape, dtype=bool)
        kept[rows, first] = kept[rows, second] = False
        left = left[kept].reshape(len(left), size - 2)
    return np.stack(out, -1).reshape(*shape, count // 2)


def _exactly(M: Matrix) -> tuple[Surd | Closed, ...]:
    """Return the eigenvalues in CC, half of the roots of the characteristic polynomial."""
    F = M.algebra.ring
    whole = [CC(c) for c in M.reduced_characteristic_polynomial()]
    if not is_division(F, M.algebra.constants):
        raise CoercionError(
            f"right eigenvalues are computed for matrices over Hamilton's algebra, not {M.algebra}"
        )
    found = []
    for g in CC.irreducible_factors(whole):
        times, (rest, remainder) = 0, divided(CC, whole, g)
        while not remainder:
            times, (rest, remainder) = times + 1, divided(CC, rest, g)
        if (-g[0]).is_real():  # each twice
            found += [-g[0]] * (times // 2)
        elif (-g[0]).ball(64).imag > 0:
            found += [-g[0]] * times
    return tuple(found)


def schur(M: Matrix) -> Schur:
    """Return the Schur form; see :meth:`Matrix.schur`."""
    given = _pair(M, square=True)
    *shape, n, _ = given.u.shape
    whole, unitary = given.copy(), identity(shape, n)
    for k in range(n):
        values, vectors = _lapack(np.linalg.eig, whole[..., k:, k:].matrices)
        best = values.imag.argmax(-1)[..., None, None]
        x = column(np.take_along_axis(vectors, best, -1)[..., 0])
        turn = beginning_with(x)
        for part in (whole, unitary):
            part[..., :, k:] = part[..., :, k:] @ turn
        whole[..., k:, :] = turn.H @ whole[..., k:, :]
        below = whole[..., k:, k]
        residual = np.hypot(*(np.linalg.norm(x, axis=-1) for x in (below.u[..., 1:], below.v)))
        _check(residual, n * given.sizes, "what is left below the diagonal")
        whole.u[..., k + 1 :, k], whole.v[..., k:, k] = 0, 0
        corner = whole.u[..., k, k]
        whole.u[..., k, k] = corner.real + 1j * np.maximum(corner.imag, 0)
    _check_product(given, unitary @ whole @ unitary.H)
    _check_product(identity(shape, n), unitary.H @ unitary)
    return Schur(_matrix(M, unitary), _matrix(M, whole))


def svd(M: Matrix) -> SVD:
    """Return singular values with unitary matrices; see :meth:`Matrix.svd`."""
    left, values, right = _singular(_pair(M))
    return SVD(_matrix(M, left), values, _matrix(M, right))


def polar(M: Matrix) -> PolarDecomposition:
    """Return the polar form; see :meth:`Matrix.polar`."""
    m, n = M.shape
    if m < n:
        raise CoercionError(
            f"a polar form needs at least as many rows as columns, found shape {M.shape}; take that of the "
            "adjoint"
        )
    left, values, right = _singular(_pair(M))
    scaled = right.scaled(values[..., None, :])
    return PolarDecomposition(_matrix(M, left[..., :, :n] @ right.H), _matrix(M, scaled @ right.H))


def _singular(given: Pair) -> tuple[Pair, np.ndarray, Pair]:
    *shape, m, n = given.u.shape
    rest, left, right = given, identity(shape, m), identity(shape, n)
    values = np.zeros((*shape, min(m, n)))
    for k in range(min(m, n)):
        vectors = _lapack(np.linalg.svd, rest.matrices)[2]
        x = column(vectors[..., 0, :].conj())
        y = rest @ x
        size = y.sizes
        values[..., k] = size
        safe, first = np.where(size > 0, size, 1)[..., None, None], np.zeros((m - k, 1))
        first[0] = 1
        y = Pair(np.where(size[..., None, None] > 0, y.u / safe, first), y.v / safe)
        one, two = beginning_with(y), beginning_with(x)
        rest = (one.H @ rest @ two)[..., 1:, 1:]
        for part, turn in ((left, one), (right, two)):
            part[..., :, k:] = part[..., :, k:] @ turn
    kept = min(m, n)
    scaled = left[..., :kept].scaled(values[..., None, :])
    _check_product(given, scaled @ right[..., :, :kept].H)
    for unitary, size in ((left, m), (right, n)):
        _check_product(identity(shape, size), unitary.H @ unitary)
    return left, values, right


def _pair(M: Matrix, square: bool = False) -> Pair:
    F = M.algebra.ring
    if F.is_exact:
        raise UndecidedError(
            f'this is computed in floating point, not over {F.name}; use M.change_ring("RDF")'
        )
    if square and M.shape[0] != M.shape[1]:
        raise CoercionError(f"expected a square matrix, found the shape {M.shape}")
    return pair_of(M.algebra, M.rows)


def _matrix(M: Matrix, pair: Pair) -> Matrix:
    return M._like(rows_of(M.algebra, pair))


def _lapack(function: Callable[[np.ndarray], T], matrices: np.ndarray) -> T:
    """Apply LAPACK to scaled matrices, because some builds fail on large entries."""
    try:
        return function(matrices / _scale(matrices)[..., None, None])
    except np.linalg.LinAlgError as error:
        raise UndecidedError(f"LAPACK found no solution: {error}") from error


def _scale(matrices: np.ndarray) -> np.ndarray:
    """Return a power of 2 about as large as the entries of each matrix."""
    size = np.max(np.abs(matrices), axis=(-1, -2), initial=0.0)
    return np.asarray(np.ldexp(1.0, np.frexp(size)[1]))


def _check_product(given: Pair, product: Pair) -> None:
    _check(
        product.minus(given).sizes,
        max(given.u.shape[-2:]) * given.sizes,
        "the product of the parts",
    )


def _check(residual: np.ndarray, size: np.ndarray, what: str) -> None:
    """Raise :class:`UndecidedError` if a residual is larger than rounding errors."""
    if not (residual <= ROUNDING * size + np.finfo(float).tiny).all():
        raise UndecidedError(f"{what} has an error beyond rounding: {np.max(residual):.1e}")
