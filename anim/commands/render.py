"""``hfield render``: the spinning top as a film, a folder of pictures, a contact sheet or a web page."""

from __future__ import annotations

import re
from argparse import ArgumentParser, ArgumentTypeError, Namespace, _ArgumentGroup
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING

from hfield.commands.output import Progress, note, open_output
from hfield.commands.parser import UsageError, add_format, processes

if TYPE_CHECKING:
    from anim.film import Clip
    from anim.model import Model
    from anim.motion import Motion
    from anim.output import Film
    from anim.picture import Look
    from anim.render import Scene
    from anim.timeline import Timeline

SUMMARY = "draw the spinning top: a film, pictures, or a web page in which it turns"
HELP = (
    "Draw the spinning top. The suffix of -o FILE says what is made: .mp4 .gif .apng .webp a film, .html a "
    "web page in which it turns, a name without suffix a folder of pictures; with --sheet a .png of ten "
    "frames. --model takes one of the thesis's four ways to its motion, or physics: a heavy top that "
    "precesses, slows and falls."
)
MODELS = ("quaternions", "product", "euler", "matrix", "physics")
PRESETS = (
    "ultrafast",
    "superfast",
    "veryfast",
    "faster",
    "fast",
    "medium",
    "slow",
    "slower",
    "veryslow",
)
SHEET_SIZE, FILM_SIZE = (320, 240), (640, 480)
MOST_FRAMES_OF_A_PAGE = 100_000


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "-o", "--output", metavar="FILE", required=True, help="the film, by its suffix"
    )
    parser.add_argument("--force", action="store_true", help="replace FILE if it exists")
    parser.add_argument("--sheet", action="store_true", help="ten frames in one picture, a .png")
    parser.add_argument(
        "--preview",
        action="store_true",
        help="a quick look: half the size, a quarter of the frames",
    )
    parser.add_argument(
        "--jobs", type=processes, default=1, metavar="N", help="draw in N processes"
    )
    _motion(parser.add_argument_group("the motion"))
    _picture(parser.add_argument_group("the picture"))
    _physics(parser.add_argument_group("the heavy top (--model physics), in SI units"))
    add_format(parser, "plain", "json")


def _motion(group: _ArgumentGroup) -> None:
    group.add_argument(
        "--model",
        choices=MODELS,
        metavar="M",
        help=f"{', '.join(MODELS)} (default: quaternions; for .html the first four, side by side)",
    )
    group.add_argument(
        "--frames", type=int, metavar="N", help="frames of the same motion (default: 500)"
    )
    group.add_argument("--fps", type=float, metavar="X", help="frames a second (default: 50)")
    group.add_argument(
        "--duration", type=float, metavar="S", help="seconds of the film (default: 10)"
    )
    group.add_argument(
        "--time-scale",
        type=float,
        metavar="X",
        help="seconds of motion in one of film; 0.5 is slow motion",
    )
    group.add_argument(
        "--motion-blur",
        type=float,
        default=0.0,
        metavar="X",
        help="part of the time the shutter is open, 0 to 1",
    )
    group.add_argument(
        "--spin",
        default="absolute",
        metavar="absolute|accumulated",
        help="what the thesis's speed is",
    )
    group.add_argument(
        "--order",
        default="spin-first",
        metavar="spin-first|tilt-first",
        help="which rotation comes first",
    )
    group.add_argument(
        "--angle",
        default="quarter",
        metavar="A",
        help="of the second rotation: quarter, half, axis, or radians",
    )
    group.add_argument(
        "--euler", default="zyx", metavar="zyx|zyz", help="the axes of the Euler angles"
    )


def _picture(group: _ArgumentGroup) -> None:
    group.add_argument("--size", type=_size, metavar="WxH", help="in pixels (default: 640x480)")
    group.add_argument(
        "--points", type=int, default=1000, metavar="N", help="points on each ring (default: 1000)"
    )
    group.add_argument("--bands", type=int, metavar="N", help="bands of colour (default: 10)")
    group.add_argument(
        "--p2", default="printed", metavar="printed|third|R", help="the radius of P₂"
    )
    group.add_argument(
        "--style", default="flat", metavar="flat|classic|shaded", help="how to draw (default: flat)"
    )
    group.add_argument(
        "--camera",
        metavar="A,E[,D[,Z]]",
        help="azimuth, elevation in degrees, distance, zoom (default: -60,20,12,1)",
    )
    group.add_argument("--background", metavar="COLOUR", help="such as white or '#f5f2ea'")
    group.add_argument("--trace", action="store_true", help="draw the path of the apex")
    group.add_argument("--shadow", action="store_true", help="draw the shadow on the ground")
    group.add_argument(
        "--quality", type=int, default=2, metavar="1..4", help="smoothness (default: 2)"
    )
    group.add_argument(
        "--crf", type=int, default=18, metavar="N", help="quality of mp4: 0 best, 51 (default: 18)"
    )
    group.add_argument(
        "--preset",
        choices=PRESETS,
        default="medium",
        metavar="P",
        help="x264's effort (default: medium)",
    )


