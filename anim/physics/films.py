"""Films of a physical top, with fixed tip or free on the ground."""

from dataclasses import replace
from math import hypot, sqrt

from anim.film import Clip
from anim.model import Model
from anim.motion import Motion, Record
from anim.physics.free_top import Contact, FreeTop
from anim.physics.heavy_top import HeavyTop
from anim.physics.inertia import Body
from anim.physics.launch import Launch

STORY = (
    Launch(spin=30.5, tilt=0.35, spin_decay=30.0),
    Contact(radius=0.06, friction=0.5, rolling=0.01),
)
"""A launch of the thesis's top, and a ground, that show in ten seconds all that a top does."""


def story_of(body: Body, free: bool) -> tuple[Launch, Contact | None]:
    """Return the launch and the ground of :data:`STORY`, scaled for another body.

    Without ``free`` there is no ground. Two ratios are those of the thesis's top: the spin relative to the
    spin at which the body sleeps upright, and the tip's radius relative to the size of the body. The tilt is
    at most half the tilt at which the rim touches the ground.
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

    The tip is fixed, unless ``contact`` describes how a free top touches the ground. Raises
    :class:`~anim.errors.AnimationError` as :class:`HeavyTop` and :class:`~anim.physics.FreeTop` do.

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
