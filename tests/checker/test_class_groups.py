"""Certificates of class groups and units: what is true is accepted, what is forged is rejected."""

import json
import math
import random
from fractions import Fraction
from functools import cache
from typing import Any

import pytest

from hfield import ring
from hfield.checker.check import check
from hfield.checker.number_fields.integers import RingOfIntegers
from hfield.checker.number_fields.logarithms import DIGITS, Places, log, volume
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.number_fields import NumberField
from tests.checker.cases import Certificate
from tests.checker.order_certificates import established, mutated, rejects
from tests.subcases import subcases

FIELDS = (
    "QQ(sqrt(-1))", "QQ(sqrt(-21))", "QQ(sqrt(-4027))", "QQ(sqrt(5))", "QQ(sqrt(94))", "QQ(sqrt(82))",
    "QQ(zeta5)", "QQ(root(7,3))", "QQ[s]/(s^3-s^2-2*s-8)", "QQ[s]/(s^3-s^2-2*s+1)", "QQ[s]/(s^4-s^2+4)",
    "QQ[s]/(s^3-1/2)", "QQ[s]/(s^4-5*s^2+5)", "QQ[s]/(s^5+4*s^4+2*s^3-3*s^2-3*s-5)",
)  # fmt: skip


@cache
def both(name: str) -> tuple[Certificate, Certificate]:
    K = ring(name)
    classes, units = K.class_group().certificate, K.unit_group().certificate
    assert classes is not None
    assert units is not None
    return classes, units


@subcases("name", FIELDS)
def test_the_true_ones_are_accepted(name: str) -> None:
    for data in both(name):
        found = established(json.loads(json.dumps(data)))
        assert found.theorems
        assert not found.assumptions
        assert found.statement == data["statement"]


def test_the_narrowest_theorems_are_cited() -> None:
    """Bounds that hold for all fields where the evidence reaches so far; those of the field elsewhere."""
    first, last = (established(both(name)[0]).theorems for name in ("QQ[s]/(s^4-s-1)", FIELDS[-1]))
    assert [theorem.rpartition("(")[2] for theorem in first] == ["Minkowski)", "Friedman)"]
    assert [theorem.rpartition("(")[2] for theorem in last] == ["Zimmert)", "Hermite)"]
    data = both(FIELDS[-1])[0]
    for prime, _ in data["evidence"]["saturated"]:
        fewer = [entry for entry in data["evidence"]["saturated"] if entry[0] != prime]
        rejects({**data, "evidence": {**data["evidence"], "saturated": fewer}}, f"at {prime}")


def test_a_narrow_class_group_says_why_there_is_none() -> None:
    claim = ring("QQ(sqrt(3))").narrow_class_group().claim
    assert claim.certificate is None
    assert "narrow" in str(claim.why_no_certificate)


def test_what_they_state() -> None:
    stated = [both(name)[0]["statement"] for name in FIELDS[:3]]
    assert stated == ["class-group{1}", "class-group{2,2}", "class-group{3,3}"]
    assert both("QQ(sqrt(82))")[0]["statement"] == "class-group{4}"
    assert both("QQ(zeta5)")[1]["statement"].startswith("unit-group{10; ")


@pytest.mark.slow
@subcases("name", FIELDS)
def test_no_other_statement_passes(name: str) -> None:
    """Other groups are refused; whatever evidence passes after a change shows the same statement."""
    classes, units = both(name)
    for other in ("1", "2", "3", "4", "2,2", "3,3", "5", "2,4"):
        statement = f"class-group{{{other}}}"
        if statement != classes["statement"]:
            rejects({**classes, "statement": statement}, "another one")
    for data in (classes, units):
        rejects({**data, "verdict": "refuted"})
        rejects({**data, "assumes": []}, "assumes")
        rejects({**data, "assumes": [*data["assumes"], data["assumes"][0]]}, "assumes")
        for key in data["evidence"]:
            rejects({**data, "evidence": {k: v for k, v in data["evidence"].items() if k != key}})
        rejects({**data, "evidence": {**data["evidence"], "more": 1}}, "unknown key")


def squared(data: Certificate, n: int) -> Certificate:
    """Put the square of a generator in its place: a subgroup of index 2."""
    field = read_ring(data["ring"])
    power = [(*map(Fraction, x),) for x in data["evidence"]["generators"]]
    assert isinstance(field, NumberField)
    power[n] = field.mul(power[n], power[n])
    generators = [[str(c) if c.denominator > 1 else int(c) for c in x] for x in power]
    return {**data, "evidence": {**data["evidence"], "generators": generators}}


SATURATED = (
    "QQ[s]/(s^3-s^2-2*s-8)", "QQ(root(7,3))", "QQ[s]/(s^4-s^2+4)", "QQ(root(11,3))", "QQ[s]/(s^3-65)"
)  # fmt: skip


@pytest.mark.parametrize("name", SATURATED)
def test_a_subgroup_of_the_units_is_not_all(name: str) -> None:
    for data in both(name):
        for n in range(len(data["evidence"]["generators"])):
            rejects(squared(data, n), "saturated at 2")


def test_units_that_do_not_generate_all() -> None:
    units = both("QQ(sqrt(5))")[1]
    assert units["statement"] == "unit-group{2; 1/2+1/2*sqrt(5)}"
    for u, why in (
        ("3/2+1/2*sqrt(5)", "do not generate"),
        ("-1", "do not generate"),
        ("2", "not a unit"),
        ("1/2+1/2*sqrt(5); 1", "rank"),
    ):
        rejects({**units, "statement": f"unit-group{{2; {u}}}"}, why)
    rejects({**units, "statement": "unit-group{2}"}, "rank")
    rejects({**units, "statement": "unit-group{4; 1/2+1/2*sqrt(5)}"}, "roots of unity")
    for same in ("-1/2-1/2*sqrt(5)", "1/2*sqrt(5)-1/2"):
        assert established({**units, "statement": f"unit-group{{2; {same}}}"})


