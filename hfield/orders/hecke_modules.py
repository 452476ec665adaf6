"""The functions on the ideal classes as a module of Hecke operators, modulo the ideals of the base."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from functools import cached_property
from typing import Any

from flint import fmpz_mat, nmod_mat, nmod_poly

from hfield.orders import brandt
from hfield.orders.classes import Classes, orbits
from hfield.orders.eigensystems import Combination, Module


class ClassFunctions(Module):
    """Forms of weight 2: functions on the classes; ``make`` returns the classes of another level."""

    weight = 2

    def __init__(self, classes: Classes, make: Callable[[Any], Classes]) -> None:
        super().__init__(classes, make)
        self._kinds = orbits(len(classes), classes.central)
        self._of = [self._kinds.index(kind) for kind in range(len(set(self._kinds)))]
        self.narrow = self._modulo_squares()
        self._operators: dict[Any, fmpz_mat] = {}
        self._rows: dict[tuple[Any, int], Counter[int]] = {}

    def _modulo_squares(self) -> list[int]:
        """Return the narrow class of the norm of each point modulo squares, by numbers."""
        narrow = self.classes.keys.narrow
        group, classes = narrow.group, self.classes
        numbers = [classes.norms[n].number for n in self._of]
        known: dict[tuple[int, ...], int] = {}
        out = []
        for number in numbers:
            vector = group.class_of(narrow.ideals[number]) if narrow.order > 1 else ()
            reduced = tuple(
                c % 2 for c, d in zip(vector, group.invariants, strict=False) if d % 2 == 0
            )
            out.append(known.setdefault(reduced, len(known)))
        return out

    def suits(self, p: int) -> bool:
        """Return True, as the operators are integral."""
        return True

    def subspace(self, p: int) -> None:
        """Return None, as functions on the points have trivial character."""

    @cached_property
    def cusp_dimension(self) -> int:
        """The dimension of the cusp forms: functions on the points but for those of the norm alone."""
        return len(self._of) - len(set(self.narrow))

    def operator(self, prime: Any, p: int) -> nmod_mat:
        """Return the Brandt matrix of a prime, on functions on the points."""
        if prime not in self._operators:
            matrix = brandt.prime_power(self.classes, prime, 1)
            if len(self._of) < len(self._kinds):
                rows = matrix.tolist()
                table = [[0] * len(self._of) for _ in self._of]
                for line, n in zip(table, self._of, strict=True):
                    for j, times in enumerate(rows[n]):
                        line[self._kinds[j]] += int(times)
                matrix = fmpz_mat(table)
            self._operators[prime] = matrix
        return nmod_mat(self._operators[prime], p)

    def norm_polynomial(self, T: Combination, p: int) -> nmod_poly:
        """Return the characteristic polynomial of a Hecke operator on functions of the norm alone."""
        size = max(self.narrow) + 1
        entries = [0] * (size * size)
        for kind in range(size):
            i = self.narrow.index(kind)
            for P, c in zip(*T, strict=True):
                for j, times in self.row(P, i, p).items():
                    entries[kind * size + self.narrow[j]] += c * times
        return nmod_mat(size, size, [x % p for x in entries], p).charpoly()

    def row(self, prime: Any, i: int, p: int) -> Counter[int]:
        """Return row i of the Brandt matrix of a prime, on functions on the points."""
        if (prime, i) not in self._rows:
            found: Counter[int] = Counter()
            for j, times in self.classes.neighbours_of(self._of[i], prime).items():
                found[self._kinds[j]] += times
            self._rows[prime, i] = found
        return self._rows[prime, i]

    def exchange_row(self, prime: Any, i: int, p: int) -> dict[int, int]:
        """Return row i of the permutation of the points by the two-sided ideal at a prime."""
        return {self._kinds[self.classes.exchanged(prime)[self._of[i]]]: 1}

    def of_classes(self, classes: Classes) -> ClassFunctions:
        """Return the module of the classes of another level."""
        return ClassFunctions(classes, self.make)
