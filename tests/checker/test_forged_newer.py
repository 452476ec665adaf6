"""Forged evidence of the newer kinds: lattices, places, subfields, roots by theorems, presentations."""

from itertools import product
from typing import Any

import pytest

from hfield.checker.check import check
from hfield.checker.glossary import (
    COMPLEX_ROOT,
    MASS,
    ODD_DEGREE,
    QUATERNION_ROOT,
    REAL_ROOTS,
    SIGN_CHANGE,
)
from tests.checker.cases import Certificate, Field, certified
from tests.checker.hand_made import implication, opposite, rejects
from tests.checker.ring_data import (
    INFINITY,
    QQ,
    Data,
    completion,
    data_of,
    generated,
    ideal,
    number,
    other,
    prime,
    split,
)
from tests.checker.test_orders import true_ones
from tests.subcases import subcases

LIPSCHITZ = "1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1"
HURWITZ = "1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 1/2,1/2,1/2,1/2"
TWICE = "2,0,0,0 | 0,2,0,0 | 0,0,2,0 | 0,0,0,2"
UNIT = {"den": 1, "rows": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}
HALF = {"den": 2, "rows": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [1, 1, 1, 1]]}


def forged(
    statement: str, field: Field, verdict: str, method: str, evidence: Any, **more: Any
) -> Certificate:
    return {**certified(statement, field, method, evidence), "verdict": verdict, **more}


# --- lattices -------------------------------------------------------------------------------------

ORDER, IDEAL = {"kind": "order"}, {"kind": "ideal"}
SMALL = "1,0,0,0 | 0,2,0,0 | 0,0,2,0 | 0,0,0,2"
RADICAL = "2,0,0,0 | 1,1,0,0 | 1,0,1,0 | 1,0,0,1"  # what is even in Lipschitz's order
LATTICES = [
    (f"order{{{LIPSCHITZ}; 4; maximal}}", "order", ORDER),
    (f"order{{{LIPSCHITZ}; 2}}", "order", ORDER),
    (f"order{{{LIPSCHITZ}; -4}}", "order", ORDER),
    (f"order{{{LIPSCHITZ}; 4; minimal}}", "order", ORDER),
    (f"order{{{LIPSCHITZ}; 4}}", "order", {**ORDER, "maximal": True}),
    ("order{1,0,0,0 | 0,1/2,0,0 | 0,0,1,0 | 0,0,0,1; 2}", "order", ORDER),
    (f"order{{{TWICE}; 64}}", "order", ORDER),
    ("order{1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 1,1,1,0; 4}", "order", ORDER),
    ("order{1,0,0,0 | 0,1,0,0 | 0,0,3,0 | 1/2,1/2,3/2,3/2; 6; maximal}", "order", ORDER),
    (f"ideal{{{TWICE}; left; {LIPSCHITZ}; 2}}", "ideal", IDEAL),
    (f"ideal{{{SMALL}; left; {LIPSCHITZ}; 1}}", "ideal", IDEAL),
    (f"ideal{{{RADICAL}; left; {LIPSCHITZ}; 2}}", "ideal", IDEAL),  # not locally principal
    (f"ideal{{{TWICE}; left; {TWICE}; 4}}", "ideal", IDEAL),
    (f"ideal{{{TWICE}; both; {LIPSCHITZ}; 4}}", "ideal", IDEAL),
    (f"ideal{{{HURWITZ}; left; {LIPSCHITZ}; 1}}", "ideal", IDEAL),
    *(
        (f"equivalent{{left; {one}; {other}}}", "element", {"kind": "equivalent", "element": x})
        for one, other, x in (
            (LIPSCHITZ, LIPSCHITZ, ["0"] * 4),
            (LIPSCHITZ, TWICE, ["1", "0", "0", "0"]),
            (LIPSCHITZ, HURWITZ, ["1", "1", "0", "0"]),
            (HURWITZ, "1,2,0,0 | 0,5,0,0 | 0,0,1,2 | 0,0,0,5", ["1", "2", "0", "0"]),
        )
    ),
    *(
        (f"isomorphic-orders{{{LIPSCHITZ}; {other}}}", "element", evidence)
        for other, evidence in (
            (LIPSCHITZ, {"kind": "isomorphic-orders", "element": ["0"] * 4}),
            (HURWITZ, {"kind": "isomorphic-orders", "element": ["1", "0", "0", "0"]}),
        )
    ),
    *(
        (f"embedding{{{order}; {d}}}", "element", {"kind": "embedding", "element": x})
        for order, d, x in (
            (HURWITZ, -12, ["0", "1", "1", "1"]),  # in Hurwitz's order (1 + i + j + k)/2 has -3
            (HURWITZ, -3, ["0", "1", "0", "0"]),
            (LIPSCHITZ, -3, ["1/2"] * 4),
            (LIPSCHITZ, 0, ["3", "0", "0", "0"]),
        )
    ),
]


