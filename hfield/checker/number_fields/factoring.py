"""The primes of an integer, by trial division."""

from hfield.checker.budget import spend
from hfield.checker.rejection import reject
from hfield.checker.scalars.finite import PROVED_BELOW, is_prime

MAX_TRIAL = 10**6
MAX_BITS = 4096


def factored(n: int) -> dict[int, int]:
    """Return the primes of a positive integer and their exponents. Rejects if trial division is not
    enough.
    """
    found: dict[int, int] = {}
    if n.bit_length() > MAX_BITS:
        reject("a discriminant is too large to be factored here")
    p = 2
    while n > 1:
        proved = p & 1023 == 1 and n < PROVED_BELOW and is_prime(n)
        if p > MAX_TRIAL or p * p > n or proved:
            if not is_prime(n):
                reject(
                    "a discriminant is not factored here: it has two large primes, or too large a one"
                )
            p = n
        spend(1 + n.bit_length() // 64)
        while n % p == 0:
            found[p] = found.get(p, 0) + 1
            n //= p
        p += 1
    return found
