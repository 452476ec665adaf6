import itertools
import math
import random

import pytest

from hfield import H
from hfield.algebra.structure.counting.counted_kinds import KINDS
from hfield.algebra.structure.counting.formulas_finite import count
from hfield.algebra.structure.counting.tally import confirm, tally
from hfield.cli.commands.count import counts
from hfield.errors import CoercionError, NotFiniteError, TooLargeError
from hfield.fields.names import ring
from tests.fields.algebra_cases import cases, constants
from tests.subcases import first_quick

UP_TO_32 = [2, 3, 4, 5, 7, 8, 9, 11, 13, 16, 17, 19, 23, 25, 27, 29, 31, 32]


def test_formulas_agree_with_gap():
    for case in cases("finite_counts"):
        F, c = ring(case["ring"]), constants(case["ring"], case["a"], case["t"], case["b"])
        assert count(F, c, "elements").value == case["elements"]
        assert count(F, c, "norm").value == case["norm_zero"], case
        assert count(F, c, "nilpotent").value == case["nilpotent"], case
        assert count(F, c, "idempotent").value == case["idempotent"], case
        assert count(F, c, "units").value == case["unit"], case
        assert count(F, c, "square roots").value == case["sqrt_one"], case
        assert count(F, c, "square roots", -1).value == case["sqrt_minus_one"], case


@pytest.mark.parametrize("q", [2, 3, 4, 5, 8, 9])
def test_every_kind_of_algebra_is_confirmed_by_exhaustion(q):
    F = ring(f"GF({q})")
    some = list(itertools.islice(F.elements(), 3 if q > 4 else q))
    for a, t, b in itertools.product(some, repeat=3):
        confirm(F, constants(F.name, a, t, b))


@pytest.mark.slow
def test_hamilton_up_to_32():
    for q in UP_TO_32:
        found = confirm(ring(f"GF({q})"), constants(f"GF({q})", -1, 0, -1))
        assert found.norms["0"] == (q**3 if q % 2 == 0 else q**3 + q**2 - q)


def test_residue_rings_are_counted_too():
    R, c = ring("ZZ/4"), constants("ZZ/4", -1, 0, -1)
    found = tally(R, c)
    assert found.elements == 256
    assert sum(found.norms.values()) == 256
    assert found.units == found.norms["1"] + found.norms["3"] == 128
    assert found.nilpotent == 128  # a local ring: what is not a unit is nilpotent
    six = tally(ring("ZZ/6"), constants("ZZ/6", -1, 0, -1))
    assert six.units == 8 * 48  # units modulo 2 times units modulo 3
    assert six.idempotent == 2 * 14


def everything_agrees(n, a, t, b):
    """Compare every formula over ZZ/n with the exhaustive count; ``confirm`` raises where they differ."""
    confirm(ring(f"ZZ/{n}"), constants(f"ZZ/{n}", a, t, b))


def test_residue_formulas_for_all_algebras_modulo_4():
    for a, t, b in itertools.product(range(4), repeat=3):
        everything_agrees(4, a, t, b)