@subcases(("statement", "method", "evidence"), LATTICES)
def test_lattices_are_what_they_are(statement: str, method: str, evidence: Any) -> None:
    for verdict in ("proved", "refuted", "vacuous"):
        rejects(forged(statement, "QQ", verdict, method, evidence), ".")


DENIED = [
    (f"equivalent{{left; {LIPSCHITZ}; {TWICE}}}", "enumeration", "equivalent", {"between": basis})
    for basis in (
        {"den": 1, "rows": [[2 * x for x in row] for row in UNIT["rows"]]},
        {"den": 1, "rows": [[4 * x for x in row] for row in UNIT["rows"]]},
        {"den": 0, "rows": UNIT["rows"]},
        {"den": -1, "rows": UNIT["rows"]},
        {"den": True, "rows": UNIT["rows"]},
        UNIT,
    )
] + [
    (f"equivalent{{left; {LIPSCHITZ}; {TWICE}}}", "norm", "equivalent", {}),
    *(
        (f"isomorphic-orders{{{HURWITZ}; {HURWITZ}}}", method, "isomorphic-orders", more)
        for method, more in (
            ("enumeration", {"trace": 0, "norm": 1, "bases": [HALF, HALF]}),
            ("enumeration", {"trace": 0, "norm": 1, "bases": [HALF, UNIT]}),
            ("enumeration", {"trace": 0, "norm": -1, "bases": [HALF, HALF]}),
            ("enumeration", {"trace": 0, "norm": 1, "bases": [HALF]}),
            ("discriminant", {}),
        )
    ),
    *(
        (f"embedding{{{HURWITZ}; {d}}}", "enumeration", "embedding", {"basis": basis})
        for d, basis in ((-3, HALF), (-4, UNIT), (5, HALF), (-5, HALF), (0, HALF))
    ),
]


@subcases(("statement", "method", "kind", "more"), DENIED)
def test_what_is_there_is_not_denied(statement: str, method: str, kind: str, more: Any) -> None:
    rejects(forged(statement, "QQ", "refuted", method, {"kind": kind, **more}), ".")


def test_nothing_is_exhausted_in_an_indefinite_algebra() -> None:
    for data in (
        forged(
            DENIED[0][0], "QQ", "refuted", "enumeration", {"kind": "equivalent", "between": UNIT}
        ),
        forged(
            f"embedding{{{LIPSCHITZ}; -3}}",
            "QQ",
            "refuted",
            "enumeration",
            {"kind": "embedding", "basis": UNIT},
        ),
    ):
        rejects({**data, "algebra": "(2,3|QQ)"}, ".")


@pytest.mark.parametrize(
    ("algebra", "field"),
    [
        ("(-1,-1|RR)", "RR"),
        ("(-1,-1|F)", None),
        ("(a,-1|QQ)", "QQ"),
        ("(0,-1|QQ)", "QQ"),
        ("(1/0,-1|QQ)", "QQ"),
    ],
)
def test_lattices_lie_in_an_algebra_over_the_rational_numbers(algebra: str, field: Any) -> None:
    data = forged(f"order{{{LIPSCHITZ}; 4}}", field, "proved", "order", ORDER, algebra=algebra)
    rejects(data, ".")


@pytest.mark.slow
def test_evidence_about_lattices_has_no_key_that_is_not_used() -> None:
    used = ("between", "trace", "norm", "bases", "basis", "element", "classes", "den", "rows", "x")
    for data in true_ones():
        assert check(data)
        for key in used:
            if key not in data["evidence"]:
                for value in (0, UNIT, ["1", "0", "0", "0"], [HALF, HALF]):
                    rejects({**data, "evidence": {**data["evidence"], key: value}}, ".")


