"""Statements as propositions of Coq: the text follows the tree, and nothing else is exported."""

import pytest

from hfield.errors import HFieldError, NotationError
from hfield.export.coq.base_rings import FIELDS, RINGS
from hfield.export.coq.cofactors import MismatchError
from hfield.export.coq.export import Export, export_session, export_statements
from hfield.export.coq.terms import HAMILTON, NotCoveredError, Terms
from hfield.export.coq.theorem import comment_text, theorem
from hfield.prover.prove import prove
from hfield.prover.statements.language import Sort
from hfield.syntax import parse
from tests.checker.cases import about_field
from tests.export.certificates import multilinear, true_certificates
from tests.subcases import slow, subcases


def one(statement, algebra=None):
    (theorem,) = export_statements([statement], algebra).theorems
    return theorem


@subcases(
    ("statement", "text"),
    [
        ("(p*q)*r == p*(q*r)", "p [*H] q [*H] r = p [*H] (q [*H] r)"),
        ("s*(y*q) == (s*y)*q", "s [.] (y [.] q) = s * y [.] q"),
        ("q*s == s*q", "s [.] q = s [.] q"),
        ("s + q == q + s", "embed s [+] q = q [+] embed s"),
        ("s - (y - 3) == s - y + 3", "s - (y - num 3) = s - y + num 3"),
        ("norm(-q) == norm(q)", "norm H ([-] q) = norm H q"),
        ("-(-1) == 1", "- (- (1)) = 1 :> R"),
        ("conj(q)[1] == -q[1]", "im (conj H q) = - im q"),
        ("q**2*q == q**3", "qpow H q 2 [*H] q = qpow H q 3"),
        ("s**2 == s*s and trace(s) == 2*s", "pow s 2 = s * s /\\ trace H (embed s) = num 2 * s"),
        ("comm(p, q) == -comm(q, p)", "comm H p q = [-] comm H q p"),
        ("scalar(q) + vector(q) == q", "embed (re q) [+] vector q = q"),
        ("i*j == k", "i [*H] j = k :> quaternion R"),
    ],
)
def test_terms(statement, text):
    theorem = one(statement)
    assert theorem.text.split(",\n  ")[-1].removeprefix(RINGS.opening) == text
    assert theorem.text.startswith(RINGS.opening)


def test_a_quaternion_is_no_scalar():
    terms = Terms([("q", Sort.QUATERNION), ("s", Sort.SCALAR)], [], HAMILTON)
    with pytest.raises(MismatchError, match="q is a quaternion, where a scalar is expected"):
        terms.term(parse("s/q"))
    with pytest.raises(MismatchError, match="s is a scalar, where a quaternion is expected"):
        _ = terms.names["s"].coordinates


def test_hypotheses_and_quantifiers():
    theorem = one("2 == 0 => p*q == q*p")
    assert theorem.text == (
        "every commutative ring R, forall (p q : quaternion R),\n"
        "  num 2 = 0 :> R ->\n  p [*H] q = q [*H] p"
    )
    assert one("exists q: q*q == -1").text == (
        "every commutative ring R, exists (q : quaternion R), q [*H] q = embed (- (1))"
    )


def test_a_comparison_that_divides_says_that_it_may():
    theorem = one("norm(q) != 0 => q*inv(q) == e and (q/norm(q))*norm(q) == q")
    assert theorem.text.startswith(FIELDS.opening)
    assert theorem.text.split("->\n  ")[1] == (
        "(norm H q <> 0 /\\ q [*H] qinv H q = e)"
        " /\\ norm H q <> 0 /\\ norm H q [.] (q [/] norm H q) = q"
    )
    assert "num 2 <> 0 :> R /\\ 1 / num 2 * num 2 = 1 :> R" in one("2 != 0 => 0.5*2 == 1").text


