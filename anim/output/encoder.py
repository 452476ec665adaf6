"""ffmpeg at the end of a pipe: raw frames go in, a file comes out; nothing is kept in memory.

The program is the one in imageio-ffmpeg's wheel, or what IMAGEIO_FFMPEG_EXE names.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from fractions import Fraction
from pathlib import Path
from shutil import which
from tempfile import TemporaryFile
from typing import IO, TYPE_CHECKING

import numpy as np

from anim.errors import AnimationError

if TYPE_CHECKING:
    from anim.output.formats import Film, Frame, Samples, Write

PIPE_BYTES = 1 << 20
SECONDS_TO_END = 600  # for what ffmpeg still has to do after the last frame
# Tagged and converted as BT.709, so that players show the colours that were drawn.
BT709 = ("-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709")
# Averaging chroma over each block of four keeps the most of what 4:2:0 can hold of sharp bands.
TO_BT709 = "scale=out_color_matrix=bt709:out_range=tv:flags=area+accurate_rnd+full_chroma_inp+full_chroma_int"

# The bands' edges are of strong colours, and lose more by coarse chroma than by anything else. In small
# pictures four pixels are too large for one chroma: they keep all of it (4:4:4).
FINER_CHROMA = -6
LARGE = 640 * 480


def ffmpeg() -> str:
    """Return the path of the program. Raises :class:`AnimationError` where there is none."""
    with suppress(ImportError, RuntimeError):
        from imageio_ffmpeg import get_ffmpeg_exe

        program = which(str(get_ffmpeg_exe()))
        if program is not None:
            return program
    raise AnimationError(
        "films are encoded by ffmpeg, which is missing: run `pip install imageio-ffmpeg`, "
        "or set IMAGEIO_FFMPEG_EXE to the program"
    )


@contextmanager
def open_encoder(path: Path, film: Film, samples: Samples | None) -> Iterator[Write]:
    """Yield a function that sends a frame to ffmpeg, which writes ``path`` in the format of its suffix."""
    width, height = film.size
    rate = Fraction(film.fps).limit_denominator(100_000)
    command = [ffmpeg(), "-y", "-nostdin", "-loglevel", "error", "-progress", "pipe:2"]
    command += ["-stats_period", "30", "-f", "rawvideo", "-pix_fmt", "rgb24"]
    command += ["-s", f"{width}x{height}", "-r", str(rate), "-i", "pipe:0"]
    palette = path.with_suffix(".palette.png")
    with TemporaryFile() as said:
        try:
            if path.suffix.lower() == ".gif":
                from anim.output.palette import write_palette

                write_palette(palette, samples() if samples else ())
                command += ["-f", "image2", "-pattern_type", "none", "-i", str(palette)]
            command += [*_format(path.suffix.lower(), film), str(path)]
            process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=said
            )
            with _ended(process):
                _widen(process)
                yield from _feed(process, film, said, path.suffix.lower() == ".webp")
        finally:
            palette.unlink(missing_ok=True)


def _format(suffix: str, film: Film) -> list[str]:
    """Return ffmpeg's options for a suffix; the format by name too, whatever else the file's name says."""
    if suffix == ".mp4":
        coded = ["-c:v", "libx264", "-crf", str(film.crf), "-preset", film.preset]
        coded += ["-x264-params", f"chroma-qp-offset={FINER_CHROMA}", "-vf", TO_BT709, *BT709]
        chroma = "yuv420p" if film.size[0] * film.size[1] >= LARGE else "yuv444p"
        return [*coded, "-pix_fmt", chroma, "-movflags", "+faststart", "-f", "mp4"]
    if suffix == ".gif":
        dithered = "[0][1]paletteuse=dither=bayer:bayer_scale=5:diff_mode=rectangle"
        return ["-lavfi", dithered, "-f", "gif"]
    if suffix == ".apng":
        return ["-f", "apng", "-pred", "mixed", "-plays", "0"]
    return ["-c:v", "libwebp_anim", "-quality", "85", "-loop", "0", "-f", "webp"]


def _feed(
    process: subprocess.Popen[bytes], film: Film, said: IO[bytes], whole: bool
) -> Iterator[Write]:
    """Yield the function that sends frames; then wait for the end, and see that all frames arrived.

    ``whole`` says that the encoder counts its one packet, and not the frames.
    """
    stream = process.stdin
    assert stream is not None
    sent = 0

    def write(frame: Frame) -> None:
        nonlocal sent
        try:
            stream.write(np.ascontiguousarray(frame).data)
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
    arrived = sent if whole else int(counts[-1]) if counts else 0
    if arrived != sent or sent != film.frames:
        raise AnimationError(
            f"the encoder took {arrived} of {film.frames} frames ({sent} were drawn): "
            "the film is not whole, and was thrown away"
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
    """See that the process has ended when the block has, however that ended."""
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
    """Let the pipe hold a frame or so, which spares changes between the two processes."""
    import fcntl

    with suppress(OSError, AttributeError):
        assert process.stdin is not None
        fcntl.fcntl(process.stdin, fcntl.F_SETPIPE_SZ, PIPE_BYTES)
