"""Comparisons and moduli over ordered fields: what is proved, refuted, refused, and forged certificates."""

from fractions import Fraction
from math import sqrt
from random import Random
from typing import Any

import flint
import numpy as np
import pytest

from hfield import NotationError, Rejected, check, prove
from hfield.cli import main
from hfield.export.coq.judgement import Judgement
from hfield.export.coq.terms import NotCoveredError
from hfield.prover.polynomials.sums_of_squares import as_sum_of_squares
from hfield.prover.statements.printing import to_latex, to_unicode
from hfield.prover.statements.setting import read_setting
from hfield.syntax import parse
from tests.subcases import first_quick, pairs_quick

ORDERED = [None, "QQ", "QQ(sqrt(2))", "RR"]
STATEMENTS = [
    ("abs(p*q) == abs(p)*abs(q)", "proved"),
    ("abs(p + q) == abs(p) + abs(q)", "refuted"),
    ("norm(q) >= 0", "proved"),
    ("norm(p + q) <= 2*norm(p) + 2*norm(q)", "proved"),
    ("q != 0 => norm(q) > 0", "proved"),
    ("norm(q) > 0 <=> q != 0", "proved"),
    ("norm(q) > 0", "refuted"),
    ("dot(p,q)**2 <= norm(p)*norm(q)", "proved"),
    ("dot(p,q)**2 < norm(p)*norm(q)", "refuted"),
    ("norm(comm(p,q)) <= 4*norm(p)*norm(q)", "proved"),
    ("norm(q) < -1 => p == q", "vacuous"),
    ("abs(p) >= 0", "proved"),
    ("norm(q) == 1 => q[0] <= 1", "proved"),
    ("norm(q) == 1 => q[0] < 1", "refuted"),
    ("norm(p) >= 1 and norm(q) >= 1 => norm(p*q) >= 1", "proved"),
    ("s >= 0 and t >= 0 => s*t >= 0", "proved"),
    ("s >= t and t >= x => s >= x", "proved"),
    ("s >= t and t >= s <=> s == t", "proved"),
    ("s >= 0 or s <= 0", "proved"),
    ("s > 0 <=> 1/s > 0", "proved"),
    ("s >= 0 <=> 1/s >= 0", "refuted"),
    ("1/s >= 0 or 1/s < 0", "refuted"),
    ("not (1/0 >= 0)", "proved"),
]


@pytest.mark.parametrize(("case", "field"), pairs_quick(STATEMENTS, ORDERED, 5))
def test_statements_with_an_order(case: tuple[str, str], field: str | None) -> None:
    statement, verdict = case
    answer = prove(statement, field)
    assert answer.verdict == verdict
    assert answer.certificate is not None, answer.why_no_certificate
    found = check(answer.certificate)
    assert found.verdict == verdict
    if field is None and verdict == "proved":
        assert answer.decision.scope == found.scope == "ordered fields"
    assert set(answer.witness or {}) <= set("pqstxF")


@pytest.mark.parametrize(
    ("statement", "options", "verdict"),
    [
        ("norm(q) >= 0", {"field": "QQ(x)"}, "proved"),
        ("norm(q) >= 0", {"field": "ZZ"}, "proved"),
        ("norm(q) >= x", {"field": "QQ(x)"}, "undecided"),
        ("sqrt(2) > 1 and sqrt(2) < 3/2", {"field": "QQ(sqrt(2))"}, "proved"),
        ("norm(q) >= sqrt(2)", {"field": "QQ(sqrt(2))"}, "refuted"),
        ("a < 0 and b < 0 => norm(q) >= 0", {"algebra": "(a,b|F)"}, "proved"),
        ("norm(q) >= 0", {"algebra": "(a,b|F)"}, "refuted"),
        ("norm(q) >= 0", {"field": "RDF"}, "undecided"),
        ("1/s >= 0 or 1/s <= 0", {"field": "ZZ"}, "undecided"),
    ],
)
def test_an_order_elsewhere(statement: str, options: dict[str, str], verdict: str) -> None:
    answer = prove(statement, **options)
    assert answer.verdict == verdict
    assert verdict == "undecided" or check(answer.certificate).verdict == verdict


@pytest.mark.parametrize(
    ("statement", "options", "words"),
    [
        ("norm(q) >= 0", {"field": "GF(7)"}, "GF.7. is not known to have an order"),
        ("norm(q) > 0", {"field": "QQ(I)"}, "needs an ordered field, such as QQ"),
        ("norm(q) <= 0", {"field": "Qp(5)"}, "<= needs an ordered field"),
        ("p >= 0", {}, "compares scalars, and this is a quaternion"),
        ("M >= 0", {}, "compares scalars, and this is a matrix"),
        ("exists q: norm(q) > 3", {"field": "QQ"}, "a statement cannot have both"),
        ("p[0] >= 0", {"algebra": "table(e, i: e, i; i, -e|QQ)"}, "algebra by its table"),
    ],
)
def test_what_has_no_order(statement: str, options: dict[str, str], words: str) -> None:
    with pytest.raises(NotationError, match=words):
        prove(statement, **options)


def _forms() -> list[tuple[str, Any]]:
    def dot(p: Any, q: Any) -> Any:
        return p[1:] @ q[1:]

    return [
        ("norm(p)", lambda p, q: p @ p),
        ("norm(q)", lambda p, q: q @ q),
        ("dot(p,q)", dot),
        ("scalar(p*q)", lambda p, q: p[0] * q[0] - dot(p, q)),
        ("p[1]*q[2]", lambda p, q: p[1] * q[2]),
        ("norm(p - 2*q)", lambda p, q: (p - 2 * q) @ (p - 2 * q)),
    ]


