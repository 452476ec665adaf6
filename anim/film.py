"""The seconds, frames and frames per second of a film of a motion.

Two of the four numbers determine the others: frames = fps · (seconds of the motion) / (time scale).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from anim.checks import real, whole
from anim.errors import AnimationError

SECONDS = 10.0
FPS = 50.0
MAX_FRAMES = 1_000_000
MAX_FPS = 10_000.0


@dataclass(frozen=True)
class Clip:
    """A film of ``frames`` pictures at ``fps`` frames per second, showing ``seconds`` of a motion.

    >>> Clip().duration, Clip(frames=100).interval > 0.1
    (10.0, True)
    """

    frames: int = 500
    fps: float = FPS
    seconds: float = SECONDS

    @property
    def duration(self) -> float:
        """The length of the film in seconds."""
        return self.frames / self.fps

    @property
    def time_scale(self) -> float:
        """Seconds of the motion in one second of the film; below 1 is slow motion."""
        return self.seconds / self.duration

    @property
    def times(self) -> NDArray[np.float64]:
        """The instants of the frames in seconds of the motion, (frames,), from 0 to ``seconds``.

        Both ends are included, as in the thesis's ``linspace``, for any number of frames.
        """
        return np.linspace(0.0, self.seconds, self.frames)

    @property
    def interval(self) -> float:
        """The seconds of the motion between consecutive frames; 0 for a single frame."""
        return self.seconds / (self.frames - 1) if self.frames > 1 else 0.0


def clip(
    frames: int | None = None,
    fps: float | None = None,
    duration: float | None = None,
    time_scale: float | None = None,
) -> Clip:
    """Return the film described by the given numbers; by default 500 frames at 50 per second (section 3.4.1).

    ``frames`` alone samples the same ten seconds of motion more or less finely, still at 50 frames per
    second; ``fps`` alone keeps the ten seconds and changes the number of frames. ``duration`` is the length
    of the film in seconds; the motion shown is ``time_scale`` times as long, so ``time_scale`` 0.5 shows it
    at half speed. Raises :class:`~anim.errors.AnimationError` for frames outside 1 … 1 000 000, for values
    that are not positive, and for inconsistent frames, fps and duration.

    >>> clip(frames=100).time_scale, clip(time_scale=0.5).frames, clip(duration=4).seconds
    (5.0, 1000, 4.0)
    """
    count = None if frames is None else whole("frames", frames, 1, MAX_FRAMES)
    rate = None if fps is None else real("fps", fps, above=0)
    length = None if duration is None else real("duration", duration, above=0)
    scale = None if time_scale is None else real("time_scale", time_scale, above=0)
    if count is not None and rate is not None and length is not None:
        if abs(length * rate - count) > 0.5:
            raise AnimationError(
                f"{count} frames at {rate:g} a second do not last {length:g} seconds; give only two of "
                "frames, fps and duration"
            )
    elif length is None and scale is not None and (count is None or rate is None):
        length = SECONDS / scale
    if count is not None and length is not None:
        rate = count / length
    rate = FPS if rate is None else rate
    if rate > MAX_FPS:
        raise AnimationError(f"fps is {rate:g}; expected at most {MAX_FPS:g}")
    if count is None:
        wanted = (SECONDS if length is None else length) * rate
        if not 0.5 < wanted < MAX_FRAMES + 0.5:
            raise AnimationError(
                f"these numbers make {wanted:g} frames; expected 1 to {MAX_FRAMES}: "
                "change duration, fps or time_scale"
            )
        count = round(wanted)
    return Clip(count, rate, _seconds(count / rate, length is not None, scale))


def _seconds(film: float, measured: bool, scale: float | None) -> float:
    """Return the length of the motion: ten seconds, unless the film's length or rate is given."""
    if scale is not None:
        return film * scale
    return film if measured else SECONDS
