"""Until when something may be tried."""

from __future__ import annotations

from dataclasses import dataclass
from time import monotonic

from hfield.rings.base import INFINITY


@dataclass(frozen=True)
class Clock:
    """A clock that runs out at ``end``, in seconds of :func:`time.monotonic`.

    >>> Clock.of(-1).is_late
    True
    """

    end: float = INFINITY

    @classmethod
    def of(cls, seconds: float) -> Clock:
        """Return a clock that runs out after so many seconds from now."""
        return cls(monotonic() + seconds)

    @property
    def seconds_left(self) -> float:
        """How long until then; negative afterwards."""
        return self.end - monotonic()

    @property
    def is_late(self) -> bool:
        """Whether it has run out."""
        return monotonic() > self.end

    def within(self, seconds: float) -> Clock:
        """Return a clock that runs out after so many seconds, or with this one."""
        return Clock(min(self.end, monotonic() + seconds))

    def share(self, part: float, least: float = 0.0) -> Clock:
        """Return a clock with a part of the time that is left, or with ``least`` seconds."""
        return Clock(monotonic() + max(part * self.seconds_left, least))


UNTIMED = Clock()
