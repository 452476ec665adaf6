"""Theorem 1: relations, and what follows from them in associative algebras."""

from itertools import product

import pytest

from hfield import Rejected, check, prove
from hfield.cli import main
from hfield.errors import NotationError
from hfield.prover.methods.presentations import decide_presentation, presentation_text

RELATIONS = ["i*i == -e", "j*j == -e", "k*k == -e", "i*j*k == -e"]
TABLE = ["i*j == k", "j*k == i", "k*i == j", "j*i == -k", "k*j == -i", "i*k == -j"]
IDENTITY = ["e*e == e", "e*i == i", "i*e == i", "e*j == j", "j*e == j", "e*k == k", "k*e == k"]


def expand(terms, relations):
    out = {}
    for c, left, n, right in terms:
        for d, word in relations[n]:
            key = left + word + right
            out[key] = out.get(key, 0) + c * d
    return {w: c for w, c in out.items() if c}


def test_the_table_follows_over_every_ring():
    decision = decide_presentation(RELATIONS, TABLE)
    assert (decision.verdict, decision.scope) == ("proved", "commutative rings")
    evidence = decision.evidence
    for goal, proof in zip(evidence["goals"], evidence["proofs"], strict=True):
        assert proof["denominator"] == 1
        assert expand(proof["cofactors"], evidence["relations"]) == {w: c for c, w in goal}
        assert len(proof["cofactors"]) <= 8


@pytest.mark.parametrize("wrong", ["i*j == -k", "j*i == k", "k*i == i", "i*j == k + e"])
def test_a_wrong_sign_does_not_follow(wrong):
    assert decide_presentation(RELATIONS, [*TABLE, wrong]).verdict == "refuted"


def test_in_characteristic_2_signs_do_not_matter():
    decision = decide_presentation(RELATIONS, ["i*j == -k", "j*i == k"], field="GF(4)")
    assert (decision.verdict, decision.scope) == ("proved", "characteristics [2]")


def value(table, word):
    vector = {word[0]: 1}
    for letter in word[1:]:
        out = {}
        for at, c in vector.items():
            for name, d in zip("eijk", table[at + letter], strict=True):
                out[name] = out.get(name, 0) + c * d
        vector = out
    return [vector.get(name, 0) for name in "eijk"]


@pytest.mark.parametrize("field", [None, "QQ", "GF(2)", "GF(3)", "GF(4)", "GF(13)"])
def test_without_the_identity_the_theorem_fails_in_every_characteristic(field):
    decision = decide_presentation(RELATIONS, [*TABLE, *IDENTITY], identity=False, field=field)
    assert decision.verdict == "refuted"
    evidence = decision.evidence
    p, table = evidence["characteristic"], evidence["table"]

    def is_zero(vector):
        return all(c % p == 0 if p else c == 0 for c in vector)

    def evaluate(f):
        return [
            sum(c * v for c, v in zip([c for c, _ in f], column, strict=True))
            for column in zip(*(value(table, w) for _, w in f), strict=True)
        ]

    for x, y, z in product("eijk", repeat=3):
        left, right = {}, {}
        for name, c in zip("eijk", table[x + y], strict=True):
            for at, d in zip("eijk", table[name + z], strict=True):
                left[at] = left.get(at, 0) + c * d
        for name, c in zip("eijk", table[y + z], strict=True):
            for at, d in zip("eijk", table[x + name], strict=True):
                right[at] = right.get(at, 0) + c * d
        assert is_zero([left[n] - right[n] for n in "eijk"])
    assert all(is_zero(evaluate(f)) for f in evidence["relations"])
    assert evaluate(evidence["goals"][evidence["goal"]]) == evidence["value"]
    assert not is_zero(evidence["value"])


def test_the_converse_and_other_relations():
    table = [*TABLE, "i*i == -e", "j*j == -e", "k*k == -e"]
    assert decide_presentation(table, RELATIONS).verdict == "proved"
    assert decide_presentation(["i*j == k", "j*i == -k"], ["i*j + j*i == 0"]).verdict == "proved"
    assert decide_presentation(RELATIONS[:3], TABLE).verdict == "refuted"
    assert decide_presentation(["2*i == 0"], ["i == 0"], field="GF(3)").verdict == "proved"
    assert decide_presentation(["2*i == 0"], ["i == 0"], field="QQ").verdict == "proved"
    assert decide_presentation(["2*i == 0"], ["i == 0"]).verdict != "proved"


