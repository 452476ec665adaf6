"""`draw_plane` and `Rotation.plot`: the right points in axes of one's own, whose settings stay."""

import matplotlib as mpl
import numpy as np
import pytest
import sympy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb, to_rgba
from matplotlib.figure import Figure

from rotation import LETTER_T, DTypeError, Rotation, RotationError, draw_plane
from tests.subcases import pairs_quick

TURN = Rotation.from_axis_angle([1, 1, 1], 120, degrees=True)
OWN = {"axes.prop_cycle": "cycler(color=['#112233', '#445566'])", "axes.labelcolor": "#778899"}


def axes(projection="rectilinear", **settings):
    with mpl.rc_context(settings):
        return Figure().add_subplot(projection=projection)


def pixels(figure):
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())


def rotated(points, angle):
    """The points turned, by complex numbers."""
    z = np.asarray(points, float) @ [1, 1j] * np.exp(1j * angle)
    return np.stack([z.real, z.imag], axis=-1)


@pytest.mark.parametrize(
    ("angle", "degrees", "radians"),
    [
        (0.3, False, 0.3),
        (30, True, np.pi / 6),
        (sympy.pi / 6, False, np.pi / 6),
        (-400, True, -400 * np.pi / 180),
    ],
)
def test_the_image_is_the_polygon_turned(angle, degrees, radians):
    ax = axes()
    assert draw_plane(ax, LETTER_T, angle, degrees=degrees) is ax
    before, after = (patch.get_xy()[:-1] for patch in ax.patches)
    assert np.array_equal(before, LETTER_T)
    assert np.allclose(after, rotated(LETTER_T, radians), rtol=0, atol=1e-13)
    assert ax.get_aspect() == 1
    (text,) = (text.get_text() for text in ax.texts if text.get_text())
    assert text == f"{np.degrees(radians):.4g}°".replace("-", "−")


def test_the_arc_spans_the_angle():
    ax = axes()
    draw_plane(ax, LETTER_T, -100, degrees=True)
    *_, path = (line.get_xydata() for line in ax.lines)
    turns = np.unwrap(np.angle(path @ [1, 1j]))
    assert np.degrees(turns[-1] - turns[0]) == pytest.approx(-100)


def test_several_angles_and_points_alone():
    ax = axes()
    draw_plane(ax, LETTER_T, [1, 2, 3])
    assert len(ax.patches) == 4
    assert ax.get_legend_handles_labels()[1] == ["points", "turned by 3 angles"]
    ax = axes()
    draw_plane(ax, LETTER_T, 1, joined=False)
    assert not ax.patches
    assert np.allclose(ax.collections[1].get_offsets(), rotated(LETTER_T, 1), rtol=0, atol=1e-13)


@pytest.mark.parametrize("points", [[[0, 0]], [[1, 2]], [[1, 2], [3, 4]], [[1, 0], [-1, 0]]])
@pytest.mark.parametrize("angle", [0, 360, 30])
def test_few_points_and_whole_turns(points, angle):
    draw_plane(axes(), points, angle, degrees=True)


@pytest.mark.parametrize("kind", ["rectilinear", "3d"])
def test_in_axes_that_are_passed_in_their_settings_rule(kind):
    ax = axes(kind, **OWN)
    title, face = ax.get_title(), ax.get_facecolor()
    with mpl.rc_context(OWN):
        draw_plane(ax, LETTER_T, 1) if kind == "rectilinear" else TURN.plot(ax, [[1, 0, 0]])
    assert (ax.get_title(), ax.get_facecolor()) == (title, face)
    inks = {to_rgb(text.get_color()) for text in ax.texts if text.get_text()}
    assert inks == {to_rgb("#778899")}
    shapes = ax.patches if kind == "rectilinear" else ax.collections
    edges = {tuple(np.ravel(shape.get_edgecolor())) for shape in shapes}
    assert {to_rgba("#112233"), to_rgba("#445566")} <= edges


