"""What a ring may have besides its arithmetic, and what those say that have it not."""

import pytest

from hfield.errors import CoercionError
from hfield.fields.base.ring import WithIntegers
from hfield.fields.names import ring
from tests.subcases import subcases

PLAIN = ["QQ", "ZZ", "ZZ/6", "GF(9)", "RR", "QQ(I)", "QQ[s]/(s^3-2)", "Qp(5)"]


@pytest.mark.parametrize(
    ("name", "below"),
    [("QQ(x)", "QQ"), ("GF(4)(t)", "GF(4)"), ("ZZ[a,b]", "ZZ"), ("GF(5)[x]", "GF(5)")],
)
def test_constants(name, below):
    R = ring(name)
    assert R.constants == ring(below)
    assert R.as_constant(R(3)) == ring(below)(3)
    assert R.as_constant(R(0)) == ring(below)(0)
    assert R.as_constant(R.gen) is None


@pytest.mark.parametrize("name", PLAIN)
def test_other_rings_have_no_constants(name):
    R = ring(name)
    assert R.constants is None
    assert R.as_constant(R(1)) is None


@subcases(
    ("name", "coefficients", "rootless"),
    [
        ("QQ", [-2, 0, 0, 1], True),
        ("QQ", [-8, 0, 0, 1], False),
        ("QQ", [3], True),
        ("QQ", [1, 0, 0], False),  # the leading coefficient is 0
        ("GF(7)", [-3, 0, 1], True),
        ("GF(7)", [-2, 0, 1], False),
        ("GF(7)", [-3, 0, 0, 1], False),  # nobody says so of a cubic
        ("GF(4)", [1, 1, 1], False),
        ("QQ(sqrt(2))", [-3, 0, 1], True),
        ("ZZ/6", [-5, 0, 1], True),
    ],
)
def test_polynomials_without_roots(name, coefficients, rootless):
    R = ring(name)
    assert R.is_rootless([R(c) for c in coefficients]) == rootless


@pytest.mark.parametrize(("name", "degree"), [("QQ", 1), ("QQ(I)", 2), ("QQ(zeta5)", 4)])
def test_fields_with_integers(name, degree):
    F = ring(name)
    assert isinstance(F, WithIntegers)
    assert F.degree == len(F.integral_basis()) == degree
    assert F.integral_basis()[0] == 1


@pytest.mark.parametrize("name", ["ZZ", "GF(9)", "RR", "QQ(x)", "Qp(5)", "QQ(x)[u]/(u^2-x)"])
def test_rings_without_integers(name):
    assert not isinstance(ring(name), WithIntegers)


def test_maps_that_no_text_gives():
    K, L = ring("QQ[s]/(s^2-2)"), ring("QQ(sqrt(2),I)")
    root = L.embed_from(K)(K.gen)
    assert root * root == 2
    assert L.embed_from(ring("QQ(I)"))(ring("QQ(I)").gen) == L("I")
    assert L.embed_from(ring("QQ")) is None
    with pytest.raises(CoercionError, match="no root"):
        L.embed_from(ring("QQ[s]/(s^3-2)"))
    M = ring("QQ[s]/(s^4+1)")
    assert ring("QQ(I)").images_in(M)["I"] ** 2 == -1
    assert ring("QQ(sqrt(2))").images_in(M) == {}
    F = ring("QQ").completion(5)
    assert F.embed_from(ring("QQ"))(ring("QQ")(2)) == F(2)
    with pytest.raises(CoercionError, match="no variable t"):
        ring("GF(3)(t)").images_in(ring("GF(3)"))


def test_numbers_of_no_field_name_a_common_one():
    from hfield.fields.quadratic_forms.global_field import field_named_by

    x, y = (ring(f"QQ(sqrt({d}))").gen for d in (2, 8))
    assert field_named_by(x, y, 3) == ring("QQ(sqrt(2))")
    assert field_named_by(1, "2") is None
