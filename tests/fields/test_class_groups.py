"""Class groups, units and ζ_K(−1) against PARI, and saturation of a group that is not."""

import json
from fractions import Fraction
from itertools import pairwise
from math import isclose, log, prod
from pathlib import Path
from random import Random
from typing import Any

import pytest

from hfield import ring
from hfield.checker.number_fields.class_groups import _characters
from hfield.errors import HFieldError, RingError
from hfield.fields.number_fields.classes.s_units import (
    PowerResidues,
    SUnits,
    root,
    roots_of_unity,
    s_units,
)
from hfield.fields.number_fields.ideals import integers
from tests.subcases import subcases

CASES = json.loads((Path(__file__).parents[1] / "vectors/class_groups.json").read_text())["cases"]


@pytest.mark.slow
@subcases("case", CASES)
def test_as_pari(case: dict[str, Any]) -> None:
    """Invariants, regulator, torsion, ζ_K(−1) and which primes are principal; generators generate."""
    K = ring(f"QQ[s]/({case['polynomial']})")
    C, U = K.class_group(), K.unit_group()
    assert list(C.invariants) == case["classes"]
    assert list(K.narrow_class_group().invariants) == case["narrow"]
    assert C.assumes == U.assumes == ()
    assert U.torsion_order == case["torsion"]
    assert isclose(float(U.regulator.mid()), case["regulator"], rel_tol=1e-9)
    assert all(abs(u.norm()) == 1 and K.is_integral(u) for u in U.generators)
    if case["zeta"]:
        assert K.zeta_minus_one() == Fraction(*case["zeta"])
    for p, wanted in case["principal"].items():
        found = []
        for P in K.primes_above(int(p)):
            answer = K.ideal(P).is_principal()
            assert not answer or K.ideal(answer.generator) == K.ideal(P)
            found.append([P.f, int(bool(answer))])
        assert sorted(found) == wanted


@pytest.mark.parametrize(
    ("name", "order", "narrow"),
    [("QQ(sqrt(-5))", 2, 2), ("QQ(sqrt(3))", 1, 2), ("QQ(sqrt(10))", 2, 2), ("QQ(sqrt(-5460))", 16, 16),
     ("QQ(sqrt(79))", 3, 6), ("QQ(I)", 1, 1), ("QQ[s]/(s^4-10*s^2+1)", 1, 2)],
)  # fmt: skip
def test_groups(name: str, order: int, narrow: int) -> None:
    """Known orders; generators have the orders of their factors; totally positive units are that."""
    K = ring(name)
    for C, wanted in ((K.class_group(), order), (K.narrow_class_group(), narrow)):
        assert C.order == len(C) == wanted
        for k, (a, d) in enumerate(zip(C.generators, C.invariants, strict=True)):
            assert C.class_of(a) == tuple(int(j == k) for j in range(len(C.invariants)))
            assert not any(C.class_of(a**d))
    places = K.real_places()
    assert all(v.sign(u) > 0 for u in K.totally_positive_units() for v in places)


def test_large_fundamental_unit() -> None:
    """A generator with a large unit is found, and is short."""
    K = ring("QQ(sqrt(2400009))")
    for p in (2, 3, 5, 7):
        for P in K.primes_above(p):
            h = K.class_group().order
            a = K.ideal(P) ** h
            assert K.ideal(a.is_principal().generator) == a


def test_saturation() -> None:
    """From S-units of index 2·9·5 the saturation comes back to the whole group."""
    K = ring("QQ[s]/(s^4-s^3-4*s^2+4*s+1)")
    whole = SUnits(integers(K))
    size = whole.covolume(whole.generators, whole.rows)
    for position, power in ((0, 2), (1, 9), (2, 5)):
        x = whole.generators[position]
        whole.generators[position] = K.power(x, power) * whole.torsion
        whole.rows[position] = [c * power for c in whole.rows[position]]
    spoilt = whole.covolume(whole.generators, whole.rows)
    assert isclose(float((spoilt / size).mid()), 90)
    whole._saturate()
    assert whole.covolume(whole.generators, whole.rows).overlaps(size)


def test_roots() -> None:
    """Roots of powers are found, also fractions and with complex conjugates; others are refused."""
    K = ring("QQ[s]/(s^4-s-1)")
    frame, x = integers(K), K("3/2-s+s^3")
    for ell in (2, 3, 5):
        y = root(frame, K.power(x, ell), ell)
        assert y is not None
        assert K.power(y, ell) == K.power(x, ell)
        assert root(frame, K.power(x, ell) * 7, ell) is None


