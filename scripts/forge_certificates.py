"""Forge certificates of false claims, and see that none passes.

    python scripts/forge_certificates.py [--count 200000] [--seed 0] [--keep FOLDER]

Lies are made by knowing how a checker works (tests/adversary/forging); what passes is judged by an
evaluator that shares nothing with it. Exit status 1 when a false claim passes; --keep writes those.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.adversary.forging.campaign import run
from tests.adversary.forging.mutants import FIELDS, STATEMENTS, genuine


def main() -> int:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=200_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=Path, help="a folder for the files that pass")
    args = parser.parse_args()
    out = run(args.count, args.seed, genuine(STATEMENTS, FIELDS))
    for what, number in out.tally.most_common():
        print(f"{number:8} {what}")
    print(f"{len(out.breaks):8} breaks")
    for n, (reason, text) in enumerate(out.breaks):
        print(f"--- {reason[:300]}\n    {text[:300]}")
        if args.keep is not None:
            args.keep.mkdir(parents=True, exist_ok=True)
            (args.keep / f"break-{n}.json").write_text(
                text, encoding="utf-8", errors="backslashreplace"
            )
    return int(bool(out.breaks))


if __name__ == "__main__":
    sys.exit(main())
