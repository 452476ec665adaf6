"""The top as a rigid body: mass, centre and moments of inertia of a homogeneous solid of revolution."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import atan2, hypot, pi

from numpy.polynomial import Polynomial

from anim.checks import real
from anim.errors import AnimationError
from anim.outline import simplified

Profile = Sequence[tuple[float, float]]

# The thesis's unit of length in m. A top of this size spins slowly enough for 50 frames a second to show.
SCALE = 0.5
# Lower bound for mass, moments of inertia and their inverses, so that products of three are floats.
MIN_MAGNITUDE = 1e-90
# The largest distance between the outline and the corners that may touch the ground, relative to the extent.
CONTACT_TOLERANCE = 1e-3


@dataclass(frozen=True)
class Body:
    """The mass, moments of inertia about the tip and centre of mass of a top. SI units.

    >>> from anim import Model
    >>> Body.turned(Model().profile).mass
    1.0
    """

    mass: float
    """In kg."""
    height: float
    """From the tip to the centre of mass, in m."""
    axial: float
    """The moment of inertia about the top's axis, I₃, in kg·m²."""
    transverse: float
    """The moment about an axis through the tip perpendicular to it, I₁, in kg·m²."""
    reach: float
    """The tilt at which the surface touches the ground, in radians."""
    outline: Profile = ()
    """Pairs (radius, z) from the tip up, in m, as many as the ground needs to know of a free top."""
    unit: float = SCALE
    """The length in m of the unit in which the outline was given."""

    @classmethod
    def turned(
        cls,
        profile: Profile,
        scale: float = SCALE,
        mass: float | None = None,
        density: float | None = None,
    ) -> "Body":
        """Return the solid with the outline ``profile``, pairs ``(radius, z)`` from the tip at (0, 0)
        upwards.

        ``scale`` is the length of the profile's unit in m. Give either the ``mass`` in kg or the ``density``
        in kg/m³; with neither, the mass is 1 kg. The moments are integrals of the polynomials r², z·r², r⁴
        and z²·r² over each frustum, in closed form. Raises :class:`~anim.errors.AnimationError` if both are
        given, for a value that is not positive, and for an outline without volume above the ground. A body
        with a flat base has ``reach`` 0: it cannot lean on its tip.
        """
        if mass is not None and density is not None:
            raise AnimationError("mass and density are both given; the size makes one of the other")
        size = real("scale", scale, above=0)
        volume, moment, axial, equatorial = _moments(profile)
        if mass is None and density is not None:
            weight = real("density", density, above=0) * volume * (size * size * size)
        else:
            weight = real("mass", 1.0 if mass is None else mass, above=0)
        unit = weight / volume
        square = size * size  # not **, which raises an error for large numbers
        moments = unit * square * axial, unit * square * equatorial
        if not (
            min(weight, *moments) > MIN_MAGNITUDE and max(weight, *moments) < 1 / MIN_MAGNITUDE
        ):
            raise AnimationError(
                f"a top of {weight:.3g} kg and {size:.3g} m has moments of inertia that cannot be "
                "computed with; choose another mass or size"
            )
        fine = CONTACT_TOLERANCE * max(hypot(r, z) for r, z in profile)
        outline = tuple((size * r, size * z) for r, z in simplified(tuple(profile), fine))
        return cls(weight, size * moment / volume, *moments, reach(profile), outline, size)


def reach(profile: Profile) -> float:
    """Return the tilt in radians at which the solid, with its tip on the ground, touches the ground again.

    At tilt θ the lowest point of the circle of radius r at height z is at z·cos θ − r·sin θ. For a solid with
    a flat base the result is 0.

    >>> round(reach([(0, 0), (1, 1), (0.2, 1.1), (0, 3)]) / pi, 6)
    0.25
    """
    angles = [atan2(z, r) for r, z in profile if r > 0]
    if not angles or min(angles) < 0:
        raise AnimationError("the outline is not above the ground around its tip")
    return min(angles)


def _moments(profile: Profile) -> tuple[float, float, float, float]:
    """Return the integrals of 1, z, x² + y² and x² + z² over the solid."""
    volume = moment = axial = equatorial = 0.0
    for (r0, z0), (r1, z1) in pairwise(profile):
        r, z = Polynomial([r0, r1 - r0]), Polynomial([z0, z1 - z0])
        rise = pi * (z1 - z0)
        squares, fourths = _integral(r**2), _integral(r**4)
        volume += rise * squares
        moment += rise * _integral(z * r**2)
        axial += rise * fourths / 2
        equatorial += rise * (fourths / 4 + _integral(z**2 * r**2))
    if not volume > 0:
        raise AnimationError("the outline encloses no volume")
    return volume, moment, axial, equatorial


def _integral(p: Polynomial) -> float:
    return float(p.integ()(1.0))
