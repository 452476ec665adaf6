"""Words of the ledger's vocabulary: evidence that shows them, and what it does not show."""

from itertools import product
from typing import Any

import pytest

from hfield.checker.check import check
from hfield.checker.glossary import CIRCLE, COMPLEX_ROOTS, INDUCTION, KULIKOV, REAL_ROOTS
from hfield.checker.rejection import Rejected
from tests.checker.cases import certified, with_rings
from tests.checker.ring_data import data_of
from tests.subcases import subcases

TUPLES = [["".join(t) for t in product("eijk", repeat=k)] for k in (1, 2, 3)]
IDENTITY = {"kind": "identity"}
MINOR = {"kind": "minor", "rows": [2, 3, 7], "columns": [1, 2, 3]}
NO_LEVEL = {"kind": "squares", "values": ["I"]}
ELEMENTS = [["1", "0", "0", "0"], ["I", "0", "0", "0"]]
CHOICES: dict[str, Any] = {
    "kind": "all choices",
    "elements": ELEMENTS,
    "roots": ["1", "I"],
}
ZERO = {"kind": "zero norm", "value": ["I", "1", "0", "0"]}
HALF = {"kind": "squares", "values": ["2", "1"]}  # 4 + 1 = −1 in GF(3)


def proved(evidence: Any) -> dict[str, Any]:
    return {"verdict": "proved", "evidence": evidence}


def refuted(evidence: Any) -> dict[str, Any]:
    return {"verdict": "refuted", "evidence": evidence}


def both(left: Any, right: Any) -> dict[str, Any]:
    return {"kind": "both", "left": left, "right": right}


def over(field: str, evidence: Any) -> dict[str, Any]:
    return {"kind": "over", "ring": data_of(field), "evidence": evidence}


def at(values: dict[str, list[str]], field: str) -> dict[str, Any]:
    return {"kind": "witness", "ring": data_of(field), "values": values}


def tuples(*arities: int) -> dict[str, Any]:
    return {"kind": "basis tuples", "tuples": [TUPLES[k - 1] for k in arities]}


