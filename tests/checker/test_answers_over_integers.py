"""Certificates of orders, ideals and answers over number fields: the true ones pass, lies do not."""

import json
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from hfield import QuaternionAlgebra
from hfield.checker.check import ExpectedClaim
from hfield.cli import main
from hfield.evidence import CertifiedClaim
from hfield.orders import certificates
from hfield.verdicts import Verdict
from tests.checker.cases import Certificate
from tests.checker.order_certificates import changed_and_passed, established, rejects
from tests.subcases import first_quick

FIELDS = ("QQ(sqrt(5))", "QQ(sqrt(3))", "QQ[s]/(s^3-4*s-1)")


@cache
def ideals(field: str) -> tuple[Any, ...]:
    """A maximal order, an ideal of it that is not principal if there is one, and an element."""
    A = QuaternionAlgebra(field, -1, -1)
    order = A.maximal_order()
    return order, list(order.class_set())[-1], A(1, 2, 0, 1)


@cache
def genuine(field: str) -> tuple[Certificate, ...]:
    order, ideal, x = ideals(field)
    moved = conjugated(order, x)
    smaller = order.suborders(order.algebra.ring.primes_above(3)[0])[0]
    claims = [
        order.claim, certificates.of_unit_index(order.value, order.unit_index()),
        ideal.claim, ideal.conjugate().claim,
        ideal.is_principal().claim,
        ideal.conjugate().is_principal().claim, ideal.equivalence(x * ideal).claim,
        order.isomorphism(moved).claim,
        order.isomorphism(ideal.left_order()).claim, order.isomorphism(smaller).claim,
    ]  # fmt: skip
    found = [claim.certificate for claim in claims]
    assert None not in found, [claim.why_no_certificate for claim in claims]
    return tuple(data for data in found if data is not None)


def conjugated(order: Any, x: Any) -> Any:
    return (x * order * x.inverse()).left_order()


def equivalence_claim(first: Any, second: Any, element: Any) -> CertifiedClaim:
    """That this element carries one ideal to the other; without one, that none does."""
    result = Verdict(element is not None, "", element)
    return certificates.of_equivalence(first.side, first.value, second.value, None, result)


def isomorphism_claim(first: Any, second: Any, element: Any) -> CertifiedClaim:
    """That this element conjugates one order into the other; without one, that none does."""
    result = Verdict(element is not None, "", element)
    return certificates.of_isomorphism(first.value, second.value, result)


@pytest.mark.slow
@pytest.mark.parametrize("field", FIELDS)
def test_the_true_ones_are_accepted(field: str) -> None:
    verdicts = set()
    for data in genuine(field):
        expected = ExpectedClaim((data["statement"],), data["ring"], data["algebra"])
        assert not established(json.loads(json.dumps(data)), expected).assumptions
        verdicts.add((data["verdict"], data["method"]))
        rejects({**data, "verdict": {"proved": "refuted", "refuted": "proved"}[data["verdict"]]})
        for key in data["evidence"]:
            rejects(
                {**data, "evidence": {k: v for k, v in data["evidence"].items() if k != key}}, "."
            )
        if data["assumes"]:
            rejects({**data, "assumes": []}, "assumes")
    assert ("refuted", "discriminant") in verdicts


@pytest.mark.slow
@pytest.mark.parametrize("field", FIELDS)
def test_what_is_equivalent_is_not_shown_to_be_none(field: str) -> None:
    """The evidence of a false refusal is made as for a true one."""
    order, ideal, x = ideals(field)
    for first, second in ((ideal, x * ideal), (ideal.conjugate(), ideal.conjugate() * x)):
        why = equivalence_claim(first, second, None).why_no_certificate
        assert "lies between" in str(why)
    for P in (order, ideal.left_order()):
        why = isomorphism_claim(P, conjugated(P, x), None).why_no_certificate
        assert "there is an isomorphism" in str(why)
    wrong = equivalence_claim(ideal, x * ideal, x + 1).why_no_certificate
    assert "does not carry" in str(wrong)
    wrong = isomorphism_claim(order, conjugated(order, x), x + 1).why_no_certificate
    assert "does not conjugate" in str(wrong)


@pytest.mark.parametrize("field", first_quick(FIELDS, 1))
def test_no_other_number_passes(field: str) -> None:
    for data in genuine(field):
        word = data["statement"].partition("{")[0]
        if word in ("order-over-integers", "unit-index", "ideal-over-integers"):
            rest, _, n = data["statement"].rpartition("; ")
            for lie in (Fraction(n[:-1]) + 1, 2 * Fraction(n[:-1]), 7):
                if lie != Fraction(n[:-1]):
                    rejects({**data, "statement": f"{rest}; {lie}}}"})


