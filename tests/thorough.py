"""How many cases a test takes of many alike.

Of random cases a fifth, all of them with HFIELD_THOROUGH=1. ``quick_part`` thins further in the quick tests.
"""

import os
from collections.abc import Iterable, Sequence
from itertools import cycle, product
from typing import TypeVar

T = TypeVar("T")
U = TypeVar("U")

THOROUGH = os.environ.get("HFIELD_THOROUGH", "") not in ("", "0")
run_all = False  # set by conftest.py under --runslow, before tests are collected


def cases(most: int) -> int:
    """Return how many of so many cases to draw."""
    return most if THOROUGH else -(-most // 5)


def part(items: Sequence[T], step: int = 5) -> Sequence[T]:
    """Return every ``step``-th of some cases, or all."""
    return items if THOROUGH else items[::step]


def quick_part(items: Sequence[T], step: int = 2) -> Sequence[T]:
    """Return every ``step``-th of some cases in the quick tests, all of them under --runslow."""
    return items if THOROUGH or run_all else items[::step]


def pairwise(items: Iterable[T], others: Sequence[U]) -> list[tuple[T, U]]:
    """Return each item with one of the others, which take turns, or with all of them."""
    if THOROUGH:
        return list(product(items, others))
    return list(zip(items, cycle(others), strict=False))
