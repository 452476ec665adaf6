"""Matrices and systems as texts: read as printed, and never taken for commutators."""

from random import Random

import pytest

from hfield import CoercionError, H, NotationError, QuaternionAlgebra, UndecidedError, prove, ring
from hfield.matrices.equations import read_equation
from hfield.matrices.texts import read_matrix_equation
from tests.cli.running import run
from tests.subcases import subcases

RINGS = ["QQ", "GF(9)", "QQ(sqrt(2))", "QQ(t)", "RR", "ZZ/6", "QQ[s]/(s^3-2)"]


@pytest.mark.parametrize("name", RINGS)
def test_matrices_and_polynomials_are_read_as_they_are_printed(name):
    A = QuaternionAlgebra(ring(name), -1, 1)
    P = A.polynomials("y")
    for seed in range(4):
        q = [A.random_element(seed + n) for n in range(4)]
        M = A.matrix([q[:2], [q[2], 0]])
        assert A.matrix(str(M)) == A.matrix(repr(M)) == M
        f = P([*q, -1, 1])
        assert P.parse(str(f)) == f
        assert A.matrix(f"{M}^2 - {M}*{M}") == M - M


def test_expressions():
    A = H("QQ")
    _, i, j, k = A.basis
    M, N = A.matrix([[1, i], [j, k]]), A.matrix([[0, 1], [k, 2]])
    assert A.matrix("[[1,i],[j,k]]*[[0,1],[k,2]]") == M @ N
    assert A.matrix("[[1,i],[j,k]]·[[0,1],[k,2]] − i*[[1,i],[j,k]]²") == M @ N - i * M @ M
    assert A.matrix("inv([[1,i],[j,k]])/2") == M.inverse() * A("1/2")
    assert A.matrix("transpose(conj([[1,i],[j,k]]))") == M.conjugate_transpose()
    assert A.matrix("[[[i,j], 2i], [(1+i)*j, norm(1+i)]]") == A.matrix([[2 * k, 2 * i], [j + k, 2]])
    assert H("QQ(sqrt(2))").matrix("[[sqrt(2)]]*sqrt(2)") == H("QQ(sqrt(2))").matrix([[2]])


@subcases(
    "text",
    ["", "i", "[1,i]", "[[1,i],j]", "[[1,i", "[[1,i],[j,k]]+1", "[[1]]/[[1]]", "[[[1,i],[j,k]]]", "[[]]",
     "[[1,],[2,3]]", "[[1,i],[j,k]][0]", "[[x]]", "[[1,i],[j]]", "[[1)]]", "sqrt([[1]])"],
)  # fmt: skip
def test_what_is_no_matrix(text):
    with pytest.raises((NotationError, CoercionError)):
        H("QQ").matrix(text)


@pytest.mark.parametrize("text", ["[[1,i],[j,k]]", "[ [i,j] , [j,k] ]+1", "[[1,i]]", "i*[[1],[2]]"])
def test_what_may_be_a_matrix_is_no_commutator(text, capsys):
    with pytest.raises(NotationError, match=r"comm\(.*A.matrix"):
        H("QQ")(text)
    with pytest.raises(NotationError, match=r"comm\("):
        prove(f"{text} == 0")
    status, out, err = run(capsys, "eval", text)
    assert (status, out) == (2, "")
    assert "hfield matrix" in err


def test_what_is_a_commutator():
    A = H("QQ")
    i, j, k = A.basis[1:]
    assert A("comm([i,j],[j,k])") == (2 * k) * (2 * i) - (2 * i) * (2 * k)
    assert A("[[i,j],j]") == (2 * k) * j - j * (2 * k)
    assert A("[[i,j]², [j,k]]") == 0
    assert A("[[i,j]*j, [j,k]]") == (2 * k * j) * (2 * i) - (2 * i) * (2 * k * j)
    shown = prove("comm([p,q],[r,u]) == comm([p,q],[r,u])").statement
    assert prove(str(shown))