def test_a_quotient_of_norms_with_a_generator_is_found_out() -> None:
    """Over ℚ(√3) the last class has a norm that no totally positive number generates; 1 has another."""
    order, ideal, _ = ideals("QQ(sqrt(3))")
    claim = ideal.is_principal().claim
    assert claim.method == "norm"
    quotient = claim.evidence["quotient"]
    squared = {**claim.evidence, "quotient": [[1, 0], quotient[1]]}
    rejects({**claim.certificate, "evidence": squared}, "another ideal")
    one = order.right_ideal([1])
    lie = equivalence_claim(one, one, None)
    forged = {k: v for k, v in lie.evidence.items() if k not in ("norm", "between")}
    forged["quotient"] = [[1, 0], [0] * len(quotient[1])]
    data = {**claim.certificate, "statement": lie.statement, "evidence": forged}
    rejects(data, "totally positive generator")


def test_what_is_run_through_is_all() -> None:
    """A sublattice has no such element, and an element outside the order no image, though there is one."""
    order, ideal, x = ideals("QQ(sqrt(5))")
    moved = conjugated(order, x)
    lie = established_data(equivalence_claim(ideal, x * ideal, None))
    for key, data in (
        ("between", lie),
        ("order", established_data(isomorphism_claim(order, moved, None))),
    ):
        basis = data["evidence"][key]
        twice = {**basis, "rows": [[2 * c for c in row] for row in basis["rows"]]}
        rejects({**data, "evidence": {**data["evidence"], key: twice}}, "another lattice")
    pair = [{**y, "den": 7 * y["den"]} for y in data["evidence"]["pair"]]
    rejects({**data, "evidence": {**data["evidence"], "pair": pair}}, "elements of the first order")


def test_an_ideal_that_is_not_locally_principal_is_rejected() -> None:
    order, _, _ = ideals("QQ(sqrt(5))")
    smaller = order.suborders(order.algebra.ring.primes_above(3)[0])[0]
    data = order.right_ideal([1]).certificate
    statement = "; ".join(
        [
            f"ideal-over-integers{{{certificates.text(order)}",
            "right",
            certificates.text(smaller),
            "1}",
        ]
    )
    rejects({**data, "statement": statement}, "not locally principal")


def test_norms_that_are_not_totally_positive_need_a_definite_algebra() -> None:
    """√3 generates no ideal with a totally positive generator, and is a norm from M₂(ℚ(√3))."""
    A = QuaternionAlgebra("QQ(sqrt(3))", 1, -1)
    order = A.order(["i", "j"])
    c = A("1/2 + 1/2*sqrt(3)", "1/2*sqrt(3) - 1/2", 0, 0)
    assert c.norm() == A.ring.gen
    one = order.left_ideal([1])
    lie = equivalence_claim(one, order.left_ideal([c]), None)
    assert lie.method == "norm"
    rejects(established_data(lie), "indefinite")


def test_lattices_that_are_compared_are_modules() -> None:
    """A lattice that is none goes into its multiple by a unit u, of norm u², and by no element of norm 1."""
    order, _, _ = ideals("QQ(sqrt(3))")
    basis = ["1,0,0,0", "5*sqrt(3),0,0,0"]
    basis += [f"{'0,' * k}{w}{',0' * (3 - k)}" for k in (1, 2, 3) for w in ("1", "sqrt(3)")]
    moved = ["2+sqrt(3),0,0,0", "15+10*sqrt(3),0,0,0", *basis[2:]]
    one = order.right_ideal([1])
    lie = established_data(equivalence_claim(one, one, None))
    about = f"left; {' | '.join(basis)}; {' | '.join(moved)}"
    rejects({**lie, "statement": f"equivalent-over-integers{{{about}}}"}, "no module")


def test_nothing_is_exhausted_in_an_indefinite_algebra() -> None:
    order, ideal, _ = ideals("QQ(sqrt(5))")
    for claim in (
        certificates.of_unit_index(order.value, order.unit_index()),
        isomorphism_claim(order, ideal.left_order(), None),
    ):
        data = {**established_data(claim), "algebra": "(1,-1|QQ(sqrt(5)))"}
        rejects(data)
    A = QuaternionAlgebra("QQ(sqrt(5))", "sqrt(5)", -1)
    M = A.maximal_order()
    assert M.certificate
    assert M.left_ideal([3]).certificate


def established_data(claim: Any) -> Certificate:
    """The certificate that a claim would have, whatever the checker says."""
    data: Certificate = claim._data
    return data


@pytest.mark.slow
def test_no_number_can_be_changed() -> None:
    """One to three changes anywhere in the evidence: what passes is the statement, which is true."""
    files = (data for field in FIELDS for data in genuine(field))
    tried, passed = changed_and_passed(5, files, 4, millions=3)
    assert passed < tried / 3


@pytest.mark.parametrize(
    "words",
    [
        ["order", "(-1,-1|QQ(sqrt(3)))"],
        ["ideal", "(-1,-1|QQ(sqrt(3)))", "3, 1 + i + j"],
        ["ideal", "(-1,-1|QQ(sqrt(3)))", "3, 1 + i + j", "--principal"],
        ["ideal", "(-1,-1|QQ(sqrt(3)))", "11, 1 + 3*i + j", "--with", "5"],
    ],
)
def test_the_commands_write_them(tmp_path: Path, words: list[str]) -> None:
    file = tmp_path / "answer.json"
    assert main([*words, "--certificate", str(file)]) == 0
    assert main(["check", str(file)]) == 0
