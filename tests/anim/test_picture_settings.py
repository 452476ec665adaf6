import numpy as np
import pytest

from anim.errors import AnimationError
from anim.model import Model
from anim.picture import STYLES, Camera, RenderSettings, painter
from tests.subcases import subcases


@subcases(
    "values",
    [
        {"size": (0, 10)},
        {"size": (10,)},
        {"size": "640x480"},
        {"size": (640.5, 480)},
        {"size": (100_000, 10)},
        {"size": (16_000, 16_000)},
        {"style": "pretty"},
        {"style": None},
        {"camera": (1, 2)},
        {"background": "no colour"},
        {"colours": ("red",)},
        {"colours": "red"},
        {"colours": ("red", "no colour")},
        {"quality": 0},
        {"quality": 5},
        {"quality": 1.5},
        {"tilt": -1},
        {"tilt": 181},
        {"tilt": float("nan")},
    ],
)
def test_looks_that_make_no_sense_are_refused(values):
    with pytest.raises(AnimationError, match=r"expected|must be a"):
        RenderSettings(**values)


@pytest.mark.parametrize(
    "values",
    [
        {"elevation": 91},
        {"elevation": -90.5},
        {"distance": 5},
        {"distance": float("inf")},
        {"zoom": 0},
        {"zoom": 1e9},
        {"azimuth": "north"},
    ],
    ids=str,
)
def test_cameras_that_make_no_sense_are_refused(values):
    with pytest.raises(AnimationError):
        Camera(**values)


def test_camera_from_text():
    assert Camera.parse("30,15") == Camera(30, 15)
    assert Camera.parse(" -60 , 20, 8, 1.5, parallel ") == Camera(-60, 20, 8, 1.5, False)
    assert Camera.parse("10,orthographic") == Camera(10, perspective=False)
    for text in ("", "a,b", "1,2,9,1,5", "parallel", "1,2,parallel,3"):
        with pytest.raises(AnimationError):
            Camera.parse(text)


def test_looks_are_values():
    assert RenderSettings() == RenderSettings(size=[640, 480])
    assert hash(RenderSettings(background="white")) == hash(RenderSettings(background="white"))
    assert RenderSettings(shadow=True) != RenderSettings()


@subcases("style", STYLES)
@subcases("size", [(1, 1), (1, 30), (31, 2), (33, 27), (641, 5)])
def test_any_size_is_drawn(style, size):
    look = RenderSettings(size, style, trace=True, shadow=True)
    trail = [[0, 0, 3.0], [0, 3.0, 0], [3.0, 0, 0]]
    picture = painter(Model(ring=12), look).draw(np.eye(3), trail)
    assert picture.shape == (size[1], size[0], 3)
    assert picture.dtype == np.uint8
