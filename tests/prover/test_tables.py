"""Statements about algebras by their tables: verdicts, certificates, and forged ones."""

import itertools
from copy import deepcopy
from random import Random
from typing import Any

import pytest

from hfield import NotationError, Rejected, StructureAlgebra, check, prove, ring
from hfield.checker.check import ExpectedClaim
from hfield.cli import main
from tests.subcases import slow
from tests.test_structure_algebra import TABLE_1_1, octonions, quaternions, random_table

DUAL = StructureAlgebra("QQ", [["e", "d"], ["d", "0*d"]], names="e d")


@pytest.mark.parametrize(
    ("algebra", "statement", "verdict"),
    [
        (quaternions(), "(p*q)*r == p*(q*r)", "proved"),
        (quaternions(), "p*q == q*p", "refuted"),
        (quaternions(), "i*j == k and p*1 == p", "proved"),
        (quaternions(), "p*q == q*p => comm(p, q) == 0", "proved"),
        (quaternions(), "p**2 == -1 => p[0] == 0", "proved"),
        (quaternions(), "exists p: p*p == -1 and p != i", "proved"),
        (quaternions(), "p*q == 0 => p == 0 or q == 0", "proved"),
        (quaternions("GF(3)"), "p*q == 0 => p == 0 or q == 0", "refuted"),
        (octonions(), "(p*p)*q == p*(p*q)", "proved"),
        slow(octonions(), "(p*q)*r == p*(q*r)", "refuted"),
        slow(octonions(), "((p*q)*p)*r == p*(q*(p*r))", "proved"),
        (octonions("GF(3)"), "(p*q)*p == p*(q*p)", "proved"),
        (DUAL, "p*q == q*p", "proved"),
        (DUAL, "p*p == 0 => p == 0", "refuted"),
        (DUAL, "p*p == 0 => (exists s: p == s*d)", "proved"),
        (DUAL, "d*d/s == 0 => s != 0", "proved"),  # where s = 0 the quotient is undefined
        (DUAL, "(d/s)[0] == 0 => s != 0", "proved"),
        (StructureAlgebra("ZZ", [["2*a"]], names="a"), "p*q == q*p", "proved"),
        (StructureAlgebra("GF(9)", [["x*a"]], names="a"), "p*a == x*p", "proved"),
        (StructureAlgebra("QQ", [["1/2*a"]], names="a"), "2*(p*p) == p[0]*p", "proved"),
    ],
)
def test_statements_are_decided_with_certificates(
    algebra: StructureAlgebra, statement: str, verdict: str
) -> None:
    answer = prove(statement, algebra=algebra)
    assert answer.verdict == verdict
    assert answer.certificate is not None, answer.why_no_certificate
    found = check(answer.certificate)
    assert (found.verdict, found.algebra) == (verdict, str(algebra))


@pytest.mark.slow
def test_a_witness_has_elements_that_the_algebra_reads() -> None:
    B = octonions()
    witness = prove("(p*q)*r == p*(q*r)", algebra=B).witness
    assert witness is not None
    p, q, r = (B(witness[x][0]) for x in "pqr")
    assert (p * q) * r != p * (q * r)


def test_random_tables_are_associative_or_not_with_certificates() -> None:
    rng, seen = Random(5), set()
    for _ in range(40):
        m, n = rng.choice(((2, 2), (3, 2), (5, 2), (3, 3)))
        B = StructureAlgebra(ring(f"GF({m})"), random_table(rng, m, n))
        answer = prove("(p*q)*r == p*(q*r)", algebra=B)
        assert bool(answer) == bool(B.is_associative())
        assert answer.certificate is not None, answer.why_no_certificate
        seen.add(answer.verdict)
    assert seen == {"proved", "refuted"}


def changed_signs() -> list[str]:
    out = []
    for row, column in itertools.product((1, 2, 3), repeat=2):
        table = deepcopy(TABLE_1_1)
        entry = table[row][column]
        table[row][column] = entry[1:] if entry.startswith("-") else "-" + entry
        out.append(str(StructureAlgebra("QQ", table, names="e i j k")))
    return out


