"""Our time over the quickest peer's, for one rotation and for 10 to 10⁶ of them, call by call.

    python benchmarks/rotation_sizes.py [SECONDS] [SIZES, such as 1,10,1000000] [BEFORE]

Peers are scipy, numpy-quaternion, quaternionic and pytransform3d on numpy's arrays, roma on torch, jaxlie
on JAX; who is not installed is left out. All take turns within SECONDS (default 0.1) for each call and size,
and the least time of each counts, so that a busy machine disturbs all alike. Below 1 we are faster; the
letter says than whom. BEFORE is the folder of another state of this project: then each state has a process
of its own, which takes its turns with the peers, and each cell gives the ratio of that state first. Single
precision is timed where points keep it. At 10⁶ our conversions are compared with the floor that memory sets,
and at the end new processes tell what importing and the first call take.
"""

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # its threads spin after a product, in the next one's time
os.environ["OMP_NUM_THREADS"] = "1"

import numpy as np
from scipy.spatial.transform import RigidTransform as ScipyTransform
from scipy.spatial.transform import Rotation as ScipyRotation
from scipy.spatial.transform import RotationSpline as ScipySpline

import rotation
from rotation import Rotation
from rotation.kernels import threads

Ways = dict[str, Callable[[], Any]]  # by whose they are; ours first
Timer = Callable[[int], float]  # how long so many calls take
SIZES = (1, 10, 100, 1000, 10_000, 100_000, 1_000_000)
HERE = Path(rotation.__file__).parents[1]
RUN = 2e-4  # seconds of a run of calls
SLOW = 5.0  # seconds of a call that is not repeated
PEERS = {
    "scipy": "s",
    "quaternion": "q",
    "quaternionic": "i",
    "pytransform3d": "p",
    "roma": "r",
    "jaxlie": "j",
}

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


def rotations(n: int) -> dict[str, Ways]:
    """Return the calls on n rotations, one being a single one and no array."""
    rng = np.random.default_rng(0)
    shape = (n,) if n > 1 else ()
    raw, other = rng.normal(size=(2, *shape, 4))
    v, a = rng.normal(size=(*shape, 3)), rng.uniform(-1.5, 1.5, (*shape, 3))
    v32 = v.astype(np.float32)
    r, s = Rotation(raw), ScipyRotation.from_quat(raw, scalar_first=True)
    p, t = Rotation(other), ScipyRotation.from_quat(other, scalar_first=True)
    one, single = Rotation([1, 2, 3, 4]), ScipyRotation.from_quat([2, 3, 4, 1])
    m, out, generator = s.as_matrix(), np.empty_like(v), np.random.default_rng(1)
    axis = np.array([1.0, 2.0, 3.0])
    turn = axis / np.linalg.norm(axis) * 3.0
    calls: dict[str, tuple[Callable[[], Any], Callable[[], Any]]] = {
        "apply 1→N": (lambda: one.apply(v), lambda: single.apply(v)),
        "apply N→N": (lambda: r.apply(v), lambda: s.apply(v)),
        "apply N→N, out=": (lambda: r.apply(v, out=out), lambda: s.apply(v)),
        "rotate, one axis": (
            lambda: rotation.rotate(v, axis, 3.0),
            lambda: ScipyRotation.from_rotvec(turn).apply(v),
        ),
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
            lambda: Rotation.identity(*shape),
            lambda: ScipyRotation.identity(*shape),
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
        "random": (
            lambda: Rotation.random(shape, rng=generator),
            lambda: ScipyRotation.random(n if shape else None, rng=generator),
        ),
        "from_mrp": (lambda: Rotation.from_mrp(v), lambda: ScipyRotation.from_mrp(v)),
        "as_mrp": (lambda: r.as_mrp(), lambda: s.as_mrp()),
    }
    axes = np.eye(3)
    calls["as_davenport"] = (lambda: r.as_davenport(axes, "e"), lambda: s.as_davenport(axes, "e"))
    if n > 1:
        weights, u = rng.uniform(1, 2, n), one.apply(v) + 0.01 * a
        calls["mean"] = (lambda: r.mean(), lambda: s.mean())
        calls["mean, weighted"] = (lambda: r.mean(weights), lambda: s.mean(weights))
        calls["align"] = (lambda: rotation.align(v, u), lambda: ScipyRotation.align_vectors(u, v))
    if 1 < n <= 10_000:
        calls |= splines(n)
    calls |= transforms(r, s, v)
    rows: dict[str, Ways] = {
        name: {"ours": ours, "scipy": scipys} for name, (ours, scipys) in calls.items()
    }
    if find_spec("quaternion"):
        rows["slerp"] = {"ours": lambda: rotation.slerp(r, p, 0.3)}
    for peer, add in (
        ("quaternion", numpy_quaternions),
        ("quaternionic", quaternionics),
        ("pytransform3d", pytransforms),
    ):
        if find_spec(peer):
            for name, way in add(r, p, v, m).items():
                rows[name][peer] = way
    for peer, add in (("roma", on_torch), ("jaxlie", on_jax)):
        if find_spec(peer):
            rows |= {name: {"ours": a, peer: b} for name, (a, b) in add(raw, other, v).items()}
    return rows


