"""scipy's own tests of its rotations, run from its wheel with `rotation.compat` in their place.

Nothing of them is here. What does not pass is named with its reason; what is named and passes is an
error too.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("scipy", minversion="1.17")

EXPECTED = {
    "test_rotation.py::test_cython_backend_selection": "asks which of scipy's two backends computes",
}


@pytest.mark.slow
def test_scipys_own_tests_pass_but_for_those_named(tmp_path: Path) -> None:
    results, settings = tmp_path / "results.json", tmp_path / "pytest.ini"
    settings.write_text("[pytest]\n")
    plugins = ("no:cacheprovider", "no:xdist", "tests.rotation.compat_plugin")
    root = Path(__file__).parents[2]
    paths = os.pathsep.join(filter(None, [str(root), os.environ.get("PYTHONPATH")]))
    found = subprocess.run(
        [
            *(sys.executable, "-m", "pytest", "-q", "-c", str(settings), "--tb=line"),
            *(x for p in plugins for x in ("-p", p)),
            *("--pyargs", "scipy.spatial.transform.tests"),
        ],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": paths, "COMPAT_RESULTS": str(results)},
        capture_output=True,
        text=True,
        check=False,
    )
    if not results.exists() or "found no collectors" in found.stdout + found.stderr:
        pytest.skip("this scipy came without its tests")
    outcome = json.loads(results.read_text())
    assert set(outcome["failed"]) == set(EXPECTED), found.stdout[-3000:]
    assert len(outcome["passed"]) >= 600
