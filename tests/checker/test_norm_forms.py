"""Reasons why a norm form is 0 only at 0: genuine ones, and each of them with one thing changed."""

from typing import Any

import pytest

from hfield.checker.anisotropy import anisotropic, constants_of, is_readable
from hfield.checker.anisotropy import is_certified as certifies
from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from tests.checker.cases import certified
from tests.checker.ring_data import Data, data_of, ideal, number, prime, split
from tests.subcases import subcases

ORDERING, LEVEL = {"by": "ordering"}, {"by": "level"}


def at(place: int | Data, u: str, j: str) -> dict[str, Any]:
    """Return the reason at a place, or at a number; u and j by their coordinates."""
    place = number(place) if isinstance(place, int) else place
    return {"by": "place", "place": place, "u": u.split(), "j": j.split()}


def near(point: str, proof: Any) -> dict[str, Any]:
    return {"by": "specialisation", "at": point, "proof": proof}


THREE = at(3, "0 1 0 0", "0 0 1 0")
TWO = at(2, "1/2 0 1/2 1/2", "0 1/2 1 1/2")
WILD = at(prime(0, 1), "0 1 0 0", "0 0 1 0")
HALF = at(2, "1/2 1/2 1/2 3/2", "0 1 0 1")
POINT = near("-1", HALF)
REAL, IMAGINARY = "QQ(sqrt(2))", "QQ(sqrt(-7))"
Row = tuple[str, str, Any]
GENUINE: list[Row] = [
    ("(-1,-1|QQ)", "QQ", ORDERING),
    ("[-1,-1|QQ)", "QQ", ORDERING),
    ("[-2,-1,2|QQ)", "QQ", ORDERING),  # 2² + 4·(−2) < 0
    ("(sqrt(2),-1|QQ(sqrt(2)))", REAL, ORDERING),  # √2 is negative in one of the two
    ("(-1,-1|QQ(sqrt(-7)))", IMAGINARY, LEVEL),
    ("[-1,-1,0|QQ(sqrt(-7)))", IMAGINARY, LEVEL),
    ("(2,3|QQ)", "QQ", THREE),
    ("(2,3|QQ)", "QQ", TWO),
    ("[1,t|GF(2)(t))", "GF(2)(t)", WILD),
    ("(x,3|QQ(x))", "QQ(x)", POINT),
]


def is_certified(algebra: str, field: str, reason: Any) -> bool:
    return certifies(algebra, data_of(field), reason)


def refused(algebra: str, field: str, reason: Any) -> str:
    """Return why a reason is rejected."""
    try:
        ring, c = constants_of(algebra, data_of(field))
        anisotropic(ring, c, reason, algebra)
    except Rejected as error:
        return str(error)
    pytest.fail(f"{reason} passes for {algebra}")


@subcases(("algebra", "field", "reason"), GENUINE)
def test_what_is_genuine_is_accepted(algebra: str, field: str, reason: Any) -> None:
    assert is_certified(algebra, field, reason)
    ring, c = constants_of(algebra, data_of(field))
    assert anisotropic(ring, c, reason, algebra) == ()


@subcases(("algebra", "field", "reason"), GENUINE)
def test_its_keys_are_complete(algebra: str, field: str, reason: Any) -> None:
    for key in reason:
        left = {k: v for k, v in reason.items() if k != key}
        said = "of no known kind" if key == "by" else f"a fact about a norm lacks the key {key!r}"
        assert said in refused(algebra, field, left)
        assert not is_certified(algebra, field, left)
    assert "unknown key 'more'" in refused(algebra, field, {**reason, "more": 1})
    for by in ("magic", None, 3, ["ordering"]):
        said = f"the reason for the norm form of {algebra} is of no known kind"
        assert refused(algebra, field, {**reason, "by": by}) == said
    for data in (None, [], "ordering"):
        assert "of no known kind" in refused(algebra, field, data)


