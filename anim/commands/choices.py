"""From the arguments of ``hfield render`` to the things they describe: model, film, motion, look."""

from __future__ import annotations

from argparse import Namespace
from dataclasses import replace
from math import ceil, degrees, pi, radians
from typing import TYPE_CHECKING

from anim.commands.arguments import MODELS
from hfield.commands.parser import UsageError

if TYPE_CHECKING:
    from anim.film import Clip
    from anim.model import Model
    from anim.motion import Motion
    from anim.picture import Camera, Look
    from anim.timeline import Timeline

PHYSICS_ONLY = (
    *("spin_rate", "tilt", "precession", "gravity", "mass", "density", "scale"),
    *("spin_decay", "tilt_decay"),
)
FRAMED = 5  # degrees: a look is framed for a tilt that is a multiple of this


def model_of(args: Namespace) -> Model:
    """Return the top."""
    from anim.checks import real
    from anim.model import READINGS, Model

    p2 = args.p2 if args.p2 in READINGS or not _is_number(args.p2) else real("--p2", args.p2)
    return Model(args.points, args.bands, p2)


def clip_of(args: Namespace) -> Clip:
    """Return how many frames there are, and how fast; a preview has a quarter of them."""
    from anim.film import clip

    whole = clip(args.frames, args.fps, args.duration, args.time_scale)
    if not args.preview:
        return whole
    return clip(max(1, whole.frames // 4), None, whole.duration, whole.time_scale)


def motions_of(args: Namespace, model: Model, film: Clip) -> list[Motion]:
    """Return the motion that the flags describe; for a page without ``--model``, all four of the thesis."""
    from anim.output.writing import PAGE
    from anim.pipelines import PIPELINES, kinematic

    if args.model == "physics":
        return [_heavy(args, model, film)]
    for name in PHYSICS_ONLY:
        if getattr(args, name) is not None:
            raise UsageError(f"--{name.replace('_', '-')} belongs to --model physics")
    reading = _reading(args)
    if args.model is None and args.output.lower().endswith(PAGE):
        return [kinematic(name, film, reading) for name in PIPELINES]
    return [kinematic(args.model or MODELS[0], film, reading)]


def camera_of(args: Namespace) -> Camera:
    """Return the camera."""
    from anim.picture import Camera

    return Camera() if args.camera is None else Camera.parse(args.camera)


def look_of(args: Namespace, size: tuple[int, int]) -> Look:
    """Return the look, by default of ``size``; a preview is half as wide and high."""
    from anim.picture import Look

    width, height = args.size or size
    if args.preview:
        width, height = (max(2, side // 4 * 2) for side in (width, height))
    return Look(
        size=(width, height),
        style=args.style,
        camera=camera_of(args),
        background=args.background,
        trace=args.trace,
        shadow=args.shadow,
        quality=1 if args.preview else args.quality,
    )


def framed(look: Look, motion: Motion) -> Look:
    """Return the look, as close as the greatest tilt of a motion allows."""
    steepest = degrees(float(motion.tilts.max()))
    return replace(look, tilt=min(90, FRAMED * ceil(steepest / FRAMED)))


def _reading(args: Namespace) -> Timeline:
    from anim.timeline import Timeline

    angle = float(args.angle) if _is_number(args.angle) else args.angle
    return Timeline(args.spin, args.order, angle, args.euler)


def _heavy(args: Namespace, model: Model, film: Clip) -> Motion:
    """Return the film of the heavy top, with the flags in place of its defaults."""
    from anim.physics import Body, Launch, physical

    given = {
        "spin": args.spin_rate,
        "tilt": None if args.tilt is None else radians(args.tilt),
        "precession": args.precession,
        "gravity": args.gravity,
        "spin_decay": args.spin_decay,
        "tilt_decay": args.tilt_decay,
    }
    if args.seed is not None:
        from random import Random

        given["heading"] = Random(args.seed).uniform(-pi, pi)
    sizes = {"scale": args.scale, "mass": args.mass, "density": args.density}
    launch = Launch(**{name: value for name, value in given.items() if value is not None})
    body = Body.turned(
        model.profile, **{name: value for name, value in sizes.items() if value is not None}
    )
    return physical(film, body, launch)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
