"""A user's settings of matplotlib change no picture and break none."""

import os
import subprocess
import sys

import pytest

from tests.patience import PATIENCE

SETTINGS = """
font.size: 30
axes.facecolor: red
axes3d.grid: False
lines.linewidth: 9
text.usetex: True
path.sketch: 3, 100, 2
path.simplify: False
agg.path.chunksize: 50
savefig.facecolor: blue
no setting at all
"""
DRAW = """
import sys
from hfield.cli import main
assert main("domain 6 -o d.png".split()) == 0
assert main("brandt 37 --prime 2 --plot b.png".split()) == 0
for style in ("classic", "flat"):
    words = f"render --model quaternions --style {style} --size 200x150 --frame 5 -o {style}.png"
    assert main(words.split()) == 0
assert main("figures --format png -o .".split()) == 0
"""


@pytest.mark.slow
def test_the_settings_of_a_user_change_nothing(tmp_path) -> None:
    folders = tmp_path / "ours", tmp_path / "theirs"
    for folder in folders:
        folder.mkdir()
    settings = tmp_path / "matplotlibrc"
    settings.write_text(SETTINGS)
    foreign = {"MATPLOTLIBRC": str(settings), "MPLBACKEND": "nonsense"}
    for folder, more in zip(folders, ({}, foreign), strict=True):
        words = [sys.executable, "-c", DRAW]
        done = subprocess.run(
            words,
            cwd=folder,
            env=os.environ | more,
            capture_output=True,
            text=True,
            timeout=PATIENCE,
        )
        assert done.returncode == 0, done.stderr
    ours, theirs = ({p.name: p.read_bytes() for p in folder.iterdir()} for folder in folders)
    assert len(ours) > 8
    assert [name for name in ours if ours[name] != theirs.get(name)] == []