ROOT, VALUATION, TRACES = (
    "has a root among the residues",
    "has not the valuation",
    "the traces of j",
)
NEGATIVE, SQUARES = "not both negative in an ordering", "may be a sum of two squares"
FORGED: list[tuple[str, str, Any, str]] = [
    # Definite in no ordering, or in one where d = t² + 4a is positive.
    ("(1,-1|QQ)", "QQ", ORDERING, NEGATIVE),
    ("(-1,1|QQ)", "QQ", ORDERING, NEGATIVE),
    ("(0,-1|QQ)", "QQ", ORDERING, NEGATIVE),
    ("[0,-1|QQ)", "QQ", ORDERING, NEGATIVE),
    ("[-1,-1,2|QQ)", "QQ", ORDERING, NEGATIVE),
    ("[-1,-1,-3|QQ)", "QQ", ORDERING, NEGATIVE),
    ("(sqrt(2),-sqrt(2)|QQ(sqrt(2)))", REAL, ORDERING, NEGATIVE),
    ("(-1,-1|GF(3))", "GF(3)", ORDERING, NEGATIVE),
    ("(-1,-1|QQ(sqrt(-7)))", IMAGINARY, ORDERING, NEGATIVE),
    # −1 is a sum of two squares, or the algebra is another.
    ("(-1,-1|QQ(I))", "QQ(I)", LEVEL, SQUARES),
    ("(-1,-1|GF(7))", "GF(7)", LEVEL, SQUARES),
    ("(-1,-1|GF(2)(t))", "GF(2)(t)", LEVEL, SQUARES),
    ("(-1,-2|QQ(sqrt(-7)))", IMAGINARY, LEVEL, SQUARES),
    ("(-2,-1|QQ(sqrt(-7)))", IMAGINARY, LEVEL, SQUARES),
    ("[-1,-1|QQ(sqrt(-7)))", IMAGINARY, LEVEL, SQUARES),
    # Another place, another u, another j.
    ("(2,3|QQ)", "QQ", {**THREE, "place": number(5)}, f"{VALUATION} of (5)"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": number(7)}, ROOT),
    ("(2,3|QQ)", "QQ", {**THREE, "place": number(2)}, ROOT),
    ("(2,3|QQ)", "QQ", {**THREE, "place": number(9)}, ROOT),
    ("(2,3|QQ)", "QQ", {**THREE, "place": number(4)}, "is not a place"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": number(1)}, "a place must be at least 2"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": number("3")}, "a place must be an integer"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": {**number(3), "root": 1}}, "unknown key"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": prime(0, 1)}, "no place of the kind 'prime polynomial'"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": split(3, 1)}, "no place of the kind 'split'"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": ideal(3)}, "no place of the kind 'prime ideal'"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": 3}, "a place must be an object"),
    ("(2,3|QQ)", "QQ", {**THREE, "place": "3"}, "a place must be an object"),
    ("(2,3|QQ)", "QQ", at(3, "1 0 0 0", "0 0 1 0"), ROOT),
    ("(2,3|QQ)", "QQ", at(3, "0 0 1 0", "0 0 1 0"), ROOT),
    ("(2,3|QQ)", "QQ", at(3, "1/3 1 0 0", "0 0 1 0"), ROOT),
    ("(2,3|QQ)", "QQ", at(3, "0 1/3 0 0", "0 0 1 0"), ROOT),
    ("(2,3|QQ)", "QQ", at(3, "0 1 0 0", "0 1 0 0"), f"{VALUATION} of (3)"),
    ("(2,3|QQ)", "QQ", at(3, "0 1 0 0", "0 0 3 0"), f"{VALUATION} of (3)"),
    ("(2,3|QQ)", "QQ", at(3, "0 1 0 0", "0 0 0 0"), f"{VALUATION} of (3)"),
    ("(2,3|QQ)", "QQ", at(3, "0 1 0 0", "0 0 1/3 0"), f"{VALUATION} of (3)"),
    ("(2,3|QQ)", "QQ", at(3, "0 1 0", "0 0 1 0"), "coordinates has 3 entries"),
    ("(2,3|QQ)", "QQ", at(3, "0 1 0 0 0", "0 0 1 0"), "a quaternion has four coordinates"),
    ("(2,3|QQ)", "QQ", at(3, "0 1 0 0", "0 0 1 0 0"), "a quaternion has four coordinates"),
    ("(2,3|QQ)", "QQ", at(3, "0 x 0 0", "0 0 1 0"), "'x' is not an element of QQ"),
    ("(2,3|QQ)", "QQ", {**THREE, "u": [0, 1, 0, 0]}, "an entry of coordinates must be a text"),
    # These two split: N(j) = 3 and −3, but tr(j) = 4 and B(u, j) = −4.
    ("(2,1|QQ)", "QQ", at(3, "0 1 0 0", "2 0 1 0"), TRACES),
    ("(2,1|QQ)", "QQ", at(3, "0 1 0 0", "0 1 1 0"), TRACES),
    ("(2,3|QQ)", "QQ", {**TWO, "place": number(3)}, ROOT),
    ("(2,3|QQ)", "QQ", {**TWO, "u": ["0", "0", "1", "0"]}, ROOT),
    ("(2,3|QQ)", "QQ", {**TWO, "j": ["0", "0", "1", "0"]}, VALUATION),
    ("(3,7|QQ)", "QQ", TWO, ROOT),
    ("[1,t|GF(2)(t))", "GF(2)(t)", {**WILD, "place": prime(1, 1)}, VALUATION),
    ("[1,t|GF(2)(t))", "GF(2)(t)", {**WILD, "place": prime(1, 1, 1)}, ROOT),
    ("[1,t|GF(2)(t))", "GF(2)(t)", {**WILD, "place": prime(1, 0, 1)}, "is reducible"),
    ("[1,t|GF(2)(t))", "GF(2)(t)", {**WILD, "place": prime(1)}, "has 1 entries; expected 2"),
    ("[1,t|GF(2)(t))", "GF(2)(t)", {**WILD, "place": prime(0, 2)}, "from 0 to 1"),
    ("[1,t|GF(2)(t))", "GF(2)(t)", {**WILD, "place": prime(1, 0)}, "is monic"),
    ("[1,t|GF(2)(t))", "GF(2)(t)", {**WILD, "place": number(2)}, "no place of the kind 'number'"),
    ("[t,t|GF(2)(t))", "GF(2)(t)", WILD, ROOT),
    ("[1,t^2|GF(2)(t))", "GF(2)(t)", WILD, VALUATION),
    ("(1,t|GF(2)(t))", "GF(2)(t)", WILD, ROOT),
    # Another point, where the algebra splits or does not exist; another reason there.
    ("(x,3|QQ(x))", "QQ(x)", near("1", HALF), ROOT),
    ("(x,3|QQ(x))", "QQ(x)", near("0", HALF), ROOT),
    ("(1/x,3|QQ(x))", "QQ(x)", near("0", HALF), "a constant has no value at 0"),
    ("(x,3/x|QQ(x))", "QQ(x)", near("0", HALF), "a constant has no value at 0"),
    ("(x,3|QQ(x))", "QQ(x)", near("x", HALF), "'x' is not an element of QQ"),
    ("(x,3|QQ(x))", "QQ(x)", near("-1", ORDERING), NEGATIVE),
    ("(x,3|QQ(x))", "QQ(x)", near("-1", LEVEL), SQUARES),
    ("(x,3|QQ(x))", "QQ(x)", near("-1", POINT), "have no values at points"),
    ("(x,3|QQ(x))", "QQ(x)", near("-1", None), "(x,3|QQ(x)) at -1 is of no known kind"),
    ("(x,3|QQ(x))", "QQ(x)", {**POINT, "at": -1}, "a point must be a text"),
    ("(x,3|QQ(x))", "QQ(x)", HALF, "no place of the kind 'number' is known of QQ(x)"),
    ("(2,3|QQ)", "QQ", POINT, "have no values at points"),
    # Nothing of this is said of rings, of unknown constants, or of all fields.
    ("(-1,-1|ZZ)", "ZZ", ORDERING, "ZZ is not an exact field"),
    ("(-1,-1|RDF)", "RDF", ORDERING, "RDF is not an exact field"),
]


