"""The motions: 10⁵ steps of the heavy top against DOP853 at the same accuracy, and 500 frames of each motion.

    python benchmarks/top_motion.py

Best of several runs, after one that compiles. Needs scipy.
"""

import time
from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

from anim.film import Clip
from anim.model import Model
from anim.physics import Body, HeavyTop, Launch, physical
from anim.physics.heavy_top_equations import run_compiled
from anim.pipelines import PIPELINES, kinematic

STEPS = 100_000


def best(work: Callable[[], object], runs: int = 7) -> float:
    """Return the least wall time in seconds, after one run that is not counted."""
    work()
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def dop853(top: HeavyTop) -> object:
    """Solve the body-frame equations, to about the error of our steps."""
    i1, i3, mgl = top.body.transverse, top.body.axial, top.torque

    def rates(_: float, y: np.ndarray) -> list[float]:
        w, a, b, c, o1, o2, o3 = y.tolist()
        return [
            (-a * o1 - b * o2 - c * o3) / 2,
            (w * o1 + b * o3 - c * o2) / 2,
            (w * o2 + c * o1 - a * o3) / 2,
            (w * o3 + a * o2 - b * o1) / 2,
            ((i1 - i3) * o2 * o3 + mgl * 2 * (b * c + w * a)) / i1,
            ((i3 - i1) * o3 * o1 - mgl * 2 * (a * c - w * b)) / i1,
            0.0,
        ]

    return solve_ivp(rates, (0, top.seconds), top.start, "DOP853", rtol=1e-10, atol=1e-10)


def main() -> None:
    """Print one line a figure."""
    body, launch = Body.turned(Model().profile), Launch(spin=30.0).without_friction()
    step = HeavyTop(body, launch, 1.0).longest_step
    top = HeavyTop(body, launch, (STEPS - 0.5) * step)
    ours = best(lambda: run_compiled(top.start, top.step, top.steps, top.steps, top._rates))
    print(f"{STEPS} steps of {top.step * 1000:.2f} ms: {ours * 1000:.0f} ms")
    part = HeavyTop(body, launch, top.seconds / 20)
    theirs = 20 * best(lambda: dop853(part), 1)
    print(
        f"DOP853 over the same {top.seconds:.0f} s: {theirs:.1f} s, {theirs / ours:.0f} times as long"
    )
    print(f"500 frames, physics: {best(physical) * 1000:.1f} ms")
    for name in PIPELINES:
        took = best(lambda name=name: kinematic(name, Clip()))
        print(f"500 frames, {name}: {took * 1000:.1f} ms")


if __name__ == "__main__":
    main()
