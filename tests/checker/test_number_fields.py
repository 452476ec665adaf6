"""The checker's number fields: what is irreducible, real, a square, a prime ideal, and forged evidence."""

from math import prod
from random import Random
from typing import Any

import pytest
from flint import fmpz_poly

from hfield import NumberField, QuaternionAlgebra, ring
from hfield.checker.anisotropy import is_certified as certifies
from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.number_fields import check_irreducible, cyclotomic, twice_cosine
from hfield.checker.scalars.real_roots import real_roots
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.quadratic_forms.global_field import known_field
from tests.checker import ring_data
from tests.checker.cases import decided
from tests.checker.ring_data import (
    Data,
    generated,
    ideal,
    other,
    read_field,
    root_field,
)
from tests.fields.quadratic_forms.number_field_cases import cases, field
from tests.subcases import share_quick, subcases

FIELDS = [case["polynomial"] for case in cases("number_fields")]


def is_certified(algebra: str, K: NumberField, reason: Any) -> bool:
    return certifies(algebra, K.data, reason)


def accepted(f: list[int]) -> bool:
    try:
        check_irreducible(f, "a field")
    except Rejected:
        return False
    return True


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_irreducible_is_what_flint_does_not_factor(seed: int) -> None:
    """Products are never let pass; nor is much else rejected."""
    rng, seen = Random(seed), {True: 0, False: 0}
    for _ in range(40):
        parts = [
            fmpz_poly([rng.randint(-9, 9) for _ in range(rng.randint(1, 4))] + [1])
            for _ in range(rng.choice((1, 1, 2, 3)))
        ]
        f = prod(parts[1:], start=parts[0])
        _, factors = f.factor()
        irreducible = len(factors) == 1 and factors[0][1] == 1
        if f.degree() > 1:
            assert accepted([int(c) for c in f.coeffs()]) == irreducible
            seen[irreducible] += 1
    assert min(seen.values()) > 5


@pytest.mark.parametrize(
    "polynomial", ["x^4+1", "x^4-10*x^2+1", "x^8-x^4+1", "x^8-40*x^6+352*x^4-960*x^2+576"]
)
def test_irreducible_though_reducible_modulo_every_prime(
    polynomial: str,
) -> None:
    assert read_field(f"QQ[x]/({polynomial})").degree == NumberField(polynomial, "x").degree


@subcases("n", range(3, 40))
def test_cyclotomic_polynomials(n: int) -> None:
    assert cyclotomic(n) == [int(c) for c in fmpz_poly.cyclotomic(n).coeffs()]
    if len(cyclotomic(n)) > 3:
        name = f"QQ(zeta{n})+"
        assert [c.numerator for c in read_field(name).modulus] == twice_cosine(n)
        assert [int(c.p) for c in ring(name).polynomial.coeffs()] == twice_cosine(n)


@pytest.mark.slow
@subcases("polynomial", FIELDS)
def test_signs_are_those_of_the_real_places(polynomial: str) -> None:
    K, checked, rng = field(polynomial), read_field(f"QQ[x]/({polynomial})"), Random(1)
    assert len(real_roots(checked.modulus)) == K.signature[0]
    for _ in range(5):
        x = K.random(rng)
        signs = checked.signs(checked.read(str(x)))
        assert signs == (tuple(v.sign(x) for v in K.real_places()) or (None,))


@pytest.mark.slow
@subcases("polynomial", FIELDS)
def test_arithmetic_and_squares(polynomial: str) -> None:
    K, checked, rng = field(polynomial), read_field(f"QQ[x]/({polynomial})"), Random(2)
    for _ in range(3):
        x, y = K.random(rng), K.random(rng)
        a, b = checked.read(str(x)), checked.read(str(y))
        assert checked.mul(a, b) == checked.read(str(x * y))
        assert checked.add(a, checked.neg(b)) == checked.read(str(x - y))
        if x:
            assert checked.mul(a, checked.inverse(a)) == checked.one
        try:
            square = checked.is_square(a)
        except Rejected:
            continue
        assert square == (K.sqrt(x) is not None)


@pytest.mark.slow
@subcases("polynomial", FIELDS)
def test_levels_are_not_overstated(polynomial: str) -> None:
    K, checked = field(polynomial), read_field(f"QQ[x]/({polynomial})")
    for bound in (1, 2, 3, 4):
        assert not checked.level_above(bound) or K.level.value > bound
    assert checked.level_above(4) == (K.signature[0] > 0)


