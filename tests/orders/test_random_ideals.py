"""Random ideals are equally likely: counted over all choices, and over seeds."""

import random
from collections import Counter
from collections.abc import Callable
from itertools import product
from typing import Any

import pytest

from hfield import QuaternionAlgebra
from hfield.orders.ideals_of_norm import random_ideal


class Chosen(random.Random):
    """Returns given numbers, and stops when there is none left."""

    def __init__(self, numbers: tuple[int, ...]) -> None:
        super().__init__(0)
        self.numbers = iter(numbers)

    def randrange(self, *_: Any) -> int:
        return next(self.numbers)


def order_over_q() -> Any:
    return QuaternionAlgebra(11).maximal_order()


def eichler_order() -> Any:
    return QuaternionAlgebra(11).eichler_order(5)


def order_over_sqrt5() -> Any:
    return QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()


@pytest.mark.parametrize(
    ("make", "n", "modulus", "ideals", "units"),
    [
        (order_over_q, 2, 2, 3, 6),
        (order_over_q, 3, 3, 4, 48),
        (order_over_q, 4, 4, 6, 96),  # 6 · 2⁴ units of M₂(ℤ/4)
        (eichler_order, 3, 3, 4, 48),
        (order_over_sqrt5, 2, 2, 5, 180),  # 2 is inert: GL₂ of the field with four elements
    ],
)
def test_each_choice_of_a_unit_counts_alike(
    make: Callable[[], Any], n: int, modulus: int, ideals: int, units: int
) -> None:
    """Of all vectors those that are units give each ideal equally often."""
    O = make()
    base, counts = O.value.ambient.base, Counter[Any]()
    for vector in product(range(modulus), repeat=O.value.ambient.size):
        try:
            J = random_ideal(O.value, base.integral_ideal(n), Chosen(vector))
        except StopIteration:  # no unit: another vector would be drawn
            continue
        counts[J.hnf] += 1
    assert sorted(counts.values()) == [units // ideals] * ideals


@pytest.mark.parametrize("n", [2, 3, 5, 6])
def test_seeds_draw_all_ideals_alike(n: int) -> None:
    """Pearson's sum of squares over fixed seeds stays below what chance exceeds once in a thousand times."""
    O = order_over_q()
    number = {2: 3, 3: 4, 5: 6, 6: 12}[n]
    counts = Counter(O.random_ideal(n, seed=seed).hnf for seed in range(100 * number))
    assert len(counts) == number
    most = {3: 13.8, 4: 16.3, 6: 20.5, 12: 31.3}[number]
    assert sum((c - 100) ** 2 for c in counts.values()) / 100 < most
