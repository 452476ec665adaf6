"""The object for notebooks."""

import sys
import webbrowser
from dataclasses import replace
from html import unescape
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from anim.errors import AnimationError
from anim.film import clip
from anim.model import Model
from anim.output.writing import suffixes
from anim.picture import RenderSettings
from anim.picture.settings import FILM_SETTINGS
from anim.picture.styles.classic import view_of
from anim.pipelines import kinematic
from anim.rendering import framed
from anim.top import Top
from hfield.cli import main
from rotation.matrices import to_matrix
from tests.anim.cones import interior, reference

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
    top.save(tmp_path / "top.gif", RenderSettings(size=(32, 24)))
    assert (tmp_path / "top.gif").stat().st_size > 100
    with pytest.raises(AnimationError, match="--force"):
        top.save(tmp_path / "top.gif")


@pytest.mark.slow
@pytest.mark.parametrize("suffix", [*suffixes(), "", ".jpg"])
def test_python_and_the_command_make_the_same_of_a_name(tmp_path: Path, suffix: str) -> None:
    top = Top(kinematic("matrix", clip(frames=2)), SMALL)
    ours, theirs = tmp_path / f"ours{suffix}", tmp_path / f"theirs{suffix}"
    words = ["--model", "matrix", "--frames", "2", "--points", "30"]
    words += ["--size", "32x24"] * (suffix != ".html")  # a page has no size
    status = main(["render", *words, "-o", str(theirs)])
    if suffix == ".jpg":
        assert status == 2
        with pytest.raises(AnimationError, match="is unknown"):
            top.save(ours)
        return
    assert status == 0
    top.save(ours, framed(replace(FILM_SETTINGS, size=(32, 24)), SMALL, top.motion))
    if suffix == ".html":
        assert "<!doctype html>" in ours.read_text("utf-8").lower()
    elif suffix:
        assert ours.read_bytes() == theirs.read_bytes()
    else:
        assert len(list(ours.iterdir())) == len(list(theirs.iterdir())) == 2


def test_unknown_pipeline() -> None:
    with pytest.raises(AnimationError, match="expected one of quaternions, product, euler, matrix"):
        Top("matrices")


TURNING = [[1, 0, 0, 0.1 * n] for n in range(5)]


def test_frames_are_those_of_the_film(tmp_path: Path) -> None:
    top = Top(TURNING, Model.from_outline([(0, 0), (1, 2), (2, 0)], ring=30))
    look = RenderSettings(size=(64, 48), style="shaded", trace=True, shadow=True)
    frames = list(top.frames(look))
    assert len(frames) == 5
    for number, frame in enumerate(frames):
        assert (frame.shape, frame.dtype) == ((48, 64, 3), np.uint8)
        np.testing.assert_array_equal(frame, top.frame(top.motion.times[number], look))
    between = top.frame(0.5 * (top.motion.times[1] + top.motion.times[2]), look)
    assert (between != frames[1]).any()
    assert (between != frames[2]).any()
    top.save(tmp_path / "one.png", look, frame=2)
    with Image.open(tmp_path / "one.png") as picture:
        np.testing.assert_array_equal(np.asarray(picture), frames[2])


@pytest.mark.parametrize("t", [-0.1, 99.0, float("nan"), "now"])
def test_a_time_outside_the_motion_is_refused(t: object) -> None:
    with pytest.raises(AnimationError, match=r"t (is|must)"):
        Top(TURNING, SMALL).frame(t)  # type: ignore[arg-type]


def test_in_plain_axes_it_is_a_picture_of_their_size() -> None:
    axes = Figure(figsize=(2, 1.5), dpi=50).add_axes((0, 0, 1, 1))
    artist = Top(TURNING, SMALL).draw(axes, 0.04)
    assert artist in axes.images
    assert artist.get_array().shape == (75, 100, 3)


@pytest.mark.parametrize("elevation", [-30, 20, 85])
def test_in_axes_of_three_dimensions_faces_hide_each_other_rightly(elevation: float) -> None:
    figure = Figure(figsize=(4, 4), dpi=60)
    axes = figure.add_subplot(projection="3d")
    axes.view_init(elev=elevation, azim=30)
    model = Model.from_outline([(0, 0), (1, 2), (1.2, 0.4), (3, 0.4)], bands=4)
    Top(TURNING, model).draw(axes, 0.05)
    axes.set_aspect("equal")
    axes.set_axis_off()
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    shown = np.asarray(canvas.buffer_rgba())[..., :3]
    rotation = Top(TURNING, model).motion.at([0.05])
    expected = reference(
        view_of(axes).matrix, (240, 240), np.asarray(to_matrix(rotation))[0], model
    )
    inside = interior(expected) & (expected >= 0)
    yellow = shown[..., 2].astype(int) < shown[..., 0].astype(int) // 2
    assert inside.sum() > 2000
    assert np.mean(yellow[inside] == (expected[inside] % 2 == 0)) > 0.998


def test_axes_of_three_dimensions_have_their_own_look() -> None:
    axes = Figure().add_subplot(projection="3d")
    with pytest.raises(AnimationError, match="expected no settings"):
        Top(TURNING, SMALL).draw(axes, 0, RenderSettings())
    with pytest.raises(AnimationError, match="ax is a int"):
        Top(TURNING, SMALL).draw(3)  # type: ignore[arg-type]
