"""Statements as propositions of Coq: the text follows the tree, and nothing else is exported."""

import pytest

from hfield.coq.export import Export, comment_text, export_session, export_statements
from hfield.coq.facts import NoProofError
from hfield.coq.theorems import FIELDS, RINGS
from hfield.errors import NotationError
from hfield.proving.prove import prove


def one(statement, algebra=None):
    (theorem,) = export_statements([statement], algebra).theorems
    return theorem


@pytest.mark.parametrize(
    ("statement", "text"),
    [
        ("(p*q)*r == p*(q*r)", "p [*H] q [*H] r = p [*H] (q [*H] r)"),
        ("s*(y*q) == (s*y)*q", "s [.] (y [.] q) = s * y [.] q"),
        ("q*s == s*q", "s [.] q = s [.] q"),
        ("s + q == q + s", "embed s [+] q = q [+] embed s"),
        ("s - (y - 3) == s - y + 3", "s - (y - num 3) = s - y + num 3"),
        ("norm(-q) == norm(q)", "norm H ([-] q) = norm H q"),
        ("-(-1) == 1", "- (- (1)) = 1"),
        ("conj(q)[1] == -q[1]", "im (conj H q) = - im q"),
        ("q**2*q == q**3", "qpow H q 2 [*H] q = qpow H q 3"),
        ("s**2 == s*s and trace(s) == 2*s", "pow s 2 = s * s /\\ trace H (embed s) = num 2 * s"),
        ("comm(p, q) == -comm(q, p)", "comm H p q = [-] comm H q p"),
        ("scalar(q) + vector(q) == q", "embed (re q) [+] vector q = q"),
        ("i*j == k", "i [*H] j = k"),
    ],
)
def test_terms(statement, text):
    theorem = one(statement)
    assert theorem.text.split(",\n  ")[-1] == text
    assert theorem.room == RINGS


def test_hypotheses_and_quantifiers():
    theorem = one("2 == 0 => p*q == q*p")
    assert theorem.text == ("forall (p q : quaternion R),\n  num 2 = 0 ->\n  p [*H] q = q [*H] p")
    assert one("exists q: q*q == -1").text == "exists (q : quaternion R), q [*H] q = embed (- (1))"


def test_a_comparison_that_divides_says_that_it_may():
    theorem = one("norm(q) != 0 => q*inv(q) == e and (q/norm(q))*norm(q) == q")
    assert theorem.room == FIELDS
    assert theorem.text.split("->\n  ")[1] == (
        "(norm H q <> 0 /\\ q [*H] qinv H q = e)"
        " /\\ norm H q <> 0 /\\ norm H q [.] (q [/] norm H q) = q"
    )
    assert "num 2 <> 0 /\\ 1 / num 2 * num 2 = 1" in one("2 != 0 => 0.5*2 == 1").text


def test_negation_and_choice_need_a_field():
    assert one("s*y == 0 => s == 0 or y == 0").room == FIELDS
    assert one("p == q or p == -q => p*p == q*q").room == RINGS
    assert "(~ (s = 0 /\\ y = 0)) -> s <> 0 \\/ y <> 0" in one(
        "not (s == 0 and y == 0) => s != 0 or y != 0"
    ).text.replace("\n  ", " ")


def test_other_algebras():
    theorem = one("norm(p*q) == norm(p)*norm(q)", "[a,b|F)")
    A = "(Algebra a 1 b)"
    assert theorem.text == (
        f"forall (p q : quaternion R) (a b : R),\n  norm {A} (p [*{A}] q) = norm {A} p * norm {A} q"
    )
    assert theorem.comment.endswith("in [a,b|F) [proved over commutative rings]")


@pytest.mark.parametrize(
    ("statement", "field", "reason"),
    [
        ("p*q == q*p", None, "refuted, so this is no theorem"),
        ("p*q == q*p", "GF(2)", "decided over GF(2) only"),
        ("norm(q) == 0 => q == 0", "QQ", "decided over QQ only"),
        ("((((q**3)**3)**3)*p)*r == (((q**3)**3)**3)*(p*r)", None, "too large to unfold"),
        ("s**501 == s*s**500", None, "the exponent 501 is larger than 500"),
        ("s + 7**1000 == 7**1000 + s", None, "the exponent 1000 is larger than 500"),
        (f"s + {10**800} == {10**800} + s", None, "a number has more than 2000 bits"),
    ],
)
def test_what_is_left_out_says_why(statement, field, reason):
    export = export_session([prove(statement, field)])
    assert not export.theorems
    assert reason in export.left[0].reason
    assert f"(* Not in this file:\n   statement_1: {statement[:20]}" in export.text


def test_a_session_keeps_its_order():
    answers = [prove("e*q == q"), prove("p*q == q*p"), prove("q*e == q")]
    export = export_session(answers)
    assert [t.name for t in export.theorems] == ["statement_1", "statement_3"]
    assert [x.name for x in export.left] == ["statement_2"]


def test_unreadable_statements_are_errors():
    with pytest.raises(NotationError):
        export_statements(["p +"])
    assert issubclass(NoProofError, ArithmeticError)


def test_comments_cannot_be_closed_from_inside():
    assert comment_text('a (* b *) "c"') == "a ( * b * ) 'c'"
    assert Export(()).text.count("(*") == Export(()).text.count("*)")


def test_cofactors_are_written_out():
    proof = one("s*s == norm(p) and y*y == norm(q) => (s*y)*(s*y) == norm(p*q)").proof
    assert "combine (cons (pow (y) 2) h2 (cons (pow (re p) 2" in proof
    assert one("3*s == 0 and 2*s == 0 => s == 0").proof.count("equal_or_not (num 3) 0") == 1
