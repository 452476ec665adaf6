"""Elements, lattices, orders and ideals as text: written, read back, read by PARI and Sage, and refused."""

import random
import re
from fractions import Fraction
from functools import cache
from typing import Any

import pytest

from hfield import (
    QQ,
    H,
    Ideal,
    Lattice,
    MixedParentsError,
    NotationError,
    Order,
    QuaternionAlgebra,
    RingError,
)
from hfield.errors import CoercionError

ALGEBRAS = {
    "QQ": QuaternionAlgebra("QQ", -1, -11),
    "fractions": QuaternionAlgebra("QQ", "-2/3", "5/2"),
    "quadratic": QuaternionAlgebra("QQ(sqrt(5))", "1/2+1/2*sqrt(5)", "-1/2"),
    "cubic": QuaternionAlgebra("QQ[s]/(s^3-2)", "s", -1),
    "cyclotomic": QuaternionAlgebra("QQ(zeta5)", -1, "zeta5+1"),
}
SYSTEMS = "sage", "Magma", "pari"


def element(A: Any, rng: random.Random) -> Any:
    gen = A.ring(1) if A.ring == QQ else A.ring.gen
    numbers = [Fraction(rng.randint(-9, 9), rng.choice((1, 2, 3))) for _ in "wxyz"]
    return A(*(gen * rng.randint(0, 1) + A.ring(x) for x in numbers))


@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("name", ALGEBRAS)
def test_there_and_back(name: str, system: str) -> None:
    A = ALGEBRAS[name]
    rng = random.Random(1)
    for _ in range(3):
        q = element(A, rng)
        assert A.read(q.text_for(system)) == q
    if name == "cyclotomic":
        return
    O = A.maximal_order()
    if (name, system) == ("fractions", "sage"):
        with pytest.raises(RingError, match="Sage has lattices in algebras with integers"):
            O.text_for(system)
        return
    found = A.read(O.text_for(system))
    assert found == O
    assert system == "pari" or type(found) is Order
    values = [2 * O, O.left_ideal([3, A.i]), O.right_ideal([3, "1+i"]), O.two_sided_ideal([2])]
    for value in values:
        if system == "sage" and name != "QQ":
            with pytest.raises(RingError, match="not written for Sage"):
                value.text_for(system)
            continue
        found = A.read(value.text_for(system))
        assert found == value
        if system != "pari" and isinstance(value, Ideal):
            assert isinstance(found, Ideal)
            assert found.side == value.side
            assert found.order == O


@pytest.mark.parametrize("system", SYSTEMS)
def test_class_sets_are_lists_of_ideals(system: str) -> None:
    C = QuaternionAlgebra(37).maximal_order().class_set()
    found = C.order.algebra.read(C.text_for(system))
    assert found == list(C)
    assert [C.index(I) for I in found] == [0, 1, 2]


PRINTED_BY_SAGE = (
    "Order of Quaternion Algebra (-1, -11) with base ring Rational Field\n"
    " with basis (1/2 + 1/2*j, 1/2*i + 1/2*k, j, k)"
)
ROWS = [
    "[[1/2, 0, 1/2, 0], [0, 1/2, 0, 1/2], [0, 0, 1, 0], [0, 0, 0, 1]]",
    "[1/2   0 1/2   0]\n[  0 1/2   0 1/2]\n[  0   0   1   0]\n[  0   0   0   1]",
    "[1/2, 0, 1/2, 0; 0, 1/2, 0, 1/2; 0, 0, 1, 0; 0, 0, 0, 1]",
    "1/2 0 1/2 0\n0 1/2 0 1/2\n0 0 1 0\n0 0 0 1\n",
    "1/2, 0, 1/2, 0\n0, 1/2, 0, 1/2\n0, 0, 1, 0\n0, 0, 0, 1",
    "[ 1/2 + 1/2*j, 1/2*i + 1/2*k, j, k ]",
    "(1/2 + 1/2*j, 1/2*i + 1/2*k, j, k)",
]