FORGED: list[tuple[str, str, Any, str]] = [
    ("QQ(sqrt(-21))", "S", [0], "generators of S-units|neither in S|not reduced"),
    ("QQ(sqrt(-21))", "S", [0, 0], "twice"),
    ("QQ(sqrt(-21))", "S", [0, 77], "not given"),
    ("QQ(sqrt(-21))", "primes", [[2, [[1, 1]]]], "missing|not given"),
    ("QQ(sqrt(-21))", "saturated", [], "not shown that the S-units are saturated"),
    ("QQ(sqrt(94))", "primes", [[2, [[0, 1], [0, 1]]], [3, [[1, 1], [2, 1]]]], "twice"),
    ("QQ(sqrt(94))", "primes", [[2, [[0, 1]]], [3, [[1, 1]]]], "not all prime ideals"),
    ("QQ(sqrt(94))", "primes", [[2, [[0, 1]]], [4, [[0, 0]]]], "not a prime number"),
    ("QQ(sqrt(94))", "primes", [[2, [[0, 0]]], [3, [[1, 1], [2, 1]]]], "not prime"),
    ("QQ(sqrt(94))", "primes", [[2, [[0, 1]]], [2, [[0, 1]]]], "twice"),
    ("QQ(sqrt(5))", "basis", [[1, 0], [0, 1]], "not span all integers at 2"),
    ("QQ(sqrt(5))", "basis", [[1, 0], ["1/4", "1/4"]], "spans no ring"),
    ("QQ(sqrt(5))", "basis", [[1, 0], [2, 0]], "dependent"),
    (
        "QQ(zeta5)",
        "torsion",
        {"order": 5, "generator": [0, 1, 0, 0], "residues": [[11, 3]]},
        "no more",
    ),
    (
        "QQ(zeta5)",
        "torsion",
        {"order": 2, "generator": [-1, 0, 0, 0], "residues": [[11, 3]]},
        "no more",
    ),
    (
        "QQ(zeta5)",
        "torsion",
        {"order": 10, "generator": [0, 1, 0, 0], "residues": [[11, 3]]},
        "order",
    ),
    (
        "QQ(zeta5)",
        "torsion",
        {"order": 10, "generator": [0, -1, 0, 0], "residues": [[11, 2]]},
        "root",
    ),
    (
        "QQ(zeta5)",
        "torsion",
        {"order": 10, "generator": [0, -1, 0, 0], "residues": [[5, 1]]},
        "at least",
    ),
    ("QQ(zeta5)", "torsion", {"order": 10, "generator": [0, -1, 0, 0], "residues": []}, "no more"),
]


@subcases(("name", "key", "value", "why"), FORGED)
def test_forged_evidence(name: str, key: str, value: Any, why: str) -> None:
    data = both(name)[0]
    rejects({**data, "evidence": {**data["evidence"], key: value}}, why)


def test_no_number_can_be_changed() -> None:
    """One to three changes anywhere in the evidence: what passes is the statement, which is true."""
    rng, tried, passed = random.Random(11), 0, 0
    for name in FIELDS:
        for data in both(name):
            evidence = data["evidence"]
            for _ in range(6):
                for _ in range(rng.randint(1, 3)):
                    evidence = mutated(rng, evidence)
                tried += 1
                try:
                    check({**data, "evidence": evidence})
                except Rejected:
                    evidence = data["evidence"]
                    continue
                passed += 1
    assert tried == 6 * 2 * len(FIELDS)
    assert passed < tried / 3


def test_bounds_of_logarithms() -> None:
    for n in (1, 2, 3, 10, 10**40, 2**77 - 1):
        low, high = log(n)
        assert high - low < 1 << 22
        assert abs(low / (1 << DIGITS) - math.log(n)) < 1e-12
    places = Places([-94, 0, 1])
    assert (places.real, places.complex, places.rank) == (2, 0, 1)
    for k in (1, 5, 40):
        u, v = 1, 0
        for _ in range(k):
            u, v = u * 2143295 + v * 221064 * 94, u * 221064 + v * 2143295
        (a, b), (c, d) = places.logarithms([u, -v], 1)
        assert a + c <= 0 <= b + d
        assert max(b - a, d - c) < 1 << DIGITS - 180
    low, high = volume([(2,), (3,)], [[log(2)], [log(3)]])
    assert low <= 2 * log(3)[0] - 3 * log(2)[0] + (1 << 30)
    assert low > 0
    assert high - low < 1 << 40


def test_maximal_orders_are_recognised() -> None:
    """ℤ + m·O is maximal for m = 1 alone."""
    for name in ("QQ[s]/(s^3-s^2-2*s-8)", "QQ[s]/(s^4-s^2+4)"):
        data = both(name)[0]
        field = read_ring(data["ring"])
        assert isinstance(field, NumberField)
        rows = [[Fraction(c) for c in x] for x in data["evidence"]["basis"]]
        whole = RingOfIntegers(field, rows)
        assert whole.discriminant
        for m in (2, 3, 5):
            smaller = [rows[0], *([m * c for c in row] for row in rows[1:])]
            with pytest.raises(Rejected, match=f"all integers at {m}|spans no ring"):
                RingOfIntegers(field, smaller)
