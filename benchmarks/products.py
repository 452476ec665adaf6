"""Quaternion products, a million in one call, beside galois and beside the bytes that they move.

    python benchmarks/products.py [RING…] [--count N] [--all]

A line a ring, nanoseconds a product, the least of several runs in a row, one thread and its processor
time, so that what else the machine does matters less:

- ours: ``p * q`` on arrays of quaternions;
- by hand: the sixteen products and twelve sums typed on galois's arrays (on numpy's int64 over ZZ, where they
  overflow unnoticed; on numpy's uint64 with ``%`` over ZZ/n);
- bytes: numpy's sum of two arrays, which reads and writes as many bytes as ours and does little; ratio 1
  is as fast as they can be moved;
- then ours for the norm and the inverse, and how many times faster two threads are than one by the wall's
  clock, on ten times as many products; behind it the same of that sum of two arrays: what the machine, and
  who else is on it, allow just then.

``--all`` adds single elements: a Python loop over a part of the array. All products are compared first.

Rings without a loop of their own have a line of two numbers: microseconds a product in an array, and how
many times longer that takes than a Python loop over single elements.
"""

import argparse
import time
from collections.abc import Callable
from random import Random
from threading import Thread
from typing import Any

import numpy as np

from hfield import H, Quaternion
from hfield.compiling.threads import threads
from hfield.fields.base.array_storage.object_arrays import ObjectArrays

FIELDS = [
    "GF(2)", "GF(3)", "GF(7)", "GF(251)", "GF(65521)", "GF(65537)", "GF(2147483647)", "GF(4294967291)",
    "GF(9)", "GF(3^5)", "GF(251^2)", "GF(3^10)", "GF(2^8)", "GF(2^16)", "GF(2^32)", "GF(2^64)",
    "ZZ/1000000", "ZZ, 7 bits", "ZZ, 15 bits", "ZZ, 20 bits", "ZZ, 29 bits", "QQ, 20 bits",
]  # fmt: skip
ONE_BY_ONE = [
    "QQ(sqrt(2))", "QQ[s]/(s^3-2)", "QQ[s]/(s^4-2)", "GF(5)(t)", "QQ(x)",
    "GF(18446744073709551629)", "GF(3^11)",
]  # fmt: skip
PART = 2_000
FEW = 500
RUNS = 7


def least(
    *works: Callable[[], object], runs: int = RUNS, clock: Callable[[], float] = time.thread_time
) -> list[float]:
    """Return the least time of each, run several times in a row."""
    best = [float("inf")] * len(works)
    for n, work in enumerate(works):
        for _ in range(runs):
            start = clock()
            work()
            best[n] = min(best[n], clock() - start)
    return best


def operands(name: str, count: int) -> tuple[Quaternion, Quaternion]:
    """Return two arrays of random quaternions; over ZZ and QQ a size stands behind a comma."""
    name, _, size = name.partition(", ")
    A, rng = H(name), np.random.default_rng(1)
    order = A.ring.order
    if order is None:
        most = 1 << int((size or "20 bits").split()[0])
        small = [rng.integers(1 - most, most, count) for _ in range(8)]
        return A(*small[:4]), A(*small[4:])
    dtype = np.min_scalar_type(order - 1)
    p, q = (rng.integers(0, order - 1, (4, count), dtype, endpoint=True) for _ in range(2))
    return A.from_array(p), A.from_array(q)


def three_of_a_size(*arrays: Quaternion) -> list[Any]:
    """Return three arrays of one type with as many bytes in total as the storage of these."""
    rows = [row for q in arrays for row in q._stored]
    widest = max((row.dtype for row in rows), key=lambda dtype: dtype.itemsize)
    length = sum(row.nbytes for row in rows) // widest.itemsize // 3
    return [np.zeros(length, widest) for _ in range(3)]


def typed(p: Any, q: Any) -> tuple[Any, ...]:
    """Multiply Hamilton's quaternions as a user would type it."""
    a, b, c, d = p
    e, f, g, h = q
    return (
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    )


def by_hand(p: Quaternion, q: Quaternion) -> Callable[[], Any] | None:
    """Return the plain sixteen products, or None where no library has fast arrays."""
    F = p.ring
    if F.order is None or not F.is_field:
        if F.name == "QQ":
            return None
        x, y = (tuple(a.to_array().astype(np.int64)) for a in (p, q))
        n = F.order
        return lambda: typed(x, y) if n is None else tuple(c % n for c in typed(x, y))
    if F.order >= 2**31:
        return None
    u, v = p.coordinates, q.coordinates
    return lambda: typed(u, v)


