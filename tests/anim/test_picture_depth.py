"""What hides what, in all styles, against rays met with cones."""

import numpy as np
import pytest

from anim.model import Model
from anim.picture import Camera, RenderSettings, outlines, painter
from anim.picture.styles import flat, shaded
from tests.anim.cones import NOTHING, interior, nearest, random_rotation, reference
from tests.subcases import pairs_quick, subcases
from tests.thorough import cases

# A colour of its own for each piece and band, far apart from each other.
COLOURS = [
    ((255, 0, 0), (0, 160, 0)),
    ((0, 0, 255), (255, 255, 0)),
    ((255, 0, 255), (0, 255, 255)),
    ((255, 130, 0), (120, 60, 0)),
    ((130, 0, 130), (130, 255, 130)),
    ((0, 70, 90), (255, 170, 190)),
]
PALETTE = [colour for pair in COLOURS for colour in pair]
SIZE = (400, 300)
LIMIT = 0.002
LEAK = 16  # levels of 255; where two edges just touch, the far side comes through with up to 64


@pytest.fixture(scope="module")
def attitudes():
    rng = np.random.default_rng(1)
    return [random_rotation(rng) for _ in range(cases(200))]


def coloured(model: Model, look: RenderSettings):
    """Return a painter whose pieces have the colours above and whose light is even."""
    brush = painter(model, look)
    if look.style == "shaded":
        mesh = brush.mesh
        body = shaded.ShadedBody(mesh, model.palette, np.array([0, 0, 1.0]), look.quality, 0.0)
        pieces = np.repeat(np.repeat(np.arange(len(mesh.groups)), mesh.groups), mesh.ring)
        bands = np.tile(mesh.keys, sum(mesh.groups))
        body.paints = shaded.LINEAR[np.array(COLOURS)][pieces, bands]
        body.lighting = lambda view, rotation: np.tile([1.0, 0.0], (len(body._normals), 1))
        brush.body = body
    else:
        brush.body = flat.FlatBody(brush.mesh, COLOURS)
    return brush


def wrong(brush, rotation, empty) -> tuple[int, int]:
    """Return how many interior pixels differ from the reference, and how many show the top."""
    expected = reference(brush.view.matrix, brush.settings.size, rotation, brush.model)
    inside = interior(expected)
    picture, expected = brush.draw(rotation)[inside], expected[inside]
    shown = np.full(expected.shape, NOTHING)
    drawn = (picture != empty[inside]).any(axis=-1)
    shown[drawn] = nearest(picture[drawn], PALETTE)
    return int((shown != expected).sum()), int((expected != NOTHING).sum())


def share_wrong(brush, rotations) -> float:
    empty = brush.canvas.rgb()
    counts = [wrong(brush, rotation, empty) for rotation in rotations]
    bad, total = np.sum(counts, axis=0)
    assert total > 100 * len(counts)
    return bad / total


@pytest.mark.slow
@pytest.mark.parametrize("style", ["flat", "classic", "shaded"])
def test_depth_is_right_in_many_attitudes(style, attitudes):
    brush = coloured(Model(), RenderSettings(SIZE, style, tilt=180))
    assert share_wrong(brush, attitudes) <= LIMIT


@pytest.mark.slow
@subcases(
    "camera",
    [
        Camera(30, 75, perspective=False),
        Camera(100, -25, distance=7),
        Camera(0, 0, zoom=1.1),
        Camera(-60, 90),
    ],
)
@subcases("style", ["flat", "classic", "shaded"])
def test_depth_is_right_from_other_cameras(style, camera, attitudes):
    brush = coloured(Model(p2="third"), RenderSettings(SIZE, style, camera, tilt=180))
    assert share_wrong(brush, attitudes[:8]) <= LIMIT


@pytest.mark.parametrize(("p2", "style"), pairs_quick([0.1, 0.9, 1.4], ["flat", "shaded"], 2))
def test_depth_is_right_for_other_collars(style, p2, attitudes):
    brush = coloured(Model(p2=p2, bands=7), RenderSettings(SIZE, style, tilt=180))
    assert share_wrong(brush, attitudes[8:16]) <= LIMIT


