"""A motion: one attitude per frame, and interpolated attitudes between frames."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from anim import attitude
from anim.checks import whole
from anim.errors import AnimationError
from anim.film import Clip
from anim.model import APEX_HEIGHT
from rotation.matrices import from_matrix, to_matrix
from rotation.quaternions import inverse, normalised, product

Floats = NDArray[np.float64]

Sampler = Callable[[Floats], Floats]
"""From instants (n,) in seconds of the motion to unit quaternions (n, 4),
or matrices (n, 3, 3), or points (n, 3)."""

# The angular velocity is determined from two instants this far apart, in seconds: up to 10⁵ rad/s a
# top turns less than half a turn between them.
APART = 2e-5


@dataclass(frozen=True, eq=False)
class Record:
    """Physical quantities of each frame; arrays (frames,), read-only."""

    energies: Floats
    """Kinetic and potential energy in J, the potential 0 at the height of the tip."""
    momenta: Floats
    """The angular momentum about the vertical through the tip, L_z, in kg·m²/s."""
    spins: Floats
    """The angular velocity about the top's own axis, ω₃, in rad/s."""
    landed: float | None
    """When the rim touched the ground, in seconds of the motion; None if it did not."""

    def __post_init__(self) -> None:
        for values in (self.energies, self.momenta, self.spins):
            values.flags.writeable = False


@dataclass(frozen=True, eq=False)
class Motion:
    """The attitude and place of the top in each frame of a film. Immutable; made by :meth:`sample` or
    :meth:`through`.

    Attitudes map the model's coordinates to space; the ground is z = 0.

    >>> from anim import kinematic
    >>> kinematic("product").attitudes.shape
    (500, 4)
    """

    name: str
    clip: Clip
    attitudes: Floats
    """Unit quaternions (frames, 4), scalar first, signs chosen so that neighbours are close. Read-only."""
    matrices: Floats
    """Rotation matrices (frames, 3, 3), as computed by the motion's own method. Read-only."""
    sampler: Sampler
    record: Record | None = None
    places: Sampler | None = None
    """Where the tip is (n, 3) at instants (n,), in the model's unit; None: it stays at the origin."""

    @classmethod
    def sample(
        cls,
        name: str,
        clip: Clip,
        sampler: Sampler,
        record: Record | None = None,
        places: Sampler | None = None,
    ) -> "Motion":
        """Return the motion with attitudes from ``sampler`` and places from ``places``."""
        quaternions, matrices = _both(sampler(clip.times))
        for values in (quaternions, matrices):
            values.flags.writeable = False
        return cls(name, clip, quaternions, matrices, sampler, record, places)

    @classmethod
    def through(cls, name: str, clip: Clip, attitudes: ArrayLike) -> "Motion":
        """Return the motion through given attitudes (frames, 4), by the shortest rotations between them.

        Raises :class:`~anim.errors.AnimationError` unless there is one nonzero quaternion per frame.
        """
        q = np.array(attitudes, dtype=np.float64)
        if q.shape != (clip.frames, 4):
            raise AnimationError(f"attitudes of shape {q.shape}; expected ({clip.frames}, 4)")
        if not (np.isfinite(q).all() and np.all(np.any(q != 0, axis=-1))):
            raise AnimationError("attitudes hold a quaternion that is 0 or not finite")
        return cls.sample(name, clip, Shortest(normalised(q), clip.times))

    @property
    def frames(self) -> int:
        """The number of frames."""
        return self.clip.frames

    @property
    def fps(self) -> float:
        """The number of frames per second of the film."""
        return self.clip.fps

    @property
    def duration(self) -> float:
        """The length of the film in seconds."""
        return self.clip.duration

    @property
    def times(self) -> Floats:
        """The instants of the frames in seconds of the motion, (frames,)."""
        return self.clip.times

    @property
    def tilts(self) -> Floats:
        """The angles between the top's axis and the vertical, (frames,), in radians."""
        return attitude.tilts(self.matrices[:, :, 2])

    def tips(self, times: ArrayLike) -> Floats:
        """Return the positions (n, 3) of the tip at instants (n,) in seconds, constant beyond the ends."""
        instants = np.clip(np.asarray(times, dtype=np.float64), 0.0, self.clip.seconds)
        if self.places is None:
            return np.zeros((len(instants), 3))
        return self.places(instants)

    def apex(self, height: float = APEX_HEIGHT) -> Floats:
        """Return the path (frames, 3) of the point at ``height`` on the top's axis, by default the apex."""
        return np.asarray(self.tips(self.times) + height * self.matrices[:, :, 2])

    def at(self, times: ArrayLike) -> Floats:
        """Return unit quaternions (n, 4) at instants (n,) in seconds, constant beyond the ends."""
        instants = np.clip(np.asarray(times, dtype=np.float64), 0.0, self.clip.seconds)
        return _both(self.sampler(instants))[0]

    def between(self, frame: int, fractions: ArrayLike) -> Floats:
        """Return attitudes (n, 4) near ``frame``, at ``fractions`` (n,) of the interval between frames.

        Fraction 0 is the frame itself, 1 the next frame, −1 the previous frame; motion blur uses several
        fractions in (−½, ½). Raises :class:`~anim.errors.AnimationError` for a frame that is not in the film.
        """
        number = whole("frame", frame, 0, self.frames - 1)
        return self.at(self.times[number] + np.asarray(fractions) * self.clip.interval)

    def spin_rates(self, times: ArrayLike) -> Floats:
        """Return the angular velocity about the top's own axis (n,) at instants (n,), in rad/s."""
        middle = np.asarray(times, dtype=np.float64)
        before = np.clip(middle - APART / 2, 0.0, self.clip.seconds)
        after = np.clip(middle + APART / 2, 0.0, self.clip.seconds)
        turned = np.asarray(product(inverse(self.at(before)), self.at(after)))
        return attitude.twist(turned) / (after - before)


@dataclass(frozen=True, eq=False)
class Shortest:
    """Interpolates along the shortest rotation from each attitude (frames, 4) to the next."""

    attitudes: Floats
    times: Floats
    """The time of each attitude in seconds, (frames,), increasing."""

    def __call__(self, times: Floats) -> Floats:
        """Return the quaternions (n, 4) at ``times`` (n,)."""
        if len(self.times) == 1:
            return np.repeat(self.attitudes, len(times), axis=0)
        last = len(self.times) - 2
        here = np.clip(np.searchsorted(self.times, times, "right") - 1, 0, last)
        share = (times - self.times[here]) / (self.times[here + 1] - self.times[here])
        return attitude.between(self.attitudes[here], self.attitudes[here + 1], share)


def _both(values: Floats) -> tuple[Floats, Floats]:
    """Return quaternions and matrices of attitudes given in either form."""
    if values.ndim == 3:
        return attitude.continuous(np.asarray(from_matrix(values))), values
    return attitude.continuous(values), np.asarray(to_matrix(values))
