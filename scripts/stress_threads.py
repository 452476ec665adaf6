"""Eight threads at a time call what is compiled on first use, in fresh processes, cold and warm.

Every public function of ``rotation`` and every operation on arrays of ``hfield`` is called, a sample of them
in each process. The threads wait for each other before each call, or each begins elsewhere and does not wait.
What comes out is compared with what one thread got in peace. Four kinds of processes take turns:

- cold: nothing is kept on disk;
- warm: everything is;
- fork: cold, and children are forked while the threads compile, which call the same;
- spawn: cold, and another process does the same with the same folder of machine code.

    python scripts/stress_threads.py --processes 1000
    python scripts/stress_threads.py --one 17 --reference FILE    # number 17 again, alone
"""

import argparse
import ast
import faulthandler
import hashlib
import json
import os
import random
import signal
import subprocess
import sys
import sysconfig
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from pkgutil import walk_packages
from typing import Any

THREADS = 8
APART = ("bench", "commands", "compat", "figures", "ledger", "report", "thesis")  # of rotation
KINDS = ("cold", "warm", "fork", "spawn")
SAMPLE = {"rotation": 12, "hfield": 12, "galois": 3}
MANY = 600_000  # elements, which threads share
PATIENCE = 600  # seconds until a process is given up, and says where its threads are

# --- what is called ----------------------------------------------------------------------------------
# With points V and W (n, 3), their angles T, quaternions Q (n, 4) of any length, and what is made of them.

