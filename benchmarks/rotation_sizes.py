"""Our time over scipy's, for one rotation and for 10, 100, 10³, 10⁴ and 10⁵ of them, call by call.

    python benchmarks/rotation_sizes.py [SECONDS]

Ours and scipy's take turns within SECONDS (default 0.1) for each call and size, and the least time of each
counts, so that a busy machine disturbs both alike. Below 1 we are faster. Single precision is timed
where points keep it. At the end new processes tell what importing and the first call take.
"""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # its threads spin after a product, in the next one's time

import numpy as np
from scipy.spatial.transform import RigidTransform as ScipyTransform
from scipy.spatial.transform import Rotation as ScipyRotation
from scipy.spatial.transform import RotationSpline as ScipySpline

import rotation
from rotation import Rotation

Pair = tuple[Callable[[], Any], Callable[[], Any]]
SIZES = (0, 10, 100, 1000, 10_000, 100_000)
RUN = 2e-4  # seconds of a run of calls

FIRST = """
import time
start = time.perf_counter()
import numpy
there = time.perf_counter()
from rotation import Rotation
imported = time.perf_counter()
Rotation.from_quat([1.0, 2.0, 3.0, 4.0]).apply([1.0, 2.0, 3.0])
print(there - start, imported - there, time.perf_counter() - imported)
"""


def rotations(n: int) -> dict[str, Pair]:
    """Return the calls on n rotations; 0 stands for a single one."""
    rng = np.random.default_rng(0)
    shape = (n,) if n else ()
    raw, other = rng.normal(size=(2, *shape, 4))
    v, a = rng.normal(size=(*shape, 3)), rng.uniform(-1.5, 1.5, (*shape, 3))
    v32 = v.astype(np.float32)
    r, s = Rotation(raw), ScipyRotation.from_quat(raw, scalar_first=True)
    p, t = Rotation(other), ScipyRotation.from_quat(other, scalar_first=True)
    one, single = Rotation([1, 2, 3, 4]), ScipyRotation.from_quat([2, 3, 4, 1])
    m = s.as_matrix()
    calls: dict[str, Pair] = {
        "apply 1→N": (lambda: one.apply(v), lambda: single.apply(v)),
        "apply N→N": (lambda: r.apply(v), lambda: s.apply(v)),
        "apply N→N, float32": (lambda: r.apply(v32), lambda: s.apply(v32)),
        "mul": (lambda: r * p, lambda: s * t),
        "inv": (lambda: r.inv(), lambda: s.inv()),
        "pow": (lambda: r**0.3, lambda: s**0.3),
        "magnitude": (lambda: r.magnitude(), lambda: s.magnitude()),
        "from_quat": (
            lambda: Rotation.from_quat(raw),
            lambda: ScipyRotation.from_quat(raw, scalar_first=True),
        ),
        "as_quat": (lambda: r.as_quat(), lambda: s.as_quat(scalar_first=True)),
        "as_quat, scalar last": (
            lambda: r.as_quat(scalar_first=False),
            lambda: s.as_quat(scalar_first=False),
        ),
        "identity": (
            lambda: Rotation.identity(n or None),
            lambda: ScipyRotation.identity(n or None),
        ),
        "from_matrix": (lambda: Rotation.from_matrix(m), lambda: ScipyRotation.from_matrix(m)),
        "as_matrix": (lambda: r.as_matrix(), lambda: s.as_matrix()),
        "from_rotvec": (lambda: Rotation.from_rotvec(v), lambda: ScipyRotation.from_rotvec(v)),
        "as_rotvec": (lambda: r.as_rotvec(), lambda: s.as_rotvec()),
        "from_euler": (
            lambda: Rotation.from_euler("ZYX", a),
            lambda: ScipyRotation.from_euler("ZYX", a),
        ),
        "as_euler": (lambda: r.as_euler("ZYX"), lambda: s.as_euler("ZYX")),
        "from_mrp": (lambda: Rotation.from_mrp(v), lambda: ScipyRotation.from_mrp(v)),
        "as_mrp": (lambda: r.as_mrp(), lambda: s.as_mrp()),
    }
    axes = np.eye(3)
    calls["as_davenport"] = (lambda: r.as_davenport(axes, "e"), lambda: s.as_davenport(axes, "e"))
    if n:
        weights, u = rng.uniform(1, 2, n), one.apply(v) + 0.01 * a
        calls["mean"] = (lambda: r.mean(), lambda: s.mean())
        calls["mean, weighted"] = (lambda: r.mean(weights), lambda: s.mean(weights))
        calls["align"] = (lambda: rotation.align(v, u), lambda: ScipyRotation.align_vectors(u, v))
    if 1 < n <= 10_000:
        calls |= splines(n)
    if hasattr(rotation, "RigidTransform"):
        calls |= transforms(r, s, v)
    return calls


