import pickle
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from anim.errors import AnimationError
from anim.model import Model
from anim.picture import STYLES, Camera, RenderSettings, painter
from anim.picture.styles.shaded import LINEAR
from anim.rendering import FrameTask, draw
from tests.anim.cones import cone_hits, interior, random_rotation, rays
from tests.anim.test_picture_projection import about_y, about_z

MODEL = Model(ring=200)
TRACE = (214, 57, 72)
SIZE = (240, 180)
APEX = np.array([0, 0, 3.0])


def spiral(count=200, lean=0.7):
    """Return apex positions along a spiral from the top of the sphere outwards."""
    turns, leans = np.linspace(0, 8 * np.pi, count), np.linspace(0, lean, count)
    return 3 * np.column_stack(
        [np.sin(leans) * np.cos(turns), np.sin(leans) * np.sin(turns), np.cos(leans)]
    )


def reddish(picture):
    """Tell which pixels have the colour of the trace."""
    return (np.abs(picture.astype(int) - TRACE) < 30).all(axis=-1)


@pytest.mark.parametrize("style", STYLES)
def test_pictures_depend_on_the_arguments_only(style):
    look = RenderSettings(SIZE, style, trace=True, shadow=True)
    rng = np.random.default_rng(1)
    rotations = [random_rotation(rng) for _ in range(4)]
    trails = [spiral(n) for n in (1, 3, 100, 200)]
    jobs = list(zip(rotations, trails, strict=True))
    brush = painter(MODEL, look)
    first = [brush.draw(*job).tobytes() for job in jobs]
    backwards = [brush.draw(*job).tobytes() for job in reversed(jobs)]
    assert first == backwards[::-1]
    copy = pickle.loads(pickle.dumps(brush))
    assert first == [copy.draw(*job).tobytes() for job in jobs]
    with ThreadPoolExecutor(4) as pool:
        own = pool.map(lambda job: painter(MODEL, look).draw(*job).tobytes(), jobs)
        assert first == list(own)
        tasks = [
            FrameTask(MODEL, look, matrix[None], trail, np.zeros((1, 3))) for matrix, trail in jobs
        ] * 3
        drawn = [picture.tobytes() for picture in pool.map(draw, tasks)]
        assert drawn == first * 3


@pytest.mark.parametrize("style", STYLES)
def test_a_picture_handed_out_is_left_alone(style):
    brush = painter(MODEL, RenderSettings(SIZE, style))
    picture = brush.draw(np.eye(3))
    kept = picture.copy()
    brush.draw(about_y(1.0))
    np.testing.assert_array_equal(picture, kept)
    picture[:] = 0
    np.testing.assert_array_equal(brush.draw(np.eye(3)), kept)


@pytest.mark.parametrize("style", STYLES)
def test_background_is_the_given_one(style):
    picture = painter(MODEL, RenderSettings(SIZE, style, background="#102030")).draw(np.eye(3))
    assert tuple(picture[0, 0]) == (16, 32, 48)


@pytest.mark.parametrize("style", STYLES)
def test_colours_are_the_given_ones(style):
    picture = painter(
        MODEL, RenderSettings(SIZE, style, colours=("#3060ff", "white"), tilt=0)
    ).draw(np.eye(3))
    blue = picture[..., 2].astype(int) - picture[..., 0]
    yellow = picture[..., 0].astype(int) - picture[..., 2]
    assert (blue > 60).sum() > 500
    assert (yellow > 60).sum() == 0


def test_without_smoothing_there_are_no_mixed_colours():
    picture = painter(MODEL, RenderSettings(SIZE, quality=1)).draw(about_y(0.4))
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) <= 7


@pytest.mark.parametrize("lean", [0.1, 1.0, 2.2])
def test_edges_of_lit_pictures_are_the_shares_that_faces_cover(lean):
    size, fine = (100, 75), 12
    look = RenderSettings(size, "shaded", background="#e9ecef", tilt=180)
    large = replace(look, size=(size[0] * fine, size[1] * fine), quality=1)
    turn = about_z(0.3) @ about_y(lean)
    light = LINEAR[painter(MODEL, large).draw(turn)]
    mean = light.reshape(size[1], fine, size[0], fine, 3).mean(axis=(1, 3))
    apart = np.abs(LINEAR[painter(MODEL, look).draw(turn)] - mean).max(axis=-1)
    assert np.quantile(apart, 0.995) < 0.04
    assert apart.max() < 0.15