ROTATION = (
    "rotate(V, W, T)",
    "rotate(V, W[0], 0.3)",
    "rotate(V.astype('f4'), W.astype('f4'), T.astype('f4'))",
    "rotate(V.T.copy(), W.T.copy(), T, layout='soa', degrees=True)",
    "rotate(V[:, ::-1], W[::-1], T)",
    "rotate_quat(V, Q)",
    "rotate_quat(V, Q[0])",
    "rotate_quat(V[0], Q)",
    "rotate_quat(V, Q, out=V.copy())",
    "rotate_euler(V, W)",
    "rotate_euler(V, W, 'xzx', degrees=True)",
    "(R_x(T), R_y(T, degrees=True), R_z(0.3))",
    "(R2(0.3), reflection(0.3), rotate2(V[:, :2], 0.3), reflect2(V[:, :2], 0.3))",
    "T_q(Q[0], V)",
    "left_jacobian(V)",
    "inverse_left_jacobian(V)",
    "(right_jacobian(V), inverse_right_jacobian(U), ad(U), vee(hat(V)))",
    "integrate(V[:200], LONG[:200])",
    "integrate(lambda t: V[int(t) % 7], LONG[:50], frame='world')",
    "slerp(Rotation(Q), Rotation(Q[0]), T)",
    "squad(Rotation(Q), Rotation(Q[0]), Rotation(Q[1]), Rotation(Q[2]), T)",
    "Slerp(LONG[:50], Rotation(Q[:50]))(LONG[:49] + 0.25)",
    "Squad(LONG[:50], Rotation(Q[:50]))(LONG[:49] + 0.25)",
    "[RotationSpline(LONG[:50], Rotation(Q[:50]))(LONG[:49] + 0.25, n) for n in (0, 1, 2)]",
    "RotationSpline(LONG[:50], Rotation(Q[:50])).extended(LONG[:50] + 0.25)",
    "[BSpline(Rotation(Q[:50]))(LONG[:40] + 1.25, n) for n in (0, 1)]",
    "angular_velocity(Rotation(Q[:50]), LONG[:50], 'world')",
    "swing_twist(Rotation(Q), V)",
    "align(V, W)",
    "align_points(V, W)",
    "[m.apply(V) for m in [align_similarity(V, W)] if isinstance(m, Similarity)]",
    "look_at(V, W)",
    "[(from_exact(g), exact_matrix(g[0])) for g in [exact_group('T')]]",
    "[(u.mean, (u * u).covariance) for u in [Uncertain(Rotation(Q), np.eye(3))]]",
    "(change_of_axes('opencv', 'opengl'), convert_points(V, 'opencv', 'opengl'))",
    "convert_rotation(Rotation(Q), 'opencv', 'opengl')",
    "convert_transform(RigidTransform.from_translation(V), 'opencv', 'opengl')",
    "sclerp(RigidTransform.from_translation(V), RigidTransform.from_rotation(Rotation(Q)), T)",
    "(threads() > 0, Rotation.identity(3), RigidTransform.identity(3))",
    # of rotations
    "Rotation(Q).as_quat(canonical=True)",
    "Rotation(Q, dtype='float32').astype('float64').dtype.itemsize",
    "Rotation.from_quat(Q, scalar_first=False).as_matrix()",
    "Rotation.from_matrix(Rotation(Q).as_matrix())",
    "Rotation.from_matrix(1.1 * Rotation(Q).as_matrix(), orthonormalize=True)",
    "Rotation.from_rotvec(V).as_rotvec(degrees=True)",
    "Rotation.from_axis_angle(V, T).as_axis_angle()",
    "Rotation.from_euler('ZYX', V, degrees=True).as_euler('ZYX', degrees=True)",
    "Rotation.from_euler('xzx', V).as_euler('yxz')",
    "Rotation.from_davenport(np.eye(3), 'extrinsic', V).as_davenport(np.eye(3), 'extrinsic')",
    "Rotation.from_davenport(Rotation(Q).as_matrix(), 'intrinsic', V)",
    "Rotation.from_mrp(V).as_mrp()",
    "list(Rotation(Q).as_columns().values())",
    "Rotation.from_6d(W.repeat(2, 1)[:, ::-1]).as_6d()",
    "Rotation.between(V, W)",
    "Rotation.random(3000, seed=1)",
    "Rotation.create_group('I')",
    "Rotation.align_vectors(V, W)",
    "Rotation.concatenate([Rotation(Q), Rotation(Q[::-1])]).reshape(2, -1)",
    "Rotation(Q).apply(V)",
    "Rotation(Q).apply(V, inverse=True)",
    "Rotation(Q[0]).apply(V)",
    "Rotation(Q[:9]).apply_outer(V[:99])",
    "Rotation(Q) * Rotation(Q[::-1])",
    "Rotation(Q[:9]).outer(Rotation(Q[:99]))",
    "Rotation(Q) ** 0.3",
    "(Rotation(Q).inv(), Rotation(Q).inverse(), Rotation(Q).magnitude(degrees=True))",
    "Rotation(Q).approx_equal(Rotation(-Q))",
    "[Rotation(Q).cumprod(), Rotation(Q).cumprod(frame='body')]",
    "Rotation(Q).mean(weights=abs(T))",
    "Rotation(Q[:99]).median()",
    "Rotation(Q[:999]).disorientation(Rotation(Q[1:1000]), 'O')",
    "Rotation.super_fibonacci(999)",
    "(Rotation.exp(V).log(), Rotation(Q).adjoint())",
    "(Rotation(Q).plus(V), Rotation(Q).minus(Rotation(Q[::-1])))",
    "Rotation(Q[:99]).reduce(Rotation.create_group('O'))",
    "Rotation.from_scipy(Rotation(Q[:9]).to_scipy()) if SCIPY else 0",
    "[Rotation(Q)[3:5], len(Rotation(Q)), Rotation(Q) == Rotation(Q[::-1]), list(Rotation(Q[:3]))]",
    "(Rotation(Q).ndim, Rotation(Q).shape, Rotation(Q).single, Rotation(Q).size)",
    # of rigid motions
    "RigidTransform.from_components(V, Rotation(Q)).as_components()",
    "RigidTransform.from_matrix(RigidTransform.from_exp_coords(U).as_matrix())",
    "RigidTransform.from_exp_coords(U).as_exp_coords()",
    "RigidTransform.from_dual_quat(RigidTransform.from_exp_coords(U).as_dual_quat())",
    "RigidTransform.from_screw(V, W, T, T).as_screw()",
    "RigidTransform.from_exp_coords(U).apply(V)",
    "RigidTransform.from_exp_coords(U).apply(V, inverse=True)",
    "RigidTransform.from_exp_coords(U) * RigidTransform.from_exp_coords(U[::-1])",
    "RigidTransform.from_exp_coords(U) ** 0.3",
    "(RigidTransform.from_exp_coords(U).inv(), RigidTransform.from_exp_coords(U).inverse())",
    "RigidTransform.from_exp_coords(U).mean()",
    "RigidTransform.align(V, W)",
    "RigidTransform.from_exp_coords(U).approx_equal(RigidTransform.from_exp_coords(U[::-1]))",
    "RigidTransform.concatenate([RigidTransform.from_exp_coords(U)] * 2)[4:7]",
    "(RigidTransform.from_translation(V).translation, RigidTransform.from_translation(V).rotation)",
    "[(M.ndim, M.shape, M.single, M.size) for M in [RigidTransform.from_translation(V)]]",
)
LOOPS = (
    *("GF(2)", "GF(7)", "GF(65537)", "GF(2147483647)", "GF(4)", "GF(2^8)", "GF(2^40)", "GF(9)"),
    *("GF(7^3)", "GF(3^9)", "ZZ/6", "ZZ/4294967296", "ZZ", "QQ"),
)
RINGS = (*LOOPS, "RDF", "QQ(sqrt(2))")  # the last have no loops of their own
# With arrays p and q (n,) of an algebra A over one of them.
OPERATIONS = (
    *("p + q", "p - q", "-p", "p * q", "p * 3", "p[0] * q", "p ** 3", "p == q", "p.conjugate()"),
    *(
        "p.is_zero()",
        "p.units()",
        "p.sum()",
        "p.product()",
        "p.dot(q)",
        "p.cross(q)",
        "p[2:5]",
        "list(p[:3])",
    ),
    *("p.reshape(2, -1)", "len(p)", "A.product(list(p[:9]))", "numbers(A, p)", "inverted(p)"),
    *("many(A) * many(A)[0]", "every(A)"),
)
FLOATS = (
    *("(1 + p).exp()", "(1 + p).log()", "(1 + p).sqrt()", "(1 + p).unit()"),
    *("(1 + p).polar()", "(1 + p).roots(3)"),
)
GALOIS = ("p.coordinates", "p.norm()", "p.trace()", "p.norm() * q.norm()", "p.scalar_part")


