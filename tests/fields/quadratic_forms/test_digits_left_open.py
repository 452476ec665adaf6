"""What too few digits leave open: decided exactly where all numbers with these digits give one answer."""

from itertools import product
from random import Random

import pytest

from hfield import QuaternionAlgebra, hilbert_symbol, ring
from hfield.errors import UndecidedError
from tests.thorough import cases


def residues(F):
    """All residues, lifted, as sums of a basis."""
    basis = F.residues.over_prime_field()
    assert 2 ** len(basis) == F.residues.order
    total = [F.zero]
    for r in basis:
        total += [x + F(F.residues.lift(r)) for x in total]
    return total


def refinements(F, x, last):
    """All exact numbers in x with all choices of the digits before π^last."""
    start, found = x.precision, [F(x.value)]
    for m in range(start, last):
        found = [y + r * F.uniformiser**m for y in found for r in residues(F)]
    return found


def answer(question):
    """What is said, or None and the text of the error."""
    try:
        return question(), ""
    except UndecidedError as error:
        return None, str(error)


def one(answers):
    """The one answer, or None where there are several."""
    found = set(answers)
    return found.pop() if len(found) == 1 else None


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["Qp(2)", "QQ(I)_(2)", "QQ(sqrt(-3))_(2)", "QQ(sqrt(2))_(2)", "QQ[s]/(s^3-2)_(2, s)"]
)
def test_symbols_and_squares_are_those_of_all_numbers_with_these_digits(name):
    F, rng = ring(name), Random(1)
    digits, most = F.square_digits, 3 if F.residues.order == 2 and F.doubling == 1 else 2
    seen = set()
    for _ in range(cases(200) if most == 3 else 20):
        exact = [F.random(rng) * F.uniformiser ** rng.randint(0, 1) for _ in range(2)]
        if not all(x.has_value for x in exact):
            continue
        a, b = (F.up_to(x, x.valuation() + digits - rng.randint(0, most)) for x in exact)
        if not (a.has_value and b.has_value):
            continue
        if F.residues.order > 2 and a.digits() + b.digits() < digits + 1:
            continue
        all_a, all_b = (refinements(F, x, x.valuation() + digits) for x in (a, b))
        for x, numbers in ((a, all_a), (b, all_b)):
            expected = one(F.is_square(y) for y in numbers)
            assert answer(lambda: F.is_square(x))[0] == expected, x  # noqa: B023
        # 1 + O(4π) are squares, so that every class is met
        expected = one(hilbert_symbol(x, y, None) for x, y in product(all_a, all_b))
        found, error = answer(lambda: hilbert_symbol(a, b, None))  # noqa: B023
        assert found == expected, (a, b)
        assert bool(error) == (found is None)
        seen.add(found)
        A = QuaternionAlgebra(F, a, b)
        assert answer(A.is_division_algebra)[0] == (None if found is None else found < 0)
    assert seen == {1, -1, None}


@pytest.mark.slow
@pytest.mark.parametrize("name", ["GF(2)((t))", "GF(4)((t))", "GF(2)(t)_inf"])
def test_symbols_in_characteristic_2_are_those_of_all_numbers_with_these_digits(name):
    F, rng, seen = ring(name), Random(2), set()
    for _ in range(40):
        a = F.up_to(F.random(rng), 4) / F.uniformiser ** rng.randint(0, 2)
        a = F.up_to(a, rng.randint(0, 1))
        b = F.one + F.uniformiser * F.up_to(F.random(rng), 9)
        pole = max(0, -(a.least_valuation() or 0))
        b = F.up_to(b * F.uniformiser ** rng.randint(0, 1), rng.randint(1, 3))
        if not b.has_value:
            continue
        first = refinements(F, a, 1)
        second = refinements(F, b, b.valuation() + pole + 1)
        if len(first) * len(second) > 300:
            continue
        expected = one(hilbert_symbol(x, y, None) for x, y in product(first, second))
        assert answer(lambda: hilbert_symbol(a, b, None))[0] == expected, (a, b)  # noqa: B023
        seen.add(expected)
    assert seen == {1, -1, None}


def test_the_digits_that_are_named_are_needed_and_those_before_are_not_enough():
    """(u, 3) over ℚ₂ depends on u modulo 4, (u, 2) on u modulo 8, (u, 5) on nothing."""
    F = ring("Qp(2)")
    assert hilbert_symbol(F("1+O(2)"), F(5), 2) == 1
    for unit, other in (("1+O(2)", "1+O(2)"), ("1+O(2)", "1+O(2^2)")):
        found, _ = answer(lambda: hilbert_symbol(F(unit), F(other), 2))  # noqa: B023
        assert found == (None if unit == other else 1)  # (3, 3) = −1
    for b, digits in ((3, 2), (2, 3)):
        for known in range(1, digits):
            with pytest.raises(
                UndecidedError, match=rf"{digits} digits .* {known} are known.*2\^{digits}\)"
            ):
                hilbert_symbol(F.up_to(1, known), F(b), 2)
        assert hilbert_symbol(F.up_to(1, digits), F(b), 2) == 1
    with pytest.raises(UndecidedError, match=r"O\(t\)"):
        hilbert_symbol(ring("GF(2)((t))")("t^-1+O(1)"), ring("GF(2)((t))")("t"), "t")


def test_what_splits_whatever_the_digits_has_no_element_of_norm_0_to_show():
    A = QuaternionAlgebra("Qp(2)", "3+O(2^2)", 5)
    assert not A.is_division_algebra()
    assert A.ramified_places() == ()
    assert A.is_isomorphic(QuaternionAlgebra("Qp(2)", 1, 1))
    assert not A.is_isomorphic(QuaternionAlgebra("Qp(2)", -1, "3+O(2^2)"))
    with pytest.raises(UndecidedError, match="an element of norm 0 depends on 3 digits"):
        A.zero_norm_element()
    # a root of b is one, whatever a is, 0 too
    assert QuaternionAlgebra("Qp(2)", "O(2^3)", 9).zero_norm_element() is not None
    assert not QuaternionAlgebra("Qp(5)", "O(5)", 4).is_division_algebra()
    with pytest.raises(UndecidedError, match="is 0 is not decided"):
        QuaternionAlgebra("Qp(5)", "O(5)", 2).is_division_algebra()


def test_an_algebra_is_isomorphic_to_itself_whatever_its_digits():
    A = QuaternionAlgebra("Qp(2)", "1+O(2)", 3)
    assert A.is_isomorphic(A)
    assert [A.isomorphism(A)(x) for x in A.basis] == list(A.basis)
    with pytest.raises(UndecidedError):
        A.is_isomorphic(QuaternionAlgebra("Qp(2)", "1+O(2)", 3))
