"""Import matplotlib with its default settings instead of the user's."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

BACKEND = "MPLBACKEND"
DATELESS: dict[str, dict[str, None]] = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
"""By suffix, what leaves the time of day out of a file."""


@dataclass(frozen=True)
class Theme:
    """The colours of a page: background, text, lines and small text, zero."""

    page: str
    ink: str
    quiet: str
    zero: str
    lightness: tuple[float, float]


LIGHT = Theme("#ffffff", "#1d2433", "#6d7689", "#10141d", (0.42, 0.86))
DARK = Theme("#11141b", "#eef1f7", "#8a94ad", "#000000", (0.32, 0.78))


def import_matplotlib() -> None:
    """Import matplotlib and its fonts; the font list is built on first use on a machine.

    If the home directory is read-only, a temporary folder is used, and processes started later find it
    through the environment. A backend named by MPLBACKEND is left for programs that open windows; an unknown
    one is ignored.
    """
    logger = logging.getLogger("matplotlib")
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        try:
            import matplotlib as _
        except ValueError:
            backend = os.environ.pop(BACKEND, None)
            if backend is None:
                raise
            try:
                for name in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
                    del sys.modules[name]
                import matplotlib as _  # noqa: F401
            finally:
                os.environ[BACKEND] = backend
        import matplotlib.font_manager  # noqa: F401
    finally:
        logger.setLevel(level)


@contextmanager
def default_settings() -> Iterator[None]:
    """Draw with matplotlib's default settings, whatever the user's matplotlibrc says."""
    import_matplotlib()
    import matplotlib as mpl

    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams["svg.hashsalt"] = "hfield"
        yield


def titled_page(
    colors: Theme, title: str, facts: str, size: tuple[float, float]
) -> tuple[Figure, Axes]:
    """Return a figure of ``size`` inches with a title and a line below it, and the axes, without frame."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    width, height = size
    figure = Figure(figsize=size, facecolor=colors.page)
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0.04, 0.03, 0.92, 1 - 0.03 - 0.77 / height))
    axes.axis("off")
    axes.set_aspect("equal")
    for text, below, color, size_of_letters in (
        (title, 0.254, colors.ink, min(14, 118 * width / len(title))),
        (facts, 0.524, colors.quiet, min(9.5, 128 * width / len(facts))),
    ):
        figure.text(
            *(0.5, 1 - below / height, text),
            ha="center",
            va="center",
            color=color,
            fontsize=size_of_letters,
        )
    return figure, axes


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure to a file that contains no date. Raises OSError, and ValueError for an unknown
    suffix.
    """
    metadata = DATELESS.get(path.suffix.lower(), {})
    figure.savefig(path, facecolor=figure.get_facecolor(), dpi=160, metadata=metadata)
