"""Factor integers into proved primes, and report what was not factored.

This is the only module that factors. Small primes, perfect powers, and elliptic curves up to a size that
depends on the number are tried first; a composite number of at most :data:`SIEVED_BITS` is sieved. So the
work is bounded by the length of the number, and the remaining factor is :class:`Unfactored`, not a number.
"""

from collections.abc import Iterable, Mapping
from contextvars import ContextVar
from dataclasses import dataclass
from functools import lru_cache
from math import gcd, isqrt

import flint

from hfield.core.primality import (
    LONGEST_BITS,
    PROVED_BITS,
    WORD,
    is_prime,
    is_probable_prime,
    power_root,
)
from hfield.errors import RingError, UndecidedError, shorten

SIEVED_BITS = 190
"""Composite numbers up to this length are always factored (a second or two for the worst of them)."""

NORM_BITS = 210
"""The same for norms from number fields, which are longer than what was typed by the degree: ten seconds."""

RELATED = 64
"""The bound of both parts of the fractions ``(p − 1)/(q − 1)`` that are tried."""

BASES_PROVE_BITS = 81
"""Up to here the test of Miller and Rabin to 13 bases is a proof."""

SMALL_PRIMES = 3_000
"""How many primes are tried as divisors of a long number."""

# (numbers up to so many bits, prime factors up to so many bits are sought with elliptic curves)
_CURVES = ((512, 48), (1500, 32), (LONGEST_BITS, 24))

Factors = Mapping[int, int] | Iterable[int]


@dataclass(frozen=True)
class Unfactored:
    """A divisor greater than 1 without a known prime: composite, or too long for a primality proof.

    It is deliberately not a number, so arithmetic with it fails.
    """

    value: int

    def __str__(self) -> str:
        bits = self.value.bit_length()
        if bits > LONGEST_BITS:
            return f"{shorten(self.value)} is too long to be factored ({bits} bits)"
        size = f"{shorten(self.value)} has {len(str(self.value))} digits"
        if is_probable_prime(self.value):
            return f"{size} and is not proved prime (primes are, up to {PROVED_BITS} bits)"
        return f"{size}, is composite and has no small factor"


class UnfactoredError(UndecidedError):
    """A decision needs primes that are not known; ``rest`` is the divisor that was not factored.

    >>> issubclass(UnfactoredError, UndecidedError)
    True
    """

    def __init__(self, rest: Unfactored) -> None:
        self.rest = rest
        requested = _asked.get()
        help_ = f"give its primes with {requested}" if requested else "its primes are needed here"
        super().__init__(f"{rest}: {help_}")

    def __reduce__(self) -> tuple[type["UnfactoredError"], tuple[Unfactored]]:
        return UnfactoredError, (self.rest,)


@dataclass(frozen=True)
class Factorisation:
    """``|n| = ∏ pᵉ · rest``: proved primes with exponents, ascending, and the unfactored part, if any."""

    primes: Mapping[int, int]
    rest: Unfactored | None = None

    def complete(self) -> dict[int, int]:
        """Return the primes with their exponents. Raises :class:`UnfactoredError` if the factorisation is
        incomplete.
        """
        if self.rest is not None:
            raise UnfactoredError(self.rest)
        return dict(self.primes)


# --- primes that the user knows ----------------------------------------------------------------

_known: ContextVar[frozenset[int]] = ContextVar("known primes", default=frozenset())
_asked: ContextVar[str] = ContextVar("how to give them", default="")


def known_primes(factors: Factors | None, argument: str = "factors=") -> "_KnownPrimes":
    """Use these primes in all factorisations inside the ``with`` block; errors name ``argument``.

    Raises :class:`RingError` for a number that is not prime.
    """
    return _KnownPrimes(checked_primes(factors) if factors is not None else _NONE, argument)


_NONE: frozenset[int] = frozenset()


class _KnownPrimes:
    """The context manager of known primes; a class, which is faster than a generator."""

    __slots__ = ("argument", "given", "tokens")

    def __init__(self, given: frozenset[int], argument: str) -> None:
        self.given, self.argument = given, argument

    def __enter__(self) -> None:
        self.tokens = (
            _known.set(_known.get() | self.given) if self.given else None,
            _asked.set(_asked.get() or self.argument),
        )

    def __exit__(self, *_: object) -> None:
        known, requested = self.tokens
        if known is not None:
            _known.reset(known)
        _asked.reset(requested)


def checked_primes(factors: Factors) -> frozenset[int]:
    """Return the numbers, each proved prime. Raises :class:`RingError` for a number that is not prime."""
    if isinstance(factors, str) or not isinstance(factors, Iterable):
        raise RingError(
            f"{shorten(repr(factors))} is not a list of prime factors; expected a list such as [2, 11]"
        )
    primes = set()
    for given in factors:
        try:
            p = int(given)
        except (TypeError, ValueError, OverflowError):
            p = 0
        if p != given or not is_prime(p):
            raise RingError(f"{shorten(given)} was given as a prime factor but is not a prime")
        primes.add(p)
    return frozenset(primes)


# --- factorisation -----------------------------------------------------------------------------


def remove(n: int, p: int) -> tuple[int, int]:
    """Return ``(v, u)`` with ``n = pᵛ·u`` and p not dividing u, for n ≠ 0."""
    if p == 2:
        v = (n & -n).bit_length() - 1
        return v, n >> v
    v = 0
    while True:
        quotient, rest = divmod(n, p)
        if rest:
            return v, n
        n, v = quotient, v + 1