def calls() -> dict[str, list[str]]:
    """Return the calls by area: ``RING: OPERATION`` over rings."""
    return {
        "rotation": list(ROTATION),
        "hfield": [
            *(f"{ring}: {operation}" for ring in RINGS for operation in OPERATIONS),
            *(f"RDF: {operation}" for operation in FLOATS),
        ],
        "galois": [f"{ring}: {operation}" for ring in RINGS for operation in GALOIS],
    }


def named() -> set[str]:
    """Return all names and attributes that the calls mention."""
    trees = (ast.walk(ast.parse(text)) for text in (*ROTATION, *OPERATIONS, *FLOATS, *GALOIS))
    found = set[str]()
    for node in (node for tree in trees for node in tree):
        if isinstance(node, ast.Name | ast.Attribute):
            found.add(node.id if isinstance(node, ast.Name) else node.attr)
    return found | {"from_array", "to_array", "inverse", "element_array"}  # in the functions below


class Caller:
    """What the calls are evaluated in; nothing of it is compiled yet."""

    def __init__(self) -> None:
        import numpy as np

        import rotation

        rng, n = np.random.default_rng(7), 3_000
        self.names: dict[str, Any] = {
            "np": np,
            "V": rng.normal(size=(20 * n, 3)),
            "W": rng.normal(size=(20 * n, 3)),
            "T": rng.normal(size=20 * n),
            "Q": rng.normal(size=(20 * n, 4)),
            "U": rng.normal(size=(20 * n, 6)),
            "LONG": np.arange(float(n)),
            "SCIPY": find_spec("scipy") is not None,
            "many": lambda A: A(*self.drawn[:, : MANY if A.ring.name in LOOPS else 60], 0, 1),
            "every": lambda A: A.element_array() if (A.ring.order or 9) < 5 else None,
            "numbers": _numbers,
            "inverted": _inverted,
        }
        self.drawn = rng.integers(0, 2, (2, MANY))
        self.few = rng.integers(0, 2, (8, 200))
        self.names |= {name: getattr(rotation, name) for name in rotation.__all__}
        self.short = {**self.names, **{k: self.names[k][:n] for k in "VWTQU"}}

    def digest(self, call: str) -> str:
        """Return a checksum of what a call returns."""
        ring, colon, operation = call.partition(": ")
        if colon and ring in RINGS:
            from hfield import H

            A = H(ring)
            p, q = A(*self.few[:4]), A(*self.few[4:])
            value = eval(operation, {**self.names, "A": A, "p": p, "q": q})
        else:
            value = eval(call, self.names if call.startswith("rotate") else self.short)
        found = hashlib.sha256()
        _feed(found, value)
        return found.hexdigest()


