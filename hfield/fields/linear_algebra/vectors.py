"""Vectors over a ring."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hfield.core.product import S


def dot(u: Sequence[S], v: Sequence[S]) -> S:
    """Return Σ u[i]·v[i]."""
    total = u[0] * v[0]
    for x, y in zip(u[1:], v[1:], strict=True):
        total = total + x * y
    return total
