"""Words of the vocabulary for one field, for angles, and for theorems of analysis."""

import copy
from typing import Any

import pytest

from hfield.checker.check import ExpectedClaim, check
from hfield.checker.glossary import CIRCLE, CITED_BY_NAME, REAL_ROOTS
from hfield.checker.rejection import Rejected
from hfield.fields.names import ring
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import Proposition
from hfield.ledger.modulus import ModulusDefined
from hfield.ledger.propositions import Assertion, Equivalence, Every, Implication
from hfield.ledger.real_geometry import Analysis, Angles
from hfield.ledger.scopes import InField, Negation
from tests.checker.cases import with_rings
from tests.checker.ring_data import data_of

CIRCLE_CORE = Assertion("y**2 + s**2 == 1 => (y + s*i)*(y - s*i) == 1")
REAL_PART = Assertion("p[0]**2 + p[1]**2 == 0 => p[0] == 0 and p[1] == 0")
CUBIC = Assertion("(s - 1)*(s - 2)*(s - 3) == s**3 - 6*s**2 + 11*s - 6")


def certified(proposition: Proposition, field: str | None) -> dict[str, Any]:
    decision = proposition.decide(None if field is None else ring(field))
    data = certificate(proposition, decision, field or "universal")
    assert data is not None
    check(data, ExpectedClaim((proposition.statement,), field))
    return data


def changed(data: dict[str, Any], **changes: Any) -> dict[str, Any]:
    return {**copy.deepcopy(data), **changes}


def renamed(data: dict[str, Any], statement: str) -> dict[str, Any]:
    """Return the certificate about another statement, with the rings that this names."""
    own = data["evidence"]["evidence"]
    return changed(data, statement=statement, evidence=with_rings(statement, own))


def test_over_is_about_the_ring_named() -> None:
    data = certified(InField("GF(3)", Assertion("1 + 1 == -1")), None)
    assert data["statement"] == "over{GF(3); 1 + 1 == -1}"
    with pytest.raises(Rejected, match="expanding"):
        check(renamed(data, "over{QQ; 1 + 1 == -1}"))
    with pytest.raises(Rejected, match="another statement"):
        check(data, ExpectedClaim(("over{GF(5); 1 + 1 == -1}",)))
    check(data, ExpectedClaim(("over{ GF(3) ; (1 + 1) == -1 }",)))


def test_over_refutes_with_a_witness_in_that_ring() -> None:
    proposition = InField("QQ", Assertion("s**2 == 1 => s == 1"))
    decision = proposition.decide(None)
    assert decision.witness == {"F": ["QQ"], "s": ["-1"]}
    data = certified(proposition, None)
    worse = changed(data)
    worse["evidence"]["evidence"]["values"]["s"] = ["1"]
    with pytest.raises(Rejected, match="is true"):
        check(worse)


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("RDF", "nothing is proved over floats"),
        ("GF(6)", "does not say which rings"),
        ("nothing", "does not say which rings"),
    ],
)
def test_over_rings_where_nothing_is_proved(name: str, why: str) -> None:
    data = certified(InField("QQ", Assertion("1 + 1 == 2")), None)
    statement = f"over{{{name}; 1 + 1 == 2}}"
    with pytest.raises(Rejected, match=why):
        check(renamed(data, statement) if name == "RDF" else changed(data, statement=statement))


def test_over_joins_other_words() -> None:
    parts = (InField("QQ", Assertion("2 != 0")), InField("GF(2)", Assertion("2 == 0")))
    data = certified(Every(parts), None)
    with pytest.raises(Rejected, match=r"covered|expanding"):
        check(changed(data, statement="every{over{GF(2); 2 != 0}; over{QQ; 2 == 0}}"))


def test_what_stands_in_brackets_is_a_name() -> None:
    place = "QQ[s]/(s^3-2)_(2, s)"
    data = renamed(
        certified(InField("QQ", Assertion("1 + 1 == 2")), None), f"over{{{place}; 1 + 1 == 2}}"
    )
    assert check(data).verdict == "proved"
    check(data, ExpectedClaim((f"over{{ {place} ;1 + 1 == 2}}",)))
    with pytest.raises(Rejected, match="another statement"):
        check(data, ExpectedClaim((f"over{{{place.replace(' ', '')}; 1 + 1 == 2}}",)))
    for wrong in (f"over{{{place[:-1]}; 1 + 1 == 2}}", f"over{{{place[:-1]}]; 1 + 1 == 2}}"):
        with pytest.raises(Rejected, match="brackets"):
            check(changed(data, statement=wrong))
    with pytest.raises(Rejected, match="does not say which rings"):  # and is not of three parts
        check(changed(data, statement="over{QQ[s]/(s^3-2)_(2; s); 1 + 1 == 2}"))


