"""Finite fields against galois, an independent implementation; and how values enter them."""

from random import Random

import galois
import numpy as np
import pytest

from hfield.errors import CoercionError, NotInvertibleError, RingError
from hfield.fields import GF, Zmod
from hfield.fields.names import ring
from tests.galois_classes import galois_class
from tests.subcases import share_quick, subcases

FIELDS = ["GF(2)", "GF(7)", "GF(4)", "GF(9)", "GF(9, x^2+1)", "GF(256)"]


def theirs(F):
    """The class of galois for F, made by its own means."""
    if F.degree == 1 or F.is_default:
        return galois_class(F.order)
    return galois_class(F.order, irreducible_poly=F.modulus, primitive_element="x+1", verify=False)


@pytest.mark.parametrize("name", share_quick(FIELDS, 2))
def test_arithmetic_is_that_of_galois(name):
    F = ring(name)
    G = theirs(F)
    rng = Random(name)
    for _ in range(60):
        m, n = rng.randrange(F.order), rng.randrange(F.order)
        x, y, u, v = F.from_label(m), F.from_label(n), G(m), G(n)
        assert F.label(x) == m
        assert F(u) == x
        for ours, their in ((x + y, u + v), (x - y, u - v), (x * y, u * v), (-x, -u)):
            assert F.label(ours) == int(their)
        if n:
            assert F.label(F.divide(x, y)) == int(u / v)
        assert F.label(F.power(x, 12345)) == int(u**12345)


@pytest.mark.parametrize("name", FIELDS)
def test_arrays_are_those_of_galois(name):
    F = ring(name)
    G = theirs(F)
    values = G.Random((3, 4), seed=1)
    a = F.array(values)
    assert a.shape == (3, 4)
    assert np.array_equal(np.asarray(a), np.asarray(values))
    assert np.array_equal(np.asarray(a * a + a), np.asarray(values * values + values))
    assert F.scalar(a[1, 2]) == F(values[1, 2])
    back = F.array([[F.scalar(x) for x in row] for row in a])
    assert np.array_equal(back, a)
    texts = F.array([F.text(F.scalar(x)) for x in a.ravel()])
    assert np.array_equal(texts, a.ravel())


def test_the_default_modulus_is_conways():
    for p, n in [(2, 2), (2, 8), (2, 16), (3, 2), (3, 6), (7, 2), (7, 5)]:
        F = GF(p**n)
        assert F.coefficients == [int(c) for c in galois.conway_poly(p, n).coeffs][::-1]
        assert F.modulus_origin == "Conway"
    assert GF("2^100").modulus_origin == "Conway"
    assert GF("2^500").modulus_origin == "sparse"
    assert GF(9, "x^2+1").modulus_origin == "given"
    assert GF(9).modulus == "x^2+2*x+2"
    assert GF(9, "x^2+1").modulus == "x^2+1"


@pytest.mark.slow
def test_integers_are_multiples_of_one_not_labels():
    F = GF(4)
    assert F(2) == 0
    assert F(3) == F.one
    assert F.text(F.gen) == "x"
    assert F(galois.GF(4)(2)) == F.gen
    assert np.asarray(F.array(np.array([0, 1, 2, 3]))).tolist() == [0, 1, 0, 1]
    assert np.asarray(F.array([0, 1, 2, 3])).tolist() == [0, 1, 0, 1]
    assert np.asarray(F.array(galois.GF(4)([0, 1, 2, 3]))).tolist() == [0, 1, 2, 3]
    assert np.asarray(F.array([galois.GF(4)(2), 2, "x", F.gen])).tolist() == [2, 0, 2, 2]
    assert np.asarray(GF(257).array(np.array([255, 3], dtype=np.uint8))).tolist() == [255, 3]
    assert np.asarray(GF(7).array(np.array([-1, 8], dtype=np.int8))).tolist() == [6, 1]
    assert np.asarray(GF(7).array(np.array([2**64 - 1], dtype=np.uint64))).tolist() == [
        (2**64 - 1) % 7
    ]
    assert np.asarray(GF(7).array(np.array([True, False]))).tolist() == [1, 0]


