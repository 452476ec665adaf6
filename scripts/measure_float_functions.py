"""Measure the errors of functions of quaternions of floats against mpmath, in units of 2⁻⁵².

    python scripts/measure_float_functions.py [COUNT]

COUNT random quaternions (default 100 000, about two minutes) are divided among exponential, logarithm, square
root, powers and n-th roots. The error is the modulus of the difference divided by the modulus of the value.
The script prints the largest and the mean error of each function, as listed in docs/reference/algebras.md.
"""

import sys
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np

from hfield import H

PRECISION = 120  # bits of mpmath
Value = Callable[[Any], Any]


def quaternions(count: int, seed: int, largest: float) -> np.ndarray:
    """Return quaternions of modulus 2⁻²⁰ to 2^largest; every seventh has a small vector part."""
    rng = np.random.default_rng(seed)
    q = rng.normal(size=(count, 4))
    q *= (2.0 ** rng.uniform(-20, largest, count) / np.linalg.norm(q, axis=1))[:, None]
    q[::7, 1:] *= 2.0 ** rng.uniform(-40, 0, len(q[::7]))[:, None]
    q[1::7] /= np.linalg.norm(q[1::7], axis=1)[:, None]  # near modulus 1
    return q


def errors(q: np.ndarray, found: np.ndarray, value: Value) -> np.ndarray:
    """Return the errors of rows in units of 2⁻⁵², from f(w + iφ) by mpmath."""
    out = np.empty(len(q))
    with mpmath.workprec(PRECISION):
        for n, (row, ours) in enumerate(zip(q.tolist(), found.tolist(), strict=True)):
            w, *v = map(mpmath.mpf, row)
            phi = mpmath.sqrt(sum(x * x for x in v))
            z = value(mpmath.mpc(w, phi))
            right = [z.real, *(z.imag * x / phi for x in v)]
            off = sum((f - r) ** 2 for f, r in zip(ours, right, strict=True))
            out[n] = mpmath.sqrt(off / sum(r * r for r in right)) * 2**52
    return out


def measure(count: int) -> dict[str, np.ndarray]:
    """Return the errors of ``count`` values in all, by function."""
    A = H("RDF")
    cases: dict[str, tuple[float, Callable[[Any], Any], Value]] = {
        "exp, |q| ≤ 2": (1, lambda q: q.exp(), mpmath.exp),
        "exp, |q| ≤ 32": (5, lambda q: q.exp(), mpmath.exp),
        "log": (20, lambda q: q.log(), mpmath.log),
        "sqrt": (20, lambda q: q.sqrt(), mpmath.sqrt),
        "q**0.3": (20, lambda q: q**0.3, lambda z: z ** mpmath.mpf(0.3)),
        "q**-2.5": (20, lambda q: q**-2.5, lambda z: z ** mpmath.mpf(-2.5)),
        "q**7.5": (10, lambda q: q**7.5, lambda z: z ** mpmath.mpf(7.5)),
        "q.roots(3)[0]": (20, lambda q: q.roots(3)[0], lambda z: z ** (mpmath.mpf(1) / 3)),
        "q.roots(5)[0]": (20, lambda q: q.roots(5)[0], lambda z: z ** (mpmath.mpf(1) / 5)),
        "q.roots(5)[2]": (
            20,
            lambda q: q.roots(5)[2],
            lambda z: z ** (mpmath.mpf(1) / 5) * mpmath.expjpi(mpmath.mpf(4) / 5),
        ),
    }
    found = {}
    for seed, (name, (largest, ours, value)) in enumerate(cases.items()):
        q = quaternions(count // len(cases), seed, largest)
        computed = ours(A.from_array(q, axis=-1)).to_array(axis=-1)
        found[name] = errors(q, computed, value)
    return found


if __name__ == "__main__":
    print(f"{'':16}{'largest':>9}{'mean':>8}")
    for name, units in measure(int(sys.argv[1]) if len(sys.argv) > 1 else 100_000).items():
        print(f"{name:16}{units.max():9.2f}{units.mean():8.2f}", flush=True)
