"""Compare the roots of every polynomial of degree at most 2 over all algebras over GF(3) with brute force.

``python -m scripts.roots_by_brute_force --seconds 600`` goes through the 27 algebras in turn, in random order
of polynomials, one of each orbit under left multiplication by units, which does not change the roots. It says
how many it compared, and stops with an error at the first difference.
"""

from argparse import ArgumentParser
from itertools import product
from random import Random
from time import monotonic

from hfield import QuaternionAlgebra, ring
from tests.modules.test_roots_by_brute_force import Everything


def compare(constants: tuple[int, int, int], seconds: float, seed: int) -> None:
    """Compare for one algebra, until all polynomials are seen or the time is over."""
    a, t, b = constants
    A = QuaternionAlgebra(ring("GF(3)"), a, b, t)
    everything = Everything(A)
    elements = everything.elements
    index = {q: n for n, q in enumerate(elements)}
    rows = [[index[u * q] for q in elements] for u in elements if u.is_unit()]
    size, count = len(elements), 0
    order = list(range(1, size**3))
    Random(seed).shuffle(order)
    start = monotonic()
    for number in order:
        n = (number // size**2, number // size % size, number % size)
        if any((row[n[0]], row[n[1]], row[n[2]]) < n for row in rows):
            continue
        if monotonic() - start > seconds:
            print(A, f"t = {t}: {count} orbits compared, out of time", flush=True)
            return
        everything.check(everything.P([elements[k] for k in n]))
        count += 1
    print(A, f"t = {t}: all {count} orbits compared", flush=True)


def main() -> None:
    """Read the arguments and go through the algebras."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=600, help="for all algebras together")
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    for constants in product(range(3), repeat=3):
        compare(constants, args.seconds / 27, args.seed)


if __name__ == "__main__":
    main()
