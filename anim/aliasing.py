"""Find frames of a film of a fast spin in which the bands seem to stand still, or to turn backwards.

A film shows the top at discrete instants. If the colours repeat after a period, turns that differ by a whole
number of periods look the same, and the eye sees the smallest of them.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from anim.checks import whole
from anim.model import MAX_POINTS
from anim.motion import Motion

Floats = NDArray[np.float64]

# Bands that seem to move by less than this fraction of their period per frame are reported as
# standing still.
STANDING = 0.02


@dataclass(frozen=True, eq=False)
class ApparentSpin:
    """The true and the apparent spin between frames: arrays (frames − 1,), in radians."""

    true: Floats
    """How far the top turns about its own axis."""
    seen: Floats
    """The turn that looks the same and is at most half a period."""
    period: float
    """After how much the colours repeat."""

    @property
    def standing(self) -> NDArray[np.bool_]:
        """Frames in which the top turns by about a whole period, so that the bands seem to stand still."""
        still = np.abs(self.seen) < STANDING * self.period
        return still & (np.abs(self.true) > self.period / 2)

    @property
    def backwards(self) -> NDArray[np.bool_]:
        """Where the bands seem to turn against the spin."""
        return (self.seen * self.true < 0) & ~self.standing

    @property
    def misleading(self) -> bool:
        """Whether the film shows a spin other than the true one."""
        return bool(np.any(self.standing | self.backwards))

    def message(self) -> str:
        """Return a sentence about the apparent spin; empty if the bands turn like the top."""
        if not self.misleading:
            return ""
        parts = [
            f"{words} in {np.mean(where):.0%} of the frames, from frame {int(np.argmax(where))} on"
            for words, where in (("run backwards", self.backwards), ("stand", self.standing))
            if np.any(where)
        ]
        fastest = np.degrees(np.abs(self.true).max())
        return (
            f"the bands seem to {' and to '.join(parts)}: their colours repeat every "
            f"{np.degrees(self.period):.4g}° and the top spins up to {fastest:.4g}° a frame; "
            "fewer bands, more frames a second, slow motion or motion blur show it truer"
        )


def apparent_spin(motion: Motion, bands: int) -> ApparentSpin:
    """Return the spin that a film seems to show, for a top with ``bands`` bands in two alternating colours.

    For an even number of bands the pattern repeats after two bands, for an odd number only after a full turn.
    Raises :class:`~anim.errors.AnimationError` unless ``bands`` is at least 1.

    >>> from anim import kinematic, Timeline
    >>> seen = apparent_spin(kinematic(reading=Timeline(spin="accumulated")), 10)
    >>> float(seen.true[0].round(3)), float(seen.seen[0].round(3)), float(round(seen.period, 3))
    (1.006, -0.25, 1.257)
    """
    number = whole("bands", bands, 1, MAX_POINTS)
    period = 2 * np.pi / (number / 2 if number % 2 == 0 else 1)
    times, step = motion.times, motion.clip.interval
    at_frames = motion.spin_rates(times)
    at_middles = motion.spin_rates(times[:-1] + step / 2)
    true = (at_frames[:-1] + 4 * at_middles + at_frames[1:]) / 6 * step  # Simpson's rule
    return ApparentSpin(true, true - period * np.round(true / period), float(period))