LEVEL, ORDERED = {"kind": "level"}, {"kind": "anisotropic", "by": "ordering"}
NOT_COMMUTING = at({"p": ["0", "1", "0", "0"], "q": ["0", "0", "1", "0"]}, "GF(3)")
NORM_I = {"kind": "witness", "value": ["I", "0", "0", "0"], "norm": -1}
DET, COUNT, COMMUTATIVE_RINGS = {"kind": "determinant"}, {"kind": "count"}, "commutative rings"
LEFT_OUT: dict[str, Any] = {"kind": "left out", "tuple": ""}
ALL, NO_ROOT, PARTS = {"kind": "basis tuples"}, {"kind": "no root"}, {"kind": "parts"}
PART: dict[str, Any] = {"kind": "part", "part": 0, "evidence": NOT_COMMUTING}
COMMUTES, IF_ONLY = "implies{level-above{1}; p*q == q*p}", "iff{level-above{1}; p*q == q*p}"
DIVIDES, CITING = "implies{formally-real; division}", "citing{induction; determined-by{all; 1}}"
EVERY, SECOND = "every{formally-real; q == q}", "every{q == q; p*q == q*p}"
CONSTANT = "determined-by{constant; 2,3}"
# Statement, field, verdict, method, what is cited, evidence, scope.
Row = tuple[str, str | None, str, str, str | None, dict[str, Any], str]
GOOD: list[Row] = [
    ("basis{2; 1,2; 3,7}", None, "proved", "determinant", None, DET, COMMUTATIVE_RINGS),
    ("basis{2; 1,2; 3,5}", None, "proved", "determinant", None, DET, COMMUTATIVE_RINGS),
    ("basis{2; 1,2; 3,4}", "GF(3)", "proved", "determinant", None, DET, "field"),
    ("basis{2; 1,2; 3,4}", None, "refuted", "determinant", None, DET, "field"),
    ("basis{2; 1,2; 3,4}", "GF(2)", "refuted", "determinant", None, DET, "field"),
    ("basis{3; 0,1,0; 0,0,1; 1,0,0}", "QQ", "proved", "determinant", None, DET, "field"),
    ("basis{3; 1,0,0; 0,1,0}", None, "refuted", "count", None, COUNT, "field"),
    ("basis{2; 1,0; 1}", "QQ", "refuted", "count", None, COUNT, "field"),
    ("centre{2}", None, "proved", "Smith form", None, MINOR, "fields"),
    ("centre{2}", "QQ", "proved", "linear algebra", None, MINOR, "field"),
    ("centre{2}", "GF(4)", "proved", "linear algebra", None, MINOR, "field"),
    ("centre{3}", "GF(5)", "proved", "linear algebra", None, MINOR, "field"),
    ("determined-by{all; 1,3}", None, "proved", "basis tuples", None, tuples(1, 3), COMMUTATIVE_RINGS),
    ("determined-by{all; 2}", "QQ", "proved", "basis tuples", None, tuples(2), "field"),
    (CONSTANT, None, "refuted", "basis tuples", None, {**LEFT_OUT, "tuple": "ei"}, "field"),
    ("determined-by{short; 2}", None, "refuted", "basis tuples", None, {**LEFT_OUT, "tuple": "ek"}, "field"),
    ("determined-by{all-but-one; 3}", None, "refuted", "basis tuples", None,
     {**LEFT_OUT, "tuple": "kkk"}, "field"),
    ("curried-linear{1}", None, "proved", "identity", None, IDENTITY, COMMUTATIVE_RINGS),
    ("curried-linear{1}", "QQ", "proved", "identity", None, IDENTITY, "field"),
    ("last-argument{4; 1,2}", None, "proved", "identity", None, IDENTITY, COMMUTATIVE_RINGS),
    ("last-argument{4; 1}", "GF(2)", "proved", "identity", None, IDENTITY, "field"),
    ("last-argument{3; 1,2}", None, "refuted", "identity", None, IDENTITY, "field"),
    ("last-argument{5; 2}", None, "refuted", "identity", None, IDENTITY, "field"),
    (CITING, None, "proved", "basis tuples", INDUCTION, tuples(1), COMMUTATIVE_RINGS),
    ("citing{induction; last-argument{5; 1}}", None, "refuted", "identity", None, IDENTITY, "field"),
    ("division", "QQ", "proved", "anisotropic norm", None, ORDERED, "field"),
    ("division", "QQ(I)", "refuted", "zero norm", None, ZERO, "field"),
    ("division", None, "refuted", "zero norm", None, over("QQ(I)", ZERO), "field"),
    ("not-everywhere{division}", None, "proved", "witness", None, over("QQ(I)", ZERO), "field"),
    ("not-everywhere{division}", "QQ(I)", "proved", "witness", None, over("QQ(I)", ZERO), "field"),
    ("level-above{1}", "GF(7)", "proved", "level", None, LEVEL, "field"),
    ("level-above{2}", "GF(3)", "refuted", "sum of squares", None, {**HALF, "values": ["1", "1"]}, "field"),
    ("formally-real", "QQ(sqrt(2))", "proved", "level", None, LEVEL, "field"),
    ("formally-real", "QQ(I)", "refuted", "sum of squares", None, NO_LEVEL, "field"),
    ("norm-criterion{>}", "QQ", "proved", "ordering", None, {"kind": "ordering"}, "field"),
    ("norm-criterion{>}", "QQ(I)", "refuted", "witness", None, NORM_I, "field"),
    ("norm-criterion{<}", "QQ", "refuted", "witness", None,
     {**NORM_I, "value": ["1", "0", "0", "0"], "norm": 1}, "field"),
    ("modulus-exists", "RR", "proved", "closed field", REAL_ROOTS, {"kind": "closed"}, "field"),
    ("modulus-exists", "CC", "proved", "closed field", COMPLEX_ROOTS, {"kind": "closed"}, "field"),
    ("modulus-exists", "GF(4)", "proved", "identity", None, IDENTITY, "field"),
    ("modulus-exists", "QQ", "refuted", "witness", None, {**NO_ROOT, "value": ["1", "1", "0", "0"]}, "field"),
    ("modulus-law{*}", "QQ", "proved", "ordering", None, {"kind": "ordering"}, "field"),
    ("modulus-law{*}", "GF(8)", "proved", "unique roots", None, {"kind": "unique roots"}, "field"),
    ("modulus-law{*}", "GF(7)", "proved", "exhaustion", None, {"kind": "square roots"}, "field"),
    ("modulus-law{*}", "GF(27)", "proved", "exhaustion", None, {"kind": "square roots"}, "field"),
    ("modulus-law{*}", "GF(263)", "proved", "choice of roots", None, {"kind": "square roots"}, "field"),
    ("modulus-law{*}", "QQ(sqrt(-7))", "proved", "choice of roots", KULIKOV,
     {"kind": "pure subgroup"}, "field"),
    ("modulus-law{*}", "QQ(I)", "refuted", "all choices of roots", None, CHOICES, "field"),
    ("modulus-law{+}", "QQ", "refuted", "all choices of roots", None,
     CHOICES | {"elements": ELEMENTS[:1], "roots": ["1"]}, "field"),
    (DIVIDES, "QQ", "proved", "anisotropic norm", None, {"kind": "conclusion", "evidence": ORDERED}, "field"),
    (DIVIDES, "QQ(I)", "vacuous", "sum of squares", None,
     {"kind": "hypothesis", "evidence": NO_LEVEL}, "field"),
    (COMMUTES, "GF(3)", "refuted", "identity", None, both(proved(LEVEL), refuted(NOT_COMMUTING)), "field"),
    (COMMUTES, None, "refuted", "identity", None, over("GF(3)",
     both(proved(LEVEL), refuted(NOT_COMMUTING))), "field"),
    ("iff{level-above{1}; formally-real}", "QQ", "proved", "level", None,
     both(proved(LEVEL), proved(LEVEL)), "field"),
    ("iff{division; formally-real}", "QQ(I)", "proved", "zero norm; sum of squares", None,
     both(refuted(ZERO), refuted(NO_LEVEL)), "field"),
    (IF_ONLY, "GF(3)", "refuted", "level; identity", None,
     both(proved(LEVEL), refuted(NOT_COMMUTING)), "field"),
    (DIVIDES, None, "proved", "identity", None, {"kind": "lemmas", "proofs": [IDENTITY] * 4}, "fields"),
    (EVERY, "QQ", "proved", "level; identity", None,
     {**PARTS, "parts": [proved(LEVEL), proved(IDENTITY)]}, "field"),
    (SECOND, "GF(3)", "refuted", "identity", None, {**PART, "part": 1}, "field"),
]  # fmt: skip


