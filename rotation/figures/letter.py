"""Figures 2.3 and 2.4: the letter T of example 2, and the same turned about the origin."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from rotation.figures.drawing import BLUE, GREY, INK, PALE, RED
from rotation.plane import LETTER_T, rotate2

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STEP = 30  # degrees between the passing positions of figure 2.4, which the thesis does not tell


def letter_t(figure: Figure) -> None:
    """Draw figure 2.3: the eight corners, in the order in which they are joined."""
    ax = figure.add_subplot(aspect="equal", xlim=(5.9, 15.1), ylim=(-0.1, 8.1))
    ax.grid(True)
    ax.set_axisbelow(True)
    corners = np.array(LETTER_T, float)
    ax.fill(*corners.T, facecolor="#eef4f9", edgecolor=BLUE, lw=1.8)
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
    """Draw figure 2.4: black the images under π/2, π and 3π/2, grey the passing positions."""
    ax = figure.add_subplot(aspect="equal", xlim=(-17, 17), ylim=(-17, 17))
    ax.set_axisbelow(True)
    ax.grid(True)
    ax.tick_params(labelsize=8)
    ax.axhline(0, color=GREY, lw=0.8)
    ax.axvline(0, color=GREY, lw=0.8)
    for angle in range(0, 360, STEP):
        if angle % 90:
            ax.fill(*_turned(angle).T, fill=False, edgecolor=GREY, lw=0.9, ls="--")
    names = {90: r"$\pi/2$", 180: r"$\pi$", 270: r"$3\pi/2$"}
    for angle, name in names.items():
        ax.fill(*_turned(angle).T, facecolor=PALE, edgecolor=INK, lw=1.8)
        x, y = rotate2((10.5, 8.6), angle, degrees=True)
        ax.text(x, y, name, ha="center", va="center", fontsize=12)
    ax.fill(*_turned(0).T, facecolor="#fbe9dd", edgecolor=RED, lw=2.2, hatch="///")
    ax.text(11.4, 3.8, "the original", color=RED, va="center")


def _turned(degrees: float) -> Any:
    return rotate2(LETTER_T, degrees, degrees=True)
