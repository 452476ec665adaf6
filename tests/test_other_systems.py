"""What Magma, Sage and PARI write of algebras is read, and what is written for them they read."""

import pytest

from hfield import H, QuaternionAlgebra, RingError
from tests.subcases import subcases

ALGEBRAS = [
    ("QQ", -1, -1),
    ("QQ", "2/3", -5),
    ("QQ(sqrt(5))", "1+sqrt(5)", "-1/2"),
    ("QQ[s]/(s^3-2)", "s^2-1/2", "-s"),
    ("QQ(zeta5)", "zeta5+1", -1),
]


@subcases("named", ALGEBRAS)
@subcases("system", ["Magma", "sage", "pari"])
def test_there_and_back(named, system):
    A = QuaternionAlgebra(*named)
    B = QuaternionAlgebra(A.text_for(system))
    if named[0] == "QQ":
        assert B.is_isomorphic(A)
    assert B.ring.degree == A.ring.degree
    assert len(B.ramified_places()) == len(A.ramified_places())


@pytest.mark.parametrize(
    ("text", "algebra"),
    [
        ("QuaternionAlgebra< RationalField() | -1, -3 >", "(-1,-3|QQ)"),
        ("QuaternionAlgebra<GF(7)|3,5>", "(3,5|GF(7))"),
        ("QuaternionAlgebra(GF(7), 3, 5)", "(3,5|GF(7))"),
        ("K.<a> = NumberField(x^2-5); QuaternionAlgebra(K, a, -1)", "(s,-1|QQ[s]/(s^2-5))"),
        ("alginit(nfinit(y^2-5), [-1, y])", "(-1,s|QQ[s]/(s^2-5))"),
    ],
)
def test_read(text, algebra):
    assert QuaternionAlgebra(text) == QuaternionAlgebra(algebra)


@pytest.mark.parametrize("named", ALGEBRAS, ids=lambda named: named[0])
def test_pari_reads_it(named):
    pari = pytest.importorskip("cypari", reason="PARI is not installed").pari
    A = QuaternionAlgebra(*named)
    theirs = pari(A.text_for("pari"))
    assert len(pari.algramifiedplaces(theirs)) == len(A.ramified_places())


def test_what_is_not_written():
    for A in (QuaternionAlgebra("[1,1|GF(2))"), H("QQ(x)"), H("QQ(sqrt(2),sqrt(3))")):
        with pytest.raises(RingError, match="is not written"):
            A.text_for("magma")
    with pytest.raises(RingError, match="magma, sage, pari"):
        H("QQ").text_for("maple")