@subcases(("algebra", "field", "reason", "why"), FORGED)
def test_what_is_forged_is_rejected(algebra: str, field: str, reason: Any, why: str) -> None:
    assert why in refused(algebra, field, reason)
    assert not is_certified(algebra, field, reason)


def test_constants_that_are_not_known() -> None:
    for algebra, field, said in (
        ("(a,b|QQ)", "QQ", "'a' names no element of QQ"),
        ("(1/0,-1|QQ)", "QQ", "the structure constants are not defined"),
        ("(-1,-1|F)", "QQ", "the algebra '(-1,-1|F)' is none over QQ, as (-1,-1|QQ) is"),
    ):
        assert refused(algebra, field, ORDERING) == said
        assert not is_readable(algebra, data_of(field))
    assert not is_readable("(-1,-1|F)", None)
    assert not certifies("(-1,-1|F)", None, ORDERING)
    assert is_readable("(sqrt(2),x-1|QQ(x))", data_of("QQ(x)")) is False
    assert is_readable("(1/2,-1|QQ)", data_of("QQ"))
    assert not is_certified("(-1,-1|QQ", "QQ", ORDERING)


def test_a_certificate_rests_on_its_reason() -> None:
    """The reason names the algebra of which the norm is evaluated."""
    norm = {"step": "norm", "terms": [f"q[{n}]" for n in range(4)], "cofactors": ["1", "0"]}
    items = [
        {
            "characteristic": 0,
            "zero": ["q[0]**2 - 2*q[1]**2 - 3*q[2]**2 + 6*q[3]**2"],
            "relations": [],
            "nonzero": [f"q[{n}]"],
            "steps": [
                {**norm, "denominator": 1},
                {
                    "step": "contradiction",
                    "cofactors": ["0", "1", *("T1" if m == n else "0" for m in range(4))],
                    "denominator": 1,
                },
            ],
        }
        for n in range(4)
    ]

    def about(*facts: Any, name: str | None = None) -> Any:
        own = [
            {**x, "steps": [{**x["steps"][0], "algebra": name}, x["steps"][1]]} if name else x
            for x in items
        ]
        evidence = {"kind": "implication", "facts": list(facts), "items": own}
        statement = "norm(q) == 0 => q == 0"
        return certified(statement, "QQ", "implication", evidence, "(2,3|QQ)")

    fact, named = {"form": "norm", **THREE}, {"form": "norm", "algebra": "(2,3|QQ)", **TWO}
    assert check(about(fact)).scope == check(about(named, name="(2,3|QQ)")).scope == "field"
    for data, said in (
        (about(), "the norm is that of four terms, in an algebra that a fact is about"),
        (about(named), "in an algebra that a fact is about"),
        (about(fact, name="(2,3|QQ)"), "in an algebra that a fact is about"),
        (about(fact, fact), "a fact stands there twice"),
        (about(named, named), "a fact stands there twice"),
        (about({**fact, "place": number(5)}), VALUATION),
        (about({**named, "algebra": "(3,2|QQ)", **THREE}), ROOT),
        (about({**named, "algebra": "(1/0,3|QQ)"}), "constants of a fact are not known"),
        (about({**named, "algebra": "(a,3|QQ)"}), "the unknown 'a' has no value"),
        (about({**named, "algebra": 5}), "an algebra must be a text"),
        (about({**named, "algebra": "(2,3|QQ(I))"}), "none over QQ, as (-1,-1|QQ) is"),
        # Anisotropic, but another form.
        (
            about({"form": "norm", "algebra": "(-1,-1|QQ)", **ORDERING}, name="(-1,-1|QQ)"),
            "a sum of cofactors is not the form of the step 'norm'",
        ),
    ):
        with pytest.raises(Rejected) as caught:
            check(data)
        assert said in str(caught.value)


