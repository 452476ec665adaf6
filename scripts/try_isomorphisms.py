"""Isomorphisms of random algebras over number fields of degree 2 to 8, and maximal orders where they ramify.

    python scripts/try_isomorphisms.py [--pairs 200] [--seed 0] [--only TEXT]

Each pair is an algebra with small coefficients and the same algebra with other constants; the map is
multiplied out. Then an algebra is made that ramifies at a random set of places, and a maximal order of it.
Exit status 1 if one is refused or wrong.
"""

import argparse
import sys
import time
from itertools import islice
from pathlib import Path
from random import Random

sys.path.insert(0, str(Path(__file__).parents[1]))

from hfield import QuaternionAlgebra, ring
from hfield.errors import HFieldError
from tests.fields.quadratic_forms.test_number_field_isomorphisms import check, isomorphic_pair

FIELDS = (
    "QQ(sqrt(5))", "QQ(I)", "QQ(sqrt(-23))", "QQ[s]/(s^3-2)", "QQ[s]/(s^3-s^2-2*s+1)", "QQ[s]/(s^4-5*s^2+5)",
    "QQ(zeta5)", "QQ[s]/(s^5-s-1)", "QQ[s]/(s^6+2*s+2)", "QQ(zeta7)", "QQ[s]/(s^7-s-1)",
    "QQ[s]/(s^8-2*s^7+4*s^5-4*s^4+3*s^2-2*s+1)",
)  # fmt: skip


def ramified(K, rng: Random):
    """Return two or four places, none of them complex."""
    known = [
        v for v in islice(K.places(), 12) if K.completion(v).level.value != 1 or "inf" not in str(v)
    ]
    return rng.sample(known, rng.choice((2, 4)))


def main() -> int:
    """Run and report, a line a field."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pairs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="fields with this text in their name")
    args = parser.parse_args()
    failed = 0
    for name in FIELDS:
        if args.only not in name:
            continue
        K, rng, start, slowest, wrong = ring(name), Random(args.seed), time.process_time(), 0.0, 0
        for n in range(args.pairs):
            begun = time.process_time()
            try:
                check(*isomorphic_pair(K, rng))
                places = ramified(K, rng)
                A = QuaternionAlgebra.from_ramification(K, places)
                assert set(A.ramified_places()) == set(places)
                assert A.maximal_order().discriminant() is not None
            except (HFieldError, ArithmeticError, AssertionError) as error:
                wrong += 1
                print(f"{name}, pair {n}: {type(error).__name__}: {str(error)[:200]}")
            slowest = max(slowest, time.process_time() - begun)
        failed += wrong
        seconds = (time.process_time() - start) / args.pairs
        print(
            f"{name}: {args.pairs - wrong} of {args.pairs}, {seconds:.2f} s each, at most {slowest:.1f} s"
        )
        sys.stdout.flush()
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