@pytest.mark.parametrize(
    "polynomial",
    share_quick(["x^3-x^2-2*x-8", *(f for f in FIELDS if field(f).degree < 7)][::4], 4),
)
def test_places_that_ramify_are_certified_and_others_are_not(polynomial: str) -> None:
    """Where ℤ[s] is not maximal, by another generator; and no evidence survives a change of its numbers."""
    K, rng, seen = field(polynomial), Random(polynomial), 0
    arithmetic = known_field(K)
    for _ in range(2):
        a, b = (K.random(rng) for _ in "ab")
        if not (a and b):
            continue
        A = QuaternionAlgebra(K, a, b)
        for P in A.ramified_places():
            if isinstance(P, PrimeIdeal):
                data = next(
                    d for d in arithmetic.evidence(A.constants, [P]) if is_certified(A.name, K, d)
                )
                assert not is_certified(QuaternionAlgebra(K, a, 1).name, K, data)
                assert not is_certified(A.name, K, {**data, "u": data["j"], "j": data["u"]})
                assert not is_certified(A.name, K, {**data, "j": data["u"]})
                others = [Q for p in (2, 5) for Q in K.primes_above(p)]
                for Q in others:
                    if Q not in A.ramified_places():
                        assert not is_certified(A.name, K, {**data, "place": Q.data})
                seen += 1
    assert seen


CUBE, QUARTIC = generated([-2, 0, 0, 1]), generated([4, 0, -16, 0, 1])


@subcases(
    ("field", "place", "why"),
    [
        (CUBE, ideal(4, 0, 1, 0), "not a prime"),
        (CUBE, ideal(5, 0, 1, 0), "not a prime ideal"),
        (CUBE, ideal(5), "reducible"),
        (
            generated([-8, -2, -1, 1]),
            ideal(2, 0, 1, 0),
            "not a valuation ring|not a prime ideal|reducible",
        ),
        (generated(["-9/2", 0, 1]), ideal(2, 0, 1), "not integral"),
        (CUBE, ideal(2, 2, 0, 0), "needs a polynomial"),  # s³
        (QUARTIC, ideal(2, 0, 1, 0, 0), "not a valuation ring"),
        (QUARTIC, other(2, [0, 1], [0, 1, 0, 0]), "not a valuation ring"),
        (QUARTIC, other(2, [0, 1], [0, 0, 1, 0]), "does not generate"),
        (QUARTIC, other(2, [0, 1], [0, "1/4", 0, 0]), "not integral|is integral"),
        (CUBE, other(2, [1, 1], [0, 1, 0]), "not a prime ideal"),
    ],
)
def test_what_is_no_place_is_rejected(field: Data, place: Data, why: str) -> None:
    with pytest.raises(Rejected, match=why):
        read_ring(field).place(place)


@subcases(
    "data",
    [
        *(generated(f) for f in ([-4, 0, 0, 0, 1], [-2, 0, 0, 2], [1], ["t", 0, 1], [1, 0, 1, 0])),
        *(root_field(4, 4), root_field(-4, 4), generated([1, 0, 1], "i"), ring_data.cyclotomic(2)),
        *({"kind": "field of numbers", "numbers": ["root(2,3)", "zeta3"]}, ring_data.cyclotomic([5, 7])),
    ],
)  # fmt: skip
def test_what_is_no_field_here_is_rejected(data: Data) -> None:
    with pytest.raises(Rejected):
        read_ring(data)


@pytest.mark.parametrize(
    ("statement", "name", "algebra", "verdict"),
    [
        ("norm(q) == 0 => q == 0", "QQ[x]/(x^3-2)", "(-1,-1|QQ[x]/(x^3-2))", "proved"),
        ("p*q == 0 => p == 0 or q == 0", "QQ[x]/(x^3-2)", "(x,5|QQ[x]/(x^3-2))", "proved"),
        ("exists q: norm(q) == 0 and q != 0", "QQ(zeta5)", "(-1,-1|QQ(zeta5))", "proved"),
        ("norm(q) == 0 => q == 0", "QQ(zeta7)", "(-1,-1|QQ(zeta7))", "proved"),
        ("p*q == 0 => p == 0 or q == 0", "QQ(zeta5)", "(zeta5,2+zeta5|QQ(zeta5))", "refuted"),
        ("s*s + x*x + y*y + z*z == 0 => x == 0", "QQ(zeta7)", "(-1,-1|QQ(zeta7))", "proved"),
        ("p*q == q*p", "QQ(root(2,3))", "(-1,-1|QQ(root(2,3)))", "refuted"),
        ("norm(q) == 0 => q == 0", "QQ(sqrt(2),sqrt(3))", "(-1,-1|QQ(sqrt(2),sqrt(3)))", "proved"),
    ],
)
def test_certificates_are_accepted(statement: str, name: str, algebra: str, verdict: str) -> None:
    data = decided(statement, name, algebra)
    assert check(data).verdict == data["verdict"] == verdict
    assert data["assumes"] == []
