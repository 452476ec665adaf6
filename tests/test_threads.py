"""What threads call at once for the first time: fresh processes of `scripts/stress_threads.py`."""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import rotation
from hfield import H
from tests.thorough import cases

pytestmark = pytest.mark.slow

PROCESSES = cases(20)
SCRIPT = Path(__file__).parent.parent / "scripts" / "stress_threads.py"
NO_CALLS = {
    "DTypeError",
    "ForeignArrayError",
    "RotationError",
    "ZeroRotationError",
    "Screw",
    "compat",
}
COMPILES_ALL = {"warm_up"}
DRAWS_OR_TIMES = {"LETTER_T", "benchmark", "draw_plane", "plot"}
# Attributes of a quaternion that compute nothing with an array.
NOT_OF_ARRAYS = {
    "algebra", "annihilator", "change_ring", "characteristic_polynomial", "conj", "conjugacy",
    "conjugator", "diff", "free_symbols", "inv", "is_batch", "is_idempotent", "is_nilpotent",
    "is_unit", "is_zero_divisor", "matrix", "minimal_polynomial", "order", "ring",
    "rotation_matrix", "scalar_part", "shape", "square_roots", "subs", "text", "text_for",
    "vector", "vector_part",
}  # fmt: skip


@pytest.fixture(scope="module")
def stress() -> ModuleType:
    spec = importlib.util.spec_from_file_location("stress_threads", SCRIPT)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def methods(kind: Any) -> set[str]:
    return {
        name
        for name in dir(kind)
        if not name.startswith("_")
        and name not in {"foreign_names", *getattr(kind, "foreign_names", ())}
    }


def test_every_public_function_of_rotation_is_called(stress: ModuleType) -> None:
    public = set(rotation.__all__) - NO_CALLS - COMPILES_ALL
    for kind in (rotation.Rotation, rotation.RigidTransform, rotation.RotationSpline):
        public |= methods(kind)
    assert public - DRAWS_OR_TIMES <= stress.named()


def test_every_operation_on_arrays_is_called(stress: ModuleType) -> None:
    public = {name for name in dir(H("QQ").one) if not name.startswith("_")}
    assert public >= NOT_OF_ARRAYS
    assert public - NOT_OF_ARRAYS <= stress.named()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_threads_that_call_for_the_first_time_get_what_one_gets() -> None:
    done = subprocess.run(
        [sys.executable, SCRIPT, "--processes", str(PROCESSES)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    n = PROCESSES // 4
    assert done.stdout.startswith(
        f"{PROCESSES} processes ({n} cold, {n} warm, {n} fork, {n} spawn) of 8 threads"
    )