@pytest.mark.parametrize(
    ("n", "times"), first_quick([(6, 12), (25, 2), (8, 40), (9, 25), (12, 8), (16, 12)], 2)
)
def test_residue_formulas_for_random_algebras(n, times):
    rng = random.Random(n)
    for _ in range(times):
        # even numbers, 0 and n/2 make degenerate reductions; odd t has a formula of its own
        a, t, b = (rng.choice([rng.randrange(n), rng.randrange(0, n, 2), n // 2, 0]) for _ in "atb")
        everything_agrees(n, a, t, b)


def test_residue_formulas_for_larger_moduli():
    """Sums over all values, a formula that is known, and a count lifted by another way."""
    for name in ("ZZ/64", "ZZ/1000", "ZZ/729"):
        R = ring(name)
        for c in (constants(name, -1, 0, -1), constants(name, 6, 3, 10)):
            norms = [count(R, c, "norm", x).value for x in R.elements()]
            assert sum(norms) == R.order**4
            units = sum(v for v, x in zip(norms, R.elements(), strict=True) if R.is_unit(x))
            assert units == count(R, c, "units").value
    p = 10**9 + 7
    square = ring(f"ZZ/{p**2}")
    hamilton = constants(square.name, -1, 0, -1)
    assert count(square, hamilton, "norm", 1).value == (p**3 - p) * p**3
    # of the elements of norm 0 modulo p, those that are not 0 lift in p³ ways, and 0 in p⁴
    assert count(square, hamilton, "norm", 0).value == (p**3 + p**2 - p - 1) * p**3 + p**4
    big = ring(f"ZZ/{2**60}")
    found = count(big, constants(big.name, -1, 0, -1), "square roots", 1).value
    assert found == 32
    huge = ring(f"ZZ/{2**300}")
    with pytest.raises(TooLargeError, match="exponents up to 64"):
        count(huge, constants(huge.name, -1, 0, -1), "square roots", 1)


def test_square_roots_modulo_a_prime_power_add_up():
    """Every element is a square root of its square, and those with a scalar square are known otherwise."""
    for name, a, t, b in (
        ("ZZ/32", -1, 0, -1),
        ("ZZ/32", 3, 1, 6),
        ("ZZ/32", 4, 6, 8),
        ("ZZ/81", 3, 2, 6),
    ):
        R, c = ring(name), constants(name, a, t, b)
        n = R.order
        scalar_squares = 0
        for w, x in itertools.product(range(n), repeat=2):
            trace = (2 * w + int(c.t) * x) % n
            if trace * x % n:
                continue
            d = n // math.gcd(n, trace)  # y and z are multiples of it
            scalar_squares += (n // d) ** 2
        assert sum(count(R, c, "square roots", s).value for s in R.elements()) == scalar_squares


def test_formulas_are_texts():
    c = constants("GF(9)", -1, 0, -1)
    assert count(ring("GF(9)"), c, "norm") == (801, "q^3+q^2-q")
    assert count(ring("GF(9)"), c, "units").formula == "q^4-(q^3+q^2-q)"
    big = ring("GF(101^5)")
    assert count(big, constants(big.name, -1, 0, -1), "norm").value > 10**30


def test_what_cannot_be_counted():
    with pytest.raises(NotFiniteError, match="neither a finite field nor ZZ/n"):
        count(ring("QQ"), constants("QQ", -1, 0, -1), "norm")
    with pytest.raises(NotFiniteError, match="infinite"):
        tally(ring("QQ"), constants("QQ", -1, 0, -1))
    with pytest.raises(CoercionError, match="no count of 'zeros'"):
        count(ring("GF(3)"), constants("GF(3)", -1, 0, -1), "zeros")
    with pytest.raises(TooLargeError, match="formulas"):
        tally(ring("GF(101)"), constants("GF(101)", -1, 0, -1))


@pytest.mark.parametrize("name", first_quick(["GF(4)", "ZZ/6", "GF(5)", "GF(9)", "ZZ/8"], 2))
def test_loops_and_tables_count_the_same(name, monkeypatch):
    R = ring(name)
    for c in (constants(name, -1, 0, -1), constants(name, 2, 1, 3)):
        found = []
        for many in (0, 10**9):
            monkeypatch.setattr(f"{tally.__module__}.MIN_COMPILED", many)
            found.append(tally(R, c))
        assert found[0] == found[1]


@pytest.mark.parametrize("name", ["GF(5)", "ZZ/4"])
def test_every_kind_is_counted_without_formulas_too(name, monkeypatch):
    """Over a finite ring without formulas methods and tables have the same kinds with the same numbers."""
    A = H(name)
    asked = {"norm": {"norm": 0}, "square roots": {"square": -1}}

    def numbers():
        return [
            A.count(**(asked[kind.name] if kind.needs else {"kind": word}))
            for kind in KINDS.values()
            for word in (kind.name, *kind.words)
        ]

    by_formulas, table = numbers(), counts(A)
    monkeypatch.setattr("hfield.algebra.structure.has_formulas", lambda ring: False)
    assert numbers() == by_formulas
    assert [line[:2] for line in counts(A).lines] == [line[:2] for line in table.lines]
    assert all(formula is None for _, _, formula in counts(A).lines)
    for kind in KINDS.values():
        if not kind.needs:
            assert (kind.name, A.count(kind.name)) in [line[:2] for line in table.lines]
