"""Vectors over a ring."""

from collections.abc import Sequence
from typing import Any


def dot(u: Sequence[Any], v: Sequence[Any]) -> Any:
    """Return Σ u[i]·v[i]."""
    total = u[0] * v[0]
    for x, y in zip(u[1:], v[1:], strict=True):
        total = total + x * y
    return total
