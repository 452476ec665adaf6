"""Equivalent ideals of small norm."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Quaternion
from hfield.errors import UndecidedError
from hfield.primality import is_prime

if TYPE_CHECKING:
    from hfield.lattices.ideal import Ideal

DOUBLINGS = 12
LONGER = 20_000


def to_prime_norm(ideal: Ideal, avoid: frozenset[int]) -> Quaternion:
    """Return c by which an ideal becomes one of the least prime norm not in ``avoid``.

    Raises :class:`IndefiniteError`, and :class:`UndecidedError` when no such norm was found.
    """
    ideal._definite("equivalent_of_prime_norm()")
    for row, m in by_norm(ideal):
        if m not in avoid and is_prime(m):
            found: Quaternion = ideal._element(row).conjugate() / ideal.norm()
            return found
    raise UndecidedError(
        f"no equivalent ideal of prime norm was found among the short elements, in {DOUBLINGS} doublings"
    )


def by_norm(ideal: Ideal) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield elements as rows, and their norms as multiples of the norm of the ideal, by ascending norm."""
    low, high = 0, 2 * ideal._least()
    for _ in range(DOUBLINGS):
        found = sorted((m, row) for row, m in ideal._short(high) if m > low)
        for m, row in found:
            yield row, m
        low, high = high, 2 * high


def longer(ideal: Ideal, rng: random.Random) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield random elements and their norms, as :func:`by_norm` does, of no small subspace.

    All that are short may lie in a plane, where the norms have a common divisor, such as that of ``O·R·n``, R
    a quadratic order and n inert in it.
    """
    rows, gram = ideal._reduced
    for trial in range(LONGER):
        size = 1 + trial // 50
        x = [rng.randint(-size, size) for _ in range(4)]
        norm = sum(gram[m][n] * x[m] * x[n] for m in range(4) for n in range(4)) // 2
        if norm:
            yield tuple(sum(c * int(rows[m, k]) for m, c in enumerate(x)) for k in range(4)), norm
