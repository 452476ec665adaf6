"""Compare roots of polynomials of degree at most 2 over all algebras over a small field with brute force.

``python -m scripts.roots_by_brute_force GF3 --seconds 600`` goes through the algebras (a, t, b), and for
each through all polynomials in random order until its share of the time is over. Over GF(2) and GF(3) one of
each orbit under left multiplication by units is taken, which does not change the roots. It says how many it
compared, and stops with an error at the first difference.
"""

from argparse import ArgumentParser
from itertools import product
from random import Random
from time import monotonic

from hfield import QuaternionAlgebra, ring
from tests.polynomials.test_roots_by_brute_force import Everything


def compare(A: QuaternionAlgebra, seconds: float, seed: int) -> tuple[int, bool]:
    """Return how many polynomials were compared, and whether these are all."""
    everything, rng = Everything(A), Random(seed)
    elements = everything.elements
    size = len(elements)
    rows = []
    if size <= 81:
        index = {q: n for n, q in enumerate(elements)}
        rows = [[index[u * q] for q in elements] for u in elements if u.is_unit()]
    order = list(range(1, size**3)) if size <= 81 else []
    rng.shuffle(order)
    start, count = monotonic(), 0
    for number in order or iter(lambda: rng.randrange(1, size**3), 0):
        if monotonic() - start > seconds:
            return count, False
        n = (number // size**2, number // size % size, number % size)
        if not any((row[n[0]], row[n[1]], row[n[2]]) < n for row in rows):
            everything.check(everything.P([elements[k] for k in n]))
            count += 1
    return count, True


def main() -> None:
    """Read the arguments and go through the algebras."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("field", help="a finite field of at most 5 elements, such as GF3")
    parser.add_argument("--seconds", type=float, default=600, help="for all algebras together")
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    F = ring(args.field)
    algebras = list(product(F.elements(), repeat=3))
    total, whole = 0, 0
    for a, t, b in algebras:
        count, is_all = compare(
            QuaternionAlgebra(F, a, b, t), args.seconds / len(algebras), args.seed
        )
        total, whole = total + count, whole + is_all
    print(
        f"{F.name}: {total} polynomials, no difference; all of {whole} of {len(algebras)} algebras"
    )


if __name__ == "__main__":
    main()