def certificate(row: Row, **changes: Any) -> dict[str, Any]:
    statement, field, verdict, method, cites, evidence, _ = row
    field = changes.get("field", field)
    statement, evidence = changes.pop("statement", statement), changes.pop("evidence", evidence)
    assumes = [cites] if cites else []
    data = certified(statement, field, method, evidence)
    return {**data, "verdict": verdict, "assumes": assumes, **changes}


def rejects(row: Row, **changes: Any) -> None:
    """Reject for what it says and not for how it calls it."""
    with pytest.raises(Rejected) as caught:
        check(certificate(row, **changes))
    assert "not that of the evidence" not in str(caught.value)
    assert "exactly what the evidence cites" not in str(caught.value)


@subcases("row", GOOD)
def test_what_is_shown_is_accepted_and_nothing_else(row: Row) -> None:
    assert check(certificate(row)).scope == row[6]
    for verdict in {"proved", "refuted", "vacuous"} - {row[2]}:
        rejects(row, verdict=verdict)
    for extra in ({"more": 1}, {"kind": "nothing"}):
        rejects(row, evidence={**row[5], **extra})
    for key in row[5]:
        rejects(row, evidence={k: v for k, v in row[5].items() if k != key})
    with pytest.raises(Rejected, match="is not that of the evidence"):
        check(certificate(row, method="nothing"))
    if row[4] is None:
        with pytest.raises(Rejected, match="exactly what the evidence cites"):
            check(certificate(row, assumes=[KULIKOV]))


