"""Figures 2.3 to 2.5: the letter T of example 2, rotated about the origin, and under the matrices of 2.1.2.

The images under the matrices are drawn twice: with the printed matrices and with the corrected ones.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from rotation.figures.drawing import BLUE, GREY, INK, PALE, RED
from rotation.figures.plane import Floats, outline, plane_axes
from rotation.plane import (
    LETTER_T,
    area,
    printed_orthogonal,
    printed_reflection,
    reflection,
    rotate2,
    transform,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Matrices = Callable[..., Floats]

STEP = 30  # degrees between the passing positions of figure 2.4, not given in the thesis
ANGLES = np.arange(11) * 36.0  # degrees: 2πn/10 for n = 0 … 10
BEYOND = (14.3, 6.5)  # position of the number of an image: next to the bar of the T
PANELS: tuple[tuple[str, str, Matrices], ...] = (
    ("(a) as printed, O(θ) of example 3", "[cos θ, sin θ; sin θ, cos θ]", printed_orthogonal),
    (
        "(b) as printed for determinant −1",
        "[cos θ, −sin θ; sin θ, −cos θ]",
        printed_reflection,
    ),
    ("(c) as it should be: reflections", "[cos θ, sin θ; sin θ, −cos θ]", reflection),
)


def letter_t(figure: Figure) -> None:
    """Draw figure 2.3: the eight corners, in the order in which they are joined."""
    ax = figure.add_subplot(aspect="equal", xlim=(5.9, 15.1), ylim=(-0.1, 8.1))
    ax.grid(True)
    ax.set_axisbelow(True)
    corners = np.array(LETTER_T, float)
    outline(ax, corners, facecolor="#eef4f9", edgecolor=BLUE, lw=1.8)
    ax.plot(*corners.T, "o", color=BLUE, ms=5)
    for n, (x, y) in enumerate(LETTER_T, 1):
        left, side = x <= 10, {7: "bottom", 6: "center" if x in (8, 13) else "top", 1: "top"}[y]
        ax.annotate(
            rf"$x_{n}$ = ({x}, {y})",
            (x, y),
            (-7 if left else 7, {"bottom": 4, "center": 0, "top": -5}[side]),
            textcoords="offset points",
            ha="right" if left else "left",
            va=side,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
        )
    ax.set_xlabel("$x$")
    ax.set_ylabel("$y$")


def letter_turned(figure: Figure) -> None:
    """Draw figure 2.4: the images under π/2, π and 3π/2 in black, intermediate positions in grey."""
    ax = figure.add_subplot()
    _square(ax, 17, 0.8)
    for angle in range(0, 360, STEP):
        if angle % 90:
            outline(ax, _turned(angle), fill=False, edgecolor=GREY, lw=0.9, ls="--")
    names = {90: r"$\pi/2$", 180: r"$\pi$", 270: r"$3\pi/2$"}
    for angle, name in names.items():
        outline(ax, _turned(angle), facecolor=PALE, edgecolor=INK, lw=1.8)
        x, y = rotate2((10.5, 8.6), angle, degrees=True)
        ax.text(x, y, name, ha="center", va="center", fontsize=12)
    outline(ax, _turned(0), facecolor="#fbe9dd", edgecolor=RED, lw=2.2, hatch="///")
    ax.text(11.4, 3.8, "the original", color=RED, va="center")


def _square(ax: Axes, reach: float, width: float) -> None:
    """Show the plane from −reach to reach with a grid."""
    ax.set(xlim=(-reach, reach), ylim=(-reach, reach))
    ax.grid(True)
    ax.set_axisbelow(True)
    ax.tick_params(labelsize=8)
    plane_axes(ax, GREY, width)


def _turned(degrees: float) -> Floats:
    return rotate2(LETTER_T, degrees, degrees=True)


def letter_mirrored(figure: Figure) -> None:
    """Draw figure 2.5: the images for the angles 2πn/10, n = 0 … 10, and their areas."""
    axes = figure.subplots(2, 2)
    for ax, (title, entries, matrices) in zip(axes.flat, PANELS, strict=False):
        _images(ax, matrices)
        ax.set_title(f"{title}\n{entries}")
    _areas(axes[1, 1])


def _images(ax: Axes, matrices: Matrices) -> None:
    """Draw the images: filled and solid if the area equals that of the T, otherwise thin and dashed."""
    _square(ax, 19, 0.7)
    m = matrices(ANGLES[:10], degrees=True)
    images = transform(m[:, None], LETTER_T)
    kept = np.isclose(area(images), area(LETTER_T))
    for image, keeps in zip(images, kept, strict=True):
        style: dict[str, str | float] = (
            {"facecolor": PALE, "lw": 1.6} if keeps else {"fill": False, "lw": 1.0, "ls": "--"}
        )
        outline(ax, image, edgecolor=INK if keeps else GREY, **style)
    outline(ax, np.array(LETTER_T, float), fill=False, edgecolor=RED, lw=2.2, hatch="////")
    for n, (x, y) in enumerate(transform(m, BEYOND)):
        name, side = ("0, 10", "left") if n == 0 else (str(n), "center")
        ax.text(x - 0.8 * (n == 0), y, name, fontsize=9, ha=side, va="center")


def _areas(ax: Axes) -> None:
    """Plot the areas of the images over n."""
    fine = np.linspace(0, 360, 361)
    for matrices, colour, style in (
        (reflection, BLUE, {"marker": "o", "ls": "-"}),
        (printed_orthogonal, RED, {"marker": "s", "ls": "--"}),
    ):
        smooth = area(transform(matrices(fine, degrees=True)[:, None], LETTER_T))
        ax.plot(fine / 36, smooth, color=colour, lw=1.4, ls=style["ls"])
        points = area(transform(matrices(ANGLES, degrees=True)[:, None], LETTER_T))
        ax.plot(range(11), points, color=colour, ls="none", marker=style["marker"], ms=6)
    ax.text(2.5, 10.25, "(c) as it should be: always 10", color=BLUE, ha="center", va="bottom")
    ax.text(5, 1.5, "as printed,\n(a) and (b):\n10 |cos 2θ|", color=RED, ha="center", va="center")
    ax.set_title("(d) area of the image of the T, whose own area is 10")
    ax.set(xlim=(-0.4, 10.4), ylim=(0, 11.4), xticks=range(11))
    ax.set_xlabel("n,   θ = 2πn/10")
    ax.set_ylabel("area")
    ax.grid(True)