def numpy_quaternions(r: Rotation, p: Rotation, v: Any, m: Any) -> dict[str, Callable[[], Any]]:
    """Return numpy-quaternion's way of the calls that it has; a single one is its own type."""
    q = import_module("quaternion")
    a, b = (q.as_quat_array(x.as_quat())[()] for x in (r, p))
    a, b = (q.quaternion(*x.as_quat()) for x in (r, p)) if r.single else (a, b)
    slerp = q.slerp_evaluate if r.single else np.slerp_vectorized  # type: ignore[attr-defined]
    return {
        "slerp": lambda: slerp(a, b, 0.3),
        "mul": lambda: a * b,
        "inv": lambda: a.conjugate(),
        "pow": lambda: a**0.3,
        "as_matrix": lambda: q.as_rotation_matrix(a),
        "from_matrix": lambda: q.from_rotation_matrix(m),
        "as_rotvec": lambda: q.as_rotation_vector(a),
        "from_rotvec": lambda: q.from_rotation_vector(v),
    }


def quaternionics(r: Rotation, p: Rotation, v: Any, m: Any) -> dict[str, Callable[[], Any]]:
    """Return quaternionic's way of the calls that it has."""
    array = import_module("quaternionic").array
    a, b = array(r.as_quat()), array(p.as_quat())
    return {
        "mul": lambda: a * b,
        "inv": lambda: a.conjugate(),
        "as_matrix": lambda: a.to_rotation_matrix,
        "from_matrix": lambda: array.from_rotation_matrix(m),
        "as_rotvec": lambda: a.to_rotation_vector,
        "from_rotvec": lambda: array.from_rotation_vector(v),
    }


def pytransforms(r: Rotation, p: Rotation, v: Any, m: Any) -> dict[str, Callable[[], Any]]:
    """Return pytransform3d's way, the one for many."""
    turns = import_module("pytransform3d.batch_rotations")
    moves = import_module("pytransform3d.trajectories")
    a, b = r.as_quat(), p.as_quat()
    motion = rotation.RigidTransform.from_components(v, r)
    t, x = motion.as_matrix(), motion.as_exp_coords()
    return {
        "mul": lambda: turns.batch_concatenate_quaternions(a, b),
        "inv": lambda: turns.batch_q_conj(a),
        "as_matrix": lambda: turns.matrices_from_quaternions(a),
        "from_matrix": lambda: turns.quaternions_from_matrices(m),
        "rigid from_exp_coords": lambda: moves.transforms_from_exponential_coordinates(x),
        "rigid as_exp_coords": lambda: moves.exponential_coordinates_from_transforms(t),
        "rigid inv": lambda: moves.invert_transforms(t),
    }


def on_torch(
    raw: Any, other: Any, v: Any
) -> dict[str, tuple[Callable[[], Any], Callable[[], Any]]]:
    """Return calls on plain tensors, and roma's."""
    torch, roma = import_module("torch"), import_module("roma")
    torch.set_num_threads(1)
    a, b, t = (torch.tensor(x) for x in (raw, other, v))
    r, p = Rotation(a), Rotation(b)
    q, o = (roma.quat_wxyz_to_xyzw(x.as_quat()) for x in (r, p))
    m = r.as_matrix()
    return {
        "torch: mul": (lambda: r * p, lambda: roma.quat_product(q, o)),
        "torch: from_rotvec": (
            lambda: Rotation.from_rotvec(t),
            lambda: roma.rotvec_to_unitquat(t),
        ),
        "torch: as_rotvec": (lambda: r.as_rotvec(), lambda: roma.unitquat_to_rotvec(q)),
        "torch: as_matrix": (lambda: r.as_matrix(), lambda: roma.unitquat_to_rotmat(q)),
        "torch: from_matrix": (
            lambda: Rotation.from_matrix(m),
            lambda: roma.rotmat_to_unitquat(m),
        ),
        "torch: apply": (lambda: r.apply(t), lambda: roma.quat_action(q, t)),
    }