def test_negation_and_choice_need_a_field():
    assert one("s*y == 0 => s == 0 or y == 0").text.startswith(FIELDS.opening)
    assert one("p == q or p == -q => p*p == q*q").text.startswith(RINGS.opening)
    assert one("s == 0 => (y == s <=> y == 0)").text.startswith(RINGS.opening)
    assert "(~ (s = 0 /\\ y = 0)) -> s <> 0 \\/ y <> 0" in one(
        "not (s == 0 and y == 0) => s != 0 or y != 0"
    ).text.replace("\n  ", " ")


def test_other_algebras():
    theorem = one("norm(p*q) == norm(p)*norm(q)", "[a,b|F)")
    A = "(Algebra a 1 b)"
    assert theorem.text == (
        f"every commutative ring R, forall (p q : quaternion R) (a b : R),\n"
        f"  norm {A} (p [*{A}] q) = norm {A} p * norm {A} q"
    )
    assert theorem.comment.endswith("in [a,b|F) [proved, all fields]")


@pytest.mark.parametrize(
    ("statement", "field", "text"),
    [
        ("p*q == q*p", "GF(2)", "forall (p q : quaternion (GF 2)),\n  p [*H] q = q [*H] p"),
        (
            "norm(q) == 0 => q == 0",
            "QQ",
            "forall (q : quaternion Qc),\n  norm H q = 0 ->\n  q = embed 0",
        ),
        ("2 != 0", "GF(3)", "num 2 <> 0 :> GF 3"),
        (
            "s*s == 1 => s == 1 or s == -1",
            "ZZ",
            "forall (s : Z),\n  s * s = 1 ->\n  s = 1 \\/ s = - (1)",
        ),
        (
            "s/5 == 5*s",
            "ZZ/6",
            "forall (s : GF 6),\n  unit (num 5 : GF 6) /\\ s / num 5 = num 5 * s",
        ),
        (
            "7*s == 0 => s == 0",
            "GF(1000003)",
            "every field R, num (R := R) 1000003 = 0 -> forall (s : R),\n  num 7 * s = 0 ->\n  s = 0",
        ),
    ],
)
def test_one_ring(statement, field, text):
    (theorem,) = export_session([prove(statement, field)]).theorems
    assert theorem.text == text


def test_what_is_refuted_becomes_a_negation():
    def refuted(*words):
        return theorem("t", prove(*words).certificate).text

    assert refuted("p*q == q*p", "QQ") == (
        "~ (forall (p q : quaternion Qc),\n  p [*H] q = q [*H] p)"
    )
    assert refuted("p*q == q*p").startswith("~ (every field R, forall (p q : quaternion R),")
    assert refuted("exists s: s != 0 and s*s == 0", "GF(5)") == (
        "~ (exists (s : GF 5), s <> 0 /\\ s * s = 0)"
    )


@pytest.mark.parametrize(
    ("statement", "field", "reason"),
    [
        ("p*q == q*p", None, "refuted, so this is not a theorem"),
        ("norm(q) == 0 => q == 0", "QQ(sqrt(2))", "the field QQ(sqrt(2)): Coq has ZZ, QQ"),
        ("x**2 == -1 => x + x == 2*x", "GF(9)", "the field GF(9)"),
        ("i == i*k => q != s*q => e == k", "ZZ/4", "'not' or '!=' over ZZ/4"),
        slow("((((q**3)**3)**3)*p)*r == (((q**3)**3)**3)*(p*r)", None, "too large to unfold"),
        ("s**501 == s*s**500", None, "the exponent 501 is larger than 500"),
        slow("s + 7**1000 == 7**1000 + s", None, "the exponent 1000 is larger than 500"),
        (f"s + {10**800} == {10**800} + s", None, "a number has more than 2000 bits"),
    ],
)
def test_what_is_left_out_says_why(statement, field, reason):
    export = export_session([prove(statement, field)])
    assert not export.theorems
    assert reason in export.left[0].reason
    assert f"(* Not in this file:\n   statement_1: {statement[:20]}" in export.text


def test_a_part_that_is_vacuous_says_what_it_says():
    text = theorem("t", true_certificates()["a vacuous part"]).text.replace("\n  ", " ")
    assert text.endswith(
        "((norm H i = num 2 :> Qc) -> forall (p q : quaternion Qc), p [*H] q = q [*H] p)"
    )


