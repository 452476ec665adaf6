"""A film of the heavy top: launched, and followed to the film's end or until its rim touches the ground."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import cos, degrees, hypot, inf, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from anim.errors import AnimationError
from anim.film import Clip
from anim.model import Model
from anim.motion import Motion, Record
from anim.physics.free import Contact, FreeTop
from anim.physics.inertia import Body
from anim.physics.launch import EVERY, Launch, Stepped, attitude_of
from rotation.matrices import to_matrix

if TYPE_CHECKING:
    from anim.physics.integrator import Rates

Floats = NDArray[np.float64]

ACCURACY = 0.02
"""The step times the greatest rate of the motion: half of what keeps the energy to 1e-9."""


@dataclass(frozen=True)
class HeavyTop(Stepped):
    """A body on its tip, launched, and followed for ``seconds``: the sampler of its motion.

    Raises :class:`~anim.errors.AnimationError` for a tilt beyond that at which the rim is on the ground, and
    for a motion of more than 20 million steps.
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
        """The greatest torque of gravity about the tip, mgl, in N·m."""
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
        """The longest step in s: ACCURACY over the greatest rate, of nutation, swing, fall or decay."""
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
        """The state at the start, (7,): attitude, and the angular velocity in the body's axes."""
        velocity = [-self.launch.precession * sin(self.launch.tilt), 0.0, self.spin]
        return np.concatenate([attitude_of(self.launch), velocity])

    @cached_property
    def landed(self) -> float | None:
        """When the rim touches the ground, in s; None if it does not while the film lasts."""
        landed = self._followed[1]
        return landed if 0 <= landed <= self.seconds else None

    def states(self, times: Floats) -> Floats:
        """Return the states (n, 7) at instants (n,): attitudes and angular velocities in the body's axes."""
        from anim.physics.integrator import visit_compiled

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
        """The constants of this top for the integrator: torque, losses, contact."""
        from anim.physics.integrator import Rates

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
        """The states after every EVERY steps, and when the rim touched, or −1."""
        from anim.physics.integrator import run_compiled

        kept = np.empty((self.steps // EVERY + 1, 7))
        return kept, run_compiled(kept, self.start, self.step, self.steps, EVERY, self.rates)

    @staticmethod
    def _vertical(states: Floats) -> Floats:
        return np.asarray(to_matrix(states[:, :4]))[:, 2, :]


STORY = (
    Launch(spin=30.5, tilt=0.35, spin_decay=30.0),
    Contact(radius=0.06, friction=0.5, rolling=0.01),
)
"""A launch of the thesis's top, and a ground, that show in ten seconds all that a top does."""


def story_of(body: Body, free: bool) -> tuple[Launch, Contact | None]:
    """Return the launch and the ground of :data:`STORY` in proportion for another body.

    Without ``free`` there is no ground. Two ratios are those of the thesis's top: of the spin to the spin at
    which the body sleeps upright, and of the tip's radius to the size of the body. The tilt is at most half
    the tilt at which the rim touches the ground.
    """
    usual = Body.turned(Model().profile)
    launch, contact = STORY if free else (Launch(), None)
    lean = min(launch.tilt, body.reach / 2)
    if contact is None:
        return replace(launch, tilt=lean), None
    pace = sqrt(body.mass * body.height * body.transverse) / body.axial
    usual_pace = sqrt(usual.mass * usual.height * usual.transverse) / usual.axial
    size, usual_size = (max(hypot(*corner) for corner in b.outline) for b in (body, usual))
    spin = (launch.spin or 0.0) * pace / usual_pace
    larger = {name: getattr(contact, name) * size / usual_size for name in ("radius", "rolling")}
    return replace(launch, tilt=lean, spin=spin), replace(contact, **larger)


def physical(
    clip: Clip | None = None,
    body: Body | None = None,
    launch: Launch | None = None,
    contact: Contact | None = None,
) -> Motion:
    """Return the film of a heavy symmetric top; by default the thesis's model in metres.

    Its tip stays where it is, unless ``contact`` says how a free top meets the ground. Raises
    :class:`~anim.errors.AnimationError` where :class:`HeavyTop` and :class:`~anim.physics.FreeTop` do.

    >>> from anim import clip
    >>> physical(clip(frames=50)).frames
    50
    """
    film, chosen = clip or Clip(), body or Body.turned(Model().profile)
    start = launch or Launch()
    if contact is not None:
        free = FreeTop(chosen, start, film.seconds, contact)
        states = free.states(film.times)
        record = Record(
            free.energies(states), free.momenta(states)[:, 2], states[:, 6].copy(), free.landed
        )
        return Motion.sample("free", film, free, record, free.places)
    top = HeavyTop(chosen, start, film.seconds)
    states = top.states(film.times)
    record = Record(
        top.energies(states), top.vertical_momenta(states), states[:, 6].copy(), top.landed
    )
    return Motion.sample("physics", film, top, record)
