"""Random cases of every operation on lattices, orders, ideals and classes, recomputed another way.

    python scripts/check_lattices.py [--cases 10000] [--seed 0] [--state FILE] [--seconds S] [--only WORD]

The other ways are in tests/orders/recomputed, which shares no algorithm with the package. Case n of an
operation is the same for the same seed. With --state what was done is kept in a file, a line a slice, and
the next run goes on there, after a kill too; --seconds stops in time. Exit status 1 when a case differs.
"""

import argparse
import json
import sys
import time
import traceback
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.orders.recomputed import OPERATIONS, run

SLICE = 100


def done_in(state: Path | None, seed: int) -> Counter[str]:
    """Return how many cases of each operation the file tells of; a torn last line is left out."""
    done: Counter[str] = Counter()
    if state is not None and state.exists():
        for line in state.read_text(encoding="utf-8").splitlines(keepends=True):
            if line.endswith("\n") and (slice_ := json.loads(line))["seed"] == seed:
                done[slice_["operation"]] = max(done[slice_["operation"]], slice_["to"])
    return done


def main() -> int:
    """Run slices of all operations in turn, and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--state", type=Path, help="a file of JSON lines that tells what is done")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="stop after so long")
    parser.add_argument("--only", default="", help="operations with this word in their name")
    args = parser.parse_args()
    done, start, wrong = done_in(args.state, args.seed), time.monotonic(), 0
    names = [name for name in OPERATIONS if args.only in name]
    for target in range(SLICE, args.cases + SLICE, SLICE):
        for name in names:
            while done[name] < min(target, args.cases):
                if time.monotonic() - start > args.seconds:
                    return report(names, done, wrong, start)
                first, last = done[name], min(done[name] + SLICE, args.cases)
                wrong += try_cases(name, range(first, last), args.seed)
                done[name] = last
                if args.state is not None:
                    with args.state.open("a", encoding="utf-8") as file:
                        line = {"operation": name, "seed": args.seed, "from": first, "to": last}
                        file.write(json.dumps(line) + "\n")
    return report(names, done, wrong, start)


def try_cases(name: str, cases: range, seed: int) -> int:
    """Try some cases of an operation, print those that fail, and return how many do."""
    wrong = 0
    for n in cases:
        try:
            run(name, n, seed)
        except Exception:
            wrong += 1
            print(f"{name}, case {n} of seed {seed}:\n{traceback.format_exc()}", flush=True)
    return wrong


def report(names: list[str], done: Counter[str], wrong: int, start: float) -> int:
    """Print how many cases there were."""
    for name in names:
        print(f"{done[name]:7d}  {name}")
    print(
        f"{sum(done[name] for name in names)} cases, {wrong} wrong in this run, "
        f"{time.monotonic() - start:.0f} s"
    )
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
