"""``hfield precompile`` compiles loops once, and processes that write at the same time agree."""

import json
import os
import subprocess
import sys

import pytest

from hfield.cli import main
from tests.patience import PATIENCE


def precompile(tmp_path, *words):
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    return subprocess.Popen(
        [sys.executable, "-m", "hfield", "precompile", *words],
        env=environment,
        stdout=subprocess.PIPE,
        text=True,
    )


@pytest.mark.slow
def test_precompile_keeps_what_it_compiles_and_two_may_write(tmp_path):
    both = [precompile(tmp_path, "GF(5)", "(-1,-3|QQ)", "--format", "json") for _ in range(2)]
    for process in both:
        out, _ = process.communicate(timeout=PATIENCE)
        assert process.returncode == 0
        found = json.loads(out)
        assert (found["schema"], found["compiler"]) == ("hfield-precompile/1", True)
        assert set(found["seconds"]) == {"(-1,-1|GF(5))", "(-1,-3|QQ)"}
    (folder,) = tmp_path.iterdir()
    files = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert files
    assert all("." not in name for name in files)  # no part of a file is left
    out, _ = precompile(tmp_path, "GF(5)", "(-1,-3|QQ)").communicate(timeout=PATIENCE)
    assert out.startswith("(-1,-1|GF(5)): ")
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == files


def test_precompile_says_what_it_does_not_understand(capsys):
    assert main(["precompile", "GF(6)"]) == 2
    assert "GF(6)" in capsys.readouterr().err


def test_the_former_name_runs_with_a_warning(capsys):
    assert main(["warm", "--help"]) == 0
    said = capsys.readouterr()
    assert "usage: hfield precompile" in said.out
    assert "`hfield warm` is now `hfield precompile`" in said.err
