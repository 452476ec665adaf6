"""Progress of long computations: loops report it, and commands display it."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import TypeVar

T = TypeVar("T")

_now: tuple[str, float, float] | None = None
"""The name of the loop, when it began and the share that is done, as one tuple, which threads read whole."""


def report(done: Fraction | float, total: Fraction | float, what: str) -> None:
    """Report how much of a total is done; reporting the total ends the loop.

    >>> report(3, 4, "classes")
    >>> current()[1]
    0.75
    >>> report(4, 4, "classes"); current()
    """
    global _now
    since = _now[1] if _now is not None and _now[0] == what else time.monotonic()
    _now = (what, since, float(done / total)) if done < total else None


def current() -> tuple[str, float, float] | None:
    """Return the name of the running loop, the fraction done and the seconds since it began, or None."""
    if _now is None:
        return None
    what, since, share = _now
    return what, share, time.monotonic() - since


def track(items: Iterable[T], total: int, what: str) -> Iterator[T]:
    """Yield the items of a loop and report its progress.

    >>> [current()[1] for _ in track("abcd", 4, "letters")]
    [0.0, 0.25, 0.5, 0.75]
    >>> current()
    """
    try:
        for n, item in enumerate(items):
            report(n, total, what)
            yield item
    finally:
        report(1, 1, what)
