"""Check hilbert.json by brute force: python3 scripts/vectors/check_hilbert.py

Needs nothing but Python. At the real place and at p <= 13 it looks for x, y, z, not all divisible
by p, with a·x² + b·y² = z²; a, b are first made free of squares of p, and then solutions modulo p²
(modulo 32 for p = 2) lift. All symbols of one pair must multiply to 1 where the file has them all.
"""

from collections import defaultdict
from fractions import Fraction
from functools import cache
from math import prod

from common import read_cases


def reduced(text: str, p: int) -> int:
    """Return an integer in the square class of the text in Q_p, with p-valuation 0 or 1."""
    x = Fraction(text)
    n = x.numerator * x.denominator
    while n % (p * p) == 0:
        n //= p * p
    return n


@cache
def solvable(a: int, b: int, p: int, m: int) -> bool:
    unit_squares = {z * z % m for z in range(m) if z % p}
    squares = {z * z % m for z in range(m)}
    return any(
        (a * x * x + b * y * y) % m in (squares if x % p or y % p else unit_squares)
        for x in range(m)
        for y in range(m)
    )


if __name__ == "__main__":
    good = done = 0
    by_pair: dict[tuple[str, str], dict[object, int]] = defaultdict(dict)
    for case in read_cases("hilbert.json"):
        a, b, p = case["a"], case["b"], case["place"]
        by_pair[a, b][p] = case["value"]
        if p == "inf":
            value = -1 if Fraction(a) < 0 and Fraction(b) < 0 else 1
        elif p <= 13:
            m = 32 if p == 2 else p * p
            value = 1 if solvable(reduced(a, p) % m, reduced(b, p) % m, p, m) else -1
        else:
            continue
        done += 1
        good += value == case["value"]
    full = [values for values in by_pair.values() if "inf" in values]
    print(f"brute force: {good} of {done} agree")
    print(f"product formula: {sum(prod(v.values()) == 1 for v in full)} of {len(full)} pairs")
