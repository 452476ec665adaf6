"""Quaternions with symbols against sympy's own: the norm of a product with eight unknowns.

    python benchmarks/symbols.py

Prints milliseconds, the least of several runs, and how many times faster hfield is.
"""

import time
from collections.abc import Callable
from typing import Any

import sympy
from sympy.core.cache import clear_cache

from hfield import H, prove


def least(work: Callable[[], Any], runs: int) -> float:
    """Return the least time of several runs, in milliseconds."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return 1000 * min(times)


def main() -> None:
    """Print one line a task."""
    p, q = H("QQ").unknowns("p q")
    coordinates = sympy.symbols("p0:4 q0:4")
    u, v = sympy.Quaternion(*coordinates[:4]), sympy.Quaternion(*coordinates[4:])

    def ours() -> bool:
        return bool((p * q).norm() == p.norm() * q.norm())

    def theirs() -> bool:
        clear_cache()  # or sympy would remember the answer

        def norm(w: Any) -> Any:
            return w.a**2 + w.b**2 + w.c**2 + w.d**2

        return bool(sympy.expand(norm(u * v) - norm(u) * norm(v)) == 0)

    assert ours()
    assert theirs()
    mine, other = least(ours, 200), least(theirs, 5)
    proved = least(lambda: prove("norm(p*q) == norm(p)*norm(q)"), 3)
    print(
        f"N(pq) = N(p)N(q): hfield {mine:.3f} ms, sympy with expand {other:.1f} ms, {other / mine:.0f} times"
    )
    print(f"the same by prove, remembered after the first: {proved:.3f} ms")


if __name__ == "__main__":
    main()
