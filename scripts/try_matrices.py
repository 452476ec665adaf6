"""Random matrices of up to 12 rows over seventeen algebras, compared with flint's over the prime field.

    python scripts/try_matrices.py [--size 12] [--count 3] [--seconds 600] [--seed 0] [--only TEXT]

Ranks, kernels on both sides, echelon forms, solutions, inverses and reduced norms of so many matrices of each
size. One line an algebra, with the seconds and what failed. Exit status 1 if anything did.
"""

import argparse
import sys
import time
from pathlib import Path
from random import Random

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.matrices.matrix_checks import ALGEBRAS, Case


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=12)
    parser.add_argument("--count", type=int, default=3, help="matrices of each size")
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="algebras whose text has this in it")
    args = parser.parse_args()
    rng, end, bad = Random(args.seed), time.monotonic() + args.seconds, 0
    texts = [x for x in ALGEBRAS if args.only in x]
    for n, text in enumerate(texts):
        case, begun, done, failed = Case(text, rng), time.monotonic(), 0, []
        until = begun + (end - begun) / (len(texts) - n)
        for size in range(1, args.size + 1):
            for _ in range(args.count):
                if time.monotonic() > until:
                    break
                try:
                    case.check(size)
                except Exception as error:  # each failure is printed
                    failed.append(f"size {size}: {type(error).__name__} {error}"[:300])
                done += 1
        seconds = time.monotonic() - begun
        print(
            f"{text}: {done}, {seconds:.1f} s, {len(failed)} failed",
            *failed[:3],
            sep="\n  ",
            flush=True,
        )
        bad += len(failed)
    return int(bad > 0)


if __name__ == "__main__":
    sys.exit(main())
