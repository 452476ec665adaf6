"""``hfield warm``: loops are compiled once, whole files are kept, and processes that write at once agree."""

import json
import os
import subprocess
import sys

import pytest


def warm(tmp_path, *words):
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    return subprocess.Popen(
        [sys.executable, "-m", "hfield", "warm", *words],
        env=environment,
        stdout=subprocess.PIPE,
        text=True,
    )


@pytest.mark.slow
def test_warm_keeps_what_it_compiles_and_two_may_write(tmp_path):
    both = [warm(tmp_path, "GF(5)", "(-1,-3|QQ)", "--format", "json") for _ in range(2)]
    for process in both:
        out, _ = process.communicate(timeout=100)
        assert process.returncode == 0
        found = json.loads(out)
        assert (found["schema"], found["compiler"]) == ("hfield-warm/1", True)
        assert set(found["seconds"]) == {"(-1,-1|GF(5))", "(-1,-3|QQ)"}
    (folder,) = tmp_path.iterdir()
    files = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert files
    assert all("." not in name for name in files)  # no part of a file is left
    out, _ = warm(tmp_path, "GF(5)", "(-1,-3|QQ)").communicate(timeout=100)
    assert out.startswith("(-1,-1|GF(5)): ")
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == files


def test_warm_says_what_it_does_not_understand(capsys):
    from hfield.cli import main

    assert main(["warm", "GF(6)"]) == 2
    assert "GF(6)" in capsys.readouterr().err
