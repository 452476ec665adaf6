"""Polynomials of the checker: monomials never collide, all of a text is read, every bound is checked."""

import random

import pytest

from hfield.checker.budget import bounded
from hfield.checker.polynomials import (
    MAX_DIRECT_TERMS,
    MAX_EXPONENT,
    Names,
    Poly,
    add,
    constant,
    divide,
    multiply,
    power,
    times,
    variable,
)
from hfield.checker.rejection import Rejected
from tests.subcases import subcases

NAMES = Names([("name", "s"), ("index", ("name", "q"), 0), ("call", "sqrt", (("num", 2),))])
S, Q, ROOT = (variable(n) for n in range(3))


def read(text: str) -> Poly:
    return NAMES.read(text, "a text")


def value(f: Poly, point: list[int]) -> int:
    total = 0
    for m, c in f.items():
        for v, e in m:
            c *= point[v] ** e
        total += c
    return total


def test_terms_are_read() -> None:
    assert read("- 2*q[0]**2*s + sqrt(2) - 3*4") == {
        ((1, 2), (0, 1)): -2,
        ((2, 1),): 1,
        (): -12,
    }
    assert read("s*q[0] - q[0]*s") == {} == read("0")
    assert read("s*s*s") == power(S, 3) == read(" s**3 ")


@subcases(
    "text",
    [
        *("", " ", "+", "2 3", "s s", "s+", "+-s", "s--s", "2**2", "s**", "s**-1", "s**0", "s**s", "s^2"),
        *("(s)", "s*(s)", "2(s)", "s[0]", "q", "q[4]", "q[0", "q[0]x", "sqrt(3)", "sqrt(2", "sqrt", "t"),
        *("s*", "*s", "s**2**2", "s*+s", "1.5", "1e3", "²", "s²", "٣", "s**٣", "ｓ", "s\0", "1_0", "s;s"),
        *("s=s", "s**65537", "s**99999999", "*".join(["s**65536"] * 2), "9" * 4_001),
        "*".join(["9" * 4_000] * 5),
        " + ".join(["9" * 4_000 + "*" + "9" * 817] * 40),
    ],
)  # fmt: skip
def test_what_is_no_polynomial_is_rejected(text: str) -> None:
    with pytest.raises(Rejected):
        read(text)


def test_degrees_do_not_carry_into_other_variables() -> None:
    """The forgery of old: 256 times s**65536 was the next variable, and past the last one nothing."""
    for many in (2, 255, 256, 257, 65_536):
        with pytest.raises(Rejected, match="degree"):
            read("*".join(["s**65536"] * min(many, 400)))
    f = power(S, 1 << 10)
    for _ in range(6):
        f = multiply(f, f)
    assert f == {((0, MAX_EXPONENT),): 1}
    for g in (S, f, add(S, Q), add(f, Q), add(Q, f)):  # in front, behind, alone
        for product in ((f, g), (g, f)):
            with pytest.raises(Rejected, match="degree"):
                multiply(*product)


def test_a_large_degree_is_seen_in_every_term() -> None:
    mask = multiply(Q, ROOT)
    large = {((0, MAX_EXPONENT),): 1}
    with pytest.raises(Rejected, match="degree"):
        multiply(add(mask, large), add(mask, S))
    with pytest.raises(Rejected, match="degree"):
        times(((2, 1), (0, MAX_EXPONENT)), ((1, 1), (0, 1)))


def test_bounds_on_size() -> None:
    wide: Poly = {((n, 1),): 1 for n in range(1_001)}
    with pytest.raises(Rejected, match="more work"), bounded():
        multiply(wide, wide)
    with pytest.raises(Rejected, match="coefficient"):
        multiply(constant(1 << 9_000), constant(-1 << 9_000))
    with pytest.raises(Rejected, match="coefficient"):
        add(constant(1 << 15_999), constant(1 << 15_999))
    with pytest.raises(Rejected, match="longer"):
        read("s" + " " * 4_000_000)


def test_variables_with_one_name_are_refused() -> None:
    with pytest.raises(Rejected, match="same name"):
        Names([("name", "T1")]).extended(["T1"])


def random_polynomial(rng: random.Random) -> Poly:
    out: Poly = {}
    for _ in range(rng.randint(0, 6)):
        exponents = [(v, rng.choice([0, 0, 1, 2, 70, 255, 256])) for v in (2, 1, 0)]
        m = tuple((v, e) for v, e in exponents if e)
        out = add(out, {m: rng.choice([-1, 1]) * rng.randint(1, 2**70)})
    return out


def test_arithmetic_is_that_of_values() -> None:
    rng = random.Random(4)
    for _ in range(200):
        f, g = random_polynomial(rng), random_polynomial(rng)
        point = [rng.randint(-9, 9) for _ in range(3)]
        a, b = value(f, point), value(g, point)
        assert value(add(f, g, -3), point) == a - 3 * b
        assert value(multiply(f, g), point) == a * b
        assert add(f, f, -1) == {}
        if g:
            assert divide(multiply(f, g), g) == f
        if f:
            assert divide(add(multiply(f, f), constant(1)), f) is None or len(f) == 1


def test_division_that_leaves_a_rest() -> None:
    assert divide(S, Q) is None
    assert divide(multiply(S, S), add(S, Q)) is None
    assert divide(constant(3), constant(2)) is None
    assert divide(constant(6), constant(-2)) == constant(-3)
    assert divide({}, S) == {}


def some(rng: random.Random, terms: int, most: int) -> Poly:
    """A polynomial in twelve variables."""
    out: Poly = {}
    for _ in range(terms):
        chosen = sorted(rng.sample(range(12), rng.randint(0, 4)), reverse=True)
        out[tuple((v, rng.randint(1, most)) for v in chosen)] = rng.choice((-3, -1, 1, 10**40))
    return out


@pytest.mark.parametrize("most", [1, 3, MAX_EXPONENT // 2])
def test_long_products_are_those_of_their_terms(most: int) -> None:
    rng = random.Random(most)
    for _ in range(5):
        f, g = some(rng, 60, most), some(rng, 70, most)
        assert len(f) * len(g) > MAX_DIRECT_TERMS
        by_terms: Poly = {}
        for m, c in f.items():
            by_terms = add(by_terms, multiply({m: c}, g))
        assert multiply(f, g) == by_terms == multiply(g, f)


def test_long_products_are_bounded_as_short_ones() -> None:
    f = {((0, n),): 1 for n in range(1, MAX_DIRECT_TERMS)}
    for top in (
        MAX_EXPONENT - MAX_DIRECT_TERMS + 1,
        MAX_EXPONENT - MAX_DIRECT_TERMS + 2,
        MAX_EXPONENT,
    ):
        g = {((2, 3),): 1, ((0, top),): 1, (): 1}
        if top + MAX_DIRECT_TERMS - 1 > MAX_EXPONENT:
            with pytest.raises(Rejected, match="degree"):
                multiply(f, g)
        else:
            assert len(multiply(f, g)) == 3 * len(f)
    large = {((0, n),): 10**4_000 for n in range(MAX_DIRECT_TERMS)}
    with pytest.raises(Rejected, match="coefficient"):
        multiply(large, {((1, 1),): 10**4_000, ((1, 2),): 10**4_000, (): 10**4_000})