def test_class_sets_are_complete_and_of_different_classes() -> None:
    data = next(
        d
        for d in true_ones()
        if d["statement"].startswith("class-set") and len(d["evidence"]["classes"]) > 1
    )
    classes, statement = data["evidence"]["classes"], data["statement"]
    front = statement.rpartition(";")[0]

    def said(own: list[Any], n: int) -> Certificate:
        evidence = {"kind": "class-set", "classes": own}
        return {**data, "statement": f"{front}; {n}}}", "evidence": evidence}

    assert check(said(classes, len(classes)))
    first = classes[0]
    larger = {"den": 1, "rows": [[3 * x for x in row] for row in first["rows"]]}
    for own in (
        classes[1:],
        classes[:-1],
        [*classes, first],
        [*classes[:-1], first],
        [*classes[:-1], larger],
        [*classes[:-1], UNIT],
        [],
    ):
        for n in {len(own), len(classes)}:
            rejects(said(own, n), ".")
    rejects({**data, "assumes": []}, "assumes")
    rejects({**data, "assumes": [MASS, MASS]}, "assumes")
    rejects({**data, "verdict": "refuted"}, ".")


# --- fields ---------------------------------------------------------------------------------------

LEVELS = [
    ("QQ(sqrt(-7))", 4),
    ("QQ(I)", 1),
    ("GF(3)", 2),
    ("GF(5)", 1),
    ("QQ(sqrt(-3))", 2),
    ("QQ(sqrt(-15))", 4),
    ("QQ[s]/(s^2+7)", 4),
    ("QQ(zeta5)", 2),
    ("QQ(zeta3)", 2),
    ("Qp(3)", 2),
    ("Qp(5)", 1),
    ("Qp(2)", 4),
    ("CC", 1),
    ("QQ(sqrt(2),I)", 1),
    ("GF(3)(t)", 2),
    ("QQ(zeta7)", 4),
    ("QQ[s]/(s^4+1)", 1),
    ("GF(2)", 1),
]


@subcases(("field", "level"), LEVELS)
def test_a_level_is_not_above_what_it_is(field: str, level: int) -> None:
    for bound in (level, level + 1, 9_999):
        rejects(forged(f"level-above{{{bound}}}", field, "proved", "level", {"kind": "level"}), ".")
    rejects(forged("formally-real", field, "proved", "level", {"kind": "level"}), ".")
    ordering = {"kind": "anisotropic", "by": "ordering"}
    rejects(forged("division", field, "proved", "anisotropic norm", ordering), ".")


SQUARES = [
    ("QQ(I)", "-1"),
    ("Qp(7)", "2"),
    ("Qp(2)", "17"),
    ("Qp(5)", "1/4"),
    ("Qp(5)", "25"),
    ("Qp(3)", "-2"),
    ("QQ(sqrt(2))_(7, sqrt(2)-3)", "sqrt(2)+6"),
    ("QQ(sqrt(2),sqrt(3))", "6"),
    ("GF(3)((t))", "1+t"),
    ("QQ(sqrt(2),sqrt(3))", "5+2*sqrt(6)"),
    ("QQ(zeta5)", "5"),
    ("QQ(zeta8)", "2"),
    ("QQ(zeta3)", "-3"),
    ("QQ(zeta12)", "3"),
    ("QQ(zeta7)", "-7"),
    ("QQ[c]/(c^4-2)", "2"),
    ("QQ[c]/(c^2-8)", "2"),
    ("RR", "2"),
    ("CC", "2"),
    ("QQ[a]/(a^3-2)", "a**2"),
    ("GF(9)", "2"),
    ("QQ(x)", "x**2 + 2*x + 1"),
    ("Qp(5)", "0"),
]


@subcases(("field", "square"), SQUARES)
def test_a_square_is_never_a_polynomial_without_roots(field: str, square: str) -> None:
    f = f"s**2 - {square}".replace("- -", "+ ").replace("- 5+", "- 5 - ")
    step = {"step": "no root", "polynomial": f, "cofactors": ["1"], "denominator": 1}
    for by, sign in product(("squares", "factors"), ("", "-")):
        evidence = implication([opposite([sign + f], [], [step])], [{"form": "roots", "by": by}])
        statement = f"s**2 != {square}"
        rejects(forged(statement, field, "proved", "implication", evidence), ".")


def test_cubes_have_roots_in_local_fields() -> None:
    step = {"step": "no root", "polynomial": "s**3 - 2", "cofactors": ["1"], "denominator": 1}
    for by in ("factors", "squares"):
        evidence = implication([opposite(["s**3 - 2"], [], [step])], [{"form": "roots", "by": by}])
        for field in ("Qp(5)", "QQ[a]/(a^3-2)", "RR", "GF(5)"):
            rejects(forged("s**3 != 2", field, "proved", "implication", evidence), ".")


