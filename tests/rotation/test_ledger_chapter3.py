"""The introduction and sections 3.1 and 3.2, decided: verdicts, twins, certificates, the code proved."""

import importlib
import inspect
import json
import random
import re
import sys
from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hfield.certificates.check import Pin, check_text
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Claim, decide
from hfield.ledger.computed import Computed
from hfield.ledger.registry import claims
from hfield.rings import ring
from rotation import thesis
from rotation.ledger import CLAIMS, generator, tables
from rotation.ledger.order import Less, between
from rotation.ledger.symbols import Symbol, code, coordinates, equal, read_as

ROWS_OF_SECTION = {"0": 5, "3.1.1": 16, "3.1.2": 4, "3.2": 3, "3.2.1": 19}
OWN = [claim for claim in CLAIMS if claim.section in ROWS_OF_SECTION]
CHECKABLE = [claim for claim in OWN if claim.checkable]
# Worked out by hand from the thesis.
WRONG = {"C3.1.1-a", "C3.1.1-h", "C3.2.1-f", "C3.2.1-l", "C3.2.1-o"}
NOT_CHECKABLE = {
    *("C0-a", "C0-e", "C3.1.1-c", "C3.1.1-o", "C3.2-a", "C3.2-b", "C3.2-c"),
    *("C3.2.1-b", "C3.2.1-m", "C3.2.1-q", "C3.2.1-r"),
}


def test_the_rows() -> None:
    assert Counter(claim.section for claim in OWN) == ROWS_OF_SECTION
    assert len({claim.id for claim in OWN}) == 47
    names = Counter(claim.name for claim in {c.id: c for c in (*claims(), *CLAIMS)}.values())
    for claim in OWN:
        assert names[claim.name] == 1, claim.name
        assert re.fullmatch(r"[a-z0-9]+([-.][a-z0-9]+)*", claim.name), claim.name
        assert claim.checkable or claim.note, f"{claim.id} must say why it cannot be checked"
    assert {claim.id for claim in OWN if not claim.checkable} == NOT_CHECKABLE
    assert {c.id for c in OWN if not c.fieldless} == {"C0-b", "C0-c", "C0-d"}


@pytest.mark.parametrize("claim", CHECKABLE, ids=lambda claim: claim.id)
def test_decided_with_a_certificate(claim: Claim) -> None:
    for field in claim.fields:
        row = decide(claim, field)
        assert row.settled, (field, row.as_printed, row.as_corrected)
        if row.as_printed.verdict == "refuted":
            assert claim.corrected is not None, f"refuted over {field} without a correction"
            assert row.as_printed.witness is not None, f"refuted over {field} without a witness"
            assert row.as_corrected is not None
            assert row.as_corrected.verdict == "proved"
        pairs = ((claim.as_printed, row.as_printed), (claim.corrected, row.as_corrected))
        for proposition, decision in pairs:
            data = certificate(proposition, decision, field)
            if isinstance(proposition, Computed):
                assert data is None
            elif decision is not None:
                assert data is not None, f"no certificate over {field}"
                pin = Pin((proposition.statement,), data["field"]) if proposition else None
                assert check_text(json.dumps(data), pin).verdict == decision.verdict


@pytest.mark.parametrize("claim", CHECKABLE, ids=lambda claim: claim.id)
def test_the_spoilt_twin_changes_the_verdict(claim: Claim) -> None:
    assert claim.spoilt is not None
    assert claim.as_printed is not None
    base = None if claim.fieldless else ring("QQ")
    verdicts = {claim.as_printed.decide(base).verdict, claim.spoilt.decide(base).verdict}
    assert verdicts == {"proved", "refuted"}


def test_the_errata() -> None:
    assert {c.id for c in CHECKABLE if refuted(c, NO_FIELD)} == WRONG
    plane = [c for c in CHECKABLE if not c.fieldless]
    assert {c.id for c in plane if refuted(c, "QQ")} == {"C0-c", "C0-d"}
    assert {c.id for c in plane if refuted(c, "GF(4)")} == {"C0-c"}
    assert {c.id for c in plane if refuted(c, UNIVERSAL)} == {"C0-c", "C0-d"}


def refuted(claim: Claim, field: str) -> bool:
    return field in claim.fields and decide(claim, field).as_printed.verdict == "refuted"


FORMULAS = ("quaternion_functions", "matrix_functions", "second_test")


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


@pytest.fixture
def again() -> Iterator[Any]:
    """Read the functions on symbols anew; after the test with the true functions."""

    def reread() -> None:
        for name in FORMULAS:
            importlib.reload(sys.modules[f"rotation.ledger.{name}"])
        importlib.reload(sys.modules["rotation.ledger"])

    yield reread
    importlib.reload(thesis)
    reread()


@pytest.mark.parametrize("line", MUTANTS)
def test_what_is_proved_is_the_code(line: str, again: Any) -> None:
    """A wrong function turns its own rows red, and those of the functions that call it."""
    mutant, expected = MUTANTS[line]
    source = inspect.getsource(thesis)
    assert source.count(line) == 1
    exec(compile(source.replace(line, mutant), thesis.__name__, "exec"), vars(thesis))
    again()
    red = {
        claim.id.removeprefix("C3.1.1-").removeprefix("C3.1.2")
        for claim in sys.modules["rotation.ledger"].CLAIMS
        if any(claim.id in sys.modules[f"rotation.ledger.{name}"].COMPUTED for name in FORMULAS[:2])
        and wrong_now(claim)
    }
    assert red - {"a"} == expected


def wrong_now(claim: Claim) -> bool:
    """Whether a row that is proved, or corrected, is so no more."""
    row = decide(claim, NO_FIELD)
    said = row.as_corrected or row.as_printed
    return said.verdict != "proved"


def test_symbols_write_down_what_is_done() -> None:
    s, t = Symbol("s"), Symbol("t")
    assert (1 + s * 2 - (-t)).text == "((1 + s*2) - (-t))"
    assert ((s * t) / (s * t)).text == "(s*t/(s*t))"
    assert (2 - s).text == "(2 - s)"
    assert equal([s, 0], [t, 1]) == "s == t and 0 == 1"
    with pytest.raises(ValueError, match="zip"):
        equal([s], [])
    half = code("rotationquaternion", cos=read_as({}), sin=read_as({}))
    with pytest.raises(KeyError, match=r"0\.5\*angle"):
        half(Symbol("angle"), coordinates("p"), coordinates("q"))


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
    assert QQ(tables.mean((1, 2, 6))) == QQ(3)
    assert QQ(tables.ratio((8, 4), (3,))) == QQ(2)
    assert QQ(tables.saving((8,), (6,))) == QQ(25)
    assert [len(row) for row in tables.ALL] == [10] * 4


def test_the_extreme_numbers_of_random() -> None:
    assert generator.returned(0, 0) == 0.0
    assert generator.returned(generator.ONES, generator.ONES) == 1 - 2**-53
    for word in (1, 2**31, 0x9D2C5680, 123456789, *random.Random(7).choices(range(2**32), k=20)):
        fed = random.Random(0)
        fed.setstate((3, (*[generator.untempered(word)] * generator.WORDS, 0), None))
        assert fed.getrandbits(32) == word
    assert generator.within("[0, 1)", lambda low, high: low >= 0 and high < 1).compute().holds
    assert not generator.within("(0, 1)", lambda low, high: low > 0 and high < 1).compute().holds
