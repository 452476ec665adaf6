"""Save a drawing as a file, reproducibly and atomically."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import AbstractContextManager
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryFile
from typing import TYPE_CHECKING

from hfield.cli.output import writing
from hfield.core.files import whole_file
from hfield.core.progress import track
from hfield.errors import shorten
from hfield.plotting import DATELESS
from rotation.figures.drawing import Drawing, figure_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = ("png", "svg", "pdf")


def picture(
    draw: Callable[[Figure], None],
    size: tuple[float, float],
    suffix: str = "png",
    dpi: int = 150,
    words: Mapping[str, str] | None = None,
    dark: bool = False,
) -> bytes:
    """Return the picture drawn by ``draw`` on ``size`` inches as bytes, independent of date and settings.

    ``suffix`` is one of ``FORMATS``; ``dpi`` applies to png only; ``words`` replaces labels; ``dark``
    pictures are for dark pages.
    """
    out = BytesIO()
    with figure_style(dark):
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
        from matplotlib.text import Text

        figure = Figure(figsize=size, layout="constrained")
        FigureCanvasAgg(figure)
        draw(figure)
        for text in figure.findobj(Text):
            text.set_text((words or {}).get(text.get_text(), text.get_text()))
        figure.savefig(out, format=suffix, dpi=dpi, metadata=DATELESS.get(f".{suffix}", {}))
    return out.getvalue()


def save(
    drawings: Iterable[Drawing],
    directory: Path,
    suffix: str = "png",
    dpi: int = 150,
    dark: bool = False,
) -> list[Path]:
    """Write each drawing to ``directory/figure-NUMBER.suffix`` and return the paths.

    The directory is created if missing, and checked before anything is drawn. Raises
    :class:`~hfield.cli.output.OutputError` if it cannot be written.
    """
    try_folder(directory)
    paths = []
    with _writing(directory):
        chosen = list(drawings)
        for drawing in track(chosen, len(chosen), "figures"):
            path = directory / f"figure-{drawing.number}.{suffix}"
            write_whole(path, picture(drawing.draw, drawing.size, suffix, dpi, dark=dark))
            paths.append(path)
    return paths


def try_folder(directory: Path) -> None:
    """Create a directory if it is missing, and check that it is writable.

    Raises :class:`~hfield.cli.output.OutputError`.
    """
    with _writing(directory):
        directory.mkdir(parents=True, exist_ok=True)
        with TemporaryFile(dir=directory):
            pass


def _writing(directory: Path) -> AbstractContextManager[None]:
    return writing(f"to {shorten(directory)!r}", "directory")


def write_whole(path: Path, content: bytes, replace: bool | None = None) -> None:
    """Write a file completely or not at all, as :func:`whole_file` does. Raises OSError."""
    with whole_file(path, replace) as part:
        part.write_bytes(content)
