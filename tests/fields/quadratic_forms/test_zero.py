import itertools

import pytest

from hfield.algebra.structure import centre, is_commutative
from hfield.core.product import norm
from hfield.errors import UndecidedError
from hfield.fields.names import ring
from hfield.fields.quadratic_forms import is_division, zero_norm
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import found
from tests.fields.algebra_cases import cases, constants
from tests.subcases import subcases

PANEL = {
    "QQ": True, "RR": True, "CC": False, "GF(2)": False, "GF(3)": False, "GF(4)": False, "GF(5)": False,
    "GF(7)": False, "GF(8)": False, "GF(9)": False, "GF(13)": False, "QQ(sqrt(2))": True, "QQ(I)": False,
    "QQ(sqrt(-7))": True, "QQ(x)": True, "GF(2)(t)": False,
}  # fmt: skip


@subcases(("name", "division"), PANEL.items())
def test_hamilton_over_the_panel(name, division):
    F, c = ring(name), constants(name, -1, 0, -1)
    assert is_division(F, c) == division
    answer = zero_norm(F, c)
    assert bool(answer) != division
    assert answer.reason
    if answer.element is not None:
        assert F.is_zero(norm(c, answer.element))
        assert not all(map(F.is_zero, answer.element))


@subcases("m", [m for m in range(1, 60) if all(m % (p * p) for p in (2, 3, 5, 7))])
def test_hamilton_over_imaginary_quadratic_fields(m):
    name = f"QQ(sqrt({-m}))"
    assert is_division(ring(name), constants(name, -1, 0, -1)) == (m % 8 == 7)


@pytest.mark.parametrize(("a", "b"), [(2, 3), (3, 5), (-1, 3)])
def test_division_algebras_that_gap_calls_split(a, b):
    assert is_division(ring("QQ"), constants("QQ", a, 0, b))


@pytest.mark.parametrize("name", ["GF(2)", "GF(3)", "GF(4)", "GF(5)", "GF(8)", "GF(9)", "GF(7)"])
def test_every_algebra_over_a_finite_field_has_a_zero_norm(name):
    F = ring(name)
    some = list(itertools.islice(F.elements(), 5))
    for a, t, b in itertools.product(some, repeat=3):
        c = constants(name, a, t, b)
        element = zero_norm(F, c).element
        assert element is not None
        assert F.is_zero(norm(c, element))
        assert not is_division(F, c)


@pytest.mark.parametrize(
    "name", ["GF(1000003)", "GF(101^5)", "GF(2^20)", "GF(18446744073709551629)"]
)
def test_large_finite_fields_need_no_search(name):
    F = ring(name)
    for a, t, b in [
        (-1, 0, -1),
        (2, 1, 3),
        (5, 1, -7),
        (F.gen if name == "GF(101^5)" else 3, 0, 2),
    ]:
        assert zero_norm(F, constants(name, a, t, b))


@subcases(
    ("name", "a", "t", "b", "division"),
    [
        ("RR", "-sqrt(2)", 0, -3, True),
        ("RR", "-sqrt(2)", 0, 3, False),
        ("RR", "-1/8", 1, -3, False),
        ("RR", "-1/2", 1, -3, True),
        ("CC", "I", 0, -3, False),
        ("QQ(sqrt(2))", "sqrt(2)", 0, -1, True),
        ("QQ(sqrt(2))", "sqrt(2)", 0, 3, False),
        ("QQ", "3/7", 1, 5, True),
        ("QQ", 0, 1, 7, False),
        ("QQ", 3, 1, 0, False),
        ("QQ", "-1/4", 1, 7, False),
        ("QQ", 10**20 + 39, 0, 10**12 - 10**20 - 39, False),
        ("QQ(x)", "x", 0, "1-x", False),
        ("QQ(x)", "-x", 0, "-1", True),
    ],
)
def test_general_constants(name, a, t, b, division):
    F, c = ring(name), constants(name, a, t, b)
    assert is_division(F, c) == division
    element = zero_norm(F, c).element
    assert (element is None) == division
    if element is not None:
        assert F.is_zero(norm(c, element))


