"""Numbers in nested roots that are 0 by the rules of a field: seen without digits, and no others."""

import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import I, Rational, cos, pi, root, sqrt

from hfield import H
from hfield.errors import HFieldError
from hfield.fields import CC, RR
from hfield.fields.algebraic import closed_forms as closed
from hfield.fields.algebraic.identities import vanishes_identically
from tests.steps import steps
from tests.subcases import subcases

# an identity whose degree and height asked for more digits than are computed
LONG = ["4+root(4,3)", "root(7,25)", "sqrt(5-root(5,3))+sqrt(6+root(3,3))", "11"]
# asked whether a product of theirs is finite, sympy answered after a minute
MIXED = ["1/(sqrt(2+I)/(7+I)+7)", "-1", "root(1/9,3)", "4*I*root(2,3)"]


def test_inverses_need_no_digits() -> None:
    A = H(RR)
    q = A(*map(RR, LONG))
    p = q.inverse()

    def work() -> None:
        assert p * q == 1
        assert q * p == 1
        assert p * q != 2

    assert steps(work) < 1_000_000


def test_inverses_of_long_numbers() -> None:
    A = H(CC)
    q = A(*map(CC, MIXED)) * A(1, 2, 0, 1)
    assert steps(q.inverse) < 1_000_000


X = sqrt(5 + root(5, 3))
FORMS = [
    (X**2 - 5 - root(5, 3), True),
    (X**2 - 5 - root(3, 3), False),
    (1 / (X + 1) - (X - 1) / (4 + root(5, 3)), True),
    (1 / X + 1 / (X + 1) - (2 * X + 1) / (X**2 + X), True),
    (sympy.Pow(6, Rational(1, 3), evaluate=False) - root(2, 3) * root(3, 3), True),
    (sqrt(Rational(2, 3)) - sqrt(6) / 3, True),
    (root(-1, 3) ** 2 - root(-1, 3) + 1, True),
    (root(-1, 6) ** 3 - I, True),
    (sympy.Pow(-2, Rational(1, 3), evaluate=False) - root(-1, 3) * root(2, 3), True),
    (sqrt(1 + 1 / (1 + X)) ** 2 * (1 + X) - 2 - X, True),
    (cos(1) ** 2 / (1 + cos(1)) - cos(1) + cos(1) / (1 + cos(1)), True),
    (sqrt(pi) ** 3 / pi - sqrt(pi), True),
    (sqrt(5 + 2 * sqrt(6)) - sqrt(2) - sqrt(3), False),  # 0, but not by these rules
    (sqrt((X - 3) ** 2) - (X - 3), False),  # X < 3
    (sqrt(2 + I) * sqrt(2 - I) - sqrt(5), False),
    (sum((sqrt(2 + root(n, 3)) for n in range(2, 40)), sympy.S.Zero) ** 4 - 1, False),  # too long
]


@subcases(("expr", "seen"), FORMS)
def test_what_is_seen(expr, seen) -> None:
    assert vanishes_identically(expr) is seen


def numbers(leaf):
    """Expressions of nested roots as texts."""
    return st.recursive(
        leaf,
        lambda x: st.one_of(
            st.builds("sqrt({})".format, x),
            st.builds("root({},{})".format, x, st.integers(3, 5)),
            st.builds("({}+{})".format, x, x),
            st.builds("({}*{})".format, x, x),
            st.builds("1/({}+7)".format, x),
        ),
        max_leaves=5,
    )


@settings(max_examples=60, deadline=None)
@given(*[numbers(st.sampled_from(["2", "3", "5", "-3", "I", "1/2", "sqrt(2)"]))] * 2)
def test_seen_identities_are_true_and_those_of_fields_are_seen(first, second) -> None:
    try:
        x, y = CC(first), CC(second)
        if CC.is_zero(x) or CC.is_zero(y):
            return
        a, b = closed.to_sympy(x), closed.to_sympy(y)
    except HFieldError:
        return
    assert vanishes_identically((a + b) / (a * b) - 1 / a - 1 / b)
    if vanishes_identically(a - b):
        assert (x - y if x is not y else CC.zero).ball(300).abs_upper() < 1e-80
    assert CC.is_zero((x + y) * (x - y) - (x * x - y * y))


@settings(max_examples=60, deadline=None)
@given(numbers(st.sampled_from(["2", "-2", "-3", "1-sqrt(2)", "2-sqrt(5)", "-pi"])))
def test_a_text_means_one_number(text) -> None:
    """What RR reads is the same in CC, and so is what either prints."""
    try:
        x = RR(text)
    except HFieldError:
        return
    z = CC(text)
    assert x.ball(60).overlaps(z.ball(60))
    for shown in (RR.text(x), CC.text(z)):
        assert RR(shown).ball(60).overlaps(CC(shown).ball(60))
        assert RR(shown).ball(60).overlaps(x.ball(60))


def test_roots_of_negative_numbers() -> None:
    assert RR("root(2-sqrt(5),3)") == CC("root(2-sqrt(5),3)") == RR("(1-sqrt(5))/2")
    assert RR("cbrt(-8)") == CC("cbrt(-8)") == -2
    principal = CC("2*exp(I*pi/3)")
    assert principal**3 == -8
    assert CC(CC.text(principal)) == principal != CC("root(-8,3)")
    assert CC("root(-4,4)") == CC("1+I")
