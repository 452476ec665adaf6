"""The initial state of a top, and the length of its motion."""

from abc import abstractmethod
from dataclasses import dataclass, replace
from math import ceil, cos, inf, sin

import numpy as np
from numpy.typing import NDArray

from anim.checks import real
from anim.errors import AnimationError
from rotation.quaternions import product

Floats = NDArray[np.float64]

MAX_STEPS = 20_000_000
EVERY = 32  # steps between stored states


class Stepped:
    """A motion of ``seconds`` integrated in equal steps, none longer than ``longest_step``."""

    seconds: float

    @property
    @abstractmethod
    def longest_step(self) -> float:
        """The longest time step, in s, that is short enough for the motion."""

    @property
    def steps(self) -> int:
        """The number of steps."""
        return max(1, ceil(self.seconds / self.longest_step))

    @property
    def step(self) -> float:
        """The length of a step in s."""
        return self.seconds / self.steps

    def refuse_long(self) -> None:
        """Raise an error for a motion of more than 20 million steps."""
        steps = self.seconds / self.longest_step
        if not steps <= MAX_STEPS:
            raise AnimationError(
                f"{self.seconds:g} s of this motion take {steps:.3g} steps, expected {MAX_STEPS:.0e} "
                "at most: choose less spin, a larger top or a shorter film"
            )


@dataclass(frozen=True)
class Launch:
    """The initial state of a top, and the forces that slow it down. SI units.

    Raises :class:`~anim.errors.AnimationError` for anything but numbers, a negative tilt or gravity, and
    decay times that are not positive.

    >>> Launch(tilt=0.2).tilt
    0.2
    """

    spin: float | None = None
    """The angular velocity about its own axis, ω₃, in rad/s; None: a tenth above the spin that sleeps."""
    tilt: float = 0.1
    """The angle between its axis and the vertical, in radians."""
    precession: float = 0.0
    """The angular velocity with which its axis goes round the vertical, in rad/s."""
    gravity: float = 9.80665
    """In m/s²."""
    spin_decay: float = 40.0
    """I₃/k₃, the time in s in which friction alone brings ω₃ down to 1/e; infinite: no friction."""
    tilt_decay: float = 12.0
    """I₁/k₁, the same for the angular velocity of the axis."""
    heading: float = 0.0
    """The side to which it leans, an angle from the x axis in radians."""

    def __post_init__(self) -> None:
        if self.spin is not None:
            real("spin", self.spin)
        real("heading", self.heading)
        real("precession", self.precession)
        real("tilt", self.tilt, least=0)
        real("gravity", self.gravity, least=0)
        for name in ("spin_decay", "tilt_decay"):
            time = getattr(self, name)
            if time != inf:
                real(name, time, above=0)

    def without_friction(self) -> "Launch":
        """Return the same launch without friction."""
        return replace(self, spin_decay=inf, tilt_decay=inf)


def attitude_of(launch: Launch) -> Floats:
    """Return the initial attitude (4,): tilted, then rotated to its heading."""
    tilt, heading = launch.tilt, launch.heading
    turn = np.array([cos(heading / 2), 0.0, 0.0, sin(heading / 2)])
    return np.asarray(product(turn, np.array([cos(tilt / 2), 0.0, sin(tilt / 2), 0.0])))
