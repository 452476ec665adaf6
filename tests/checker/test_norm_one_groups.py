"""Certificates of units of norm 1: what is true is accepted, what is forged is rejected."""

import json
import random
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from hfield import QuaternionAlgebra
from hfield.checker.check import ExpectedClaim
from hfield.checker.number_fields.integers import RATIONAL_INTEGERS, RationalPrimes
from hfield.checker.orders.algebra import Algebra
from hfield.checker.orders.fuchsian import area
from hfield.checker.orders.lattice import Lattice
from hfield.checker.scalars.fields import read_ring
from hfield.checker.statement import read_setting
from hfield.cli import main
from tests.checker.cases import Certificate
from tests.checker.order_certificates import changed_and_passed, established, rejects

ORDERS = ((3, -1, 1), (1, 1, 1), (1, 1, 6), (-1, 3, 5), (5, 2, 1), (2, 5, 3), (7, -1, 3))


@cache
def group(a: int, b: int, level: int) -> Any:
    return QuaternionAlgebra("QQ", a, b).eichler_order(level).norm_one_group()


@cache
def both(a: int, b: int, level: int) -> tuple[Certificate, Certificate]:
    G = group(a, b, level)
    whole, domain = G.certificate, G.domain().certificate
    assert whole is not None
    assert domain is not None
    return whole, domain


@pytest.mark.parametrize("which", ORDERS)
def test_the_true_ones_are_accepted(which: tuple[int, int, int]) -> None:
    for data in both(*which):
        found = established(
            json.loads(json.dumps(data)), ExpectedClaim((data["statement"],), "QQ", data["algebra"])
        )
        assert found.theorems
        assert not found.assumptions


def test_orders_that_are_not_eichler_and_other_centres() -> None:
    A = QuaternionAlgebra("QQ", 1, 1)
    for generators in (["2*i", "2*j"], ["i", "3*j"], ["i", "j"]):
        G = A.order(generators).norm_one_group()
        assert G.certificate is not None
        assert G.domain(0.3 + 1.7j).certificate is not None
    assert group(3, -1, 1).domain(0.11 + 0.9j).certificate is not None


def restated(data: Certificate, n: int, text: str) -> Certificate:
    """Put another text for part n of the statement."""
    word, _, inside = data["statement"][:-1].partition("{")
    parts = inside.split("; ")
    return {**data, "statement": f"{word}{{{'; '.join([*parts[:n], text, *parts[n + 1 :]])}}}"}


def test_forged_signatures_and_presentations() -> None:
    data, _ = both(3, -1, 1)
    _, genus, orders, cusps, generators, words = data["statement"][:-1].split("; ")
    assert (genus, orders, cusps) == ("0", "2,2,3,3", "0")
    for n, text in (
        (1, "1"),
        (2, "2,3,3,2"),
        (2, "none"),
        (2, "2,2,3"),
        (3, "1"),
        (1, "1/2"),
        (3, "-1"),
    ):
        rejects(restated(data, n, text), "another signature")
    first, *others = generators.split(" | ")
    for text in (
        " | ".join(others),
        " | ".join([*others, first]),
        " | ".join([first, first, *others]),
        "1,0,0,0",
    ):
        rejects(restated(data, 4, text), "not the presentation")
    some = words.split(", ")
    for text in (
        "none",
        ", ".join(some[1:]),
        ", ".join([*some, some[0]]),
        ", ".join(some[::-1]),
        "1 1",
    ):
        rejects(restated(data, 5, text), "not the presentation")
    rejects(restated(data, 4, "1,0,0"), "four numbers")
    rejects(restated(data, 5, "1 x"), "no rational number")
    rejects({**data, "verdict": "refuted"}, "does not show")
    rejects({**data, "assumes": data["assumes"][:1]}, "assumes")
    rejects({**data, "algebra": "(-3,-1|QQ)"})
    rejects({**data, "algebra": "(-1,-1|QQ)"}, "order|definite|norm")


def test_forged_domains() -> None:
    for which in ORDERS:
        data, _ = both(*which)
        evidence = data["evidence"]
        units = evidence["units"]

        def forged(units: list[Any], evidence: Any = evidence, data: Any = data) -> Certificate:
            return {**data, "evidence": {**evidence, "units": units}}

        rejects(forged(units[1:]))
        rejects(forged([*units, units[0]]))
        rejects(forged([units[1], units[0], *units[2:]]))
        rejects(forged(units[::-1]))
        one = ["1", "0", "0", "0"]
        rejects(forged([one, *units[1:]]), "the first unit fixes the centre")
        rejects(forged([one, *units, one]), "the first unit does not move the centre")
        rejects(forged([*units[:1], one, *units[1:]]), "a unit does not move the centre")
        rejects(forged(units * 2))
        rejects(forged(units[:2]), "3 to")
        for center in (["1", "0", "0", "0"], ["0", "0", "0", "0"]):
            rejects({**data, "evidence": {**evidence, "center": center}}, "centre")


def test_a_suborder_has_more_area_than_the_domain_of_the_order() -> None:
    """The domain of the maximal order is none of Γ₀(6), nor the other way around."""
    data, domain = both(1, 1, 1)
    smaller, other = both(1, 1, 6)
    for one, two in ((data, smaller), (domain, other)):
        rejects(restated(one, 0, two["statement"].partition("{")[2].split("; ")[0]))
        rejects(restated(two, 0, one["statement"].partition("{")[2].split("; ")[0]), "area")


def test_the_area_is_that_of_the_formula() -> None:
    rng, setting = random.Random(5), read_ring({"kind": "rationals"})
    for _ in range(12):
        A = QuaternionAlgebra("QQ", rng.choice([2, 3, 5, 7, -1, 1]), rng.choice([3, 5, 11, 1, 2]))
        order = A.order([A(0, rng.randint(1, 4), 0, 0), A(0, 0, rng.randint(1, 4), 0)])
        den, rows = order.hnf
        algebra = Algebra(read_setting(str(A), setting), RATIONAL_INTEGERS)
        checked = Lattice(algebra, den, tuple(map(tuple, rows)))
        assert area(checked, RationalPrimes()) == order.norm_one_group().area


@pytest.mark.slow
def test_no_number_can_be_changed() -> None:
    """One to three changes anywhere in the evidence: what passes is the statement, which is true."""
    tried, passed = changed_and_passed(7, (both(*which)[0] for which in ORDERS), 60)
    assert passed < tried / 10


def test_the_command_writes_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for more in ([], ["--center", "0.11+0.9j"]):
        file = tmp_path / "domain.json"
        assert main(["domain", "(3,-1|QQ)", "--certificate", str(file), *more]) == 0
        assert main(["check", str(file)]) == 0
        assert "Shimizu" in capsys.readouterr().out