def row_of(statement: str, field: str | None, verdict: str = "") -> Row:
    found = [r for r in GOOD if r[:2] == (statement, field) and verdict in ("", r[2])]
    return found[0]


BAD: list[tuple[str, str | None, dict[str, Any]]] = [
    # A determinant 1, −2 or 0, and not it; vectors as many and as long as said.
    ("basis{2; 1,2; 3,7}", None, {"statement": "basis{2; 1,2; 3,8}"}),
    ("basis{2; 1,2; 3,7}", None, {"statement": "basis{2; 1,2; 3,6}"}),
    ("basis{2; 1,2; 3,7}", None, {"evidence": COUNT, "verdict": "refuted"}),
    ("basis{2; 1,2; 3,4}", "GF(3)", {"field": "GF(2)"}),
    ("basis{2; 1,2; 3,4}", "GF(3)", {"field": "ZZ"}),
    ("basis{3; 1,0,0; 0,1,0}", None, {"evidence": DET}),
    ("basis{3; 1,0,0; 0,1,0}", None, {"statement": "basis{2; 1,0; 0,1}"}),
    ("basis{2; 1,2; 3,7}", None, {"statement": "basis{2}"}),
    ("basis{2; 1,2; 3,7}", None, {"statement": "basis{2,2; 1,2; 3,7}"}),
    ("basis{2; 1,2; 3,7}", None, {"statement": "basis{2; 1,x; 3,7}"}),
    ("basis{2; 1,2; 3,7}", None, {"statement": "basis{2; 1,2; 3,123456789}"}),
    ("centre{2}", None, {"statement": "centre{3}"}),
    ("centre{2}", None, {"statement": "centre{4}"}),
    ("centre{2}", None, {"statement": "centre{2; 3}"}),
    ("centre{2}", None, {"statement": "centre{x}"}),
    ("centre{2}", "QQ", {"field": "ZZ"}),
    ("centre{3}", "GF(5)", {"field": "GF(2)"}),
    ("centre{3}", "GF(5)", {"field": "GF(3)"}),
    ("centre{2}", "GF(4)", {"statement": "centre{3}"}),
    ("centre{2}", None, {"evidence": {**MINOR, "rows": [0, 1, 2]}}),
    ("centre{2}", "QQ", {"evidence": {**MINOR, "rows": [0, 1, 2]}}),
    ("centre{2}", None, {"evidence": {**MINOR, "rows": [2, 3]}}),
    ("centre{2}", None, {"evidence": {**MINOR, "rows": [2, 3, 3]}}),
    ("centre{2}", None, {"evidence": {**MINOR, "rows": [2, 3, 7, 6]}}),
    ("centre{2}", None, {"evidence": {**MINOR, "rows": [2, 3, 8]}}),
    ("centre{2}", None, {"evidence": {**MINOR, "rows": [2, 3, -1]}}),
    ("centre{2}", None, {"evidence": {**MINOR, "columns": [1, 2, 4]}}),
    ("centre{2}", None, {"evidence": {**MINOR, "columns": [0, 1, 2]}}),
    ("determined-by{all; 1,3}", None, {"evidence": tuples(1, 2)}),
    ("determined-by{all; 1,3}", None, {"evidence": tuples(1)}),
    ("determined-by{all; 1,3}", None, {"evidence": tuples(1, 3, 3)}),
    ("determined-by{all; 1,3}", None, {"statement": "determined-by{all-but-one; 1,3}"}),
    ("determined-by{all; 1,3}", None, {"statement": "determined-by{all; 1,1}"}),
    ("determined-by{all; 1,3}", None, {"statement": "determined-by{all; 0,3}"}),
    ("determined-by{all; 1,3}", None, {"statement": "determined-by{all; 1,5}"}),
    ("determined-by{all; 1,3}", None, {"statement": "determined-by{most; 1,3}"}),
    ("determined-by{all; 2}", "QQ", {"evidence": {**ALL, "tuples": [TUPLES[1][:-1]]}}),
    ("determined-by{all; 2}", "QQ", {"evidence": {**ALL, "tuples": [TUPLES[1][::-1]]}}),
    (CONSTANT, None, {"evidence": {**LEFT_OUT, "tuple": "ee"}}),
    (CONSTANT, None, {"evidence": {**LEFT_OUT, "tuple": "eije"}}),
    (CONSTANT, None, {"evidence": {**LEFT_OUT, "tuple": "ex"}}),
    (CONSTANT, None, {"evidence": {**LEFT_OUT, "tuple": ["e", "i"]}}),
    ("determined-by{short; 2}", None, {"evidence": {**LEFT_OUT, "tuple": "ke"}}),
    ("determined-by{all-but-one; 3}", None, {"evidence": {**LEFT_OUT, "tuple": "kki"}}),
    ("curried-linear{1}", None, {"statement": "curried-linear{2}"}),
    ("last-argument{4; 1,2}", None, {"statement": "last-argument{3; 1,2}"}),
    ("last-argument{4; 1,2}", None, {"statement": "last-argument{5; 1,2}"}),
    ("last-argument{4; 1,2}", None, {"statement": "last-argument{6; 1,2}"}),
    ("last-argument{4; 1,2}", None, {"statement": "last-argument{4}"}),
    ("last-argument{3; 1,2}", None, {"statement": "last-argument{4; 1,2}"}),
    (CITING, None, {"statement": "citing{limits; determined-by{all; 1}}"}),
    (CITING, None, {"statement": "citing{magic; determined-by{all; 1}}"}),
    ("division", "QQ", {"field": "QQ(I)"}),
    ("division", "QQ", {"field": "ZZ"}),
    ("division", "QQ", {"field": None}),
    ("division", "QQ", {"statement": "division{q}"}),
    ("division", "QQ(I)", {"evidence": {**ZERO, "value": ["0", "0", "0", "0"]}}),
    ("division", "QQ(I)", {"evidence": {**ZERO, "value": ["1", "1", "0", "0"]}}),
    ("division", "QQ(I)", {"evidence": {**ZERO, "value": ["I", "1", "0"]}}),
    ("division", "QQ(I)", {"evidence": {**ZERO, "value": ["I", "1", "0", "0", "0"]}}),
    ("division", None, {"evidence": over("QQ", ZERO)}),
    ("division", None, {"evidence": over("ZZ/5", ZERO | {"value": ["2", "1", "0", "0"]}),
     "verdict": "proved"}),
    ("not-everywhere{division}", None, {"evidence": over("QQ", ORDERED)}),
    ("not-everywhere{division}", "QQ(I)", {"evidence": over("CC", ZERO)}),
    ("level-above{1}", "GF(7)", {"statement": "level-above{2}"}),
    ("level-above{1}", "GF(7)", {"statement": "level-above{x}"}),
    ("level-above{1}", "GF(7)", {"statement": "level-above{1; 2}"}),
    ("level-above{1}", "GF(7)", {"field": "GF(5)"}),
    ("level-above{2}", "GF(3)", {"statement": "level-above{1}"}),
    ("level-above{2}", "GF(3)", {"evidence": {**HALF, "values": ["1", "0"]}}),
    ("level-above{2}", "GF(3)", {"evidence": {**HALF, "values": []}}),
    ("formally-real", "QQ(sqrt(2))", {"field": "QQ(sqrt(-2))"}),
    ("formally-real", "QQ(I)", {"evidence": {**HALF, "values": ["1"]}}),
    ("norm-criterion{>}", "QQ", {"field": "QQ(I)"}),
    ("norm-criterion{>}", "QQ", {"statement": "norm-criterion{<}"}),
    ("norm-criterion{>}", "QQ", {"statement": "norm-criterion{=}"}),
    ("norm-criterion{>}", "QQ(I)", {"statement": "norm-criterion{<}"}),
    ("norm-criterion{>}", "QQ(I)", {"evidence": {**NORM_I, "norm": -2}}),
    ("norm-criterion{>}", "QQ(I)", {"evidence": {**NORM_I, "norm": 1, "value": ["1", "0", "0", "0"]}}),
    ("norm-criterion{>}", "QQ(I)", {"field": "GF(5)", "evidence": {**NORM_I, "value": ["2", "0", "0", "0"]}}),
    ("norm-criterion{>}", "QQ(I)", {"evidence": {**NORM_I, "norm": 0, "value": ["0", "0", "0", "0"]}}),
    ("norm-criterion{<}", "QQ", {"evidence": {**NORM_I, "value": ["0", "0", "0", "0"], "norm": 0}}),
    ("modulus-exists", "RR", {"field": "QQ"}),
    ("modulus-exists", "GF(4)", {"field": "GF(3)"}),
    ("modulus-exists", "QQ", {"evidence": {**NO_ROOT, "value": ["1", "0", "0", "0"]}}),
    ("modulus-exists", "QQ", {"statement": "modulus-exists{q}"}),
    ("modulus-law{*}", "QQ", {"field": "QQ(I)"}),
    ("modulus-law{*}", "QQ", {"statement": "modulus-law{+}"}),
    ("modulus-law{*}", "QQ", {"statement": "modulus-law{-}"}),
    ("modulus-law{*}", "GF(8)", {"field": "GF(9)"}),
    ("modulus-law{*}", "GF(7)", {"field": "GF(5)"}),
    ("modulus-law{*}", "GF(7)", {"field": "QQ"}),
    ("modulus-law{*}", "QQ(sqrt(-7))", {"field": "QQ(I)"}),
    ("modulus-law{*}", "QQ(sqrt(-7))", {"field": "GF(7)"}),
    ("modulus-law{*}", "QQ(I)", {"evidence": {**CHOICES, "roots": ["1", "1"]}}),
    ("modulus-law{*}", "QQ(I)", {"evidence": {**CHOICES, "roots": ["1"]}}),
    ("modulus-law{*}", "QQ(I)", {"evidence": {**CHOICES, "elements": ELEMENTS[:1], "roots": ["1"]}}),
    ("modulus-law{*}", "QQ(I)", {"evidence": {**CHOICES, "elements": ELEMENTS * 5, "roots": ["1", "I"] * 5}}),
    ("modulus-law{*}", "QQ(I)", {"evidence": {**CHOICES, "elements": [], "roots": []}}),
    # The root of 1 that is given breaks the law, and the other one does not.
    ("modulus-law{*}", "QQ(I)",
     {"evidence": {**CHOICES, "elements": ELEMENTS[:1], "roots": ["-1"]}}),
    (DIVIDES, "QQ", {"field": "QQ(I)"}),
    (COMMUTES, "GF(3)", {"evidence": both(refuted(HALF), refuted(NOT_COMMUTING))}),
    (COMMUTES, "GF(3)", {"evidence": both(proved(LEVEL), proved(IDENTITY))}),
    (COMMUTES, "GF(3)", {"statement": "implies{level-above{2}; p*q == q*p}"}),
    (COMMUTES, "GF(3)", {"statement": "iff{p*q == q*p; level-above{1}}"}),
    ("iff{level-above{1}; formally-real}", "QQ", {"statement": "iff{p*q == q*p; formally-real}"}),
    (IF_ONLY, "GF(3)", {"evidence": both({"verdict": "vacuous", "evidence": LEVEL}, refuted(NOT_COMMUTING))}),
    (DIVIDES, None, {"evidence": {"kind": "lemmas", "proofs": [IDENTITY] * 3}}),
    (DIVIDES, None, {"evidence": {"kind": "lemmas", "proofs": [IDENTITY] * 5}}),
    (DIVIDES, None, {"statement": "implies{division; formally-real}"}),
    (EVERY, "QQ", {"evidence": {**PARTS, "parts": [proved(LEVEL)]}}),
    (EVERY, "QQ", {"evidence": {**PARTS, "parts": [proved(IDENTITY), proved(LEVEL)]}}),
    (EVERY, "QQ", {"statement": "every{formally-real; q == p}"}),
    (EVERY, "QQ", {"statement": "every{formally-real; ; q == q}"}),
    (EVERY, "QQ", {"statement": "every{formally-real; q == q}}"}),
    (EVERY, "QQ", {"algebra": "(-1,-3|QQ)"}),
    (SECOND, "GF(3)", {"evidence": {**PART, "part": 0}}),
    (SECOND, "GF(3)", {"evidence": {**PART, "part": 2}}),
    (SECOND, "GF(3)", {"evidence": {**PART, "part": -1}}),
]  # fmt: skip