def one_by_one(name: str) -> str:
    """Measure a ring without a loop of its own."""
    A, rng = H(name), Random(1)
    F = A.ring

    def drawn() -> Any:
        x = F.random(rng)
        return x + F.random(rng) * F.gen if F.order is None else x

    singles = [[A(*(drawn() for _ in range(4))) for _ in range(FEW)] for _ in range(2)]
    p, q = (A(*([x.coordinates[n] for x in each] for n in range(4))) for each in singles)
    pairs = list(zip(*singles, strict=True))
    assert all(x == y * z for x, (y, z) in zip(p * q, pairs, strict=True))
    ours, loop = least(lambda: p * q, lambda: [x * y for x, y in pairs])
    return f"{name:>24} {ours / FEW * 1e6:8.2f} {ours / loop:6.2f}"


def line(name: str, count: int, with_loop: bool) -> str:
    """Measure one ring."""
    if isinstance(H(name.partition(", ")[0]).array_storage, ObjectArrays):
        return one_by_one(name)
    p, q = operands(name, count)
    hand = by_hand(p, q)
    product = p * q
    sample = range(0, count, max(1, count // 50))
    assert all(product[n] == p[n] * q[n] for n in sample)
    if hand is not None:
        assert (product.to_array()[:4] == np.stack([np.asarray(c) for c in hand()])).all()
    x, y, out = three_of_a_size(p, q, product)
    ours, moved = least(lambda: p * q, lambda: np.add(x, y, out=out))
    figures = [f"{ours / count * 1e9:8.2f} {moved / count * 1e9:7.2f} {ours / moved:6.1f}"]
    if hand is None:
        figures.append(f"{'–':>9} {'–':>6}")
    else:
        (plain,) = least(hand, runs=2)
        figures.append(f"{plain / count * 1e9:9.1f} {plain / ours:5.0f}×")
    how = p.algebra.array_storage
    if p.ring.order is None:
        figures.append(f"{'–':>7} {'–':>7}")
    else:  # the loops alone: the norms of a large field become galois's arrays or objects
        loop, stored = how.kernel("norm"), p._stored  # type: ignore[attr-defined]
        units = p[how.units(stored)]
        norm, inverse = least(lambda: loop(stored), units.inverse, runs=3)
        figures.append(f"{norm / count * 1e9:7.2f} {inverse / len(units) * 1e9:7.1f}")
    figures += [f"{times:5.2f}×" for times in two_threads(name, 10 * count)]
    if with_loop:
        pairs = [(p[n], q[n]) for n in range(PART)]
        (loop_time,) = least(lambda: [u * v for u, v in pairs], runs=3)
        figures.append(f"{loop_time / PART * 1e9:8.0f}")
    return f"{name:>15} " + " ".join(figures)


def two_threads(name: str, count: int) -> tuple[float, float]:
    """Return how many times faster two threads are than one: with our products, and with numpy's sum."""
    p, q = operands(name, count)
    x, y, out = three_of_a_size(p, q, p * q)
    half = len(x) // 2

    def ours(number: int) -> Callable[[], object]:
        def work() -> object:
            threads(number)
            return p * q

        return work

    def halves() -> None:
        other = Thread(target=np.add, args=(x[:half], y[:half], out[:half]))
        other.start()
        np.add(x[half:], y[half:], out=out[half:])
        other.join()

    works = ours(1), ours(2), lambda: np.add(x, y, out=out), halves
    one, two, whole, both = least(*works, runs=10, clock=time.perf_counter)
    threads(1)
    return one / two, whole / both


def main() -> None:
    """Print one line a ring."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("fields", nargs="*", default=[*FIELDS, *ONE_BY_ONE])
    parser.add_argument("--count", type=int, default=1_000_000)
    parser.add_argument("--all", action="store_true", help="single elements too")
    args = parser.parse_args()
    threads(1)
    print(
        f"{args.count} products in one call, ns each\n{'ring':>15} {'ours':>8} {'bytes':>7} {'ratio':>6} "
        f"{'by hand':>9} {'ratio':>6} {'norm':>7} {'inverse':>7} {'2 thr':>6} {'sum':>6}"
        + ("   single" if args.all else "")
    )
    for name in args.fields:
        print(line(name, args.count, args.all), flush=True)


if __name__ == "__main__":
    main()
