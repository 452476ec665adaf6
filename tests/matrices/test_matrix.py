"""Matrices over quaternion algebras: against the regular representation, brute force and identities."""

import json
from fractions import Fraction
from itertools import product
from random import Random

import flint
import pytest

from hfield import (
    CoercionError,
    H,
    MixedParentsError,
    NoSolutionError,
    NotationError,
    NotInvertibleError,
    QuaternionAlgebra,
)
from hfield.matrices.equations import read_equation
from tests.cli.running import run
from tests.subcases import subcases

ALGEBRAS = [
    *(
        "(-1,-1|QQ)",
        "(-1,-1|GF(7))",
        "(-1,-1|GF(9))",
        "(-1,-1|QQ(sqrt(-7)))",
        "(-1,-1|QQ(x))",
        "(-1,-1|GF(2))",
    ),
    *("[1,1|GF(4))", "(0,0|GF(3))", "(0,-1|QQ)", "(1,1|QQ)", "[1,t|GF(2)(t))"),
]


def random_matrix(A, rows, columns, rng, small=True):
    def entry():
        if small:
            return A(*(rng.choice((0, 0, 1, -1, 2)) for _ in range(4)))
        return A.random_element(rng.randrange(10**6))

    return A.matrix([[entry() for _ in range(columns)] for _ in range(rows)])


def dot(row, column):
    return sum((x * y for x, y in zip(row[1:], column[1:], strict=True)), row[0] * column[0])