HALVES, PLUS = ["1/2"] * 4, ["1", "1", "0", "0"]
CUBE, GOLDEN = "QQ[s]/(s^3-2)", "QQ[s]/(s^2-5)"
NO_PLACES: list[tuple[Field, Any]] = [
    *((CUBE, ideal(n, 0, 1, 0)) for n in (4, 0, 1, -2, "2", 2.0)),
    *((CUBE, ideal(2, *x)) for x in ((0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 1), (0, 1), ("2/2", 1, 0))),
    *((CUBE, ideal(n)) for n in (2, -2, 3)),
    *((CUBE, other(2, [0, 1], x)) for x in ([0, 2, 0], [1, 0, 0], [0, 0, 0], [0, "1/2", 0], [[0, 1, 0]])),
    (CUBE, other(2, [[0, 1, 0]], [0, 1, 0])),
    (CUBE, number(2)),
    ("QQ(zeta5)", ideal(2)),
    ("QQ(zeta3)", ideal(2)),
    ("QQ(zeta8)", ideal(2, -1, 1, 0, 0)),
    ("QQ[s]/(s^2+1)", ideal(2, 1, 1)),
    (GOLDEN, ideal(2, -1, 1)),
    (GOLDEN, other(2, [1, 1, 1], [0, 1])),
    ("QQ[s]/(s^2+3)", other(2, [1, 1, 1], ["1/2", "1/2"])),
    (generated([-8, 0, 0, 1]), ideal(2, 0, 1, 0)),
    (generated([-4, 0, 1]), ideal(2, 0, 1)),
    ("QQ[s]/(s^2-17)", ideal(2)),
    ("QQ[s]/(s^2-1/2)", ideal(2, 0, 1)),
    *(("QQ", number(n)) for n in (3, 9, 1, -2, 4, True, "2")),
    ("QQ", INFINITY),
    ("QQ(sqrt(-7))", split(2, 5)),
    ("QQ(sqrt(-7))", number(2)),
    ("QQ(I)", number(2)),
    ("QQ(sqrt(-3))", number(2)),
    ("Qp(3)", number(2)),
    ("Qp(5)", number(5)),
    ("GF(3)((t))", prime(0, 1)),
    ("GF(3)(t)", prime(1, 0, 1)),
    ("GF(3)(t)", prime(2, 0, 1)),
    ("GF(3)(t)", INFINITY),
    ("CC", number(2)),
    ("RR", number(2)),
    ("QQ(x)", number(2)),
    ("QQ(sqrt(2),sqrt(3))", number(2)),
]  # fmt: skip


@subcases(("field", "place"), NO_PLACES)
def test_no_place_shows_a_split_algebra_to_be_a_division_algebra(field: Field, place: Any) -> None:
    for u, j in product(
        (HALVES, ["0", "1", "0", "0"], ["0", "1", "1", "0"]),
        (PLUS, ["0", "0", "1", "0"], ["1", "1", "1", "0"], ["0"] * 4),
    ):
        evidence = {"kind": "anisotropic", "by": "place", "place": place, "u": u, "j": j}
        rejects(forged("division", field, "proved", "anisotropic norm", evidence), ".")


def own(field: str | Data) -> Data:
    return data_of(field) if isinstance(field, str) else field


def _inside(field: str | Data, root: str, witness: Any) -> dict[str, Any]:
    return {"kind": "subfield", "ring": own(field), "root": root, "witness": witness}


