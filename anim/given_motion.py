"""Make motions from arrays of quaternions, rotations, functions of time, and files."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from anim.errors import AnimationError
from anim.film import FPS, Clip, clip
from anim.motion import Motion, Shortest
from anim.pipelines import PIPELINES, kinematic
from hfield.tables import read_table
from rotation import Rotation
from rotation.hints import is_scipys
from rotation.quaternions import normalised

Floats = NDArray[np.float64]

COLUMNS = {4: "w, x, y, z of a quaternion", 5: "seconds, then w, x, y, z"}


MotionSource: TypeAlias = (
    Motion | Rotation | ArrayLike | Path | Callable[[float], "Rotation | ArrayLike"]
)
"""What describes a motion: see :func:`motion_of`; scipy's rotations are read too."""


def motion_of(source: MotionSource, film: Clip | None = None) -> Motion:
    """Return the motion that ``source`` describes.

    ``source`` is

    - an array (n, 4) of quaternions, scalar first, or a :class:`~rotation.Rotation` of n rotations: one
      attitude a frame, 50 frames a second, two frames or more;
    - a function of the time in seconds that returns a quaternion (4,), a rotation matrix (3, 3) or a
      :class:`~rotation.Rotation`: ten seconds of it;
    - the path of a text file, as :func:`read_motion` takes it;
    - the name of one of the thesis's pipelines, or a :class:`~anim.motion.Motion`, returned as it is.

    Quaternions need not have norm 1. ``film`` sets another number of frames and another rate; attitudes
    between the given ones are interpolated along the shortest rotation. Raises
    :class:`~anim.errors.AnimationError`.

    >>> from math import cos, sin
    >>> motion_of(lambda t: (cos(t), 0, 0, sin(t))).frames
    500
    >>> motion_of([[1, 0, 0, 0], [1, 0, 0, 1], [0, 0, 0, 1]]).duration
    0.06
    """
    if isinstance(source, Motion):
        if film is not None and film != source.clip:
            raise AnimationError("a Motion has its own frames; expected no clip with it")
        return source
    if isinstance(source, str) and source in PIPELINES:
        return kinematic(source, film)
    if isinstance(source, Path) or (isinstance(source, str) and _is_file_name(source)):
        return read_motion(source).motion(film)
    if isinstance(source, str):
        raise AnimationError(
            f"motion is {source!r}; expected one of {', '.join(PIPELINES)}, or the name of a file"
        )
    if callable(source) and not isinstance(source, Rotation):
        return Motion.sample("function", film or Clip(), Function(source))
    return Recorded("quaternions given", _quaternions(source)).motion(film)


@dataclass(frozen=True, eq=False)
class Recorded:
    """Attitudes (n, 4) at ``times`` (n,) in seconds; without times they are equally spaced."""

    name: str
    attitudes: Floats
    times: Floats | None = None

    def seconds(self, fps: float = FPS) -> float:
        """Return the duration in seconds; without times each attitude is one frame at the rate ``fps``."""
        return len(self.attitudes) / fps if self.times is None else float(self.times[-1])

    def motion(self, film: Clip | None = None) -> Motion:
        """Return the motion; by default each attitude is a frame, or with times there are 50 frames per
        second.

        Raises :class:`~anim.errors.AnimationError` for a film that is longer than the motion.
        """
        if film is None:
            film = clip(duration=self.seconds(), time_scale=1.0)
        times = self.times
        if times is None:
            times = np.linspace(0.0, self.seconds(film.fps), len(self.attitudes))
        if film.seconds > times[-1] * (1 + 1e-9):
            raise AnimationError(
                f"the motion lasts {times[-1]:g} s, and a film of {film.seconds:g} s of it is wanted; "
                "choose a shorter one"
            )
        return Motion.sample(self.name, film, Shortest(self.attitudes, times))


