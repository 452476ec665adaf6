"""What is printed can be typed: statements and elements with mathematical signs."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield import QQ, H, QuaternionAlgebra, prove, ring
from hfield.errors import NotationError
from hfield.ledger.propositions import Assertion
from hfield.ledger.registry import claims
from hfield.prover.statements.printing import to_text, to_unicode
from hfield.syntax import parse, plain, plain_element
from tests.adversary.statement_generator import plain_statements


def without_inverses(text):
    """inv(x) is printed as x⁻¹, which reads as x**-1: the same value, another tree."""
    return "inv(" in text or "**-" in text


def statements_of_the_thesis():
    for claim in claims():
        for proposition in (claim.as_printed, claim.corrected):
            if isinstance(proposition, Assertion):
                yield proposition.statement


def test_every_statement_of_the_thesis_is_read_as_it_is_printed():
    texts = list(statements_of_the_thesis())
    assert len(texts) > 100
    for text in texts:
        tree = parse(text)
        printed = to_unicode(tree)
        if without_inverses(text):
            assert to_unicode(parse(plain(printed))).replace("(q⁻¹)", "q⁻¹") == printed
        else:
            assert parse(plain(printed)) == tree


def test_any_statement_is_read_as_it_is_printed():
    for text in plain_statements(7, 600):
        printed = to_unicode(parse(text))
        assert to_unicode(parse(plain(printed))) == printed
        typed = to_text(parse(text))
        assert plain(typed) == typed  # plain letters stay as they are


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("q̄ = q", "conj(q) == q"),
        ("ū·u ≠ 0", "conj(u)*u != 0"),
        ("N(p)\u0304 = N(p)", "conj(norm(p)) == norm(p)"),
        ("qN(p)\u0304 = tr (p+1)\u0304q", "q*conj(norm(p)) == conj(trace (p+1))*q"),
        ("p(q+r)\u0304 = 0", "p*conj(q+r) == 0"),
        ("|p|·q·|r| = |p||qr|", "abs(p)*q*abs(r) == abs(p)*abs(q*r)"),
        ("p₀ = 0 ⇒ q² = p⁻¹", "p[0] == 0 => q**2 == p**-1"),
        ("not [p,q] = 0", "not comm(p,q) == 0"),
        ("[[p,q]², r]", "comm(comm(p,q)**2, r)"),
        ("(p·q)[1] = q[2]", "(p*q)[1] == q[2]"),
        ("q⁻¹₀ = q²₃", "(q**-1)[0] == (q**2)[3]"),
        ("N(p) = tr(q)", "norm(p) == trace(q)"),
        ("p == q => p <=> q != 1", "p == q => p <=> q != 1"),
    ],
)
def test_signs(text, meant):
    assert plain(text) == meant


def test_a_verdict_does_not_hang_on_the_spelling():
    signed, typed = prove("p·q̄ = q·p̄", "QQ"), prove("p*conj(q) == q*conj(p)", "QQ")
    assert signed.to_json() == typed.to_json()
    assert signed.certificate == typed.certificate


RINGS = ["QQ", "GF(9)", "QQ(sqrt(2))", "QQ(x)", "GF(7)", "ZZ/6"]


@pytest.mark.parametrize("name", RINGS)
@settings(deadline=None, max_examples=40)
@given(st.data())
def test_elements_are_read_as_they_are_printed(name, data):
    F = ring(name)
    A = H(F)
    numbers = [F(data.draw(st.integers(-9, 9))) for _ in range(4)]
    g = [F(x) * data.draw(st.integers(0, 3)) for x in F.names().values()]
    q = A(*(x + y for x, y in zip(numbers, (g or [F(0)]) * 4, strict=False)))
    if name == "QQ":
        q = q / data.draw(st.integers(1, 9))
    assert A(q.text("unicode")) == q
    assert A(q.text()) == q


def test_fractions_and_blanks():
    A = QuaternionAlgebra(QQ, -1, -1)
    assert A("1/5 − 2/5i") == A("1/5", "-2/5", 0, 0)
    assert plain_element("2e + 3k - 2.5j") == "2*e + 3*k - 2.5*j"
    assert A("(1+i)j") == A("j + k")
    assert plain_element("x2i + 10*i") == "x2i + 10*i"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("i^2 = j^2 = k^2 = ijk = -1", "i^2 == -1 and j^2 == -1 and k^2 == -1 and i*j*k == -1"),
        ("(1+2i)(3+j) = 2pq^2", "(1+2*i)*(3+j) == 2*p*q^2"),
        ("1/2 i + 1/2j - x/2 y", "1/2*i + 1/2*j - x/2*y"),
        ("tr (p) N(pq)", "trace (p)*norm(p*q)"),
        (r"\overline{pq} = \bar q \bar{p}", "conj(p*q) == conj(q)*conj(p)"),
        (r"$\frac{1}{2} q^{-1} \neq \mathrm{tr}(q_{0})$", "((1)/(2))*q^(-1) !=trace (q[0])"),
        ("p \u2013 q", "p - q"),
        ("(0,1,-2,x+1)q = [1,0,0,0]", "(i + (-2)*j + (x+1)*k)*q == (1)"),
        ("comm(p, q) = matrix(p,q,r,u)", "comm(p, q) == matrix(p,q,r,u)"),
        ("not p = q = r => 0 <= x <= 1", "not (p == r and q == r) => 0 <= x and x <= 1"),
        ("p(0,0,0,1)", "p*(k)"),
        ("½ + ½i - ¾ p = ⅓²", "(1/2) + (1/2)*i - (3/4)*p == (1/3)**2"),
        (
            r"\frac12 i + \dfrac 1 2 p = \frac pq r",
            "((1)/(2))*i + ((1)/(2))*p == ((p)/(q))*r",
        ),
        (r"\frac{\sqrt3}2j - p^2\frac12", "((sqrt(3))/(2))*j - p^2*((1)/(2))"),
        (r"\sqrt{\frac12} \sqrt 2i", "sqrt(((1)/(2)))*sqrt(2)*i"),
        ("i|p|q = 2|p|", "i*abs(p)*q == 2*abs(p)"),
        ("(pq)\u0304 = ((p + r)\u0305 q)\u0304", "conj(p*q) == conj(conj(p + r)*q)"),
        ("p(q)\u0304²", "p*conj(q)**2"),
        ("-1/2i + p/2 i - q^-1", "-1/2*i + p/2*i - q^-1"),
        ("every one", "every one"),
        ("|pq|^2 = ‖p‖² |q|", "norm(p*q) == norm(p)*abs(q)"),
        ("Re(p) √2 = nrd(q)", "scalar(p)*sqrt(2) == norm(q)"),
        ("N(p+q) + N(p-q) = 2N(p) + 2N(q)", "norm(p+q) + norm(p-q) == 2*norm(p) + 2*norm(q)"),
        ("pN(q)^2N(p) = 3tr(p)q", "p*norm(q)^2*norm(p) == 3*trace(p)*q"),
        ("p₀q₁ - 2q[1] p[0]q", "p[0]*q[1] - 2*q[1]*p[0]*q"),
        (
            r"q\bar q = q\overline{q} = \lvert q\rvert^2",
            "q*conj(q) == norm(q) and q*conj(q) == norm(q)",
        ),
        ("qq\u0304 = p²r\u0304i", "q*conj(q) == p**2*conj(r)*i"),
        ("pq²₀ - 2\u016b = x1\u0304", "p*(q**2)[0] - 2*conj(u) == conj(x1)"),
        (r"x\sqrt{2} = \|p\|", "x*sqrt(2) == abs(p)"),
    ],
)
def test_what_is_left_out_is_written(text, meant):
    assert plain(text) == meant
    assert plain(meant) == meant


@pytest.mark.parametrize(
    ("text", "position", "reason"),
    [
        ("1/2(1+i)", 3, "two readings"),
        ("p = 1/pq", 6, "two readings"),
        ("p = x/2y", 7, "two readings"),
        ("p = (0,q,0,0)", 7, "q is a quaternion"),
        ("q\u0304 = p² + %", 10, "no remainder"),
        ("ij = (p", 7, "to close a parenthesis"),
        ("i² = p¹ and pq = foo", 17, "means nothing"),
        ("(1,2) = p", 2, "four coordinates"),
        ("p = q != r", 6, "!= does not chain"),
        ("1/-2x = y", 4, "two readings"),
        ("1/-pq = r", 3, "two readings"),
        ("2²3 = 12", 2, "did not expect '3'"),
        ("|p|^2^3 = 1", 5, "powers do not chain"),
        ("p^2/2i = q", 5, "write (p^2/2)*i or p^2/(2*i)"),
        ("x/2i = q", 3, "write (x/2)*i or x/(2*i)"),
        ("q + p²/2i", 8, "write (p²/2)*i or p²/(2*i)"),
        ("3*1/2i = q", 5, "write (3*1/2)*i or 3*1/(2*i)"),
        ("1/2ij = q", 3, "write (1/2)*ij or 1/(2*ij)"),
        ("1/--pq = r", 4, "write (1/--p)*q or 1/(--p*q)"),
        ("3½i = p", None, "write 3 + 1/2 or 3*1/2"),
        ("1 ½ = p", None, "write 1 + 1/2 or 1*1/2"),
        ("p½ = q", None, "write p*1/2"),
        ("|p|q|r| = 1", None, "write abs(p)*(q)*abs(r) or abs(p*abs(q)*r)"),
        ("x = |p|q + 1|r|", None, "has two readings"),
        (r"2\frac12 = p", None, r"write 2 + \frac12 or 2*\frac12"),
        (r"\frac123 = p", 7, "did not expect '3'"),
        (r"\sqrt[3]{2} = p", None, "only square roots"),
    ],
)
def test_errors_are_reported_at_what_was_typed(text, position, reason):
    with pytest.raises(NotationError, match=re.escape(reason)) as caught:
        prove(text)
    assert caught.value.position == position
    assert caught.value.text == text


def test_errors_of_hypotheses_are_reported_at_what_was_typed():
    with pytest.raises(NotationError) as caught:
        prove("ij = foo", given=["pq = qp"])
    assert caught.value.text == "(pq = qp) => (ij = foo)"
    assert caught.value.text[caught.value.position :].startswith("foo")


def test_a_name_of_the_field_is_no_product_and_the_answer_says_so():
    answer = prove("pq*i = i*pq", "QQ(pq)")
    assert answer.verdict == "proved"
    assert "pq is one name here, not the product p*q" in answer.decision.steps
    with pytest.raises(NotationError, match="two readings, since pq is a name"):
        prove("pqr = 0", "QQ(pq)")


@pytest.mark.parametrize("text", ["p × q = -q×p", r"p\times q = -q \times p"])
def test_a_product_that_may_be_meant_as_a_cross_product_is_pointed_out(text):
    answer = prove(text, "QQ")
    assert answer.verdict == "refuted"
    assert any("cross(p, q)" in step for step in answer.decision.steps)
    assert not any("cross" in step for step in prove("2×p = p×2", "QQ").decision.steps)


def test_a_bar_over_several_letters_is_not_printed():
    tree = parse("conj(foo)*q == conj(q)*foo")
    assert parse(plain(to_unicode(tree))) == tree


def test_a_decimal_number_with_an_exponent_is_pointed_out():
    answer = prove("2e+1 = 3", "QQ")
    assert answer.verdict == "refuted"
    assert "2e+1 is a decimal number, not a product with the unit e" in answer.decision.steps
    assert prove("2e + 1 = 3", "QQ").verdict == "proved"


def test_elements_are_read_as_they_are_typed():
    A = H(QQ)
    assert A("(1+2i)(3+j)") == A("(1+2*i)*(3+j)")
    assert A("ij") == A.k
    assert A("(0,1,0,0)") == A("[0,1,0,0]") == A.i
    assert H(ring("QQ(x)"))("2x(1+i)j") == H(ring("QQ(x)"))("2*x*j + 2*x*k")
    with pytest.raises(NotationError, match="means nothing") as caught:
        A("(1+i)(1+2q)")
    assert caught.value.position == 9


@pytest.mark.parametrize("text", ["p = q", "p % q"])
def test_the_language_itself_says_what_to_write(text):
    with pytest.raises(NotationError, match=r"write == for equality|there is no"):
        parse(text)