def on_jax(raw: Any, other: Any, v: Any) -> dict[str, tuple[Callable[[], Any], Callable[[], Any]]]:
    """Return calls compiled by JAX in double precision, and jaxlie's."""
    jax, jaxlie = import_module("jax"), import_module("jaxlie")
    jax.config.update("jax_enable_x64", True)
    a, b, t = (jax.numpy.asarray(x) for x in (raw, other, v))
    r, p = Rotation(a), Rotation(b)
    s, o = (jaxlie.SO3(x.as_quat()) for x in (r, p))

    def both(ours: Any, theirs: Any, *mine: Any) -> Any:
        def waited(call: Any, *arguments: Any) -> Callable[[], Any]:
            compiled = jax.jit(call)
            return lambda: jax.block_until_ready(compiled(*arguments))

        return waited(ours, *mine), waited(
            theirs, *[{id(r): s, id(p): o}.get(id(x), x) for x in mine]
        )

    return {
        "jax: mul": both(lambda x, y: x * y, lambda x, y: x @ y, r, p),
        "jax: exp": both(Rotation.from_rotvec, jaxlie.SO3.exp, t),
        "jax: log": both(lambda x: x.as_rotvec(), lambda x: x.log(), r),
        "jax: as_matrix": both(lambda x: x.as_matrix(), lambda x: x.as_matrix(), r),
        "jax: apply": both(lambda x, y: x.apply(y), lambda x, y: x.apply(y), r, t),
    }


def splines(n: int) -> dict[str, tuple[Callable[[], Any], Callable[[], Any]]]:
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


def transforms(
    r: Rotation, s: Any, v: Any
) -> dict[str, tuple[Callable[[], Any], Callable[[], Any]]]:
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


def timer(call: Callable[[], Any]) -> Timer:
    """Return what takes the time of so many calls."""

    def run(repeats: int) -> float:
        start = time.perf_counter()
        for _ in range(repeats):
            call()
        return time.perf_counter() - start

    return run


