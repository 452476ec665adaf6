"""Hilbert newforms over real quadratic fields against published traces of Hecke operators.

    python scripts/try_hilbert_newforms.py [--seconds 600] [--fields 5 8 12 13 17 21 40 60] [--log FILE]

The traces of T₁, …, T₅ on cusp forms of levels 1 to 5 and weights 2 to 12 are added up from newforms of the
levels that divide one (tests/orders/hilbert_traces.py). Small level·(weight − 1) come first. Ends when all
are compared or the time is over. With ``--log`` each space that agrees is written to the file, and those
already in it are passed over. Exit status 1 if a trace differs.
"""

import argparse
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.orders.hilbert_traces import Field, published


def main() -> int:
    """Compare, print what differs, and count."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--fields", type=int, nargs="+", default=sorted(published()))
    parser.add_argument("--log", type=Path)
    args = parser.parse_args()
    known, fields = published(), {d: Field(d) for d in args.fields}
    done: set[tuple[int, ...]] = set()
    if args.log and args.log.exists():
        done = {tuple(map(int, line.split()[:3])) for line in args.log.read_text().splitlines()}
    every = {(d, n, k) for d in fields for n, k in known[d]} - done
    spaces = [(n * (k - 1), d, n, k) for d, n, k in every]
    end, start = time.monotonic() + args.seconds, time.monotonic()
    compared, failures = dict.fromkeys(fields, 0), 0
    for _, d, n, k in sorted(spaces):
        if time.monotonic() > end:
            break
        if fields[d].traces(n, k) != known[d][n, k]:
            failures += 1
            print(f"differs: discriminant {d}, level {n}, weight {k}", flush=True)
        elif args.log:
            with args.log.open("a") as log:
                log.write(f"{d} {n} {k} agrees, {time.monotonic() - start:.0f} s\n")
        compared[d] += 1
        print(f"{d} {n} {k} {time.monotonic() - start:.0f} s", flush=True)
    print(f"spaces of {len(spaces)} by discriminant: {compared}; {failures} differ")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
