"""Lets Coq judge certificates: how many it accepts, and what is not covered, each with its reason.

Usage: ``python scripts/judge_with_coq.py FOLDER [--every N] [--batch N]``, with a folder of
certificates such as ``hfield verify --certificates FOLDER`` writes. Exit status 1 if Coq rejects one.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections import Counter
from pathlib import Path

from hfield.coq.coqc import Coqc
from hfield.coq.theorem import Theorem, theorem
from hfield.errors import HFieldError


def main() -> int:
    """Translate all certificates, compile them in batches, report."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--every", type=int, default=1, help="take only every Nth certificate")
    parser.add_argument("--batch", type=int, default=60, help="theorems in one run of coqc")
    args = parser.parse_args()
    files = sorted(args.folder.glob("*.json"))[:: args.every]
    theorems: list[tuple[Path, Theorem]] = []
    left: Counter[str] = Counter()
    for number, file in enumerate(files):
        data = json.loads(file.read_text(encoding="utf-8"))
        try:
            theorems.append((file, theorem(f"certificate_{number}", data)))
        except HFieldError as error:
            left[f"{type(error).__name__}: {re.sub(r'[0-9]+', 'N', str(error))[:100]}"] += 1
    print(f"{len(files)} certificates, {len(theorems)} translated, {left.total()} not covered")
    for reason, count in left.most_common():
        print(f"{count:6} {reason}")
    rejected = 0
    with Coqc() as coq:
        for start in range(0, len(theorems), args.batch):
            batch = theorems[start : start + args.batch]
            if coq.reject([t for _, t in batch]) is not None:
                for file, one in batch:
                    reason = coq.reject([one])
                    if reason is not None:
                        rejected += 1
                        print(f"rejected: {file.name}: {reason}")
            print(f"{start + len(batch)} judged, {rejected} rejected", file=sys.stderr, flush=True)
    print(f"{len(theorems) - rejected} accepted by Coq, {rejected} rejected")
    return int(bool(rejected))


if __name__ == "__main__":
    sys.exit(main())