def _physics(group: _ArgumentGroup) -> None:
    for name, text in (
        (
            "spin-rate",
            "rad/s about its own axis (default: a tenth above the spin at which it sleeps)",
        ),
        ("tilt", "degrees between its axis and the vertical (default: 5.7)"),
        ("precession", "rad/s of its axis around the vertical (default: 0)"),
        ("gravity", "m/s² (default: 9.80665)"),
        ("mass", "kg (default: 1)"),
        ("density", "kg/m³, in place of the mass"),
        ("scale", "m, the radius of the rim (default: 0.5)"),
        ("spin-decay", "s in which friction slows the spin to 1/e; inf: none (default: 40)"),
        ("tilt-decay", "s for the swing of the axis (default: 12)"),
    ):
        group.add_argument(f"--{name}", type=float, metavar="X", help=text)
    group.add_argument(
        "--seed", type=int, metavar="N", help="lean to a random side (default: to the x axis)"
    )


def run(args: Namespace) -> int:
    """Draw, write, and tell what was made."""
    from anim.output import Film, check

    model, motion = _model(args), _motion_of(args)
    path = Path(args.output)
    film: Film | None = None
    if path.suffix.lower() == ".html":
        check(path, None, args.force)
        _page(args, model, motion, path)
    elif args.sheet:
        _sheet(args, model, motion, path)
    else:
        look = _look(args, motion, FILM_SIZE)
        film = Film(
            look.size,
            motion.frames,
            motion.fps,
            args.crf,
            "ultrafast" if args.preview else args.preset,
        )
        check(path, film, args.force)
        _film(args, _scene(args, model, motion, look), path, film)
    return _report(args, motion, path, film)


