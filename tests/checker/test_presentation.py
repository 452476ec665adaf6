"""Statements about all associative algebras: what is read, what shows them, and what does not."""

import copy
from typing import Any

import pytest

from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.checker.vocabulary import presentation
from hfield.checker.vocabulary.presentation import read_presentation
from tests.checker.cases import Certificate, about_field, certified
from tests.subcases import subcases

WITH_E = "associative(e, i, j, k): "
UNITS = "eijk"


def words(f: dict[str, int]) -> list[Any]:
    return [[c, word] for word, c in f.items()]


def evidence(identity: bool, relations: Any, goals: Any, p: int = 0, **own: Any) -> dict[str, Any]:
    return {
        "kind": "presentation" if "proofs" in own else "algebra",
        "characteristic": p,
        "identity": identity,
        "relations": [words(f) for f in relations],
        "goals": [words(f) for f in goals],
        **own,
    }


def proof(*cofactors: Any, d: int = 1) -> dict[str, Any]:
    return {"cofactors": [list(c) for c in cofactors], "denominator": d}


def accepted(data: Certificate) -> str:
    return check(data).scope


def rejects(data: Certificate, why: str, **changes: Any) -> None:
    """Reject the certificate with changes of its keys, or of those of its evidence."""
    spoilt = copy.deepcopy(data)
    for key, value in changes.items():
        (spoilt if key in spoilt else spoilt["evidence"])[key] = value
    with pytest.raises(Rejected) as caught:
        check(spoilt)
    assert why in str(caught.value), str(caught.value)


# i·k + j = (i·i + 1)·j − i·(i·j − k)
SQUARES = ({"ii": 1, "": 1}, {"ij": 1, "k": -1})
PROVED = certified(
    "associative(i, j, k): i*i == -1 and i*j == k => i*k == -j",
    None,
    "presentation",
    evidence(
        True,
        SQUARES,
        [{"ik": 1, "j": 1}],
        proofs=[proof([1, "", 0, "j"], [-1, "i", 1, ""])],
    ),
)
TWICE = certified(
    "associative(i, j, k): 2*i == 0 => i == 0",
    "QQ",
    "presentation",
    evidence(True, [{"i": 2}], [{"i": 1}], proofs=[proof([1, "", 0, ""], d=2)]),
)
THREE = certified(
    "associative(i, j, k): 4*i == 1 => i == 1",
    "GF(3)",
    "presentation",
    evidence(True, [{"i": 4, "": -1}], [{"i": 1, "": -1}], 3, proofs=[proof([1, "", 0, ""])]),
)
# The commutative algebra with i² = j² = −1: i·j is not −j·i.
TABLE = {x + "e": [int(x == u) for u in UNITS] for x in UNITS}
TABLE |= {"e" + x: [int(x == u) for u in UNITS] for x in UNITS}
TABLE |= {"ii": [-1, 0, 0, 0], "jj": [-1, 0, 0, 0], "kk": [1, 0, 0, 0]}
TABLE |= {"ij": [0, 0, 0, 1], "ik": [0, 0, -1, 0], "jk": [0, -1, 0, 0]}
TABLE |= {y + x: TABLE[x + y] for x, y in ("ij", "ik", "jk")}
REFUTED = {
    **certified(
        "associative(i, j, k): i*i == -1 and i*j == k => i*k == -j and i*j == -j*i",
        None,
        "algebra",
        evidence(
            True,
            SQUARES,
            [{"ik": 1, "j": 1}, {"ij": 1, "ji": 1}],
            table=TABLE,
            goal=1,
            value=[0, 0, 0, 2],
        ),
    ),
    "verdict": "refuted",
}
# x·y = λ(x)·y with λ(e) = 1, λ(i) = λ(j) = λ(k) = 0: e is an identity from the left alone.
LEFT = {x + y: [int(x == "e" and y == u) for u in UNITS] for x in UNITS for y in UNITS}
ONE_SIDED = {
    **certified(
        f"{WITH_E}e*i == i => i*e == i",
        "QQ",
        "algebra",
        evidence(
            False,
            [{"ei": 1, "i": -1}],
            [{"ie": 1, "i": -1}],
            table=LEFT,
            goal=0,
            value=[0, -1, 0, 0],
        ),
    ),
    "verdict": "refuted",
}


