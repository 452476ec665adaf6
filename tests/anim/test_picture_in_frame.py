"""Nothing is cropped: top, shadow and trace end before the picture does."""

import numpy as np
import pytest

from anim.film import clip
from anim.model import Model
from anim.physics import Launch, physical
from anim.picture import STYLES, Camera, RenderSettings, painter
from anim.picture.settings import FILM_SETTINGS
from anim.pipelines import PIPELINES, kinematic
from anim.rendering import Scene, framed, frames
from tests.anim.test_picture_projection import about_y, about_z
from tests.subcases import subcases

FILM = clip(frames=9)
HD, WIDE, TALL, SMALL = (1920, 1080), (400, 90), (90, 400), (64, 48)
MOTIONS = {name: kinematic(name, FILM) for name in PIPELINES} | {
    "physics": physical(FILM),
    "a fall": physical(FILM, launch=Launch(spin=5.0, tilt=0.3)),
}
CAMERAS = [Camera(), Camera(40, 80), Camera(130, 3, perspective=False), Camera(10, -25, 6)]


def drawn(pictures, empty):
    """Tell which pixels (height, width) of some pictures are not those of the scene without the top."""
    return np.any([(picture != empty).any(axis=-1) for picture in pictures], axis=0)


def on_the_edge(mask):
    return [mask[0].any(), mask[-1].any(), mask[:, 0].any(), mask[:, -1].any()]


def scene_of(motion, look):
    model = Model(ring=60)
    return Scene(model, motion, framed(look, model, motion))


def without_top(scene):
    return painter(scene.model, scene.settings).canvas.rgb()


@pytest.mark.slow
@subcases("motion", MOTIONS)
@subcases("size", [HD, WIDE, TALL, SMALL])
def test_the_default_film(motion, size):
    look = RenderSettings(size, FILM_SETTINGS.style, trace=True, shadow=True, quality=1)
    scene = scene_of(MOTIONS[motion], look)
    mask = drawn(frames(scene, numbers=range(2, 9, 3)), without_top(scene))
    assert mask.any()
    assert on_the_edge(mask) == [False] * 4


@pytest.mark.slow
@subcases("style", STYLES)
@subcases("camera", CAMERAS)
def test_long_shadows_from_every_side(style, camera):
    scene = scene_of(
        MOTIONS["a fall"], RenderSettings((320, 180), style, camera, trace=True, shadow=True)
    )
    assert on_the_edge(drawn(frames(scene), without_top(scene))) == [False] * 4
    brush = painter(scene.model, RenderSettings((320, 180), style, camera, shadow=True, tilt=60))
    empty = brush.canvas.rgb()
    leaning = [brush.draw(about_z(turn) @ about_y(np.pi / 3)) for turn in np.arange(0, 6.2, 0.35)]
    assert on_the_edge(drawn(leaning, empty)) == [False] * 4


def test_the_picture_is_filled():
    scene = scene_of(MOTIONS["physics"], RenderSettings((320, 240), trace=True, shadow=True))
    rows, columns = np.nonzero(drawn(frames(scene), without_top(scene)))
    assert max(np.ptp(rows) / 240, np.ptp(columns) / 320) > 0.8
