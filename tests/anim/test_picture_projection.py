import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from anim.errors import AnimationError
from anim.model import Model
from anim.picture import Camera, RenderSettings, painter
from anim.picture.mesh import Mesh
from anim.picture.projection import frame, reached, view
from anim.picture.solid import drawing_order, pieces
from anim.picture.styles import classic
from tests.anim.cones import random_rotation

cameras = st.builds(
    Camera,
    st.floats(-180, 180),
    st.floats(-90, 90),
    st.floats(6, 1000),
    st.just(1.0),
    st.booleans(),
)
seeds = st.integers(0, 2**32 - 1)
SIZE = (320, 200)
MODEL = Model(ring=40)


def about_y(angle):
    return np.array(
        [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    )


def about_z(angle):
    return np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )


@given(cameras)
@settings(max_examples=30)
def test_eye_is_where_the_camera_stands(camera):
    eye = view(camera, SIZE, reached(MODEL, RenderSettings(tilt=90))).eye
    towards = frame(camera)[2]
    if camera.perspective:
        np.testing.assert_allclose(
            eye, [*(towards * camera.distance + [0, 0, 1.2]), 1], rtol=1e-7, atol=1e-7
        )
    else:
        np.testing.assert_allclose(eye, [*towards, 0], atol=1e-9)


@given(cameras, st.floats(0, 180), seeds)
@settings(max_examples=60)
def test_leaning_top_stays_in_frame(camera, tilt, seed):
    rng = np.random.default_rng(seed)
    turns = rng.uniform(-np.pi, np.pi, 2)
    rotation = about_z(turns[0]) @ about_y(np.radians(tilt) * rng.uniform()) @ about_z(turns[1])
    seen = view(camera, SIZE, reached(MODEL, RenderSettings(tilt=tilt))).project(
        MODEL.points @ rotation.T
    )
    assert (seen > 0).all()
    assert (seen < SIZE).all()


@given(cameras, seeds)
@settings(max_examples=30)
def test_turning_the_top_or_the_view_is_the_same(camera, seed):
    rotation = random_rotation(np.random.default_rng(seed))
    seen = view(camera, SIZE, reached(MODEL, RenderSettings(tilt=90)))
    turned = seen.moved(rotation, np.zeros(3))
    points = MODEL.points
    np.testing.assert_allclose(turned.project(points), seen.project(points @ rotation.T), atol=1e-8)
    again = type(turned)(turned.matrix)
    np.testing.assert_allclose(turned.eye, again.eye, atol=1e-6)


@given(cameras, seeds)
@settings(max_examples=30)
def test_faces_turned_to_the_eye_turn_counterclockwise(camera, seed):
    seen = view(camera, SIZE, reached(MODEL, RenderSettings(tilt=180))).moved(
        random_rotation(np.random.default_rng(seed)), np.zeros(3)
    )
    x, y = seen.project(MODEL.points).T
    for part, corners in zip(
        pieces(Mesh.of(MODEL, 1e9)), (MODEL.lower, MODEL.sides, MODEL.upper), strict=True
    ):
        cx, cy = x[corners], y[corners]
        area = (cx * np.roll(cy, -1, axis=1) - np.roll(cx, -1, axis=1) * cy).sum(axis=1)
        sure = np.abs(area) > 1e-6
        assert (part.facing(seen.eye)[sure] == (area[sure] > 0)).all()


@given(cameras, seeds)
@settings(max_examples=30)
def test_what_lies_towards_the_eye_is_seen_at_one_place(camera, seed):
    seen = view(camera, SIZE, reached(MODEL, RenderSettings(tilt=90)))
    point = np.random.default_rng(seed).uniform(-1, 1, 3)
    towards = seen.eye[:3] - point * seen.eye[3]
    nearer = point + 0.1 * towards / np.linalg.norm(towards)
    here, there = seen.project(np.array([point, nearer]))
    np.testing.assert_allclose(here, there, atol=1e-6)


@pytest.mark.parametrize("perspective", [True, False])
def test_classic_camera_stands_at_the_given_angles(perspective):
    camera = Camera(-37, 24, perspective=perspective)
    brush = painter(MODEL, RenderSettings((400, 300), "classic", camera, tilt=50))
    eye = brush.view.eye
    direction = eye[:3] - np.array([0, 0, 1.5]) * eye[3]
    np.testing.assert_allclose(direction / np.linalg.norm(direction), frame(camera)[2], atol=1e-6)
    if perspective:
        assert np.linalg.norm(direction) == pytest.approx(camera.distance, rel=0.05)


def test_classic_axes_are_drawn_where_they_are_projected():
    brush = painter(MODEL, RenderSettings((400, 300), "classic", Camera(-60, 20), tilt=0))
    picture = brush.draw(np.eye(3))
    edge = np.column_stack([np.linspace(-0.9, 0.9, 30), np.full(30, -1.0), np.zeros(30)])
    for x, y in brush.view.project(edge):
        row, column = int(300 - y), int(x)
        assert picture[row - 1 : row + 2, column - 1 : column + 2].min() < 100


RINGS = np.array([1.0, 1.1])


def test_drawing_order_follows_the_side_of_the_eye():
    assert drawing_order(np.array([0, 0, 5.0, 1]), RINGS) == (0, 1, 2)
    assert drawing_order(np.array([9, 0, 0.5, 1]), RINGS) == (2, 1, 0)
    assert drawing_order(np.array([9, 0, 1.05, 1]), RINGS) == (0, 2, 1)
    assert drawing_order(np.array([1, 0, 0.1, 0]), RINGS) == (0, 1, 2)
    assert drawing_order(np.array([1, 0, -0.1, 0]), RINGS) == (2, 1, 0)


def test_a_camera_inside_the_reach_of_a_top_is_refused():
    far = ((0, 0, 0), (0, 0, 3), (30, 0, 0))
    with pytest.raises(AnimationError, match="too near"):
        painter(MODEL, RenderSettings(SIZE, reach=far))
    painter(MODEL, RenderSettings(SIZE, camera=Camera(distance=60), reach=far))


def test_a_classic_axis_has_few_numbers_so_that_they_do_not_touch(monkeypatch):
    seen = []
    view_of = classic.view_of
    monkeypatch.setattr(classic, "view_of", lambda axes: seen.append(axes) or view_of(axes))
    painter(MODEL, RenderSettings((640, 480), "classic", Camera(-60, 20), tilt=50))
    for axis in (seen[-1].xaxis, seen[-1].yaxis, seen[-1].zaxis):
        assert 3 <= len(axis.get_ticklabels()) <= 7