def read_motion(path: str | Path) -> Recorded:
    """Read attitudes from a text file: w, x, y, z on each line, optionally preceded by the seconds.

    Without seconds each line is a frame. Raises :class:`~hfield.errors.TableError` for a file that is not a
    table of numbers, and :class:`~anim.errors.AnimationError` for numbers that are not a motion. Both name
    the file and the line.
    """
    table = read_table(path, COLUMNS)
    q, times = table.rows[:, -4:], None
    zero = np.flatnonzero(~q.any(axis=1))
    if len(zero):
        raise AnimationError(
            f"{table.place(int(zero[0]))}: the quaternion is 0, which is not a rotation; expected another"
        )
    if len(q) < 2:
        raise AnimationError(f"{table.place(0)} is the only attitude; expected two or more")
    if table.rows.shape[1] == 5:
        times = table.rows[:, 0] - table.rows[0, 0]
        late = np.flatnonzero(np.diff(times) <= 0)
        if len(late):
            raise AnimationError(
                f"{table.place(int(late[0]) + 1)}: the time is not after that of the line before; "
                "expected increasing times"
            )
    return Recorded(Path(path).name, np.asarray(normalised(q)), times)


@dataclass(frozen=True, eq=False)
class Function:
    """A sampler that calls a function of one instant."""

    function: Callable[[float], object]

    def __call__(self, times: Floats) -> Floats:
        """Return the quaternions (n, 4), or matrices (n, 3, 3), at ``times`` (n,)."""
        found = [self._at(float(time)) for time in times]
        if not found:
            return np.empty((0, 4))
        if any(value.shape != found[0].shape for value in found):
            raise AnimationError(
                "the motion's function returns both quaternions and matrices; expected only one of the two"
            )
        return np.stack(found)

    def _at(self, time: float) -> Floats:
        value = self.function(time)
        if isinstance(value, Rotation) or is_scipys(value, "Rotation"):
            value = _of_rotation(value)
        where = f"the motion's function at t = {time:g}"
        try:
            array = np.asarray(value, dtype=np.float64)
        except (TypeError, ValueError):
            raise AnimationError(
                f"{where} returns a {type(value).__name__}; expected a quaternion (4,), a rotation matrix "
                "(3, 3) or a Rotation"
            ) from None
        if array.shape not in ((4,), (3, 3)):
            raise AnimationError(
                f"{where} returns the shape {array.shape}; expected a quaternion (4,), a rotation matrix "
                "(3, 3) or a Rotation of one rotation"
            )
        if not np.isfinite(array).all():
            raise AnimationError(f"{where} returns {array.tolist()}, which is not finite")
        if array.shape == (3, 3):
            if not (abs(array @ array.T - np.eye(3)).max() < 1e-6 and np.linalg.det(array) > 0):
                raise AnimationError(f"{where} returns a matrix that is not a rotation")
            return array
        if not array.any():
            raise AnimationError(f"{where} returns the quaternion 0, which is not a rotation")
        return np.asarray(normalised(array))


def _quaternions(source: object) -> Floats:
    """Return unit quaternions (n, 4) of an array or of rotations."""
    if isinstance(source, Rotation) or is_scipys(source, "Rotation"):
        source = _of_rotation(source)
    try:
        q = np.array(source, dtype=np.float64)
    except (TypeError, ValueError):
        raise AnimationError(
            f"the motion is a {type(source).__name__}; expected quaternions (n, 4), a Rotation, a function "
            f"of time, the name of a file or one of {', '.join(PIPELINES)}"
        ) from None
    if q.ndim != 2 or q.shape[1] != 4:
        raise AnimationError(
            f"the motion has the shape {q.shape}; expected (n, 4): one quaternion a frame, scalar first"
        )
    if len(q) < 2:
        raise AnimationError(
            f"the motion has {len(q)} attitude{'s' * (len(q) != 1)}; expected two or more"
        )
    wrong = np.flatnonzero(~np.isfinite(q).all(axis=1))
    if len(wrong):
        raise AnimationError(f"quaternion {wrong[0]} of the motion is not finite")
    zero = np.flatnonzero(~q.any(axis=1))
    if len(zero):
        raise AnimationError(f"quaternion {zero[0]} of the motion is 0, which is not a rotation")
    return np.asarray(normalised(q))


def _of_rotation(value: object) -> Floats:
    """Return the quaternions of a Rotation of this package or of scipy."""
    ours = value if isinstance(value, Rotation) else Rotation.from_scipy(value)
    return np.asarray(ours.as_quat(), dtype=np.float64)


def _is_file_name(text: str) -> bool:
    return bool(Path(text).suffix) or Path(text).is_file()
