"""Hermitian matrices: the form itself, and signs against eigenvalues of complex matrices."""

from random import Random

import numpy as np
import pytest

from hfield import CoercionError, H, QuaternionAlgebra, RingError, UndecidedError, ring


def hermitian(A, n, rng, zeros=0.3):
    def entry():
        return A(*(0 if rng.random() < zeros else rng.randint(-4, 4) for _ in range(4)))

    rows = [[entry() for _ in range(n)] for _ in range(n)]
    for r in range(n):
        rows[r][r] = A.scalar(rng.randint(-1, 1))
        for s in range(r):
            rows[r][s] = rows[s][r].conjugate()
    return A.matrix(rows)


def complex_form(M, value):
    """The hermitian matrix of 2n complex numbers; ``value`` takes scalars to floats, a, b < 0, t = 0."""
    a, _, b = (value(c) for c in M.algebra.constants)
    i, j = (-a) ** 0.5, (-b) ** 0.5
    q = np.array([[[value(x) for x in q.coordinates] for q in row] for row in M.rows])
    u, v = q[..., 0] + 1j * i * q[..., 1], j * (q[..., 2] + 1j * i * q[..., 3])
    return np.block([[u, v], [-v.conj(), u.conj()]])


@pytest.mark.parametrize(
    ("field", "a", "b"),
    [
        ("QQ", -1, -1),
        ("QQ", -2, -5),
        ("QQ", 2, 3),
        ("GF(7)", -1, -1),
        ("GF(9)", -1, "x"),
        ("QQ(sqrt(2))", -1, -3),
        ("QQ(x)", -1, "x"),
        ("RR", -1, -1),
    ],
)
def test_diagonal_forms(field, a, b):
    A, rng = QuaternionAlgebra(field, a, b), Random(3)
    for n in (1, 2, 3, 4, 5):
        M = hermitian(A, n, rng)
        d, P = M.diagonal_form()
        assert P.is_invertible()
        product = P.conjugate_transpose() @ M @ P
        assert product == A.matrix([[d[r] if r == s else 0 for s in range(n)] for r in range(n)])
        assert not any(x.vector_part for x in d)
        assert sum(map(bool, d)) == M.rank()


def test_characteristic_2():
    A = QuaternionAlgebra.from_text("[1,t|GF(2)(t))")
    _, i, j, k = A.basis
    for rows in ([[0, i], [i + 1, 0]], [[j, k], [k, 1]], [[0, i, j], [i + 1, 0, k], [j, k, 0]]):
        M = A.matrix(rows)
        d, P = M.diagonal_form()
        assert P.is_invertible()
        product = P.conjugate_transpose() @ M @ P
        n = len(rows)
        assert product == A.matrix([[d[r] if r == s else 0 for s in range(n)] for r in range(n)])


@pytest.mark.parametrize(
    ("field", "a", "b"), [("QQ", -1, -1), ("QQ", -2, -3), ("QQ(sqrt(2))", -1, "sqrt(2)-2")]
)
def test_signatures_are_those_of_eigenvalues(field, a, b):
    A, rng, seen = QuaternionAlgebra(field, a, b), Random(4), set()

    def terms(x):
        return x.as_surd().terms if hasattr(x, "as_surd") else {1: x}

    def value(x):
        return sum(float(c.p) / float(c.q) * n**0.5 for n, c in terms(x).items())

    for n in (1, 2, 3, 4) * 4:
        N = hermitian(A, n, rng)
        M = N if rng.random() < 0.7 else N.conjugate_transpose() @ N
        found = np.linalg.eigvalsh(complex_form(M, value))
        small = 1e-9 * max(1, abs(found).max())
        signature = M.signature()
        counted = (found > small).sum(), (found < -small).sum(), (abs(found) <= small).sum()
        assert tuple(2 * m for m in signature) == counted
        assert M.is_positive_definite() == (signature.positive == n)
        seen.add(M.is_positive_definite())
    assert seen == {True, False}


def test_orderings():
    A = QuaternionAlgebra("QQ(sqrt(2))", -1, "sqrt(2)-2")
    M = A.matrix([["sqrt(2)", 0], [0, 1]])
    assert M.is_positive_definite(0)
    assert not M.is_positive_definite(1)
    assert M.signature(1) == (1, 1, 0)
    with pytest.raises(RingError, match="ordering"):
        M.signature(2)
    with pytest.raises(RingError, match="both signs"):
        QuaternionAlgebra("QQ", 2, -3).matrix([[1]]).signature()
    assert not QuaternionAlgebra("QQ", 2, -3).matrix([[1]]).is_positive_definite()
    with pytest.raises(RingError, match="ordering"):
        H("GF(7)").matrix([[1]]).signature()
    with pytest.raises(CoercionError, match="hermitian"):
        H("QQ").matrix([["i"]]).signature()
    with pytest.raises(UndecidedError, match="exact"):
        H("RDF").matrix([[1]]).signature()
    assert ring("QQ(x)").orderings.value > 1
    assert QuaternionAlgebra("QQ(x)", -1, "-x").matrix([["x", 0], [0, 1]]).is_positive_definite()
