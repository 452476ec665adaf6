"""Show the progress of a command on a line of stderr, on terminals only."""

from __future__ import annotations

import sys
import time
from threading import Event, RLock, Thread
from types import TracebackType
from typing import TextIO

from hfield.core.progress import current

WIDTH = 79
PATIENCE = 0.5  # seconds after which a command reports its progress
_ERASE = "\r\x1b[K"


class StatusLine:
    """A single status line that is overwritten, and erased before any other output."""

    def __init__(self) -> None:
        self._lock = RLock()
        self._stream: TextIO | None = None

    def show(self, text: str) -> None:
        """Show a text in place of the last one, if stderr is a terminal."""
        stream = sys.stderr
        if stream is None or not stream.isatty():
            return
        text = text.replace("\n", " ")
        text = text if len(text) <= WIDTH else f"{text[: WIDTH - 1]}…"
        plain = text.encode(stream.encoding or "ascii", "replace").decode(
            stream.encoding or "ascii"
        )
        with self._lock:
            stream.write(_ERASE + plain)
            stream.flush()
            self._stream = stream

    def erase(self) -> None:
        """Erase the line, if there is one."""
        with self._lock:
            if self._stream is not None:
                self._stream.write(_ERASE)
                self._stream.flush()
                self._stream = None


STATUS = StatusLine()


def _how_far() -> str:
    """Describe the running loop: its name, the fraction done and the time left."""
    if (now := current()) is None:
        return ""
    what, share, seconds = now
    left = f", some {time_left(seconds / share * (1 - share))}" if share else ""
    return f" ({int(100 * share)} % of {what}{left})"


def time_left(seconds: float) -> str:
    """Return the remaining time in words.

    >>> time_left(41.7), time_left(301)
    ('42 s left', '5 min left')
    """
    return f"{seconds:.0f} s left" if seconds < 100 else f"{seconds / 60:.0f} min left"


class Progress:
    """A status line on stderr with the progress; nothing is shown if stderr is not a terminal.

    Steps ``done`` before the start do not count in the estimate of the remaining time.
    """

    def __init__(self, noun: str, done: int = 0) -> None:
        self.noun = noun
        self._done = done
        self._since = time.monotonic()

    def __call__(self, done: int, total: int, what: str = "") -> None:
        """Show ``done`` of ``total``, the time left, and ``what`` is running."""
        bar = "#" * (20 * done // max(total, 1))
        said = [f"[{bar:<20}] {done} of {total} {self.noun}"]
        passed = time.monotonic() - self._since
        if self._done < done < total and passed > PATIENCE:
            said.append(time_left(passed / (done - self._done) * (total - done)))
        STATUS.show(", ".join([*said, what] if what else said))

    def __enter__(self) -> Progress:
        Waiting.hush()
        return self

    def __exit__(self, *_: object) -> None:
        STATUS.erase()


class Waiting:
    """A status line that appears after half a second, with the current step and the elapsed seconds.

    ``Waiting.at("theorem 3")`` changes the text of the open status line; a :class:`Progress` silences it.
    """

    _open: Waiting | None = None

    def __init__(self, what: str) -> None:
        self._what = what
        self._over = Event()
        self._thread: Thread | None = None

    @classmethod
    def at(cls, what: str) -> None:
        """Show the current step on the open status line, if there is one."""
        if cls._open is not None:
            cls._open._what = what

    @classmethod
    def hush(cls) -> None:
        """Silence the open status line."""
        if cls._open is not None:
            cls._open._over.set()

    def __enter__(self) -> Waiting:
        if sys.stderr is not None and sys.stderr.isatty():
            Waiting._open = self
            self._thread = Thread(target=self._tell, daemon=True)
            self._thread.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        Waiting._open = None
        self._over.set()
        if self._thread is not None:
            self._thread.join()
        STATUS.erase()

    def _tell(self) -> None:
        seconds, pause = 0, PATIENCE
        while not self._over.wait(pause):
            STATUS.show(f"{self._what} …" + (f" {seconds} s" if seconds else "") + _how_far())
            seconds, pause = seconds + 1, 1.0 if seconds else 1.0 - PATIENCE