@subcases("n", range(len(BAD)))
def test_what_is_not_shown_is_rejected(n: int) -> None:
    statement, field, changes = BAD[n]
    rejects(row_of(statement, field), **changes)


def test_words_nest_only_so_deep() -> None:
    def nested(depth: int) -> dict[str, Any]:
        statement, evidence = "formally-real", LEVEL
        for _ in range(depth):
            statement = f"implies{{division; {statement}}}"
            evidence = {"kind": "conclusion", "evidence": evidence}
        row = (statement, "QQ", "proved", "level", None, evidence, "field")
        return certificate(row)

    assert check(nested(6)).scope == "field"
    with pytest.raises(Rejected, match="nests too deeply"):
        check(nested(7))
    inside = nested(5)
    inside["statement"] = f"over{{QQ; {inside['statement']}}}"
    own = inside["evidence"]
    inside["evidence"] = with_rings(inside["statement"], own)
    assert check(inside).scope == "field"
    inside["statement"] = f"every{{{inside['statement']}}}"
    inside["evidence"] = {**inside["evidence"], "evidence": {**PARTS, "parts": [proved(own)]}}
    with pytest.raises(Rejected, match="nests too deeply"):
        check(inside)


def test_rows_and_columns_are_named() -> None:
    row = row_of("centre{2}", "QQ")
    for key in ("rows", "columns"):
        for value, said in (("1", "must be an integer"), (-1, "must be at least 0")):
            wrong = {**MINOR, key: [value, *MINOR[key][1:]]}  # type: ignore[index]
            with pytest.raises(Rejected, match=f"^a row or column {said}"):
                check(certificate(row, evidence=wrong))