SUBFIELDS: list[tuple[str, Field, str | Data, str, str]] = [
    ("exists s: s*s == 2", "Qp(5)", "QQ(sqrt(2))", "1", "sqrt(2)"),
    ("exists s: s*s == -1", "Qp(2)", "QQ(I)", "1", "I"),
    ("exists s: s*s == 5", "Qp(2)", "QQ(sqrt(5))", "1", "sqrt(5)"),
    ("exists s: s*s == 5", "Qp(5)", "QQ(sqrt(5))", "5", "sqrt(5)"),
    ("exists s: s*s == 5", "Qp(5)", "QQ(sqrt(5))", "1/5", "sqrt(5)"),
    ("exists s: s*s == 5", "Qp(5)", "QQ(sqrt(5))", "0", "sqrt(5)"),
    ("exists s: s*s == 3", "Qp(2)", "QQ(sqrt(3))", "1/2", "sqrt(3)"),
    ("exists s: s*s == 2", "Qp(7)", "QQ(sqrt(2),sqrt(3))", "3", "sqrt(2)"),
    ("exists s: s*s == 2", "Qp(7)", "QQ[a]/(a^2-2)", "1", "a"),
    ("exists s: s*s == 2", "Qp(3)", "QQ[a]/(a^2-2)", "3", "a"),
    ("exists s: s**3 == 2", "Qp(7)", "QQ[g]/(g^3-2)", "3", "g"),
    ("exists s: s**3 == 2", "Qp(2)", "QQ[g]/(g^3-2)", "2", "g"),
    ("exists s: s**3 == 2", "Qp(7)", "QQ[g]/(g^3-2)", "3/7", "g"),
    ("exists s: s**3 == 2", "Qp(7)", "QQ[g]/(g^3-2)", "1/49", "g"),
    ("exists s: 7*s**3 == 1", "Qp(7)", "QQ[g]/(g^3-1/7)", "1/7", "g"),
    ("exists s: s**3 == 8", "Qp(7)", generated([-8, 0, 0, 1], "g"), "2", "g"),
    ("exists s: s**3 == 2", completion(QQ, number(4)), "QQ[g]/(g^3-2)", "2", "g"),
    ("exists s: s**4 == -1", "Qp(3)", "QQ(zeta8)", "1", "zeta8"),
    ("exists s: s*s == 2", "QQ", "QQ(sqrt(2))", "3", "sqrt(2)"),
    ("exists s: s*s == 3", "QQ(sqrt(2))_(7, sqrt(2)-3)", "QQ(sqrt(3))", "1", "sqrt(3)"),
    ("exists s: s*s == -1", "GF(5)((t))", "QQ(I)", "2", "I"),
]


@subcases(("statement", "field", "inner", "root", "value"), SUBFIELDS)
def test_a_root_that_is_not_there_embeds_nothing(
    statement: str, field: Field, inner: str | Data, root: str, value: str
) -> None:
    witness = {"kind": "witness", "ring": own(inner), "values": {"s": [value]}}
    rejects(forged(statement, field, "proved", "witness", _inside(inner, root, witness)), ".")


def test_the_witness_lies_in_the_subfield_that_is_named() -> None:
    statement, witness = (
        "exists s: s*s == -1",
        {"kind": "witness", "ring": data_of("QQ(I)"), "values": {"s": ["I"]}},
    )
    true = forged(statement, "Qp(5)", "proved", "witness", _inside("QQ(I)", "2", witness))
    assert check(true)
    rejects({**true, "evidence": {**true["evidence"], "by": "Hensel"}}, "unknown key")
    rejects({**true, "evidence": _inside("QQ(I)", "2", true["evidence"])}, ".")
    rejects({**true, "evidence": _inside("QQ(I)", "1", witness)}, "Hensel")
    rejects({**true, "evidence": _inside("QQ(sqrt(-6))", "2", witness)}, ".")
    rejects({**true, "evidence": _inside("QQ(I)", "2", {"kind": "none exists", "proof": {}})}, ".")
    rejects(forged("s*s != -1", "Qp(3)", "refuted", "counterexample", true["evidence"]), ".")


def test_long_numbers_that_do_not_fit_are_rejected_and_break_nothing() -> None:
    """Python writes no integer of more than 4300 digits, in messages neither, and reads none."""
    witness = {"kind": "witness", "ring": data_of("QQ(I)"), "values": {"s": ["I"]}}
    for root in ("3**9999", "1/3**9999"):
        evidence = _inside("QQ(I)", root, witness)
        rejects(forged("exists s: s*s == -1", "Qp(7)", "proved", "witness", evidence), "Hensel")
    for place, said in (
        (split(7, 10**5000), "more than 4000 digits"),
        (split(7, 10**3999), "is not"),
    ):
        evidence = {
            "kind": "anisotropic",
            "by": "place",
            "place": place,
            "u": ["0"] * 4,
            "j": ["0"] * 4,
        }
        rejects(forged("division", "QQ(sqrt(2))", "proved", "norm", evidence), said)


