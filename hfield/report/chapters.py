"""Chapters of other packages, found by the entry points ``hfield.report_sections``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.metadata import entry_points

from hfield.errors import HFieldError, shorten

GROUP = "hfield.report_sections"


class ChapterError(HFieldError, LookupError):
    """No package has the chapter, or it cannot be built."""


@dataclass(frozen=True)
class Chapter:
    """One chapter: its section in the thesis (numbers and dots), its title, and its body as HTML.

    An entry point of the group ``hfield.report_sections`` names a function of a language (``en`` or ``pl``)
    that returns a chapter. The body must not load anything from the network.
    """

    section: str
    title: str
    body: str


Progress = Callable[[int, int, str], None]


def names() -> list[str]:
    """Return the names of all chapters."""
    return sorted(entry_points(group=GROUP).names)


def require(wanted: Sequence[str]) -> None:
    """Raise :class:`ChapterError` for a chapter that no installed package has."""
    known = names()
    for name in wanted:
        if name not in known:
            listed = ", ".join(known) or "none is installed"
            raise ChapterError(f"there is no chapter {shorten(name)!r}; there are {listed}")


def chapters(
    wanted: Sequence[str], language: str, progress: Progress | None = None
) -> list[Chapter]:
    """Build the named chapters, in the order of their sections. Raises :class:`ChapterError`."""
    require(wanted)
    points = entry_points(group=GROUP)
    made = []
    for done, name in enumerate(wanted):
        if progress:
            progress(done, len(wanted), f"chapter {name}")
        chapter = points[name].load()(language)
        if not isinstance(chapter, Chapter):
            raise ChapterError(
                f"the chapter {name!r} is a {type(chapter).__name__}, expected a Chapter"
            )
        made.append(chapter)
    return sorted(made, key=lambda chapter: [int(n) for n in chapter.section.split(".")])
