"""Certificates of class sets over number fields: what is true is accepted, what is forged is rejected."""

import json
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.checker.check import ExpectedClaim
from hfield.checker.number_fields.class_groups import SUnits
from hfield.checker.number_fields.integers import Factors, RingOfIntegers
from hfield.checker.number_fields.zeta import zeta_minus_one
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.number_fields import NumberField
from hfield.cli import main
from hfield.core.primality import primes
from hfield.fields.number_fields.classes.evidence import seconds_above
from hfield.fields.number_fields.classes.s_units import s_units
from tests.checker.cases import Certificate
from tests.checker.order_certificates import changed_and_passed, established, rejects
from tests.subcases import subcases

ORDERS = (
    ("QQ(sqrt(5))", -1, -1, 1), ("QQ(sqrt(5))", -1, -1, 6), ("QQ(sqrt(2))", -1, -3, 1),
    ("QQ(sqrt(13))", -1, -1, 1), ("QQ(sqrt(17))", -1, -1, 1), ("QQ(sqrt(29))", -1, -1, 1),
    ("QQ[s]/(s^3-s^2-2*s+1)", -1, -1, 1), ("QQ[s]/(s^2-s-1)", "s-2", -3, 1),
    ("QQ(sqrt(3))", -1, -1, 1), ("QQ(sqrt(10))", -1, -1, 1), ("QQ(sqrt(15))", -1, -1, 1),
)  # fmt: skip


@cache
def genuine(field: str, a: Any, b: Any, level: int) -> Certificate:
    A = QuaternionAlgebra(field, a, b)
    order = A.maximal_order() if level == 1 else A.order(["2*i", "j"])
    data = order.class_set().certificate
    assert data is not None
    return data


@pytest.mark.slow
@subcases("which", ORDERS)
def test_the_true_ones_are_accepted(which: Any) -> None:
    data = genuine(*which)
    expected = ExpectedClaim((data["statement"],), data["ring"], data["algebra"])
    found = established(json.loads(json.dumps(data)), expected)
    assert len(found.theorems) >= 3
    assert not found.assumptions


def multiplied(values: list[Any], by: int) -> list[Any]:
    found = [by * Fraction(c) for c in values]
    return [str(c) if c.denominator > 1 else int(c) for c in found]


@pytest.mark.slow
@pytest.mark.parametrize("which", ORDERS)
def test_no_other_number_passes(which: Any) -> None:
    data = genuine(*which)
    evidence, classes = data["evidence"], data["evidence"]["classes"]
    order, _, h = data["statement"].rpartition("; ")

    def of(listed: list[Any]) -> Certificate:
        return {
            **data,
            "statement": f"{order}; {len(listed)}}}",
            "evidence": {**evidence, "classes": listed},
        }

    assert int(h[:-1]) == len(classes)
    assert established(of(classes[::-1]))
    rejects({**data, "statement": f"{order}; {len(classes) + 1}}}"}, "not the number")
    rejects(of([*classes, classes[0]]), "in one class")
    twice = {**classes[0], "rows": [[2 * x for x in row] for row in classes[0]["rows"]]}
    rejects(of([*classes, twice]), "norm")
    four = [
        str(4 * Fraction(c)) if "/" in str(4 * Fraction(c)) else int(4 * Fraction(c))
        for c in twice["norm"]
    ]
    rejects(of([*classes, {**twice, "norm": four}]), "in one class")
    negative = [
        str(-Fraction(c)) if Fraction(c).denominator > 1 else -int(c) for c in classes[0]["norm"]
    ]
    rejects(of([{**classes[0], "norm": negative}, *classes[1:]]), "totally positive")
    if len(classes) > 1:
        rejects(of(classes[1:]), "do not have the mass")
        rejects(of([*classes[1:], classes[1]]), "in one class")
    for key in evidence.keys() - ({"narrow"} if len(evidence["narrow"]) == 1 else set()):
        rejects({**data, "evidence": {k: v for k, v in evidence.items() if k != key}})
    rejects({**data, "verdict": "refuted"})
    rejects({**data, "assumes": data["assumes"][1:]}, "assumes")


def test_norms_lie_in_the_narrow_classes_that_are_stated() -> None:
    """ℚ(√10) has h = 2 and no more narrow classes; ℚ(√3) has h = 1 and two; ℚ(√15) two and four."""
    for which in ORDERS[-3:]:
        data = genuine(*which)
        evidence = data["evidence"]
        narrow, classes = evidence["narrow"], evidence["classes"]

        def forged(data: Certificate = data, **changes: Any) -> Certificate:
            return {**data, "evidence": {**data["evidence"], **changes}}

        assert len({x["narrow"] for x in classes}) == len(narrow) > 1
        rejects(forged(narrow=[*narrow, narrow[-1]]), "two norms are in one narrow class")
        rejects(forged(narrow=narrow[:1]), "not given")
        rejects(forged(narrow=narrow[::-1]), "norm")
        other = [{**x, "narrow": 1 - min(x["narrow"], 1)} for x in classes]
        rejects(forged(classes=other), "norm|totally positive")
        one = next(x for x in classes if x["narrow"])
        again = [*narrow, [multiplied(narrow[one["narrow"]][0], 2), narrow[one["narrow"]][1]]]
        rejects(forged(narrow=again), "two norms are in one narrow class")


def test_zeta_is_that_of_the_prover() -> None:
    for name in (
        "QQ[s]/(s^2-s-1)",
        "QQ[s]/(s^2-7)",
        "QQ[s]/(s^3-s^2-2*s+1)",
        "QQ[s]/(s^3-4*s-1)",
        "QQ[s]/(s^4-5*s^2+5)",
    ):
        K = ring(name)
        data = K.class_group().certificate
        field = read_ring(data["ring"])
        assert isinstance(field, NumberField)
        whole = RingOfIntegers(field, [[Fraction(c) for c in x] for x in data["evidence"]["basis"]])
        listed = [[p, seconds_above(s_units(K), p)] for p in primes(50)]
        assert zeta_minus_one(whole, Factors(whole, listed)) == K.zeta_minus_one()


@pytest.mark.slow
def test_no_number_can_be_changed() -> None:
    """One to three changes anywhere in the evidence: what passes is the statement, which is true."""
    tried, passed = changed_and_passed(2, (genuine(*which) for which in ORDERS), 8, millions=3)
    assert passed < tried / 3


def test_the_command_writes_one(tmp_path: Path) -> None:
    file = tmp_path / "classes.json"
    assert main(["classes", "(-1,-1|QQ(sqrt(5)))", "--certificate", str(file)]) == 0
    assert main(["check", str(file)]) == 0
    assert SUnits.KEYS.split()[0] in json.loads(file.read_text())["evidence"]["units"]
