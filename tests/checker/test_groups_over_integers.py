"""Certificates of units of norm 1 over number fields: true ones are accepted, forged ones rejected."""

import json
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from hfield import Order, QuaternionAlgebra, ring
from hfield.checker.check import ExpectedClaim
from hfield.checker.number_fields.real_numbers import Real, RealPlace
from hfield.checker.orders.reading import OverField
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.real_roots import real_roots
from hfield.checker.statement import read_setting
from hfield.cli import main
from tests.checker.cases import Certificate
from tests.checker.order_certificates import changed_and_passed, established, rejects
from tests.checker.test_norm_one_groups import restated
from tests.subcases import slow

HURWITZ = "(-1+s-s^2,1+3*s+s^2|QQ[s]/(s^3+s^2-2*s-1))"
ORDERS = (
    ("(-1,sqrt(5)|QQ(sqrt(5)))", 1),
    ("(-1,sqrt(5)|QQ(sqrt(5)))", 11),
    ("[-1+t,-1|QQ[t]/(t^2-t-1))", 1),
    (HURWITZ, 1),
)


@cache
def group(algebra: str, p: int) -> Any:
    A = QuaternionAlgebra.from_text(algebra)
    order = A.maximal_order() if p == 1 else A.eichler_order(A.ring.primes_above(p)[-1])
    return order.norm_one_group()


@cache
def both(algebra: str, p: int) -> tuple[Certificate, Certificate]:
    G = group(algebra, p)
    whole, domain = G.certificate, G.domain().certificate
    assert whole is not None
    assert domain is not None
    return whole, domain


@pytest.mark.parametrize("which", [*ORDERS[:2], *map(slow, ORDERS[2:])])
def test_the_true_ones_are_accepted(which: tuple[str, int]) -> None:
    K = group(*which).order.algebra.ring
    for data in both(*which):
        found = established(
            json.loads(json.dumps(data)),
            ExpectedClaim((data["statement"],), K.data, data["algebra"]),
        )
        assert len(found.theorems) == 2 + ("norm-one" in data["statement"])
        assert not found.assumptions


def test_another_centre_is_another_domain() -> None:
    G = group(*ORDERS[0])
    data, other = G.domain(0.2 + 0.9j).certificate, both(*ORDERS[0])[1]
    assert data is not None
    assert established(data).verdict == "proved"
    for n in (1, 2):
        rejects(restated(data, n, other["statement"][:-1].split("; ")[n]))


def test_forged_signatures_and_presentations() -> None:
    assert "; 0; 2,3,7; 0; " in both(HURWITZ, 1)[0]["statement"]
    data, _ = both(*ORDERS[0])
    _, genus, orders, cusps, generators, words = data["statement"][:-1].split("; ")
    assert (genus, orders, cusps) == ("0", "2,5,5", "0")
    for n, wrong in ((1, "1"), (2, "5,2,5"), (2, "none"), (2, "2,5"), (2, "2,5,6"), (3, "1")):
        rejects(restated(data, n, wrong), "another signature")
    for n, wrong in ((1, "1/2"), (1, "-1"), (3, "x"), (5, "1 x"), (5, "0")):
        rejects(restated(data, n, wrong), "is not how")
    some = generators.split(" | ")
    for wrong in (some[0], " | ".join(some[::-1]), "1,0,0,0", "sqrt(5),0,0,0 | 0,1,0,0"):
        rejects(restated(data, 4, wrong), "not the presentation")
    listed = words.split(", ")
    for wrong in ("none", ", ".join(listed[1:]), ", ".join(listed[::-1]), "1 1"):
        rejects(restated(data, 5, wrong), "not the presentation")
    rejects(restated(data, 4, "1,0,0"), "four numbers")
    rejects({**data, "verdict": "refuted"}, "does not show")
    rejects({**data, "evidence": {**data["evidence"], "kind": "norm-one-group"}}, "does not show")
    for text in data["assumes"]:
        rejects({**data, "assumes": [x for x in data["assumes"] if x != text]}, "assumes")


def test_the_algebra_splits_at_one_real_place_of_a_totally_real_field() -> None:
    data, _ = both(*ORDERS[0])
    for a, b, field in ((-1, -1, "s^2-5"), (1, 1, "s^2-5"), (2, 3, "s^2-5"), (1, 1, "s^3-s-1")):
        K = ring(f"QQ[s]/({field})")  # the last has one real place, and a complex one
        n = K.degree
        powers = ["1", "s", "s^2"][:n]
        order = " | ".join(
            ",".join("0" if k != m else w for k in range(4)) for m in range(4) for w in powers
        )
        basis = [[int(k == m) for k in range(n)] for m in range(n)]
        if n == 2:
            basis[1] = ["1/2", "1/2"]
            order = order.replace("s", "1/2+1/2*s")
        changed = {
            "algebra": f"({a},{b}|{K.name})", "field": K.name, "ring": K.data,
            "evidence": {**data["evidence"], "basis": basis, "primes": []},
        }  # fmt: skip
        rejects(restated({**data, **changed}, 0, order), "one real place")


