"""Decide membership in ideals, with exact cofactors.

The search runs modulo a prime: the characteristic, or in characteristic 0 a large prime, from which the
coefficients of the cofactors are reconstructed as rational numbers. In both cases the identity
``denominator·target = Σ cofactor·generator`` is verified by multiplying out.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import isqrt, lcm
from typing import TYPE_CHECKING

from flint import Ordering, fmpz_mpoly_ctx

from hfield.errors import TooLargeError
from hfield.prover.clock import UNTIMED, Clock
from hfield.prover.polynomials.groebner import Basis, History, Polynomial

if TYPE_CHECKING:
    import flint


MAX_CHECK = 5_000_000  # products of terms that a verification may take
LARGE_PRIMES = (2**61 - 1, 2**127 - 1, 2**521 - 1)


@dataclass(frozen=True)
class Cofactors:
    """Cofactors with ``denominator·target = Σ factors[n]·generators[n]``, modulo p in characteristic p."""

    factors: tuple[flint.fmpz_mpoly, ...]
    denominator: int


class PolynomialIdeal:
    """An ideal to which generators can be added.

    The polynomials are flint's, over ``context``, all of one characteristic.
    """

    def __init__(
        self,
        variables: int,
        characteristic: int,
        prime: int | None = None,
        clock: Clock = UNTIMED,
    ) -> None:
        self.characteristic = characteristic
        self.basis = Basis(variables, prime or characteristic or LARGE_PRIMES[0], clock)
        names = [f"v{n}" for n in range(variables)]
        self.context = fmpz_mpoly_ctx.get(names, Ordering.degrevlex)
        self.generators: list[flint.fmpz_mpoly] = []
        self._listed: tuple[int, list[flint.fmpz_mpoly]] = (0, [])  # of a basis of that size

    def lift(self, polynomial: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
        """Convert a polynomial in the first variables to this context."""
        first = range(polynomial.context().nvars())
        return polynomial.project_to_context(self.context, dict(zip(first, first, strict=True)))

    def add(self, polynomial: flint.fmpz_mpoly) -> None:
        """Add a generator (an element of ``context``)."""
        self.generators.append(polynomial)
        self.basis.add(self._encode(polynomial))

    def extend(self, polynomials: Iterable[flint.fmpz_mpoly]) -> None:
        """Add several generators."""
        for p in polynomials:
            self.add(p)

    def run(self, steps: int) -> bool:
        """Extend the basis; return whether it is complete."""
        return self.basis.run(steps)

    @property
    def is_everything(self) -> bool:
        """Whether 1 lies in the ideal."""
        return self.basis.has_one

    def cofactors(self, target: flint.fmpz_mpoly) -> Cofactors | None:
        """Return cofactors for ``target`` if the current basis reduces it to 0, else None.

        Raises :class:`TooLargeError` if the time limit is reached.
        """
        rest, history = self.basis.reduce(self._reduced(target))
        if rest:
            return None
        negative = [(n, m, self.basis.p - c) for n, m, c in history]
        return self._verified(target, negative)

    def elements(self) -> list[flint.fmpz_mpoly]:
        """Return the minimal elements of the basis, reduced, as integer polynomials.

        They are reconstructed from residues modulo a prime, so a polynomial is proved to lie in the ideal
        only by its :meth:`cofactors`. Raises :class:`TooLargeError` if the time limit is reached.
        """
        size = len(self.basis.leads)
        if size != self._listed[0]:
            self._listed = size, list(self._minimal())
        return self._listed[1]

    def _minimal(self) -> Iterator[flint.fmpz_mpoly]:
        for _, index in self.basis.active:
            rest, _ = self.basis.reduce(dict(self.basis.tails[index]))
            terms = self._rational({self.basis.leads[index]: 1, **rest})
            if terms is not None:
                yield self.context.from_dict(terms[0])

    def _reduced(self, polynomial: flint.fmpz_mpoly) -> Polynomial:
        p = self.basis.p
        return {m: c % p for m, c in self._encode(polynomial).items() if c % p}

    def _encode(self, polynomial: flint.fmpz_mpoly) -> Polynomial:
        encode = self.basis.monomials.encode
        return {encode(map(int, m)): int(c) for m, c in polynomial.terms()}

    def _verified(self, target: flint.fmpz_mpoly, history: History) -> Cofactors | None:
        """Convert a history to cofactors, and verify them by multiplication."""
        try:
            modular = self.basis.express(history)
        except TooLargeError:
            return None
        parts = [self._rational(f) for f in modular]
        if any(part is None for part in parts):
            return None
        common = lcm(*(part[1] for part in parts if part))
        factors = tuple(
            self.context.from_dict({m: c * (common // part[1]) for m, c in part[0].items()})
            for part in parts
            if part
        )
        if sum(len(f) * len(g) for f, g in zip(factors, self.generators, strict=True)) > MAX_CHECK:
            return None
        total = self.context.constant(0) - common * target
        for f, g in zip(factors, self.generators, strict=True):
            total += f * g
        p = self.characteristic
        if total != 0 and not (p and int(total.content()) % p == 0):
            return None
        return Cofactors(factors, common)

    def _rational(self, f: Polynomial) -> tuple[dict[tuple[int, ...], int], int] | None:
        """Return f as integer coefficients over a denominator, or None."""
        decode, p = self.basis.monomials.decode, self.basis.p
        if self.characteristic:
            half = p // 2
            return {decode(m): c - p if c > half else c for m, c in f.items() if c}, 1
        values = {}
        for m, c in f.items():
            if c:
                fraction = _reconstruct(c, p)
                if fraction is None:
                    return None
                values[decode(m)] = fraction
        common = lcm(*(d for _, d in values.values()))
        return {m: n * (common // d) for m, (n, d) in values.items()}, common


def _reconstruct(c: int, p: int) -> tuple[int, int] | None:
    """Return the fraction with small terms that is congruent to c modulo p (Wang's algorithm), or None."""
    bound = isqrt(p // 2)
    r0, r1, s0, s1 = p, c, 0, 1
    while r1 > bound:
        q = r0 // r1
        r0, r1, s0, s1 = r1, r0 - q * r1, s1, s0 - q * s1
    if s1 == 0 or abs(s1) > bound:
        return None
    return (r1, s1) if s1 > 0 else (-r1, -s1)
