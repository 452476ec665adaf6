"""Which places show that a norm form is 0 only at 0: the checker against Hilbert's symbol, by Serre's formula.

(a, b)_p is −1 exactly when the norm form of (a, b) over ℚ_p is 0 only at 0 (Serre, *A Course in
Arithmetic*, III.1.2, theorem 1).
"""

import random
from fractions import Fraction
from typing import Any

import pytest

from hfield.certificates.check import check
from hfield.certificates.rejection import Rejected

PRIMES = (2, 3, 5, 7, 11, 13, 97, 1_000_003)


def order_and_unit(x: Fraction, p: int) -> tuple[int, int]:
    """Return n and an integer u with x = pⁿ·u up to squares of units."""
    u, n = x.numerator * x.denominator, 0
    while u % p == 0:
        u, n = u // p, n + 1
    return n, u


def hilbert(a: Fraction, b: Fraction, p: int) -> int:
    """Return Hilbert's symbol."""
    (m, u), (n, v) = order_and_unit(a, p), order_and_unit(b, p)
    if p == 2:
        e = ((u - 1) // 2) * ((v - 1) // 2) + m * ((v * v - 1) // 8) + n * ((u * u - 1) // 8)
        return (-1) ** (e % 2)
    legendre = lambda x: 1 if pow(x, (p - 1) // 2, p) == 1 else -1  # noqa: E731
    return (-1) ** (m * n * (p - 1) // 2) * legendre(u) ** n * legendre(v) ** m


def certificate(algebra: str, field: str, a: str, b: str, fact: Any) -> dict[str, Any]:
    """Return a proof that the norm of the algebra is 0 only at 0, which rests on the fact."""
    norm = f"q[0]**2 - {a}*q[1]**2 - {b}*q[2]**2 + {a}*{b}*q[3]**2"
    norm = norm.replace("- -", "+ ").replace("+ -", "- ").replace("*-", "*")
    steps = lambda n: [  # noqa: E731
        {"step": "norm", "cofactors": ["1", "0"], "denominator": 1, "terms": [f"q[{m}]" for m in range(4)]},
        {"step": "contradiction", "denominator": 1,
         "cofactors": ["0", "1", *("T1" if m == n else "0" for m in range(4))]},
    ]  # fmt: skip
    items = [
        {
            "characteristic": 0,
            "zero": [norm],
            "relations": [],
            "nonzero": [f"q[{n}]"],
            "steps": steps(n),
        }
        for n in range(4)
    ]
    return {
        "schema": "hfield-cert/1",
        "statement": "norm(q) == 0 => q == 0",
        "algebra": algebra,
        "field": field,
        "verdict": "proved",
        "method": "implication",
        "assumes": [],
        "evidence": {"kind": "implication", "facts": [fact], "items": items},
    }


def accepted(data: dict[str, Any]) -> bool:
    """Tell whether the checker accepts."""
    try:
        return not check(data).assumes
    except Rejected:
        return False


def integers(rng: random.Random) -> tuple[int, int]:
    a, b = (rng.choice((1, -1)) * rng.choice((1, 2, 3, 5, 6, 7, 10, 14, 15, 21, 97)) for _ in "ab")
    p = rng.choice(PRIMES)
    return a * rng.choice((1, 1, p, p * p, 4)), b * rng.choice((1, 1, 1, p, 9))


def text_norm(a: int, b: int, value: dict[str, Any]) -> None:
    """Write the coefficients of the norm as plain integers."""
    signs = lambda c, q: f"{'-' if c < 0 else '+'} {abs(c)}*{q}**2"  # noqa: E731
    norm = " ".join(["q[0]**2", signs(-a, "q[1]"), signs(-b, "q[2]"), signs(a * b, "q[3]")])
    for item in value["evidence"]["items"]:
        item["zero"] = [norm]


def test_a_place_of_q_is_taken_exactly_where_the_symbol_is_minus_one() -> None:
    rng = random.Random(0)
    found = {1: 0, -1: 0}
    for _ in range(250):
        a, b = integers(rng)
        p = rng.choice([*PRIMES[:3], *(q for q in PRIMES if a * b % q == 0)])
        data = certificate(
            f"({a},{b}|QQ)",
            "QQ",
            "0",
            "0",
            {"form": "norm", "by": "ramified places", "places": [str(p)]},
        )
        text_norm(a, b, data)
        symbol = hilbert(Fraction(a), Fraction(b), p)
        found[symbol] += 1
        assert accepted(data) == (symbol == -1), (a, b, p)
    assert min(found.values()) > 40


def test_the_symbols_multiply_to_one() -> None:
    rng = random.Random(1)
    for _ in range(300):
        a, b = integers(rng)
        primes = [
            p for p in range(2, 100) if all(p % q for q in range(2, p)) and 2 * a * b % p == 0
        ]
        primes += [p for p in (1_000_003,) if a * b % p == 0]
        total = -1 if a < 0 and b < 0 else 1
        for p in primes:
            total *= hilbert(Fraction(a), Fraction(b), p)
        assert total == 1, (a, b)


@pytest.mark.parametrize(
    "place", ["4", "1", "0", "-3", "9", "15", "561", "٣", " 3", "3 ", "+3", "03", "inf", "x", ""]
)
def test_what_is_no_place_of_q(place: str) -> None:
    data = certificate(
        "(3,-1|QQ)", "QQ", "3", "-1", {"form": "norm", "by": "ramified places", "places": [place]}
    )
    text_norm(3, -1, data)
    assert hilbert(Fraction(3), Fraction(-1), 3) == -1
    if place.strip() not in ("3", "03"):
        assert not accepted(data)
    data["evidence"]["facts"][0]["places"] = ["3"]
    assert accepted(data)


def test_an_ordering_is_taken_where_both_constants_are_negative() -> None:
    for a, b in ((-1, -1), (-2, -3), (-1, 1), (1, -1), (2, 3), (-5, 7)):
        data = certificate(f"({a},{b}|RR)", "RR", "0", "0", {"form": "norm", "by": "ordering"})
        text_norm(a, b, data)
        assert accepted(data) == (a < 0 and b < 0)
