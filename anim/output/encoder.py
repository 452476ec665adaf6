"""Encode raw frames with ffmpeg through a pipe, without keeping them in memory.

The program is the one in imageio-ffmpeg's wheel, or the one named by IMAGEIO_FFMPEG_EXE.
"""

from __future__ import annotations

import re
import subprocess
from abc import abstractmethod
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from fractions import Fraction
from pathlib import Path
from shutil import which
from tempfile import TemporaryFile
from typing import IO

import numpy as np

from anim.errors import AnimationError
from anim.output.format import Film, Format, Pixels, Samples, Write

PIPE_BYTES = 1 << 20
SECONDS_TO_END = 600  # for ffmpeg's remaining work after the last frame
SLOWEST_FPS = 0.01  # a gif shows a picture for eleven minutes at most


def ffmpeg() -> str:
    """Return the path of the program. Raises :class:`AnimationError` if there is none."""
    with suppress(ImportError, RuntimeError):
        from imageio_ffmpeg import get_ffmpeg_exe

        program = which(str(get_ffmpeg_exe()))
        if program is not None:
            return program
    raise AnimationError(
        "films are encoded by ffmpeg, which is missing: run `pip install imageio-ffmpeg`, "
        "or set IMAGEIO_FFMPEG_EXE to the program"
    )


class Encoded(Format):
    """A format that ffmpeg writes."""

    counts_frames = True
    """Whether the encoder tells how many frames it took; else it counts the whole film as one packet."""

    def check(self, film: Film) -> None:
        """Raise :class:`AnimationError` for a film that is too slow, or if ffmpeg is missing."""
        if film.fps < SLOWEST_FPS:
            raise AnimationError(
                f"{film.fps:g} frames a second are too few for .{self.name}; expected {SLOWEST_FPS:g} or more"
            )
        ffmpeg()

    def raw(self, film: Film) -> tuple[Sequence[str], Callable[[Pixels], memoryview]]:
        """Return ffmpeg's name of the raw pixel format, and the function that converts a frame to it."""
        return ("-pix_fmt", "rgb24"), lambda frame: np.ascontiguousarray(frame).data

    @abstractmethod
    def options(self, film: Film) -> list[str]:
        """Return ffmpeg's options, with the format by name, so that the file's name does not matter."""

    @contextmanager
    def open(self, path: Path, film: Film, samples: Samples | None) -> Iterator[Write]:
        """Yield a function that sends a frame to ffmpeg."""
        with self.encoder(path, film, ()) as write:
            yield write

    @contextmanager
    def encoder(self, path: Path, film: Film, more_input: Sequence[str]) -> Iterator[Write]:
        """Run ffmpeg on the frames and on further inputs, the options ``more_input``."""
        width, height = film.size
        pixels, made = self.raw(film)
        rate = Fraction(film.fps).limit_denominator(100_000)
        command = [ffmpeg(), "-y", "-nostdin", "-loglevel", "error", "-progress", "pipe:2"]
        command += ["-stats_period", "30", "-f", "rawvideo", *pixels]
        command += ["-s", f"{width}x{height}", "-r", str(rate), "-i", "pipe:0"]
        command += [*more_input, *self.options(film), str(path)]
        with TemporaryFile() as said:
            process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=said
            )
            with _ended(process):
                _widen(process)
                yield from _feed(process, film, made, said, self.counts_frames)


def _feed(
    process: subprocess.Popen[bytes],
    film: Film,
    made: Callable[[Pixels], memoryview],
    said: IO[bytes],
    counts_frames: bool,
) -> Iterator[Write]:
    """Yield the function that sends frames; then wait for the end, and check that all frames arrived.

    If the encoder does not count frames, it counts one packet.
    """
    stream = process.stdin
    assert stream is not None
    sent = 0

    def write(frame: Pixels) -> None:
        nonlocal sent
        try:
            stream.write(made(frame))
        except OSError:
            process.wait(SECONDS_TO_END)
            raise _failed(said) from None
        sent += 1

    yield write
    try:
        stream.close()
    except OSError:
        raise _failed(said) from None
    if process.wait(SECONDS_TO_END):
        raise _failed(said)
    said.seek(0)
    counts = re.findall(rb"^frame=\s*(\d+)", said.read(), re.MULTILINE)
    arrived = sent if not counts_frames else int(counts[-1]) if counts else 0
    if arrived != sent or sent != film.frames:
        raise AnimationError(
            f"the encoder took {arrived} of {film.frames} frames ({sent} were drawn): the film is "
            "incomplete, and was deleted"
        )


def _failed(said: IO[bytes]) -> AnimationError:
    said.seek(0)
    lines = [line.strip() for line in said.read().decode(errors="replace").splitlines()]
    reasons = [line for line in lines if line and not re.fullmatch(r"\w+=.*", line)]
    reason = next((r for r in reasons if "No space" in r or "too large" in r), None)
    reason = reason or (
        reasons[-1] if reasons else "ffmpeg ended without saying why; is the disk full?"
    )
    return AnimationError(f"the film could not be written: {reason}")


@contextmanager
def _ended(process: subprocess.Popen[bytes]) -> Iterator[None]:
    """End the process when the block ends, also on an error."""
    try:
        yield
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
        if process.stdin:
            with suppress(OSError):
                process.stdin.close()


def _widen(process: subprocess.Popen[bytes]) -> None:
    """Enlarge the pipe to about one frame, which saves switches between the two processes."""
    import fcntl

    with suppress(OSError, AttributeError):
        assert process.stdin is not None
        fcntl.fcntl(process.stdin, fcntl.F_SETPIPE_SZ, PIPE_BYTES)
