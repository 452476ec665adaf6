"""Generators of random right ideals; scripts/try_ideal_generators.py tries many more."""

import random
from typing import Any

import pytest

from hfield import QuaternionAlgebra, ring
from tests.fuchsian.random_ideals import has_positive_generator, ideal, trial


def over(field: str, *places: int, prime: int | None = None) -> Any:
    K = ring(field)
    chosen = [K.real_places()[n] for n in places]
    chosen += K.primes_above(prime)[:1] if prime else ()
    return QuaternionAlgebra.from_ramification(K, chosen).maximal_order()


def test_over_the_rationals_all_are_principal() -> None:
    rng = random.Random(2)
    for primes, level in (([2, 3], 1), ([], 30), ([5, 7], 4), ([2, 3, 5, 7], 1)):
        A = QuaternionAlgebra.from_ramification("QQ", primes) if primes else None
        order = (A or QuaternionAlgebra("QQ", 1, 1)).eichler_order(level)
        assert {trial(rng, order) for _ in range(8)} == {"a generator"}


def test_over_fields_those_are_whose_norm_has_a_positive_generator() -> None:
    """ℚ(√10) and ℚ(√15) have two classes."""
    pytest.importorskip("cypari")
    rng = random.Random(3)
    said = [trial(rng, over("QQ[s]/(s^3+s^2-2*s-1)", 0, 1)) for _ in range(2)]
    assert set(said) == {"a generator"}
    said = [trial(rng, over(f"QQ[s]/(s^2-{d})", 0, prime=3)) for d in (10, 15) for _ in range(4)]
    assert set(said) == {"a generator", "not principal, PARI True"}


def test_the_trial_can_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """An answer without an element, or with another one, is a failure."""
    pytest.importorskip("cypari")
    order = over("QQ[s]/(s^2-10)", 0, prime=3)
    rng = random.Random(1)
    some = [ideal(rng, order) for _ in range(6)]
    kinds = {bool(has_positive_generator(order, I.norm())) for I in some}
    assert kinds == {True, False}
    other = some[0].algebra(1)

    class Answer:
        element, reason = None, "nothing was found"

        def __bool__(self) -> bool:
            return True

    monkeypatch.setattr(type(some[0]), "is_principal", lambda _: Answer())
    assert trial(rng, order).startswith("failed: no generator")
    Answer.element = other
    assert "does not generate" in trial(rng, order)


def test_an_element_that_is_short_from_far_away_alone() -> None:
    """Of 20 000 random ideals this one had no generator found, from points that were not far enough."""
    O = QuaternionAlgebra("QQ", 1, 1).eichler_order(252)
    I = O.right_ideal([2823, "3/2*i + 993*j + 288669/2*k", "1/2 + 1/2*i + 2303/2*j + 59803/2*k"])
    assert I.norm() == 2823
    assert O.right_ideal([I.is_principal().element]) == I
