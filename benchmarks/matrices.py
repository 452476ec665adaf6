"""Matrices of quaternions beside flint's and numpy's, processor time, in one run.

    python benchmarks/matrices.py [--size 50] [--count 1000000]

Each line: ours, the peer, and ours over the peer, the least of several runs in turn; answers are compared.

- the inverse of a matrix over H(QQ) with entries of 20 bits, beside flint's of the regular representation,
  four times as large, over QQ;
- products of 2 × 2 matrices over H(GF(7)), whose entries are arrays, beside the eight products of arrays;
- right eigenvalues of 1000 matrices 8 × 8 over H(RDF), beside numpy's of the complex ones of twice the size;
- rank and inverse of 12 × 12 over fields for which flint has no matrices: milliseconds alone.
"""

import argparse
import time
from collections.abc import Callable
from random import Random
from typing import Any

import flint
import numpy as np

from hfield import H, QuaternionAlgebra

RUNS = 5


def least(*works: Callable[[], Any], runs: int = RUNS) -> list[float]:
    """Return the least milliseconds of each, run in turn."""
    best = [float("inf")] * len(works)
    for _ in range(runs):
        for n, work in enumerate(works):
            start = time.process_time()
            work()
            best[n] = min(best[n], (time.process_time() - start) * 1000)
    return best


def line(what: str, ours: float, peer: float) -> None:
    print(f"{what}: {ours:.1f} ms, {peer:.1f} ms, {ours / peer:.2f}", flush=True)


def inverses(size: int) -> None:
    A, rng = H("QQ"), Random(1)
    rows = [
        [A(*(rng.randrange(-(2**20), 2**20) for _ in range(4))) for _ in range(size)]
        for _ in range(size)
    ]
    flat = flint.fmpq_mat(
        [[x for q in row for x in q.matrix()[r]] for row in rows for r in range(4)]
    )
    M, back = A.matrix(rows), flat.inv()
    inverse = M.inverse()
    assert all(
        inverse[r, 0].coordinates == tuple(back[4 * r + n, 0] for n in range(4))
        for r in range(size)
    )
    ours, peer = least(lambda: A.matrix(rows).inverse(), flat.inv, runs=2)
    line(f"inverse, {size} × {size} over H(QQ), and flint's of {4 * size} rows", ours, peer)


def products(count: int) -> None:
    A, rng = H("GF(7)"), np.random.default_rng(1)
    p, q, r, s, t, u, v, w = (A(*rng.integers(0, 7, (4, count))) for _ in range(8))
    M, N = A.matrix([[p, q], [r, s]]), A.matrix([[t, u], [v, w]])
    pairs = [(p, t), (q, v), (p, u), (q, w), (r, t), (s, v), (r, u), (s, w)]
    eight = [x * y for x, y in pairs]
    assert all(((M @ N)[0, n] == eight[2 * n] + eight[2 * n + 1]).all() for n in (0, 1))
    del eight

    def peer() -> None:
        for x, y in pairs:
            _ = x * y

    line(
        f"{count} products of 2 × 2 over H(GF(7)), and eight of arrays",
        *least(lambda: M @ N, peer, runs=15),
    )


def eigenvalues() -> None:
    A, rng = H("RDF"), np.random.default_rng(1)
    entries = rng.standard_normal((8, 8, 4, 1000))
    M = A.matrix([[A(*entries[r, c]) for c in range(8)] for r in range(8)])
    a, b, c, d = np.moveaxis(entries, (2, 3), (0, 1))
    upper, lower = a + 1j * b, c + 1j * d
    complex_form = np.block([[upper, lower], [-lower.conj(), upper.conj()]])
    peer = np.sort(np.linalg.eigvals(complex_form).real, -1)
    assert np.allclose(np.sort(np.repeat(M.right_eigenvalues().real, 2, -1), -1), peer)
    times = least(M.right_eigenvalues, lambda: np.linalg.eigvals(complex_form))
    line("eigenvalues of 1000 matrices 8 × 8 over H(RDF), and numpy's of 16 rows", *times)


def other_rings() -> None:
    for text in ("(-1,-1|GF(9))", "(-1,-1|QQ(sqrt(-7)))", "[1,t|GF(2)(t))"):
        A, rng = QuaternionAlgebra.from_text(text), Random(1)
        scalars = [A.ring(0), A.ring(1), A.ring.gen, A.ring.gen + A.ring(1)]
        M = A.matrix([[A(*rng.choices(scalars, k=4)) for _ in range(12)] for _ in range(12)])
        rank, inverse = least(M.rank, M.inverse, runs=2)
        print(f"12 × 12 over {text}: rank {rank:.1f} ms, inverse {inverse:.1f} ms", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=50)
    parser.add_argument("--count", type=int, default=1_000_000)
    args = parser.parse_args()
    inverses(args.size)
    products(args.count)
    eigenvalues()
    other_rings()


if __name__ == "__main__":
    main()
