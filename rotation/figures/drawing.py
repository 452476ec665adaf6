"""The class of figures, and their common style."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hfield.plotting import import_matplotlib
from rotation.angles import to_degrees
from rotation.array_types import NUMPY
from rotation.errors import DTypeError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.typing import ColorType

    from rotation.array_types import Array

# Four colours that stay apart with any colour vision and in grey (Okabe and Ito's palette).
BLUE, RED, INK, GREY, PALE = "#0072b2", "#d55e00", "#1a1a1a", "#8c8c8c", "#dcdcdc"
PAGE, LIGHT_INK = "#11141b", "#eef1f7"  # of dark pictures

Colour = tuple[float, float, float]

STYLE: dict[str, str | float] = {
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
    "axes.prop_cycle": f"cycler(color=[{BLUE!r}, {RED!r}])",
}
DARK_STYLE: dict[str, str] = {
    **dict.fromkeys(["figure.facecolor", "axes.facecolor", "savefig.facecolor"], PAGE),
    **dict.fromkeys(["text.color", "axes.labelcolor", "axes.titlecolor"], LIGHT_INK),
    **dict.fromkeys(["xtick.color", "ytick.color", "axes.edgecolor"], "#9aa3b5"),
    "grid.color": "#2b3140",
    "axes.prop_cycle": "cycler(color=['#56b4e9', '#f0915c'])",
}


@contextmanager
def figure_style(dark: bool = False) -> Iterator[None]:
    """Use the settings of this package, independent of the user's matplotlibrc."""
    import_matplotlib()
    from matplotlib import style

    with style.context(["default", STYLE, *([DARK_STYLE] if dark else [])]):
        yield


def expect_axes(ax: object, kind: str) -> None:
    """Raise `DTypeError` unless ``ax`` are matplotlib axes, "rectilinear" or "3d"."""
    from matplotlib.axes import Axes

    ways = {"rectilinear": "figure.add_subplot()", "3d": 'figure.add_subplot(projection="3d")'}
    if not isinstance(ax, Axes):
        raise DTypeError(
            f"ax is a {type(ax).__name__}; expected axes of matplotlib: write {ways[kind]}"
        )
    if ax.name != kind:
        raise DTypeError(f"ax are {ax.name} axes; expected {kind} ones: write {ways[kind]}")


def ink_of(ax: Axes) -> ColorType:
    """Return the colour of the axes' labels, which is legible on their background."""
    return ax.xaxis.label.get_color()


def angle_text(angle: float | Array, degrees: bool = False) -> str:
    """Return an angle as ``30°``, with up to four digits."""
    return f"{float(angle if degrees else to_degrees(NUMPY, np.asarray(angle))):.4g}°".replace(
        "-", "−"
    )


def two_colours() -> tuple[Colour, Colour]:
    """Return the first two colours of the current cycle, for points and for their images."""
    from matplotlib.colors import to_rgb

    return to_rgb("C0"), to_rgb("C1")


@dataclass(frozen=True)
class Drawing:
    """A figure: its number in the thesis, a title, its size in inches, and how to draw it.

    ``draw`` fills an empty matplotlib Figure.
    """

    number: str
    title: str
    size: tuple[float, float]
    draw: Callable[[Figure], None]
