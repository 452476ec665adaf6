import random

import pytest

from hfield.core.product import norm
from hfield.errors import RingError, UndecidedError
from hfield.fields.function_fields.conics import RamifiedError, solve_conic_functions
from hfield.fields.function_fields.places import FunctionPlace
from hfield.fields.function_fields.residues import ResidueField
from hfield.fields.function_fields.symbols import ramified_places_functions
from hfield.fields.names import ring
from hfield.fields.quadratic_forms import hilbert_symbol, is_division, zero_norm
from hfield.fields.quadratic_forms.normal_forms import discriminant, normal_form
from hfield.fields.quadratic_forms.ramification import place, ramified_places, reduced_discriminant
from tests.fields.algebra_cases import constants
from tests.subcases import slow


@pytest.mark.parametrize(
    ("name", "t"),
    [
        slow("GF(5)(t)", 0),
        ("GF(3)(t)", 1),
        slow("GF(9)(t)", 0),
        ("GF(2)(t)", 1),
        slow("GF(4)(t)", 1),
        slow("GF(8)(t)", "t"),
        slow("QQ(x)", 0),
        slow("QQ(x)", 1),
    ],
)
def test_symbols_and_lattices_agree(name, t):
    """Two ways that share no formula: residues of symbols, and minimising the conic place by place."""
    F = ring(name)
    rng = random.Random(f"{name}{t}")
    for number in range(40):
        a, b = F.random(rng), F.random(rng)
        if number % 3 == 0:  # make b a norm, so that the algebra splits
            u, v = F.random(rng), F.random(rng)
            b = u * u + F(t) * (u * v) - a * v * v
        c = constants(name, a, t, b)
        if F.is_zero(discriminant(F, c)):
            continue
        places = ramified_places_functions(F, normal_form(F, c))
        assert F.base.order is None or len(places) % 2 == 0
        try:
            w, x, y = solve_conic_functions(F, c)
        except RamifiedError as error:
            # or places of ℚ, of a constant division algebra
            bad = [v for v in error.places if isinstance(v, FunctionPlace)]
            assert set(bad) <= set(places)
            assert bool(bad) == bool(places)
        else:
            assert not places
            assert F.is_zero(norm(c, (w, x, y, F.zero)))
            assert not all(map(F.is_zero, (w, x, y)))


@pytest.mark.parametrize(
    ("name", "a", "t", "b", "ramified"),
    [
        ("GF(5)(t)", "2", 0, "t", ["t", "inf"]),
        ("GF(3)(t)", "t", 0, "t+1", ["t+1", "inf"]),
        ("GF(2)(t)", "1", 1, "t", ["t", "inf"]),
        ("GF(4)(t)", "1", 1, "t", []),
        ("GF(4)(t)", "x", 1, "t", ["t", "inf"]),
        ("GF(2)(t)", "1/t", 1, "t+1", ["t", "t+1"]),
        ("QQ(x)", "x", 0, "x-2", ["x", "x-2", "inf"]),
        ("QQ(x)", "2", 0, "3", []),
    ],
)
def test_ramified_places(name, a, t, b, ramified):
    F, c = ring(name), constants(name, a, t, b)
    assert sorted(map(str, ramified_places(F, c))) == sorted(ramified)
    assert is_division(F, c) == (bool(ramified) or (a, b) == ("2", "3"))


def test_constant_algebras_over_the_rationals():
    F = ring("QQ(x)")
    hidden = constants("QQ(x)", "2*(x^2+1)^2", 0, "3*(x^2-3)^2")
    answer = zero_norm(F, hidden)
    assert answer.element is None
    assert answer.places == (2, 3)
    split = constants("QQ(x)", "2*(x^2+1)^2", 0, "-7*(x^2-5)^2")
    element = zero_norm(F, split).element
    assert element is not None
    assert F.is_zero(norm(split, element))


def test_the_discriminant_is_a_polynomial():
    F = ring("GF(5)(t)")
    assert reduced_discriminant(F, constants("GF(5)(t)", "2", 0, "t^3+t")) == F("t^3+t")
    assert reduced_discriminant(F, constants("GF(5)(t)", "1", 0, "t")) == F.one


def test_public_symbol():
    F = ring("GF(5)(t)")
    assert hilbert_symbol(F(2), F.gen, "t") == -1
    assert hilbert_symbol(F(2), F.gen, place(F, "inf")) == -1
    assert hilbert_symbol(F(2), F.gen, "t+1") == 1
    with pytest.raises(RingError, match="not a place"):
        hilbert_symbol(F(2), F.gen, "t^2+1")
    with pytest.raises(RingError, match="nonzero"):
        hilbert_symbol(F(0), F.gen, "t")
    K = ring("GF(2)(t)")
    assert hilbert_symbol(K.one, K.gen, "t") == hilbert_symbol(K.one, K.gen, "inf") == -1
    assert hilbert_symbol(K.zero, K.gen, "t") == hilbert_symbol(K.gen, K.gen, "t") == 1
    with pytest.raises(RingError, match="nonzero"):
        hilbert_symbol(K.gen, K.zero, "t")
    with pytest.raises(UndecidedError, match="not local fields"):
        hilbert_symbol(ring("QQ(x)").gen, 1, "x")


@pytest.mark.parametrize(
    ("name", "modulus"),
    [
        ("GF(5)(t)", "t^3+t+1"),
        ("GF(9)(t)", "t"),
        ("GF(4)(t)", "t^2+t+x"),
        ("GF(2)(t)", "t^4+t+1"),
        ("QQ(x)", "x-3"),
        ("QQ(x)", "x^3-2"),
        ("QQ(x)", "x^4-10*x^2+1"),
    ],
)
def test_roots_in_residue_fields(name, modulus):
    F = ring(name)
    p = F(modulus).num
    kappa = ResidueField(F, p)
    rng = random.Random(1)
    for _ in range(20):
        a, b, y = (kappa.random(rng) for _ in range(3))
        root = kappa.sqrt(kappa.multiply(y, y))
        assert kappa.multiply(root, root) == kappa.multiply(y, y)
        if y != 0:
            assert kappa.multiply(y, kappa.inverse(y)) == kappa.one
        c = (F.zero.num - a - b * y) % p if F.characteristic != 2 else kappa.multiply(b, y) + a
        # a·1² + b·1·y + c·y² has the zero (1, y) up to the choice of c
        root = kappa.quadratic_root(a, b, c)
        if root is not None:
            u, v = root
            assert (a * u * u + b * u * v + c * v * v) % p == 0
            assert u != 0 or v != 0


def test_inseparable_norms_over_function_fields_of_characteristic_two():
    F = ring("GF(4)(t)")
    rng = random.Random(5)
    for _ in range(30):
        c = constants("GF(4)(t)", F.random(rng), 0, F.random(rng))
        element = zero_norm(F, c).element
        assert element is not None
        assert F.is_zero(norm(c, element))
