"""The words dot, cross and abs: what they mean, what is proved of them, and forged certificates."""

from math import isqrt
from random import Random
from typing import Any

import pytest

from hfield import NotationError, Rejected, check, prove
from tests.subcases import first_quick

Q = tuple[int, int, int, int]


def text(q: Q) -> str:
    return " + ".join(f"({c})*{u}" for c, u in zip(q, "eijk", strict=True))


def dot(p: Q, q: Q) -> int:
    return sum(a * b for a, b in zip(p[1:], q[1:], strict=True))


def cross(p: Q, q: Q) -> Q:
    (_, a, b, c), (_, u, v, w) = p, q
    return 0, b * w - c * v, c * u - a * w, a * v - b * u


@pytest.mark.parametrize("seed", range(5))
def test_dot_and_cross_are_those_of_the_vector_parts(seed: int) -> None:
    rng = Random(seed)
    p, q = (tuple(rng.randint(-5, 5) for _ in range(4)) for _ in range(2))
    there = f"({text(p)}, {text(q)})"
    assert prove(f"dot{there} == {dot(p, q)} and cross{there} == {text(cross(p, q))}")
    assert not prove(f"dot{there} == {dot(p, q) + 1}", "QQ")
    assert not prove(f"cross{there} == {text(cross(q, p))} + e", "QQ")


@pytest.mark.parametrize("seed", first_quick([1, 0, 2, 3, 4], 1))
def test_abs_is_the_nonnegative_root_of_the_norm(seed: int) -> None:
    rng = Random(seed)
    while True:
        q = tuple(rng.randint(-9, 9) for _ in range(4))
        norm = sum(c * c for c in q)
        if norm and isqrt(norm) ** 2 == norm:
            break
    good = prove(f"q == {text(q)} => abs(q) == {isqrt(norm)}", "RR")
    assert good.verdict == "proved"
    assert good.certificate is not None
    assert (
        prove(f"q == {text(q)} and abs(q) == -{isqrt(norm)} => p == 0", "RR").verdict == "vacuous"
    )


@pytest.mark.parametrize(
    ("statement", "field", "verdict"),
    [
        ("scalar(p) == 0 and scalar(q) == 0 => p*q == cross(p, q) - dot(p, q)", None, "proved"),
        ("p*q == cross(p, q) - dot(p, q)", None, "refuted"),
        ("comm(p, q) == 2*cross(p, q)", None, "proved"),
        ("dot(p, cross(p, q)) == 0", "GF(9)", "proved"),
        ("norm(vector(p)) == dot(p, p)", None, "proved"),
        ("norm(cross(p, q)) == dot(p, p)*dot(q, q) - dot(p, q)**2", None, "proved"),
        ("exists q: cross(q, i) == k", "QQ", "proved"),
        ("abs(p*q) == abs(p)*abs(q)", "RR", "proved"),
        ("abs(p + q) == abs(p) + abs(q)", "RR", "refuted"),
        ("abs(p)**2 == norm(p)", "RR", "proved"),
        ("abs(conj(p)) == abs(p) and abs(-p) == abs(p)", "RR", "proved"),
        ("abs(s*p) == abs(s)*abs(p)", "RR", "proved"),
        ("abs(s) == s", "RR", "refuted"),
        ("abs(p) == 0 <=> p == 0", "RR", "proved"),
        ("abs(p) == -1 => p == q", "RR", "vacuous"),
        ("abs(abs(p)*q) == abs(p)*abs(q)", "RR", "proved"),
    ],
)
def test_statements_with_words(statement: str, field: str | None, verdict: str) -> None:
    answer = prove(statement, field)
    assert answer.verdict == verdict
    assert answer.certificate is not None, answer.why_no_certificate
    assert check(answer.certificate).verdict == verdict
    assert set(answer.witness or {}) <= set("pqsF")


@pytest.mark.parametrize(
    ("statement", "options", "words"),
    [
        ("dot(p) == 0", {}, "dot takes 2 arguments"),
        ("abs(p, q) == 0", {"field": "RR"}, "abs takes 1 argument"),
        ("abs(p) == 1", {"field": "QQ(I)"}, "needs an ordered field, .* and QQ.I. is not known"),
        ("abs(p) == 1", {"field": "RR", "algebra": "(1,1|RR)"}, "where no norm is negative"),
        ("exists p: abs(p) == 1", {"field": "RR"}, "a statement cannot have both"),
        ("abs(inv(p)) == 1", {"field": "RR"}, "no quotient and no inverse"),
        ("abs(M) == 1", {"field": "RR"}, "abs takes no matrix"),
        ("cross(M, N) == 1", {}, "cross takes no matrix"),
        (" and ".join(f"abs({n}*p) == 0" for n in range(13)), {"field": "RR"}, "at most 12"),
    ],
)
def test_what_the_words_do_not_take(statement: str, options: dict[str, str], words: str) -> None:
    with pytest.raises(NotationError, match=words):
        prove(statement, **options)


@pytest.mark.parametrize(
    ("statement", "field", "old", "new"),
    [
        ("dot(p, q) == dot(q, p)", None, "dot", "cross"),
        ("dot(p, q) == dot(q, p)", None, "dot", "abs"),
        ("cross(p, q) == -cross(q, p)", None, "-cross", "cross"),
        ("dot(p, q) == dot(q, p)", None, "dot(q, p)", "dot(q)"),
        ("abs(p*q) == abs(p)*abs(q)", "RR", "p*q", "p+q"),
        ("abs(p*q) == abs(p)*abs(q)", "RR", "== abs(p)", "== -abs(p)"),
        ("abs(conj(p)) == abs(p)", "RR", "abs(conj(p))", "abs(inv(p))"),
        ("abs(conj(p)) == abs(p)", "RR", "abs(conj(p)) ==", "exists p: abs(conj(p)) =="),
        ("abs(p)**2 == norm(p)", "RR", "abs(p)**2", "abs(p)"),
        ("abs(p)**2 == norm(p)", "RR", "abs(p)**2", "dot(p, p)"),
    ],
)
def test_a_certificate_is_none_for_other_words(
    statement: str, field: str | None, old: str, new: str
) -> None:
    good: Any = prove(statement, field).certificate
    check(good)
    assert old in good["statement"]
    with pytest.raises(Rejected):
        check(good | {"statement": good["statement"].replace(old, new)})


@pytest.mark.parametrize(
    ("algebra", "field", "why"),
    [
        ("(1,-1|RR)", "RR", "abs is about H over ordered fields"),
        ("(-1,-1|QQ(I))", "QQ(I)", "not known to have an order"),
        ("(-1,-1|GF(3))", "GF(3)", "not known to have an order"),
    ],
)
def test_there_are_no_moduli_where_norms_may_be_negative_or_there_is_no_order(
    algebra: str, field: str, why: str
) -> None:
    good: Any = prove("abs(p)**2 == norm(p)", "RR").certificate
    ring = prove("p == p", field).certificate["ring"]  # type: ignore[index]
    with pytest.raises(Rejected, match=why):
        check(good | {"algebra": algebra, "field": field, "ring": ring})
