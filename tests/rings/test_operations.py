"""Operations of the rings against trying everything: roots, quotients, squares that add up to −1, copies."""

import copy
import pickle
from fractions import Fraction
from itertools import product

import pytest

from hfield.errors import HFieldError
from hfield.rings import ring

EVERY = (
    *("ZZ", "QQ", "RR", "CC", "QQ(I)", "QQ(sqrt(2))", "QQ(sqrt(-7))", "QQ(sqrt(-3))", "QQ(x)"),
    *("GF(2)", "GF(7)", "GF(4)", "GF(9)", "ZZ/6", "ZZ/12", "GF(5)(t)", "GF(2)(t)", "QQ[x]"),
    *("ZZ[a,b]", "GF(5)[x]", "GF(5)[x,y]", "GF(2)[x,y,z]"),
)


@pytest.mark.parametrize("n", [*range(2, 33), 36, 45, 49, 64, 100])
def test_square_roots_modulo_n(n: int) -> None:
    residues = ring(f"ZZ/{n}")
    squares = {x * x % n for x in range(n)}
    for x in range(n):
        root = residues.sqrt(residues(x))
        assert (root is not None) == (x in squares)
        assert root is None or residues.equal(root * root, residues(x))


@pytest.mark.parametrize("q", [2, 3, 4, 5, 7, 8, 9, 11, 25, 27, 101])
def test_square_roots_in_finite_fields(q: int) -> None:
    field = ring(f"GF({q})")
    squares = {field.key(x * x) for x in field.elements()}
    assert len(squares) == (q + 1) // 2 or q % 2 == 0
    for x in field.elements():
        root = field.sqrt(x)
        assert (root is not None) == (field.key(x) in squares)
        assert root is None or field.equal(root * root, x)


def test_quotients_of_integers() -> None:
    integers = ring("ZZ")
    for x, y in product(range(-7, 8), repeat=2):
        if y and x % y == 0:
            assert integers.divide(integers(x), integers(y)) == x // y
        else:
            with pytest.raises(HFieldError):
                integers.divide(integers(x), integers(y))


@pytest.mark.parametrize(
    "name",
    [
        *("GF(2)", "GF(3)", "GF(5)", "GF(7)", "GF(4)", "GF(9)", "GF(27)", "GF(3)(t)", "GF(5)(t)"),
        *("QQ(I)", "CC", *(f"QQ(sqrt(-{d}))" for d in (2, 3, 5, 6, 7, 10, 11, 13, 14, 15, 19, 23))),
    ],
)
def test_minus_one_as_a_sum_of_as_many_squares_as_the_level(name: str) -> None:
    field = ring(name)
    squares = field.minus_one_as_squares()
    assert field.equal(sum((x * x for x in squares), field.zero), field(-1))
    assert len([x for x in squares if not field.is_zero(x)]) == field.level.value


@pytest.mark.parametrize("name", EVERY)
def test_elements_are_read_back_and_copied(name: str) -> None:
    import random

    R = ring(name)
    rng = random.Random(name)
    for _ in range(6):
        x, y = R.random(rng), R.random(rng)
        for z in (x, x + y, x * y - y, -x):
            assert R.equal(R(R.text(z)), z)
            again = R(pickle.loads(pickle.dumps(R.state(z))))
            assert R.equal(again, z)
        assert R.key(x + y) == R.key(y + x)
        assert R.equal(x * (x + y), x * x + x * y)
        assert R.equal((x + y) * (x - y), x * x - y * y) or not R.equal(x * y, y * x)
    assert copy.deepcopy(R) is R or copy.deepcopy(R) == R
    assert R.characteristic == 0 or R.is_zero(R(R.characteristic))
    assert all(not R.is_zero(R(n)) for n in range(1, R.characteristic))


@pytest.mark.parametrize("text", ["nan", "inf", "infinity", "-inf", "+Infinity", "−NaN", " Inf "])
def test_floats_are_numbers(text: str) -> None:
    with pytest.raises(HFieldError):
        ring("RDF")(text)


def test_numbers_near_a_fraction_are_none() -> None:
    real = ring("RR")
    third = real("1/3")
    for far in ("sqrt(2)/10**12", "sqrt(2)/10**40", "pi/10**30"):
        assert not real.equal(third + real(far), third)
        assert real.sign(real(far)) == 1
    assert real.equal(real("sqrt(2)*sqrt(8)"), real(4))
    assert real.equal(real("(sqrt(2) + sqrt(3))**2 - 5"), real("2*sqrt(6)"))
    assert real(Fraction(1, 3)) == third
