"""The norms that KLPT accepts for an equivalent ideal: powers of a prime, or divisors of a smooth number.

The algorithm chooses two factors of such a norm, one after the other, each of a given size.
"""

from __future__ import annotations

import heapq
import math
import random
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol


class AllowedNorms(Protocol):
    """The accepted norms of an equivalent ideal, as a source of factors."""

    def above(self, least: int, rng: random.Random) -> Iterator[int]:
        """Yield some allowed norms of at least this size, the first ones close to it."""

    def without(self, n: int) -> AllowedNorms:
        """Return the allowed norms divided by n."""

    def divisible_by(self, n: int) -> bool:
        """Return whether an allowed norm may have the prime factor n."""


SUPPLY = 12


@dataclass(frozen=True)
class Powers:
    """All powers of a prime."""

    prime: int

    def above(self, least: int, rng: random.Random) -> Iterator[int]:
        """Yield powers of at least this size."""
        exponent = math.ceil(max(least, 2).bit_length() / math.log2(self.prime))
        yield from (self.prime**e for e in range(exponent, exponent + SUPPLY))

    def without(self, n: int) -> Powers:
        """Return all powers, as they are never used up."""
        return self

    def divisible_by(self, n: int) -> bool:
        """Return whether n is the prime whose powers are allowed."""
        return n == self.prime


@dataclass(frozen=True)
class Divisors:
    """The divisors of a number, given by its prime factors."""

    factors: tuple[tuple[int, int], ...]

    @property
    def product(self) -> int:
        """The number whose divisors these are."""
        return math.prod(p**e for p, e in self.factors)

    def above(self, least: int, rng: random.Random) -> Iterator[int]:
        """Yield divisors of at least this size; the number itself also if it is slightly smaller."""
        whole = self.product
        if whole < least:
            # the bounds leave some room
            if whole >= least >> 6:
                yield whole
            return
        found = set()
        for k in range(SUPPLY):
            n = self._close_to(min(least << (k // 2), whole), rng)
            if n not in found:
                found.add(n)
                yield n
        if whole not in found:
            yield whole

    def _close_to(self, least: int, rng: random.Random) -> int:
        """Return a divisor of at least some size that falls below it without any one of its primes."""
        primes = [p for p, e in self.factors for _ in range(e)]
        rng.shuffle(primes)
        n, used = 1, []
        for p in primes:
            if n >= least:
                break
            n *= p
            used.append(p)
        for p in sorted(used, reverse=True):
            if n // p >= least:
                n //= p
        return n

    def without(self, n: int) -> Divisors:
        """Return the divisors of the number divided by n."""
        rest = []
        for p, e in self.factors:
            while e and n % p == 0:
                n, e = n // p, e - 1
            if e:
                rest.append((p, e))
        return Divisors(tuple(rest))

    def divisible_by(self, n: int) -> bool:
        """Return whether n is one of the primes."""
        return any(p == n for p, _ in self.factors)

    def ascending(self) -> Iterator[int]:
        """Yield the divisors in ascending order."""
        heap = [(1, 0)]
        while heap:
            n, first = heapq.heappop(heap)
            yield n
            for k in range(first, len(self.factors)):
                p, e = self.factors[k]
                if n % p**e:
                    heapq.heappush(heap, (n * p, k))