@pytest.mark.parametrize(("ell", "q"), [(2, 3), (3, 7), (13, 53), (31, 311), (1009, 10091)])
def test_power_residues(ell: int, q: int) -> None:
    """They are a homomorphism that is 0 at ℓ-th powers alone, and the checker's up to a factor."""
    symbol, rng = PowerResidues(ell, q), Random(ell)
    values = [rng.randrange(1, q) for _ in range(40)]
    found = [symbol(x) for x in values]
    assert all(0 <= c < ell for c in found)
    for (x, c), (y, d) in pairwise(zip(values, found, strict=True)):
        assert symbol(x * y % q) == (c + d) % ell
        assert (c == 0) == (pow(x, (q - 1) // ell, q) == 1)
    assert _characters(ell, q, values) == found


def test_roots_of_large_degree() -> None:
    """Roots are lifted from one prime ideal, also where the field has roots of unity of that order."""
    K = ring("QQ(zeta13)")
    frame, x = integers(K), K("1/3-2*zeta13+zeta13^5")
    for ell in (2, 13, 31):
        y = root(frame, K.power(x, ell), ell)
        assert y is not None
        assert K.power(y, ell) == K.power(x, ell)
        assert root(frame, K.power(x, ell) * 3, ell) is None
    assert root(frame, K.gen, 13) is None


@pytest.mark.parametrize(
    ("name", "order"),
    [("QQ(zeta21)", 42), ("QQ(sqrt(-1),sqrt(2))", 8), ("QQ(sqrt(-3),sqrt(5))", 6), ("QQ[s]/(s^4+2)", 2),
     ("QQ(sqrt(-3),root(2,3))", 6), ("QQ[s]/(s^6+3)", 6), ("QQ[s]/(s^4-2)", 2)],
)  # fmt: skip
def test_roots_of_unity(name: str, order: int) -> None:
    K = ring(name)
    found, zeta = roots_of_unity(integers(K))
    powers = [K.power(zeta, k) for k in range(order)]
    assert found == order
    assert len(set(powers)) == order
    assert K.power(zeta, order) == K.one


@pytest.mark.slow
def test_group_with_a_large_index_bound() -> None:
    """The index bound is 588: products that are powers modulo many prime ideals are not taken for powers."""
    classes = ring("QQ(zeta13)").class_group()
    assert classes.order == 1
    assert classes.certificate is not None


@pytest.mark.slow
def test_class_number_divides_the_index_bound() -> None:
    """The first index bound is 108852, over the limit; it is divided by the class number (PARI: (8, 2))."""
    assert ring("QQ(sqrt(-5),sqrt(7),sqrt(-11))").class_group().invariants == (2, 8)


def test_zeta() -> None:
    """Known values."""
    known = {"QQ(sqrt(5))": (1, 30), "QQ(sqrt(2))": (1, 12), "QQ(sqrt(3))": (1, 6), "QQ(sqrt(13))": (1, 6),
             "QQ[s]/(s^3-s^2-2*s+1)": (-1, 21), "QQ[s]/(s^3-3*s-1)": (-1, 9),
             "QQ[s]/(s^4-s^3-3*s^2+s+1)": (2, 15)}  # fmt: skip
    for name, value in known.items():
        assert ring(name).zeta_minus_one() == Fraction(*value)
    with pytest.raises(RingError, match="totally real"):
        ring("QQ[s]/(s^3-2)").zeta_minus_one()


def test_out_of_reach() -> None:
    """A large discriminant is refused, with what is missing."""
    with pytest.raises(HFieldError, match="discriminant is too large"):
        ring("QQ(sqrt(1000000007))").class_group()


def test_fields_with_few_small_primes() -> None:
    """Small elements are seldom units there, nor do they have primes below Minkowski's bound."""
    for d, unit in ((17, 4 + 17**0.5), (227, 226 + 15 * 227**0.5), (503, 24648 + 1099 * 503**0.5)):
        K = ring(f"QQ(sqrt({d}))")
        assert K.class_group().order == 1
        assert isclose(float(K.unit_group().regulator.mid()), log(unit))


BY_CYCLES = [
    602,
    623,
    902,
    987,
    1022,
    1055,
    1298,
    1487,
    79,
    17,
    9_997,
    100_010,
    -1,
    -3,
    -5,
    -23,
    -9_995,
    -10_006,
]


@pytest.mark.parametrize("d", BY_CYCLES)
def test_quadratic_fields_by_reduced_ideals(d: int) -> None:
    """Groups and regulators are PARI's; an ideal is its factors; a power of it is principal."""
    pari = pytest.importorskip("cypari").pari
    K = ring(f"QQ(sqrt({d}))")
    C, D = K.class_group(), int(K.discriminant())
    assert C.invariants == tuple(sorted(map(int, pari(f"quadclassunit({D})")[1])))
    if d > 0:
        wanted = float(pari(f"quadregulator({D})"))
        assert isclose(float(K.unit_group().regulator.mid()), wanted, rel_tol=1e-9)
    for P in (P for p in (2, 3, 5, 7) for P in K.primes_above(p)):
        x, exponents = C.factors(K.ideal(P))
        found = K.ideal(x)
        for k, e in zip(C.evidence["S"], exponents, strict=True):
            listed = [Q for p, _ in C.evidence["primes"] for Q in K.primes_above(p)]
            found = found * K.ideal(listed[k]) ** e
        assert found == K.ideal(P)
        a = K.ideal(P) ** C.order
        assert K.ideal(a.is_principal().generator) == a


@pytest.mark.parametrize("d", [-99_003, 80_005, -10_010])
def test_numbers_of_quadratic_fields_are_computed_when_they_are_needed(d: int) -> None:
    """The group asks for none; they have the ideals that are stated, and the group is saturated."""
    K = ring(f"QQ(sqrt({d}))")
    s = s_units(K)
    assert K.class_group().order > 1
    assert not {"generators", "reductions"} & set(vars(s))
    stated = [dict(zip(s.primes, row, strict=True)) for row in s.rows]
    pairs = [*zip(s.generators, stated, strict=True), *s.reductions.values()]
    for x, exponents in pairs:
        powers = [s.frame.prime(s.base[k]) ** e for k, e in exponents.items()]
        assert s.frame.principal(x) == prod(powers, start=s.frame.one)
    known = list(s.generators)
    assert s.saturated
    assert s.generators == known
