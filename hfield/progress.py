"""How far long computations are: their loops tell it here, and a command that waits reads it."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import TypeVar

T = TypeVar("T")

_now: tuple[str, float, float] | None = None
"""What is being gone through, since when, and the share that is done. One tuple: threads read it whole."""


def tell(done: Fraction | float, total: Fraction | float, what: str) -> None:
    """Note that so much of the total is done; at its end nothing is being gone through any more.

    >>> tell(3, 4, "classes")
    >>> told()[1]
    0.75
    >>> tell(4, 4, "classes"); told()
    """
    global _now
    since = _now[1] if _now is not None and _now[0] == what else time.monotonic()
    _now = (what, since, float(done / total)) if done < total else None


def told() -> tuple[str, float, float] | None:
    """Return what is being gone through, the share that is done, and for how many seconds it has been."""
    if _now is None:
        return None
    what, since, share = _now
    return what, share, time.monotonic() - since


def along(items: Iterable[T], total: int, what: str) -> Iterator[T]:
    """Yield the items of a loop, telling how far it is.

    >>> [told()[1] for _ in along("abcd", 4, "letters")]
    [0.0, 0.25, 0.5, 0.75]
    >>> told()
    """
    try:
        for n, item in enumerate(items):
            tell(n, total, what)
            yield item
    finally:
        tell(1, 1, what)