@subcases(
    ("name", "a", "t", "b", "has"),
    [
        ("ZZ", -1, 0, -1, False),
        ("ZZ", 2, 0, 3, False),
        ("ZZ", 5, 1, 25, True),
        ("ZZ/6", -1, 0, -1, True),
        ("ZZ/35", 2, 1, 3, True),
        ("ZZ/9", 2, 0, 2, True),
        ("ZZ[a,b]", "a", 0, "b", False),
        ("ZZ[a,b]", "a", 0, "-a*b^2", True),
        ("ZZ[a,b]", -1, 0, -1, False),
        ("QQ[x,y]", "x", 0, "1-x*y^2", True),
        ("QQ[x]", "x^2-2", 0, "7*x", False),
        ("QQ[x]", "x^2-2", 1, "7-x", False),
        ("GF(3)[x]", "x", 0, "1+x^2", True),
        ("GF(3)[x]", "x", 0, "2+x", False),
        ("GF(5)[x,y]", "x", 0, "y", False),
        ("GF(2)[x,y]", "x", 0, "x*y^2", True),
        ("GF(2)[x,y]", "x", 1, "y", False),
    ],
)
def test_rings_that_are_not_fields(name, a, t, b, has):
    R, c = ring(name), constants(name, a, t, b)
    element = zero_norm(R, c).element
    assert (element is not None) == has
    if element is not None:
        assert R.is_zero(norm(c, element))
        assert not all(map(R.is_zero, element))
    assert not is_division(R, c)


def test_inexact_rings_prove_nothing():
    for question in (zero_norm, is_division):
        with pytest.raises(UndecidedError, match="inexact"):
            question(ring("RDF"), constants("RDF", -1, 0, -1))


def test_a_wrong_element_is_not_believed():
    F, c = ring("QQ"), constants("QQ", -1, 0, -1)
    with pytest.raises(AssertionError, match="norm 0"):
        found(F, c, (F(1), F(1), F(0), F(0)), "m", "r")
    with pytest.raises(AssertionError, match="is 0"):
        found(F, c, (F(0),) * 4, "m", "r")


def test_centres_agree_with_gap():
    for case in cases("finite_counts"):
        F, c = ring(case["ring"]), constants(case["ring"], case["a"], case["t"], case["b"])
        assert is_commutative(F, c) == case["commutative"]
        assert len(centre(F, c)) == case["centre_dim"]


@subcases(
    ("name", "a", "t", "b", "size"),
    [
        ("QQ", -1, 0, -1, 1),
        ("QQ", 0, 0, 0, 2),
        ("ZZ", -1, 0, -1, 1),
        ("ZZ", 0, 0, 0, 2),
        ("ZZ", -1, 2, 5, 1),
        ("ZZ", -1, 2, 0, 2),
        ("GF(2)", 1, 0, 1, 4),
        ("GF(2)", 1, 1, 1, 1),
        ("ZZ/9", -1, 0, -1, 1),
        ("QQ[x,y]", "x", 0, "y", 1),
        ("RR", "sqrt(2)", 1, 0, 1),
        ("CC", "I", 0, -1, 1),
    ],
)
def test_the_centre_commutes_and_is_a_basis(name, a, t, b, size):
    from hfield.core.product import multiply
    from hfield.fields.quadratic_forms.normal_forms import basis_of

    R, c = ring(name), constants(name, a, t, b)
    basis = centre(R, c)
    assert len(basis) == size
    for q in basis:
        for u in basis_of(R):
            assert all(
                R.equal(x, y) for x, y in zip(multiply(c, q, u), multiply(c, u, q), strict=True)
            )


def test_a_centre_that_is_not_free_is_generated():
    found = centre(ring("ZZ/4"), constants("ZZ/4", -1, 0, -1))
    assert [tuple(int(x) for x in q) for q in found] == [
        (1, 0, 0, 0),
        (0, 2, 0, 0),
        (0, 0, 2, 0),
        (0, 0, 0, 2),
    ]


def test_division_without_factoring():
    hard = (2**521 - 1) * (2**607 - 1)  # nobody factors this product here
    F = ring("QQ")
    for a, b in ((-hard, -hard), (3, -hard), (hard**2, 5)):
        c = constants("QQ", a, 0, b)
        answer = zero_norm(F, c)
        assert is_division(F, c) == (answer.element is None)
    undecided = constants("QQ", hard, 0, 4 - 9 * hard)  # split, for 9a + b = 2²
    with pytest.raises(UndecidedError, match="composite"):
        zero_norm(F, undecided)


def test_a_split_quadratic_algebra_is_no_division_algebra_even_if_no_zero_divisor_is_found():
    name = "QQ(sqrt(-14))"
    c = constants(name, "-150-182*sqrt(-14)", 0, "19+183*sqrt(-14)")
    F = ring(name)
    assert not is_division(F, c)
    try:
        element = zero_norm(F, c).element
    except UndecidedError as error:
        assert "ramified nowhere" in str(error)  # noqa: PT017
    else:
        assert element is not None
