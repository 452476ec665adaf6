"""The results as a bar chart on a logarithmic scale."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.cli.output import OutputError, writing
from hfield.errors import shorten
from rotation.bench.measure import Result, Settings
from rotation.bench.results import counted
from rotation.figures.drawing import BLUE, GREY, INK, PALE, RED
from rotation.figures.saving import FORMATS, picture, try_folder, write_whole

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Distinguished by colour, hatch and lightness.
LOOKS: dict[str, dict[str, str]] = {
    "floor": {"facecolor": "white", "edgecolor": INK},
    "ours": {"facecolor": BLUE, "edgecolor": INK},
    "peer": {"facecolor": PALE, "edgecolor": INK},
    "thesis": {"facecolor": "white", "edgecolor": RED, "hatch": "////"},
    "own": {"facecolor": "#f0e442", "edgecolor": INK, "hatch": "...."},
}


def try_chart(path: str) -> Path:
    """Return the path of a chart, after checking that it can be written.

    Raises :class:`~hfield.cli.output.OutputError`.
    """
    target = Path(path)
    if not path or target.suffix[1:].lower() not in FORMATS:
        raise OutputError(
            f"cannot tell the format of {shorten(path)!r}; end the name with "
            + ", ".join(f".{suffix}" for suffix in FORMATS)
        )
    if target.is_dir():
        raise OutputError(f"cannot write {shorten(path)!r}: it is a directory; name a file")
    try_folder(target.parent)
    return target


def write_chart(
    results: Sequence[Result], settings: Settings, path: Path, replace: bool | None = None
) -> None:
    """Draw the results and write them to ``path`` atomically, as :func:`write_whole` does."""
    groups = [
        sorted((r for r in group if r.samples), key=lambda r: -r.best)
        for _, group in groupby(results, key=lambda r: r.test)
    ]

    def draw(figure: Figure) -> None:
        _draw(figure, groups, settings)

    height = sum(0.27 * len(group) + 0.75 for group in groups) + 0.4
    content = picture(draw, (7.6, height), path.suffix[1:].lower())
    with writing(repr(shorten(path))):
        write_whole(path, content, replace)


def _draw(figure: Figure, groups: Sequence[Sequence[Result]], settings: Settings) -> None:
    axes = figure.subplots(
        len(groups), 1, sharex=True, squeeze=False, height_ratios=[len(g) + 0.8 for g in groups]
    )[:, 0]
    times = [1e3 * result.best for group in groups for result in group]
    for ax, group in zip(axes, groups, strict=True):
        for n, result in enumerate(group):
            ms = 1e3 * result.best
            ax.barh(n, ms, height=0.68, lw=0.8, **LOOKS[result.way.role])
            ax.annotate(
                f"{ms:.3g} ms" if ms < 1000 else f"{ms:.0f} ms",
                (ms, n),
                (4, 0),
                textcoords="offset points",
                va="center",
                fontsize=8.5,
                bbox={
                    "facecolor": "white",
                    "edgecolor": "none",
                    "pad": 0.8,
                },  # over the dashed line
            )
        floor = next((1e3 * r.best for r in group if r.way.role == "floor"), None)
        if floor is not None:
            ax.axvline(floor, color=GREY, lw=0.9, ls="--", zorder=0)
        ax.set_yticks(range(len(group)), [result.way.name for result in group])
        ax.tick_params(axis="y", length=0)
        ax.set_xscale("log")
        ax.set_title(group[0].test.title if group else "", loc="left")
    axes[-1].set_xlim(min(times) / 2, max(times) * 4)
    part = any(result.scale > 1 for group in groups for result in group)
    axes[-1].set_xlabel(
        f"best frame of {settings.points} points, ms; "
        f"{counted(settings.threads, 'thread')}; dashed: the copy"
        + ("\nhatched: scaled from a part of the points" if part else "")
    )