def test_the_rings_that_are_named_are_said_and_no_others() -> None:
    parts = (InField("QQ", Assertion("2 != 0")), InField("GF(2)", Assertion("2 == 0")))
    data = certified(Every(parts), None)
    own, rings = data["evidence"]["evidence"], [data_of("GF(2)"), data_of("QQ")]
    assert data["evidence"] == {"kind": "rings", "rings": rings, "evidence": own}

    def saying(*said: Any, **more: Any) -> dict[str, Any]:
        return changed(data, evidence={**data["evidence"], "rings": list(said), **more})

    assert check(saying(*reversed(rings))).verdict == "proved"
    gf_4 = data_of("GF(4)")
    for said in (rings[:1], rings[1:], [*rings, gf_4], [gf_4, rings[1]], [], [*rings, rings[0]]):
        with pytest.raises(Rejected, match="does not say which rings the statement names"):
            check(saying(*said))
    for said, why in (
        ([rings[0], "QQ"], "the data of a ring must be an object"),
        ([rings[0], {**rings[1], "n": 1}], "unknown key"),
        ([{**rings[0], "modulus": [1, 1]}, rings[1]], "takes no modulus"),
        ([rings[0], {"kind": "rational numbers"}], "are not known here"),
    ):
        with pytest.raises(Rejected, match=why):
            check(saying(*said))
    with pytest.raises(Rejected, match="rings must be a list"):
        check(changed(data, evidence={**data["evidence"], "rings": {}}))
    with pytest.raises(Rejected, match="unknown key 'more'"):
        check(saying(*rings, more=1))
    with pytest.raises(Rejected, match="does not say which rings"):
        check(saying(*rings, kind="parts"))
    with pytest.raises(Rejected, match="lacks the key"):
        check(saying(*rings, kind="parts", evidence=None) | {"evidence": {"kind": "rings"}})
    with pytest.raises(Rejected, match="unknown key 'parts'"):
        check(changed(data, evidence=own))
    twice = {**data["evidence"], "evidence": data["evidence"]}
    with pytest.raises(Rejected, match="does not show this"):
        check(changed(data, evidence=twice))
    alone = certified(Assertion("2 == 1 + 1"), "QQ")
    for said in ([], [data_of("QQ")]):
        wrapped = {"kind": "rings", "rings": said, "evidence": alone["evidence"]}
        with pytest.raises(Rejected, match="of the kind 'rings' does not show"):
            check(changed(alone, evidence=wrapped))


@pytest.mark.parametrize(
    "name", ["GF(3^2)", "GF( 9)", "GF(9,x^2+2*x+2)", "gf(9)", "FF(9)", "GF(9, x^2+2*x+2)", "GF(3)"]
)
def test_a_ring_is_named_as_the_checker_writes_it(name: str) -> None:
    data = certified(InField("GF(9)", Assertion("1 + 1 == -1")), None)
    with pytest.raises(Rejected, match="does not say which rings the statement names"):
        check(changed(data, statement=f"over{{{name}; 1 + 1 == -1}}"))


def test_angles_cite_the_circle_where_rr_is_spoken_of() -> None:
    for field in (None, "RR"):
        data = certified(Angles(CIRCLE_CORE), field)
        assert data["assumes"] == [CIRCLE]
        with pytest.raises(Rejected, match="assumes"):
            check(changed(data, assumes=[]))
    for field in ("QQ", "GF(4)"):
        data = certified(Angles(CIRCLE_CORE), field)
        assert data["assumes"] == []
        with pytest.raises(Rejected, match="assumes"):
            check(changed(data, assumes=[CIRCLE]))


