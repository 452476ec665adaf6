"""10⁵ quaternion products: one batched call against a Python loop over single elements.

    python benchmarks/products.py [FIELD…]

Both sides multiply the same quaternions and are compared for equality. Prints nanoseconds a product
(median of 5) and the ratio. The loop runs on a part of the batch and is scaled; it says so.
"""

import sys
import time
from collections.abc import Callable
from random import Random
from statistics import median

from hfield import H, Quaternion, ring

N = 100_000
PART = 5_000


def seconds(work: Callable[[], object]) -> float:
    """Return the median time of five runs."""
    times = []
    for _ in range(5):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return median(times)


def operands(field: str) -> tuple[Quaternion, Quaternion]:
    """Return two random arrays of N quaternions over the field."""
    A, F, rng = H(field), ring(field), Random(1)
    pool = [F.random(rng) for _ in range(1000)]
    columns = [F.array([pool[rng.randrange(1000)] for _ in range(N)]) for _ in range(8)]
    return A(*columns[:4]), A(*columns[4:])


def main(fields: list[str]) -> None:
    """Print one line a field."""
    print(f"{'field':>8}  {'batch, ns':>10}  {'loop, ns':>10}  ratio   (loop on {PART} of {N})")
    for field in fields or ["GF(2^8)", "GF(7)", "GF(3^5)", "QQ"]:
        p, q = operands(field)
        pairs = [(p[n], q[n]) for n in range(PART)]
        product = p * q
        assert all(product[n] == x * y for n, (x, y) in enumerate(pairs[:500]))
        batch = seconds(lambda p=p, q=q: p * q) / N * 1e9
        loop = seconds(lambda pairs=pairs: [x * y for x, y in pairs]) / PART * 1e9
        print(f"{field:>8}  {batch:>10.0f}  {loop:>10.0f}  {loop / batch:.0f}")


if __name__ == "__main__":
    main(sys.argv[1:])
