"""Deadlines for attempts at a proof."""

from __future__ import annotations

from dataclasses import dataclass
from time import thread_time

from hfield.fields.base.ring import INFINITY


@dataclass(frozen=True)
class Clock:
    """A clock that runs out at ``end``, in seconds of :func:`time.thread_time`.

    The clock counts the CPU time of the thread, so that on a busy machine an answer comes later but is the
    same.

    >>> Clock.of(-1).is_late
    True
    """

    end: float = INFINITY

    @classmethod
    def of(cls, seconds: float) -> Clock:
        """Return a clock that runs out in so many seconds."""
        return cls(thread_time() + seconds)

    @property
    def seconds_left(self) -> float:
        """The number of seconds left; negative afterwards."""
        return self.end - thread_time()

    @property
    def is_late(self) -> bool:
        """Whether it has run out."""
        return thread_time() > self.end

    def within(self, seconds: float) -> Clock:
        """Return a clock that ends after so many seconds, but not later than this one."""
        return Clock(min(self.end, thread_time() + seconds))

    def share(self, part: float, least: float = 0.0) -> Clock:
        """Return a clock with a fraction of the remaining time, or with ``least`` seconds."""
        return Clock(thread_time() + max(part * self.seconds_left, least))


UNTIMED = Clock()
