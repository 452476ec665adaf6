"""Draw a rotation in three-dimensional matplotlib axes: its axis, its angle, and rotated points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rotation.array_types import ArrayLike
from rotation.arrays import components
from rotation.errors import RotationError
from rotation.figures.drawing import (
    Colour,
    angle_text,
    expect_axes,
    figure_style,
    ink_of,
    two_colours,
)
from rotation.matrices import to_matrix
from rotation.namespaces import expect_numpy, refuse_rows
from rotation.vectors import from_axis_angle, to_axis_angle

if TYPE_CHECKING:
    from matplotlib.typing import ColorType
    from mpl_toolkits.mplot3d.axes3d import Axes3D

Floats = NDArray[np.floating]
MAX_ARCS = 24  # points whose paths are drawn
FRAME = np.eye(3)
LETTERS = "xyz"


def plot_rotation(q: Floats, ax: Axes3D | None, points: ArrayLike | None) -> Axes3D:
    """Draw the rotation of a unit quaternion (4,), as described in `rotation.Rotation.plot`."""
    expect_numpy("plot", q)
    if q.ndim != 1:
        raise RotationError(
            f"plot draws a single rotation, and this is an array of shape {q.shape[:-1]}; draw one of them, "
            "as by r[0].plot()"
        )
    refuse_rows(np.asarray(~np.isfinite(q).all()), "the rotation", "is not finite")
    start = FRAME if points is None else _checked(points)
    if ax is not None:
        expect_axes(ax, "3d")
        _draw(ax, q, start, points is None)
        return ax
    with figure_style():
        from matplotlib import pyplot

        figure = pyplot.figure(figsize=(5.6, 5.4), layout="constrained")
        made: Axes3D = figure.add_subplot(projection="3d")
        _draw(made, q, start, points is None)
        made.set_title(_title(q))
        made.tick_params(labelsize=9)  # in points: a size in words is read again at every drawing
        figure.draw_without_rendering()  # ticks take their settings when they are first drawn
    return made


def _checked(points: ArrayLike) -> Floats:
    rows = components(points, 3, "points", "aos")
    if rows.ndim != 2 or not len(rows):
        raise RotationError(f"expected points of shape (n, 3), n at least 1, found {rows.shape}")
    refuse_rows(np.asarray(~np.isfinite(rows).all(axis=1)), "the point", "is not finite")
    return rows.astype(np.float64)


def _title(q: Floats) -> str:
    axis, angle = to_axis_angle(q)
    if angle == 0:
        return "the identity"
    numbers = ", ".join(f"{round(x, 12) + 0.0:.3g}" for x in axis.tolist())
    return f"{angle_text(angle)} about ({numbers})"


def _draw(ax: Axes3D, q: Floats, start: Floats, frame: bool) -> None:
    """Draw the axis, the points before and after, their paths, and the angle at the longest path."""
    axis, angle = to_axis_angle(q.astype(np.float64))
    end = start @ to_matrix(q.astype(np.float64)).T
    ink, reach = ink_of(ax), np.linalg.norm(start, axis=1).max() or 1.0
    if angle:
        tip = 1.25 * reach * axis
        ax.plot(*np.stack([-0.4 * tip, tip], axis=1), color=ink, lw=0.9, ls="-.", label="axis")
        ax.quiver(*(0.9 * tip), *(0.1 * tip), color=ink, lw=0.9, arrow_length_ratio=1)
    before, after = two_colours()
    if frame:
        _draw_frame(ax, start, before, "", 1.12, ls="--", lw=1.3, zorder=3, label="axes x, y, z")
        _draw_frame(ax, end, after, "′", 1.3, lw=2.6, label="turned")
    else:
        style = {"s": 24, "depthshade": False}
        ax.scatter(*start.T, edgecolors=[before], facecolors="none", label="points", **style)
        ax.scatter(*end.T, color=[after], label="turned", **style)
    if angle and len(start) <= MAX_ARCS:
        _draw_paths(ax, axis, float(angle), start, ink)
    _equal_lengths(ax)
    for letter in LETTERS:
        if not getattr(ax, f"get_{letter}label")():
            getattr(ax, f"set_{letter}label")(letter)


def _draw_frame(
    ax: Axes3D, frame: Floats, colour: Colour, mark: str, beyond: float, **style: Any
) -> None:
    """Draw three vectors from the origin, with the labels x, y and z beyond their ends."""
    vectors = np.stack([0 * frame, frame], axis=-1)
    for letter, vector, point in zip(LETTERS, vectors, frame, strict=True):
        ax.plot(*vector, color=colour, **style)
        ax.text(*(beyond * point), letter + mark, color=colour, ha="center", va="center")
        style.pop("label", None)
    ax.auto_scale_xyz(*(beyond * frame).T)  # with room for the letters


def _equal_lengths(ax: Axes3D) -> None:
    """Set equal limits on all axes, unless the user has set the limits."""
    if ax.get_autoscale_on():
        limits = np.array([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()])
        half = np.ptp(limits, axis=1).max() / 2
        for letter, middle in zip(LETTERS, limits.mean(axis=1), strict=True):
            getattr(ax, f"set_{letter}lim")(middle - half, middle + half, auto=True)
        ax.set_box_aspect((1, 1, 1))


def _draw_paths(ax: Axes3D, axis: Floats, angle: float, start: Floats, ink: ColorType) -> None:
    """Draw the arc from each point to its image, and the angle at the longest of them."""
    turns = to_matrix(from_axis_angle(axis, np.linspace(0, angle, 49)))
    for point in start:
        ax.plot(*(turns @ point).T, color=ink, lw=0.8, ls=":")
    widths = np.linalg.norm(np.cross(axis, start), axis=1)
    widest = start[int(widths.argmax())]
    if widths.any():
        ax.text(
            *(1.25 * turns[24] @ widest), angle_text(angle), color=ink, ha="center", va="center"
        )
