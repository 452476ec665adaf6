"""Roots and linear factors of random polynomials over nine fields, compared with the definitions.

    python scripts/try_polynomials.py [--count 10000] [--seconds 600] [--seed 0] [--only TEXT]

Roots by substitution, their number over division algebras by the theorem of Gordon and Motzkin, products of
factors by multiplying out; over GF(3) all 81 elements are tried. One line an algebra: how many polynomials,
of how many roots or factors were not decided, the seconds, and what failed. Exit status 1 if anything did.
"""

import argparse
import signal
import sys
import time
from pathlib import Path
from random import Random

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.polynomials.polynomial_checks import ALGEBRAS, Case

EACH = 20
"""Seconds for one polynomial."""


def too_long(*_: object) -> None:
    raise TimeoutError(f"longer than {EACH} seconds")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=10_000, help="polynomials in all")
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="algebras whose text has this in it")
    args = parser.parse_args()
    signal.signal(signal.SIGALRM, too_long)
    texts = [x for some in ALGEBRAS.values() for x in some if args.only in x]
    rng, end, total, bad = Random(args.seed), time.monotonic() + args.seconds, 0, 0
    for n, text in enumerate(texts):
        case, begun, done, open_, failed = Case(text, rng), time.monotonic(), 0, 0, []
        until = begun + (end - begun) / (len(texts) - n)
        while done < args.count // len(texts) + 1 and time.monotonic() < until:
            drawn = case.polynomial()
            signal.alarm(EACH)
            try:
                open_ += not case.check(*drawn)
            except Exception as error:  # each failure is printed
                failed.append(f"{type(error).__name__} {error}: {drawn[0]}")
            signal.alarm(0)
            done += 1
        total, bad = total + done, bad + len(failed)
        seconds = time.monotonic() - begun
        print(
            f"{text}: {done}, {open_} open, {seconds:.1f} s, {len(failed)} failed",
            *failed[:5],
            sep="\n  ",
        )
        sys.stdout.flush()
    print(f"{total} polynomials, {bad} failed")
    return int(bad > 0)


if __name__ == "__main__":
    sys.exit(main())
