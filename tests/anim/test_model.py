import pickle
from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from anim.errors import AnimationError
from anim.model import BLACK, YELLOW, Model
from hfield.errors import HFieldError

rings = st.integers(3, 60)
radii = st.one_of(st.sampled_from(["printed", "third"]), st.floats(0.05, 2))


def test_the_model_of_the_thesis():
    model = Model()
    assert model.counts() == {
        "points": 2002,
        "triangles": 2000,
        "quadrilaterals": 1000,
        "polygons": 3000,
    }
    assert Model(ring=10).counts()["polygons"] == 30
    assert model.profile == ((0, 0), (1, 1), (3**-1.5, 1.1), (0, 3))
    assert Model(p2="third").profile[2] == (1 / 3, 1.1)
    assert model.palette == (YELLOW, BLACK)


@given(rings, radii)
def test_points_lie_where_section_33_puts_them(ring, p2):
    model = Model(ring, p2=p2)
    points = model.points
    assert points.shape == (2 * ring + 2, 3)
    assert points.dtype == np.float64
    assert points[0].tolist() == [0, 0, 0]
    assert points[-1].tolist() == [0, 0, 3]
    for circle, radius, height in (
        (points[1 : ring + 1], 1, 1),
        (points[ring + 1 : -1], model.radius, 1.1),
    ):
        assert np.hypot(circle[:, 0], circle[:, 1]) == pytest.approx(radius)
        assert np.all(circle[:, 2] == height)
        steps = np.linalg.norm(np.roll(circle, -1, axis=0) - circle, axis=1)
        assert steps == pytest.approx(2 * radius * np.sin(pi / ring))


@given(rings, radii)
def test_the_surface_is_closed_and_its_polygons_face_outwards(ring, p2):
    model = Model(ring, p2=p2)
    edges = [edge for p in model.polygons for edge in zip(p, (*p[1:], p[0]), strict=True)]
    assert len(edges) == len(set(edges))
    assert {(b, a) for a, b in edges} == set(edges)
    faces, _ = model.triangles()
    corners = model.points[faces]
    volume = np.einsum("ni,ni->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    radius = model.radius
    solid = (1 + 0.1 * (1 + radius + radius**2) + 1.9 * radius**2) / 3
    assert volume == pytest.approx(ring / 2 * np.sin(2 * pi / ring) * solid)
    euler = len(model.points) - len(edges) / 2 + len(model.polygons)
    assert euler == 2


@given(rings)
def test_every_triangle_looks_away_from_the_axis(ring):
    model = Model(ring)
    faces, bands = model.triangles()
    a, b, c = np.moveaxis(model.points[faces], 1, 0)
    normals, centres = np.cross(b - a, c - a), (a + b + c) / 3
    assert np.all(np.sum(normals[:, :2] * centres[:, :2], axis=1) > 0)
    assert len(bands) == len(faces) == 4 * ring


@given(st.data())
@settings(max_examples=50)
def test_bands_are_runs_of_nearly_equal_length_from_the_first_to_the_last(data):
    ring = data.draw(rings)
    bands = data.draw(st.integers(1, ring))
    model = Model(ring, bands)
    sectors = model.sectors
    assert sectors[0] == 0
    assert sectors[-1] == bands - 1
    assert set(np.diff(sectors).tolist()) <= {0, 1}
    lengths = np.bincount(sectors)
    assert lengths.max() - lengths.min() <= 1
    assert len(model.polygon_bands) == len(model.polygons)


@pytest.mark.parametrize(("ring", "bands"), [(3, 2), (4, 4), (9, 8), (10, 10), (1000, 10)])
def test_there_are_ten_bands_or_as_many_as_fit_in_pairs(ring, bands):
    assert Model(ring).bands == bands


def test_a_model_is_immutable_and_equal_to_one_made_alike():
    model = Model(12, 4, "third")
    with pytest.raises(AttributeError):
        model.ring = 5
    for values in (model.points, model.lower, model.sides, model.upper, model.sectors):
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 1
    assert model == Model(12, 4, 1 / 3)
    assert hash(model) == hash(Model(12, 4, 1 / 3))
    assert model != Model(12, 4)
    assert pickle.loads(pickle.dumps(model)) == model


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"ring": 2}, "ring is 2; expected a number from 3"),
        ({"ring": 10**7}, "from 3 to 1000000"),
        ({"ring": 3.5}, "whole number"),
        ({"ring": 5, "bands": 6}, "bands is 6; expected a number from 1 to 5"),
        ({"bands": 0}, "bands is 0"),
        ({"p2": "fourth"}, "expected one of printed, third"),
        ({"p2": -1}, "greater than 0"),
        ({"p2": float("nan")}, "finite"),
        ({"p2": None}, "real number"),
    ],
)
def test_what_cannot_be_a_top_is_refused(values, words):
    with pytest.raises(AnimationError, match=words) as caught:
        Model(**values)
    assert isinstance(caught.value, HFieldError)
    assert isinstance(caught.value, ValueError)