OUTLINES = {
    "bottle": [(0, 0.3), (0.1, 1.1), (1.6, 1.0), (1.6, 0.3), (3, 0.2)],
    "disc, wider than tall": [(0, 0), (0.8, 1.9), (1.0, 1.9), (1.1, 0.2), (1.9, 0.15)],
    "cylinder": [(0, 1), (2, 1)],
    "waist": [(0, 0), (0.7, 1.0), (1.5, 0.25), (2.2, 0.9), (3, 0)],
}


@pytest.mark.parametrize(("name", "style"), pairs_quick(OUTLINES, ["flat", "shaded"], 4))
def test_depth_is_right_for_other_outlines(style, name, attitudes):
    model = Model.from_outline(OUTLINES[name], bands=7)
    # Rays know nothing of the picture's unit: the model is as large as its picture.
    brush = coloured(model.scaled(model.magnified), RenderSettings(SIZE, style, tilt=180))
    assert share_wrong(brush, attitudes[16:22]) <= LIMIT


def test_between_the_rings_the_band_hides_both_cones():
    # The eye in the slab between P₁ and P₂ of the upright top: the order with two far sides.
    brush = coloured(
        Model(p2=0.9), RenderSettings(SIZE, "flat", Camera(0, -1.0, distance=8), tilt=0)
    )
    height = brush.view.eye[2]
    assert 1 < height < 1.1
    bad, total = wrong(brush, np.eye(3), brush.canvas.rgb())
    assert bad <= LIMIT * total


def test_a_wrong_order_would_be_found(monkeypatch, attitudes):
    monkeypatch.setattr(flat, "drawing_order", lambda eye, heights: (2, 1, 0))
    brush = coloured(Model(), RenderSettings(SIZE, "flat", tilt=180))
    assert share_wrong(brush, attitudes[:10]) > 5 * LIMIT


def test_without_culling_it_would_be_found(monkeypatch, attitudes):
    from anim.picture.solid import Piece

    monkeypatch.setattr(Piece, "facing", lambda self, eye: np.ones(len(self.low), bool))
    brush = coloured(Model(), RenderSettings(SIZE, "flat", tilt=180))
    assert share_wrong(brush, attitudes[:10]) > 5 * LIMIT


def leaking(ring: int, rotations) -> float:
    """Return the share of the interior in which a top of a single colour shows another one."""
    look = RenderSettings(
        SIZE, "classic", background="white", tilt=180, colours=("#d02040", "#d02040")
    )
    brush = painter(Model(ring=ring), look)
    empty = brush.canvas.rgb()
    leaks = total = 0
    for rotation in rotations:
        picture = brush.draw(rotation)
        windows = np.lib.stride_tricks.sliding_window_view((picture != empty).any(axis=-1), (5, 5))
        inside = np.pad(windows.all(axis=(2, 3)), 2)
        apart = np.abs(picture[inside].astype(int) - (208, 32, 64)).max(axis=-1)
        leaks, total = leaks + (apart > LEAK).sum(), total + inside.sum()
    return leaks / total


@pytest.mark.parametrize("ring", [3, 10, 1000])
def test_seams_let_nothing_through(ring, attitudes):
    assert leaking(ring, attitudes[20:30]) <= LIMIT


def test_seams_without_overlap_would_be_found(monkeypatch, attitudes):
    monkeypatch.setattr(outlines, "OVERLAP", 1e-6)
    monkeypatch.setattr(outlines, "DEPTH", 1e-6)
    assert leaking(1000, attitudes[20:30]) > 5 * LIMIT


@pytest.mark.slow
def test_flat_and_shaded_agree_on_a_coarse_top():
    # With few points the cones are no reference; but outlines and triangles are independent.
    model, rng = Model(ring=5, bands=5), np.random.default_rng(5)
    flat_one = coloured(model, RenderSettings(SIZE, "flat", background="white", tilt=180))
    deep_one = coloured(model, RenderSettings(SIZE, "shaded", background="white", tilt=180))
    for _ in range(8):
        rotation = random_rotation(rng)
        palette = [*PALETTE, (255, 255, 255)]
        one = nearest(flat_one.draw(rotation), palette)
        other = nearest(deep_one.draw(rotation), palette)
        inside = interior(other) & interior(one)
        assert ((one != other) & inside).sum() <= LIMIT * inside.sum()
