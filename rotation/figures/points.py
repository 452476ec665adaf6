"""Figures 2.1 and 2.2: one point in two coordinate systems, and its image under a rotation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from rotation.figures.drawing import BLUE, GREY, INK, RED
from rotation.figures.plane import arc, arrow
from rotation.plane import from_polar, rotate2

if TYPE_CHECKING:
    from matplotlib.figure import Figure

POINT = (4.0, 3.0)  # figure 2.1: r is 5
VECTOR = from_polar(5.0, np.deg2rad(22.0))
TURN = np.deg2rad(48.0)


def polar_and_cartesian(figure: Figure) -> None:
    """Draw figure 2.1: the polar coordinates r and θ of a point, and its x and y."""
    ax = _plane(figure, 5.6, 4.1)
    x, y = POINT
    theta = np.arctan2(y, x)
    ax.plot([0, x, x], [0, 0, y], color=BLUE, lw=2.0, zorder=4)
    arrow(ax, (0, 0), (x, y), INK)
    arc(ax, 1.3, 0, theta, INK)
    ax.plot([x - 0.25, x - 0.25, x], [0, 0.25, 0.25], color=GREY, lw=0.9)
    ax.text(*from_polar(1.62, theta / 2), r"$\theta$", ha="center", va="center")
    ax.text(1.95, 1.6, "$r$", ha="right", va="bottom")
    ax.text(x / 2, -0.18, r"$x = r\,\cos\theta$", ha="center", va="top", color=BLUE)
    ax.text(x + 0.15, y / 2, r"$y = r\,\sin\theta$", va="center", color=BLUE)
    ax.plot([x], [y], "o", color=INK, ms=5, zorder=5)
    ax.text(x, y + 0.2, r"$p = (x,\ y) = (r,\ \theta)$", ha="center", va="bottom")


def turned_vector(figure: Figure) -> None:
    """Draw figure 2.2: v = (r, θ) and v′ = (r, θ + ψ), on one circle about the origin."""
    ax = _plane(figure, 6.4, 5.9)
    theta = float(np.arctan2(VECTOR[1], VECTOR[0]))
    image = rotate2(VECTOR, TURN)
    sweep = from_polar(5.0, np.linspace(0, np.pi / 2, 91))
    ax.plot(*sweep.T, color=GREY, lw=0.9, ls=(0, (1, 2)))
    for (x, y), colour, style in ((VECTOR, BLUE, "--"), (image, RED, "-.")):
        ax.plot([x, x, 0], [0, y, y], color=colour, lw=1.0, ls=style)
        arrow(ax, (0, 0), (x, y), colour)
        ax.plot([x], [y], "o", color=colour, ms=5)
    arc(ax, 2.7, 0, theta, INK)
    ax.text(*from_polar(2.3, theta / 2), r"$\theta$", ha="center", va="center")
    arc(ax, 1.4, theta, theta + TURN, INK)
    ax.text(*from_polar(1.0, theta + TURN / 2), r"$\psi$", ha="center", va="center")
    (x, y), (u, v) = VECTOR, image
    ax.text(x + 0.18, y + 0.05, r"$\vec{v} = (x,\ y)$", color=BLUE, va="bottom")
    ax.text(
        u + 0.1, v + 0.3, r"$\vec{v}\,' = (x_\Delta,\ y_\Delta)$", color=RED, ha="left", va="bottom"
    )
    for at, name, colour in ((x, "$x$", BLUE), (u, r"$x_\Delta$", RED)):
        ax.text(at, -0.15, name, ha="center", va="top", color=colour)
    for at, name, colour in ((y, "$y$", BLUE), (v, r"$y_\Delta$", RED)):
        ax.text(-0.15, at, name, ha="right", va="center", color=colour)


def _plane(figure: Figure, right: float, top: float) -> Any:
    """Return axes without a frame, with two arrows through the origin."""
    ax = figure.add_subplot(aspect="equal", xlim=(-0.7, right + 0.3), ylim=(-0.7, top + 0.3))
    ax.axis("off")
    for tip, name in (((right, 0), "$x$"), ((0, top), "$y$")):
        arrow(ax, (-0.5 if tip[0] else 0, -0.5 if tip[1] else 0), tip, GREY, 0.9)
        ax.text(tip[0] + 0.12 * (tip[0] > 0), tip[1] + 0.12 * (tip[1] > 0), name, color=INK,
                ha="left" if tip[0] else "center", va="bottom" if tip[1] else "center")  # fmt: skip
    ax.text(-0.12, -0.12, "0", ha="right", va="top")
    return ax
