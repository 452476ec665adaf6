"""Claims about the functions of sections 3.1 and 3.2: what is proved is the code, and the order of ℚ."""

import json
import random
import sys
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hfield.checker.check import check_text
from hfield.fields.names import ring
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import NO_FIELD, Claim, decide
from hfield.syntax import names, parse
from rotation.ledger import generator, printed_times
from rotation.ledger.inequalities import Less, between
from rotation.ledger.symbolic_runs import code, coordinates, equal, read_as
from tests.ledger.spoilt_thesis import spoilt_thesis
from tests.subcases import share_quick

FORMULAS = ("quaternion_functions", "matrix_functions", "second_benchmark")


MUTANTS = {
    "v1[0] * v2[0] + v1[1]": ("v1[0] * v2[0] - v1[1]", {"d", "k", "m", "p", "h", "-b", "-d"}),
    "v1[2] * v2[0] - v1[0] * v2[2]": ("v1[0] * v2[2] - v1[2] * v2[0]", {"e", "i", "k", "p"}),
    "a1 * a2 - dotProduct": ("a1 * a2 + dotProduct", {"k", "m", "p", "h"}),
    "[a, [-v[0], -v[1]": ("[a, [-v[0], v[1]", {"j", "k", "l", "m", "p"}),
    "cos(0.5 * angle), scalarVector(sin(0.5": (
        "sin(0.5 * angle), scalarVector(cos(0.5",
        {"k", "m"},
    ),
    "v[1] / norm": ("v[1]", {"n"}),
    "[-s, 0, c]": ("[s, 0, c]", {"-b"}),
    "matmul(yaxisMatrixrotation(phi), xaxis": ("matmul(yaxisMatrixrotation(theta), xaxis", {"-c"}),
}


@pytest.mark.parametrize("line", share_quick(MUTANTS, 4))
def test_what_is_proved_is_the_code(line: str) -> None:
    """A wrong function turns its own rows red, and those of the functions that call it."""
    mutant, expected = MUTANTS[line]
    with spoilt_thesis(line, mutant, "rotation.ledger", FORMULAS) as spoilt:
        computed = {
            name
            for module in FORMULAS[:2]
            for name in sys.modules[f"rotation.ledger.{module}"].COMPUTED
        }
        red = {
            claim.id.removeprefix("C3.1.1-").removeprefix("C3.1.2")
            for claim in spoilt
            if claim.id in computed and wrong_now(claim)
        }
    assert red - {"a"} == expected


def wrong_now(claim: Claim) -> bool:
    """Whether a row that is proved, or corrected, is so no more."""
    row = decide(claim, NO_FIELD)
    said = row.as_corrected or row.as_printed
    return said.verdict != "proved"


def test_terms_write_down_what_is_done() -> None:
    s, t = names("s t")
    assert 1 + s * 2 - (-t) == parse("(1 + s*2) - (-t)")
    assert (s * t) / (s * t) == parse("(s*t)/(s*t)")
    assert 2 - s / 0.25 == parse("2 - s/0.25")
    assert equal([s, 0], [t, 1]) == parse("s == t and 0 == 1")
    with pytest.raises(ValueError, match="zip"):
        equal([s], [])
    half = code("rotationquaternion", cos=read_as({}), sin=read_as({}))
    with pytest.raises(KeyError, match="angle"):
        half(*names("angle"), coordinates("p"), coordinates("q"))


fractions = st.fractions(min_value=-50, max_value=50, max_denominator=60)


@given(fractions, fractions)
def test_less_is_the_order_of_the_rationals(a: Fraction, b: Fraction) -> None:
    claim = Less(str(a), str(b))
    decision = claim.decide(ring("QQ"))
    assert (decision.verdict == "proved") == (a < b)
    data = certificate(claim, decision, "QQ")
    assert check_text(json.dumps(data)).verdict == decision.verdict
    if decision.witness:
        assert sum(Fraction(x) ** 2 for x in decision.witness["q"]) == a - b


def test_less_stands_on_the_rationals_alone() -> None:
    assert Less("1/3", "1/2").decide(None).verdict == "proved"
    within = between("1", "3/2", "2", "it")
    assert within.text == "1 < it < 2"
    assert within.decide(ring("QQ")).verdict == "proved"


def test_the_terms_of_the_tables() -> None:
    QQ = ring("QQ")
    assert QQ(printed_times.mean((1, 2, 6))) == QQ(3)
    assert QQ(printed_times.ratio((8, 4), (3,))) == QQ(2)
    assert QQ(printed_times.saving((8,), (6,))) == QQ(25)
    assert [len(row) for row in printed_times.ALL] == [10] * 4


def test_the_extreme_numbers_of_random() -> None:
    assert generator.returned(0, 0) == 0.0
    assert generator.returned(generator.ONES, generator.ONES) == 1 - 2**-53
    for word in (1, 2**31, 0x9D2C5680, 123456789, *random.Random(7).choices(range(2**32), k=20)):
        fed = random.Random(0)
        fed.setstate((3, (*[generator.untempered(word)] * generator.WORDS, 0), None))
        assert fed.getrandbits(32) == word
    assert generator.within("[0, 1)", lambda low, high: low >= 0 and high < 1).compute().holds
    assert not generator.within("(0, 1)", lambda low, high: low > 0 and high < 1).compute().holds
