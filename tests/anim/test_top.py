"""The object for notebooks."""

import sys
import webbrowser
from html import unescape
from pathlib import Path
from types import ModuleType

import pytest

from anim.errors import AnimationError
from anim.film import clip
from anim.model import Model
from anim.picture import Look
from anim.pipelines import kinematic
from anim.top import Top

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


def test_unknown_pipeline() -> None:
    with pytest.raises(AnimationError, match="expected one of quaternions, product, euler, matrix"):
        Top("matrices")
