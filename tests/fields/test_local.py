"""Elements of local fields: texts, and O() that always contains the exact result."""

from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from hfield.errors import CoercionError, HFieldError, UndecidedError
from hfield.fields.names import ring
from tests.subcases import share_quick, subcases

FIELDS = (
    "Qp(2)", "Qp(5)", "QQ(I)_(5, I-2)", "QQ(sqrt(2))_(2)", "QQ(sqrt(-3))_(2)", "QQ(sqrt(-3))_(3)",
    "QQ(sqrt(17))_(2, sqrt(17)-3)", "GF(2)((t))", "GF(9)((t))", "GF(3)(t)_(t^2+1)", "GF(5)(t)_inf",
)  # fmt: skip


def contains(ball, x):
    """Whether an exact element is in a ball: equal to it, or different by a multiple of πⁿ."""
    rest = ball.field(x.value) - ball.field(ball.value)
    if not rest.has_value:
        return True
    return ball.precision is not None and rest.valuation() >= ball.precision


@pytest.mark.parametrize("name", share_quick(FIELDS, 4))
@settings(max_examples=25, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(seed=st.integers(0, 2**20), m=st.integers(-2, 8), n=st.integers(-2, 8))
def test_a_result_with_o_contains_the_results_of_all_candidates(name, seed, m, n):
    F, rng = ring(name), Random(seed)
    x, y = (F.random(rng) * F.uniformiser ** rng.randint(-1, 2) for _ in range(2))
    balls = F.up_to(x, m), F.up_to(y, n)
    pi = F.uniformiser
    for _ in range(3):
        # others in the same balls: x + πᵐ·(an integral element)
        errors = [
            F(F.residues.lift(F.residues.one)) * rng.randint(0, 9) * pi ** (k + rng.randint(0, 2))
            for k in (m, n)
        ]
        u, v = x + errors[0], y + errors[1]
        assert contains(balls[0], u)
        assert contains(balls[1], v)
        for f in (
            lambda a, b: a + b,
            lambda a, b: a - b,
            lambda a, b: a * b,
            lambda a, b: a * a - 3 * b,
            lambda a, b: a**3 + b * a,
            lambda a, b: a + a,
        ):
            assert contains(f(*balls), f(u, v))
        if balls[1].has_value:
            assert contains(balls[0] / balls[1], u / v)
            assert contains(balls[1] ** -2, v**-2)
        else:
            with pytest.raises(UndecidedError):  # it may be 0
                F.inverse(balls[1])


@pytest.mark.parametrize("name", FIELDS)
@settings(max_examples=10, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(seed=st.integers(0, 2**20), n=st.integers(-3, 9))
def test_texts_read_back_and_equal_sets_have_equal_parts(name, seed, n):
    F, rng = ring(name), Random(seed)
    x = F.random(rng)
    ball = F.up_to(x, n)
    for style in ("plain", "unicode"):
        assert F(F.text(ball, style)) == ball
    assert hash(F(F.text(ball))) == hash(ball)
    moved = F.up_to(ball.value + F.global_field.power(F.pi, n), n)
    assert moved == ball
    assert F.key(moved) == F.key(ball)
    assert F.up_to(x, n + 1) != ball or F.text(F.up_to(x, n + 1)) == F.text(ball)


@subcases("name", FIELDS)
def test_roots_are_as_near_as_they_say(name):
    F, rng = ring(name), Random(2)
    seen = 0
    for _ in range(40):
        x = F.random(rng)
        if F.is_zero(x):
            continue
        root = F.sqrt(x)
        if root is not None:
            seen += 1
            assert F.vanishes(root * root - x)
            assert root.is_exact or (root * root - x).precision >= 10
            y = (
                F.sqrt(F.up_to(x, x.valuation() + F.square_digits + 4))
                if F.characteristic != 2
                else root
            )
            assert F.vanishes(y * y - x)
        square = F.sqrt(x * x)
        assert square is not None
        assert F.vanishes(square * square - x * x)
    assert seen


def test_known_digits_are_distinguished_from_unknown_ones():
    F = ring("Qp(5)")
    x, y = F("2 + O(5^4)"), F("2 + O(5^2)")
    assert x == F("627 + O(5^4)")
    assert x != y
    assert not F.equal(x, F(3))
    assert F.equal(F(2), F("10/5"))
    with pytest.raises(UndecidedError, match=r"up to O\(5\^5\) at least"):
        F.equal(x, F(2))
    with pytest.raises(UndecidedError, match=r"up to O\(5\^3\) at least"):
        F.is_zero(F("O(5^2)"))
    with pytest.raises(CoercionError, match="0 has no valuation"):
        F(0).valuation()
    assert (x.valuation(), x.digits(), y.digits(), F("50+O(5^4)").digits()) == (0, 4, 2, 2)
    assert str(x * 5 + y) == "12+O(5^2)"
    assert len({x, F("627+O(5^4)"), y}) == 2


@pytest.mark.parametrize("name", FIELDS)
def test_equal_elements_compute_alike_whichever_object_they_are(name):
    F = ring(name)
    for text in ("1", "0", "3"):
        x, y = (F.up_to(F(text), 3) for _ in range(2))
        assert x == y
        assert x is not y
        for f in (
            lambda a, b: a + b,
            lambda a, b: a - b,
            lambda a, b: a * b,
            lambda a, b: a + b * a,
        ):
            assert f(x, x) == f(x, y) == f(y, x)
    assert F.up_to(F.up_to(1, 2), 5) == F.up_to(1, 2)  # digits are forgotten, never made up


def test_elements_of_different_completions_do_not_mix():
    F, L = ring("Qp(5)"), ring("Qp(7)")
    with pytest.raises(CoercionError, match=r"Qp\(5\) and Qp\(7\)"):
        F(1) + L(1)
    with pytest.raises(CoercionError, match="is not an element of"):
        F(L(1))
    assert F(1) != L(1)


@pytest.mark.parametrize("text", ["sqrt(2)", "O(x)", "2 + O(5^4", "O()", "1/(5-5)", "O"])
def test_what_cannot_be_read(text):
    with pytest.raises(HFieldError):
        ring("Qp(5)")(text)


def test_in_characteristic_2_squares_need_exact_elements():
    F = ring("GF(2)((t))")
    assert F.sqrt(F("1+t^2")) == F("1+t")
    assert F.sqrt(F("1+t")) is None
    assert F.sqrt(F("1+t+O(t^5)")) is None
    with pytest.raises(UndecidedError, match="exactly"):
        F.sqrt(F("1+t^2+O(t^5)"))
