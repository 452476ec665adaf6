"""Points of the plane rotated about the origin, drawn in matplotlib axes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rotation.arrays import components, real
from rotation.errors import RotationError
from rotation.figures.drawing import Drawing, angle_text, expect_axes, ink_of, two_colours
from rotation.namespaces import refuse_rows
from rotation.plane import from_polar, rotate2, to_polar

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.typing import ColorType

Floats = NDArray[np.floating]


def draw_plane(
    ax: Axes,
    points: ArrayLike,
    angle: ArrayLike,
    *,
    degrees: bool = False,
    joined: bool = True,
) -> Axes:
    """Draw points of the plane and their images under a counterclockwise rotation (thesis 2.1).

    The points have a dashed outline, and the images are filled. Their colours are the first two of the axes'
    cycle (``C0`` and ``C1``); everything else follows the settings of the axes. Both are labelled for a
    legend.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw; the aspect becomes equal.
    points : array_like, shape (n, 2)
        x and y, in any unit of length.
    angle : array_like, shape () or (m,)
        One angle or several, in radians; the arc is drawn only for a single angle.
    degrees : bool
        The angles are in degrees.
    joined : bool
        Join the points in order, the last to the first; otherwise draw the points alone.

    Returns
    -------
    matplotlib.axes.Axes
        ``ax``.

    Raises
    ------
    RotationError
        Points of another shape, or points and angles that are not finite.
    DTypeError
        Axes that are not plane, points that are not an array, or angles that are not numbers.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from rotation import LETTER_T, draw_plane
    >>> ax = Figure().add_subplot()
    >>> draw_plane(ax, LETTER_T, 30, degrees=True).get_legend_handles_labels()[1]
    ['points', 'turned by 30°']
    """
    expect_axes(ax, "rectilinear")
    corners = components(points, 2, "points", "aos")
    angles = real(angle, "angle").astype(np.float64)
    if corners.ndim != 2 or not len(corners):
        raise RotationError(f"expected points of shape (n, 2), n at least 1, found {corners.shape}")
    if angles.ndim > 1:
        raise RotationError(f"expected one angle or a list of them, found the shape {angles.shape}")
    refuse_rows(np.asarray(~np.isfinite(corners).all(axis=1)), "the point", "is not finite")
    refuse_rows(~np.isfinite(angles), "the angle", "is not finite")
    images = rotate2(corners, angles.reshape(-1, 1), degrees=degrees)
    plane_axes(ax, ink_of(ax))
    before, after = two_colours()
    shape = outline if joined else dots
    shape(ax, corners, edgecolor=before, facecolor="none", ls="--", label="points")
    turned = angle_text(angles, degrees) if angles.ndim == 0 else f"{angles.size} angles"
    for n, image in enumerate(images):
        label = None if n else f"turned by {turned}"
        shape(ax, image, edgecolor=after, facecolor=(*after, 0.25), label=label)
    if angles.ndim == 0:
        _draw_angle(ax, corners, float(np.deg2rad(angles) if degrees else angles), turned)
    return ax


def turned_points(points: ArrayLike, angles: Sequence[float], joined: bool = True) -> Drawing:
    """Return a figure of points (n, 2) and their images under rotations by angles in degrees."""
    angle = angles[0] if len(angles) == 1 else angles

    def draw(figure: Figure) -> None:
        ax = figure.add_subplot()
        ax.grid(True)
        ax.set_axisbelow(True)
        draw_plane(ax, points, angle, degrees=True, joined=joined)
        ax.set_xlabel("$x$")
        ax.set_ylabel("$y$")
        figure.legend(*ax.get_legend_handles_labels(), loc="outside upper center", ncols=2)

    return Drawing("turned", "Points turned about the origin", (6.4, 6.4), draw)


def plane_axes(ax: Axes, colour: ColorType, width: float = 0.8) -> None:
    """Make the aspect equal and draw the two coordinate axes."""
    ax.set_aspect("equal")
    ax.axhline(0, color=colour, lw=width)
    ax.axvline(0, color=colour, lw=width)


def outline(ax: Axes, corners: Floats, **style: Any) -> None:
    """Draw a polygon (n, 2); with fewer than three corners a segment or a point."""
    if len(corners) < 3:
        dots(ax, corners, **style)
    if len(corners) > 1:
        ax.fill(*corners.T, **style)


def dots(ax: Axes, points: Floats, **style: Any) -> None:
    """Draw only the points (n, 2), in the style of a polygon."""
    style.pop("ls", None)
    x, y = points.T
    ax.scatter(x, y, 24, **style)


def arrow(
    ax: Axes,
    start: tuple[float, float],
    end: tuple[float, float],
    colour: ColorType,
    width: float = 1.8,
) -> None:
    """Draw an arrow between two points."""
    style = {"arrowstyle": "-|>", "color": colour, "lw": width, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", xy=end, xytext=start, arrowprops=style)


def arc(ax: Axes, radius: float, start: float, end: float, colour: ColorType) -> None:
    """Draw an arc about the origin between two angles, in radians, with an arrowhead at its end."""
    path = from_polar(radius, np.linspace(start, end, 61))
    ax.plot(*path.T, color=colour, lw=1.1)
    (x, y), (end_x, end_y) = path[[-3, -1]].tolist()
    arrow(ax, (x, y), (end_x, end_y), colour, 0.9)


def _draw_angle(ax: Axes, corners: Floats, angle: float, text: str) -> None:
    """Draw the angle at the origin from the centroid of the points to the centroid of their images.

    If the centroid is the origin, the angle starts at the first point other than the origin.
    """
    reach = np.hypot(*corners.T).max()
    middle = corners.mean(axis=0)
    if np.hypot(*middle) < reach / 20:
        middle = corners[np.hypot(*corners.T) >= reach / 2][0]
    (radius, start), ink = map(float, to_polar(middle)), ink_of(ax)
    sweep = float(np.fmod(angle, 2 * np.pi))
    if not radius or not sweep:
        return
    for each in (start, start + sweep):
        ax.plot(*from_polar([0, radius], each).T, color=ink, lw=0.8, ls=":")
    arc(ax, radius / 2, start, start + sweep, ink)
    ax.update_datalim([from_polar(0.7 * radius, start + sweep / 2)])  # room for the text
    ax.autoscale_view()
    across = from_polar(16.0, start + sweep / 2)
    ax.annotate(
        text,
        tuple(from_polar(radius / 2, start + sweep / 2)),
        tuple(across),
        textcoords="offset points",
        color=ink,
        ha="center",
        va="center",
        bbox={"facecolor": ax.get_facecolor(), "edgecolor": "none", "alpha": 0.7, "pad": 1},
    )