def test_a_figure_that_we_make_has_our_settings():
    from matplotlib import pyplot

    spoilt = {"font.size": 30, "axes.facecolor": "red", "axes.prop_cycle": OWN["axes.prop_cycle"],
              "xtick.color": "lime", "figure.dpi": 30, "lines.linewidth": 9}  # fmt: skip
    pictures = []
    for settings in ({}, spoilt):
        with mpl.rc_context({"backend": "agg", **settings}):
            figure = TURN.plot().figure
            pictures.append(pixels(figure))
            pyplot.close(figure)
    assert np.array_equal(*pictures)


def test_axis_points_and_images_in_space():
    points = np.array([[1.0, 0, 0], [2, 0, 1], [0, 0, 0]])
    ax = axes("3d")
    assert TURN.plot(ax, points) is ax
    tail, tip = np.transpose(ax.lines[0].get_data_3d())
    assert np.allclose(np.cross(tip - tail, [1, 1, 1]), 0, atol=1e-14)
    assert tip @ [1, 1, 1] > 0
    _, before, after = ax.collections  # the head of the axis comes first
    assert np.array_equal(np.transpose(before._offsets3d), points)
    assert np.allclose(np.transpose(after._offsets3d), points[:, [2, 0, 1]], rtol=0, atol=1e-14)
    path = np.transpose(ax.lines[2].get_data_3d())
    assert np.allclose(path[[0, -1]], [points[1], points[1, [2, 0, 1]]], atol=1e-14)
    assert [text.get_text() for text in ax.texts] == ["120°"]


def test_without_points_the_axes_are_turned():
    ax = axes("3d")
    TURN.plot(ax)
    assert [text.get_text() for text in ax.texts] == ["x", "y", "z", "x′", "y′", "z′", "120°"]
    ends = [np.transpose(line.get_data_3d())[-1] for line in ax.lines[1:7]]
    assert np.allclose(ends, [*np.eye(3), *np.eye(3)[[1, 2, 0]]], rtol=0, atol=1e-14)
    lengths = [np.ptp(limits) for limits in (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())]
    assert np.allclose(lengths, lengths[0])


@pytest.mark.parametrize(
    ("points", "angle"),
    pairs_quick([None, [[0, 0, 0]], [[0, 0, 2]], np.ones((100, 3))], [0, 1e-9, 180], 3),
)
def test_no_turn_and_points_on_the_axis(points, angle):
    r = Rotation.from_euler("Z", angle, degrees=True)
    pixels(r.plot(axes("3d"), points).figure)


@pytest.mark.parametrize(
    ("call", "kind", "said"),
    [
        (lambda: draw_plane(Figure(), LETTER_T, 1), DTypeError, r"write figure\.add_subplot\(\)"),
        (lambda: draw_plane(axes("3d"), LETTER_T, 1), DTypeError, "expected rectilinear"),
        (lambda: draw_plane(axes(), [1, 2], 1), RotationError, r"\(n, 2\)"),
        (lambda: draw_plane(axes(), np.empty((0, 2)), 1), RotationError, "n at least 1"),
        (lambda: draw_plane(axes(), [[1, 2, 3]], 1), RotationError, "expected"),
        (lambda: draw_plane(axes(), [[1, 2], [1, np.inf]], 1), RotationError, "row 1 is not finite"),
        (lambda: draw_plane(axes(), LETTER_T, np.nan), RotationError, "angle is not finite"),
        (lambda: draw_plane(axes(), LETTER_T, [[1]]), RotationError, "one angle or a list"),
        (lambda: draw_plane(axes(), LETTER_T, "x"), DTypeError, "angle"),
        (lambda: TURN.plot(axes()), DTypeError, 'projection="3d"'),
        (lambda: TURN.plot(None, [[1, 2]]), RotationError, "points"),
        (lambda: TURN.plot(None, [1, 2, 3]), RotationError, r"\(n, 3\)"),
        (lambda: TURN[None].plot(), RotationError, r"r\[0\]\.plot\(\)"),
        (lambda: Rotation([np.nan] * 4).plot(), RotationError, "not finite"),
    ],
)  # fmt: skip
def test_what_cannot_be_drawn(call, kind, said):
    with pytest.raises(kind, match=said):
        call()