def test_that_nothing_exists_is_not_said_where_constants_divide():
    data = prove("exists q: norm(p) == 3*s and comm(q, e) != 0", algebra="(0.5,3|F)").certificate
    assert data["verdict"] == "refuted"
    with pytest.raises(NotCoveredError, match="structure constants divide"):
        theorem("t", data)


def test_a_witness_has_quaternions_and_scalars():
    data = prove("exists s, q: s*q == 2*i and s != 0", "GF(5)").certificate
    (s,), q = (data["evidence"]["values"][name] for name in "sq")
    quaternion = " ".join(f"(reduce 5 {x})" for x in q)
    assert f"[Quaternion {quaternion}] [(reduce 5 {s})]" in str(theorem("t", data))


def test_a_session_keeps_its_order():
    answers = [prove("e*q == q"), prove("p*q == q*p"), prove("q*e == q")]
    export = export_session(answers)
    assert [t.name for t in export.theorems] == ["statement_1", "statement_3"]
    assert [x.name for x in export.left] == ["statement_2"]


def test_unreadable_statements_are_errors():
    with pytest.raises(NotationError):
        export_statements(["p +"])
    assert issubclass(NotCoveredError, NotImplementedError)


def test_comments_cannot_be_closed_from_inside():
    assert comment_text('a (* b *) "c"') == "a ( * b * ) 'c'"
    assert comment_text("a\u202eb\0\ud800\nc") == "a?b??\nc"  # nothing that turns the text around
    assert Export(()).text.count("(*") == Export(()).text.count("*)")


def test_evidence_is_written_out():
    proof = str(one("s*s == norm(p) and y*y == norm(q) => (s*y)*(s*y) == norm(p*q)"))
    assert "Direct [" in proof
    assert "X 9 ^ 2" in proof.replace("(X 9)", "X 9")


@subcases(
    ("change", "reason"),
    [
        ({"schema": "hfield-cert/3"}, "this is not a certificate"),
        ({"more": 1}, "this is not a certificate"),
        ({"verdict": "certain"}, "there is no verdict"),
        ({"field": "GF(3)"}, "the algebra and the field do not agree"),
        (
            {"field": "GF(3)", "algebra": "(-1,-1|GF(3))"},
            "the data of a ring are not those of its name",
        ),
        ({"ring": {"kind": "rationals"}}, "the data of a ring are not those of its name"),
        (about_field({"algebra": "(-1,-1|F)"}, "GF(3)") | {"algebra": "(-1,-1|F)"}, "the algebra"),
        ({"evidence": {"kind": "implication"}}, "not of the form"),
        ({"evidence": {"kind": "implication", "facts": [], "items": [{}]}}, "not of the form"),
        ({"evidence": []}, "not of the form"),
        ({"statement": "p ==", "evidence": {"kind": "identity"}}, "expected"),
    ],
)
def test_what_is_no_certificate_is_refused(change, reason):
    data = prove("2 == 0 => p*q == q*p").certificate
    with pytest.raises(HFieldError, match=reason):
        theorem("t", {**data, **change})


def test_tuples_of_three_basis_vectors_are_as_many_as_are_translated():
    data = multilinear("(p*q)*r == p*(q*r)", "pqr", None, lambda p, q, r: p * q * r)
    (values,) = theorem("t", data).proved.before  # 64 tuples, and both sides of each
    assert values.count("/\\") == 127


@pytest.mark.parametrize(
    "text", ["p[0]*", "p[4]", "q[0]", "2**p[0]", "p[0]/2", "(p[0]", "p[0] == 0", "", "T1"]
)
def test_only_polynomials_in_the_unknowns_are_evidence(text):
    data = prove("2 == 0 => p*p == p*p + 2*p").certificate
    item = {
        "characteristic": 0,
        "zero": ["2"],
        "relations": [],
        "member": "2*p[0]",
        "cofactors": [text],
        "denominator": 1,
    }
    with pytest.raises(MismatchError):
        theorem("t", {**data, "evidence": {"kind": "implication", "facts": [], "items": [item]}})