def test_forged_domains() -> None:
    for which in (ORDERS[0], ORDERS[2]):
        data, _ = both(*which)
        evidence = data["evidence"]
        units, n = evidence["units"], len(evidence["units"][0]["row"]) // 4
        one = {"den": 1, "row": [1, *[0] * (4 * n - 1)]}

        def forged(data: Certificate = data, **changes: Any) -> Certificate:
            return {**data, "evidence": {**data["evidence"], **changes}}

        for some in (units[1:], [*units, units[0]], [units[1], units[0], *units[2:]], units[::-1]):
            rejects(forged(units=some))
        rejects(forged(units=[one, *units[1:]]))
        rejects(forged(units=units * 2))
        rejects(forged(units=units[:2]), "3 to")
        for key, value in (("den", 2 * units[0]["den"]), ("row", [2 * c for c in units[0]["row"]])):
            rejects(forged(units=[{**units[0], key: value}, *units[1:]]), "no unit")
        rejects(forged(center=one), "centre")
        rejects(forged(basis=evidence["basis"][:-1]), "integral basis")
        twice = [[2 * Fraction(c) for c in x] for x in evidence["basis"]]
        rejects(forged(basis=[evidence["basis"][0], *[[str(c) for c in x] for x in twice[1:]]]))


def test_without_a_pair_of_sides_the_others_are_not_mapped_to_sides() -> None:
    data, _ = both(HURWITZ, 1)
    said, units = set(), data["evidence"]["units"]
    for n, side in enumerate(group(HURWITZ, 1).domain().sides):
        left = [u for k, u in enumerate(units) if k not in (n, side.partner)]
        with pytest.raises(Rejected) as caught:
            established({**data, "evidence": {**data["evidence"], "units": left}})
        said.add(str(caught.value))
    assert "a side is not mapped to a side" in said
    assert said <= {
        "a side is not mapped to a side", "the sides do not go once around the centre",
        "two sides meet beyond infinity"
    }  # fmt: skip


def test_a_suborder_has_more_area_than_the_domain_of_the_order() -> None:
    """The domain of the maximal order is none of the Eichler order, nor the other way around."""
    for pair in zip(both(*ORDERS[0]), both(*ORDERS[1]), strict=True):
        for data, other in (pair, pair[::-1]):
            primes = pair[1]["evidence"]["primes"]
            changed = {**data, "evidence": {**data["evidence"], "primes": primes}}
            order = other["statement"].partition("{")[2].split("; ")[0]
            rejects(restated(changed, 0, order), "area|no unit")
    data, _ = both(*ORDERS[1])
    rejects({**data, "evidence": {**data["evidence"], "primes": []}}, "missing")


def test_a_conjugate_order_has_the_same_area_and_other_units() -> None:
    order = Order(group(*ORDERS[0]).order.order)
    x = order.algebra(1, 2, 0, 1)
    other = (x * order * x.inverse()).left_order().claim.statement
    text = other.partition("{")[2].split("; ")[0]
    for data in both(*ORDERS[0]):
        rejects(restated(data, 0, text), "no unit")


def test_integers_are_ordered_by_the_place() -> None:
    """The signs are those of floats, which tell these apart; near 0 more bits are found."""
    data, _ = both(HURWITZ, 1)
    setting = read_setting(HURWITZ, read_ring(data["ring"]))
    integers = OverField(setting, data["evidence"]).algebra.integers
    roots = real_roots(integers.field.modulus)
    assert len(roots) == 3
    for root in roots:
        place = RealPlace(integers, root)
        values = [float(root.within(Fraction(1, 2**60)).bounds(x)[0]) for x in integers.rows]
        for row in ((1, -3, 2), (5, 4, -3), (-1, 0, 0), (7, 0, -2)):
            x, near = Real(place, row), sum(c * v for c, v in zip(row, values, strict=True))
            assert (x > 0, x < 0, x >= 0, x <= 0) == (near > 0, near < 0, near > 0, near < 0)
            assert x - x == 0 <= x * 0 + (x - x)
        far = 10**400  # the bounds of 128 bits do not tell these from one another
        ends = root.within(Fraction(1, far)).bounds(integers.rows[1])
        low, high = (int(c * far) for c in ends)
        assert low - 10 < Real(place, (0, far, 0)) < high + 10
        assert not Real(place, (0, far, 0)) < low - 10
        assert -high - 10 < Real(place, (0, -far, 0)) < 10 - low


def test_no_number_can_be_changed() -> None:
    """One to three changes anywhere in the evidence: what passes is the statement, which is true."""
    tried, passed = changed_and_passed(3, (both(*ORDERS[n])[0] for n in (0, 3)), 20)
    assert passed < tried / 4


def test_the_command_writes_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for more in ([], ["--center", "0.2+0.9j"]):
        file = tmp_path / "domain.json"
        assert main(["domain", ORDERS[0][0], "--certificate", str(file), *more]) == 0
        assert main(["check", str(file)]) == 0
        assert "Siegel" in capsys.readouterr().out
