"""Labels of orders: equal exactly for isomorphic orders, and read back."""

import random
from itertools import product

import pytest

from hfield import (
    LatticeError,
    MixedParentsError,
    NotationError,
    QuaternionAlgebra,
    UndecidedError,
    ring,
    ternary_form,
)
from hfield.cli import main
from tests.orders.random_lattices import moved, random_step


def conjugated(O, rng):
    """The order x·O·x⁻¹ for a random x."""
    x = O.algebra(*(rng.randint(-9, 9) for _ in range(3)), rng.randint(1, 9))
    return O.algebra.order_from_basis([x * q * x.inverse() for q in O.basis])


@pytest.mark.parametrize("discriminant", [11, 30, 37])
def test_conjugate_orders_have_one_label(discriminant: int) -> None:
    rng = random.Random(discriminant)
    A = QuaternionAlgebra(discriminant)
    for O in (A.maximal_order(), A.eichler_order(7), A.order(A.lipschitz_order().basis)):
        assert {conjugated(O, rng).label() for _ in range(4)} == {O.label()}


@pytest.mark.parametrize(("discriminant", "level"), [(2, 33), (11, 6), (37, 1), (30, 7), (67, 4)])
def test_a_class_set_has_as_many_labels_as_types(discriminant: int, level: int) -> None:
    C = QuaternionAlgebra(discriminant).eichler_order(level).class_set()
    labels = C.labels()
    assert labels == [O.label() for O in C.left_orders()]
    assert len(set(labels)) == C.type_number
    found = C.types_by_label()
    assert sorted(n for numbers in found.values() for n in numbers) == list(range(len(C)))
    assert all(labels[n] == text for text, numbers in found.items() for n in numbers)
    coefficients = [ternary_form(text).coefficients for text in found]
    assert coefficients == sorted(coefficients)


# On the boundary: all inner products are half the square of a vector, or vectors have one length.
BOUNDARY = list(product((1, 2), (2,), (2, 4), (-2, 2), (-1, 1), (0, 1)))


def test_forms_on_the_boundary_have_one_reduced_form() -> None:
    rng, reduced = random.Random(1), {}
    for coefficients in BOUNDARY:
        try:
            form = ternary_form(coefficients)
        except LatticeError:
            continue
        if not form.is_definite():
            continue
        assert moved(form, random_step(form.ring, rng)).reduced() == form.reduced()
        reduced.setdefault(form.discriminant(), []).append(form)
    pairs = [(f, g) for forms in reduced.values() for f in forms for g in forms[:2]]
    assert 10 < len(pairs)
    for f, g in pairs:
        assert (f.reduced() == g.reduced()) == f.is_equivalent(g)


def test_a_label_is_read_back() -> None:
    for A, level in ((QuaternionAlgebra(11), 3), (QuaternionAlgebra("QQ", -7, -22), 1)):
        for O in A.eichler_order(level).class_set().left_orders():
            P = A.order_from_label(O.label())
            assert P.label() == O.label()
            assert P.isomorphism(O).element is not None
    A = QuaternionAlgebra(6)
    assert A.eichler_order(5).label() == "6.5"
    assert A.order_from_label("6.5") == A.eichler_order(5)
    assert QuaternionAlgebra("QQ", 1, 1).eichler_order(11).label() == "1.11"
    K = ring("QQ[s]/(s-1)")
    assert QuaternionAlgebra(K, -1, -11).maximal_order().label() == "x²+y²+3·z²+y·z"


MISTAKES = [
    (11, "x^2+y^2+*z", NotationError, "character 9"),
    (11, "x^2+y^2+z", NotationError, "not a ternary form"),
    (11, "x^2+y^2-z^2", NotationError, "not positive"),
    (11, "x^2+y^2", NotationError, "degenerate"),
    (11, "x^2+y^2+z^2", MixedParentsError, "discriminant 2, and .* discriminant 11"),
    (11, "6.5", MixedParentsError, "label of an indefinite order"),
    (6, "10.3", MixedParentsError, "discriminant 10"),
    (6, "6.3", LatticeError, "prime 3 in common"),
    (6, "9" * 5000 + ".1", NotationError, "too large to be read"),
    (6, "٦.١", NotationError, "cannot read"),  # digits of another script
]


@pytest.mark.parametrize(("discriminant", "text", "error", "words"), MISTAKES)
def test_what_is_no_label_of_an_order_there(discriminant, text, error, words) -> None:
    with pytest.raises(error, match=words):
        QuaternionAlgebra(discriminant).order_from_label(text)


def test_orders_without_a_label_say_so() -> None:
    for O in (
        QuaternionAlgebra(6).order(["2*i", "2*j"]),
        QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order(),
    ):
        with pytest.raises(UndecidedError, match="not yet given"):
            O.label()


def test_the_command_prints_and_reads_labels(capsys) -> None:
    assert main(["order", "11", "--label", "x^2+y^2+4*z^2+x*z+x*y"]) == 0
    assert "label                  x²+y²+4·z²+x·z+x·y" in capsys.readouterr().out
    assert main(["order", "11", "--label", "6.5"]) == 2
    assert main(["classes", "37"]) == 0
    assert "   1        2  2·x²+2·y²+3·z²+2·y·z+x·z+x·y" in capsys.readouterr().out