def splines(n: int) -> dict[str, Pair]:
    """Return the calls on splines through n keyframes, at as many times."""
    rng = np.random.default_rng(1)
    times = np.cumsum(rng.uniform(0.5, 1.5, n))
    keys = Rotation.from_rotvec(rng.normal(size=(n, 3)) * 0.5).cumprod("body")
    theirs, at = keys.to_scipy(), np.linspace(times[0], times[-1], n)
    curve, other = rotation.RotationSpline(times, keys), ScipySpline(times, theirs)
    return {
        "spline made": (
            lambda: rotation.RotationSpline(times, keys),
            lambda: ScipySpline(times, theirs),
        ),
        "spline; rates": (lambda: curve(at, 1), lambda: other(at, 1)),
        "spline; accelerations": (lambda: curve(at, 2), lambda: other(at, 2)),
    }


def transforms(r: Rotation, s: Any, v: Any) -> dict[str, Pair]:
    """Return the calls on rigid transforms made of the rotations and the points."""
    ours = rotation.RigidTransform.from_components(v, r)
    scipys = ScipyTransform.from_components(v, s)
    twist, m = scipys.as_exp_coords(), scipys.as_matrix()
    kind = rotation.RigidTransform
    return {
        "rigid apply": (lambda: ours.apply(v), lambda: scipys.apply(v)),
        "rigid mul": (lambda: ours * ours, lambda: scipys * scipys),
        "rigid inv": (lambda: ours.inv(), lambda: scipys.inv()),
        "rigid as_matrix": (lambda: ours.as_matrix(), lambda: scipys.as_matrix()),
        "rigid made, as_matrix": (
            lambda: kind.from_components(v, r).as_matrix(),
            lambda: ScipyTransform.from_components(v, s).as_matrix(),
        ),
        "rigid from_matrix": (lambda: kind.from_matrix(m), lambda: ScipyTransform.from_matrix(m)),
        "rigid as_exp_coords": (lambda: ours.as_exp_coords(), lambda: scipys.as_exp_coords()),
        "rigid from_exp_coords": (
            lambda: kind.from_exp_coords(twist),
            lambda: ScipyTransform.from_exp_coords(twist),
        ),
    }


def least(pair: Pair, seconds: float) -> tuple[float, float]:
    """Return the least time of each of two calls, which take turns."""
    number, best = [1, 1], [float("inf")] * 2
    for k, call in enumerate(pair):
        call()  # which compiles
        start = time.perf_counter()
        call()
        number[k] = max(1, int(RUN / max(time.perf_counter() - start, 1e-7)))
    end, rounds = time.perf_counter() + seconds, 0
    while time.perf_counter() < end or rounds < 3:
        rounds += 1
        for k, call in enumerate(pair):
            start = time.perf_counter()
            for _ in range(number[k]):
                call()
            best[k] = min(best[k], (time.perf_counter() - start) / number[k])
    return best[0], best[1]


def main(arguments: list[str]) -> None:
    """Print the table."""
    seconds = float(arguments[0]) if arguments else 0.1
    table: dict[str, dict[int, float]] = {}
    for n in SIZES:
        for name, pair in rotations(n).items():
            ours, scipys = least(pair, seconds)
            table.setdefault(name, {})[n] = ours / scipys
    print(
        "| our time over scipy's | " + " | ".join(str(n) if n else "single" for n in SIZES) + " |"
    )
    print("|---|" + "---|" * len(SIZES))
    for name, row in table.items():
        cells = (f"{row[n]:.2f}" if n in row else "" for n in SIZES)
        print(f"| {name} | " + " | ".join(cells) + " |")
    for number in (1, 2):
        found = subprocess.run(
            [sys.executable, "-c", FIRST], capture_output=True, text=True, check=True
        )
        numpy, ours, first = map(float, found.stdout.split())
        print(
            f"new process {number}: numpy {numpy:.3f} s, rotation {ours:.3f} s, first call {first:.3f} s"
        )


if __name__ == "__main__":
    main(sys.argv[1:])
