"""What is compiled is said once on a terminal, never in a pipe; `warm_up` misses nothing."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import rotation
from rotation import kernels
from rotation.kernels import chains, numpy_kernels

ROOT = Path(rotation.__file__).parent.parent
# Two loops, one for each precision, of more points than formulas do.
POINTS = """
import numpy as np
from rotation import rotate_quat
for kind in (np.float64, np.float32):
    rotate_quat(np.ones((60_000, 3), kind), [1.0, 2.0, 3.0, 4.0])
"""


def said(place: Path, terminal: bool) -> str:
    """Rotate points in a new Python; return what it writes to stderr, a terminal or a pipe."""
    env = {**os.environ, "PYTHONPATH": str(ROOT), "NUMBA_CACHE_DIR": str(place)}
    reading, writing = os.openpty() if terminal else os.pipe()
    with os.fdopen(reading, "rb", 0) as stream:
        subprocess.run([sys.executable, "-c", POINTS], env=env, stderr=writing, check=True)
        os.write(writing, b"|")  # a terminal may not be read when all have closed it
        os.close(writing)
        return stream.read(4096).decode().removesuffix("|")


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "openpty"), reason="this system has no such terminals")
def test_compiling_is_said_once_on_terminals_only_and_not_of_what_is_kept(tmp_path: Path) -> None:
    assert said(tmp_path / "piped", terminal=False) == ""
    first = said(tmp_path / "here", terminal=True)
    assert first.startswith("rotation: compiling a loop for many points")
    assert first.count("\n") == 1
    assert said(tmp_path / "here", terminal=True) == ""


def test_warm_up_asks_for_every_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    compiled = set()

    def kernel(name: tuple[Any, ...], *_: Any) -> None:
        compiled.add(name[0])

    def cumulative(q: Any) -> None:
        compiled.add("cumulative")

    monkeypatch.setattr(kernels, "_kernel", kernel)
    monkeypatch.setattr(numpy_kernels, "run", lambda *_: False)
    monkeypatch.setattr(chains, "cumulative", cumulative)
    rotation.warm_up()
    assert compiled == set(kernels.__all__) - {"threads"}


@pytest.mark.slow
def test_after_warm_up_nothing_is_compiled() -> None:
    code = """
import numpy as np
from hfield.compiling import machine_code
from rotation import RigidTransform, Rotation, left_jacobian, rotate, rotate_euler, rotate_quat, warm_up
from rotation import inverse_left_jacobian, swing_twist
warm_up("XYZ")
machine_code.compiled = lambda text, *_, **__: print("compiled", flush=True)
rng = np.random.default_rng(1)
for n in (1, 50, 60_000):
    q, a, b = rng.normal(size=(n, 4)), rng.normal(size=(n, 3)), rng.normal(size=n)
    r = Rotation(q)
    for kind in (np.float64, np.float32):
        for finer in {np.float64, kind}:
            v, e, t = a.astype(kind), a[::-1].astype(finer), b.astype(finer)
            for axes, angles in ((e, t), (e[0], t), (e, t[0]), (e[0], t[0])):
                rotate(v, axes, angles), rotate(v, axes, angles, out=v.copy())
                rotate(np.ascontiguousarray(v.T), axes.T.copy(), angles, layout="soa")
            rotate(v[0], e, t), rotate_quat(v[0], q.astype(finer)), rotate_euler(v[0], e, "XYZ")
            for angles, p in ((e, q.astype(finer)), (e[0], q[0])):
                rotate_euler(v, angles, "XYZ"), rotate_quat(v, p), rotate_quat(v, p, out=v.copy())
        r.apply(v), r.apply(v, inverse=True), r[0].apply(v), r[0].apply(v, inverse=True)
        Rotation.from_matrix(r.as_matrix().astype(kind))
    for degrees in (False, True):
        Rotation.from_euler("XYZ", r.as_euler("XYZ", degrees), degrees)
        Rotation.from_rotvec(r.as_rotvec(degrees), degrees)
        Rotation.from_axis_angle(*r.as_axis_angle(degrees), degrees)
    Rotation.from_matrix(1.1 * r.as_matrix(), orthonormalize=True)
    Rotation.from_mrp(r.as_mrp()), r.as_quat(canonical=True), r.mean(), r.cumprod(), r * r, r**b, r.inv()
    left_jacobian(a), inverse_left_jacobian(a), swing_twist(r, a)
    t = RigidTransform.from_components(a, r)
    t * t, t**0.5, t.inv(), t.apply(a), t.apply(a, inverse=True), t.mean(), t.as_screw()
    RigidTransform.from_matrix(t.as_matrix()), RigidTransform.from_exp_coords(t.as_exp_coords())
    RigidTransform.from_dual_quat(t.as_dual_quat())
"""
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True
    )
    assert done.stdout == ""


@pytest.mark.slow
def test_warm_up_makes_the_formulas_of_rotations() -> None:
    code = """
from rotation import action, kernels, matrices, quaternions, vectors, warm_up
from rotation.rowwise import RowFormula, unmade
kernels._run = lambda *_, **__: False
warm_up()
for module in (action, matrices, quaternions, vectors):
    for name, value in vars(module).items():
        found = value.values() if isinstance(value, dict) else value if isinstance(value, list) else [value]
        for f in found:
            if isinstance(f, RowFormula) and f.function is unmade:
                print(module.__name__, name)
"""
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True
    )
    assert done.stdout == ""
