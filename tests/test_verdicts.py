"""Answers to questions of yes or no: what they say, and that they are true or false."""

import pickle

from hfield import H, QuaternionAlgebra, ring
from hfield.algebra.structure_algebra import StructureAlgebra
from hfield.evidence import CertifiedClaim
from hfield.matrices.texts import read_matrix_equation
from hfield.verdicts import Verdict


def cases() -> list[tuple[Verdict, bool]]:
    """Answers of all kinds, with what they should be."""
    A, K = H("QQ"), ring("QQ(sqrt(-5))")
    order = QuaternionAlgebra(11).maximal_order()
    ideal = list(order.class_set())[1]
    _, i, j, k = A.basis
    return [
        (i.conjugacy(j), True),
        (i.conjugacy(j + k), False),
        (A.embed(-1), True),
        (A.embed(2), False),
        (K.ideal(2, 1 + K.gen).is_principal(), False),
        (K.ideal(1 + K.gen).is_principal(), True),
        (StructureAlgebra("QQ", [["e"]], names="e").is_associative(), True),
        (ideal.is_principal(), False),
        (ideal.equivalence(ideal), True),
        (order.isomorphism(ideal.left_order()), False),
        (A.division_or_splitting(), False),
        (QuaternionAlgebra("QQ", 2, -1).division_or_splitting(), True),
        (A.sylvester(i, j, i - j), True),
        (A.sylvester(i, i, 1), False),
        (A.solve("i*x + y = j", "x - y*i = 1"), False),
        (read_matrix_equation(A, "[[1, i], [j, k]]*x = [i, j]"), True),
    ]


def test_answers_are_verdicts() -> None:
    for found, wanted in cases():
        assert isinstance(found, Verdict)
        assert (found == wanted) is True
        assert bool(found) == found.value == wanted
        assert (found != (not wanted)) is True
        assert wanted or found.reason
        again = pickle.loads(pickle.dumps(found))
        assert again == found
        assert hash(again) == hash(found) == hash(wanted)
        assert found.holds == wanted


def test_verdicts_print_reason_and_witness() -> None:
    A = H("QQ")
    _, i, j, _ = A.basis
    assert repr(A.sylvester(i, i, 0)) == "yes with 0, plus combinations of 1, i"
    assert repr(A.sylvester(i, i, 1)).startswith("no: (1, 0, 0, 0) times")
    assert repr(i.conjugacy(j)).startswith("yes with i + j: ")


def test_verdicts_differ_where_reason_or_witness_do() -> None:
    one = Verdict(True, "seen", 1)
    assert one == Verdict(True, "seen", 1)
    assert one != Verdict(True, "seen", 2)
    assert one != Verdict(True, "heard", 1)
    assert one != "yes"
    assert repr(one) == "yes with 1: seen"
    assert repr(Verdict(False)) == "no"


def test_certificates_are_made_of_claims_on_first_use() -> None:
    calls = []

    def claim() -> CertifiedClaim:
        calls.append(1)
        evidence = {"kind": "class group"}
        return CertifiedClaim("", "class-group{1}", evidence, "class-group", refusal="too large")

    found = Verdict(True, make_claim=claim)
    assert not calls
    assert found.certificate is None
    assert found.claim is found.claim
    assert len(calls) == 1
    assert Verdict(True).certificate is None
