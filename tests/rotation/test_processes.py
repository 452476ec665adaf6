"""Kernels in other processes and threads: imports, forks, exits, caches, machines without FMA."""

import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hfield
import rotation
from hfield.compiling import disk_cache, machine_code
from rotation import kernels
from rotation.fused import rotate, rotate_quat
from tests.patience import PATIENCE

ROOT = Path(rotation.__file__).parent.parent
Q = (1.0, 2.0, 3.0, 4.0)


def run(code: str, path: Path = ROOT, **environment: str) -> str:
    """Run the code in a fresh Python; return what it prints."""
    env = {**os.environ, "PYTHONPATH": str(path), "PYTHONDONTWRITEBYTECODE": "1", **environment}
    command = [sys.executable, "-W", "error", "-c", code]
    done = subprocess.run(
        command, cwd=path, env=env, capture_output=True, text=True, timeout=PATIENCE, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_importing_rotation_imports_no_numba() -> None:
    code = (
        "import sys, rotation, rotation.fused, rotation.kernels\n"
        "rotation.rotate, rotation.Rotation\n"
        "print([m for m in ('numba', 'llvmlite', 'scipy', 'sympy') if m in sys.modules])"
    )
    assert run(code) == "[]"


@pytest.mark.slow
def test_the_number_of_threads_comes_from_the_environment() -> None:
    code = "from rotation.kernels import threads; print(threads())"
    assert run(code, ROTATION_NUM_THREADS="3") == "3"
    wrong = (
        "from rotation.kernels import threads\nfrom rotation.errors import RotationError\n"
        "try: threads()\nexcept RotationError as error: print(error)"
    )
    message = "ROTATION_NUM_THREADS is 'many'; expected a whole number of at least 1"
    assert run(wrong, ROTATION_NUM_THREADS="many") == message


WORK = """
import numpy as np
from rotation.fused import rotate_quat
from rotation.kernels import threads
threads(4)
points = np.random.default_rng(1).normal(size=(900_000, 3))
expected = rotate_quat(points, (1.0, 2.0, 3.0, 4.0))
def same():
    return np.array_equal(rotate_quat(points, (1.0, 2.0, 3.0, 4.0)), expected)
"""


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_a_fork_after_use_works_in_parent_and_child() -> None:
    code = WORK + (
        "import os, sys\n"
        "child = os.fork()\n"
        "if child == 0: os._exit(0 if same() else 1)\n"
        "print(os.waitpid(child, 0)[1], same())"
    )
    # Python 3.12 warns of any fork with threads about; that it works is what is tested
    assert (
        run(code.replace("import os, sys", "import os, warnings; warnings.simplefilter('ignore')"))
        == "0 True"
    )


def test_spawned_pools_work() -> None:
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    points = np.arange(30.0).reshape(10, 3)
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        there = pool.submit(rotate_quat, points, Q).result(timeout=PATIENCE)
    np.testing.assert_array_equal(there, rotate_quat(points, Q))


@pytest.mark.slow
def test_calls_at_exit_work_without_helpers() -> None:
    code = WORK + "import atexit\natexit.register(lambda: print(same()))"
    assert run(code) == "True"


def test_many_python_threads_at_once() -> None:
    before = kernels.threads(3)
    rng = np.random.default_rng(4)
    points, axes, angles = (
        rng.normal(size=(60_000, 3)),
        rng.normal(size=(60_000, 3)),
        rng.normal(size=60_000),
    )
    expected = rotate(points, axes, angles)
    wrong: list[Any] = []

    def work() -> None:
        for _ in range(5):
            if not np.array_equal(rotate(points, axes, angles), expected):
                wrong.append(threading.current_thread().name)

    workers = [threading.Thread(target=work) for _ in range(8)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    kernels.threads(before)
    assert not wrong


def installed(target: Path) -> Path:
    """Copy the packages, without any cache, to where a test can change them."""
    for package in (rotation, hfield):
        source = Path(str(package.__file__)).parent
        shutil.copytree(
            source,
            target / source.name,
            ignore=shutil.ignore_patterns("__pycache__", "ledger", "bench"),
        )
    return target


ONE = (
    "import numpy as np, rotation.fused as f; v = np.tile([1.0, 2.0, 3.0], (60_000, 1)); "
    "print(f.rotate_quat(v, (1.0, 1.0, 1.0, 1.0))[-1])"
)


@pytest.mark.slow
def test_nowhere_to_write_a_cache(tmp_path: Path) -> None:
    """The home directory is a plain file: not even root can write into it."""
    root = installed(tmp_path / "site")
    home = tmp_path / "home"
    home.write_text("")
    nowhere = {"HOME": str(home), "XDG_CACHE_HOME": str(home), "NUMBA_CACHE_DIR": ""}
    assert run(ONE, root, **nowhere) == "[3. 1. 2.]"


@pytest.mark.slow
def test_machine_code_is_kept_and_follows_the_formulas(tmp_path: Path) -> None:
    root, cache = installed(tmp_path / "site"), tmp_path / "cache"
    place = {"NUMBA_CACHE_DIR": str(cache)}

    def kept() -> int:
        names = {path.name for path in (cache / disk_cache.FOLDER).iterdir()}
        return len(names - {disk_cache.SECRET})

    def computed() -> int:
        assert run(ONE, root, **place) == "[3. 1. 2.]"
        return kept()

    first = computed()
    assert computed() == first
    formulas = root / "rotation" / "kernels" / "formulas.py"
    formulas.write_text(formulas.read_text().replace("(y - y)", "(y - y * 1.0)"))
    assert computed() == first + 1
    assert computed() == first + 1


@pytest.mark.slow
def test_the_range_reduction_needs_no_fma(tmp_path: Path) -> None:
    code = """
import math
import numpy as np
import llvmlite.binding as llvm
from hfield.compiling import machine_code
from rotation.fused import rotate
found = []
if PLAIN:
    llvm.get_host_cpu_name = lambda: "generic"
    machine_code._features = lambda: llvm.FeatureMap()
emit = llvm.TargetMachine.emit_object
def emitted(target, module):
    found.append(target.emit_assembly(module))
    return emit(target, module)
llvm.TargetMachine.emit_object = emitted
angles = np.random.default_rng(5).uniform(-1e9, 1e9, 60_000)
turned = rotate(np.array([1.0, 0.0, 0.0]), np.broadcast_to([0.0, 0.0, 1.0], (60_000, 3)), angles)
worst = max(abs(v[1] - math.sin(a)) for v, a in zip(turned, angles))
print(worst <= 5 * 2.0**-52, any("fmadd" in text for text in found))
"""
    cache = str(tmp_path / "cache")
    assert run(code.replace("PLAIN", "True"), NUMBA_CACHE_DIR=cache) == "True False"
    if machine_code.processor_has("fma"):
        assert run(code.replace("PLAIN", "False"), NUMBA_CACHE_DIR=cache) == "True True"


@pytest.mark.slow
def test_numba_told_not_to_compile_is_replaced_by_the_twins() -> None:
    code = (
        "import numpy as np\n"
        "from rotation import Rotation, rotate, rotate_euler\n"
        "p = np.random.default_rng(0).random((6, 3)); p[2, 0] = np.inf; q = Rotation.random(6, 1)\n"
        "results = [q.apply(p), q[0].apply(p), rotate(p, p[::-1], p[:, 1]), rotate_euler(p, p, 'xzx'),\n"
        "           Rotation.from_rotvec(np.ones((60000, 3)))[:6].as_rotvec()]\n"
        "try: rotate(p, 0 * p[:2, None], 1.0)\n"
        "except ValueError as error: print(type(error).__name__)\n"
        "print(repr(np.round(results, 9).tolist()))"
    )
    assert run(code, NUMBA_DISABLE_JIT="1") == run(code)


@pytest.mark.slow
def test_an_empty_variable_is_as_none() -> None:
    code = "import rotation; print(rotation.threads() >= 1)"
    assert run(code, ROTATION_NUM_THREADS="") == "True"