def test_what_is_read() -> None:
    found = read_presentation(
        " associative ( i,j, k ) : (i + 2*j)**2 == 3 - e*i and 0 == i => -(i - j)*2 == k*j*e - 4"
    )
    assert found is not None
    assert found.identity is True
    assert found.relations == ({"ii": 1, "ij": 2, "ji": 2, "jj": 4, "i": 1, "": -3}, {"i": -1})
    assert found.goals == ({"i": -2, "j": 2, "kj": -1, "": 4},)
    whole = read_presentation(f"{WITH_E}0 == e*k - k => e**3 == e and 2*i == i + i")
    assert whole is not None
    assert (whole.identity, whole.relations) == (False, ({"ek": -1, "k": 1},))
    assert whole.goals == ({"eee": 1, "e": -1}, {})
    assert read_presentation("i*j == k") is None
    assert read_presentation("associative(x): i == j") is None


@subcases(
    ("text", "why"),
    [
        ("associative(i, k, j): i == j => j == i", "expected associative(i, j, k)"),
        ("associative(i, j): i == j => j == i", "expected associative(i, j, k)"),
        ("associative(i, j, k): i == j", "expected relations => goals"),
        ("associative(i, j, k): i == j or j == k => j == i", "are equations"),
        ("associative(i, j, k): i == j => j != i", "are equations"),
        ("associative(i, j, k): i == m => j == i", "integer coefficients"),
        ("associative(i, j, k): i == 0.5 => j == i", "integer coefficients"),
        ("associative(i, j, k): i == 0.5*j => j == i", "integer coefficients"),
        ("associative(i, j, k): i**0 == j => j == i", "integer coefficients"),
        ("associative(i, j, k): i**(-1) == j => j == i", "integer coefficients"),
        ("associative(i, j, k): i**201 == j => j == i", "integer coefficients"),
        ("associative(i, j, k): i/2 == j => j == i", "integer coefficients"),
        (f"{WITH_E}i == 1 => j == i", "integer coefficients"),
        ("associative(i, j, k): i**100*j**101 == j => j == i", "a word is too long"),
        ("associative(i, j, k): (i + j)**13 == j => j == i", "too many terms"),
        # Numbers have no letters, but grow: each of these would take gigabytes.
        ("associative(i, j, k): ((9**200)**200)**200 == j => j == i", "coefficient has grown"),
        (f"{WITH_E}{'9' * 3000}*({'9' * 3000}*i) == j => j == i", "coefficient has grown"),
    ],
)
def test_what_is_not_read(text: str, why: str) -> None:
    with pytest.raises(Rejected) as caught:
        read_presentation(text)
    assert why in str(caught.value)


def test_bounds_are_exact(monkeypatch: pytest.MonkeyPatch) -> None:
    found = read_presentation("associative(i, j, k): i**200 == 0 => j**100*k**100 == 0")
    assert found is not None
    assert found.relations == ({"i" * 200: 1},)
    monkeypatch.setattr(presentation, "MAX_WORDS", 4)
    assert read_presentation("associative(i, j, k): (i + j)**2 == 0 => j == 0")
    with pytest.raises(Rejected, match="too many terms"):
        read_presentation("associative(i, j, k): (i + j)*(i + j + k) == 0 => j == 0")


def test_what_is_shown_is_accepted() -> None:
    assert accepted(PROVED) == "commutative rings"
    for data in (TWICE, THREE, REFUTED, ONE_SIDED):
        assert accepted(data) == "field"
    over = about_field(PROVED, "GF(4)")
    assert accepted(over) == "field"
    # In characteristic 3 the same value may be written otherwise; so may the table.
    three = copy.deepcopy(about_field(REFUTED, "GF(9)"))
    three["evidence"] |= {"characteristic": 3, "value": [0, 3, -3, -1]}
    three["evidence"]["table"]["kk"] = [1, 0, 3, 0]
    assert accepted(three) == "field"