def test_vacuous_parts_are_said() -> None:
    empty = {"verdict": "vacuous", "evidence": {"kind": "unsatisfiable", "proof": IDENTITY}}
    first, second = "1 == 2 => q == p", "q == q"
    row = (f"every{{{second}; {first}}}", "QQ", "proved", "identity", None, {}, "field")
    found = check(certificate(row, evidence={**PARTS, "parts": [proved(IDENTITY), empty]}))
    assert found.vacuous == (first,)
    assert f"vacuous part: {first}" in found.lines()
    nothing = {**PARTS, "parts": [empty, empty]}
    with pytest.raises(Rejected, match="all parts are vacuous"):
        check(certificate(row, statement=f"every{{{first}; {first}}}", evidence=nothing))
    with pytest.raises(Rejected, match=r"brackets of .* do not match"):
        check(certificate(row, statement="every{q == q; every{q == q}"))
    everywhere = check(certificate(row_of("basis{2; 1,2; 3,7}", None)))
    assert everywhere.where == "over all commutative rings"
    assert check(certificate(row_of("centre{2}", None))).where == "over all fields"
    assert check(certificate(row_of("division", "QQ"))).where == "over QQ"


def test_the_evidence_is_named() -> None:
    for statement, field in (
        ("basis{2; 1,2; 3,4}", "GF(3)"),
        ("modulus-exists", "QQ"),
        ("division", "QQ(I)"),
    ):
        row = row_of(statement, field)
        with pytest.raises(Rejected, match=r"^the evidence has an unknown key 'more'"):
            check(certificate(row, evidence={**row[5], "more": 1}))
    row = row_of("division", "QQ(I)")
    for value, said in (
        (["I", "1", "0"], "coordinates has 3 entries"),
        (["I"] * 5, "four coordinates"),
    ):
        with pytest.raises(Rejected, match=said):
            check(certificate(row, evidence={**row[5], "value": value}))