def test_what_other_systems_print() -> None:
    A = ALGEBRAS["QQ"]
    O = A.maximal_order()
    assert A.read(PRINTED_BY_SAGE) == O
    assert isinstance(A.read(PRINTED_BY_SAGE), Order)
    for text in ROWS:
        found = A.read(text)
        assert type(found) is Lattice, text
        assert found == O
    ideal = A.read("Fractional ideal (4, 4*i, 2 + 2*j, 2*i + 2*k)")
    assert isinstance(ideal, Ideal)
    assert ideal == 4 * O
    pair = A.read("(Fractional ideal (4, 4*i, 2 + 2*j, 2*i + 2*k), Fractional ideal (1, i, j, k))")
    assert pair == [4 * O, A.lipschitz_order()]
    assert A.read("B.<u,v,w> = QuaternionAlgebra(-1, -11); B.quaternion_order([1, u, v, w])") == (
        A.lipschitz_order()
    )
    session = (
        "B<i,j> := QuaternionAlgebra<Rationals() | -1, -11>;\n"
        "O := QuaternionOrder([1, i, (1+j)/2, (i+i*j)/2]);\n"
    )
    assert A.read(session) == O
    for text in (
        "1 + 2*i - k/2",
        "[1, 2, 0, -1/2]",
        "(1, 2, 0, -1/2)",
        "[Mod(1+2*x, x^2+1), 1/2*x]~",
    ):
        assert A.read(text) == A(1, 2, 0, Fraction(-1, 2))


def test_the_generator_has_the_name_that_the_text_gives_it() -> None:
    A = H("QQ(sqrt(2))")
    q = A(A.ring.gen, 0, 1, "1/2")
    for text in (
        "K.<a> = NumberField(x^2 - 2); QuaternionAlgebra(K, -1, -1)([a, 0, 1, 1/2])",
        "K.1 + j + 1/2*k",
        "s + j + 1/2*k",
        "A![L.1, 0, 1, 1/2] where A is QuaternionAlgebra<L | -1, -1> "
        "where L is NumberField(Polynomial([-2, 0, 1]))",
        "K.1 + A.2 + 1/2*A.3 where A is QuaternionAlgebra<K | -1, -1> "
        "where K is NumberField(Polynomial([-2, 0, 1]))",
    ):
        assert A.read(text) == q
    printed = (
        "Order of Quaternion Algebra (-1, -1) with base ring Number Field in b with defining polynomial "
        "x^2 - 2 with b = 1.414213562373095? with basis (1, i, j, k)"
    )
    assert A.read(printed) == A.order(["i", "j"])


MISTAKES = [
    ("", "empty text", 1),
    ("1 + i*m", "'m' means nothing", 7),
    ("[1, i, j, k", "lacks its ']'", 1),
    ("[1, i, j, k]]", "brackets do not match", 13),
    ("[[1, 0, 0], [0, 1, 0, 0]]", "expected four coordinates here, found 3", 2),
    ("[1, i, j, 1/2 + q]", "'q' means nothing", 17),
    ("[1, i, j, i + j]", "rank 3", 1),
    ("[1, i/0, j, k]", "cannot invert 0", 5),
    ("[]", "empty list", 1),
    (PRINTED_BY_SAGE.replace("1/2*k", "1/2*n"), "'n' means nothing", 107),
    (PRINTED_BY_SAGE.replace("1/2*k", "1/3*k"), "is not an order", 82),
    ("QuaternionAlgebra(QQ, -1, -11)", "names an algebra", 1),
    ("QuaternionAlgebra(QQ, -1, -11).maximal_order()", "maximal_order is not read", 1),
    ("QuaternionAlgebra(QQ, -1, -11).quaternion_order([1, i, j])", "four elements", 49),
    ("A![1, 2, 3, 4]", "without a definition", 1),
    ("[x, 1, 0]~", "two entries", 1),
    ("1 + B.2", "B.2 is not a generator", 5),
    ("x = 3; y; 1", "expected a definition", 8),
    ("[1, Fractional ideal (1, i, j, k)]", "an element in a list", 2),
    ("[" * 3000 + "]" * 3000, "nests deeper than 100 levels", 101),
    ("B.<i,i,k> = QuaternionAlgebra(QQ, -1, -11); i", "three different names", 4),
    ("B.<x,y,z,w> = QuaternionAlgebra(QQ, -1, -11); w", "three different names", 4),
]


@pytest.mark.parametrize(("text", "words", "place"), MISTAKES)
def test_what_cannot_be_read_is_named_with_its_position(text: str, words: str, place: int) -> None:
    with pytest.raises(NotationError, match=re.escape(words)) as caught:
        ALGEBRAS["QQ"].read(text)
    assert caught.value.position == place - 1
    assert f"at character {place} of" in str(caught.value)


def test_long_chains_of_definitions_are_refused() -> None:
    chain = ";".join(["a0 = i", *(f"a{n + 1} = a{n}" for n in range(2000)), "a2000"])
    with pytest.raises(NotationError, match="nests deeper"):
        ALGEBRAS["QQ"].read(chain)