@pytest.mark.parametrize("style", STYLES)
def test_trace_is_drawn_where_the_settings_say_so(style):
    bare = painter(MODEL, RenderSettings(SIZE, style)).draw(np.eye(3), spiral())
    np.testing.assert_array_equal(bare, painter(MODEL, RenderSettings(SIZE, style)).draw(np.eye(3)))
    assert not reddish(bare).any()
    assert reddish(
        painter(MODEL, RenderSettings(SIZE, style, trace=True)).draw(np.eye(3), spiral())
    ).any()


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.parametrize("perspective", [True, False])
def test_the_top_hides_the_trace_behind_it_and_not_before_it(style, perspective):
    # From above the ground, level with the upper cone: the trace runs round the sphere at a height of 2.
    camera = Camera(0, 5, perspective=perspective)
    look = RenderSettings((400, 300), style, camera, trace=True, tilt=10)
    brush = painter(MODEL, look)
    turns = np.linspace(-0.15, 0.15, 30)
    ring = np.column_stack([np.cos(turns), np.sin(turns), np.zeros(30)]) * np.sqrt(5)
    before, behind = (ring * (side, 1, 0) + np.array([0, 0, 2.0]) for side in (1, -1))
    bare = brush.draw(np.eye(3)).astype(int)
    top = (bare != painter(MODEL, look).canvas.rgb()).any(axis=-1)
    near, far = (
        np.abs(brush.draw(np.eye(3), trail) - bare).max(axis=-1) > 20 for trail in (before, behind)
    )
    assert near[top].sum() > 5
    assert far.sum() > 5
    assert not far[interior(top.astype(int)) & top].any()


def without_shadow(brush):
    """Return a painter with the same view, framed for the shadow, that leaves the shadow out."""
    other = painter(brush.model, brush.settings)
    other.settings = replace(brush.settings, shadow=False)
    return other


def test_shadow_is_where_no_light_comes():
    look = RenderSettings((320, 240), "flat", Camera(40, 35), shadow=True, tilt=45)
    model = Model()
    brush = painter(model, look)
    for rotation in (np.eye(3), about_z(1.0) @ about_y(0.5) @ about_z(2.0), about_y(-0.78)):
        picture = brush.draw(rotation).astype(int)
        bare = without_shadow(brush).draw(rotation)
        x, y = np.meshgrid(np.arange(320) + 0.5, 239.5 - np.arange(240))
        origin, direction = rays(brush.view.matrix, x.ravel(), y.ravel())
        ground = origin - (origin[:, 2] / direction[:, 2])[:, None] * direction
        light = np.broadcast_to(brush.light, ground.shape) @ rotation
        rims = list(zip(model.profile, model.profile[1:], strict=False))
        start = ground @ rotation + 1e-6 * light
        times = [cone_hits(start, light, a, b, least=0) for a, b in rims]
        shaded = np.isfinite(np.min(times, axis=0)).reshape(240, 320)
        free = (bare == bare[0, 0]).all(axis=-1)
        inside = interior(shaded.astype(int)) & interior(free.astype(int)) & free
        dark = picture.sum(axis=-1) < bare[0, 0].astype(int).sum() - 60
        assert (dark & inside).sum() > 200
        assert ((dark != shaded) & inside).sum() <= 0.002 * (inside & shaded).sum()


def test_seen_from_below_the_shadow_lies_over_the_top():
    below = RenderSettings(SIZE, "flat", Camera(0, -30), shadow=True)
    brush = painter(MODEL, below)
    bare = without_shadow(brush).draw(np.eye(3)).astype(int)
    picture = brush.draw(np.eye(3)).astype(int)
    on_the_top = (bare != bare[0, 0]).any(axis=-1)
    assert (picture[on_the_top] < bare[on_the_top] - 20).any()


def test_a_top_sunk_into_the_ground_throws_the_shadow_of_what_is_above():
    look = RenderSettings(SIZE, "flat", shadow=True, tilt=180)
    brush = painter(MODEL, look)
    for lean in (1.2, 2.0, np.pi):
        assert brush.draw(about_y(lean)).shape == (180, 240, 3)
    upside_down = brush.draw(np.diag([1.0, -1.0, -1.0]))
    bare = without_shadow(brush).draw(np.diag([1.0, -1.0, -1.0]))
    np.testing.assert_array_equal(upside_down, bare)