LATTICE = " | ".join(",".join(str(int(m == n)) for n in range(4)) for m in range(4))
NONSENSE = (
    *("hello", "s +", "sqrt(2) == s", "x[0] == y(q)", "every{q == q; q}"),
    *("over{QQ; sqrt(2) == s}", "citing{choice; q == q}", "angles{q == q; I == s}"),
    *("not-everywhere{sqrt(2) == s}", "associative(i, j): i == j => j == i"),
    *("division{2}", "level-above", "level-above{two}", "norm-criterion{>=}", "modulus-law{/}"),
    *("centre{-2}", "basis{2}", "basis{2; 1,x}", "determined-by{some; 1}", "determined-by{all; 5}"),
    *(
        "curried-linear{2}",
        "last-argument{6; 1}",
        "last-argument{4; 1.5}",
        f"order{{{LATTICE}; a}}",
    ),
    *(
        f"order{{{LATTICE}}}",
        f"embedding{{{LATTICE[1:]}; -4}}",
        f"equivalent{{up; {LATTICE}; {LATTICE}}}",
    ),
)


@subcases("nonsense", NONSENSE)
def test_every_part_has_a_meaning(nonsense: str) -> None:
    """Also a part that the evidence is not about."""
    never = {"kind": "part", "part": 0, "evidence": at({}, "QQ")}
    first = "1 == 2"
    for word, verdict, evidence in (
        ("every", "refuted", never),
        ("implies", "vacuous", {"kind": "hypothesis", "evidence": at({}, "QQ")}),
    ):
        row = (f"{word}{{{first}; q == q}}", "QQ", verdict, "identity", None, evidence, "field")
        assert check(certificate(row)).verdict == verdict
        with pytest.raises(Rejected):
            check(certificate(row, statement=f"{word}{{{first}; {nonsense}}}"))
    row = ("implies{q == q; q == q}", "QQ", "proved", "identity", None, {}, "field")
    found = check(certificate(row, evidence={"kind": "conclusion", "evidence": IDENTITY}))
    assert found.left_out == ("q == q (whether it holds)",)
    with pytest.raises(Rejected):
        check(
            certificate(
                row,
                statement=f"implies{{{nonsense}; q == q}}",
                evidence={"kind": "conclusion", "evidence": IDENTITY},
            )
        )


