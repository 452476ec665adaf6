"""Certificates over K(x), K[x], several variables and quotients R[x]/(f), accepted and forged."""

from itertools import product
from random import Random
from typing import Any

import pytest

from hfield import Rejected, check, prove, ring
from hfield.checker.scalars.fields import read_ring
from tests.subcases import pairs_quick, share_quick
from tests.thorough import quick_part

RINGS = [
    *(
        "QQ(sqrt(2))(x)",
        "QQ(sqrt(2))[x]",
        "QQ(I)(x,y)",
        "QQ[s]/(s^3-2)(x)",
        "QQ(sqrt(2),sqrt(3))(x)",
    ),
    *(
        "QQ(sqrt(2))(cos(t),sin(t))",
        "QQ(x,y)",
        "GF(3)(x,y)",
        "QQ[x]/(x^2)",
        "ZZ[I]",
        "ZZ[x]/(x^2-x)",
    ),
    *("GF(5)[x]/(x^2)", "QQ[x]/(x^3-1/2*x)", "GF(2)[x]/(x^2+x+1)"),
]


@pytest.mark.parametrize("name", share_quick(RINGS, 2))
def test_the_checker_writes_the_name_and_computes_alike(name: str) -> None:
    here = ring(name)
    there = read_ring(here.data)
    assert there.name == here.name
    rng = Random(name)
    for _ in quick_part(range(6), 2):
        x, y = here.random(rng), here.random(rng)
        if "y)" in name:  # long fractions in two variables are refused: their divisors grow
            x, y = (here(f"{rng.randint(1, 9)}*x/(y + {rng.randint(1, 9)})") for _ in "xy")
        for found, mine in ((x * y, there.mul), (x + y, there.add)):
            other = mine(there.read(here.text(x)), there.read(here.text(y)))
            assert there.equal(other, there.read(here.text(found)))
        assert here.is_unit(x) == (there.inverse(there.read(here.text(x))) is not None)


@pytest.mark.parametrize(
    ("name", "statement"),
    pairs_quick(RINGS, ["norm(p*q) == norm(p)*norm(q)", "2*p*q == 3*q*p"], 2),
)
def test_certificates_are_accepted_and_none_for_the_opposite(name: str, statement: str) -> None:
    answer = prove(statement, name)
    good: Any = answer.certificate
    assert good is not None, answer.why_no_certificate
    assert check(good).verdict == answer.verdict
    other = {"proved": "refuted", "refuted": "proved"}[answer.verdict]
    with pytest.raises(Rejected):
        check(good | {"verdict": other})


@pytest.mark.parametrize(
    ("statement", "name", "verdict"),
    [
        ("p*q == 0 => p == 0 or q == 0", "QQ(sqrt(2))(x)", "proved"),
        ("p*q == 0 => p == 0 or q == 0", "QQ(I)(x)", "refuted"),
        ("exists q: q*q == 2", "QQ(sqrt(2))(x)", "proved"),
        ("(x*i)*(x*i) == 0", "QQ[x]/(x^2)", "proved"),
        ("x*q == 0 => q == 0", "QQ[x]/(x^2)", "refuted"),
        ("x*q == 0 => q == 0", "QQ(sqrt(2))[x]", "proved"),
        ("norm(q) == 0 => q == 0", "ZZ[I]", "refuted"),
    ],
)
def test_statements(statement: str, name: str, verdict: str) -> None:
    answer = prove(statement, name)
    assert answer.verdict == verdict
    assert check(answer.certificate).verdict == verdict


@pytest.mark.parametrize(("p", "modulus"), [(2, (0, 0)), (3, (2, 0)), (3, (1, 1))])
def test_units_of_small_quotients_are_those_with_an_inverse(
    p: int, modulus: tuple[int, int]
) -> None:
    base = {"kind": "finite field", "characteristic": p, "degree": 1, "modulus": None}
    texts = [*map(str, modulus), "1"]
    data = {"kind": "quotient ring", "base": base, "modulus": texts, "variable": "x"}
    R = read_ring(data)
    elements = list(R.elements())
    assert len(elements) == R.order == p * p
    products = {pair: R.mul(*pair) for pair in product(elements, repeat=2)}
    for x in elements:
        inverse = next((y for y in elements if products[x, y] == R.one), None)
        assert R.inverse(x) == inverse


@pytest.mark.parametrize(
    "change",
    [
        {"modulus": ["0", "0"]},
        {"modulus": ["0", "0", "2"]},
        {"modulus": ["2/4", "0", "1"]},
        {"modulus": [0, 0, 1]},
        {"variable": "i"},
        {"variable": "I"},
        {"base": {"kind": "reals"}},
        {"base": {"kind": "quadratic field", "d": 2}},
        {"more": 1},
    ],
)
def test_data_of_no_quotient(change: dict[str, object]) -> None:
    good = ring("QQ[x]/(x^2)").data
    assert good is not None
    with pytest.raises(Rejected):
        read_ring(good | change)
