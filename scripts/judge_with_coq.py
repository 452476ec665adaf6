"""Lets Coq judge certificates: how many it accepts, and what is not covered or not judged, with reasons.

Usage: ``python scripts/judge_with_coq.py FOLDER [--every N] [--batch N]``, with a folder of
certificates such as ``hfield verify --certificates FOLDER`` writes. Exit status 1 if Coq does not
accept all that is translated.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from hfield.cli.commands.check_with_coq import ACCEPTED, NOT_JUDGED, REJECTED
from hfield.errors import HFieldError
from hfield.export.coq.coqc import Coqc, NotJudgedError
from hfield.export.coq.theorem import Theorem, theorem


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
    answers: Counter[str] = Counter()
    with Coqc() as coq:
        for start in range(0, len(theorems), args.batch):
            batch = theorems[start : start + args.batch]
            said = judged(coq, [t for _, t in batch])
            if said == ACCEPTED:
                answers[ACCEPTED] += len(batch)
            else:  # each by itself
                for file, one in batch:
                    said = judged(coq, [one])
                    answers[said.partition(":")[0]] += 1
                    if said != ACCEPTED:
                        print(f"{file.name}: {said}")
            print(f"{start + len(batch)} judged: {dict(answers)}", file=sys.stderr, flush=True)
    print(", ".join(f"{answers[word]} {word}" for word in (ACCEPTED, REJECTED, NOT_JUDGED)))
    return int(answers[ACCEPTED] < len(theorems))


def judged(coq: Coqc, theorems: Sequence[Theorem]) -> str:
    """Return ``accepted``, or what else became of theorems, and why."""
    try:
        rejected = coq.judge(theorems).rejected
    except NotJudgedError as error:
        return f"{NOT_JUDGED}: {error}"
    return f"{REJECTED}: {rejected}" if rejected else ACCEPTED


if __name__ == "__main__":
    sys.exit(main())
