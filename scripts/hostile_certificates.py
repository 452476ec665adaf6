"""Make certificates that are as dear as their format allows, and measure what checking each of them takes.

    nice python scripts/hostile_certificates.py [--only TEXT] [--small] [--work N] [--all]

Each is checked in a process of its own. For each kind of evidence the worst are printed: seconds of processor
time, megabytes, units of work, and how long and how large a unit was; --all prints every file. Exit status 1
if one takes more than 30 seconds or a gigabyte, ends in anything but a verdict, or is rejected for its form.
"""

import argparse
import json
import resource
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

SECONDS, MEGABYTES = 30, 1_000  # for the ten million units that there are by default
STOP_SECONDS, STOP_BYTES = 300, 8 << 30


class Found(NamedTuple):
    """What checking one file took."""

    name: str
    seconds: float
    megabytes: float
    units: int
    verdict: str

    @property
    def kind(self) -> str:
        return self.name.partition(":")[0]

    @property
    def is_bad(self) -> bool:
        much = self.seconds > SECONDS or self.megabytes > MEGABYTES
        return much or self.verdict.startswith(("fault", "form"))

    def __str__(self) -> str:
        unit = f"{self.seconds * 1e6 / max(self.units, 1):6.2f} µs/unit"
        size = f"{self.seconds:6.2f} s {self.megabytes:5.0f} MB {self.units:9} units {unit}"
        return f"{self.name:55} {size}  {self.verdict}"


def judge(work: float) -> None:
    """Check the certificate on standard input, and print what that took."""
    resource.setrlimit(resource.RLIMIT_CPU, (STOP_SECONDS, STOP_SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (STOP_BYTES, STOP_BYTES))
    from hfield.checker.check import Budget, Rejected, check_text

    text, spent = sys.stdin.read(), Budget(work)
    begun = time.process_time()
    try:
        verdict = f"accepted: {check_text(text, budget=spent).verdict}"
    except Rejected as error:
        verdict = f"rejected: {error}"
    except Exception as error:
        verdict = f"fault: {error!r}"
    seconds = time.process_time() - begun
    print(json.dumps([seconds, _peak(), spent.spent, verdict]))


def _peak() -> float:
    """Return how many megabytes this process has had at most, from its own start on."""
    status = Path("/proc/self/status")
    if status.exists():
        line = next(x for x in status.read_text().splitlines() if x.startswith("VmHWM"))
        return int(line.split()[1]) / 1e3
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3


def measured(name: str, small: bool, work: float) -> Found:
    """Check one file in a process of its own."""
    from tests.adversary.hostile.files import HOSTILE
    from tests.adversary.hostile.reasons import is_meant

    make, few, many = HOSTILE[name]
    command = [sys.executable, __file__, "--judge", str(work)]
    text = make(few if small else many)
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    if done.returncode:
        return Found(name, STOP_SECONDS, 0, 0, f"fault: ended with {done.returncode}")
    *figures, verdict = json.loads(done.stdout)
    kind, _, reason = verdict.partition(": ")
    if kind == "rejected" and not is_meant(name, reason):
        kind = "form"
    return Found(name, *figures, f"{kind}: {reason}"[:70])


def main() -> int:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", metavar="TEXT", help="files with this in their name")
    parser.add_argument("--small", action="store_true", help="of the size that tests take")
    parser.add_argument("--work", type=float, default=10.0, metavar="N", help="millions of units")
    parser.add_argument("--all", action="store_true", help="print every file")
    parser.add_argument("--judge", type=float, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.judge is not None:
        judge(args.judge)
        return 0
    from tests.adversary.hostile.files import HOSTILE

    names = [name for name in HOSTILE if args.only in name]
    worst: dict[tuple[str, int], Found] = {}
    with ThreadPoolExecutor(2) as pool:
        for found in pool.map(partial(measured, small=args.small, work=args.work), names):
            if args.all or found.is_bad:
                print(found, flush=True)
            for n, size in enumerate((found.seconds, found.megabytes)):
                key = found.kind, n
                if key not in worst or size > worst[key][n + 1]:
                    worst[key] = found
    print("--- the worst of each kind")
    for found in dict.fromkeys(worst.values()):
        print(found)
    return int(any(found.is_bad for found in worst.values()))


if __name__ == "__main__":
    sys.exit(main())
