"""The mesh: fewer points than the model where nobody sees it, and the trace's line likewise."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from anim.film import clip
from anim.model import Model
from anim.picture import STYLES, Camera, RenderSettings, painter
from anim.picture.mesh import INVISIBLE, Mesh
from anim.picture.projection import reached
from anim.picture.styles import shaded
from anim.picture.trace import thinned
from anim.pipelines import kinematic
from anim.rendering import Scene
from tests.anim.cones import random_rotation


@given(st.integers(3, 3000), st.integers(1, 40), st.floats(0.1, 1e5))
def test_a_mesh_keeps_the_edges_of_the_bands_and_strays_little(ring, bands, magnification):
    model = Model(ring, min(bands, ring))
    mesh = Mesh.of(model, magnification)
    assert mesh.places[0] == 0
    assert (np.diff(mesh.places) > 0).all()
    edges = np.flatnonzero(np.diff(model.sectors)) + 1
    assert np.isin(edges, mesh.places).all()
    widest = np.diff([*mesh.places, ring]).max() if mesh.ring < ring else 0
    assert magnification * (1 - np.cos(np.pi * widest / ring)) <= INVISIBLE + 1e-9
    assert 3 <= mesh.ring <= ring
    assert mesh.points.shape == (2 * mesh.ring + 2, 3)


def test_coarse_models_are_drawn_as_they_are():
    for ring in (3, 10, 60):
        assert painter(Model(ring), RenderSettings()).mesh.ring == ring


@pytest.mark.parametrize("style", STYLES)
def test_nobody_sees_what_the_mesh_leaves_out(style, monkeypatch):
    model, look = Model(), RenderSettings((320, 240), style, shadow=True)
    thin = painter(model, look)
    assert thin.mesh.ring < 300
    monkeypatch.setattr("anim.picture.mesh.INVISIBLE", 0.0)
    full = painter(model, look)
    assert full.mesh.ring == 1000
    rng = np.random.default_rng(3)
    for _ in range(10):
        turn = random_rotation(rng)
        apart = np.abs(thin.draw(turn).astype(int) - full.draw(turn)).max(axis=-1)
        assert (apart > 12).mean() < 2e-4


def test_a_million_points_cost_what_the_picture_can_show():
    assert painter(Model(1_000_000), RenderSettings((640, 480), "shaded")).mesh.ring < 600


@settings(max_examples=25, deadline=None)
@given(st.booleans(), st.floats(-90, 90), st.floats(6, 100), st.floats(0.1, 100))
def test_the_magnification_is_how_many_pixels_a_short_way_makes(flat, elevation, distance, zoom):
    look = RenderSettings((64, 48), camera=Camera(10, elevation, distance, zoom, not flat))
    view = painter(Model(3), look).view
    points = reached(Model(3), RenderSettings(tilt=90))
    steps = 1e-6 * np.random.default_rng(1).normal(size=points.shape)
    moved = np.linalg.norm(view.project(points + steps) - view.project(points), axis=1)
    most = (moved / np.linalg.norm(steps, axis=1)).max()
    assert most <= view.magnification(points) * 1.001 <= 2.1 * most


@given(st.integers(0, 2**32), st.integers(1, 300), st.floats(1e-6, 0.3))
def test_a_thinned_line_strays_no_further_than_allowed(seed, count, tolerance):
    path = np.cumsum(np.random.default_rng(seed).normal(size=(count, 3)), axis=0) / 20
    path[count // 2 :] = path[count // 2]  # it comes to rest
    kept = thinned(path, tolerance)
    assert kept[0] == 0
    for start, stop in zip(kept, [*kept[1:], count - 1], strict=True):
        way = path[stop] - path[start]
        share = (path[start : stop + 1] - path[start]) @ way / max(way @ way, 1e-300)
        near = path[start] + np.clip(share, 0, 1)[:, None] * way
        assert np.linalg.norm(path[start : stop + 1] - near, axis=1).max() <= tolerance + 1e-12
    shorter = thinned(path[: count // 2 + 1], tolerance)
    np.testing.assert_array_equal(shorter, kept[: len(shorter)])


def test_the_trace_of_a_long_film_has_no_more_points_than_that_of_a_short_one():
    lengths = []
    for frames in (10, 500, 20_000):
        scene = Scene(Model(10), kinematic(clip=clip(frames=frames)), RenderSettings(trace=True))
        trail = scene.task(frames - 1).trail
        assert trail is not None
        np.testing.assert_array_equal(trail[-1], scene.motion.apex()[-1])
        lengths.append(len(trail))
    assert 1000 < min(lengths) <= max(lengths) < 2500


def test_a_model_travels_without_its_arrays():
    import pickle

    model = Model(1000, 7, "third")
    model.points.sum()
    words = pickle.dumps(model)
    assert len(words) < 200
    assert pickle.loads(words) == model


def test_the_normals_of_corners_are_those_of_triangles() -> None:
    mesh = Mesh.of(Model(), 300.0)
    corners, normals = shaded._normals(mesh)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-14)
    a, b, c = mesh.points[mesh.triangles].transpose(1, 0, 2)
    across = np.cross(b - a, c - a)
    flat = across / np.linalg.norm(across, axis=1)[:, None]
    assert (np.einsum("nd,nkd->nk", flat, normals[corners]) > 0.99).all()
