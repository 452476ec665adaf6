import itertools
import math
from fractions import Fraction

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from hfield.core.factorisation import factorise, known_primes, remove
from hfield.fields.linear_algebra.lattice_reduction import combination
from hfield.fields.rationals import conics
from hfield.fields.rationals.conics import solve_conic
from hfield.fields.rationals.symbols import hilbert_symbol_q, is_isotropic, ramified_places_q

nonzero = st.integers(-(10**6), 10**6).filter(bool)


@given(nonzero, nonzero, st.integers(1, 50))
def test_conics_with_a_point_are_solved(a, b, d):
    b = Fraction(b, d)
    if ramified_places_q(a, b):
        return
    x, y, z = solve_conic(a, b)
    assert a * x * x + b * y * y == z * z
    assert (x, y, z) != (0, 0, 0)


@given(nonzero, st.integers(1, 10**6), st.integers(1, 10**6))
def test_norms_are_found_to_be_norms(a, u, v):
    b = u * u - a * v * v
    assume(b)
    x, y, z = solve_conic(a, b)
    assert a * x * x + b * y * y == z * z
    assert (x, y, z) != (0, 0, 0)


def test_a_vector_of_value_1_or_minus_1_splits_off():
    """Legendre's lattice has short vectors of value 0 in all cases tried, so this is not met from above."""
    found = set()
    for form in itertools.product(range(-7, 8), repeat=3):
        pairs = itertools.combinations(form, 2)
        prime = math.prod(form) and all(math.gcd(p, q) == 1 for p, q in pairs)
        if not (prime and is_isotropic(list(form)) and all(map(is_squarefree, form))):
            continue
        lattice = conics._lattice(form, tuple(sorted(factorise(f)) for f in form))
        size = abs(math.prod(form))
        for coefficients in itertools.product(range(-2, 3), repeat=3):
            v = combination(coefficients, lattice)
            value = sum(f * x * x for f, x in zip(form, v, strict=True)) // size
            if abs(value) == 1:
                zero = conics._split_off(form, size, lattice, v, value)
                assert any(zero)
                assert sum(f * x * x for f, x in zip(form, zero, strict=True)) == 0
                found.add(value)
    assert found == {1, -1}


def is_squarefree(n: int) -> bool:
    return all(times == 1 for times in factorise(n).values())


def test_large_coefficients_given_their_primes():
    p, q = 2**127 - 1, 2**89 - 1
    pairs = ((p * m, -q * n) for m in range(1, 40) for n in range(1, 40))
    a, b = next((a, b) for a, b in pairs if not ramified_places_q(a, b, [p, q]))
    with known_primes([p, q]):
        x, y, z = solve_conic(a, b)
    assert a * x * x + b * y * y == z * z
    assert (x, y, z) != (0, 0, 0)


def locally_isotropic(form: list[int]) -> bool:
    """The theorem of Hasse and Minkowski, stated place by place."""
    if all(f > 0 for f in form) or all(f < 0 for f in form):
        return False
    for p in {2, *(p for f in form for p in factorise(f))}:
        v, unit = remove(math.prod(form), p)
        square = v % 2 == 0 and (unit % 8 == 1 if p == 2 else pow(unit, (p - 1) // 2, p) == 1)
        hasse = math.prod(hilbert_symbol_q(form[i], form[j], p) for j in range(4) for i in range(j))
        if square and hasse != hilbert_symbol_q(-1, -1, p):
            return False
    return True


@pytest.mark.parametrize("bound", [12, 10**5])
@given(data=st.data())
@settings(max_examples=150, deadline=None)
def test_forms_in_four_variables(bound, data):
    coefficient = st.integers(-bound, bound).filter(bool)
    form = data.draw(st.lists(coefficient, min_size=4, max_size=4))
    assert is_isotropic(form) == locally_isotropic(form)


@given(
    st.lists(nonzero, min_size=1, max_size=3),
    st.lists(st.integers(-50, 50), min_size=4, max_size=4),
)
def test_forms_with_a_zero_are_isotropic(form, zero):
    assume(any(zero[: len(form)]) and zero[-1])
    last = -sum(f * x * x for f, x in zip(form, zero, strict=False))
    assume(last)
    assert is_isotropic([*form, Fraction(last, zero[-1] ** 2)])
    assert is_isotropic([form[0], -form[0] * 49])
    assert not is_isotropic([form[0], -form[0] * 48])
    assert not is_isotropic(form[:1])
