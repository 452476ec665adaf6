"""How many random cases a test draws: a fifth of them, or all with HFIELD_THOROUGH=1."""

import os
from collections.abc import Sequence
from typing import TypeVar

T = TypeVar("T")

THOROUGH = os.environ.get("HFIELD_THOROUGH", "") not in ("", "0")


def cases(most: int) -> int:
    """Return how many of so many cases to draw."""
    return most if THOROUGH else -(-most // 5)


def part(items: Sequence[T], step: int = 5) -> Sequence[T]:
    """Return every ``step``-th of some cases, or all."""
    return items if THOROUGH else items[::step]
