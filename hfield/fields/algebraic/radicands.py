"""Integers under square roots, modulo squares, without factoring them.

√n₁, √n₂, … are linearly independent over ℚ exactly if no product nᵢ·nⱼ, i ≠ j, is a square (Besicovitch,
1940). This can be tested by greatest common divisors and integer square roots. Factoring makes radicands
small; a factor that cannot be factored stays under the root as it is.
"""

from collections.abc import Iterable
from functools import lru_cache
from math import gcd, isqrt

from hfield.core.factorisation import SIEVED_BITS, coprime_base, factor, remove
from hfield.core.primality import power_root

PROVED_BELOW = 1 << SIEVED_BITS
"""Reduced radicands below are squarefree; greater ones may hide the square of a large prime."""

DIVISOR_BITS = 30
"""Primes of so many bits are sought in long radicands; only their printed form depends on it."""


def reduced(n: int) -> tuple[int, int]:
    """Return (s, f) with n = s²·f, n ≠ 0, where f is squarefree or has a divisor that could not be factored.

    For a square, f = 1.
    """
    root, sign = _exact_root(abs(n)), 1 if n > 0 else -1
    if root is not None:
        return root, sign
    found = factor(n, bits=DIVISOR_BITS)
    parts = list(found.primes.items())
    if found.rest:
        parts.append(power_root(found.rest.value))
    outside, inside = 1, sign
    for p, exponent in parts:
        outside *= p ** (exponent // 2)
        inside *= p ** (exponent % 2)
    return outside, inside


def ratio(m: int, n: int) -> tuple[int, int] | None:
    """Return positive (u, v) with √m = (u/v)·√n, both roots principal; None if m·n is not a square."""
    if (m < 0) != (n < 0):
        return None
    c = gcd(m, n)
    u, v = _exact_root(abs(m) // c), _exact_root(abs(n) // c)
    return None if u is None or v is None else (u, v)


@lru_cache(maxsize=65536)
def product(m: int, n: int) -> tuple[int, int]:
    """Return (c, r) with √m·√n = c·√r, with principal roots: √−2·√−3 = −√6. If m·n is a square, r is 1."""
    c = gcd(m, n)
    m_rest, n_rest = m // c, n // c
    factor = -c if m < 0 and n < 0 else c
    root = m_rest * n_rest
    if is_long((m, n)):
        for part in (abs(m_rest), abs(n_rest)):
            s = _exact_root(part)
            if s is not None:
                factor, root = factor * s, root // part
        if abs(root) < PROVED_BELOW:  # short now: a square that was hidden is found
            s, root = reduced(root)
            factor *= s
    return factor, root


@lru_cache(maxsize=4096)
def independent(radicands: frozenset[int]) -> tuple[int, ...]:
    """Return pairwise coprime non-squares such that, up to squares, each ``|n|`` is a product of some of
    them.

    They are independent modulo squares, so a field automorphism may change the sign of any one of their
    roots.
    """
    base = coprime_base(abs(n) for n in radicands)
    return tuple(b for b in base if _exact_root(b) is None)


def odd(n: int, b: int) -> bool:
    """Return whether the exact power of b, one of the :func:`independent` numbers, that divides n is odd."""
    return n % b == 0 and remove(n, b)[0] % 2 == 1


def is_long(radicands: Iterable[int]) -> bool:
    """Return whether one of the radicands may not be squarefree."""
    for n in radicands:  # noqa: SIM110 (asked after every product: no generator)
        if not -PROVED_BELOW < n < PROVED_BELOW:
            return True
    return False


def _exact_root(n: int) -> int | None:
    """Return the square root of n > 0 if it is an integer; else None."""
    root = isqrt(n)
    return root if root * root == n else None
