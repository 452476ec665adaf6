"""Functions on ideal classes with given signs under two-sided ideals, as vectors indexed by orbits."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from hfield.core.lanczos import SparseOperator
from hfield.core.sparse_rows import SparseRows
from hfield.orders.base_values import Prime

if TYPE_CHECKING:
    from hfield.orders.classes import Classes


class SignSpace:
    """The functions f with f(J·I) = sign·f(I) for the two-sided prime ideals J at some primes.

    They are invariant under the ideals of the base. Such a function is determined by its values on one class
    of each orbit; it is 0 on orbits on which the signs contradict one another.
    """

    def __init__(self, classes: Classes, signs: Mapping[Prime, int]) -> None:
        self.classes, self.signs = classes, dict(signs)
        moves = [(moved, 1) for moved in classes.central]
        moves += [(classes.exchanged(P), sign) for P, sign in signs.items()]
        self.first: list[int] = []
        """One class of each orbit."""
        orbit, sign = _orbits(len(classes), moves, self.first)
        self.orbit, self.sign = np.array(orbit, dtype=np.int64), np.array(sign, dtype=np.int64)
        units = classes.units
        whole = math.lcm(*set(units))
        parts = np.array([whole // count for count in units], dtype=np.int64)
        inside = self.sign != 0
        self.weights = np.bincount(
            self.orbit[inside], parts[inside], minlength=len(self.first)
        ).astype(np.int64)

    def __len__(self) -> int:
        return len(self.first)

    def operator(self, rows: SparseRows) -> SparseOperator:
        """Return the Hecke operator with these rows of neighbours, on functions of the space."""
        starts, columns, entries = rows.arrays
        first = np.array(self.first, dtype=np.int64)
        lengths = starts[first + 1] - starts[first]
        k = int(lengths.max(initial=1))
        places = starts[first] + np.arange(k)[:, None]
        inside = np.arange(k)[:, None] < lengths
        places[~inside] = 0
        found = columns[places]
        values = np.where(inside, entries[places] * self.sign[found], 0)
        return SparseOperator(np.where(values != 0, self.orbit[found], 0), values, self.weights)

    def function(self, vector: Sequence[int] | np.ndarray) -> np.ndarray:
        """Return the values on all classes of the function given by a vector."""
        values: np.ndarray = np.asarray(vector)[self.orbit] * self.sign
        return values


def _orbits(
    size: int, moves: Sequence[tuple[Sequence[int], int]], first: list[int]
) -> tuple[list[int], list[int]]:
    """Return the orbit and the sign of each of 0, …, size − 1; the sign is 0 if the signs are contradictory.

    Orbits with signs are numbered in the order of their first elements, which are appended to ``first``.
    """
    orbit, sign = [0] * size, [0] * size
    seen = [False] * size
    for start in range(size):
        if seen[start]:
            continue
        seen[start], sign[start] = True, 1
        some, consistent = [start], True
        for n in some:  # it grows
            for moved, factor in moves:
                m = moved[n]
                if not seen[m]:
                    seen[m], sign[m] = True, sign[n] * factor
                    some.append(m)
                elif sign[m] != sign[n] * factor:
                    consistent = False
        if consistent:
            for n in some:
                orbit[n] = len(first)
            first.append(start)
        else:
            for n in some:
                sign[n] = 0
    return orbit, sign
