"""Why a norm form is 0 only at 0: the checker against Hilbert's symbol and algebras that split.

(a, b)_p is −1 exactly when the norm form of (a, b) over ℚ_p is 0 only at 0 (Serre, *A Course in
Arithmetic*, III.1.2, theorem 1). And an algebra whose b is a norm w² + t·wx − a·x² splits over any field: no
reason may be taken there.
"""

import random
from fractions import Fraction
from itertools import product
from typing import Any

import pytest

from hfield.checker.anisotropy import is_certified as certifies
from tests.checker.ring_data import (
    INFINITY,
    Data,
    data_of,
    ideal,
    number,
    prime,
    real,
    split,
)
from tests.subcases import subcases

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
    signs = [1 if pow(x, (p - 1) // 2, p) == 1 else -1 for x in (u, v)]
    return int((-1) ** (m * n * (p - 1) // 2) * signs[0] ** n * signs[1] ** m)


def integers(rng: random.Random) -> tuple[int, int, int]:
    """Return a, b and one of their primes."""
    a, b = (rng.choice((1, -1)) * rng.choice((1, 2, 3, 5, 6, 7, 10, 14, 15, 21, 97)) for _ in "ab")
    p = rng.choice(PRIMES)
    a, b = a * rng.choice((1, 1, p, p * p, 4)), b * rng.choice((1, 1, 1, p, 9))
    return a, b, rng.choice([2, p, *(q for q in PRIMES if a * b % q == 0)])


def diagonal(a: int, b: int, p: int) -> tuple[list[str], list[str]]:
    """Return multiples u, j of i, j, k: p divides the norm of the first not at all, of the other once."""
    rows = []
    for n, norm in enumerate((-a, -b, a * b), 1):
        order, _ = order_and_unit(Fraction(norm), p)
        scale = Fraction(1, p ** (order // 2))
        rows.append((order % 2, [str(scale) if m == n else "0" for m in range(4)]))
    rows.sort(key=lambda x: x[0])
    return rows[0][1], rows[-1][1]


def is_certified(algebra: str, field: str, reason: Any) -> bool:
    return certifies(algebra, data_of(field), reason)


def at(place: Any, u: list[str], j: list[str]) -> dict[str, Any]:
    """Return a reason by a place, or at a number."""
    return {
        "by": "place",
        "place": number(place) if isinstance(place, int) else place,
        "u": u,
        "j": j,
    }


def test_an_odd_prime_is_taken_exactly_where_the_symbol_is_minus_one() -> None:
    rng, found = random.Random(0), {1: 0, -1: 0}
    for _ in range(400):
        a, b, p = integers(rng)
        if p == 2:
            continue
        symbol = hilbert(Fraction(a), Fraction(b), p)
        found[symbol] += 1
        data = at(p, *diagonal(a, b, p))
        assert is_certified(f"({a},{b}|QQ)", "QQ", data) == (symbol == -1), (a, b, p)
    assert min(found.values()) > 40


@pytest.mark.slow
def test_nothing_is_taken_where_all_symbols_are_one() -> None:
    """At primes, and at odd numbers that are none: then one of their primes has to have the symbol −1."""
    rng, taken, composite = random.Random(2), 0, 0
    for _ in range(4_000):
        a, b, p = integers(rng)
        n = rng.choice((2, 2, p, 15, 21, 35, 45, 105, 9, 27, 3**3 * 5, 77, 11 * 13))
        entries = ("0", "0", "1", "-1", "1/2", "-1/2", f"1/{p}", "2", "3/2", str(n), "3", "5")
        u, j = ([rng.choice(entries) for _ in range(4)] for _ in "uj")
        if rng.random() < 0.6:
            u = rng.choice((["1/2"] * 4, ["0", "1", "0", "0"], ["1/2", "1/2", "0", "0"], u))
            j = rng.choice((["1", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"], j))
        if rng.random() < 0.3:
            a, b = -1, rng.choice((-1, -1, -5, 3, n, -n))
        if is_certified(f"({a},{b}|QQ)", "QQ", at(n, u, j)):
            taken, composite = taken + 1, composite + (n not in PRIMES)
            primes = [q for q in (*range(2, 200), *PRIMES) if n % q == 0]
            primes = [q for q in primes if all(q % r for r in range(2, min(q, 200)))]
            symbols = [hilbert(Fraction(a), Fraction(b), q) for q in primes]
            assert -1 in symbols, (a, b, n, u, j)
    assert taken > 60
    assert composite > 10


def test_the_symbols_multiply_to_one() -> None:
    rng = random.Random(1)
    for _ in range(300):
        a, b, _ = integers(rng)
        primes = [
            p for p in range(2, 100) if all(p % q for q in range(2, p)) and 2 * a * b % p == 0
        ]
        primes += [p for p in (1_000_003,) if a * b % p == 0]
        total = -1 if a < 0 and b < 0 else 1
        for p in primes:
            total *= hilbert(Fraction(a), Fraction(b), p)
        assert total == 1, (a, b)


T = prime(0, 1)
FIELDS: dict[str, tuple[tuple[str, ...], tuple[int | Data, ...]]] = {
    # the entries of quaternions, and the places
    "QQ": (("1", "2", "1/2", "-3"), (2, 3, 5, 7, 15, 21, 9, 35)),
    "QQ(sqrt(2))": (
        ("1", "sqrt(2)", "1/2", "1+sqrt(2)"),
        (2, 3, split(7, 3), 7, 15, 21),
    ),
    "QQ(I)": (("1", "I", "1/2", "1+I"), (2, 3, split(5, 2), 5, split(65, 8), 15)),
    "QQ(sqrt(-7))": (
        ("1", "sqrt(-7)", "1/2", "1/2+sqrt(-7)/2"),
        (split(2, 1), 3, 7, 15),
    ),
    "QQ(sqrt(15))": (
        ("1", "sqrt(15)", "1/3", "1+sqrt(15)"),
        (3, 5, 15, 2, 7, split(7, 1)),
    ),
    "QQ(x)": (("1", "x", "1/x", "x+1"), ()),
    "GF(2)(t)": (("1", "t", "1/t", "t+1"), (T, prime(1, 1), prime(1, 1, 1), INFINITY)),
    "GF(3)(t)": (("1", "t", "1/t", "t+1"), (T, prime(1, 1), prime(1, 0, 1), INFINITY)),
    "GF(5)(t)": (("1", "t", "1/t", "2*t+1"), (T, prime(1, 1), prime(2, 0, 1), INFINITY)),
    "RR": (("1", "-2", "sqrt(2)"), ()),
    "GF(7)": (("1", "3", "-1"), ()),
    "CC": (("1", "I", "2"), ()),
}


def reasons(field: str, rng: random.Random) -> dict[str, Any]:
    """Return some reason or other."""
    entries, places = FIELDS[field]
    kind = rng.random()
    if kind < 0.15 or not places:
        inner = at(
            rng.choice((2, 3, 15)),
            _quaternion(("1", "1/2"), rng),
            _quaternion(("1", "2"), rng),
        )
        return rng.choice((
            {"by": "ordering"},
            {"by": "level"},
            {"by": "specialisation", "at": rng.choice(("0", "1", "-1", "2", "1/2", "x")),
             "proof": rng.choice((inner, {"by": "ordering"}, {"by": "level"}))},
        ))  # fmt: skip
    return at(rng.choice(places), _quaternion(entries, rng), _quaternion(entries, rng))


def _quaternion(entries: tuple[str, ...], rng: random.Random) -> list[str]:
    if rng.random() < 0.5:
        n = rng.randrange(4)
        return [rng.choice(entries) if m == n else "0" for m in range(4)]
    return [rng.choice((*entries, "0", "0")) for _ in range(4)]


@pytest.mark.slow
@subcases("field", FIELDS)
def test_no_reason_is_taken_for_an_algebra_that_splits(field: str) -> None:
    rng = random.Random(field)
    entries = FIELDS[field][0]
    for _ in range(150):
        w, x, a = (rng.choice(entries) for _ in range(3))
        a = rng.choice((a, f"-({a})", f"({a})*({rng.choice(entries)})"))
        t = rng.choice((0, 0, 1))
        b = f"({w})**2 + {t}*({w})*({x}) - ({a})*({x})**2"
        text = f"[{a},{b}|{field})" if t else f"({a},{b}|{field})"
        data = reasons(field, rng)
        assert not is_certified(text, field, data), (text, data)


def test_each_kind_of_reason_is_taken_somewhere() -> None:
    found = {
        (by, field)
        for field, by, algebra in (
            ("QQ", "ordering", "(-1,-1|QQ)"),
            ("RR", "ordering", "(-2,-1|RR)"),
            ("QQ(sqrt(2))", "ordering", "(-1,sqrt(2)-2|QQ(sqrt(2)))"),
            ("QQ(sqrt(-7))", "level", "(-1,-1|QQ(sqrt(-7)))"),
            ("QQ(x)", "ordering", "(-x**2,-1|QQ(x))"),
        )
        if is_certified(algebra, field, {"by": by})
    }
    assert len(found) == 5
    for a, b in product((-2, -1, 1, 3), repeat=2):
        assert is_certified(f"({a},{b}|RR)", "RR", {"by": "ordering"}) == (a < 0 and b < 0)
    data = at(T, ["0", "1", "0", "0"], ["0", "0", "1", "0"])
    assert is_certified("(2,t|GF(3)(t))", "GF(3)(t)", data)
    assert is_certified("[1,t|GF(2)(t))", "GF(2)(t)", data)
    special = {"by": "specialisation", "at": "1", "proof": {"by": "ordering"}}
    assert is_certified("(-x,-1|QQ(x))", "QQ(x)", special)
    assert not is_certified("(-x,-1|QQ(x))", "QQ(x)", {**special, "at": "-1"})


@subcases(
    "place",
    [
        *map(number, (4, 1, 0, -3, 9, 6, 12, 2, "3", "٣", 3.0, True, None, [3])),
        *(
            INFINITY,
            T,
            split(3, 1),
            ideal(3),
            real(0),
            {**number(3), "p": 3},
            {"n": 3},
            "3",
            None,
            {},
        ),
    ],
)
def test_what_is_no_place_of_q(place: Any) -> None:
    data = at(place, *diagonal(3, -1, 3))
    assert not is_certified("(3,-1|QQ)", "QQ", data)
    assert is_certified("(3,-1|QQ)", "QQ", {**data, "place": number(3)})


@subcases(
    ("field", "place"),
    [
        ("QQ(sqrt(-7))", number(2)),  # splits
        ("QQ(sqrt(2))", split(7, 1)),
        ("QQ(sqrt(2))", split(7, 10)),
        ("QQ(sqrt(-7))", split(2, 2)),
        ("GF(3)(t)", prime(2, 0, 1)),
        ("GF(3)(t)", prime(0, 2)),
        ("GF(3)(t)", number(2)),
        ("GF(3)(t)", prime(1)),
        ("GF(2)(t)", prime(1, 0, 1)),
        ("GF(2)(t)", prime([0], [1])),
    ],
)
def test_what_is_no_place_of_other_fields(field: str, place: Data) -> None:
    rng = random.Random(str(place))
    entries = FIELDS[field][0]
    for _ in range(120):
        a, b = rng.choice(entries), rng.choice(entries)
        data = at(place, _quaternion(entries, rng), _quaternion(entries, rng))
        assert not is_certified(f"({a},-({b})|{field})", field, data)