def test_a_text_about_another_algebra_says_so() -> None:
    A, B, K = ALGEBRAS["QQ"], QuaternionAlgebra("QQ", -1, -1), H("QQ(sqrt(2))")
    q = B("1 + i")
    for text in (
        q.text_for("sage"),
        q.text_for("magma"),
        B.maximal_order().text_for("magma"),
        PRINTED_BY_SAGE.replace("-11", "-1"),
        "B.<i,j,k> = QuaternionAlgebra(QQ, -1, -1); 1 + i",
        "B<i,j,k> := QuaternionAlgebra<Rationals() | -1, -1>; [1, i, j, k]",
    ):
        with pytest.raises(
            MixedParentsError, match=r"about \(-1,-1\|QQ\), and not about \(-1,-11\|QQ\)"
        ):
            A.read(text)
    for text in (K(1).text_for("sage"), K(1).text_for("magma")):
        with pytest.raises(MixedParentsError, match="the field QQ"):
            B.read(text)
        with pytest.raises(MixedParentsError, match="the field QQ"):
            H("QQ(sqrt(3))").read(text)
    root = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    assert root.read("[Mod(Mod(y, y^2 - 5)*x, x^2 + 1), 0]~") == root(root.ring.gen) * root.i
    for foreign in ("[Mod(y, y^2 - 2), 0]~", "[Mod(x, x^2 + 3), 0]~", "Mod(3, 7)"):
        with pytest.raises(MixedParentsError, match="residue"):
            root.read(foreign)
    with pytest.raises(MixedParentsError, match="over GF"):
        H("GF(7)").read(H("GF(5)")(1).text_for("sage"))


def test_what_is_not_written() -> None:
    with pytest.raises(CoercionError, match="one element"):
        H("RDF")([1, 2], 0, 0, 0).text_for("sage")
    with pytest.raises(RingError, match="magma, sage, pari"):
        ALGEBRAS["QQ"].maximal_order().text_for("maple")
    assert H("GF(7)").read(H("GF(7)")(1, 2, 3, 4).text_for("magma")) == H("GF(7)")(1, 2, 3, 4)


# --- live -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ALGEBRAS)
def test_pari_multiplies_as_we_do(name: str) -> None:
    pari = pytest.importorskip("cypari", reason="PARI is not installed").pari
    A, rng = ALGEBRAS[name], random.Random(3)
    theirs = pari(A.text_for("pari"))
    for _ in range(3):
        p, q = element(A, rng), element(A, rng)
        product = pari.algmul(theirs, pari(p.text_for("pari")), pari(q.text_for("pari")))
        assert A.read(str(product)) == p * q
        assert pari.algalgtobasis(theirs, product) == pari.algalgtobasis(
            theirs, pari((p * q).text_for("pari"))
        )


@cache
def sage() -> Any:
    """A function that evaluates code of Sage."""
    everything = pytest.importorskip(
        "sage.all__sagemath_schemes",
        reason="Sage is not installed (passagemath-schemes of extra 'peers')",
    )
    preparse = pytest.importorskip(
        "sage.repl.preparse", reason="passagemath-repl is not installed"
    ).preparse

    def evaluate(code: str) -> Any:
        names = dict(vars(everything))
        *statements, last = code.split(";")
        for statement in statements:
            exec(preparse(statement.strip()), names)
        return eval(preparse(last.strip()), names)

    return evaluate


def test_sage_reads_it_and_what_sage_prints_is_read() -> None:
    rng = random.Random(4)
    for name, A in ALGEBRAS.items():
        p, q = element(A, rng), element(A, rng)
        assert A.read(str(sage()(p.text_for("sage")))) == p
        if name in ("QQ", "fractions"):
            assert A.read(str(sage()(p.text_for("sage")) * sage()(q.text_for("sage")))) == p * q
        if name == "fractions":
            continue
        O = A.maximal_order()
        theirs = sage()(O.text_for("sage"))
        assert A.read(str(theirs)) == O
        if name != "QQ":
            continue
        assert theirs.discriminant() == O.discriminant()
        for I in (O.left_ideal([3, A.i]), O.right_ideal([3, A.i]), O.two_sided_prime(11), 2 * O):
            found = sage()(I.text_for("sage"))
            assert A.read(str(found)) == I
            assert A.read(str(found.left_order())) == I.left_order()
            assert A.read(str(found.basis_matrix())) == I
    C = QuaternionAlgebra(37).maximal_order().class_set()
    assert C.order.algebra.read(str(sage()(C.text_for("sage")))) == list(C)
