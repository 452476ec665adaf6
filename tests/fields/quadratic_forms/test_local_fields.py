"""Quaternion algebras over local fields: against PARI, by exhaustion, and by what the digits say."""

from fractions import Fraction
from itertools import product
from pathlib import Path
from random import Random

import pytest

from hfield import QuaternionAlgebra, hilbert_symbol, prove, ring
from hfield.core.factorisation import remove
from hfield.errors import RingError, UndecidedError
from tests.fields.quadratic_forms.padic_cases import cases, extension_cases, pari, pari_symbol
from tests.subcases import subcases
from tests.thorough import quick_part

VECTORS = Path(__file__).parents[2] / "vectors" / "padic_symbols.txt"
EXTENSIONS = Path(__file__).parents[2] / "vectors" / "padic_extension_symbols.txt"
COMPLETIONS = (
    "Qp(2)", "Qp(3)", "Qp(5)", "Qp(7)", "QQ(I)_(2)", "QQ(I)_(5, I-2)", "QQ(sqrt(2))_(2)", "QQ(sqrt(3))_(2)",
    "QQ(sqrt(5))_(2)", "QQ(sqrt(-7))_(2, sqrt(-7)-1)", "QQ(sqrt(-3))_(3)", "GF(3)((t))", "GF(9)((t))",
    "GF(5)(t)_(t^2+2)", "GF(7)(t)_inf",
)  # fmt: skip
EVEN = ("GF(2)((t))", "GF(4)((t))", "GF(2)(t)_(t^2+t+1)", "GF(4)(t)_inf")


def order(x: Fraction, p: int) -> int:
    return remove(x.numerator, p)[0] - remove(x.denominator, p)[0]


@pytest.fixture(scope="module")
def symbols():
    """Our symbols of a thousand cases, ``(p, a, b)`` to ±1."""
    found = {}
    for p, a, b in cases():
        F = ring(f"Qp({p})")
        found[p, a, b] = hilbert_symbol(F(a), F(b), p)
    assert len(found) == len(cases())
    return found


def test_a_thousand_symbols_are_those_of_the_vectors(symbols):
    signs = VECTORS.read_text(encoding="utf-8").replace("\n", "")
    assert symbols == {c: 1 if s == "+" else -1 for c, s in zip(cases(), signs, strict=True)}


@pytest.mark.slow
def test_a_thousand_symbols_are_those_of_pari(symbols):
    oracle = pari()
    assert symbols == {(p, a, b): int(oracle(f"hilbert({a},{b},{p})")) for p, a, b in cases()}


def test_two_hundred_symbols_over_extensions_are_those_of_the_vectors():
    signs = EXTENSIONS.read_text(encoding="utf-8").replace("\n", "")
    known = list(zip(extension_cases(), signs, strict=True))
    for (_, P, a, b), sign in quick_part(known):
        L = P.field.completion(P)
        assert hilbert_symbol(L(a), L(b), P) == (1 if sign == "+" else -1), (P, a, b)


@pytest.mark.slow
def test_two_hundred_symbols_over_extensions_are_those_of_pari():
    oracle = pari()
    for text, P, a, b in extension_cases():
        L = P.field.completion(P)
        cut = [L.up_to(x, P.valuation(x) + L.square_digits) for x in (a, b)]
        assert hilbert_symbol(*cut, P) == pari_symbol(oracle, text, P, a, b), (P, a, b)


def test_so_many_digits_decide_and_fewer_do_not():
    """Modulo p, and modulo 8 at 2, the unit is known; with a digit less it is not, and the error says so.

    At 2 the last of the digits is that of the unit 5, and (5, b) is −1 exactly where b has odd valuation.
    """
    for p, a, b in cases()[::7]:
        F = ring(f"Qp({p})")
        enough = 3 if p == 2 else 1
        cut = [F.up_to(x, order(x, p) + enough) for x in (a, b)]
        assert hilbert_symbol(*cut, p) == hilbert_symbol(a, b, p)
        short = F.up_to(a, order(a, p) + enough - 1)
        power = order(a, p) + enough
        if p == 2 and order(b, p) % 2 == 0:
            assert hilbert_symbol(short, F(b), p) == hilbert_symbol(a, b, p)
            continue
        with pytest.raises(UndecidedError, match=f"{enough} digit|more are needed") as error:
            hilbert_symbol(short, F(b), p)
        assert F.big_o(power) in str(error.value)