def test_proofs_of_something_else_are_rejected() -> None:
    goal = "is not the goal"
    right = [1, "", 0, "j"], [-1, "i", 1, ""]
    for cofactors in (
        [right[0]],
        [right[1]],
        [*right, right[0]],
        [[1, "", 0, "i"], right[1]],
        [[1, "j", 0, ""], right[1]],
        [right[0], [1, "i", 1, ""]],
        [right[0], [-1, "", 1, "i"]],
        [right[0], [-1, "i", 0, ""]],
    ):
        rejects(PROVED, goal, proofs=[proof(*cofactors)])
    rejects(PROVED, "as many proofs", proofs=[])
    rejects(PROVED, "as many proofs", proofs=[proof(*right)] * 2)
    rejects(PROVED, goal, proofs=[proof()])
    for d in (2, 3):
        rejects(PROVED, "may be 0", proofs=[proof(*right, d=d)])
    for d in (0, -1):
        rejects(PROVED, "a denominator must be at least 1", proofs=[proof(*right, d=d)])
    for n in (2, 3):
        rejects(PROVED, "no relation of that number", proofs=[proof([1, "", n, ""])])
    for entry in ([1, "", 0], [1, "", 0, "", ""], "1, 0", {}):
        rejects(PROVED, "a cofactor is a list", proofs=[{"cofactors": [entry], "denominator": 1}])
    for entry, said in (
        ([1.5, "", 0, ""], "a coefficient must be an integer"),
        ([1, 2, 0, ""], "a word must be a text"),
        ([1, "", "0", ""], "the number of a relation must be an integer"),
        ([1, "", -1, ""], "the number of a relation must be at least 0"),
        ([1, "", 0, "x"], "'x' is not a word"),
        ([1, "e", 0, ""], "'e' is not a word"),
        ([1, "i" * 201, 0, ""], "a word has 201 characters"),
    ):
        raw = {"cofactors": [[1, "", 0, ""], entry], "denominator": 1}
        if 1.5 not in entry:
            rejects(PROVED, said, proofs=[raw])
    rejects(PROVED, "a coefficient must be an integer", proofs=[proof(["1", "", 0, ""])])
    rejects(PROVED, "a proof lacks the key 'denominator'", proofs=[{"cofactors": []}])
    rejects(PROVED, "cofactors must be a list", proofs=[{"cofactors": {}, "denominator": 1}])
    rejects(
        PROVED, "a denominator must be an integer", proofs=[{"cofactors": [], "denominator": ""}]
    )
    rejects(PROVED, "proofs must be a list", proofs={})


def test_where_a_proof_holds() -> None:
    """Dividing by 2 needs a field in which 2 is not 0; a proof modulo 3 is one in characteristic 3."""

    def over(data: Certificate, field: str | None) -> Certificate:
        return about_field(data, field)

    for field in ("GF(3)", "GF(9)"):
        assert accepted(over(TWICE, field)) == accepted(over(THREE, field)) == "field"
    for other in (None, "GF(2)", "GF(4)"):
        rejects(over(TWICE, other), "a denominator may be 0")
    for other in (None, "QQ", "GF(5)"):
        rejects(over(THREE, other), "valid in one characteristic only")
    rejects(THREE, "is not the goal", characteristic=0)
    rejects(THREE, "the characteristic is not a prime", characteristic=9)
    rejects(THREE, "the characteristic must be an integer", characteristic="3")
    rejects(THREE, "the characteristic must be at least 0", characteristic=-3)
    for ring in ("ZZ", "ZZ/6"):
        rejects(over(PROVED, ring), "over fields, or over all of them")