@pytest.mark.parametrize("seed", first_quick(range(12), 4))
def test_quadratic_forms_are_as_their_eigenvalues_say(seed: int) -> None:
    rng = Random(seed)
    parts = [(rng.randint(-3, 6), *part) for part in rng.sample(_forms(), 4)]
    e = np.eye(8)

    def value(v: Any) -> float:
        return float(sum(c * f(v[:4], v[4:]) for c, _, f in parts))

    gram = [[value(x + y) - value(x) - value(y) for x in e] for y in e]
    least = float(np.linalg.eigvalsh(np.array(gram))[0])
    verdict = prove(" + ".join(f"({c})*{t}" for c, t, _ in parts) + " >= 0", "QQ").verdict
    assert verdict == ("proved" if least > -1e-9 else "refuted")


def test_a_polynomial_that_is_never_negative_and_no_sum_of_squares_is_not_proved() -> None:
    motzkin = "s**4*t**2 + s**2*t**4 - 3*s**2*t**2 + 1"
    assert prove(f"{motzkin} >= 0", timeout=3).verdict == "undecided"
    assert prove(f"(s**2 + t**2)*({motzkin}) >= 0").verdict == "proved"


@pytest.mark.parametrize("seed", range(20))
def test_sums_of_squares_are_found_and_add_up(seed: int) -> None:
    rng = Random(seed)
    context = flint.fmpz_mpoly_ctx.get(["x", "y", "z"], "lex")
    x, y, z = context.gens()
    monomials = [x * x, x * y, y * z, x, y, z, context.constant(1)]
    f = context.constant(0)
    for _ in range(3):
        g = sum((rng.randint(-3, 3) * m for m in rng.sample(monomials, 3)), context.constant(0))
        f += rng.randint(1, 5) * g * g
    f += sum((m * m for m in monomials), context.constant(0))
    squares = as_sum_of_squares(f)
    assert squares is not None
    assert all(c > 0 for c, _ in squares)
    total = sum((c * g * g for c, g in squares), context.constant(0))
    assert total * f.leading_coefficient() == f * total.leading_coefficient()


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("<=", "<"),
        ("<=", ">="),
        ("dot", "abs"),
        ("norm(p)*", ""),
        ("dot(p,q)**2", "2*dot(p,q)**2"),
    ],
)
def test_a_certificate_of_another_inequality_is_refused(old: str, new: str) -> None:
    good: Any = prove("dot(p,q)**2 <= norm(p)*norm(q)").certificate
    with pytest.raises(Rejected):
        check(good | {"statement": good["statement"].replace(old, new, 1)})


@pytest.mark.parametrize("field", ["GF(7)", "QQ(I)", "QQ[x]/(x^2)"])
def test_a_proof_over_ordered_fields_is_none_elsewhere(field: str) -> None:
    good: Any = prove("norm(q) >= 0").certificate
    other: Any = prove("p == p", field).certificate
    moved = {key: other[key] for key in ("field", "ring", "algebra")}
    with pytest.raises(Rejected, match="not known to have an order"):
        check(good | moved)


def test_a_witness_lies_in_the_field_and_is_one() -> None:
    good: Any = prove("norm(q) >= 1", "QQ").certificate
    for values in (["1", "0", "0", "0"], ["sqrt(2)", "0", "0", "0"], ["1/2", "1", "0", "0"]):
        with pytest.raises(Rejected):
            check(good | {"evidence": good["evidence"] | {"values": {"q": values}}})
    free: Any = prove("norm(q) >= 1").certificate
    ring = prove("p == p", "GF(2)").certificate["ring"]  # type: ignore[index]
    with pytest.raises(Rejected, match="refuted by rational numbers"):
        check(free | {"evidence": free["evidence"] | {"ring": ring}})


def test_weights_of_squares_are_positive() -> None:
    good: Any = prove("norm(q) >= 0", "QQ").certificate
    step = good["evidence"]["items"][0]["steps"][0]
    step["coefficients"][0] = -step["coefficients"][0]
    with pytest.raises(Rejected):
        check(good)


def test_coq_and_lean_say_that_they_have_no_order() -> None:
    judgement = Judgement("t", "abs(q) == abs(q)", read_setting(None, None))
    with pytest.raises(NotCoveredError, match="moduli and comparisons"):
        judgement.by("proved", {"kind": "identity"})


def test_signs_are_read_and_written(capsys: pytest.CaptureFixture[str]) -> None:
    node = parse("norm(q) >= 0 and s < t")
    assert to_unicode(node) == "N(q) ≥ 0 ∧ s < t"
    assert to_latex(node).count(r"\geq") == 1
    assert main(["prove", "N(q) ≥ 1", "--field", "QQ"]) == 1
    assert "N(q) = 0 < 1" in capsys.readouterr().out


def test_what_is_proved_is_true_at_random_points() -> None:
    rng = Random(3)
    statement = (
        "abs(p*q) >= 0 and norm(p - q) <= 2*norm(p) + 2*norm(q) and dot(p,q)**2 <= norm(p)*norm(q)"
    )
    assert prove(statement)
    for _ in range(200):
        p, q = ([Fraction(rng.randint(-9, 9), rng.randint(1, 5)) for _ in range(4)] for _ in "pq")
        norms = [sum(c * c for c in x) for x in (p, q)]
        assert sum((a - b) ** 2 for a, b in zip(p, q, strict=True)) <= 2 * sum(norms)
        assert sum(a * b for a, b in zip(p[1:], q[1:], strict=True)) ** 2 <= norms[0] * norms[1]
        assert sqrt(norms[0] * norms[1]) >= 0
