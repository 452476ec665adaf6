"""Prove that integers are prime, and recognise powers of primes.

"Prime" means proved prime: by deterministic Miller–Rabin below 2⁸¹ (Sorenson and Webster, Math. Comp. 86,
2017), and above that by the tests of Pocklington and Morrison or by APR-CL, all from FLINT.
"""

from collections.abc import Iterator
from functools import lru_cache
from itertools import count

import flint

from hfield.errors import TooLargeError, UndecidedError, shorten

WORD = 2**63
PROVED_BITS = 1024
"""The longest numbers whose primality is proved (seconds); longer composite ones are still recognised."""

LONGEST_BITS = 8192
"""Longer numbers are neither tested for primality nor factored, beyond small primes."""


def is_probable_prime(n: int) -> bool:
    """Return whether n passes the Baillie–PSW test; if not, n is composite.

    No composite number that passes is known, and below 2⁶⁴ there is none.
    """
    return n > 1 and bool(flint.fmpz(n).is_probable_prime())


def is_prime(n: int) -> bool:
    """Return whether n is prime, with proof. Raises :class:`TooLargeError` if n is too long to decide."""
    if n < 2:
        return False
    return bool(flint.fmpz(n).is_probable_prime()) if n < WORD else _is_long_prime(n)


@lru_cache(maxsize=1024)
def _is_long_prime(n: int) -> bool:
    bits, number = n.bit_length(), flint.fmpz(n)
    if bits > LONGEST_BITS:
        raise TooLargeError(
            f"whether a number of {bits} bits is prime is not tested; at most {LONGEST_BITS} bits are"
        )
    if not number.is_probable_prime():
        return False
    if bits > PROVED_BITS:
        raise TooLargeError(
            f"{shorten(n)}, of {bits} bits, seems to be prime, but primes are proved up to {PROVED_BITS} bits"
        )
    answer = number.is_prime()
    if answer not in (0, 1):
        raise UndecidedError(f"whether {shorten(n)} is prime was not decided")
    return bool(answer)


def primes(below: int | None = None) -> Iterator[int]:
    """Yield the primes, all or those below a bound.

    >>> list(primes(below=20))
    [2, 3, 5, 7, 11, 13, 17, 19]
    """
    return filter(is_prime, count(2) if below is None else range(2, below))


def prime_power(q: int) -> tuple[int, int] | None:
    """Return (p, n) with q = pⁿ and p prime, or None. Raises as :func:`is_prime` does."""
    if q < 2:
        return None
    root, n = power_root(q)
    return (root, n) if is_prime(root) else None


def power_root(n: int) -> tuple[int, int]:
    """Return (r, k) with ``n = rᵏ``, n > 1 and k as large as possible."""
    if not flint.fmpz(n).is_perfect_power():
        return n, 1
    for k in range(n.bit_length(), 1, -1):
        r = int(flint.fmpz(n).root(k))
        if r > 1 and r**k == n:
            return r, k
    raise AssertionError("a perfect power has a root")
