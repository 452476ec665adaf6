"""The motion of a free top on the ground: it slips, rises, sleeps, falls and rolls to rest."""

from dataclasses import dataclass
from functools import cached_property
from math import cos, degrees, hypot, inf, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from anim.checks import real
from anim.errors import AnimationError
from anim.physics.inertia import Body
from anim.physics.launch import EVERY, MAX_STEPS, Launch, Stepped, attitude_of
from rotation.matrices import to_matrix

if TYPE_CHECKING:
    from anim.physics.free_top_equations import Ground

Floats = NDArray[np.float64]

STANDARD = 9.80665
STEP, SINK, CREEP = 8e-4, 1 / 400, 0.025
"""A step over √(l/g), how deep the weight presses the tip in over l, the creep over √(gl)."""
TURN = 0.02
"""The step times the spin, at most."""
MAX_FRICTION = 5.0
RESTING = 1.0
"""c·√(gl), by which an impact of √(gl) loses most of its energy."""


@dataclass(frozen=True)
class Contact:
    """The contact of a free top with the ground: friction and stiffness. SI units.

    Raises :class:`~anim.errors.AnimationError` for a radius that is not positive, and for negative
    friction or rolling resistance.

    >>> Contact(radius=0.05).friction
    0.3
    """

    radius: float = 0.04
    """The tip's: it is a ball whose lowest point is where the outline begins."""
    friction: float = 0.3
    """μ, the coefficient of sliding friction, of tip and rim."""
    rolling: float = 0.0
    """The arm in m of the couple with which the ground resists rolling and drilling."""

    def __post_init__(self) -> None:
        real("the tip's radius", self.radius, above=0)
        if real("friction", self.friction, least=0) > MAX_FRICTION:
            raise AnimationError(
                f"friction is {self.friction:g}; expected at most {MAX_FRICTION:g}"
            )
        real("rolling", self.rolling, least=0)