def test_what_speaks_of_one_ring_may_name_its_elements() -> None:
    """Also where it stands in a statement on all fields, which one field refutes."""
    for statement, evidence in (
        ("angles{1 == 1; sqrt(2) == 1}", {"kind": "part", "part": 1, "evidence": at({}, "RR")}),
        ("iff{over{RR; sqrt(2)**2 == 2}; 1 == 2}", both(proved(IDENTITY), refuted(at({}, "RR")))),
    ):
        cites = CIRCLE if "angles" in statement else None
        row = (statement, None, "refuted", "identity", cites, over("RR", evidence), "field")
        assert check(certificate(row)).verdict == "refuted"


@pytest.mark.parametrize(
    ("part", "field"),
    [("not-everywhere{I == 0}", "QQ(I)"), (f"order{{{LATTICE}; 4}}", "GF(3)"), ("x*x == y", None)],
)
def test_a_part_has_a_meaning_over_the_field(part: str, field: str | None) -> None:
    evidence = {"kind": "part", "part": 0, "evidence": at({}, field or "QQ")}
    row = (f"every{{1 == 2; {part}}}", field, "refuted", "identity", None, evidence, "field")
    if field is None:
        assert check(certificate(row)).verdict == "refuted"
    else:
        with pytest.raises(Rejected):
            check(certificate(row))


def test_what_names_elements_of_one_field_says_nothing_of_all() -> None:
    evidence = {"kind": "part", "part": 0, "evidence": at({}, "QQ(I)")}
    row = ("every{1 == 2; q == q}", None, "refuted", "identity", None, evidence, "field")
    assert check(certificate(row)).verdict == "refuted"
    with pytest.raises(Rejected, match="means nothing"):
        check(certificate(row, statement="every{1 == 2; I*I == -1}"))


def test_over_one_field_the_centre_is_that_of_its_characteristic() -> None:
    for field, other in (("QQ", "2 the centre is H(F)"), ("GF(4)", "not 2 the centre is F·e")):
        found = check(certificate(row_of("centre{2}", field)))
        assert found.left_out == (f"in characteristic {other}",)
        assert f"left out: in characteristic {other}" in found.lines()
    assert check(certificate(row_of("centre{2}", None))).left_out == ()
