"""A camera that goes along with the top, the path that fades, and the light on the top's edge."""

from dataclasses import replace

import numpy as np
import pytest

from anim.attitude import continuous
from anim.errors import AnimationError
from anim.film import clip
from anim.model import Model
from anim.motion import Motion
from anim.picture import RenderSettings, painter
from anim.picture.settings import FILM_SETTINGS
from anim.picture.trace import in_sight, strengths
from anim.rendering import Scene, Track, draw, framed

SMALL = replace(FILM_SETTINGS, size=(160, 120))
MODEL = Model(ring=60)


def gliding(far: float) -> Motion:
    """Return an upright top that glides along the x axis, ten seconds."""

    def places(times):
        return np.outer(times / 10 * far, [1.0, 0.0, 0.0])

    def upright(times):
        return continuous(np.tile([1.0, 0.0, 0.0, 0.0], (len(times), 1)))

    return Motion.sample("gliding", clip(frames=501), upright, None, places)


def height_of_the_top(look: RenderSettings, motion: Motion) -> int:
    look = replace(look, trace=False, shadow=False)
    picture = draw(Scene(MODEL, motion, look).task(250))
    yellow = (picture[..., 0] > 150) & (picture[..., 2] < 80)
    return int(np.ptp(np.flatnonzero(yellow.any(axis=1))))


def test_a_top_that_goes_far_is_followed_and_stays_large() -> None:
    near, far = gliding(1), gliding(40)
    assert not framed(SMALL, MODEL, near).follow
    look = framed(SMALL, MODEL, far)
    assert look.follow
    still = height_of_the_top(framed(SMALL, MODEL, gliding(0)), gliding(0))
    assert height_of_the_top(look, far) > 0.8 * still
    with pytest.raises(AnimationError, match="let it follow the top"):
        painter(MODEL, framed(SMALL, MODEL, far, follow=False))


def test_the_ground_passes_below_a_camera_that_follows() -> None:
    motion = gliding(40)
    scene = Scene(MODEL, motion, replace(framed(SMALL, MODEL, motion), trace=False))
    first, second = draw(scene.task(200)), draw(scene.task(201))
    changed = np.abs(first.astype(int) - second).max(axis=-1) > 1
    assert changed[80:].any()
    top = (first[..., 0] > 150) & (first[..., 2] < 80)
    assert changed[top].mean() < 0.05  # the top itself stands still in the picture


def test_a_whole_ring_further_looks_the_same_but_for_the_rings() -> None:
    brush = painter(MODEL, replace(SMALL, trace=False, follow=True))
    here = brush.draw(np.eye(3))
    there = brush.draw(np.eye(3), place=(30.5, 0, 0), centre=(30.5, 0))
    assert (here != there).any()
    assert (brush.draw(np.eye(3)) == here).all()
    assert abs(here.astype(int) - there).max() < 16


def test_the_track_is_the_middle_of_the_top_and_calm() -> None:
    track = Track(MODEL, gliding(40))
    np.testing.assert_allclose(track.centres[:, 0], 4 * track.times, atol=1e-9)
    np.testing.assert_allclose(track.centres[:, 1], 0)
    assert track.at(5.0) == pytest.approx((20.0, 0.0), abs=1e-9)


def test_axes_are_not_followed() -> None:
    assert not framed(replace(SMALL, style="classic"), MODEL, gliding(40)).follow
    with pytest.raises(AnimationError, match="fixed axes"):
        RenderSettings(style="classic", follow=True)


@pytest.mark.parametrize("style", ["flat", "shaded", "classic"])
def test_the_path_fades_with_its_age(style: str) -> None:
    look = RenderSettings((160, 120), style, trace=True)
    trail = np.column_stack([np.linspace(-2, 2, 50), np.full(50, 0.0), np.full(50, 2.0)])
    brush = painter(MODEL, look)
    empty = brush.draw(np.diag([1.0, -1, -1])).astype(int)
    strong, weak = (
        np.abs(brush.draw(np.diag([1.0, -1, -1]), trail, ages=np.full(50, age)) - empty).sum()
        for age in (0.0, 60.0)
    )
    assert weak == pytest.approx(0.22 * strong, rel=0.1)
    assert strengths(np.array([0.0]))[0] == 1
    with pytest.raises(AnimationError, match="one for each point"):
        brush.draw(np.eye(3), trail, ages=[1.0])


def test_a_wide_top_hides_what_is_behind_its_rim() -> None:
    disc = Model.from_outline([(0, 0), (0.5, 3), (0.6, 3), (1, 0)])
    points = np.array([[0, 0, 1.2], [0, 0, -0.5], [-2.0, 0, 0.3], [-2.0, 0, 3.0]])
    eye = np.array([10.0, 0, 1.0, 1])
    assert in_sight(points, eye, disc.profile).tolist() == [True, True, False, True]
    level = np.array([1.0, 0, 0, 0])
    assert in_sight(points, level, disc.profile).tolist() == [True, True, False, True]


def test_on_dark_paper_a_line_of_light_closes_the_top() -> None:
    look = replace(SMALL, trace=False, shadow=False, colours=("black", "black"))
    brush = painter(MODEL, replace(look, background="#000000"))
    lit = brush.draw(np.eye(3)).astype(int)
    brush.body._outline = 0
    light = (lit - brush.draw(np.eye(3))).min(axis=-1)
    white = painter(
        MODEL, replace(look, style="flat", background="#000000", colours=("white", "white"))
    )
    top = white.draw(np.eye(3)).min(axis=-1) > 128
    rows = [(y, np.flatnonzero(row)) for y, row in enumerate(top) if row.sum() > 8]
    assert len(rows) > 20
    for y, columns in rows:
        for end in (columns[0], columns[-1]):
            assert light[y, end - 2 : end + 3].max() > 40
    assert light[~top].max() < 110
    assert (light[top] > 20).mean() < 0.35  # its inside is as it was
    pale = painter(MODEL, replace(look, background="#ffffff"))
    assert pale.body._outline == 0
