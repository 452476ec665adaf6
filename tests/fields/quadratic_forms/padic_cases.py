"""Seeded cases of p-adic Hilbert symbols, and PARI, where it is there, as an oracle."""

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

from hfield import ring

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


POLYNOMIALS = (
    "x^3-2",
    "x^4-x-1",
    "x^4+x^3+x^2+x+1",
    "x^3-x^2-2*x+1",
    "x^4+1",
    "x^5-x+1",
    "x^2-x+3",
    "x^6-3",
)
EXTENSIONS = 200


def extension_cases() -> Iterator[tuple[str, Any, Any, Any]]:
    """Two hundred: a polynomial, a prime ideal (half of them above 2), and two numbers of the field."""
    rng = Random(15)
    for n in range(EXTENSIONS):
        text = POLYNOMIALS[n % len(POLYNOMIALS)]
        K = ring(f"QQ[s]/({text.replace('x', 's')})")
        P = rng.choice(K.primes_above(2 if n % 3 else rng.choice((3, 5, 7, 11, 23))))
        a, b = (element(rng, K, P) for _ in range(2))
        yield text, P, a, b


def element(rng: Random, K: Any, P: Any) -> Any:
    x = K.zero
    while K.is_zero(x):
        x = sum((K.gen**m * rng.randint(-20, 20) for m in range(K.degree)), K.zero)
    return x * P.uniformiser ** rng.randint(0, 2) * Fraction(1, rng.choice((1, 1, 2, 3, 4, 5)))


def pari_symbol(oracle: Any, text: str, P: Any, a: Any, b: Any) -> int:
    """Return PARI's nfhilbert(nf, a, b, P), P being given by its generators."""
    nf = oracle(f"nfinit({text})")
    pi, x, y = (oracle(str(u).replace("s", "x")) for u in (P.generators[1], a, b))
    above = [Q for Q in nf.idealprimedec(P.p) if int(nf.idealval(pi, Q)) > 0]
    assert len(above) == 1
    return int(nf.nfhilbert(x, y, above[0]))


def pari() -> Any:
    """Return PARI, or skip the test where it is not installed."""
    import pytest

    cypari = pytest.importorskip("cypari", reason="cypari, an oracle, is not installed")
    return cypari.pari


if __name__ == "__main__":  # writes the vectors; cypari must be installed
    folder, oracle = Path(__file__).parents[2] / "vectors", pari()
    own = [int(oracle(f"hilbert({a},{b},{p})")) for p, a, b in cases()]
    above = [pari_symbol(oracle, *case) for case in extension_cases()]
    for name, symbols in (("padic_symbols", own), ("padic_extension_symbols", above)):
        signs = "".join("+" if s == 1 else "-" for s in symbols)
        rows = (signs[n : n + 100] for n in range(0, len(signs), 100))
        (folder / f"{name}.txt").write_text("\n".join(rows) + "\n", encoding="utf-8")