@pytest.mark.parametrize("spin", [0.0, 2.0, np.pi])
def test_the_side_to_the_light_is_brighter_however_the_top_has_turned(spin):
    look = RenderSettings(SIZE, "shaded", Camera(0, 10), colours=("grey", "grey"), tilt=0)
    brush = painter(MODEL, look)
    empty = brush.canvas.rgb()
    picture = brush.draw(about_z(spin))
    body = np.flatnonzero((picture != empty).any(axis=-1)[100])
    row = picture[100, :, 1].astype(int)
    assert row[body[len(body) // 8]] > row[body[-len(body) // 8]] + 20


@pytest.mark.parametrize(
    "matrix",
    [
        np.eye(2),
        np.eye(4),
        2 * np.eye(3),
        np.diag([1.0, 1.0, -1.0]),
        np.full((3, 3), np.nan),
        np.ones((3, 3)),
    ],
    ids=str,
)
def test_what_is_no_rotation_is_refused(matrix):
    with pytest.raises(AnimationError, match="attitude"):
        painter(MODEL, RenderSettings((16, 16))).draw(matrix)


@pytest.mark.parametrize("trail", [[0, 0, 3], [[0, 0]], [[0, 0, np.inf]]], ids=str)
def test_what_is_no_trail_is_refused(trail):
    with pytest.raises(AnimationError, match="trail"):
        painter(MODEL, RenderSettings((16, 16), trace=True)).draw(np.eye(3), trail)


def test_figures_of_the_thesis(tmp_path):
    from PIL import Image

    from anim.picture import figures

    paths = figures(tmp_path / "new")
    assert [path.stem for path in paths] == [
        "points",
        "skeleton",
        "coloured",
        "turned-about-z",
        "turned-about-both",
        "figure-3.1",
        "figure-3.2",
    ]
    assert sorted(path.name for path in (tmp_path / "new").iterdir()) == sorted(
        path.name for path in paths
    )
    pictures = {path.stem: np.asarray(Image.open(path)).astype(int) for path in paths}
    assert pictures["points"].shape == (480, 640, 3)
    assert pictures["figure-3.2"].shape == (960, 1280, 3)
    points = pictures["points"]
    green = (points[..., 1] > points[..., 0] + 80) & (points[..., 1] > points[..., 2] + 40)
    red = (points[..., 0] > points[..., 1] + 80) & (points[..., 0] > points[..., 2] + 80)
    assert green.sum() > 10 * 40
    assert red.sum() > 5 * 40
    yellow = pictures["figure-3.1"]
    assert ((yellow[..., 0] > 200) & (yellow[..., 2] < 60)).sum() > 2000


def test_the_soft_shadow_is_the_sharp_one_with_a_soft_edge_and_dark_where_the_top_stands():
    camera, size = Camera(40, 12), (320, 240)
    lit, flat = (
        painter(Model(), RenderSettings(size, s, camera, shadow=True, tilt=45))
        for s in ("shaded", "flat")
    )
    for rotation in (about_y(0.3), about_z(4.0) @ about_y(0.7)):
        without = without_shadow(lit).draw(rotation)
        bare = (without == lit.canvas._background).all(axis=-1)
        left = (lit.draw(rotation).astype(float) / without)[..., 1]
        change = without_shadow(flat).draw(rotation).astype(int) - flat.draw(rotation)
        umbra = (change.sum(axis=-1) > 60).astype(int)
        inner = interior(interior(umbra).astype(int)) & (umbra > 0) & bare
        assert left[inner].mean() < 0.7
        assert left[bare].max() < 1.02
        assert (left[bare] > 0.995).mean() > 0.5
        u, v = lit.view.project(np.zeros((1, 3)))[0]
        x, y = np.meshgrid(np.arange(size[0]), size[1] - np.arange(size[1]))
        assert left[bare & (np.hypot(x - u, y - v) < 9)].min() < 0.9 * np.median(left[inner])


def test_the_ground_has_no_bands_and_far_off_is_paper():
    empty = painter(Model(), RenderSettings((640, 480), "shaded")).canvas.rgb()
    assert len(np.unique(empty[0], axis=0)) == 1
    row = empty[400, 200:440, 1].astype(int)
    runs = np.diff(np.flatnonzero(np.diff(row)))
    assert len(runs) > 30
    assert runs.max() < 30


def test_on_dark_paper_the_black_of_the_top_is_seen():
    light, dark = (
        painter(Model(), RenderSettings((320, 240), "shaded", background=paper, tilt=20))
        .draw(about_y(0.3))
        .astype(int)
        for paper in (None, "#17181b")
    )
    black = light.max(axis=-1) < 40
    assert black.sum() > 500
    assert dark[black].max(axis=-1).mean() > light[black].max(axis=-1).mean() + 8


@pytest.mark.slow
def test_an_open_shutter_shows_the_mean_of_many_moments_without_steps():
    """Eight moments, one sample a pixel each, are nearer to eighty than the mean of eight pictures."""
    brush = painter(Model(), RenderSettings((640, 480), "shaded", tilt=30))
    eight, eighty = (
        [about_y(0.3) @ about_z(turn) for turn in np.linspace(-half, half, count)]
        for half, count in ((0.4, 8), (0.4 * 80 / 79 * 8 / 7, 80))
    )
    many, few = (np.mean([LINEAR[brush.draw(m)] for m in some], axis=0) for some in (eighty, eight))
    blurred = LINEAR[brush.expose(eight, None, np.zeros((8, 3)), 0.8)]
    empty = painter(Model(), brush.settings).canvas.rgb()
    top = (brush.draw(eight[0]) != empty).any(axis=-1)
    inside = interior(top.astype(int)) & top
    rough, smooth = (abs(found - many)[inside].mean() for found in (few, blurred))
    assert smooth < 0.5 * rough
    assert smooth < 0.01
