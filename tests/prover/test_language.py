"""Reading and writing statements: sorts, errors with their positions, three styles."""

import pytest

from hfield.errors import HFieldError, NotationError
from hfield.fields.names import ring
from hfield.prover.statements.language import Sort, read_statement
from hfield.prover.statements.printing import to_latex, to_text, to_unicode
from hfield.syntax import parse
from tests.adversary.statement_generator import plain_statements
from tests.prover.statements import DEPENDS, FALSE, FIELDS, UNIVERSAL
from tests.subcases import subcases


@subcases("text", [*UNIVERSAL, *FIELDS, *FALSE, *DEPENDS])
def test_printing_reads_back(text):
    node = parse(text)
    assert parse(to_text(node)) == node
    assert to_unicode(node)
    assert to_latex(node)


def test_printing_random_statements_reads_back():
    for text in plain_statements(7, 600):
        node = parse(text)
        assert parse(to_text(node)) == node


PRINTED = [
    ("(p*q)*r==p*(q*r)", "(p*q)*r == p*(q*r)", "(p·q)·r = p·(q·r)"),
    ("p*q*r==r", "p*q*r == r", "p·q·r = r"),
    ("p-(q-r)!=0", "p - (q - r) != 0", "p − (q − r) ≠ 0"),
    ("-p**2==(-p)**2", "-p**2 == (-p)**2", "−p² = (−p)²"),
    ("p*(-q)==-(p*q)", "p*(-q) == -(p*q)", "p·(−q) = −(p·q)"),
    ("q**-1==inv(q)", "q**-1 == inv(q)", "q⁻¹ = q⁻¹"),
    ("conj(q)[1]+q[0]==s", "conj(q)[1] + q[0] == s", "q̄₁ + q₀ = s"),
    (
        "(p==0=>q==0)=>not(p==q and q==r)or r==0",
        "(p == 0 => q == 0) => not (p == q and q == r) or r == 0",
        "(p = 0 ⇒ q = 0) ⇒ ¬(p = q ∧ q = r) ∨ r = 0",
    ),
    ("exists q,s:s*q==1", "exists q, s: s*q == 1", "∃ q, s: s·q = 1"),
    ("comm(p,q)==0", "comm(p, q) == 0", "[p, q] = 0"),
    ("0.5*q==.125", "0.5*q == 0.125", "0.5·q = 0.125"),
    ("(p==0 <=> q==0)", "p == 0 <=> q == 0", "p = 0 ⇔ q = 0"),
    ("s/(t/x)==(s/t)/x", "s/(t/x) == s/t/x", "s/(t/x) = s/t/x"),
]


@subcases(("text", "plain", "unicode"), PRINTED)
def test_styles(text, plain, unicode):
    node = parse(text)
    assert to_text(node) == plain
    assert to_unicode(node) == unicode
    assert parse(plain) == node


def test_latex():
    assert to_latex(parse("(p*q)*r == conj(p)**2")) == r"p \cdot q \cdot r = {\overline{p}}^{2}"
    assert to_latex(parse("s/2 != norm(q)")) == r"\frac{s}{2} \neq \operatorname{N}\left(q\right)"
    assert "\\sqrt{2}" in to_latex(parse("sqrt(2)*q == 0"))


def test_what_a_statement_is_made_of():
    read = read_statement("norm(p) != 0 => s*p == q => (exists r: p*r == q)")
    assert read.sorts == {
        "p": Sort.QUATERNION,
        "s": Sort.SCALAR,
        "q": Sort.QUATERNION,
        "r": Sort.QUATERNION,
    }
    assert read.exists == ("r",)
    assert len(read.hypotheses) == 2
    assert read.compares_unequal
    assert not read.divides
    assert read_statement("q/2 == q").divides
    assert read_statement("q**-1 == q").divides
    assert str(read_statement(" p==q ")) == "p == q"


def test_generators_win_over_unknowns():
    assert read_statement("x*q == q*x").sorts["x"] is Sort.SCALAR
    over = read_statement("x*q == q*x", ring("GF(9)"))
    assert "x" not in over.sorts
    assert over.constants == ("x",)
    assert read_statement("t*q == 0", ring("GF(2)(t)")).constants == ("t",)
    assert read_statement("sqrt(2)*q == 0", ring("RR")).constants == ("sqrt(2)",)


ERRORS = [
    ("p*q", 2, "expected a statement"),
    ("p == q and r", 12, "expected a statement such as p == q, found a quaternion"),
    ("(p == q)*r == 0", 4, "expected a quaternion or a scalar, found a statement"),
    ("p/q == 1", 2, "only a scalar divides"),
    ("norm(p == q) == 0", 8, "found a statement"),
    ("foo(p) == 0", 1, "no function 'foo'"),
    ("p*m == 0", 3, "'m' means nothing here"),
    ("comm(p) == 0", 1, "comm takes 2 arguments"),
    ("norm(p, q) == 0", 1, "norm takes 1 argument"),
    ("p == 0 or (exists q: p == q)", 12, "'exists' stands at the front"),
    ("p == 0 => (exists p: p == 0)", 12, "stands for something already"),
    ("exists e: e == 0", 1, "binds an unknown"),
    ("p == q != r", 8, "does not chain"),
    ("p =< q", 3, "write == for equality"),
    ("p\u00a0== q", 2, "write an ordinary blank"),
    ("p == q\x1c", 7, "write an ordinary blank"),
    ("x*q == 0 and m == 0", 14, "name a field"),
    ("not p", 5, "found a quaternion"),
]


@subcases(("text", "position", "message"), ERRORS)
def test_errors_show_the_position(text, position, message):
    with pytest.raises(NotationError) as caught:
        read_statement(text)
    assert message in str(caught.value)
    assert caught.value.position == position - 1


def test_an_error_in_a_hypothesis_shows_the_hypothesis():
    with pytest.raises(NotationError, match="character 3 of 'p ="):
        read_statement("p == q", given=("p =q",))


@pytest.mark.parametrize(
    "text",
    ["p" + "*p" * 500 + " == 0", "(" * 300 + "p == 0", "-" * 300 + "p == 0", "", "p == 0" * 9000],
)
def test_what_is_too_deep_is_refused(text):
    with pytest.raises(HFieldError):
        read_statement(text)