def test_the_real_part_is_looked_at_where_it_is_said() -> None:
    proposition = Angles(CIRCLE_CORE, REAL_PART)
    core_alone = certified(Angles(CIRCLE_CORE), "RR")["evidence"]
    for field in (None, "RR"):
        data = certified(proposition, field)
        with pytest.raises(Rejected):
            check(changed(data, evidence=core_alone, assumes=[]))
    found = check(certified(proposition, "GF(5)"))  # where it fails: 1² + 2² = 0
    assert found.left_out == (f"{REAL_PART.statement} (which is said of RR alone)",)
    assert f"left out: {found.left_out[0]}" in found.lines()
    assert check(certified(proposition, "RR")).left_out == ()
    everywhere = check(certified(proposition, None))
    assert everywhere.where == "over all commutative rings"
    assert everywhere.left_out == (f"{REAL_PART.statement} (everywhere but over RR)",)


@pytest.mark.parametrize("wrap", ["{}", "every{{{}; 1 == 1}}"])
def test_a_false_real_part_is_refuted(wrap: str) -> None:
    """Of all fields at once, and of RR, angles{P; Q} is as false as Q is."""
    identity: dict[str, Any] = {"kind": "identity"}
    never = {
        "kind": "part",
        "part": 1,
        "evidence": {"kind": "witness", "values": {}, "ring": data_of("RR")},
    }
    statement = wrap.format("angles{1 == 1; 1 == 2}")
    for field in (None, "RR"):
        data = {**certified(Assertion("1 + 1 == 2"), field), "statement": statement}
        refuted = {"kind": "part", "part": 0, "evidence": never} if "every" in statement else never
        cites = [CIRCLE] if field else []
        check({**data, "verdict": "refuted", "evidence": refuted, "assumes": cites})
        for own in (
            identity,
            {"kind": "parts", "parts": [{"verdict": "proved", "evidence": identity}] * 2},
        ):
            shown = {"verdict": "proved", "evidence": own}
            both = {"kind": "parts", "parts": [shown, {"verdict": "proved", "evidence": identity}]}
            for cited in ([], [CIRCLE]):
                with pytest.raises(Rejected, match=r"expanding|kind"):
                    check(
                        {
                            **data,
                            "evidence": both if "every" in statement else own,
                            "assumes": cited,
                        }
                    )


def test_what_fails_over_rr_alone_fails_somewhere() -> None:
    data = certified(Assertion("1 + 1 == 2"), None)
    never = {
        "kind": "part",
        "part": 1,
        "evidence": {"kind": "witness", "values": {}, "ring": data_of("RR")},
    }
    data |= {"statement": "not-everywhere{angles{1 == 1; 1 == 2}}", "method": "witness"}
    check(
        {
            **data,
            "evidence": {"kind": "over", "ring": data_of("RR"), "evidence": never},
            "assumes": [CIRCLE],
        }
    )
    with pytest.raises(Rejected):
        check({**data, "evidence": {"kind": "over", "ring": data_of("QQ"), "evidence": never}})


def test_the_prover_decides_the_real_part_of_all_fields() -> None:
    false = Assertion("s**2 == s")
    assert Angles(CIRCLE_CORE, false).decide(None).verdict == "refuted"
    assert Angles(CIRCLE_CORE, false).decide(ring("RR")).verdict == "refuted"
    assert Angles(CIRCLE_CORE, false).decide(ring("QQ")).verdict == "proved"
    assert certified(Angles(CIRCLE_CORE, false), None)["verdict"] == "refuted"
    assert certified(Angles(false, CIRCLE_CORE), None)["assumes"] == []


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
    data = certified(Assertion("1 + 1 == 2"), None)
    with pytest.raises(Rejected, match="parts"):
        check(changed(data, statement=text))


def test_what_holds_in_the_panel_may_fail_elsewhere() -> None:
    assert Negation(Assertion("11 != 0")).decide(None).verdict == "undecided"  # GF(11) is not in it
    assert Negation(Assertion("11 != 0")).decide(ring("GF(7)")).verdict == "refuted"
    assert Negation(Assertion("q == 0 => norm(q) == 0")).decide(None).verdict == "refuted"


def test_both_sides_cite() -> None:
    false = Assertion("1 == 2")
    for proposition in (
        Implication(ModulusDefined(), false),
        Equivalence(ModulusDefined(), false),
        Equivalence(Assertion("1 == 1"), ModulusDefined()),
        Every((ModulusDefined(), Assertion("1 == 1"))),
    ):
        assert certified(proposition, "RR")["assumes"] == [REAL_ROOTS]
