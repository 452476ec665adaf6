"""Compare the rational newforms of class sets with those of PARI: all squarefree D·N up to a bound.

    python scripts/try_rational_newforms.py [BOUND]

Prints how many levels and newforms agree, in a_p for p < 30. Needs cypari.
"""

import sys
from math import gcd

from cypari import pari  # type: ignore[import-untyped, unused-ignore]

from hfield import QuaternionAlgebra
from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime

PRIMES = [p for p in range(2, 30) if is_prime(p)]


def by_pari(level: int) -> list[list[int]]:
    """Return a_p for p < 30 of the newforms of weight 2 with rational coefficients, of trivial character."""
    space = pari.mfinit([level, 2], 0)
    if not pari.mfdim(space):
        return []
    columns = pari.mfsplit(space, 1)[0]
    forms = [pari.mfcoefs(pari.mflinear(space, v), PRIMES[-1]) for v in columns]
    return sorted([int(f[p]) for p in PRIMES] for f in forms)


def main() -> int:
    """Compare, and print the numbers."""
    bound = int(sys.argv[1]) if len(sys.argv) > 1 else 150
    levels = forms = 0
    for level in range(11, bound + 1):
        primes = factorise(level)
        if max(primes.values()) > 1:
            continue
        expected = by_pari(level)
        for d in range(2, level + 1):
            ramified = factorise(d)
            if level % d or len(ramified) % 2 == 0 or gcd(d, level // d) > 1:
                continue
            A = QuaternionAlgebra.from_ramification("QQ", sorted(ramified))
            found = A.eichler_order(level // d).class_set().rational_newforms()
            if sorted([f[p] for p in PRIMES] for f in found) != expected:
                print(f"discriminant {d}, level {level // d}: {found}, and PARI has {expected}")
                return 1
            levels, forms = levels + 1, forms + len(found)
    print(f"{levels} orders and {forms} newforms agree with PARI, levels up to {bound}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
