"""Try many names and data of rings on prover, checker and a reader written from docs/reference/rings.md.

    python scripts/try_names.py [--count 100000] [--seed 0] [--data]

Names are composed, misspelt, and have words for variables; with --data, data of rings are made instead, and
others near to them: each has a name of its own, and comes back from it. The names of a ring are compared with
facts (tests/adversary/names). Exit status 1 when anything is wrong.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.adversary.names.campaign import run_data, run_names


def main() -> int:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--data", action="store_true", help="data instead of names")
    args = parser.parse_args()
    out = (run_data if args.data else run_names)(args.count, args.seed)
    for what, number in out.tally.most_common():
        print(f"{number:8} {what}")
    print(f"{len(out.complaints):8} complaints")
    for complaint in out.complaints:
        print(complaint)
    return int(bool(out.complaints))


if __name__ == "__main__":
    sys.exit(main())