@subcases("text", ALGEBRAS)
def test_identities(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(text)
    F = A.ring
    for n in (1, 2, 3):
        M, N = random_matrix(A, n, n, rng), random_matrix(A, n, n, rng)
        norm = M.reduced_norm()
        assert F.equal((M @ N).reduced_norm(), norm * N.reduced_norm())
        polynomial = M.reduced_characteristic_polynomial()
        assert F.equal(polynomial[0], norm)
        value = M - M
        for c in reversed(polynomial):
            value = M @ value + M**0 * c
        assert value == M - M
        assert (M @ N).conjugate_transpose() == N.conjugate_transpose() @ M.conjugate_transpose()
        if M.is_invertible():
            assert M @ M.inverse() == M**0 == M.inverse() @ M
            assert M**-2 @ M**2 == M**0
        else:
            with pytest.raises(NotInvertibleError, match=r"y·M = 0"):
                M.inverse()
            (y, *_) = M.left_kernel()
            assert any(y)


@subcases("text", ALGEBRAS)
def test_kernels_and_solutions(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(text)
    for m, n in ((1, 2), (2, 2), (3, 2)):
        M = random_matrix(A, m, n, rng)
        for x in M.right_kernel():
            assert not any(dot(row, x) for row in M.rows)
        for y in M.left_kernel():
            assert not any(dot(y, column) for column in M.T.rows)
        x = random_matrix(A, n, 2, rng)
        assert M @ M.solve(M @ x) == M @ x
        b = random_matrix(A, m, 1, rng)
        try:
            assert M @ M.solve(b) == b
        except NoSolutionError as error:
            y = error.witness
            assert not any(dot(y, column) for column in M.T.rows)
            assert dot(y, b.T.rows[0])


@pytest.mark.parametrize("text", ["(-1,-1|GF(2))", "[1,1|GF(2))", "(0,0|GF(2))", "(1,0|GF(3))"])
def test_kernels_generate_all_by_brute_force(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(text)
    everything = list(A.elements())
    for _ in range(3):
        M = random_matrix(A, 1, 2, rng)
        pairs = [(x, y) for x, y in product(everything, repeat=2) if not dot(M.rows[0], (x, y))]
        made = {(A.zero, A.zero)}
        for x, y in M.right_kernel():
            made = {(u + x * q, v + y * q) for u, v in made for q in everything}
        assert made == set(pairs)
        size = A.ring.order
        assert size ** int(4 * (2 - M.rank())) == len(pairs)


def test_against_the_regular_representation():
    A, rng = H("QQ"), Random(5)
    for n in (2, 5, 12):
        M = random_matrix(A, n, n, rng, small=False)
        blocks = [[q.matrix() for q in row] for row in M.rows]
        flat = flint.fmpq_mat([[x for b in row for x in b[r]] for row in blocks for r in range(4)])
        assert flat.det() == M.reduced_norm() ** 2
        assert Fraction(flat.rank(), 4) == M.rank()
    column = A.matrix([[A.random_element(n)] for n in range(4)])
    assert (column @ column.conjugate_transpose()).rank() == 1
    assert len((column @ column.conjugate_transpose()).right_kernel()) == 3


def test_one_entry_is_an_element():
    for text in ALGEBRAS:
        A = QuaternionAlgebra.from_text(text)
        q = A(1, 1, 0, 1)
        assert A.ring.equal(A.matrix([[q]]).reduced_norm(), q.norm())


def test_over_rings_that_are_no_fields():
    A = H("ZZ/6")
    M = A.matrix([["2", "3"], ["3", "2"]])
    assert M.is_invertible()
    assert M @ M.inverse() == M**0
    assert M @ M.solve(["i", "j"]) == A.matrix([["i"], ["j"]])
    with pytest.raises(NotInvertibleError, match="is not a unit of ZZ/6"):
        A.matrix([["2"]]).inverse()
    assert not H("ZZ").matrix([["2"]]).is_invertible()


def test_arrays_as_entries():
    A, rng = H("GF(7)"), Random(1)
    many = [random_matrix(A, 2, 2, rng) for _ in range(10)]
    other = [random_matrix(A, 2, 2, rng) for _ in range(10)]

    def stacked(matrices):
        return A.matrix(
            [
                [
                    A(*map(list, zip(*(M[r, c].coordinates for M in matrices), strict=True)))
                    for c in (0, 1)
                ]
                for r in (0, 1)
            ]
        )

    assert stacked(many) @ stacked(other) == stacked(
        [M @ N for M, N in zip(many, other, strict=True)]
    )
    for method in ("rank", "inverse", "right_kernel", "left_kernel", "echelon_form"):
        with pytest.raises(CoercionError, match="single quaternions"):
            getattr(stacked(many), method)()


def test_elements_multiply_on_their_side():
    A = H("QQ")
    _, i, j, k = A.basis
    M = A.matrix([[1, j]])
    assert (i * M, M * i) == (A.matrix([[i, k]]), A.matrix([[i, -k]]))
    assert 2 * M == M * 2 == M + M


def test_linear_equations():
    A = QuaternionAlgebra("QQ", -1, -3)
    _, i, j, k = A.basis
    found = A.solve_linear([(i, j), (1, k), (j + 1, 1)], 5)
    x = found.particular
    assert i * x * j + x * k + (j + 1) * x == 5
    for y in found.kernel:
        assert i * y * j + y * k + (j + 1) * y == 0
    refused = A.sylvester(i, i, 1)
    assert not refused
    assert refused.particular is None
    assert "for every x" in refused.reason


def test_what_is_refused():
    A = H("QQ")
    for rows in ([], [[]], [[1, 2], [3]], "i", [1, 2], ["ij"]):
        with pytest.raises((CoercionError, NotationError)):
            A.matrix(rows)
    M = A.matrix([[1, 2]])
    with pytest.raises(CoercionError, match="M @ N"):
        M * M
    with pytest.raises(CoercionError, match="do not multiply"):
        M @ M
    with pytest.raises(CoercionError, match="square"):
        M.reduced_norm()
    with pytest.raises(MixedParentsError):
        M + H("GF(3)").matrix([[1, 2]])


@pytest.mark.parametrize("field", ["QQ", "GF(7)", "RR", "QQ(sqrt(5))"])
def test_equations_that_are_read(field):
    A = H(field)
    _, i, j, k = A.basis
    found = read_equation(A, "i*x - conj(x)*j/2 + trace(x)*(1+k)**2 = x*k + 3")
    assert found
    for x in (found.particular, *(found.particular + y for y in found.kernel)):
        assert i * x - x.conjugate() * j / 2 + A.scalar(x.trace()) * (1 + k) ** 2 == x * k + 3


@pytest.mark.parametrize(
    "text", ["x*x = 1", "x", "1 = 2", "1/x = 2", "x = y", "norm(x) = 1", "x == 1 == 2"]
)
def test_equations_that_are_refused(text):
    with pytest.raises(NotationError):
        read_equation(H("QQ"), text)


def test_the_command_solves(capsys):
    status, out, _ = run(capsys, "solve", "i*x - x*j == i - j")
    assert (status, out.splitlines()[0][:4]) == (0, "x = ")
    status, out, _ = run(capsys, "solve", "i*x - x*j == k", "--format", "json")
    assert status == 1
    assert json.loads(out)["particular"] is None
