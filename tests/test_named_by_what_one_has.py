"""Objects, texts and lists are taken wherever one of them is; what is typed first is read, or has a hint."""

import pickle

import pytest

import anim
import hfield
from hfield import CC, GF, QQ, H, QuaternionAlgebra, errors, explain, info, prove, ring, verify


@pytest.mark.parametrize(
    "named",
    [(QQ, -1, -11), ("QQ", -1, -11), (-1, -11), ("(-1,-11|QQ)",), ("[-3,-11,1|QQ)",), (11,)],
)
def test_algebras(named) -> None:
    A = QuaternionAlgebra(*named)
    assert A.ring == QQ
    assert A.discriminant() == 11


def test_indefinite_algebras_by_their_discriminant() -> None:
    assert QuaternionAlgebra(6).ramified_places() == (2, 3)
    assert QuaternionAlgebra(1).ramified_places() == ()


def test_algebras_over_the_field_of_their_constants() -> None:
    K = ring("QQ[s]/(s^3-2)")
    assert QuaternionAlgebra(K.gen, -1) == QuaternionAlgebra(K, K.gen, -1)
    assert QuaternionAlgebra(-1, -1) == H(QQ)


@pytest.mark.parametrize(
    "named", [(12,), (0,), (-11,), (GF(9),), (GF(9), 1), (None,), (True,), ("11|",)]
)
def test_what_names_no_algebra(named) -> None:
    with pytest.raises(errors.HFieldError):
        QuaternionAlgebra(*named)


@pytest.mark.parametrize("places", [[11], [11, "inf"], ["inf", 11], ["11", "inf"], (11, "inf")])
def test_ramification(places) -> None:
    A = QuaternionAlgebra.from_ramification("QQ", places)
    assert A.ramified_places() == (11, "inf")
    assert QuaternionAlgebra.from_ramification(QQ, A.ramified_places()) == A


@pytest.mark.parametrize("places", [[2, 3, "inf"], ["inf"], [11, "inf", "inf"]])
def test_places_that_do_not_ramify_alone(places) -> None:
    with pytest.raises(errors.RingError):
        QuaternionAlgebra.from_ramification("QQ", places)


@pytest.mark.parametrize("field", [GF(9), "GF(9)", "GF9"])
def test_fields(field) -> None:
    assert prove("p*q == q*p", field).field == "GF(9)"
    assert explain("theorem-3", field).row.field == "GF(9)"
    assert info(field).algebra == H(GF(9))
    for many in (field, [field], (GF(9), field)):
        assert [row.field for row in verify("theorem-3", field=many).rows] == ["GF(9)"]


@pytest.mark.parametrize("algebra", [H(GF(9)), "H(GF(9))"])
def test_an_algebra_of_a_statement(algebra) -> None:
    assert prove("i*i == -e", algebra=algebra).verdict == "proved"


@pytest.mark.parametrize("given", ["norm(q) == 0", ["norm(q) == 0"], ("N(q) = 0",)])
def test_hypotheses(given) -> None:
    assert prove("q == 0", "RR", given=given).verdict == "proved"


@pytest.mark.parametrize("wrong", [("QQ", "p*q == q*p"), (H(QQ), "p*q == q*p"), (["p*q == q*p"],)])
def test_arguments_in_another_order(wrong) -> None:
    with pytest.raises(errors.NotationError, match="the statement comes first"):
        prove(*wrong)


def test_discriminants() -> None:
    assert info(11).discriminant == info("11").discriminant == 11


def test_elements_are_formatted_and_powers_are_spelled_as_in_python() -> None:
    q = H(QQ)(1, 2, 0, 1)
    assert f"{q:>14}" == f"{q!s:>14}"
    assert f"{q}" == str(q)
    with pytest.raises(errors.CoercionError, match=r"q\*\*2"):
        q ^ 2


def test_an_unknown_claim_shows_the_nearest_five() -> None:
    with pytest.raises(hfield.UnknownClaimError) as error:
        explain("theorme-3")
    assert "theorem-3" in str(error.value)
    assert str(error.value).count(",") == 4


@pytest.mark.parametrize("field", [None, "QQ", "RR", GF(9)])
def test_equal_answers_are_equal(field) -> None:
    one, again = (prove("norm(q) == 0 => q == 0", field) for _ in range(2))
    assert one == again == pickle.loads(pickle.dumps(one))
    assert len({one, again}) == 1
    assert one != prove("p*q == q*p", field)


def test_public_classes() -> None:
    assert hfield.check(prove("p + q == q + p").certificate)
    assert isinstance(QQ, hfield.Ring)
    assert issubclass(hfield.LatticeError, hfield.HFieldError)
    assert len(QuaternionAlgebra(11).maximal_order().class_set()) == 2
    assert isinstance(QuaternionAlgebra(11).maximal_order().class_set(), hfield.ClassSet)
    assert anim.Scene
    assert anim.Film


def test_claims_in_lists() -> None:
    assert (
        verify(["theorem-3", "centre"], field="QQ").rows
        == verify("theorem-3", "centre", field="QQ").rows
    )
    with pytest.raises(errors.HFieldError, match="fields are field="):
        verify("theorem-3", GF(9))


def test_complex_floats_are_told_how_to_be_written() -> None:
    with pytest.raises(errors.CoercionError, match=r"'0 \+ 1\*I'"):
        H(CC)(1j)
    assert H(CC)("0 + 1*I") == H(CC)("I")