def _model(args: Namespace) -> Model:
    from anim.checks import real
    from anim.model import READINGS, Model

    p2 = args.p2 if args.p2 in READINGS or not _is_number(args.p2) else real("--p2", args.p2)
    return Model(args.points, args.bands, p2)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _motion_of(args: Namespace) -> Motion:
    """Return the motion that the flags describe; for a page without ``--model``, the first of its four."""
    from anim.film import clip

    frames = args.frames
    if args.preview:
        whole = clip(frames, args.fps, args.duration, args.time_scale)
        frames = max(1, whole.frames // 4)
        film = clip(frames, None, whole.duration, whole.time_scale)
    else:
        film = clip(frames, args.fps, args.duration, args.time_scale)
    if args.model == "physics":
        return _heavy(args, film)
    given = [
        f"--{name}" for name in _PHYSICS_ONLY if getattr(args, name.replace("-", "_")) is not None
    ]
    if given:
        raise UsageError(f"{given[0]} belongs to --model physics")
    from anim.pipelines import kinematic

    return kinematic(args.model or MODELS[0], film, _reading(args))


_PHYSICS_ONLY = (
    *("spin-rate", "tilt", "precession", "gravity", "mass", "density", "scale"),
    *("spin-decay", "tilt-decay", "seed"),
)


def _reading(args: Namespace) -> Timeline:
    from anim.timeline import Timeline

    angle = float(args.angle) if _is_number(args.angle) else args.angle
    return Timeline(args.spin, args.order, angle, args.euler)


def _heavy(args: Namespace, film: Clip) -> Motion:
    """Return the film of the heavy top, with the flags in place of its defaults."""
    from math import pi, radians

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
    launch = Launch(**{name: value for name, value in given.items() if value is not None})
    sizes = {"scale": args.scale, "mass": args.mass, "density": args.density}
    body = Body.turned(
        _model(args).profile,
        **{name: value for name, value in sizes.items() if value is not None},
    )
    return physical(film, body, launch)


def _look(args: Namespace, motion: Motion, size: tuple[int, int]) -> Look:
    """Return the look, framed for the greatest tilt of this motion."""
    from math import ceil, degrees

    from anim.picture import Camera, Look

    width, height = args.size or size
    if args.preview:
        width, height = (max(2, side // 4 * 2) for side in (width, height))
    return Look(
        size=(width, height),
        style=args.style,
        camera=Camera() if args.camera is None else Camera.parse(args.camera),
        background=args.background,
        trace=args.trace,
        shadow=args.shadow,
        quality=1 if args.preview else args.quality,
        tilt=min(90, 5 * ceil(degrees(float(motion.tilts.max())) / 5)),
    )


def _scene(args: Namespace, model: Model, motion: Motion, look: Look) -> Scene:
    from anim.bands import apparent_spin
    from anim.render import Scene

    if (
        motion.frames > 1
        and not args.motion_blur
        and (text := apparent_spin(motion, model.bands).message())
    ):
        note(text)
    return Scene(model, motion, look, args.motion_blur)


def _film(args: Namespace, scene: Scene, path: Path, film: Film) -> None:
    from anim.render import render
    from hfield.executors import open_executor

    start = monotonic()
    with Progress("frames") as bar:

        def show(done: int, total: int) -> None:
            left = (monotonic() - start) / done * (total - done)
            bar(done, total, f"{left:.0f} s left")

        with open_executor(args.jobs) as executor:
            render(
                scene,
                path,
                film,
                executor=executor,
                jobs=args.jobs,
                force=args.force,
                progress=show,
            )


def _sheet(args: Namespace, model: Model, motion: Motion, path: Path) -> None:
    from anim.output.pictures import save_png
    from anim.output.place import file_place, refuse_early
    from anim.render import contact_sheet

    if path.suffix.lower() != ".png":
        raise UsageError(
            f"--sheet makes one picture: expected a name such as sheet.png, not {path.name!r}"
        )
    refuse_early(path, args.force)
    look = _look(args, motion, SHEET_SIZE)
    with file_place(path) as part:
        save_png(contact_sheet(_scene(args, model, motion, look)), part)


def _page(args: Namespace, model: Model, motion: Motion, path: Path) -> None:
    """Write the page: the four models side by side, or the one named; for physics with curves."""
    from anim.output.place import file_place
    from anim.picture import Camera
    from anim.pipelines import PIPELINES, kinematic
    from anim.viewer import Curve, Show, page

    if motion.frames > MOST_FRAMES_OF_A_PAGE:
        raise UsageError(
            f"a page holds at most {MOST_FRAMES_OF_A_PAGE} frames, not {motion.frames}"
        )
    motions = [motion]
    if args.model is None:
        motions = [kinematic(name, motion.clip, _reading(args)) for name in PIPELINES]
    curves = []
    if motion.record is not None:
        from numpy import degrees

        curves = [
            Curve("tilt", degrees(motion.tilts), "°"),
            Curve("energy", motion.record.energies, "J"),
        ]
    camera = Camera() if args.camera is None else Camera.parse(args.camera)
    text = page(
        model,
        [Show(m.name, m.attitudes) for m in motions],
        motion.fps,
        curves=curves,
        camera=(camera.azimuth, camera.elevation),
        zoom=camera.zoom,
        background=args.background and colour_code(args.background),
    )
    with file_place(path) as part:
        part.write_text(text, encoding="utf-8")


def colour_code(name: str) -> str:
    """Return a colour that matplotlib knows as ``#rrggbb``."""
    from anim.picture.look import colour

    return "#{:02x}{:02x}{:02x}".format(*colour("background", name))


def _report(args: Namespace, motion: Motion, path: Path, film: Film | None) -> int:
    """Tell what was made."""
    files = sorted(path.iterdir()) if path.is_dir() else [path]
    size = sum(file.stat().st_size for file in files)
    with open_output(None) as out:
        if args.format == "json":
            out.write_json(
                {
                    "schema": "hfield-render/1",
                    "file": str(path),
                    "bytes": size,
                    "model": motion.name,
                    "frames": motion.frames,
                    "fps": motion.fps,
                    "duration": motion.duration,
                    "size": None if film is None else list(film.size),
                    "landed": motion.record.landed if motion.record else None,
                }
            )
        else:
            shape = f" of {film.size[0]}x{film.size[1]}" if film else ""
            out.write(
                f"{path}: {motion.frames} frames{shape} at {motion.fps:g} a second, "
                f"{motion.duration:.4g} s, {size / 1e6:.2f} MB"
            )
    return 0


def _size(text: str) -> tuple[int, int]:
    """Read ``640x480`` for argparse."""
    match = re.fullmatch(r"\s*(\d{1,6})\s*[x×,]\s*(\d{1,6})\s*", text, re.ASCII)
    if match is None:
        raise ArgumentTypeError(f"expected WIDTHxHEIGHT such as 640x480, found {text!r}")
    return int(match[1]), int(match[2])