ROOTS: list[tuple[dict[str, Any], str]] = [
    ({"kind": "real root", "by": "odd degree"}, ODD_DEGREE),
    ({"kind": "real root", "by": "square"}, REAL_ROOTS),
    ({"kind": "real root", "by": "sign change", "between": ["0", "1"]}, SIGN_CHANGE),
    ({"kind": "complex root"}, COMPLEX_ROOT),
    ({"kind": "quaternion root"}, QUATERNION_ROOT),
]
ROOTLESS = [
    ("s**3 == 2", "QQ"),
    ("s**2 == -1", "RR"),
    ("s**2 == y", "RR"),
    ("y*s**3 == 2", "RR"),
    ("0*s == 1", "RR"),
    ("s**2 == sqrt(2) - 2", "RR"),
    ("s*i + s*j == i + 2*j", "RR"),
    ("s**2 == -2*y**2", "RR"),
    ("y*s == 1", "CC"),
    ("s**2 - 2*s == -2", "RR"),
    ("-s**2 == 1 + y**2", "RR"),
    ("s**2 == y*x", "RR"),
    ("s == s + 1", "CC"),
    ("s**2 != s**2", "CC"),
    ("s**3 == 2/y", "RR"),
    ("not (s**3 == s**3)", "RR"),
    ("s**3 == 2", "Qp(7)"),
    ("q*i - i*q == 1", "RR"),
    ("q*q + i*q*q == 1", "QQ"),
    ("(e-e)*q == 1", "RR"),
    ("q == q + 1", "RR"),
    ("q**0 == 2", "RR"),
    ("p*q == 1", "RR"),
    ("conj(q)*q == -1", "RR"),
    ("norm(q) == -1", "RR"),
    ("q[0]*q == -1", "RR"),
    ("q != q", "RR"),
    ("0*q*q + q == q + 1", "RR"),
    ("0.0*q*q == 1", "RR"),
    ("comm(q,i) == 1", "RR"),
    ("sqrt(2)*q**2 == q**2*sqrt(2) + 1", "RR"),
    ("(i*j-k)*q == 1", "RR"),
    ("(q-q)*q**2 + q == q + 1", "RR"),
]


@subcases(("equation", "field"), ROOTLESS)
def test_no_theorem_gives_a_root_that_is_not_there(equation: str, field: str) -> None:
    name = "q" if "q" in equation.replace("sqrt", "") else "s"
    for evidence, theorem in ROOTS:
        statement = f"exists {name}: {equation}"
        rejects(forged(statement, field, "proved", "witness", evidence, assumes=[theorem]), ".")


# --- presentations --------------------------------------------------------------------------------

ANTI = "associative(i, j, k): i*i == -1 and j*j == -1 => i*j == -j*i"
ANTI_DATA: dict[str, Any] = {
    "kind": "presentation",
    "characteristic": 0,
    "identity": True,
    "relations": [[[1, "ii"], [1, ""]], [[1, "jj"], [1, ""]]],
    "goals": [[[1, "ij"], [1, "ji"]]],
}
HALVED = "associative(i, j, k): 2*i == 0 => i == 0"
HALVED_DATA: dict[str, Any] = {
    "kind": "presentation",
    "characteristic": 0,
    "identity": True,
    "relations": [[[2, "i"]]],
    "goals": [[[1, "i"]]],
}


def test_presentations_prove_what_they_multiply_out() -> None:
    two = [{"cofactors": [[1, "", 0, ""]], "denominator": 2}]
    none = [{"cofactors": [], "denominator": 1}]
    for statement, field, data, more in (
        (ANTI, None, ANTI_DATA, {"proofs": none}),
        (ANTI, None, ANTI_DATA, {"proofs": [{"cofactors": [], "denominator": 0}]}),
        (ANTI, None, ANTI_DATA, {"proofs": [{"cofactors": [[1, "", -1, ""]], "denominator": 1}]}),
        (ANTI, None, ANTI_DATA, {"proofs": none, "goals": [[[0, "ij"]]]}),
        (ANTI, "QQ", ANTI_DATA, {"proofs": none, "characteristic": 2}),
        (ANTI, None, ANTI_DATA, {"proofs": [], "goals": []}),
        (HALVED, None, HALVED_DATA, {"proofs": two}),
        (HALVED, "GF(2)", HALVED_DATA, {"proofs": two}),
        (HALVED, "GF(2)", HALVED_DATA, {"proofs": none, "characteristic": 2}),
        (HALVED, "ZZ/6", HALVED_DATA, {"proofs": two}),
        (
            HALVED,
            "QQ",
            HALVED_DATA,
            {"proofs": [{"cofactors": [[1, "e", 0, ""]], "denominator": 2}]},
        ),
        (HALVED, "QQ", HALVED_DATA, {"proofs": two, "identity": 1}),
    ):
        rejects(forged(statement, field, "proved", "presentation", {**data, **more}), ".")
    assert check(
        forged(HALVED, "QQ", "proved", "presentation", {**HALVED_DATA, "proofs": two})
    ).verdict
