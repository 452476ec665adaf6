"""The checker's lattices beside those of the package: two systems that share nothing agree."""

import random
from fractions import Fraction
from itertools import product
from math import prod
from typing import Any

import pytest
from flint import fmpz_mat

from hfield import QuaternionAlgebra
from hfield.checker.budget import bounded
from hfield.checker.number_fields.enumeration import short_vectors
from hfield.checker.number_fields.factoring import factored
from hfield.checker.number_fields.ideals import index
from hfield.checker.number_fields.integers import RATIONAL_INTEGERS, RationalPrimes
from hfield.checker.number_fields.matrices import hermite, inverse, rational_rows
from hfield.checker.orders.algebra import Algebra
from hfield.checker.orders.lattice import Lattice
from hfield.checker.orders.local_types import mass, symbols
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.rationals import QQ
from hfield.checker.statement import read_setting
from tests.checker.order_certificates import ALGEBRAS


def mirrored(L: Any) -> Lattice:
    """Return a lattice of the package as one of the checker."""
    algebra = Algebra(read_setting(str(L.algebra), QQ), RATIONAL_INTEGERS)
    den, rows = L.hnf
    return Lattice(algebra, den, rows)


def test_arithmetic_agrees() -> None:
    rng = random.Random(1)
    for a, b, t in ALGEBRAS:
        A = QuaternionAlgebra("QQ", a, b, t)
        for _ in range(6):
            rows = [
                [Fraction(rng.randint(-9, 9), rng.randint(1, 4)) for _ in range(4)]
                for _ in range(9)
            ]
            L, M = A.lattice(rows[:4]), A.lattice(rows[4:8])
            own, other = mirrored(L), mirrored(M)
            assert own.key == L.hnf
            assert index(own.norm) == Fraction(str(L.norm()))
            assert other.volume / own.volume == Fraction(L.index(M))
            for side in ("left", "right"):
                found = own.into(other, side)
                assert found.key == M.colon(L, "right" if side == "left" else "left").hnf
            O = L.left_order()
            assert mirrored(O).discriminant == O.discriminant()
            found = {P.p: symbol for P, symbol in symbols(mirrored(O), RationalPrimes())}
            assert found == {p: O.eichler_symbol(p) for p in factored(O.discriminant())}
            if "inf" in A.ramified_places():
                assert mass(mirrored(O), RationalPrimes()) == O.mass()


def test_hermite_forms_and_inverses() -> None:
    rng = random.Random(2)
    for size in (3, 10**3, 10**80):
        for _ in range(20):
            rows = [[rng.randint(-size, size) for _ in range(4)] for _ in range(rng.randint(4, 9))]
            if fmpz_mat(rows).rank() < 4:
                continue
            expected = fmpz_mat(rows).hnf().tolist()[:4]
            assert [list(row) for row in hermite(rows)] == [
                [int(x) for x in row] for row in expected
            ]
            square = fmpz_mat(rows[:4])
            if square.det():
                back, d = inverse(tuple(map(tuple, rows[:4])))
                assert abs(d) == abs(int(square.det()))
                assert square * fmpz_mat([list(row) for row in back]) == d * fmpz_mat(
                    [[int(m == n) for n in range(4)] for m in range(4)]
                )


def test_enumeration_is_complete() -> None:
    rng = random.Random(3)
    for _ in range(20):
        m = fmpz_mat([[rng.randint(-2, 2) for _ in range(4)] for _ in range(4)])
        gram = (
            m * m.transpose() * 2
            + 2 * fmpz_mat([[int(i == j) for j in range(4)] for i in range(4)])
        ).tolist()
        rows = tuple(tuple(int(x) for x in row) for row in gram)
        bound = 14
        # 2·|x|² ≤ x·G·xᵀ, so that coordinates beyond 2 are too long
        brute = {}
        for x in product(range(-2, 3), repeat=4):
            value = sum(x[i] * x[j] * rows[i][j] for i in range(4) for j in range(4))
            if 0 < value <= bound:
                brute[x] = value
        found = dict(short_vectors(rows, bound))
        both = found | {tuple(-c for c in x): v for x, v in found.items()}
        assert len(both) == 2 * len(found)
        assert both == brute


def test_masses_of_small_discriminants() -> None:
    """The mass counted by Eichler's formula for Eichler orders: φ(D)·ψ(N)/12."""
    for primes, level, expected in (((11,), 1, "5/6"), ((11,), 3, "10/3"), ((2, 3, 5), 7, "16/3")):
        O = QuaternionAlgebra.from_ramification("QQ", primes).eichler_order(level)
        assert mass(mirrored(O), RationalPrimes()) == Fraction(expected)


@pytest.mark.slow
def test_what_is_too_large_to_factor_is_rejected() -> None:
    with bounded():
        assert factored(2**5 * 3 * 1000003) == {2: 5, 3: 1, 1000003: 1}
        assert factored(10**12 + 39) == {10**12 + 39: 1}
        primes = [
            1031,
            1033,
            1039,
            1049,
            1051,
            1061,
            1063,
            1069,
            1087,
        ]  # together too long to be proved prime
        assert factored(prod(primes)) == dict.fromkeys(primes, 1)
        for n in (2**5000, (10**9 + 7) * (10**9 + 9), 5 * 2**248 - 1):
            with pytest.raises(Rejected):
                factored(n)


def test_rows_of_fractions() -> None:
    assert rational_rows([[Fraction(1, 2), Fraction(2, 3)]]) == (6, ((3, 4),))


def test_long_numbers_are_paid_for() -> None:
    """Running through vectors costs as much more as the numbers are longer."""

    def spent(scale: int) -> int:
        gram = tuple(tuple(scale * (m == n) for n in range(4)) for m in range(4))
        with bounded() as work:
            assert len(list(short_vectors(gram, 4 * scale))) == 44
        return work.spent

    assert spent(10**4000) > 50 * spent(1)