@dataclass(frozen=True)
class FreeTop(Stepped):
    """A body launched on the ground and followed for ``seconds``; the sampler of its motion.

    It starts on its tip, with the centre of the tip's ball at rest; the launch's decay times describe air
    resistance only. Raises :class:`~anim.errors.AnimationError` for a body without outline, a tilt at which
    the rim is below the ground, and a motion of more than 20 million steps.
    """

    body: Body
    launch: Launch
    seconds: float
    contact: Contact = Contact()

    def __post_init__(self) -> None:
        from anim.physics.free_top_equations import STIFF

        if not self.body.outline:
            raise AnimationError(
                "a free top needs the outline of its body: expected Body.turned(…)"
            )
        tilt, ball = self.launch.tilt, self.contact.radius
        lowest = min(z * cos(tilt) - r * sin(tilt) for r, z in self.body.outline[1:])
        if lowest - ball * (cos(tilt) - 1) < 0 or tilt > np.pi / 2:
            raise AnimationError(f"tilt is {degrees(tilt):.4g}°; the rim is in the ground there")
        self.refuse_long()
        arm = self.contact.rolling * self.pull * self.longest_step
        if ball > 100 * self.body.height or arm * self.body.mass > self.body.axial:
            raise AnimationError(
                f"a tip of {ball:g} m with a rolling arm of {self.contact.rolling:g} m is out of all "
                f"proportion to a top whose centre is at {self.body.height:.3g} m"
            )
        if not self.steps * self.longest_step * self.friction_rate <= STIFF * MAX_STEPS:
            raise AnimationError(
                f"friction of {self.contact.friction:g} is too stiff for a body this thin: "
                f"{self.seconds:g} s would take more than {MAX_STEPS:.0e} steps; choose less friction, "
                "a thicker body or a shorter film"
            )

    @property
    def pull(self) -> float:
        """The gravity in m/s² that determines the ground's stiffness and the steps: that of Earth,
        or more.
        """
        return max(STANDARD, self.launch.gravity)

    @property
    def central(self) -> float:
        """The moment of inertia about an axis through the centre of mass, perpendicular to the top's axis."""
        return self.body.transverse - self.body.mass * self.body.height**2

    @property
    def lever(self) -> float:
        """The distance from the centre of the tip's ball to the centre of mass, in m."""
        return self.body.height - self.contact.radius

    @property
    def sleeping_spin(self) -> float:
        """The spin in rad/s above which the upright top is stable; infinite if there is none.

        With friction the top rests where its energy is least for its Jellett invariant: upright if n² > mg(l
        − ρ)l²/ρ(I₃l − I₁ρ), with I₁ about the centre of mass (N. Bou-Rabee, J. Marsden and L. Romero, "Tippe
        top inversion as a dissipation-induced instability", SIAM Journal on Applied Dynamical Systems 3,
        2004). Without friction it slides about its centre, and the condition is n² > 4mg(l − ρ)I₁/I₃².
        """
        body, ball = self.body, self.contact.radius
        weight = body.mass * self.launch.gravity * self.lever
        if weight <= 0:
            return 0.0
        if not self.contact.friction:
            return 2 * sqrt(weight * self.central) / body.axial
        excess = body.axial * body.height - self.central * ball
        return body.height * sqrt(weight / (ball * excess)) if excess > 0 else inf

    @property
    def spin(self) -> float:
        """The angular velocity about its own axis at the start, in rad/s."""
        if self.launch.spin is not None:
            return self.launch.spin
        threshold = self.sleeping_spin
        if threshold == inf:
            raise AnimationError("no spin makes this top sleep; give a spin")
        return 1.1 * threshold

    @property
    def longest_step(self) -> float:
        """The longest time step, in s, that is short enough for contact, turning and decay."""
        launch = self.launch
        turning = hypot(self.spin, launch.precession * sin(launch.tilt))
        rates = (turning, 1 / launch.spin_decay, 1 / launch.tilt_decay, 1e-9)
        return min(STEP * sqrt(self.body.height / self.pull), TURN / max(rates))

    @property
    def friction_rate(self) -> float:
        """The rate in s⁻¹ at which friction damps slipping: at most μg/ε·(1 + ms²/I)."""
        i1, i3 = self.central / self.body.mass, self.body.axial / self.body.mass
        radius, height, rounding = self.edges.T
        out = (radius + rounding) ** 2
        loose = float(np.max(1 + (out + height**2) / i1 + out / i3))
        return (
            self.contact.friction * self.pull * loose / (CREEP * sqrt(self.pull * self.body.height))
        )

    @property
    def edges(self) -> Floats:
        """The edges that can touch the ground, the tip first, (k, 3): radius, height above the centre,
        rounding.
        """
        ball, height = self.contact.radius, self.body.height
        rest = [(r, z - height, 0.0) for r, z in self.body.outline[1:]]
        return np.array([(0.0, ball - height, ball), *rest])

    @property
    def ground(self) -> "Ground":
        """The constants in the equations of motion."""
        from anim.physics.free_top_equations import Ground

        body, launch, contact = self.body, self.launch, self.contact
        pace, sink = sqrt(self.pull * body.height), SINK * body.height
        constants = (
            self.central / body.mass,
            body.axial / body.mass,
            launch.gravity,
            1 / launch.tilt_decay,
            1 / launch.spin_decay,
            self.pull / sink**1.5,
            RESTING / pace,
            contact.friction,
            CREEP * pace,
            contact.rolling,
        )
        # An integer among them would change the signature.
        return Ground(*map(float, constants))

    @property
    def start(self) -> Floats:
        """The initial state, (14,), in the format of :mod:`anim.physics.free_top_equations`."""
        tilt, rate = self.launch.tilt, self.launch.precession
        attitude = attitude_of(self.launch)
        velocity = np.array([-rate * sin(tilt), 0.0, self.spin])
        turn = np.asarray(to_matrix(attitude))
        arm = turn @ [0.0, 0.0, self.lever]
        sink = SINK * self.body.height * (self.launch.gravity / self.pull) ** (2 / 3)
        place = arm + np.array([0.0, 0.0, self.contact.radius - sink])
        return np.concatenate(
            [attitude, velocity, place, np.cross(turn @ velocity, arm), np.zeros(1)]
        )

    @cached_property
    def landed(self) -> float | None:
        """The time in s at which the rim first touches the ground; None if it does not during the film."""
        landed = self._followed[1]
        return landed if landed >= 0 else None

    def states(self, times: Floats) -> Floats:
        """Return the states (n, 14) at instants (n,)."""
        from anim.physics.free_top_equations import SIZE, meet_compiled, workspace

        instants = np.ascontiguousarray(times, dtype=np.float64)
        kept, spacing, found = self._followed[0], EVERY * self.step, np.empty((len(times), SIZE))
        ground = self.ground
        meet_compiled(found, kept, spacing, instants, self.step, self.edges, ground, workspace())
        return found

    def __call__(self, times: Floats) -> Floats:
        """Return the attitudes (n, 4) at instants (n,)."""
        return self.states(times)[:, :4]

    def places(self, times: Floats) -> Floats:
        """Return the positions (n, 3) of the outline's first point at instants (n,), in the
        outline's unit.
        """
        states = self.states(times)
        axes = np.asarray(to_matrix(states[:, :4]))[:, :, 2]
        return np.asarray((states[:, 7:10] - self.body.height * axes) / self.body.unit)

    def energies(self, states: Floats) -> Floats:
        """Return the sum of kinetic, potential and elastic energy (n,) of states (n, 14), in J."""
        turning = states[:, 4:7] ** 2 @ [self.central, self.central, self.body.axial]
        moving = np.sum(states[:, 10:13] ** 2, axis=1)
        pressed = 0.4 * self.ground.stiffness * np.sum(self._depths(states) ** 2.5, axis=1)
        per_mass = moving / 2 + self.launch.gravity * states[:, 9] + pressed
        return np.asarray(turning / 2 + self.body.mass * per_mass)

    def losses(self, states: Floats) -> Floats:
        """Return the energy lost to friction, air and impacts (n,) up to states (n, 14), in J."""
        return np.asarray(self.body.mass * states[:, 13])

    def momenta(self, states: Floats) -> Floats:
        """Return the angular momenta about the centre of mass as vectors in space (n, 3), in kg·m²/s."""
        own = states[:, 4:7] * [self.central, self.central, self.body.axial]
        return np.asarray(np.einsum("nij,nj->ni", to_matrix(states[:, :4]), own))

    def jellett(self, states: Floats) -> Floats:
        """Return Jellett's invariant (n,) of states (n, 14), in kg·m³/s.

        It is −L·s, where s is the vector from the centre of mass to the contact. It is conserved for any
        friction, as long as only the tip touches the ground and there is no air or rolling resistance (J. H.
        Jellett, A Treatise on the Theory of Friction, 1872).
        """
        axes = np.asarray(to_matrix(states[:, :4]))[:, :, 2]
        arms = self.lever * axes + [0.0, 0.0, self.contact.radius]
        return np.asarray(np.sum(self.momenta(states) * arms, axis=1))

    @cached_property
    def _followed(self) -> tuple[Floats, float]:
        from anim.physics.free_top_equations import SIZE, follow_compiled, workspace

        kept, edges, ground = np.empty((self.steps // EVERY + 1, SIZE)), self.edges, self.ground
        landed = follow_compiled(
            kept, self.start, self.step, self.steps, EVERY, edges, ground, workspace()
        )
        return kept, landed

    def _depths(self, states: Floats) -> Floats:
        """Return how deep each edge is in the ground, (n, k)."""
        up = np.asarray(to_matrix(states[:, :4]))[:, 2, 2][:, None]
        radius, height, rounding = self.edges.T
        low = height * up - radius * np.sqrt(np.maximum(0, 1 - up * up)) - rounding
        return np.asarray(np.maximum(0, -(states[:, 9][:, None] + low)))
