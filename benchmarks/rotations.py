"""Rotations of 550 000 points against the installed peers and against a copy of the array, in one run.

    python benchmarks/rotations.py [POINTS] [SECONDS]

Four loads: one rotation of all points; an axis and an angle, a quaternion, or Euler angles for each
point. The floor is `np.copyto` between preallocated arrays, of as many bytes as our calls read and write;
these are made with ``out=``. The ways take turns, round after round, for SECONDS (default 20) a load,
and the best time of a call counts, so that a busy machine disturbs all alike. A turn is a run of calls, as
frame follows frame: the first is not timed, since it finds the caches full of another's arrays. Our calls
have one thread and then two; the copy and the peers have one. Peers build what they need (quaternions,
rotations) within the time, as their users must when every frame is new. Answers are compared before
anything is timed.
"""

import os
import sys
import time
from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # its threads spin after a product, in the next one's time

import numpy as np

from rotation import rotate, rotate_euler, rotate_quat
from rotation.kernels import threads

Way = Callable[[], Any]
Array = Any
RNG = np.random.default_rng(1)
TURN = 0.03  # seconds of a run of calls


def ours(number: int, call: Way) -> Way:
    """Return the call made with that many threads."""

    def way() -> Any:
        threads(number)
        return call()

    return way


def quaternion_of(axis: Array, angle: Array) -> Array:
    """Return the unit quaternions, as a peer's user would write them."""
    unit = axis / np.linalg.norm(axis, axis=-1, keepdims=True)
    half = np.asarray(angle)[..., None] / 2
    return np.concatenate([np.cos(half), np.sin(half) * unit], axis=-1)