def test_sums_of_squares_need_an_ordering_or_a_level() -> None:
    squares = {"form": "squares", "by": "ordering", "most": None, "positive": True}

    def about(field: str, **changes: Any) -> Any:
        evidence = {"kind": "implication", "facts": [{**squares, **changes}], "items": []}
        return certified("s == s", field, "implication", evidence)

    level = {"by": "level", "positive": False}
    for data in (
        about("QQ"),
        about("QQ(sqrt(2))", most=7),
        about("QQ(x)", positive=False),
        about("GF(7)", **level, most=2),
        about("QQ(sqrt(-7))", **level, most=4),
    ):
        assert check(data)
    for data, said in (
        (about("GF(7)"), "GF(7) is not known to have an ordering"),
        (about("QQ(I)"), "QQ(I) is not known to have an ordering"),
        (about("GF(7)", **level, most=3), "sums of squares in GF(7) may be 0"),
        (about("GF(5)", **level, most=2), "sums of squares in GF(5) may be 0"),
        (about("GF(7)", **level, most=None), "sums of squares in GF(7) may be 0"),
        (about("GF(7)", by="level", most=2), "sums of squares in GF(7) may be 0"),
        (about("GF(7)", by="magic", most=2), "sums of squares in GF(7) may be 0"),
        (about("GF(7)", **level, most=0), "most must be at least 1"),
        (about("QQ", positive=1), "'positive' must be true or false"),
    ):
        with pytest.raises(Rejected) as caught:
            check(data)
        assert said in str(caught.value)
