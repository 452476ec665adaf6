"""What an order is: its discriminant, level, Eichler symbols, conductor, ternary lattice."""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import cached_property
from itertools import product

from flint import fmpz_mat

from hfield.factorisation import factorise
from hfield.lattices import enumeration, hermite
from hfield.lattices.checked_arguments import natural, prime
from hfield.lattices.modulo_primes import kronecker
from hfield.lattices.normed_lattice import NormedLattice


class OrderInvariants(NormedLattice):
    """The part of an order's methods that need its rows and its norm only."""

    def discriminant(self) -> int:
        """Return the reduced discriminant; for a maximal order it is that of the algebra."""
        return self._discriminant

    @cached_property
    def _discriminant(self) -> int:
        c = self._regular.constants
        volume = abs((c.t * c.t + 4 * c.a) * c.b) * hermite.determinant(self._matrix)
        return int(volume / self._den**4)

    @property
    def level(self) -> int:
        """The index in a maximal order: the reduced discriminant over that of the algebra."""
        return self._discriminant // self._regular.discriminant

    def is_maximal(self) -> bool:
        """Tell whether no larger order contains this one: whether its discriminant is that small."""
        return self._discriminant == self._regular.discriminant

    def is_eichler(self) -> bool:
        """Tell whether this is an intersection of two maximal orders (Voight, section 24.3)."""
        level = self.level
        return math.gcd(level, self._regular.discriminant) == 1 and all(
            self.eichler_symbol(p) == 1 for p in factorise(level)
        )

    def eichler_symbol(self, p: int) -> int | None:
        """Return the Eichler symbol (O | p): 1, 0 or −1; None where the order is M₂(ℤₚ).

        It tells the residue algebra: split, ramified or inert (Voight, definition 24.3.2).
        """
        if self._discriminant % prime(p):
            return None
        # the discriminant of x changes by a square unit, or stays 0, when x changes modulo p
        symbols = {kronecker(self._x_discriminant(x), p) for x in product((0, 1), repeat=4)} - {0}
        return symbols.pop() if symbols else 0

    def _x_discriminant(self, x: tuple[int, ...]) -> int:
        """Return ``tr(q)² − 4·N(q)`` for the element with these coordinates."""
        t, n = self._trace_and_norm(x)
        return t * t - 4 * n

    def _trace_and_norm(self, x: Iterable[int]) -> tuple[int, int]:
        v = list(x)
        gram = self._integral_gram
        norm = sum(v[m] * v[n] * gram[m][n] for m in range(4) for n in range(4)) // 2
        return sum(a * b for a, b in zip(v, self._traces, strict=True)), norm

    @cached_property
    def _integral_gram(self) -> list[list[int]]:
        """The matrix of ``tr(x·conj(y))`` on the basis; the norm of an order is 1."""
        return [list(row) for row in hermite.tuples(self._even)]

    @cached_property
    def _traces(self) -> tuple[int, ...]:
        r = self._regular
        column = (self._matrix * r.form).entries()[::4]
        return tuple(int(x) // (r.scale * self._den) for x in column)

    @cached_property
    def _table(self) -> list[list[tuple[int, ...]]]:
        """The products of the basis in coordinates of the basis."""
        r = self._regular
        m, d = hermite.inverse(self._matrix)
        scale = self._den * r.scale * d
        e = [int(x) // scale for x in (r.products(self._matrix, self._matrix) * m).entries()]
        return [[tuple(e[16 * i + 4 * j : 16 * i + 4 * j + 4]) for j in range(4)] for i in range(4)]

    @cached_property
    def _one(self) -> tuple[int, ...]:
        """The coordinates of 1."""
        found = hermite.coordinates(self._matrix, (self._den, 0, 0, 0))
        return tuple(int(x) for x in found)

    def _from_coordinates(self, x: Iterable[int]) -> list[int]:
        """Return the row, over the denominator of the order, of an element with these coordinates."""
        rows = self.hnf[1]
        v = list(x)
        return [sum(v[m] * rows[m][n] for m in range(4)) for n in range(4)]

    # --- its ternary lattice: elements of trace 0 ----------------------------------------------------

    def conductor(self) -> int:
        """Return the largest f with O = ℤ + f·G for an order G; 1 for a Gorenstein order."""
        _, _, gram = self._ternary
        m, d = hermite.inverse(fmpz_mat(gram))
        # the norm times the discriminant on the trace-0 part of the codifferent (Voight, 24.2)
        form = [[4 * self._discriminant * int(x) // d for x in row] for row in m.tolist()]
        return math.gcd(*(form[r][c] // (2 if r == c else 1) for r in range(3) for c in range(3)))

    @cached_property
    def _ternary(self) -> tuple[int, fmpz_mat, list[list[int]]]:
        """The trace-0 part of ℤ + 2O: a denominator, three rows, and their matrix of tr(x·conj(y))."""
        r, t = self._regular, self._regular.constants.t
        vectors = fmpz_mat([row[1:] for row in self.hnf[1]]).hnf()
        # 2x − tr(x) has the coordinates −t·x₁, 2x₁, 2x₂, 2x₃
        d = t.denominator
        rows = fmpz_mat(
            [
                [-t.numerator * int(vectors[n, 0]), *(2 * d * int(vectors[n, m]) for m in range(3))]
                for n in range(3)
            ]
        )
        den = self._den * d
        scale = r.scale * den * den
        gram = [[int(x) // scale for x in row] for row in r.gram(rows).tolist()]
        return den, rows, gram

    @cached_property
    def _reduced_ternary(self) -> tuple[int, fmpz_mat, list[list[int]]]:
        den, rows, gram = self._ternary
        reduced, steps = fmpz_mat(gram).lll(transform=True, rep="gram")
        return den, steps * rows, [[int(x) for x in row] for row in reduced.tolist()]

    def ternary_theta_series(self, n: int) -> list[int]:
        """Return [r(0), …, r(n)], where r(m) elements of norm m are in the trace-0 part of ℤ + 2O.

        Raises :class:`IndefiniteError`. It is Gross's ternary lattice ("Heights and the special values
        of L-series", 1987).
        """
        self._definite("ternary_theta_series()")
        n = natural(n, "a theta series goes up to")
        counts = enumeration.count_by_length(self._reduced_ternary[2], 2 * n)
        return [counts.get(2 * m, 0) for m in range(n + 1)]
