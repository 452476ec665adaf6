"""Graphs on the nonzero elements of a finite algebra, as lists of edges."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import CoercionError, TooLargeError
from hfield.exploring.labels import LabelledAlgebra, labelled

if TYPE_CHECKING:
    import numpy as np

KINDS = ("commuting", "zero-divisors")
MAX_VERTICES = 2500
"""The greatest number of elements of an algebra whose graphs are listed."""


def edges(algebra: Parent, kind: str) -> list[tuple[Quaternion, Quaternion]]:
    """Return the edges (p, q) with p before q: those with ``p·q = q·p``, or those with ``p·q = 0`` or ``q·p =
    0``.

    Raises :class:`CoercionError` for another kind, :class:`NotFiniteError`, and :class:`TooLargeError`.
    """
    labels = labelled(algebra)
    pairs = numbered_edges(labels, kind).tolist()
    elements = [labels.element(n) for n in range(labels.size)]
    return [(elements[x], elements[y]) for x, y in pairs]


def numbered_edges(labels: LabelledAlgebra, kind: str) -> np.ndarray:
    """Return the edges as an array with two columns of element numbers."""
    import numpy as np

    if kind not in KINDS:
        raise CoercionError(f"there is no graph {kind!r}: expected {' or '.join(map(repr, KINDS))}")
    if labels.size > MAX_VERTICES:
        raise TooLargeError(
            f"{labels.algebra} has {labels.size} elements, and graphs are listed for at most {MAX_VERTICES}"
        )
    found = [np.zeros((0, 2), dtype=np.int64)]
    for x in range(1, labels.size):
        later = np.arange(x + 1, labels.size)
        one = np.array([x])
        left, right = labels.products(one, later), labels.products(later, one)
        joined = left == right if kind == "commuting" else (left == 0) | (right == 0)
        ends = later[joined]
        found.append(np.stack([np.full(len(ends), x), ends], axis=1))
    return np.concatenate(found)
