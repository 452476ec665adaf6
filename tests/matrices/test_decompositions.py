"""Eigenvalues and decompositions: matrices with known ones, the products themselves, exact arithmetic."""

import numpy as np
import pytest

from hfield import CC, CoercionError, H, QuaternionAlgebra, UndecidedError
from hfield.matrices import decompositions
from hfield.matrices.complex_form import Pair, beginning_with, column
from tests.subcases import subcases

ALGEBRAS = [("RDF", -1, -1, 0), ("RDF", -2, -3, 1), ("RDF", -4, -0.5, 0)]
RNG = np.random.default_rng(7)


def random(A, m, n, *shape, scale=1.0):
    return A.matrix(A(*(scale * RNG.normal(size=(4, *shape, m, n)))))


def size(M):
    return max(np.max(np.abs(x)) for row in M.rows for q in row for x in q.coordinates)


def diagonal(A, values, m, n):
    zero = A.scalar(0)
    return A.matrix(
        [[A.scalar(values[..., r]) if r == c else zero for c in range(n)] for r in range(m)]
    )


@subcases("constants", ALGEBRAS)
@subcases("shape", [(), (4,), (2, 3)])
@subcases("n", [1, 2, 5])
def test_the_parts_multiply_to_the_matrix(constants, shape, n):
    A = QuaternionAlgebra(*constants)
    one = A.matrix(np.eye(n))
    for M in (random(A, n, n, *shape), random(A, n, n, *shape, scale=1e150), random(A, n, n) * 0):
        scale = max(size(M), 1e-300)
        U, T = M.schur()
        assert size(U @ T @ U.conjugate_transpose() - M) < 1e-12 * scale
        assert size(U.conjugate_transpose() @ U - one) < 1e-12
        assert all(not np.any(x) for r in range(n) for s in range(r) for x in T[r, s].coordinates)
        for r in range(n):
            _, x, y, z = T[r, r].coordinates
            assert np.all(x >= -1e-300)
            assert np.allclose([y, z], 0, atol=1e-13 * scale)
        W, P = M.polar()
        assert size(W @ P - M) < 1e-12 * scale
        assert size(W.conjugate_transpose() @ W - one) < 1e-12
        assert size(P - P.conjugate_transpose()) < 1e-12 * scale
        assert np.all(P.right_eigenvalues().real > -1e-12 * scale)


@pytest.mark.parametrize(("m", "n"), [(3, 5), (5, 3), (1, 4), (4, 1), (4, 4)])
def test_singular_values(m, n):
    A = H("RDF")
    for M in (random(A, m, n, 6), random(A, m, 1, 6) @ random(A, 1, n, 6)):
        U, s, V = M.svd()
        assert size(U @ diagonal(A, s, m, n) @ V.conjugate_transpose() - M) < 1e-12
        assert np.all(np.diff(s) <= 1e-12)
        assert np.allclose((s**2).sum(-1), sum(q.norm() for row in M.rows for q in row))
        square = (M.conjugate_transpose() @ M).right_eigenvalues().real
        assert np.allclose(np.sort(square)[..., ::-1][..., : s.shape[-1]], s**2, atol=1e-10)
        for unitary, k in ((U, m), (V, n)):
            assert unitary.shape == (k, k)
            assert size(unitary @ unitary.conjugate_transpose() - A.matrix(np.eye(k))) < 1e-12


@subcases("constants", ALGEBRAS)
@subcases("values", [[1 + 2j, 3, -1j], [2, 2, 2], [1j, 1j, 5], [0, 0, 1], [1, 1 + 1e-3, 1 - 1e-3]])
def test_known_eigenvalues(constants, values):
    A = QuaternionAlgebra(*constants)
    a, t, _ = map(float, A.constants)
    unit = (A.basis[1] - t / 2) * (1 / (-a - t * t / 4) ** 0.5)
    T = A.matrix(
        [
            [z.real + unit * z.imag if r == s else 0 for s in range(3)]
            for r, z in enumerate(map(complex, values))
        ]
    )
    U = random(A, 3, 3).schur().unitary
    found = (U @ T @ U.conjugate_transpose()).right_eigenvalues()
    wanted = np.array([complex(z.real, abs(z.imag)) for z in map(complex, values)])
    assert np.allclose(np.sort_complex(found.round(9)), np.sort_complex(wanted), atol=1e-7)
    assert np.all(found.imag >= 0)


def test_blocks_that_are_no_sum_of_eigenspaces():
    A = H("RDF")
    M = A.matrix([["i", 1, 0], [0, "i", "j"], [0, 0, "i"]])
    assert np.allclose(M.right_eigenvalues(), 1j, atol=1e-4)
    N = A.matrix([[3, 1], [0, 3]])
    assert np.allclose(N.right_eigenvalues(), 3, atol=1e-7)
    assert (
        size(N.schur().triangular - N) < 1e-12 or abs(N.schur().triangular[0, 1].norm() - 1) < 1e-12
    )


@pytest.mark.parametrize(
    "rows",
    [
        [[1, "i"], ["j", "k"]],
        [[2, 0], [0, 2]],
        [["i", 0], [0, "j"]],
        [["sqrt(2)", "i"], ["-i", 1]],
        [[0, 1, 0], [0, 0, 1], ["j", 0, 0]],
    ],
)
def test_exact_eigenvalues(rows):
    M = H("RR").matrix(rows)
    found, n = M.right_eigenvalues(), len(rows)
    assert len(found) == n
    for z in found:
        ball = z.ball(64).imag
        assert ball >= 0 or ball.contains(0)
        value = CC.zero
        for c in reversed(M.reduced_characteristic_polynomial()):
            value = value * z + CC(c)
        assert CC.is_zero(value)
    near = M.change_ring("RDF").right_eigenvalues()
    exact = [complex(z.ball(64).real.mid(), z.ball(64).imag.mid()) for z in found]
    assert np.allclose(
        np.sort_complex(np.round(exact, 9)), np.sort_complex(near.round(9)), atol=1e-8
    )


def test_what_is_refused(monkeypatch):
    with pytest.raises(UndecidedError, match="change_ring"):
        H("QQ").matrix([[1]]).right_eigenvalues()
    with pytest.raises(CoercionError, match="square"):
        H("RDF").matrix([[1, 2]]).schur()
    with pytest.raises(CoercionError, match="adjoint"):
        H("RDF").matrix([[1, 2]]).polar()
    with pytest.raises(CoercionError, match="zero divisors"):
        QuaternionAlgebra("RDF", 1, -1).matrix([[1]]).svd()
    with pytest.raises(CoercionError, match="Hamilton"):
        QuaternionAlgebra("RR", 1, -1).matrix([[1]]).right_eigenvalues()
    monkeypatch.setattr(
        decompositions.np.linalg, "eigvals", lambda m: np.ones(m.shape[:-1], complex)
    )
    with pytest.raises(UndecidedError, match="rounding"):
        H("RDF").matrix([[5]]).right_eigenvalues()


def test_reflections():
    for v in (RNG.normal(size=(3, 8)) + 1j * RNG.normal(size=(3, 8)), np.eye(8)[[0, 3, 5]] + 0j):
        x = column(v)
        U = beginning_with(x)
        assert np.allclose((U.H @ U).u, np.eye(4))
        assert np.allclose([(U[..., :, :1]).u, U[..., :, :1].v], [x.u, x.v])
    assert isinstance(U, Pair)