def test_the_evidence_repeats_the_statement() -> None:
    for key in ("relations", "goals"):
        own = PROVED["evidence"][key]
        assert accepted(PROVED)
        not_those = f"the {key} of the evidence are not those of the statement"
        rejects(PROVED, not_those, **{key: [*own, own[0]]})
        rejects(PROVED, not_those, **{key: [own[0][:1], *own[1:]]})
        rejects(PROVED, not_those, **{key: [[[2, own[0][0][1]], *own[0][1:]], *own[1:]]})
        rejects(PROVED, f"{key} has 0 entries", **{key: []})
        rejects(PROVED, f"{key} must be a list", **{key: "i*i"})
        rejects(PROVED, f"an entry of {key} must be a list", **{key: ["i*i", *own[1:]]})
        for pair in ([1, "ij", 0], own[0][0]):
            cannot = f"a term of {key} cannot be read"
            rejects(PROVED, cannot, **{key: [[*own[0], pair], *own[1:]]})
        rejects(PROVED, "a term has 1 entries", **{key: [[[1]], *own[1:]]})
        rejects(PROVED, "a coefficient must be an integer", **{key: [[["1", "i"]], *own[1:]]})
        rejects(PROVED, "a word must be a text", **{key: [[[1, 1]], *own[1:]]})
    for value in (False, 1, None, "true"):
        rejects(PROVED, "whether e is the identity", identity=value)
    rejects(PROVED, "has an unknown key 'more'", evidence={**PROVED["evidence"], "more": 1})
    for data, other in ((PROVED, "refuted"), (PROVED, "vacuous"), (REFUTED, "proved")):
        rejects(data, f"does not show that this is {other}", verdict=other)
    rejects(PROVED, "evidence of the kind 'identity' does not show", kind="identity")
    for data in (PROVED, REFUTED):
        for key in data["evidence"]:
            without = {k: v for k, v in data["evidence"].items() if k != key}
            rejects(data, "'kind'" if key == "kind" else f"lacks the key {key!r}", evidence=without)


def test_every_entry_of_a_table_counts() -> None:
    data, table = REFUTED, REFUTED["evidence"]["table"]
    for xy, value in table.items():
        for n in range(4):
            changed = [c + (n == m) for m, c in enumerate(value)]
            with pytest.raises(Rejected, match=r"associative|identity|relation|value"):
                check({**data, "evidence": {**data["evidence"], "table": {**table, xy: changed}}})
        missing = {key: v for key, v in table.items() if key != xy}
        rejects(data, f"the table lacks the key {xy!r}", table=missing)
        for wrong, said in (
            (value[:3], "coordinates has 3 entries"),
            ([*value, 0], "four small coordinates"),
            ([10**9 + 1, 0, 0, 0], "four small coordinates"),
            ([0, 0, 0, -(10**9) - 1], "four small coordinates"),
            (["0"] * 4, "a coordinate must be an integer"),
        ):
            rejects(data, said, table={**table, xy: wrong})


def test_what_a_table_shows() -> None:
    rejects(REFUTED, "it is 0", goal=0, value=[0, 0, 0, 0])
    for value in ([0, 0, 0, 1], [0, 0, 0, -2], [1, 0, 0, 2]):
        rejects(REFUTED, "does not have the value", value=value)
    for goal, said in (
        (2, "no goal of that number"),
        (-1, "the number of a goal must be at least 0"),
    ):
        rejects(REFUTED, said, goal=goal)
    rejects(REFUTED, "the number of a goal must be an integer", goal="1")
    rejects(REFUTED, "four small coordinates", value=[0, 0, 0, 2, 0])
    two = about_field(REFUTED, "GF(2)")
    rejects(two, "it is 0", characteristic=2, value=[0, 0, 0, 0])
    rejects(two, "over another characteristic")
    rejects(about_field(REFUTED, "QQ"), "over another", characteristic=3)
    # i·i = −1, but i·j = 0 in this one; and everything is 0 in the last.
    wrong = {**TABLE, **dict.fromkeys(("ij", "ji", "ik", "ki", "jj", "jk", "kj", "kk"), [0] * 4)}
    rejects(REFUTED, "the table is not associative", table=wrong)
    rejects(REFUTED, "e is not the identity of the table", table=dict.fromkeys(TABLE, [0] * 4))
    rejects(REFUTED, "e is not the identity of the table", table=LEFT)
    # x·y = x·λ(y): an identity from the right alone
    right = {x + y: LEFT[y + x] for x in UNITS for y in UNITS}
    rejects(REFUTED, "e is not the identity of the table", table=right)
    rejects(ONE_SIDED, "a relation does not hold", table=right)
    commuting = {**REFUTED["evidence"], "relations": [words({"ii": 1, "": -1}), words(SQUARES[1])]}
    other = REFUTED["statement"].replace("i*i == -1", "i*i == 1")
    rejects({**REFUTED, "statement": other}, "a relation does not hold", evidence=commuting)


def test_many_cofactors_take_no_time_of_their_own() -> None:
    """Each costs what its relation has terms, and not what was added up before."""
    own = [[1, "i" * (n % 150), 1, "j" * (n // 150)] for n in range(15_000)]
    rejects(PROVED, "is not the goal", proofs=[proof(*own)])