@pytest.mark.parametrize("algebra", changed_signs())
def test_a_proof_is_not_one_for_another_table(algebra: str) -> None:
    good: Any = prove("(p*q)*r == p*(q*r)", algebra=quaternions()).certificate
    with pytest.raises(Rejected):
        check(good | {"algebra": algebra})
    bad: Any = prove("(p*q)*r == p*(q*r)", algebra=algebra).certificate
    assert bad["verdict"] == "refuted"
    with pytest.raises(Rejected):
        check(bad | {"algebra": str(quaternions())})


@pytest.mark.parametrize(
    ("algebra", "words"),
    [
        ("table(e, d; 1 = d: e, d; d, 0*d|QQ)", "said to be the unit is not"),
        ("table(e, d; 1 = 2*e: e, d; d, 0*d|QQ)", "said to be the unit is not"),
        ("table(e, d; one: e, d; d, 0*d|QQ)", "expected '1 ='"),
        ("table(e, d: e, d; d, 0*d|QQ)", "algebra without unit"),
        ("table(e, e; 1 = e: e, e; e, e|QQ)", "all different"),
        ("table(e, d; 1 = e: e, d; d|QQ)", "2 rows of 2 products"),
        ("table(e, d; 1 = e: e, d; d, e*d|QQ)", "a combination of basis vectors"),
        ("table(e, d; 1 = e: e, d; d, 5|QQ)", "a combination of basis vectors"),
        ("table(e, d; 1 = e: e, d; d, 0*d|ZZ)", "names another ring"),
        ("(-1,-1|QQ)", "means nothing"),
    ],
)
def test_forged_tables(algebra: str, words: str) -> None:
    good: Any = prove("p + 1 == 1 + p and d*d == 0", algebra=DUAL).certificate
    check(good)
    with pytest.raises(Rejected, match=words.replace("*", r"\*")):
        check(good | {"algebra": algebra})


def test_a_certificate_of_a_table_is_none_of_hamiltons_quaternions() -> None:
    statement = "(p*q)*r == p*(q*r)"
    good: Any = prove(statement, algebra=quaternions()).certificate
    check(good, ExpectedClaim((statement,), "QQ", str(quaternions())))
    with pytest.raises(Rejected, match="about the algebra"):
        check(good, ExpectedClaim((statement,), "QQ"))
    hamilton: Any = prove(statement, "QQ").certificate
    with pytest.raises(Rejected, match="about the algebra"):
        check(hamilton, ExpectedClaim((statement,), "QQ", str(octonions())))


@pytest.mark.parametrize(
    "statement",
    ["center{e}", "citing{induction; p == p}", "associative(i, j, k): i*i == 0 => i == i"],
)
def test_words_about_wholes_are_none_of_a_table(statement: str) -> None:
    good: Any = prove("p == p", algebra=quaternions()).certificate
    with pytest.raises(Rejected):
        check(good | {"statement": statement})


@pytest.mark.parametrize(
    ("algebra", "statement", "words"),
    [
        (octonions(), "i == j", "means nothing in this algebra, whose basis is e0"),
        (quaternions(), "norm(p) == 1", "norm means nothing in an algebra by its table"),
        (quaternions(), "p/q == 1", "only a scalar divides"),
        (quaternions(), "M*p == 1", "'M' means nothing"),
        (DUAL, "p[2] == 0", "there is no coordinate 2"),
        (StructureAlgebra("ZZ", [["2*a"]], names="a"), "p == 1", "has no unit"),
        (StructureAlgebra("QQ", [["x"]], names="x"), "exists x: x == x", "is a basis vector"),
        (StructureAlgebra("QQ", [["0*e0"] * 13] * 13), "p == p", "at most 12"),
    ],
)
def test_what_means_nothing(algebra: StructureAlgebra, statement: str, words: str) -> None:
    with pytest.raises(NotationError, match=words):
        prove(statement, algebra=algebra)


def test_the_field_of_a_table_is_its_own() -> None:
    with pytest.raises(NotationError, match="is over QQ, the field is"):
        prove("p == p", "GF(3)", algebra=quaternions())


def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["prove", "p*q == q*p", "--algebra", "table(e, i: e, i; i, -e|QQ)"]) == 0
    assert main(["prove", "p*q == q*p", "--algebra", str(quaternions())]) == 1
    assert "p = i, q = j" in capsys.readouterr().out
