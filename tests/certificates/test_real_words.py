"""Words of the vocabulary for one field, for angles, and for theorems of analysis."""

import copy
from typing import Any

import pytest

from hfield.certificates.check import Pin, check
from hfield.certificates.glossary import CIRCLE, CITED_BY_NAME
from hfield.certificates.rejection import Rejected
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import Proposition
from hfield.ledger.propositions import Every, Statement
from hfield.ledger.real_geometry import Analysis, Angles
from hfield.ledger.scopes import Over
from hfield.rings import ring

CIRCLE_CORE = Statement("y**2 + s**2 == 1 => (y + s*i)*(y - s*i) == 1")
REAL_PART = Statement("p[0]**2 + p[1]**2 == 0 => p[0] == 0 and p[1] == 0")
CUBIC = Statement("(s - 1)*(s - 2)*(s - 3) == s**3 - 6*s**2 + 11*s - 6")


def certified(proposition: Proposition, field: str | None) -> dict[str, Any]:
    decision = proposition.decide(None if field is None else ring(field))
    data = certificate(proposition, decision, field or "universal")
    assert data is not None
    check(data, Pin((proposition.statement,), field))
    return data


def changed(data: dict[str, Any], **changes: Any) -> dict[str, Any]:
    return {**copy.deepcopy(data), **changes}


def test_over_is_about_the_ring_named() -> None:
    data = certified(Over("GF(3)", Statement("1 + 1 == -1")), None)
    assert data["statement"] == "over{GF(3); 1 + 1 == -1}"
    with pytest.raises(Rejected):
        check(changed(data, statement="over{QQ; 1 + 1 == -1}"))
    with pytest.raises(Rejected, match="another statement"):
        check(data, Pin(("over{GF(5); 1 + 1 == -1}",)))
    check(data, Pin(("over{ GF(3) ; (1 + 1) == -1 }",)))


def test_over_refutes_with_a_witness_in_that_ring() -> None:
    proposition = Over("QQ", Statement("s**2 == 1 => s == 1"))
    decision = proposition.decide(None)
    assert decision.witness == {"F": ["QQ"], "s": ["-1"]}
    data = certified(proposition, None)
    worse = changed(data)
    worse["evidence"]["values"]["s"] = ["1"]
    with pytest.raises(Rejected):
        check(worse)


@pytest.mark.parametrize("name", ["RDF", "GF(6)", "nothing"])
def test_over_rings_where_nothing_is_proved(name: str) -> None:
    data = certified(Over("QQ", Statement("1 + 1 == 2")), None)
    with pytest.raises(Rejected):
        check(changed(data, statement=f"over{{{name}; 1 + 1 == 2}}"))


def test_over_joins_other_words() -> None:
    parts = (Over("QQ", Statement("2 != 0")), Over("GF(2)", Statement("2 == 0")))
    data = certified(Every(parts), None)
    with pytest.raises(Rejected):
        check(changed(data, statement="every{over{GF(2); 2 != 0}; over{QQ; 2 == 0}}"))


def test_angles_cite_the_circle_over_rr_alone() -> None:
    assert certified(Angles(CIRCLE_CORE), "RR")["assumes"] == [CIRCLE]
    for field in (None, "QQ", "GF(4)"):
        data = certified(Angles(CIRCLE_CORE), field)
        assert data["assumes"] == []
        with pytest.raises(Rejected, match="assumes"):
            check(changed(data, assumes=[CIRCLE]))


def test_the_real_part_is_needed_over_rr_alone() -> None:
    proposition = Angles(CIRCLE_CORE, REAL_PART)
    over_r = certified(proposition, "RR")
    assert certified(proposition, "GF(5)")["verdict"] == "proved"  # where it fails: 1² + 2² = 0
    core_alone = certified(Angles(CIRCLE_CORE), "RR")["evidence"]
    with pytest.raises(Rejected):
        check(changed(over_r, evidence=core_alone))


def test_theorems_are_cited_by_name() -> None:
    proposition = Analysis("odd-degree", CUBIC)
    assert certified(proposition, "RR")["assumes"] == [CITED_BY_NAME["odd-degree"]]
    assert proposition.decide(ring("QQ")).verdict == "not-applicable"
    data = certified(proposition, "RR")
    with pytest.raises(Rejected, match="no theorem"):
        check(changed(data, statement=data["statement"].replace("odd-degree", "choice")))
    with pytest.raises(Rejected, match="assumes"):
        check(changed(data, assumes=[]))


@pytest.mark.parametrize("text", ["over{QQ}", "citing{limits}", "angles{1 == 1; 1 == 1; 1 == 1}"])
def test_the_number_of_parts_is_fixed(text: str) -> None:
    data = certified(Over("QQ", Statement("1 + 1 == 2")), None)
    with pytest.raises(Rejected, match="parts"):
        check(changed(data, statement=text))
