"""What is compiled is said once on a terminal, never in a pipe; `warm_up` misses nothing."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import rotation
from rotation import kernels
from rotation.kernels import uncompiled

ROOT = Path(rotation.__file__).parent.parent
# Two kernels that are kept nowhere, one that is kept in a folder; announced as calls announce them.
ANNOUNCED = """
from types import SimpleNamespace as Kernel
from rotation.kernels.announcing import announce
def one(): pass
for place in ({place!r}, None, None):
    announce(Kernel(stats=Kernel(cache_path=place), py_func=one))
"""


def said(code: str, terminal: bool) -> str:
    """Run code in a new Python; return what it writes to stderr, a terminal or a pipe."""
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    reading, writing = os.openpty() if terminal else os.pipe()
    with os.fdopen(reading, "rb", 0) as stream:
        subprocess.run([sys.executable, "-c", code], env=env, stderr=writing, check=True)
        os.write(writing, b"|")  # a terminal may not be read when all have closed it
        os.close(writing)
        return stream.read(4096).decode().removesuffix("|")


@pytest.mark.skipif(not hasattr(os, "openpty"), reason="this system has no such terminals")
def test_compiling_is_said_once_and_on_terminals_only(tmp_path: Path) -> None:
    code = ANNOUNCED.format(place=str(tmp_path))
    first = said(code, terminal=True)
    assert first.startswith("rotation: compiling the loops for many points")
    assert first.count("\n") == 1
    assert said(code, terminal=False) == ""


@pytest.mark.skipif(not hasattr(os, "openpty"), reason="this system has no such terminals")
def test_what_is_kept_on_disk_is_read_without_a_word(tmp_path: Path) -> None:
    (tmp_path / "one.one-12.py311.nbi").touch()
    code = ANNOUNCED.format(place=str(tmp_path)).replace(", None, None", ",")
    assert said(code, terminal=True) == ""


def test_warm_up_asks_for_every_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = set()

    def kernel(name: str) -> None:
        asked.add(name)

    monkeypatch.setattr(kernels, "_kernel", kernel)
    monkeypatch.setattr(uncompiled, "run", lambda *_: False)
    rotation.warm_up()
    assert asked == set(kernels.__all__) - {"threads"}


def test_warm_up_makes_the_formulas_of_rotations() -> None:
    code = """
from rotation import acting, kernels, matrices, quaternions, vectors, warm_up
from rotation.kernels import twins, uncompiled
from rotation.rowwise import Formula
kernels._kernel = lambda name: None
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
