"""Captions have a place of their own: nothing of the scene is under them, and nothing of them is cut."""

import numpy as np
import pytest

from anim.errors import AnimationError
from anim.film import clip
from anim.model import Model
from anim.motion import Motion
from anim.physics import physical
from anim.physics.films import STORY
from anim.picture.captions import FORMULAS, WORDS, caption, strip
from anim.picture.settings import FILM_SETTINGS, RenderSettings
from anim.pipelines import PIPELINES, kinematic
from anim.rendering import Scene, draw, framed
from tests.subcases import pairs_quick

FILM = clip(frames=9)
MOTIONS: dict[str, Motion] = {name: kinematic(name, FILM) for name in PIPELINES}
MOTIONS |= {"physics": physical(FILM), "free": physical(FILM, None, *STORY)}


@pytest.mark.parametrize(
    ("name", "size"), pairs_quick(MOTIONS, [(160, 120), (200, 400), (640, 480)], 3), ids=str
)
def test_they_stand_above_a_whole_picture_of_the_scene(name, size):
    model, motion = Model(ring=30), MOTIONS[name]
    assert name in FORMULAS
    for language in WORDS:
        look = framed(
            RenderSettings(size, FILM_SETTINGS.style, trace=True, shadow=True), model, motion
        )
        task = Scene(model, motion, look, captions=language).task(5)
        picture, height = draw(task), strip(size, language, name)
        assert picture.shape == (size[1], size[0], 3)
        plain = Scene(model, motion, task.settings).task(5)
        np.testing.assert_array_equal(picture[height:], draw(plain))
        letters = (picture[:height] != picture[0, 0]).any(axis=-1)
        assert letters.sum() > 100
        edges = letters[0], letters[-1], letters[:, 0], letters[:, -1]
        assert not any(edge.any() for edge in edges)


def test_small_pictures_are_refused():
    with pytest.raises(AnimationError, match="captions are too large for a picture of 64x48"):
        Scene(Model(30), MOTIONS["physics"], RenderSettings((64, 48)), captions="en")


def test_they_say_what_they_said():
    assert caption("pl", "free", 12.34, 5.0)[1:] == ("pochylenie 12,3°", "wirowanie 5,0 rad/s")
