"""Make the model, film, motion and settings that the arguments of ``hfield render`` describe."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import replace
from math import pi, radians
from pathlib import Path
from typing import TYPE_CHECKING, Any

from anim.commands.arguments import MODELS, declare
from anim.output.writing import OutputKind
from hfield.cli.parser import UsageError
from hfield.tables import is_number

if TYPE_CHECKING:
    from anim.film import Clip
    from anim.given_motion import Recorded
    from anim.model import Model
    from anim.motion import Motion
    from anim.physics import Body, Contact, FreeTop, HeavyTop, Launch
    from anim.picture import Camera, RenderSettings
    from anim.timeline import Timeline

PHYSICS_ONLY = (
    *("spin_rate", "tilt", "precession", "gravity", "mass", "density", "scale"),
    *("spin_decay", "tilt_decay"),
)
ENCODING = {"crf": (".mp4", ".webp"), "preset": (".mp4",)}
"""Options of the encoding, and the suffixes of the formats that have them."""
ALWAYS = ("output", "force", "format")
DRAWN_ONLY = (
    *(
        "size",
        "style",
        "quality",
        "trace",
        "shadow",
        "follow",
        "captions",
        "motion_blur",
        "preview",
    ),
)
"""Options of drawn frames: a page draws itself, as its reader likes."""
FREE_ONLY = ("tip_radius", "friction", "rolling")
READING = {"spin": "absolute", "order": "spin-first", "angle": "quarter", "euler": "zyx"}


def refuse_ignored(args: Namespace, kind: OutputKind) -> None:
    """Reject options without effect for this kind of output. Raises :class:`UsageError`."""
    alone = next((flag for flag in ("quaternions", "figures") if getattr(args, flag)), None)
    for name in _given(args):
        flag = f"--{name.replace('_', '-')}"
        if alone and name not in (*ALWAYS, alone):
            raise UsageError(f"--{alone} always makes the same output; leave out {flag}")
        if not alone and kind is OutputKind.PAGE and name in (*DRAWN_ONLY, "jobs"):
            raise UsageError(f"{flag} belongs to films and pictures; a page has no such option")
        if not alone and kind is OutputKind.PICTURE and name == "jobs":
            raise UsageError("--jobs belongs to films; one picture is drawn in one process")
    if kind is OutputKind.PAGE and not alone:
        camera = camera_of(args)
        if replace(camera, azimuth=0, elevation=0, zoom=1) != type(camera)(0, 0):
            raise UsageError(
                "a page has a camera of its own: expected --camera with azimuth, elevation and zoom, "
                "such as -60,20,12,1.5"
            )


def _given(args: Namespace) -> list[str]:
    """Return the options that differ from their defaults."""
    parser = ArgumentParser()
    declare(parser)
    usual = vars(parser.parse_args(["-o", args.output]))
    return [name for name, value in usual.items() if getattr(args, name) != value]


def model_of(args: Namespace) -> Model:
    """Return the top."""
    from anim.checks import real
    from anim.model import READINGS, Model

    if args.outline is not None:
        if args.p2 != "printed":
            raise UsageError("--p2 belongs to the thesis's top, not to --outline")
        return Model.from_outline(args.outline, args.points, args.bands)
    p2 = args.p2 if args.p2 in READINGS or not is_number(args.p2) else real("--p2", args.p2)
    return Model(args.points, args.bands, p2)


def clip_of(args: Namespace, recorded: Recorded | None = None) -> Clip:
    """Return the number of frames and their rate; by default a recorded motion is shown completely."""
    from anim.film import FPS, clip

    if recorded is not None:
        pace = 1.0 if args.time_scale is None else args.time_scale
        length = args.duration
        if length is None and (args.frames is None or args.fps is None) and pace > 0:
            length = recorded.seconds(args.fps or FPS) / pace
        return clip(args.frames, args.fps, length, pace)
    return clip(args.frames, args.fps, args.duration, args.time_scale)


def numbers_of(args: Namespace, clip: Clip) -> list[int]:
    """Return the numbers of the frames in a single picture, as the flags request, counted from 0."""
    if args.sheet:
        from anim.output.sheet import shown

        return shown(clip.frames)
    number: int = args.frame or 0
    if not 0 <= number < clip.frames:
        raise UsageError(
            f"--frame is {number}, and the film has {clip.frames} frames; "
            f"expected a number from 0 to {clip.frames - 1}"
        )
    return [number]


def recorded_of(args: Namespace) -> Recorded | None:
    """Return the motion in the file of ``--motion``, or None without that flag."""
    from anim.given_motion import read_motion

    if args.motion is None:
        return None
    others = [n for n, usual in READING.items() if getattr(args, n) != usual]
    others += [
        name
        for name in ("model", "seed", *PHYSICS_ONLY, *FREE_ONLY)
        if getattr(args, name) is not None
    ]
    if others:
        flag = others[0].replace("_", "-")
        raise UsageError(f"--motion gives the whole motion; leave out --{flag}")
    return read_motion(args.motion)


def motions_of(
    args: Namespace, model: Model, film: Clip, recorded: Recorded | None = None
) -> list[Motion]:
    """Return the motion described by the flags; for a page without ``--model``, all four of the thesis.

    Without ``--model``, flags of the thesis's motion or of the heavy top select the model.
    """
    from anim.output.writing import kind_of
    from anim.pipelines import PIPELINES, kinematic

    if recorded is not None:
        return [recorded.motion(film)]
    read = any(getattr(args, name) != usual for name, usual in READING.items())
    heavy = any(getattr(args, name) is not None for name in PHYSICS_ONLY + FREE_ONLY)
    page = kind_of(Path(args.output)) is OutputKind.PAGE
    chosen = args.model or ("quaternions" if read and not heavy else MODELS[0])
    if args.model is None and page and not heavy:
        return [kinematic(name, film, _reading(args)) for name in PIPELINES]
    for names, models in ((PHYSICS_ONLY, MODELS[:2]), (FREE_ONLY, MODELS[:1])):
        for name in names:
            if getattr(args, name) is not None and chosen not in models:
                flag = name.replace("_", "-")
                raise UsageError(f"--{flag} belongs to --model {' or '.join(models)}")
    if chosen in MODELS[:2]:
        return [_heavy(args, model, film, chosen == MODELS[0])]
    return [kinematic(chosen, film, _reading(args))]


def simulated(args: Namespace, model: Model, motion: Motion) -> HeavyTop | FreeTop | None:
    """Return the simulated top for a live page, or None; for a motion of the thesis it is a free top."""
    from anim.physics import FreeTop, HeavyTop

    if isinstance(motion.sampler, (HeavyTop, FreeTop)):
        return motion.sampler
    if args.model is not None or args.motion is not None:
        return None
    body, launch, contact = _default_setup(args, model, True)
    return FreeTop(body, launch, motion.clip.seconds, contact) if contact else None


def encoding_of(args: Namespace, path: Path) -> dict[str, Any]:
    """Return the options of the encoding. Raises :class:`UsageError` if the format does not have them."""
    given = {name: getattr(args, name) for name in ENCODING if getattr(args, name) is not None}
    for name in given:
        if path.suffix.lower() not in ENCODING[name]:
            raise UsageError(
                f"--{name} belongs to {' and '.join(ENCODING[name])}, not to {path.name}"
            )
    return given


def camera_of(args: Namespace) -> Camera:
    """Return the camera."""
    from anim.picture import Camera

    return Camera() if args.camera is None else Camera.parse(args.camera)


def settings_of(args: Namespace, size: tuple[int, int]) -> RenderSettings:
    """Return the settings of size ``size``, by default those of a film; a preview has half the width and
    height.
    """
    from anim.picture.environment import environment
    from anim.picture.settings import FILM_SETTINGS

    given = {
        name: getattr(args, name)
        for name in ("size", "style", "background", "trace", "shadow", "quality")
        if getattr(args, name) is not None
    }
    if args.dark:
        given.setdefault("background", environment()["paper"]["dark"])
    width, height = size
    quick = {"size": (width // 2, height // 2), "quality": 1} if args.preview else {"size": size}
    return replace(FILM_SETTINGS, camera=camera_of(args), **(quick | given))


def _reading(args: Namespace) -> Timeline:
    from anim.timeline import Timeline

    angle = float(args.angle) if is_number(args.angle) else args.angle
    return Timeline(args.spin, args.order, angle, args.euler)


def _heavy(args: Namespace, model: Model, film: Clip, free: bool) -> Motion:
    """Return the film of the heavy top, with defaults replaced by the flags."""
    from anim.physics import physical

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
    touching = {"radius": args.tip_radius, "friction": args.friction, "rolling": args.rolling}
    body, launch, contact = _default_setup(args, model, free)
    return physical(
        film,
        body,
        replace(launch, **_without_none(given)),
        contact and replace(contact, **_without_none(touching)),
    )


def _default_setup(
    args: Namespace, model: Model, free: bool
) -> tuple[Body, Launch, Contact | None]:
    """Return the body, and its default launch and ground."""
    from anim.physics import Body, Launch
    from anim.physics.films import STORY, story_of
    from anim.physics.inertia import SCALE

    sizes = {"scale": args.scale, "mass": args.mass, "density": args.density}
    if args.outline is None:
        return Body.turned(model.profile, **_without_none(sizes)), *(
            STORY if free else (Launch(), None)
        )
    if args.scale is None:  # as large as the thesis's top
        sizes["scale"] = SCALE * model.magnified
    body = Body.turned(model.profile, **_without_none(sizes))
    return body, *story_of(body, free)


def _without_none(values: dict[str, float | None]) -> dict[str, float]:
    return {name: value for name, value in values.items() if value is not None}