class State:
    """The calls of a state of this project, in a process of its own."""

    def __init__(self, folder: str) -> None:
        self._process = subprocess.Popen(
            [sys.executable, __file__, "--serve"],
            env={**os.environ, "PYTHONPATH": folder},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def timer(self, n: int, name: str) -> Timer:
        """Return what takes the time of one of the calls on n rotations."""
        question, answer = self._process.stdin, self._process.stdout
        assert question
        assert answer

        def run(repeats: int) -> float:
            print(json.dumps([n, name, repeats]), file=question, flush=True)
            return float(answer.readline())

        return run

    def end(self) -> None:
        """End the process."""
        self._process.communicate()


def serve() -> None:
    """Answer a `State`."""
    rows: dict[int, dict[str, Ways]] = {}
    for line in sys.stdin:
        n, name, repeats = json.loads(line)
        if n not in rows:
            rows = {n: rotations(n)}
        print(timer(rows[n][name]["ours"])(repeats), flush=True)


def least(ways: Ways, seconds: float, others: dict[str, Timer] | None = None) -> dict[str, float]:
    """Return the least time of each of the calls, which take turns; one that takes seconds is timed once."""
    timers = {name: timer(call) for name, call in ways.items()} | (others or {})
    best, number = {}, {}
    for name, run in timers.items():
        for _ in range(2):  # the first compiles
            best[name] = run(1)
            if best[name] > SLOW:
                break
        else:
            number[name] = max(1, int(RUN / max(best[name], 1e-7)))
    end, rounds = time.perf_counter() + seconds, 0
    while rounds == 0 or time.perf_counter() < end:
        for name, repeats in number.items():
            best[name] = min(best[name], timers[name](repeats) / repeats)
        rounds += 1
    return best


def memory_bounds(seconds: float, n: int = 1_000_000) -> dict[str, float]:
    """Return the times of conversions of n rotations on one thread over a copy that moves as many bytes."""
    threads(1)
    rng = np.random.default_rng(2)
    r = Rotation(rng.normal(size=(n, 4)))
    q, m, v, e = r.as_quat(), r.as_matrix(), r.as_rotvec(), r.as_euler("ZYX")
    calls = {
        "as_matrix": (13, lambda: r.as_matrix()),
        "from_matrix": (13, lambda: Rotation.from_matrix(m)),
        "as_rotvec": (7, lambda: r.as_rotvec()),
        "from_rotvec": (7, lambda: Rotation.from_rotvec(v)),
        "as_euler": (7, lambda: r.as_euler("ZYX")),
        "from_euler": (7, lambda: Rotation.from_euler("ZYX", e)),
        "from_quat": (8, lambda: Rotation.from_quat(q)),
        "magnitude": (5, lambda: r.magnitude()),
        "mul": (12, lambda: r * r),
        "pow": (8, lambda: r**0.3),
    }
    found = {}
    for name, (numbers, call) in calls.items():
        a = np.ones(n * numbers // 2)
        b = np.ones_like(a)
        times = least({"ours": call, "copy": lambda a=a, b=b: np.copyto(b, a)}, seconds)  # type: ignore[misc]
        found[name] = times["ours"] / times["copy"]
    return found


def tracing(seconds: float) -> dict[str, float]:
    """Return the times to trace and compile exp and log by JAX over jaxlie's; each round compiles anew."""
    jax, jaxlie = import_module("jax"), import_module("jaxlie")
    v = jax.numpy.asarray(np.random.default_rng(3).normal(size=(100, 3)))
    r, s = Rotation.from_rotvec(v), jaxlie.SO3.exp(v)
    pairs = {
        "exp": ((Rotation.from_rotvec, v), (jaxlie.SO3.exp, v)),
        "log": ((lambda x: x.as_rotvec(), r), (lambda x: x.log(), s)),
    }

    def anew(call: Any, argument: Any) -> Callable[[], Any]:
        return lambda: jax.jit(lambda x: call(x)).lower(argument).compile()

    found = {}
    for name, (ours, theirs) in pairs.items():
        times = least({"ours": anew(*ours), "jaxlie": anew(*theirs)}, 10 * seconds)
        found[name] = times["ours"] / times["jaxlie"]
    return found


def main(arguments: list[str]) -> None:
    """Print the tables."""
    seconds = float(arguments[0]) if arguments else 0.1
    sizes = tuple(map(int, arguments[1].split(","))) if len(arguments) > 1 else SIZES
    folders = {"before": arguments[2], "ours": str(HERE)} if len(arguments) > 2 else {}
    states = {name: State(folder) for name, folder in folders.items()}
    missing = [name for name in PEERS if not find_spec(name)]
    print(f"left out, for they are not installed: {', '.join(missing) or 'none'}")
    table: dict[str, dict[int, str]] = {}
    for n in sizes:
        for name, ways in rotations(n).items():
            others = {state: found.timer(n, name) for state, found in states.items()}
            times = least(ways, seconds, others)
            ours, earlier = times.pop("ours"), times.pop("before", None)
            peer = min(times, key=lambda name: times[name])
            first = f"{earlier / times[peer]:.2f} → " if earlier else ""
            table.setdefault(name, {})[n] = f"{first}{ours / times[peer]:.2f} {PEERS[peer]}"
    for state in states.values():
        state.end()
    print("| our time over the quickest peer's | " + " | ".join(map(str, sizes)) + " |")
    print("|---|" + "---|" * len(sizes))
    for name, row in table.items():
        print(f"| {name} | " + " | ".join(row.get(n, "") for n in sizes) + " |")
    print(", ".join(f"{letter}: {name}" for name, letter in PEERS.items()))
    found = {"10⁶ on one thread over a copy of as many bytes": memory_bounds(seconds)}
    if find_spec("jaxlie"):
        found["traced and compiled by JAX over jaxlie"] = tracing(seconds)
    for what, ratios in found.items():
        print(f"{what}: " + ", ".join(f"{name} {x:.1f}" for name, x in ratios.items()))
    for number in (1, 2):
        run = [sys.executable, "-c", FIRST]
        answer = subprocess.run(run, capture_output=True, text=True, check=True).stdout
        numpy, ours, first = map(float, answer.split())
        print(
            f"new process {number}: numpy {numpy:.3f} s, rotation {ours:.3f} s, first call {first:.3f} s"
        )


if __name__ == "__main__":
    serve() if sys.argv[1:] == ["--serve"] else main(sys.argv[1:])
