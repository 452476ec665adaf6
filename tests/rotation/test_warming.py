"""What is compiled is said once on a terminal, never in a pipe; `warm_up` misses nothing."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import rotation
from rotation import kernels
from rotation.kernels import chains, uncompiled

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


@pytest.mark.skipif(not hasattr(os, "openpty"), reason="this system has no such terminals")
def test_compiling_is_said_once_on_terminals_only_and_not_of_what_is_kept(tmp_path: Path) -> None:
    assert said(tmp_path / "piped", terminal=False) == ""
    first = said(tmp_path / "here", terminal=True)
    assert first.startswith("rotation: compiling a loop for many points")
    assert first.count("\n") == 1
    assert said(tmp_path / "here", terminal=True) == ""


def test_warm_up_asks_for_every_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = set()

    def kernel(name: tuple[Any, ...], *_: Any) -> None:
        asked.add(name[0])

    def cumulative(q: Any) -> None:
        asked.add("cumulative")

    monkeypatch.setattr(kernels, "_kernel", kernel)
    monkeypatch.setattr(uncompiled, "run", lambda *_: False)
    monkeypatch.setattr(chains, "cumulative", cumulative)
    rotation.warm_up()
    assert asked == set(kernels.__all__) - {"threads"}


def test_warm_up_makes_the_formulas_of_rotations() -> None:
    code = """
from rotation import acting, kernels, matrices, quaternions, vectors, warm_up
from rotation.rowwise import Formula
kernels._run = lambda *_: False
warm_up()
for room in (acting, matrices, quaternions, vectors):
    for name, value in vars(room).items():
        found = value.values() if isinstance(value, dict) else value if isinstance(value, list) else [value]
        for f in found:
            if isinstance(f, Formula) and f._function is None:
                print(room.__name__, name)
"""
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True
    )
    assert done.stdout == ""
