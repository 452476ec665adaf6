"""Bounds of the checker's arithmetic that no file of ours comes near, each asked where it stands."""

from fractions import Fraction

import pytest

from hfield.checker.evaluate import Evaluator, Quaternion, RingScalars
from hfield.checker.number_fields.enumeration import short_vectors
from hfield.checker.number_fields.matrices import inverse
from hfield.checker.rejection import Rejected
from hfield.checker.scalars import names, rationals, real_roots, surds
from hfield.checker.scalars.number_fields import root_discs, without_common_factors
from hfield.checker.scalars.quotients import MAX_DEGREE
from hfield.checker.scalars.quotients import QuotientField as Residues
from hfield.checker.scalars.real_roots import RealRoot
from hfield.checker.statement import HAMILTON
from tests.checker.ring_data import read_field

LONG = 10**9 + 7


def test_numbers_and_moduli_that_are_too_long() -> None:
    long = "9" * (names.MAX_DIGITS + 1)
    for digits in (
        "",
        "1.5",
        "x",
        "+3",
        "٣/2",
        "1_1/2",
        "1/1",
        "4/2",
        "2/4",
        "-0/3",
        "1/-2",
        "1 /2",
        "1/0",
    ):
        with pytest.raises(Rejected, match="must be an integer or a text such as '-1/2'"):
            names.a_rational(digits, "it")
    for digits in ("3", "-12", "01/2", "1/02", "--1/2", "1/2\n", f"{long}/2", f"1/{long}"):
        with pytest.raises(Rejected, match="must be an integer or a text such as '-1/2'"):
            names.a_rational(digits, "it")
    for value in (1.0, None, True, ["1/2"], 10 ** (names.MAX_DIGITS + 20)):
        with pytest.raises(Rejected, match=r"must be an integer|has more than 4000 digits"):
            names.a_rational(value, "it")
    assert names.a_rational(-12, "it") == -12
    assert names.a_rational("-1/2", "it") == Fraction(-1, 2)
    assert names.a_rational(f"{'9' * names.MAX_DIGITS}/2", "it").denominator == 2


def test_rational_roots_with_too_many_candidates() -> None:
    with pytest.raises(Rejected, match="are too large to list their divisors"):
        rationals.divisors(10**10 + 1)
    assert rationals.divisors(12) == [1, 2, 3, 4, 6, 12]
    n = 735134400  # with 1344 divisors; 1 is a root modulo every prime
    with pytest.raises(Rejected, match="too many candidates"):
        rationals.has_no_rational_root([n, -2 * n, n])


def test_squares_of_long_primes() -> None:
    p = 2003
    assert surds.radical(20011 * 20011) == ((), 20011)
    assert surds.radical(p * p * 6) == ((2, 3), p)
    assert surds.radical(p * p) == ((), p)


def test_matrices_without_an_inverse() -> None:
    rows = [[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 0], [0, 0, 0, 1]]
    with pytest.raises(Rejected, match="rank below 4"):
        inverse(rows)
    indefinite = [[2 * (m == n) * (1 if m < 3 else -1) for n in range(4)] for m in range(4)]
    with pytest.raises(Rejected, match="the norm is indefinite"):
        list(short_vectors(indefinite, 2))


def test_roots_that_are_not_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(real_roots, "MAX_HALVINGS", 40)
    with pytest.raises(Rejected, match="too large for its roots"):
        root_discs([2**200, 0, 1])
    discs = root_discs([-2, 0, 1])
    assert len(discs) == 2
    root = RealRoot([-2, 0, 1], Fraction(1), Fraction(2))
    with pytest.raises(Rejected, match="too many halvings"):
        root.sign([Fraction(-2), Fraction(0), Fraction(1)])  # which is 0 there


def test_polynomials_over_two_elements() -> None:
    # (1 + x + x²)(1 + x²) without 1 + x + x²
    assert without_common_factors([1, 1, 0, 1, 1], [1, 1, 1]) == [1, 0, 1]


def test_degrees_of_residue_fields() -> None:
    base = read_field("GF(3)")
    for modulus in ([1], [1] * (MAX_DEGREE + 2)):
        with pytest.raises(Rejected, match="has a degree from 1 to"):
            Residues(base, modulus)


def test_elements_of_many_terms() -> None:
    ring = read_field("ZZ[x,y]")
    many = {(m, 0): 1 for m in range(4_001)}
    with pytest.raises(Rejected, match="has more than 4000 terms"):
        ring._poly(many)


def test_nothing_is_divided_by_a_quaternion() -> None:
    # read_tree says so of texts; the evaluation says it again
    ring = read_field("QQ")
    q = Quaternion([ring.number(n) for n in (0, 1, 0, 0)])
    evaluator = Evaluator(RingScalars(ring), HAMILTON, {("name", "q"): q})
    with pytest.raises(Rejected, match="a quaternion stands where a scalar is meant"):
        evaluator.value(("/", ("num", 1), ("name", "q")))
    with pytest.raises(Rejected, match="a term cannot be evaluated"):
        evaluator.value(("==", ("num", 1), ("num", 1)))
