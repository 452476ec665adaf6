"""Tensor products: against ramification, symbols, and the elements themselves."""

from itertools import combinations, product
from random import Random

import pytest

from hfield import (
    CoercionError,
    H,
    MixedParentsError,
    QuaternionAlgebra,
    RingError,
    UndecidedError,
    ring,
)
from hfield.algebra import brauer
from hfield.algebra.embedding import embedding
from hfield.fields.quadratic_forms.norm_forms.residue_forms import no_zero
from tests.subcases import first_quick, subcases


def over(primes):
    return QuaternionAlgebra.from_ramification("QQ", primes)


PAIRS = list(combinations([(2, 3), (2, 5), (3, 5), (7, "inf"), (), (2, "inf")], 2))


@subcases(("one", "other"), PAIRS)
def test_products_over_the_rationals(one, other):
    A, B = over(one), over(other)
    T = A.tensor(B)
    assert set(T.brauer_class) == set(one) ^ set(other)
    assert T.index == (1 if set(one) == set(other) else 2)
    a, x, y = T.common_slot
    assert x.algebra == A
    assert y.algebra == B
    assert x * x == a
    assert y * y == a
    assert x.trace() == y.trace() == 0


def test_products_elsewhere():
    A = H("GF(7)")
    assert (A.tensor(A).index, A.tensor(A).brauer_class) == (1, ())
    K = ring("QQ(sqrt(5))")
    T = H(K).tensor(QuaternionAlgebra(K, -1, -3))
    assert T.index in (1, 2)
    assert set(T.brauer_class) == set(H(K).ramified_places()) ^ set(T.second.ramified_places())
    R = H("RR").tensor(H("RR"))
    assert R.index == 1
    F = ring("QQ(x,y)")
    T = QuaternionAlgebra(F, "x", "y").tensor(QuaternionAlgebra(F, "x", "y+1"))
    a, x, y = T.common_slot
    assert T.index == 2
    assert x * x == a
    assert y * y == a
    S = QuaternionAlgebra("GF(3)(t)", "t", "t+1").tensor(QuaternionAlgebra("GF(3)(t)", "t", "-1"))
    assert S.index == 2
    assert S.common_slot[1] ** 2 == S.common_slot[0]


def test_what_is_refused():
    with pytest.raises(MixedParentsError):
        H("QQ").tensor(H("GF(3)"))
    with pytest.raises(CoercionError, match="not central simple"):
        H("GF(2)").tensor(H("GF(2)"))


@pytest.mark.parametrize(
    ("one", "other", "index"),
    first_quick(
        [
            ((-1, "x"), (-1, "y"), 2),
            (("x", "y"), ("x", "y"), 1),
            ((-1, "x"), (-3, "y"), 4),
            ((2, "x"), (3, "y"), 4),
            (("x", "y"), ("x+1", "y+1"), 4),
        ],
        2,
    ),
)
def test_the_index_over_functions_of_two_variables(one, other, index):
    T = QuaternionAlgebra("QQ(x,y)", *one).tensor(QuaternionAlgebra("QQ(x,y)", *other))
    assert T.index == index
    if index == 4:
        assert T.common_slot is None
        assert "residue forms" in T.reason


def test_residue_forms_never_deny_a_zero():
    F, rng = ring("QQ(x,y)"), Random(3)
    entries = [F(t) for t in ("1", "-1", "2", "x", "y", "x+1", "x*y", "x-y", "y^2+1")]
    shown = 0
    for _ in range(60):
        form = [rng.choice(entries) * rng.choice((1, -1, 3)) for _ in range(rng.choice((3, 4, 5)))]
        reason = no_zero(F, form)
        shown += reason is not None
        # a form that represents what its last coefficient takes away has a zero
        v = [F(rng.choice(("0", "1", "x", "y-1"))) for _ in form]
        value = sum((c * x * x for c, x in zip(form, v, strict=True)), F.zero)
        if not F.is_zero(value):
            assert no_zero(F, [*form, -value]) is None
    assert shown > 10


