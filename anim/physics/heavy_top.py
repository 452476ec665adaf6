"""The heavy top with fixed tip: launched, and followed to the film's end or until its rim touches
the ground.
"""

from dataclasses import dataclass
from functools import cached_property
from math import cos, degrees, inf, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from anim.errors import AnimationError
from anim.physics.inertia import Body
from anim.physics.launch import EVERY, Launch, Stepped, attitude_of
from rotation.matrices import to_matrix

if TYPE_CHECKING:
    from anim.physics.heavy_top_equations import Rates

Floats = NDArray[np.float64]

ACCURACY = 0.02
"""The step times the greatest rate of the motion: half of what keeps the energy to 1e-9."""


@dataclass(frozen=True)
class HeavyTop(Stepped):
    """A body launched on its fixed tip and followed for ``seconds``; the sampler of its motion.

    Raises :class:`~anim.errors.AnimationError` for a tilt beyond the one at which the rim touches the ground,
    and for a motion of more than 20 million steps.
    """

    body: Body
    launch: Launch
    seconds: float

    def __post_init__(self) -> None:
        if self.launch.tilt > self.body.reach:
            raise AnimationError(
                f"tilt is {degrees(self.launch.tilt):.4g}°; the rim is on the ground "
                f"at {degrees(self.body.reach):.4g}°"
            )
        self.refuse_long()

    @property
    def torque(self) -> float:
        """The maximal torque of gravity about the tip, mgl, in N·m."""
        return self.body.mass * self.launch.gravity * self.body.height

    @property
    def sleeping_spin(self) -> float:
        """The spin in rad/s above which the upright top is stable: ω₃² = 4mglI₁/I₃²."""
        return 2 * sqrt(self.torque * self.body.transverse) / self.body.axial

    @property
    def spin(self) -> float:
        """The angular velocity about its own axis at the start, in rad/s."""
        return 1.1 * self.sleeping_spin if self.launch.spin is None else self.launch.spin

    @property
    def longest_step(self) -> float:
        """The longest step in s: ACCURACY divided by the greatest rate (nutation, swing, fall or decay)."""
        body, launch = self.body, self.launch
        fastest = max(
            abs(self.spin) * body.axial / body.transverse,
            abs(launch.precession) * sin(launch.tilt),
            sqrt(self.torque / body.transverse),
            1 / launch.spin_decay,
            1 / launch.tilt_decay,
        )
        return ACCURACY / fastest if fastest > 0 else inf

    @property
    def start(self) -> Floats:
        """The initial state, (7,): attitude, and angular velocity in body axes."""
        velocity = [-self.launch.precession * sin(self.launch.tilt), 0.0, self.spin]
        return np.concatenate([attitude_of(self.launch), velocity])

    @cached_property
    def landed(self) -> float | None:
        """The time in s at which the rim touches the ground; None if it does not during the film."""
        landed = self._followed[1]
        return landed if 0 <= landed <= self.seconds else None

    def states(self, times: Floats) -> Floats:
        """Return the states (n, 7) at instants (n,): attitudes and angular velocities in body axes."""
        from anim.physics.heavy_top_equations import visit_compiled

        kept, landed = self._followed
        instants = np.ascontiguousarray(times, dtype=np.float64)
        found, touch = np.empty((len(instants), 7)), landed if landed >= 0 else inf
        visit_compiled(found, kept, EVERY * self.step, instants, self.step, touch, self.rates)
        return found

    def __call__(self, times: Floats) -> Floats:
        """Return the attitudes (n, 4) at instants (n,)."""
        return self.states(times)[:, :4]

    def energies(self, states: Floats) -> Floats:
        """Return the kinetic and potential energies (n,) of states (n, 7), in J."""
        up, moments = self._vertical(states), self.moments
        return np.asarray((states[:, 4:] ** 2 @ moments) / 2 + self.torque * up[:, 2])

    def vertical_momenta(self, states: Floats) -> Floats:
        """Return the angular momenta about the vertical, L_z (n,), of states (n, 7), in kg·m²/s."""
        return np.asarray(np.sum(states[:, 4:] * self._vertical(states) * self.moments, axis=1))

    @property
    def moments(self) -> Floats:
        """The moments of inertia about the axes of the body, in kg·m²."""
        return np.array([self.body.transverse, self.body.transverse, self.body.axial])

    @property
    def rates(self) -> "Rates":
        """The constants in the equations of motion: torque, losses, and the tilt at which the rim touches."""
        from anim.physics.heavy_top_equations import Rates

        body, launch = self.body, self.launch
        return Rates(
            body.axial / body.transverse,
            self.torque / body.transverse,
            1 / launch.tilt_decay,
            1 / launch.spin_decay,
            cos(body.reach),
        )

    @cached_property
    def _followed(self) -> tuple[Floats, float]:
        """The states after every EVERY steps, and the time at which the rim touched, or −1."""
        from anim.physics.heavy_top_equations import run_compiled

        kept = np.empty((self.steps // EVERY + 1, 7))
        return kept, run_compiled(kept, self.start, self.step, self.steps, EVERY, self.rates)

    @staticmethod
    def _vertical(states: Floats) -> Floats:
        return np.asarray(to_matrix(states[:, :4]))[:, 2, :]