def _numbers(A: Any, p: Any) -> Any:
    from hfield.errors import CoercionError

    try:
        return A.from_array(p.to_array())
    except CoercionError:
        return None


def _inverted(p: Any) -> Any:
    return p[p.units()].inverse()


def _feed(found: Any, value: Any) -> None:
    import numpy as np

    from hfield import Quaternion
    from hfield.errors import CoercionError

    if isinstance(value, np.ndarray):
        found.update(f"{value.shape} {value.dtype.kind}".encode())
        plain = value.dtype == object
        found.update(str(value.tolist()).encode() if plain else np.ascontiguousarray(value).data)
    elif isinstance(value, Quaternion):
        try:
            _feed(found, value.to_array())
        except CoercionError:
            found.update(str([str(x) for x in value] if value.is_batch else value).encode())
    elif hasattr(value, "as_dual_quat"):
        _feed(found, value.as_matrix())
    elif hasattr(value, "as_quat"):
        _feed(found, value.as_quat())
    elif isinstance(value, list | tuple):
        for part in value:
            _feed(found, part)
    else:
        found.update(repr(value).encode())


# --- one process -------------------------------------------------------------------------------------


def kind(number: int) -> str:
    """Return the kind of a process."""
    return KINDS[number % len(KINDS)]


def sample(number: int) -> tuple[list[str], bool]:
    """Return what the threads of a process call, and whether they wait before each call."""
    rng = random.Random(number)
    area = rng.choices(tuple(SAMPLE), (10, 10, 1 if find_spec("numba") else 0))[0]
    every = calls()[area]
    if area != "rotation":  # of a few rings
        rings = rng.sample(RINGS, 1 if area == "galois" else 3)
        every = [call for call in every if call.partition(": ")[0] in rings]
    count = SAMPLE[area] * (2 if kind(number) == "warm" else 1)
    return rng.sample(every, min(count, len(every))), rng.random() < 0.6


def one(number: int, reference: Path, spawned: bool) -> None:
    """Be one process; raise AssertionError where something is not as it is in peace."""
    wanted = json.loads(reference.read_text())
    chosen, together = sample(number)
    caller = Caller()
    wrong = list[str]()
    barrier = threading.Barrier(THREADS + 1, timeout=PATIENCE)

    def check(call: str) -> None:
        try:
            found = caller.digest(call)
        except Exception as error:
            found = repr(error)
        if found != wanted[call]:
            wrong.append(f"{call}: {found}")

    def work(place: int) -> None:
        begin = 0 if together else place * len(chosen) // THREADS
        barrier.wait()
        for call in chosen[begin:] + chosen[:begin]:
            if together:
                barrier.wait()
            check(call)

    if kind(number) == "fork":
        _import_all(chosen)
        faulthandler.register(signal.SIGALRM, chain=True)
    threads = [threading.Thread(target=work, args=(n,)) for n in range(THREADS)]
    for thread in threads:
        thread.start()
    other = None
    if kind(number) == "spawn" and not spawned:
        again = [sys.executable, *sys.argv, "--spawned"]
        other = subprocess.Popen(again)
    barrier.wait()
    children = list[int]()
    for call in chosen:
        if together:
            barrier.wait()
        if kind(number) == "fork":
            children.append(_forked(partial(check, call), wrong))
    for thread in threads:
        thread.join()
    for child in children:
        assert os.waitpid(child, 0)[1] == 0, "a forked child failed"
    if other is not None:
        assert other.wait(PATIENCE) == 0, "a spawned process failed"
    assert not wrong, wrong


