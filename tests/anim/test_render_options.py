"""Every option of ``hfield render``, for every kind of output: it changes what is made, or it is refused."""

from argparse import ArgumentParser
from functools import cache
from pathlib import Path

import pytest

from anim.commands.arguments import declare
from anim.commands.choices import ALWAYS
from hfield.cli import main

# The base of each kind, and where an option needs another one, what goes before it.
KINDS = {
    "page": ["--points", "12", "--frames", "4", "-o", "a.html"],
    "picture": [
        "--points",
        "12",
        "--frames",
        "4",
        "--size",
        "48x40",
        "--frame",
        "2",
        "-o",
        "a.png",
    ],
    "folder": ["--points", "12", "--frames", "3", "--size", "48x40", "-o", "a"],
    "film": ["--points", "12", "--frames", "3", "--size", "64x48", "-o", "a.mp4"],
}
PHYSICS = ["--model", "physics"]
OPTIONS = {
    "model": ["--model", "euler"],
    "motion": ["--motion", "motion.csv"],
    "frames": ["--frames", "5"],
    "fps": ["--fps", "7"],
    "duration": ["--duration", "3"],
    "time_scale": ["--time-scale", "0.3"],
    "motion_blur": ["--motion-blur", "0.9"],
    "spin": ["--spin", "accumulated"],
    "order": ["--order", "tilt-first"],
    "angle": ["--angle", "half"],
    "euler": ["--model", "euler", "--euler", "zyz"],
    "size": ["--size", "80x60"],
    "points": ["--points", "30"],
    "bands": ["--bands", "4"],
    "p2": ["--p2", "third"],
    "outline": ["--outline", "outline.csv"],
    "follow": ["--follow"],
    "style": ["--style", "flat"],
    "camera": ["--camera", "10,40"],
    "captions": ["--size", "320x240", "--captions"],
    "dark": ["--dark"],
    "background": ["--background", "#335577"],
    "trace": ["--no-trace"],
    "shadow": ["--no-shadow"],
    "quality": ["--quality", "1"],
    "crf": ["--crf", "40"],
    "preset": ["--preset", "ultrafast"],
    "preview": ["--preview"],
    "spin_rate": ["--spin-rate", "9"],
    "tilt": ["--tilt", "30"],
    "precession": ["--precession", "5"],
    "gravity": ["--gravity", "3"],
    "mass": ["--mass", "3"],
    "density": ["--density", "50"],
    "scale": ["--scale", "0.2"],
    "spin_decay": ["--spin-decay", "1"],
    "tilt_decay": ["--tilt-decay", "1"],
    "tip_radius": ["--tip-radius", "0.02"],
    "friction": ["--friction", "0.1"],
    "rolling": ["--rolling", "0.05"],
    "seed": ["--seed", "3"],
}
CONTEXT = {
    **{name: ["--model", "quaternions"] for name in ("spin", "order", "angle")},
    "euler": ["--model", "euler"],
    "captions": ["--size", "320x240"],
    **{name: ["--model", "free"] for name in ("mass", "density", "scale")},
    "seed": ["--model", "free"],
    "follow": ["--model", "free"],
}
REFUSED = {
    "page": {
        "size",
        "style",
        "quality",
        "trace",
        "shadow",
        "follow",
        "captions",
        "motion_blur",
        "preview",
    }
    | {"crf", "preset", "jobs"},
    "picture": {"crf", "preset", "jobs"},
    "folder": {"crf", "preset"},
    "film": set(),
}
SAME_FRAMES = {"mass", "density"}
"""A mass changes the numbers of a page, not the pictures: all forces grow with it."""


def options() -> set[str]:
    parser = ArgumentParser()
    declare(parser)
    kinds = {"help", "sheet", "frame", "quaternions", "figures", *ALWAYS}
    return {action.dest for action in parser._actions} - kinds


def test_the_table_has_every_option() -> None:
    assert set(OPTIONS) | {"jobs"} == options()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "motion.csv").write_text("1,0,0,0\n0.9,0.1,0,0\n0.8,0.2,0,0\n0.7,0.3,0,0\n")
    (tmp_path / "outline.csv").write_text("0,0\n1,1\n2,0.1\n3,0\n")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def made(words: list[str]) -> bytes:
    """Render, and return what is written."""
    assert main(["render", *words, "--force"]) == 0, words
    path = Path(words[words.index("-o") + 1])
    files = sorted(path.iterdir()) if path.is_dir() else [path]
    return b"".join(file.read_bytes() for file in files)


@pytest.mark.parametrize("kind", KINDS)
def test_what_a_kind_does_not_have_is_refused(folder: Path, capsys, kind: str) -> None:
    base = KINDS[kind]
    for name in sorted(REFUSED[kind]):
        words = ["--jobs", "2"] if name == "jobs" else OPTIONS[name]
        if kind == "page" and name == "captions":
            words = ["--captions"]
        assert main(["render", *base, *words]) == 2, name
        assert f"--{name.replace('_', '-')}" in capsys.readouterr().err
    assert not Path(base[-1]).exists()


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["page", "picture"])
def test_every_other_option_changes_what_is_made(folder: Path, kind: str) -> None:
    base = KINDS[kind]
    plain = cache(lambda *words: made(list(words)))  # many options have the same context
    for name in sorted(set(OPTIONS) - REFUSED[kind]):
        if kind == "picture" and name in SAME_FRAMES:
            continue
        before = plain(*base, *CONTEXT.get(name, []))
        assert made([*base, *CONTEXT.get(name, []), *OPTIONS[name]]) != before, name


@pytest.mark.parametrize("kind", ["--quaternions", "--figures"])
def test_pages_and_figures_without_options_refuse_all(folder: Path, capsys, kind: str) -> None:
    for name, words in OPTIONS.items():
        assert (
            main(["render", kind, *words, "-o", "a.html" if kind == "--quaternions" else "a"]) == 2
        )
        assert "leave out --" in capsys.readouterr().err, name


def test_a_page_refuses_a_camera_that_it_does_not_have(folder: Path, capsys) -> None:
    for camera in ("10,20,8", "10,20,12,1,parallel"):
        assert main(["render", *KINDS["page"], "--camera", camera]) == 2
        assert "azimuth, elevation and zoom" in capsys.readouterr().err