def copy(p: Array, numbers: int) -> Way:
    """Return a copy that moves so many numbers for each point, half of them to, half of them fro."""
    here = np.ones(len(p) * numbers // 2)
    there = np.empty_like(here)
    return lambda: np.copyto(there, here)


def one_rotation(p: Array) -> dict[str, Way]:
    q = np.array([0.3, -0.5, 0.7, 0.4]) / np.linalg.norm([0.3, -0.5, 0.7, 0.4])
    out, p32, soa = np.empty_like(p), p.astype(np.float32), p.T.copy()
    out32, out_soa = np.empty_like(p32), np.empty_like(soa)
    inplace = p.copy()
    ways: dict[str, Way] = {"copy": copy(p, 6)}
    for n in (1, 2):
        ways[f"ours, (N, 3), {n}"] = ours(n, lambda: rotate_quat(p, q, out=out))
        ways[f"ours, (3, N), {n}"] = ours(n, lambda: rotate_quat(soa, q, out=out_soa, layout="soa"))
        ways[f"ours, in place, {n}"] = ours(n, lambda: rotate_quat(inplace, q, out=inplace))
        ways[f"ours, float32, {n}"] = ours(n, lambda: rotate_quat(p32, q, out=out32))
    matrix = rotate_quat(np.eye(3), q).T
    ways["numpy P @ R.T"] = lambda: np.matmul(p, matrix.T, out=out)
    if find_spec("scipy"):
        from scipy.spatial.transform import Rotation

        turn = Rotation.from_quat(q[[1, 2, 3, 0]])
        ways["scipy"] = lambda: turn.apply(p)
    if find_spec("quaternionic"):
        import quaternionic

        unit = quaternionic.array(q)
        ways["quaternionic"] = lambda: unit.rotate(p)
    if find_spec("quaternion"):
        import quaternion

        single = quaternion.quaternion(*q)
        ways["numpy-quaternion"] = lambda: quaternion.rotate_vectors(single, p)
    return ways


def own_axes(p: Array) -> dict[str, Way]:
    axis, angle = RNG.normal(size=p.shape), RNG.uniform(-np.pi, np.pi, len(p))
    out, soa, soa_axis = np.empty_like(p), p.T.copy(), axis.T.copy()
    out_soa = np.empty_like(soa)
    ways: dict[str, Way] = {"copy": copy(p, 10)}
    for n in (1, 2):
        ways[f"ours, (N, 3), {n}"] = ours(n, lambda: rotate(p, axis, angle, out=out))
        ways[f"ours, (3, N), {n}"] = ours(
            n, lambda: rotate(soa, soa_axis, angle, out=out_soa, layout="soa")
        )
    if find_spec("scipy"):
        from scipy.spatial.transform import Rotation

        def with_scipy() -> Any:
            size = angle / np.linalg.norm(axis, axis=-1)
            return Rotation.from_rotvec(axis * size[:, None]).apply(p)

        ways["scipy"] = with_scipy
    if find_spec("quaternionic"):
        import quaternionic

        def with_quaternionic() -> Any:
            q = quaternionic.array(quaternion_of(axis, angle))
            points = np.concatenate([np.zeros((len(p), 1)), p], axis=-1)
            return (q * quaternionic.array(points) * q.conjugate()).vector

        ways["quaternionic"] = with_quaternionic
    if find_spec("quaternion"):
        import quaternion

        def with_numpy_quaternion() -> Any:
            q = quaternion.as_quat_array(quaternion_of(axis, angle))
            points = quaternion.from_vector_part(p)
            return quaternion.as_vector_part(q * points * q.conjugate())

        ways["numpy-quaternion"] = with_numpy_quaternion
    return ways


def own_quaternions(p: Array) -> dict[str, Way]:
    q = RNG.normal(size=(len(p), 4))
    out, soa, soa_q = np.empty_like(p), p.T.copy(), q.T.copy()
    out_soa, p32, q32 = np.empty_like(soa), p.astype(np.float32), q.astype(np.float32)
    out32 = np.empty_like(p32)
    ways: dict[str, Way] = {"copy": copy(p, 10)}
    for n in (1, 2):
        ways[f"ours, (N, 3), {n}"] = ours(n, lambda: rotate_quat(p, q, out=out))
        ways[f"ours, (3, N), {n}"] = ours(
            n, lambda: rotate_quat(soa, soa_q, out=out_soa, layout="soa")
        )
        ways[f"ours, float32, {n}"] = ours(n, lambda: rotate_quat(p32, q32, out=out32))
    if find_spec("scipy"):
        from scipy.spatial.transform import Rotation

        ways["scipy"] = lambda: Rotation.from_quat(q, scalar_first=True).apply(p)
    return ways


def own_euler(p: Array) -> dict[str, Way]:
    angles = RNG.uniform(-np.pi, np.pi, p.shape)
    out, soa, soa_angles = np.empty_like(p), p.T.copy(), angles.T.copy()
    out_soa = np.empty_like(soa)
    ways: dict[str, Way] = {"copy": copy(p, 9)}
    for n in (1, 2):
        ways[f"ours, (N, 3), {n}"] = ours(n, lambda: rotate_euler(p, angles, out=out))
        ways[f"ours, (3, N), {n}"] = ours(
            n, lambda: rotate_euler(soa, soa_angles, out=out_soa, layout="soa")
        )
    if find_spec("scipy"):
        from scipy.spatial.transform import Rotation

        ways["scipy"] = lambda: Rotation.from_euler("ZYX", angles).apply(p)
    return ways


def compared(ways: dict[str, Way]) -> None:
    """Call every way once, which also compiles; raise if a peer's answer is another one."""
    answers = {}
    for name, way in ways.items():
        answer = way()
        if answer is not None and "in place" not in name and "float32" not in name:
            answers[name] = answer.T if "(3, N)" in name else answer
    first = answers["ours, (N, 3), 1"].copy()
    for name, answer in answers.items():
        np.testing.assert_allclose(np.asarray(answer), first, atol=1e-11, err_msg=name)


def best(ways: dict[str, Way], seconds: float) -> dict[str, float]:
    """Return the best time of each way, which take turns until the time is over."""
    times = dict.fromkeys(ways, float("inf"))
    end, spent = time.perf_counter() + seconds, dict.fromkeys(ways, 0.0)
    while time.perf_counter() < end:
        for name, way in ways.items():
            if spent[name] > seconds / len(ways):  # a slow peer does not use up the rounds
                continue
            began = time.perf_counter()
            way()
            start = time.perf_counter()
            while start - began < TURN or times[name] == float("inf"):
                way()
                now = time.perf_counter()
                times[name], start = min(times[name], now - start), now
            spent[name] += start - began
    return times


def main(arguments: list[str]) -> None:
    """Print a table a load."""
    number = int(arguments[0]) if arguments else 550_000
    seconds = float(arguments[1]) if len(arguments) > 1 else 20.0
    loads = (
        ("one rotation of all points", one_rotation),
        ("an axis and an angle for each point", own_axes),
        ("a quaternion for each point", own_quaternions),
        ("Euler angles ZYX for each point", own_euler),
    )
    for title, load in loads:
        ways = load(RNG.normal(size=(number, 3)))
        compared(ways)
        times = best(ways, seconds)
        print(f"\n{title}, {number} points (layout, threads)")
        for name, took in times.items():
            print(f"  {name:<22} {took * 1e3:9.3f} ms  {took / times['copy']:8.2f} × copy")


if __name__ == "__main__":
    main(sys.argv[1:])
