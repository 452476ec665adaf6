"""Whole numbers: what Hilbert symbols, conics and orders over ℚ need to know of them.

Factorisations come from FLINT and are bounded: a composite number with no small factor that is
longer than :data:`HARD_BITS` is refused with a request for its primes, because a call into FLINT
cannot be interrupted.
"""

from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

import flint

from hfield.errors import CoercionError, RingError, UndecidedError, shorten
from hfield.rings.rational import rational

HARD_BITS = 190
"""Composite numbers up to this length are factored (a second or two for the worst of them)."""

_WORD = 2**63

Factors = Mapping[int, int] | Iterable[int]


def fraction(x: Any) -> Fraction:
    """Turn an int, a Fraction, or a FLINT integer or rational into a Fraction."""
    number = rational(x)
    if number is not None:
        return Fraction(number)
    raise CoercionError(
        f"{shorten(repr(x))} ({type(x).__name__}) is not a rational number: "
        "expected an int, a Fraction, or an element of QQ"
    )


def square_class(x: Any) -> int:
    """Return a nonzero integer equal to the rational x up to a square: numerator · denominator."""
    if type(x) is int:
        n = x
    elif type(x) is flint.fmpq:
        n = int(x.p * x.q)
    else:
        f = fraction(x)
        n = f.numerator * f.denominator
    if not n:
        raise RingError(
            "a Hilbert symbol is defined for nonzero numbers only, and one of these is 0"
        )
    return n


def is_prime(n: int) -> bool:
    """Tell whether n is a prime (a strong test without known counterexample beyond 64 bits)."""
    return n > 1 and bool(flint.fmpz(n).is_probable_prime())


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


def factorise(n: int, known: Factors | None = None) -> dict[int, int]:
    """Return the primes of ``|n|``, n ≠ 0, with their exponents.

    ``known`` are primes that are divided out first (those that do not divide n are ignored).
    Raises :class:`RingError` when one of them is no prime and :class:`UndecidedError` when what
    is left is too hard.
    """
    n = abs(n)
    if known is None and n < _WORD:
        return {int(p): e for p, e in flint.fmpz(n).factor()}
    found: dict[int, int] = {}
    for given in known or ():
        p = int(given)
        if not is_prime(p):
            raise RingError(f"{shorten(given)} was given as a prime factor but is not a prime")
        if p not in found:
            v, n = remove(n, p)
            if v:
                found[p] = v
    if n > 1:
        found.update(_factor(n))
    return found


@lru_cache(maxsize=256)  # a decision and the construction after it ask for the same numbers
def _factor(n: int) -> Mapping[int, int]:
    """Factor n > 1 without help.

    Beyond a machine word the exponents are counted here: flint may list a large prime twice.
    """
    if n < _WORD:
        return {int(p): int(e) for p, e in flint.fmpz(n).factor()}
    found: dict[int, int] = {}
    while n > 1:
        for p in _prime_divisors(flint.fmpz(n)):
            v, n = remove(n, p)
            found[p] = found.get(p, 0) + v
    return found


def _prime_divisors(number: Any) -> list[int]:
    """Return some primes that divide a number, at least one."""
    if int(number).bit_length() <= HARD_BITS or number.is_probable_prime():
        return [int(p) for p, _ in number.factor()]
    primes: list[int] = []
    bits = int(number).bit_length()
    for part, _ in number.factor_smooth(48 if bits < 512 else 32 if bits < 1500 else 24):
        if part.is_probable_prime():
            primes.append(int(part))
        elif int(part).bit_length() <= HARD_BITS:
            primes += [int(p) for p, _ in part.factor()]
        else:
            raise UndecidedError(
                f"{shorten(int(part))} has {len(str(int(part)))} digits, is composite and has no small "
                "factor: give its primes with factors="
            )
    return sorted(set(primes))


def squarefree(n: int, known: Factors | None = None) -> tuple[int, int, list[int]]:
    """Return ``(m, s, primes)`` with ``n = m·s²``, m squarefree, and the primes of m."""
    m, s, primes = (1 if n > 0 else -1), 1, []
    for p, e in factorise(n, known).items():
        s *= p ** (e // 2)
        if e % 2:
            m *= p
            primes.append(p)
    return m, s, sorted(primes)


def sqrt_mod(x: int, p: int) -> int:
    """Return a square root of x modulo the prime p; x must have one."""
    return x % 2 if p == 2 else int(flint.fmpz(x % p).sqrtmod(p))


def crt(residues: Iterable[tuple[int, int]]) -> tuple[int, int]:
    """Return ``(x, m)``: x has the given ``(residue, modulus)`` pairs, the moduli being coprime."""
    x, m = 0, 1
    for r, n in residues:
        x += m * ((r - x) * pow(m, -1, n) % n)
        m *= n
    return x % m, m
