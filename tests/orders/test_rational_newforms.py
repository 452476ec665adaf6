"""Rational newforms by Lanczos' recurrence, against those of dense matrices and known elliptic curves."""

from typing import Any

import numpy as np
import pytest

from hfield import LatticeError, QuaternionAlgebra, UndecidedError
from hfield.core import lanczos
from hfield.core.lanczos import PRIME, SparseOperator, echelon, eigenvectors, lifted, recurrence
from hfield.orders import rational_newforms as module

A: Any = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)


def described(forms: Any) -> list[tuple[list[str], list[str]]]:
    """The first eigenvalues and the signs of newforms, in an order that does not depend on theirs."""
    pairs = ((f.eigenvalues(6), f.signs) for f in forms)
    return sorted((sorted(map(str, a.items())), sorted(map(str, w.items()))) for a, w in pairs)


@pytest.mark.parametrize(
    ("algebra", "level"),
    [(QuaternionAlgebra(37), 1), (QuaternionAlgebra(11), 14)]
    + [(A, [(P, 1)]) for P in A.ring.primes_above(31)[:1]],
)
def test_those_of_dense_matrices(algebra: Any, level: Any) -> None:
    C = algebra.eichler_order(level).class_set()
    found = C.rational_newforms()
    assert described(found) == described(f for f in C.newforms() if f.degree == 1)
    P = next(iter(found[0].eigenvalues(1)))
    for f in found:
        assert C.hecke_operator(P, f.values) == [f[P] * x for x in f.values]


@pytest.mark.parametrize(
    ("p", "values"),
    [
        (307, [(0, 0, 4), (1, 2, 0), (2, 0, 2), (2, 2, 0)]),
        (113, [(-1, 2, 2)]),
        (571, [(-2, -2, -2), (0, 2, -2)]),
    ],
)
def test_several_forms_with_one_eigenvalue(p: int, values: list[tuple[int, int, int]]) -> None:
    """Two curves of conductor 307 have a₂ = 2 (Cremona); at 113 and 571 other forms have a rational a₂."""
    forms = QuaternionAlgebra(p).maximal_order().class_set().rational_newforms()
    assert sorted((f[2], f[3], f[5]) for f in forms) == values
    assert all(f[p] == -f.signs[p] for f in forms)


def operator(matrix: list[list[int]], weights: list[int]) -> SparseOperator:
    table = np.array(matrix)
    columns = np.broadcast_to(np.arange(len(table))[:, None], table.shape)
    return SparseOperator(columns, table.T.copy(), np.array(weights))


def test_the_recurrence_finds_eigenvalues_and_bounds_the_rest() -> None:
    basis = [[1, 1, 1, 1], [1, -1, 0, 0], [1, 1, -2, 0], [1, 1, 1, -3]]
    values = [3, -2, -2, 5]  # of orthogonal vectors
    lengths = [4, 2, 6, 12]
    whole = sum(
        a * 12 // n * np.outer(v, v) for a, n, v in zip(values, lengths, basis, strict=True)
    )
    T = operator(whole.tolist(), [1] * 4)
    assert T.is_self_adjoint()
    start = np.array([5, 7, 1, 11])
    found = recurrence(T, start)
    roots = [a for a in range(-99, 100) if not found.polynomials(a)[-1]]
    assert (len(found), roots) == (3, [-24, 36, 60])  # of dimension 4: one eigenvalue comes twice
    vectors = eigenvectors(T, start, found, roots)
    for a, vector in zip(roots, vectors, strict=True):
        assert np.array_equal(T.times(vector) % PRIME, a * vector % PRIME)
    basis_, pivots = echelon(vectors[1:2])
    lift = lifted(T, basis_[0], 36)
    assert lift is not None
    assert pivots == [0]
    assert lift.tolist() == [1, 1, 1, 1]
    assert lifted(T, basis_[0], 35) is None


def test_operators_that_are_not_self_adjoint() -> None:
    assert operator([[0, 2], [3, 1]], [3, 2]).is_self_adjoint()
    assert not operator([[0, 2], [3, 1]], [1, 1]).is_self_adjoint()
    isotropic = operator([[0, 1], [-1, 0]], [1, -1])
    with pytest.raises(lanczos.BreakdownError):
        recurrence(isotropic, np.array([1, 1]))


def test_reduction_modulo_the_prime() -> None:
    numbers = np.array([0, 1, PRIME - 1, PRIME, PRIME + 1, PRIME**2, 2**62, 2**63 - 1])
    assert lanczos._reduced(numbers).tolist() == [int(n) % PRIME for n in numbers]


def test_what_is_not_proved_is_not_given(monkeypatch: pytest.MonkeyPatch) -> None:
    C = QuaternionAlgebra(389).maximal_order().class_set()
    monkeypatch.setattr(lanczos, "MAX_LIFTED", 1)
    with pytest.raises(UndecidedError, match="do not prove"):
        C.rational_newforms()
    monkeypatch.undo()
    monkeypatch.setattr(module, "MAX_STARTS", 0)
    with pytest.raises(UndecidedError, match="do not prove"):
        C.rational_newforms()
    for level in (9, 4):
        with pytest.raises(LatticeError, match="squarefree"):
            QuaternionAlgebra(11).eichler_order(level).class_set().rational_newforms()
