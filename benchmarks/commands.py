"""Cold commands against an empty Python process.

    python benchmarks/commands.py

Prints the median wall time of seven runs (three for the long one), its ratio to that, and the
peak memory. The package must be installed in the Python that runs this.
"""

import resource
import subprocess
import sys
import time
from statistics import median

HFIELD = [sys.executable, "-m", "hfield"]
COMMANDS = {
    "python -c pass": ([sys.executable, "-c", "pass"], 7),
    "hfield --version": ([*HFIELD, "--version"], 7),
    "hfield eval": ([*HFIELD, "eval", "(1+i)*(j-k)**-1", "--field", "GF7"], 7),
    "hfield prove": ([*HFIELD, "prove", "(p*q)*r == p*(q*r)"], 7),
    "hfield verify": ([*HFIELD, "verify"], 3),
    "hfield verify --jobs 2": ([*HFIELD, "verify", "--jobs", "2"], 3),
}


def seconds(command: list[str], runs: int) -> float:
    """Return the median wall time."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        times.append(time.perf_counter() - start)
    return median(times)


def main() -> None:
    """Print one line a command."""
    floor = 0.0
    for name, (command, runs) in COMMANDS.items():
        took = seconds(command, runs)
        floor = floor or took
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        print(f"{name:<24} {took:7.3f} s  {took / floor:6.1f} × floor  peak so far {peak:4.0f} MB")


if __name__ == "__main__":
    main()