def test_slots_exist_over_the_rationals_however_many_places_ramify():
    A, B = over((2, 3, 5, 7, 11, 13)), over((17, 19, 23, 29, 31, "inf"))
    a, x, y = A.tensor(B).common_slot
    assert (x * x, y * y) == (a, a)


@pytest.mark.parametrize(
    "name",
    ["QQ", "QQ(sqrt(5))", "QQ(sqrt(-7))", "QQ[s]/(s^3-s-1)", "GF(2)(t)", "GF(4)(t)", "GF(3)(t)"],
)
def test_slots_of_random_pairs(name):
    """Split, isomorphic and division algebras: a slot of each, without a search that depends on luck."""
    F, rng = ring(name), Random(name)

    def scalar():
        if not F.characteristic:
            return F(rng.randint(-30, 30)) if name == "QQ" else small(F, rng)
        powers = (F.gen**n * F.constant(F.base.random(rng)) for n in range(3))
        return sum(powers, F.zero)

    def algebra():
        while True:
            A = QuaternionAlgebra(F, scalar(), scalar(), 1 if F.characteristic == 2 else 0)
            if A.is_central_simple():
                return A

    for _ in range(5):
        A, B = algebra(), algebra()
        for first, second in ((A, B), (A, A)):
            a, x, y = first.tensor(second).common_slot
            assert (x * x, y * y) == (a, a)
            assert (x.algebra, y.algebra) == (first, second)
            assert x.trace() == y.trace() == 0
            assert x.vector_part
            assert y.vector_part


@pytest.mark.parametrize(
    ("one", "other", "name"),
    [
        ("-4+8*sqrt(5),9-6*sqrt(5)", "-7-3*sqrt(5),-3+sqrt(5)", "QQ(sqrt(5))"),
        ("-1-3*sqrt(5),4+3*sqrt(5)", "-1+2*sqrt(5),-8-2*sqrt(5)", "QQ(sqrt(5))"),
        ("6+3*sqrt(94),1-6*sqrt(94)", "6-3*sqrt(94),-1-3*sqrt(94)", "QQ(sqrt(94))"),
    ],
)
def test_slots_where_signs_leave_few_elements_of_the_first(monkeypatch, one, other, name):
    """Multiples of i, j and k by ordinary integers have no square with the right signs, or few have."""
    monkeypatch.setattr(brauer, "MAX_CANDIDATES", 200)
    A, B = (QuaternionAlgebra.from_text(f"({text}|{name})") for text in (one, other))
    assert set(A.ramified_places()) != set(B.ramified_places())
    for first, second in ((A, B), (B, A)):
        a, x, y = first.tensor(second).common_slot
        assert (x * x, y * y) == (a, a)
        assert (x.algebra, y.algebra) == (first, second)


def test_a_bounded_search_for_slots_says_so(monkeypatch):
    monkeypatch.setattr(brauer, "MAX_CANDIDATES", 0)
    with pytest.raises(UndecidedError, match="a bounded search found none"):
        over((2, 3)).tensor(over((2, 5))).common_slot  # noqa: B018


@pytest.mark.parametrize("name", ["QQ", "QQ(sqrt(5))", "QQ(sqrt(-7))", "QQ[s]/(s^3-s-1)"])
def test_small_integers_are_numbered_each_once(name):
    F, most = ring(name), 4 if ring(name).degree < 3 else 1
    top = ((2 * most + 1) ** F.degree - 1) // 2
    numbered = [F(brauer._numbered(F, n)) for n in range(-top, top + 1)]
    expected = {
        F.key(sum((w * c for w, c in zip(F.integral_basis(), digits, strict=True)), F.zero))
        for digits in product(range(-most, most + 1), repeat=F.degree)
    }
    assert set(map(F.key, numbered)) == expected
    assert len(numbered) == len(expected)


@pytest.mark.parametrize("swapped", [False, True])
def test_where_one_splits_or_both_are_isomorphic_any_slot_serves(swapped):
    for one, other in (
        ("[1,1|GF(2)(t))", "[1,t|GF(2)(t))"),
        ("(1,x|QQ(x,y))", "(x,y|QQ(x,y))"),
        ("(1,1|QQ)", "(-1,-1|QQ)"),
        ("(2,5|Qp(5))", "(3,5|Qp(5))"),  # isomorphic
    ):
        A, B = (QuaternionAlgebra.from_text(text) for text in (one, other))
        T = B.tensor(A) if swapped else A.tensor(B)
        a, x, y = T.common_slot
        assert A.ring.agree((x * x).scalar_part, a)
        assert A.ring.agree((y * y).scalar_part, a)
        if one[0] == "[":
            assert str(a) == "t"


