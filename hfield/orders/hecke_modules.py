"""The functions on ideal classes, modulo the ideals of the base, as a module over the Hecke algebra."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable

from flint import fmpz_mat, nmod_mat, nmod_poly

from hfield.core.properties import cached_property
from hfield.orders import brandt
from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.classes import Classes, orbits
from hfield.orders.eigensystems import Combination, Module


class ClassFunctions(Module):
    """Forms of weight 2: functions on the classes; ``make`` returns the classes of another level."""

    weight = 2

    def __init__(self, classes: Classes, make: Callable[[BaseIdeal], Classes]) -> None:
        super().__init__(classes, make)
        self._kinds = orbits(len(classes), classes.central)
        self._of = [self._kinds.index(kind) for kind in range(len(set(self._kinds)))]
        self.narrow = self._modulo_squares()
        self._operators: dict[Prime, list[fmpz_mat]] = {}
        self._rows: dict[tuple[Prime, int], Counter[int]] = {}

    def _modulo_squares(self) -> list[int]:
        """Return the narrow class, modulo squares, of the norm of each point, as a number."""
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

    @cached_property
    def cusp_dimension(self) -> int:
        """The dimension of the cusp forms: functions on the points modulo those that factor through the
        norm.
        """
        return len(self._of) - len(set(self.narrow))

    @cached_property
    def _involution(self) -> list[int]:
        """An exchange of the points that commutes with all Hecke operators at good primes."""
        identity = list(range(len(self._of)))
        for Q in self.ramified if len(identity) > brandt.MAX_UNSPLIT else ():
            moved = [self._exchanged(i, Q) for i in identity]
            if moved != identity:
                return moved
        return identity

    @cached_property
    def _signed(self) -> list[tuple[int, list[int]]]:
        """The two signs under the involution, each with the points that represent functions of this sign."""
        moved = list(enumerate(self._involution))
        even, odd = [i for i, j in moved if i <= j], [i for i, j in moved if i < j]
        return [(1, even), (-1, odd)] if odd else [(1, even)]

    def blocks(self, prime: Prime, p: int) -> list[nmod_mat]:
        """Return the Brandt matrix of a good prime on the functions of each sign under the involution."""
        if prime not in self._operators:
            self._operators[prime] = self._signed_matrices(
                brandt.prime_power(self.classes, prime, 1)
            )
        return [nmod_mat(matrix, p) for matrix in self._operators[prime]]

    def _signed_matrices(self, matrix: fmpz_mat) -> list[fmpz_mat]:
        rows, found = matrix.tolist(), []
        for sign, points in self._signed:
            place = {i: n for n, i in enumerate(points)}
            entries = [0] * (len(points) ** 2)
            for n, i in enumerate(points):
                for j, times in enumerate(rows[self._of[i]]):
                    if times:
                        point = self._kinds[j]
                        other = self._involution[point]
                        first = min(point, other)
                        if first in place:
                            factor = 1 if first == point else sign
                            entries[n * len(points) + place[first]] += factor * int(times)
            found.append(fmpz_mat(len(points), len(points), entries))
        return found

    def expanded(self, block: int, rows: nmod_mat, p: int) -> nmod_mat:
        """Return functions of one sign as rows of values at all points."""
        sign, points = self._signed[block]
        columns, zero = rows.transpose().tolist(), [0] * rows.nrows()
        values = [zero] * len(self._of)
        for i, column in zip(points, columns, strict=True):
            values[self._involution[i]] = [c * sign for c in column]
            values[i] = column
        return nmod_mat(values, p).transpose()

    def norm_polynomial(self, T: Combination, p: int) -> nmod_poly:
        """Return the characteristic polynomial of a Hecke operator on functions that factor through
        the norm.
        """
        size = max(self.narrow) + 1
        entries = [0] * (size * size)
        for kind in range(size):
            i = self.narrow.index(kind)
            for P, c in zip(*T, strict=True):
                for j, times in self.row(P, i, p).items():
                    entries[kind * size + self.narrow[j]] += c * times
        return nmod_mat(size, size, [x % p for x in entries], p).charpoly()

    def row(self, prime: Prime, i: int, p: int) -> Counter[int]:
        """Return row i of the Brandt matrix of a prime, on functions on the points."""
        if (prime, i) not in self._rows:
            found: Counter[int] = Counter()
            for j, times in self.classes.neighbours_of(self._of[i], prime).items():
                found[self._kinds[j]] += times
            self._rows[prime, i] = found
        return self._rows[prime, i]

    def exchange_row(self, prime: Prime, i: int, p: int) -> dict[int, int]:
        """Return row i of the permutation of the points by the two-sided ideal at a prime."""
        return {self._exchanged(i, prime): 1}

    def _exchanged(self, i: int, prime: Prime) -> int:
        return self._kinds[self.classes.exchanged(prime)[self._of[i]]]

    def of_classes(self, classes: Classes) -> ClassFunctions:
        """Return the module of the classes of another level."""
        return ClassFunctions(classes, self.make)
