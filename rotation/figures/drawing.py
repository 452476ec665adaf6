"""What a figure is, and the look that all of them share."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Four colours that stay apart with any colour vision and in grey (Okabe and Ito's palette).
BLUE, RED, INK, GREY, PALE = "#0072b2", "#d55e00", "#1a1a1a", "#8c8c8c", "#dcdcdc"

STYLE: dict[str, Any] = {
    "font.size": 10.0,
    "axes.titlesize": 10.5,
    "axes.edgecolor": GREY,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "grid.color": "#e6e6e6",
    "grid.linewidth": 0.6,
    "lines.solid_joinstyle": "miter",
    "mathtext.fontset": "dejavusans",
    "svg.hashsalt": "hfield",
}


@dataclass(frozen=True)
class Drawing:
    """A figure: its number in the thesis, a title, its size in inches, and how to draw it.

    ``draw`` fills an empty matplotlib Figure.
    """

    number: str
    title: str
    size: tuple[float, float]
    draw: Callable[[Figure], None]
