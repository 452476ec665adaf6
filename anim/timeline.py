"""The motion of the thesis (section 3.4): its parameters at each instant, and its text form.

A film runs from progress 0 to 1. Meanwhile the axis turns 16 times about the vertical while moving away from
it, and the speed of the spin decreases. ``docs/reference/top.md`` explains where the text is ambiguous, and
the choice of defaults.
"""

from dataclasses import dataclass
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from anim.checks import one_of, real
from anim.errors import AnimationError

Floats = NDArray[np.float64]

SPINS = ("absolute", "accumulated")
ORDERS = ("spin-first", "tilt-first")
ANGLES = {"quarter": pi / 2, "half": pi}
EULER_AXES = ("zyx", "zyz")

AXIS_ANGLE = (0.0, 32 * pi)
RADIUS = (0.0, 1 / 4)
EULER_RADIUS = (0.0, 1 / 2)
SPEED = (16 * pi, pi / 8)


class Instants(NamedTuple):
    """The parameters at n instants, in radians."""

    spin: Floats
    """The angle about the z axis, (n,)."""
    axes: Floats
    """The unit axes of the second rotation, (n, 3)."""
    angles: Floats
    """Its angles, (n,)."""
    euler: Floats
    """The Euler angles that replace the second rotation in the Euler pipeline, (n, 3)."""


@dataclass(frozen=True)
class Timeline:
    """An interpretation of the thesis's text; the module's constants are the ranges of its parameters.

    - ``spin``: the value of ``speed`` is the angle about z ("absolute"), or a speed in rad/s, over which
      the angle accumulates ("accumulated").
    - ``order``: the turn about z comes first, as the words say ("spin-first"), or second, as the formula
      x_Δ = q₁q₂x(q₁q₂)⁻¹ says ("tilt-first").
    - ``angle``: the constant angle of the second rotation, π/2 ("quarter"), π ("half") or any number; or
      "axis", the angle of the axis, 0 … 32π.
    - ``euler``: the axes of the Euler angles, "zyx" or, literally, "zyz".

    Raises :class:`~anim.errors.AnimationError` for any other value.

    >>> Timeline(spin="accumulated").order
    'spin-first'
    """

    spin: str = "absolute"
    order: str = "spin-first"
    angle: str | float = "quarter"
    euler: str = "zyx"

    def __post_init__(self) -> None:
        one_of("spin", self.spin, SPINS)
        one_of("order", self.order, ORDERS)
        one_of("euler", self.euler, EULER_AXES)
        if isinstance(self.angle, str):
            one_of("angle", self.angle, [*ANGLES, "axis"])
        else:
            real("angle", self.angle)

    def at(self, progress: Floats, seconds: float) -> Instants:
        """Return the parameters at ``progress`` (n,), from 0 to 1, for a motion of ``seconds``."""
        if np.any((progress < 0) | (progress > 1)):
            raise AnimationError("the progress of the motion is a number from 0 to 1")
        turn, radius, euler_radius, speed = (
            start + (end - start) * progress
            for start, end in (AXIS_ANGLE, RADIUS, EULER_RADIUS, SPEED)
        )
        if (
            self.spin == "accumulated"
        ):  # the integral of a linear function is its mean times the time
            speed = (SPEED[0] + speed) / 2 * (progress * seconds)
        cos, sin = np.cos(turn), np.sin(turn)
        if isinstance(self.angle, str):
            angles = turn if self.angle == "axis" else np.full_like(turn, ANGLES[self.angle])
        else:
            angles = np.full_like(turn, self.angle)
        return Instants(
            speed,
            np.column_stack([radius * cos, radius * sin, np.sqrt(1 - radius * radius)]),
            angles,
            np.column_stack([np.zeros_like(turn), euler_radius * sin, euler_radius * cos]),
        )
