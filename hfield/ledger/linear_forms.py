"""The general k-linear form on V = F⁴, and the tuples of basis vectors at which it is looked at.

It is written with one unknown entry for each basis tuple, so that what is said of it is an identity between
polynomials in those entries and in the coordinates of the arguments, with integer coefficients.
"""

from __future__ import annotations

from itertools import product as tuples
from typing import TYPE_CHECKING

from hfield.notation import BASIS

if TYPE_CHECKING:
    import flint

N = len(BASIS)
Tuple = tuple[int, ...]


def all_tuples(k: int) -> tuple[Tuple, ...]:
    """Return the n^k tuples of basis vectors, as indices."""
    return tuple(tuples(range(N), repeat=k))


def constant_tuples(k: int) -> tuple[Tuple, ...]:
    """Return the n tuples that repeat one basis vector: what ``{e_{i_1}}_{i=1}^k`` names."""
    return tuple((n,) * k for n in range(N))


def short_tuples(k: int) -> tuple[Tuple, ...]:
    """Return the tuples in which only k − 1 indices run, and the last stays at e."""
    return tuple((*t, 0) for t in all_tuples(k - 1))


def spoilt_tuples(k: int) -> tuple[Tuple, ...]:
    """Return all tuples but the last one."""
    return all_tuples(k)[:-1]


class Form:
    """The general k-linear form: unknown entries ``h_t`` and arguments ``a1 … ak``, as polynomials.

    ``extra`` names further unknowns wanted in the same polynomial ring.
    """

    def __init__(self, k: int, extra: tuple[str, ...] = ()) -> None:
        from flint import Ordering, fmpz_mpoly_ctx

        self.k = k
        entries = ["h" + "".join(map(str, t)) for t in all_tuples(k)]
        arguments = [f"a{m}_{n}" for m in range(k) for n in range(N)]
        names = (*entries, *arguments, *extra)
        gens = fmpz_mpoly_ctx.get(names, Ordering.lex).gens()
        self.zero = gens[0] - gens[0]
        self.one = self.zero + 1
        self.entry = dict(zip(all_tuples(k), gens, strict=False))
        coordinates = gens[len(entries) :]
        self.arguments = [list(coordinates[N * m : N * m + N]) for m in range(k)]
        self.extra = coordinates[N * k :]

    def __call__(self, *arguments: list[flint.fmpz_mpoly]) -> flint.fmpz_mpoly:
        """Return the value of the form: Σ h_t · Π a_m[t_m], summed over the last index first."""
        values = list(self.entry.values())
        for a in reversed(arguments):
            rows = range(0, len(values), N)
            values = [
                sum((h * u for h, u in zip(values[r : r + N], a, strict=True)), self.zero)
                for r in rows
            ]
        return values[0]

    def at(
        self, slot: int, vector: list[flint.fmpz_mpoly], last: list[flint.fmpz_mpoly]
    ) -> flint.fmpz_mpoly:
        """Return the value with ``vector`` in the slot, ``last`` at the end, general elsewhere."""
        arguments = [*self.arguments[:-1], last]
        arguments[slot] = vector
        return self(*arguments)

    def basis(self, n: int) -> list[flint.fmpz_mpoly]:
        """Return the n-th basis vector."""
        return [self.one if m == n else self.zero for m in range(N)]

    def monomial(self, t: Tuple) -> flint.fmpz_mpoly:
        """Return Π a_m[t_m], which the entry at t stands in front of."""
        term = self.one
        for a, n in zip(self.arguments, t, strict=True):
            term = term * a[n]
        return term