@pytest.mark.slow
@subcases("name", COMPLETIONS)
def test_square_classes_are_as_many_as_they_should_be(name):
    """There are 4 in odd residue characteristic, 4·2ⁿ in degree n over ℚ₂; the symbol is regular on them."""
    F, rng = ring(name), Random(3)
    degree = F.doubling * (F.residues.order.bit_length() - 1)
    expected = 4 * 2**degree
    classes = [F.one]
    for n in range(60 * expected):
        if len(classes) == expected and n > 40:
            break
        x = F(F.random(rng).value + rng.randint(-5, 5))
        if F.is_zero(x):
            continue
        x = x * F.uniformiser ** rng.randint(0, 1)
        if not any(F.is_square(x * y) for y in classes):
            classes.append(x)
    assert len(classes) == expected
    signs = [[hilbert_symbol(x, y, None) for y in classes] for x in classes]
    assert signs == [list(row) for row in zip(*signs, strict=True)]
    assert all(s == 1 for s in signs[0])
    assert all(sum(row) == 0 for row in signs[1:])  # half of the classes are norms


@pytest.mark.slow
@subcases("name", COMPLETIONS)
def test_an_inexact_number_is_decided_as_all_numbers_in_it(name):
    F, rng = ring(name), Random(4)
    for _ in range(6):
        a, b = (F.random(rng) + F(rng.randint(1, 9)) for _ in range(2))
        if F.is_zero(a) or F.is_zero(b):
            continue
        near = [F.up_to(x, x.valuation() + F.square_digits) for x in (a, b)]
        expected = hilbert_symbol(*near, None)
        for _ in range(3):
            moved = [
                x + F.random(rng) * F.uniformiser ** (n.precision + 6)
                for x, n in zip((a, b), near, strict=True)
            ]
            if all(F.up_to(x, n.precision) == n for x, n in zip(moved, near, strict=True)):
                assert hilbert_symbol(*moved, None) == expected


@pytest.mark.slow
@subcases("name", COMPLETIONS + EVEN)
def test_what_splits_is_split_and_what_does_not_is_proved_so(name):
    F, rng, seen = ring(name), Random(6), set()
    t = F.characteristic == 2
    for _ in range(12):
        a, b = (F.random(rng) * F.uniformiser ** rng.randint(-1, 1) for _ in range(2))
        if F.is_zero(b) or (F.is_zero(a) and not t):
            continue
        A = QuaternionAlgebra(F, a, b, int(t))
        answer = A.division_or_splitting()
        seen.add(bool(answer))
        assert A.is_division_algebra() == (not answer) == (A.ramified_places() == (F.place,))
        assert A.is_division_algebra() == (hilbert_symbol(a, b, F.place) == -1)
        if answer:
            q = A.zero_norm_element()
            assert any(x.has_value for x in q.coordinates)
            assert F.vanishes(q.norm())
            for m, x, linear in ((answer.i, a, t), (answer.j, b, False)):
                assert all(map(F.agree, square(m), scalar(F, x, m, linear)))
    assert seen == {True, False}


def square(m):
    (a, b), (c, d) = m
    return a * a + b * c, a * b + b * d, c * a + d * c, c * b + d * d


def scalar(F, x, m, t):
    """The entries of x·1, plus m where t is 1."""
    (a, b), (c, d) = m if t else ((F.zero, F.zero), (F.zero, F.zero))
    return x + a, b, c, x + d


@pytest.mark.slow
@subcases("name", COMPLETIONS)
def test_all_division_algebras_are_isomorphic(name):
    F, rng, division = ring(name), Random(8), []
    while len(division) < 3:
        a, b = (F.random(rng) + F(rng.randint(-4, 4)) for _ in range(2))
        if not (F.is_zero(a) or F.is_zero(b)):
            A = QuaternionAlgebra(F, a * F.uniformiser, b)
            if A.is_division_algebra():
                division.append(A)
    A, B, C = division
    split = QuaternionAlgebra(F, 1, F.uniformiser)
    assert A.is_isomorphic(B)
    assert not A.is_isomorphic(split)
    assert split.is_isomorphic(QuaternionAlgebra(F, F.uniformiser, -F.uniformiser))
    for target in (B, C):
        phi = A.isomorphism(target)  # multiplied out as far as the digits go
        assert all(
            F.agree(x, y)
            for x, y in zip(
                (phi(A.basis[1]) ** 2).coordinates, (A.constants.a, 0, 0, 0), strict=True
            )
        )


@pytest.mark.parametrize("name", EVEN)
def test_as_many_digits_as_the_pole_decide_in_characteristic_2(name):
    F, rng = ring(name), Random(9)
    pi = F.uniformiser
    for n in (1, 3, 5):
        a = F.one / pi**n
        for _ in quick_part(range(5), 3):
            b = F.one + pi * F.up_to(F.random(rng), 30)
            if not b.has_value or b.valuation() or b.digits() < n + 1:
                continue
            cut = F.up_to(b, n + 1)
            near, exact = F.up_to(a, 1), F(b.value)
            assert hilbert_symbol(near, cut, None) == hilbert_symbol(a, exact, None)
            with pytest.raises(UndecidedError, match=f"{n + 1} digit"):
                hilbert_symbol(a, F.up_to(b, n), None)
        with pytest.raises(UndecidedError, match=r"up to O\("):
            hilbert_symbol(F.up_to(a, 0), pi, None)
        assert hilbert_symbol(F.up_to(a, 0), F.one, None) == 1