def factor(
    n: int, known: Iterable[int] = (), bits: int = 48, sieved: int = SIEVED_BITS
) -> Factorisation:
    """Factor ``|n|``, n ≠ 0, in bounded time; completely if the hard part has at most ``sieved`` bits.

    ``known`` are primes that may divide n; those of :func:`known_primes` are used as well. In longer numbers,
    primes of at most ``bits`` bits are searched for with elliptic curves.
    """
    n = abs(n)
    if n < WORD:
        return Factorisation({int(p): int(e) for p, e in sorted(flint.fmpz(n).factor())})
    return _factor(n, _known.get().union(known), bits, sieved)


def shared_primes(numbers: Iterable[int]) -> frozenset[int]:
    """Return the primes found in any of the numbers, also by greatest common divisors.

    The unfactored part of each number is split by greatest common divisors with the others.
    """
    found: set[int] = set()
    rests = []
    for n in numbers:
        part = factor(n, found)
        found.update(part.primes)
        if part.rest:
            rests.append(part.rest.value)
    for part in map(factor, coprime_base(rests) if len(rests) > 1 else ()):
        found.update(part.primes)
    return frozenset(found)


def coprime_base(numbers: Iterable[int]) -> list[int]:
    """Return pairwise coprime numbers greater than 1 such that the given positive ones are products
    of them.
    """
    base: list[int] = []
    waiting = list(numbers)
    while waiting:
        n = waiting.pop()
        for k, b in enumerate(base):
            c = gcd(n, b)
            if c > 1:
                del base[k]
                waiting += [x for x in (c, b // c, n // c) if x > 1]
                break
        else:
            if n > 1:
                base.append(n)
    return sorted(base)


def factorise(n: int, known: Iterable[int] = (), sieved: int = SIEVED_BITS) -> dict[int, int]:
    """Return the primes of ``|n|``, n ≠ 0, with exponents. Raises :class:`UnfactoredError`."""
    return factor(n, known, sieved=sieved).complete()


@lru_cache(maxsize=512)  # a decision and the construction after it factor the same numbers
def _factor(n: int, known: frozenset[int], bits: int, sieved: int) -> Factorisation:
    primes: dict[int, int] = {}
    rest, found = n, set(known)
    for _ in range(
        3
    ):  # FLINT's numbers are only taken as divisors: after division by them, some primes may remain
        for p in found:
            v, rest = remove(rest, p)
            if v:
                primes[p] = v
        if rest == 1:
            break
        found = _prime_divisors(rest, bits, sieved)
    unfactored = Unfactored(rest) if rest > 1 else None
    return Factorisation(dict(sorted(primes.items())), unfactored)


def _prime_divisors(n: int, bits: int, sieved: int) -> set[int]:
    """Return proved prime divisors of n > 1; the result is empty if none is found."""
    found: set[int] = set()
    waiting = {int(d) for d, _ in flint.fmpz(n).factor(trial_limit=SMALL_PRIMES)}
    while waiting:
        m, _ = power_root(waiting.pop())
        if m.bit_length() > LONGEST_BITS:
            continue
        if is_probable_prime(m):
            if m.bit_length() <= PROVED_BITS and is_prime(m):
                found.add(m)
        else:
            waiting |= {d for d in _divisors(m, bits, sieved) if 1 < d < m}
    return found


@lru_cache(maxsize=1024)  # numbers of one lattice or field share hard divisors
def _divisors(m: int, sought: int, sieved: int) -> set[int]:
    """Return divisors of a composite number that together contain all its primes; possibly only the
    number.
    """
    number, bits = flint.fmpz(m), m.bit_length()
    if bits <= BASES_PROVE_BITS:
        return {int(d) for d, _ in number.factor()}
    d, passes = _powers(m)
    if d == 1 and passes:
        d = _related(m)
    if d > 1:
        return {d, m // d}
    size = next(size for longest, size in _CURVES if bits <= longest)
    size = min(size, bits // 3 + 1) if bits <= sieved else min(size, sought)
    parts = {int(d) for d, _ in number.factor_smooth(size)}
    if len(parts) > 1 or bits > sieved or passes:
        return parts
    return {int(d) for d, _ in number.factor()}


def _related(m: int) -> int:
    """Return a prime p of ``m = p·q`` with ``(p − 1)/(q − 1)`` a fraction of small numbers, else 1.

    Products of two primes that are pseudoprimes to many bases are of this form (Arnault 1995). ``p − 1`` and
    ``q − 1`` are r·t and s·t, where t solves ``r·s·t² + (r + s)·t = m − 1``.
    """
    for r in range(2, RELATED):
        for s in range(1, r):
            square = (r + s) ** 2 + 4 * r * s * (m - 1)
            root = isqrt(square)
            if root * root == square:
                p = (root - r - s) // (2 * s) + 1
                if 1 < p < m and m % p == 0:
                    return p
    return 1


def _powers(m: int) -> tuple[int, bool]:
    """Return a divisor of a composite number (1 if none is found), and whether it is a pseudoprime to base 2.

    The divisor is a common divisor with ``aⁿ − 1`` for small a and ``n = (m − 1)/2ᵏ``. This splits Carmichael
    numbers, and products of primes p and k(p − 1) + 1, a common form of pseudoprimes. FLINT must not be asked
    to factor a pseudoprime to base 2 of more than 81 bits, because its proof of primality, which it tries
    first, does not end.
    """
    twos, odd = remove(m - 1, 2)
    passes = False
    for a in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29) if m.bit_length() <= 2048 else (2,):
        x = pow(a, odd, m)
        passes |= a == 2 and x in (1, m - 1)
        for _ in range(twos + 1):
            d = gcd(x - 1, m)
            if 1 < d < m:
                return d, passes
            x = x * x % m
            passes |= a == 2 and x == m - 1
    return 1, passes
