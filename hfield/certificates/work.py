"""A bound on the work for one file: whatever may take long is charged for before it is begun.

One unit is about a microsecond at worst.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from hfield.certificates.rejection import reject

MAX_WORK = 10_000_000


class Work:
    """How many units are left."""

    def __init__(self, most: int = MAX_WORK) -> None:
        self.left = most


_current: ContextVar[Work] = ContextVar("work")


@contextmanager
def bounded() -> Iterator[None]:
    """Bound the work inside."""
    token = _current.set(Work())
    try:
        yield
    finally:
        _current.reset(token)


def charge(units: int) -> None:
    """Charge for work; reject the file when nothing is left."""
    work = _current.get(None)
    if work is not None:
        work.left -= units
        if work.left < 0:
            reject("checking this would take more work than the checker does for one file")
