"""Seeded cases of p-adic Hilbert symbols, and PARI, where it is there, as an oracle."""

from fractions import Fraction
from random import Random
from typing import Any

PRIMES = (2, 2, 2, 3, 5, 7, 11, 13, 97, 10**9 + 7)
COUNT = 1_000


def cases() -> list[tuple[int, Fraction, Fraction]]:
    """A thousand triples p, a, b: small and large numbers, many divisible by p, or with p below."""
    rng, out = Random(20_261_122), []
    for n in range(COUNT):
        p = PRIMES[n % len(PRIMES)]
        a, b = (number(rng, p) for _ in range(2))
        out.append((p, a, b))
    return out


def number(rng: Random, p: int) -> Fraction:
    top = rng.choice((1, -1)) * rng.randint(1, 10 ** rng.choice((1, 3, 30)))
    return Fraction(top, rng.randint(1, 40)) * Fraction(p) ** rng.randint(-3, 3)


def pari() -> Any:
    """Return PARI, or skip the test where it is not installed."""
    import pytest

    cypari = pytest.importorskip("cypari", reason="cypari, an oracle, is not installed")
    return cypari.pari