def test_arrays_of_other_fields_and_kinds_are_refused():
    other = galois_class(9, irreducible_poly="x^2+1", primitive_element="x+1", verify=False)
    with pytest.raises(CoercionError, match=r"x\^2 \+ 1 are not of GF\(9\)"):
        GF(9).array(other([1, 2]))
    with pytest.raises(CoercionError, match=r"are not of GF\(9\)"):
        GF(9).array(galois_class(7)([1, 2]))
    with pytest.raises(CoercionError, match="float64"):
        GF(9).array(np.array([0.5]))
    with pytest.raises(CoercionError):
        GF(9).array([0.5])
    with pytest.raises(CoercionError, match="not one element"):
        GF(7)(galois.GF(7)([1, 2]))
    with pytest.raises(CoercionError, match="the same shape"):
        GF(7).array([[1, 2], [3]])
    with pytest.raises(CoercionError):
        ring("QQ").array(galois.GF(7)([1, 2]))
    same = galois_class(9, irreducible_poly="x^2+2x+2", primitive_element="2x", verify=False)
    assert np.asarray(GF(9).array(same([3, 5]))).tolist() == [3, 5]


def test_large_fields_have_object_arrays():
    for name in ("GF(2^100)", "GF(9223372036854775783)"):
        F = ring(name)
        a = F.array([1, "-1", F.random(Random(1))])
        assert (a * F.array_inverse(a) == F.array(1)).all()
        assert F.array([[1, 2], [3, 4]]).shape == (2, 2)
        assert F.array_units(F.array([0, 1])).tolist() == [False, True]


def test_texts():
    F = GF(9)
    assert [F.text(x) for x in F.elements()] == [
        "0", "1", "2", "x", "x+1", "x+2", "2*x", "2*x+1", "2*x+2",
    ]  # fmt: skip
    y = GF(27)("2*x^2+x+1")
    assert GF(27).text(y, "unicode") == "2·x²+x+1"
    assert GF(27).text(y, "latex") == "2x^{2}+x+1"
    assert F("x^-1") * F.gen == F.one
    assert F("1/x") == F.inverse(F.gen)
    assert F("x^1000") == F.gen ** (1000 % 8)
    assert GF(7)("-1/2") == GF(7)(3)


def test_what_has_no_inverse():
    with pytest.raises(NotInvertibleError, match=r"by 0 in GF\(9\)"):
        GF(9).inverse(GF(9).zero)
    with pytest.raises(NotInvertibleError, match=r"by 4 in ZZ/6: .* times 3 it gives 0"):
        Zmod(6).inverse(Zmod(6)(4))
    with pytest.raises(NotInvertibleError, match="by 0 in ZZ/6"):
        Zmod(6).inverse(Zmod(6)(0))
    assert Zmod(6).annihilator(Zmod(6)(4)) == 3


@subcases(
    ("name", "level"),
    [("GF(2)", 1), ("GF(3)", 2), ("GF(5)", 1), ("GF(7)", 2), ("GF(8)", 1), ("GF(9)", 1),
     ("GF(27)", 2), ("GF(13)", 1), ("GF(343)", 2), ("ZZ/2", 1), ("ZZ/4", 3), ("ZZ/8", 4),
     ("ZZ/6", 2), ("ZZ/5", 1), ("ZZ/12", 3), ("ZZ/10", 1), ("ZZ/1999", 2), ("ZZ/2000", 4)],
)  # fmt: skip
def test_levels(name, level):
    F = ring(name)
    assert F.level.value == level
    assert sum((y * y for y in F.minus_one_as_squares()), F.one) == 0


def test_levels_of_large_residue_rings_are_not_known():
    assert Zmod(10**6).level.value is None
    assert Zmod(10**6).minus_one_as_squares() == ()


def test_elements_are_lazy():
    for name in (
        "GF(100000000000000000039)",
        "GF(100000000000000000039^2)",
        "ZZ/100000000000000000041",
    ):
        elements = ring(name).elements()
        assert [next(elements) for _ in range(3)] == [0, 1, 2] or "^2" in name


def test_a_modulus_may_be_any_object_with_a_text():
    assert GF(9, galois.Poly.Str("x^2+1", field=galois.GF(3))) == GF(9, "x^2+1")
    with pytest.raises(RingError):
        GF(9, [1, 0, 1])