NUMBER_FIELDS = (
    "QQ(sqrt(-7))",
    "QQ(sqrt(3))",
    "QQ[s]/(s^3-s-1)",
    "QQ(sqrt(2),sqrt(3))",
    "QQ[s]/(s^4-s-1)",
)


def small(K, rng):
    """A small integer of a number field, not 0."""
    while True:
        x = sum((w * rng.randint(-4, 4) for w in K.integral_basis()), K(0))
        if not K.is_zero(x):
            return x


@pytest.mark.parametrize("name", NUMBER_FIELDS)
def test_corestriction_and_the_projection_formula(name: str):
    """The corestriction of (x, b) with b in ℚ is (N(x), b)."""
    rng, K = Random(4), ring(name)
    ramified = 0
    for _ in range(12):
        x, b = small(K, rng), rng.choice([-1, 2, 3, -5, 7, -11, 15])
        found = QuaternionAlgebra(K, x, b).corestriction()
        expected = QuaternionAlgebra("QQ", K.norm(x), b)
        assert set(found.brauer_class) == set(expected.ramified_places())
        assert found.algebra.is_isomorphic(expected)
        assert found.index == (2 if expected.is_division_algebra() else 1)
        ramified += found.index == 2
    assert ramified


def test_corestriction_in_two_steps():
    rng = Random(6)
    K, F = ring("QQ(sqrt(2),sqrt(3))"), ring("QQ(sqrt(2))")
    for _ in range(12):
        A = QuaternionAlgebra(K, small(K, rng), small(K, rng))
        step = A.corestriction(F)
        assert set(step.algebra.ramified_places()) == set(step.brauer_class)
        assert step.algebra.corestriction().algebra.is_isomorphic(A.corestriction().algebra)
        x = small(F, rng)  # from F and back it is doubled
        B = QuaternionAlgebra(F, x, -3).change_ring(K)
        assert B.corestriction(F).brauer_class == ()
    A = QuaternionAlgebra(ring("QQ[s]/(s^3-2)"), -1, -3)
    assert A.corestriction().algebra.is_isomorphic(QuaternionAlgebra(-1, -3))  # three times is once


@pytest.mark.parametrize("root", [3, -1])
def test_corestriction_to_a_quadratic_field(root):
    """The corestriction of (x, y) with y in the subfield is (N(x), y), x = a + b·√root."""
    rng = Random(8)
    F = ring("QQ(sqrt(2))")
    K = ring(f"QQ(sqrt(2),sqrt({root}))") if root > 0 else ring("QQ(zeta8)")
    image = embedding(F, K)
    s = K.sqrt(K(root))
    found = set()
    for _ in range(25):
        a, b, y = small(F, rng), small(F, rng), small(F, rng)
        over = QuaternionAlgebra(K, image(a) + image(b) * s, image(y)).corestriction(F)
        places = QuaternionAlgebra(F, a * a - root * b * b, y).ramified_places()
        assert set(over.brauer_class) == set(places)
        found |= set(places)
    assert len(found) > 4


def test_real_places_of_a_generator_with_values_that_are_near():
    F = ring("QQ[s]/(s^2-2000*s+999998)")  # 1000 ± √2
    for b in (-1, -3):
        A = QuaternionAlgebra(F, F.gen - 1000, b)
        assert set(A.corestriction(F).brauer_class) == set(A.ramified_places())


def test_no_corestriction():
    with pytest.raises(RingError, match="number fields"):
        H("GF(7)").corestriction()
    with pytest.raises(CoercionError):
        H("QQ(sqrt(2))").corestriction("QQ(sqrt(3))")
    with pytest.raises(CoercionError, match="central simple"):
        QuaternionAlgebra("QQ(sqrt(2))", 0, 1).corestriction()
