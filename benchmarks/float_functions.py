"""Functions of quaternions of floats beside numpy-quaternion and quaternionic, in one run.

    python benchmarks/float_functions.py [SECONDS]

The table shows the best time of a call in microseconds, for an array of 10⁵ quaternions and for a single one.
The libraries are timed in turns, for SECONDS (default 1) a function. The last column is the time of hfield
divided by that of the faster of the others.
"""

import sys
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import quaternion
import quaternionic

from hfield import H

FUNCTIONS: dict[str, Callable[[Any], Any]] = {
    "abs": np.abs,
    "exp": np.exp,
    "log": np.log,
    "sqrt": np.sqrt,
    "power 0.3": lambda q: q**0.3,
    "product": lambda q: q * q,
}
ARRAY_SIZE = 100_000


def best(ways: list[Callable[[], Any]], seconds: float, repeat: int) -> list[float]:
    """Return the shortest time of a call of each way, in microseconds."""
    found = [float("inf")] * len(ways)
    for way in ways:
        way()
    end = time.perf_counter() + seconds
    while time.perf_counter() < end:
        for n, way in enumerate(ways):
            start = time.perf_counter()
            for _ in range(repeat):
                way()
            found[n] = min(found[n], (time.perf_counter() - start) / repeat)
    return [1e6 * x for x in found]


def main() -> None:
    """Print the table."""
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0
    x = np.random.default_rng(1).normal(size=(ARRAY_SIZE, 4))
    A = H("RDF")
    many = (A.from_array(x, axis=-1), quaternion.as_quat_array(x), quaternionic.array(x))
    one = tuple(q[0] for q in many)
    print(f"{'':22}{'ours':>10}{'quaternion':>12}{'quaternionic':>14}{'ratio':>8}")
    for title, operands, repeat in ((f"{ARRAY_SIZE}", many, 1), ("one", one, 100)):
        for name, function in FUNCTIONS.items():
            times = best([partial(function, q) for q in operands], seconds, repeat)
            ratio = times[0] / min(times[1:])
            row = (
                f"{title:>8} {name:12} {times[0]:10.2f}{times[1]:12.2f}{times[2]:14.2f}{ratio:8.2f}"
            )
            print(row)


if __name__ == "__main__":
    main()