def test_levels():
    values = {
        "Qp(2)": 4, "Qp(3)": 2, "Qp(5)": 1, "QQ(I)_(2)": 1, "QQ(sqrt(2))_(2)": 2,
        "QQ(sqrt(17))_(2, sqrt(17)-1)": 4, "QQ(sqrt(-7))_(2, sqrt(-7)-1)": 4,
        "GF(3)((t))": 2, "GF(9)((t))": 1, "GF(4)((t))": 1,
    }  # fmt: skip
    assert {name: ring(name).level.value for name in values} == values


def test_a_global_algebra_ramifies_where_its_completion_is_a_division_algebra():
    for name, a, b in (
        ("QQ", -6, 35),
        ("QQ(sqrt(2))", -3, 5),
        ("QQ(I)", 3, 7),
        ("GF(3)(t)", "t", "t^3-t+1"),
    ):
        A = QuaternionAlgebra(name, a, b)
        K, ramified = A.ring, set(map(str, A.ramified_places()))
        for v, _ in zip(K.places(), range(14), strict=False):
            if str(v).startswith("inf") and K.characteristic == 0:
                continue
            L = K.completion(v)
            assert A.change_ring(L).is_division_algebra() == (str(v) in ramified), (name, v)


def test_the_completion_at_an_infinite_place_is_made_of_algebraic_numbers():
    assert ring("QQ").completion("inf").name == "RR"
    assert ring("QQ(sqrt(2))").completion("inf+").name == "RR"
    assert ring("QQ(I)").completion("inf").name == "CC"
    assert ring("QQ(sqrt(2))").completion("inf-").name == "QQ(sqrt(2))_inf-"


def test_errors_say_what_is_missing():
    F = ring("Qp(5)")
    with pytest.raises(RingError, match="one place, 5; 7 is not it"):
        hilbert_symbol(F(2), F(5), 7)
    with pytest.raises(RingError, match="nonzero elements only"):
        hilbert_symbol(F(0), F(5), 5)
    with pytest.raises(UndecidedError, match=r"up to O\(5\^4\)"):
        hilbert_symbol(F("O(5^3)"), F(5), 5)
    with pytest.raises(UndecidedError, match=r"whether O\(5\^3\) is 0"):
        F("1/O(5^3)")
    with pytest.raises(RingError, match="is not a place of"):
        ring("GF(3)(t)").completion("t^2-1")
    with pytest.raises(UndecidedError, match="not a global field"):
        ring("GF(3)").completion(3)
    with pytest.raises(UndecidedError, match="digit"):
        QuaternionAlgebra(F, "2+O(5)", "O(5^2)").is_division_algebra()
    with pytest.raises(UndecidedError, match=r"3 digits.*2 are known"):
        QuaternionAlgebra("Qp(2)", "3+O(2^2)", 2).ramified_places()


@pytest.mark.parametrize(
    ("statement", "algebra", "verdict"),
    [
        ("(p*q)*r == p*(q*r)", "(2,5|Qp(5))", "proved"),
        ("p*q == q*p", "(2,5|Qp(5))", "refuted"),
        ("norm(q) == 0 => q == 0", "(2,5|Qp(5))", "proved"),
        ("p*q == 0 => p == 0 or q == 0", "(-1,-1|Qp(2))", "proved"),
        ("norm(q) == 0 => q == 0", "(1,5|Qp(5))", "refuted"),
        ("norm(q) == 0 => q == 0", "[1,t|GF(2)((t)))", "proved"),
        ("exists s: s*s == 2", "(2,5|Qp(5))", "refuted"),
    ],
)  # fmt: skip
def test_verdicts(statement, algebra, verdict):
    assert prove(statement, algebra=algebra).verdict == verdict


@pytest.mark.slow
def test_products_of_classes_over_small_fields_by_exhaustion():
    """(a, b) = 1 exactly where z² = a·x² + b·y² has a primitive solution modulo p³, or modulo 2⁵ at 2."""
    for p, n in ((2, 5), (3, 2), (5, 2)):
        F, m = ring(f"Qp({p})"), p**n
        squares = {z * z % m for z in range(m)}
        for a, b in product(range(1, p * p), repeat=2):
            if order(Fraction(a), p) > 1 or order(Fraction(b), p) > 1:
                continue
            solvable = any(
                (a * x * x + b * y * y) % m in squares and (x % p or y % p)
                for x, y in product(range(m), repeat=2)
            )
            assert (hilbert_symbol(F(a), F(b), p) == 1) == solvable, (p, a, b)