def test_words_may_be_given_as_mappings():
    decision = decide_presentation(
        [{"ii": 1, "": 1}, {"jj": 1, "": 1}, {"kk": 1, "": 1}, {"ijk": 1, "": 1}],
        [{"ij": 1, "k": -1}],
    )
    assert decision.verdict == "proved"
    assert decision.steps[0].startswith("ij − k =") or "(ij − k)" in decision.steps[0]


def test_presentations_as_text():
    text = presentation_text(["i*i == -e"], ["i*i*i == -i"])
    assert text == "associative(i, j, k): i*i == -e => i*i*i == -i"
    assert presentation_text(["i*i == -e"], ["e*i == i"], False).startswith("associative(e, i")


@pytest.mark.parametrize(
    "bad", ["i*q == 0", "norm(i) == 0", "i == j == k", "i/2 == 0", "(i+j)**99"]
)
def test_what_is_no_relation_is_refused(bad):
    with pytest.raises(NotationError):
        decide_presentation([bad], ["i == 0"])


def test_without_identity_numbers_mean_nothing():
    with pytest.raises(NotationError, match="no identity"):
        decide_presentation(["i*i == -1"], ["i == 0"], identity=False)


HAMILTON = "i*i == j*j == k*k == i*j*k == -1"


@pytest.mark.parametrize(
    ("statement", "relations", "field", "verdict"),
    [
        ("i*j == k and j*k == i and k*i == j", HAMILTON, None, "proved"),
        ("j*i == -k", HAMILTON, "GF(2)", "proved"),
        ("i*j == -k", HAMILTON, None, "refuted"),
        ("i*j == -k", HAMILTON, "GF(2)", "proved"),
        ("k**2 == -1", ["i² = j² = 1", "j·i = −i·j and k = i·j"], None, "proved"),
        ("k**2 == 1", "i*i == j*j == 1 and j*i == -i*j and k == i*j", "QQ", "refuted"),
        ("i*j == j*i", "i*i == j*j == k*k == 1 and i*j == k", None, "proved"),
        ("i*j == j*i", "i*i == j*j == 1", None, "refuted"),
        ("(i + j)**2 == 0", "i**2 == j**2 == i*j + j*i == 0", None, "proved"),
        ("i == 0", "2*i == 0", None, "refuted"),
        ("i == 0", "2*i == 0", "QQ", "proved"),
        ("i == j", "i*i == 0 and i*i == 1", None, "vacuous"),
    ],
)
def test_what_follows_from_relations_in_every_ring(statement, relations, field, verdict):
    answer = prove(statement, field, relations=relations)
    assert answer.verdict == verdict
    assert check(answer.certificate).verdict == verdict
    assert "every ring with identity" in str(answer)


def test_consequences_are_none_of_other_relations():
    good = prove("i*j == k", relations=HAMILTON).certificate
    for old, new in (
        ("k*k == -1", "k*k == 1"),
        ("=> i*j == k", "=> i*j == -k"),
        ("and i*j*k == -1", ""),
    ):
        assert old in good["statement"]
        with pytest.raises(Rejected):
            check(good | {"statement": good["statement"].replace(old, new)})
    bad = prove("i*j == -k", relations=HAMILTON).certificate
    with pytest.raises(Rejected):
        check(bad | {"statement": good["statement"]})


@pytest.mark.parametrize(
    ("statement", "options", "words"),
    [
        ("i*j == k", {"relations": "i*i"}, "is not a relation: expected an equation"),
        ("i*j == k", {"relations": "i*i == == 1"}, "after '=='"),
        ("i*j == p", {"relations": "i == 1"}, "a polynomial in i, j, k and the identity e"),
        ("i*j != k", {"relations": "i == 1"}, "must be equations, joined by 'and'"),
        ("i*j == k", {"relations": "i == 1", "algebra": "(-1,-3|QQ)"}, "leave the algebra out"),
        ("i*j == k", {"relations": "i == 1", "given": "j == 1"}, "leave the algebra out"),
    ],
)
def test_what_is_no_question_about_relations(statement, options, words):
    with pytest.raises(NotationError, match=words):
        prove(statement, **options)


def test_the_option_relations(capsys):
    assert main(["prove", "i*j == k", "--relations", HAMILTON]) == 0
    assert main(["prove", "i*j == k", "--relations", "i*i == -1", "--relations", "j*j == -1"]) == 1
    assert capsys.readouterr().out.count("in every ring with identity") == 2


def test_in_h_the_basis_is_no_unknown():
    assert "i, j and k are the basis vectors" in str(prove("i*i == 1 and j*j == 1 => i*j == k"))
    assert "constants here" not in str(prove("p == i => p*j == k"))
