"""The object for notebooks."""

import sys
import webbrowser
from dataclasses import replace
from html import unescape
from pathlib import Path
from types import ModuleType

import pytest

from anim.errors import AnimationError
from anim.film import clip
from anim.model import Model
from anim.output.writing import suffixes
from anim.picture import Look
from anim.picture.look import FILM_LOOK
from anim.pipelines import kinematic
from anim.rendering import framed
from anim.top import Top
from hfield.cli import main

SMALL = Model(ring=30)


def test_in_a_notebook_it_is_a_frame_with_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    top = Top("euler", SMALL)
    shown: list[object] = []
    ipython, display = ModuleType("IPython"), ModuleType("IPython.display")
    ipython.get_ipython = object  # type: ignore[attr-defined]
    display.HTML = str  # type: ignore[attr-defined]
    display.display = shown.append  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    top.show()
    (frame,) = shown
    assert frame == top._repr_html_()
    inner = str(frame).partition('srcdoc="')[2].partition('"')[0]
    assert unescape(inner) == top.page()


def test_elsewhere_it_opens_in_the_browser(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    opened: list[str] = []
    monkeypatch.setitem(sys.modules, "IPython", None)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr(webbrowser, "open", opened.append)
    Top("product", SMALL).show()
    (path,) = tmp_path.iterdir()
    assert opened == [path.as_uri()]
    assert path.read_text(encoding="utf-8") == Top("product", SMALL).page()


def test_save(tmp_path: Path) -> None:
    top = Top(kinematic("matrix", clip(frames=3)), SMALL)
    top.save(tmp_path / "top.gif", Look(size=(32, 24)))
    assert (tmp_path / "top.gif").stat().st_size > 100
    with pytest.raises(AnimationError, match="--force"):
        top.save(tmp_path / "top.gif")


@pytest.mark.parametrize("suffix", [*suffixes(), "", ".jpg"])
def test_python_and_the_command_make_the_same_of_a_name(tmp_path: Path, suffix: str) -> None:
    top = Top(kinematic("matrix", clip(frames=2)), SMALL)
    ours, theirs = tmp_path / f"ours{suffix}", tmp_path / f"theirs{suffix}"
    words = ["--model", "matrix", "--frames", "2", "--points", "30", "--size", "32x24"]
    status = main(["render", *words, "-o", str(theirs)])
    if suffix == ".jpg":
        assert status == 2
        with pytest.raises(AnimationError, match="nothing can be written as"):
            top.save(ours)
        return
    assert status == 0
    top.save(ours, framed(replace(FILM_LOOK, size=(32, 24)), SMALL, top.motion))
    if suffix == ".html":
        assert "<!doctype html>" in ours.read_text("utf-8").lower()
    elif suffix:
        assert ours.read_bytes() == theirs.read_bytes()
    else:
        assert len(list(ours.iterdir())) == len(list(theirs.iterdir())) == 2


def test_unknown_pipeline() -> None:
    with pytest.raises(AnimationError, match="expected one of quaternions, product, euler, matrix"):
        Top("matrices")
