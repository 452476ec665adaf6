"""Ask the prover random statements, and judge its answers by an evaluator that shares nothing with it.

    python scripts/try_statements.py [--count 20000] [--seed 0] [--timeout 1.0]

Verdict, scope and witness are tried in all commutative rings of order up to 16 that tests/adversary
writes down, and every certificate is checked. Exit status 1 when anything is wrong.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.adversary.interrogation import interrogate


def main() -> int:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--timeout", type=float, default=1.0, help="seconds for one statement")
    args = parser.parse_args()
    found = interrogate(args.seed, args.count, args.timeout)
    for what, number in found.tally.most_common():
        print(f"{number:8} {what}")
    for complaint in found.complaints:
        print(complaint)
    return int(bool(found.complaints))


if __name__ == "__main__":
    sys.exit(main())