def _forked(task: Callable[[], None], wrong: list[str]) -> int:
    """Do a task in a child, which has no other thread; return its number."""
    child = os.fork()
    if child:
        return child
    signal.alarm(PATIENCE // 2)  # Python's own watch is a thread, which the child has not
    wrong.clear()
    task()
    if wrong:
        print("in a forked child:", wrong, file=sys.stderr, flush=True)
    os._exit(bool(wrong))


def _import_all(chosen: list[str]) -> None:
    """Import what the calls need: of an import in another thread a child has the lock, and no end."""
    import hfield.algebra
    import hfield.algebra.structure
    import hfield.compiling
    import hfield.fields
    import rotation

    packages = (hfield.compiling, hfield.fields, hfield.algebra.structure)
    for package in (*packages, rotation):
        for found in walk_packages(package.__path__, f"{package.__name__}."):
            if found.name.split(".")[1] not in APART and (
                "galois" not in found.name or set(chosen) & set(calls()["galois"])
            ):
                import_module(found.name)
    import_module("llvmlite.binding")
    if find_spec("scipy"):
        import_module("scipy.spatial.transform")


# --- many processes ----------------------------------------------------------------------------------


def in_peace(numbers: range) -> dict[str, str]:
    """Call in one thread what the processes of these numbers will; return the checksums."""
    caller = Caller()
    wanted = dict.fromkeys(call for number in numbers for call in sample(number)[0])
    return {call: caller.digest(call) for call in wanted}


def run(number: int, folder: Path) -> str:
    """Run one process; return what was wrong."""
    with tempfile.TemporaryDirectory(dir=folder) as fresh:
        place = str(folder / "warm") if kind(number) == "warm" else fresh
        command = [sys.executable, "-W", "ignore", __file__, "--one", str(number)]
        command += ["--reference", str(folder / "reference.json")]
        env = {**os.environ, "NUMBA_CACHE_DIR": place}
        with open(folder / f"{number}", "w+b") as said:
            done = subprocess.run(command, env=env, stderr=said, check=False)
            said.seek(0)
            output = said.read()[-3000:].decode(errors="replace")
    return "" if done.returncode == 0 else f"exit {done.returncode}\n{output}"


def campaign(numbers: list[int], jobs: int, seconds: float) -> int:
    """Run the processes of these numbers, as many as the time allows; return how many failed."""
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        env = {**os.environ, "NUMBA_CACHE_DIR": str(folder / "warm")}
        command = [sys.executable, "-W", "ignore", __file__, "--first", str(min(numbers))]
        command += ["--processes", str(max(numbers) - min(numbers) + 1)]
        subprocess.run(
            [*command, "--reference", str(folder / "reference.json")], env=env, check=True
        )
        count, failed, called = Counter[str](), list[str](), set[str]()

        def go(number: int) -> None:
            if time.monotonic() - began >= seconds:
                return
            wrong = run(number, folder)
            count[kind(number)] += 1
            called.update(sample(number)[0])
            if wrong:
                failed.append(f"{number} ({kind(number)}): {wrong}")
                print(failed[-1], flush=True)

        with ThreadPoolExecutor(jobs) as pool:
            list(pool.map(go, numbers))
    every = sum(map(len, calls().values()))
    kinds = ", ".join(f"{count[name]} {name}" for name in KINDS)
    lock = "without" if sysconfig.get_config_var("Py_GIL_DISABLED") else "with"
    print(
        f"{count.total()} processes ({kinds}) of {THREADS} threads {lock} the interpreter lock, "
        f"{len(called)} of {every} calls, {len(failed)} failed, {time.monotonic() - began:.0f} s"
    )
    return len(failed)


def main(arguments: list[str] | None = None) -> int:
    """Run the campaign, or one process of it."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--processes", type=int, default=40, metavar="N")
    parser.add_argument("--first", type=int, default=0, metavar="N", help="the first one's number")
    parser.add_argument("--without", default="", metavar="KIND", help="leave a kind out")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="processes at a time")
    parser.add_argument("--seconds", type=float, default=3600.0, help="begin none after that")
    parser.add_argument("--one", type=int, metavar="N", help="be process number N")
    parser.add_argument("--spawned", action="store_true", help="begun by another one")
    parser.add_argument("--reference", metavar="FILE", help="the checksums; written without --one")
    args = parser.parse_args(arguments)
    if args.one is not None:
        faulthandler.enable()
        faulthandler.dump_traceback_later(PATIENCE, exit=True)
        one(args.one, Path(args.reference), args.spawned)
        return 0
    if args.reference is not None:
        numbers = range(args.first, args.first + args.processes)
        Path(args.reference).write_text(json.dumps(in_peace(numbers)))
        return 0
    wanted = [n for n in range(args.first, args.first + args.processes) if kind(n) != args.without]
    return int(campaign(wanted, args.jobs, args.seconds) > 0)


if __name__ == "__main__":
    sys.exit(main())