@pytest.mark.parametrize("field", ["QQ", "GF(7)", "QQ(sqrt(5))", "GF(2)"])
def test_systems(field):
    A, rng, kinds = QuaternionAlgebra(field, -1, -1), Random(2), set()
    words = [
        "i*x",
        "x*j",
        "conj(x)",
        "y*k",
        "k*y*i",
        "trace(y)",
        "[i, x]",
        "x",
        "-y",
        "vector(x)*(1+j)",
    ]
    for _ in range(12):
        sides = [" + ".join([*rng.sample(words, 3), "x - x + y - y"]) for _ in range(2)]
        right = [A(*(rng.randint(-2, 2) for _ in range(4))) for _ in sides]
        texts = [f"{s} = {r}" for s, r in zip(sides, right, strict=True)]
        found = A.solve(*texts)
        kinds.add(bool(found))
        one = A.solve(*texts, unknowns="y, x")
        assert bool(one) == bool(found)
        homogeneous = [f"{s} = 0" for s in sides]
        if not found:
            assert "the right sides" in found.reason
            assert len(found.functional) == 8
            continue
        for v, equations in ((found.particular, texts), *((v, homogeneous) for v in found.kernel)):
            for text in equations:
                put = text.replace("x", f"({v['x']})").replace("y", f"({v['y']})")
                left, value = put.split("=")
                assert A(left) == A(value), text
    assert True in kinds


def test_a_system_of_one_equation_is_the_equation():
    A = H("QQ")
    text = "i*x - x*j = i - j"
    found, one = A.solve(text), read_equation(A, text)
    assert found.particular == {"x": one.particular}
    assert found.kernel == tuple({"x": q} for q in one.kernel)
    assert A.solve("2*q = i", unknowns="q").particular == {"q": A("i/2")}


@pytest.mark.parametrize(
    ("texts", "unknowns", "match"),
    [
        (["i*x = 1", "x*y = 1"], None, "not linear"),
        (["i*x = 1"], "x,y", "does not occur"),
        (["i*x = 1"], "x,x", "twice"),
        (["i*j = 1"], "i", "name the unknown otherwise"),
        (["i*x"], None, "one ="),
        ([], None, "expected equations"),
        (["i = 1"], None, "expected equations"),
    ],
)
def test_what_is_no_system(texts, unknowns, match):
    with pytest.raises(NotationError, match=match):
        H("QQ").solve(*texts, unknowns=unknowns)
    with pytest.raises(UndecidedError):
        H("ZZ").solve("2*x = 1")


@pytest.mark.parametrize("field", ["QQ", "GF(7)", "QQ(sqrt(5))"])
def test_equations_with_a_matrix(field):
    A = H(field)
    M = A.matrix("[[1,i],[j,j*i]]")
    found = read_matrix_equation(A, "[[1,i],[j,j*i]]*x = [1, j]")
    assert M @ found.particular == A.matrix([[1], ["j"]])
    assert found.kernel
    assert all(M @ v == A.matrix([[0], [0]]) for v in found.kernel)
    found = read_matrix_equation(A, "[1, i] = z * [[1,i],[j,j*i]]", "z")
    assert found.particular @ M == A.matrix([[1, "i"]])
    assert all(v @ M == A.matrix([[0, 0]]) for v in found.kernel)
    found = read_matrix_equation(A, "x*[[1,i],[j,j*i]] = [1, 0]")
    assert not found
    assert "M·y = 0" in found.reason
    assert not read_matrix_equation(A, "[[1,i],[j,j*i]]*x = [1, 0]")
    for text in ("[[1]]*x*[[1]] = [1]", "x = [[1]]", "[[1]]*x", "[[1]] = [[2]]", "x*[[1]] = x"):
        with pytest.raises(NotationError, match="an equation with a matrix"):
            read_matrix_equation(A, text)


def test_commands(capsys):
    status, out, _ = run(capsys, "matrix", "[[2,i],[-i,1]]")
    assert status == 0
    assert "signature" in out
    assert "[[1, -i], [i, 2]]" in out
    status, out, _ = run(capsys, "matrix", "[[1,i],[j,j*i]]", "--format", "json")
    assert '"right_kernel": "(-i, 1)"' in out
    for field in ("RDF", "RR", "ZZ6", "GF7", "GF4"):
        assert run(capsys, "matrix", "[[1,i],[j,k]]", "--field", field)[0] == 0
    assert r"\begin{pmatrix}" in run(capsys, "matrix", "[[1,i]]", "--format", "latex")[1]
    assert (
        run(capsys, "solve", "[[1,i],[j,k]]*y = [i,j]")[1] == "y = [[1/2 + 1/2*i], [1/2 + 1/2*i]]\n"
    )
    assert run(capsys, "solve", "i*x + y = j; x - y*j = k")[0] == 1
    status, out, _ = run(capsys, "solve", "i*x + y = j; x - y*i = 0")
    assert out.splitlines()[:2] == ["x = -1/2*k", "y = 1/2*j"]
