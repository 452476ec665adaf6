"""``hfield render``: show the spinning top as a film, a folder of pictures, a contact sheet or a web page."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING

from anim.commands.arguments import declare
from anim.output.formats import FORMATS
from hfield.cli.output import note, open_output
from hfield.cli.parser import UsageError
from hfield.cli.status import Progress

if TYPE_CHECKING:
    from anim.film import Clip
    from anim.given_motion import Recorded
    from anim.model import Model
    from anim.motion import Motion
    from anim.output import Film
    from anim.picture import RenderSettings
    from anim.rendering import Scene

SUMMARY = "draw the spinning top: a film, pictures or a web page"
HEADING = "Rotation and film"
HELP = (
    f"Draw the spinning top. The suffix of -o FILE decides the kind of output: .{' .'.join(FORMATS)} gives a "
    "film, .html an interactive web page, .png one frame, no suffix a folder of pictures; with --sheet, a "
    ".png shows ten frames. By default a heavy top stands free on the ground: it precesses, "
    "nods, falls and rolls out. --model chooses another motion."
)
DOING = "preparing the top"
EXAMPLES = (
    "hfield render -o top.mp4",
    "hfield render --model quaternions --captions pl -o thesis.mp4",
    "hfield render --sheet -o sheet.png",
)
SHEET_SIZE, FILM_SIZE = (320, 240), (640, 480)
MAX_FRAMES_OF_A_PAGE = 100_000
MAX_POINTS_OF_A_PAGE = 10_000
BAR_EVERY = 0.1  # seconds


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    declare(parser)


def run(args: Namespace) -> int:
    """Render the film or picture, and report the file."""
    if args.output in ("", "-"):
        raise UsageError("a picture needs an output file: expected a name such as -o top.mp4")
    from anim.commands.choices import clip_of, encoding_of, model_of, recorded_of, refuse_ignored
    from anim.output.writing import OutputKind, kind_of

    path = Path(args.output)
    refuse_ignored(args, OutputKind.FOLDER if args.figures else kind_of(path))
    if args.figures:
        return _figures(args, path)
    if args.quaternions:
        return _seeing(args, path)
    model, recorded = model_of(args), recorded_of(args)
    clip = clip_of(args, recorded)
    kind = kind_of(path)
    encoding_of(args, path)  # raises an error at once for options that the format does not support
    if args.sheet or args.frame is not None or kind is OutputKind.PICTURE:
        return _picture(args, model, clip, path, recorded)
    if kind is OutputKind.PAGE:
        return _page(args, model, clip, path, recorded)
    return _film(args, model, clip, path, recorded)


def _film(args: Namespace, model: Model, clip: Clip, path: Path, recorded: Recorded | None) -> int:
    from anim.aliasing import apparent_spin
    from anim.commands.choices import encoding_of, motions_of, settings_of
    from anim.output import Film, check

    settings = settings_of(args, FILM_SIZE)
    film = Film(settings.size, clip.frames, clip.fps, **encoding_of(args, path))
    check(path, film, args.force)
    (motion,) = motions_of(args, model, clip, recorded)
    scene = _scene(args, model, motion, settings)
    if motion.frames > 1 and not scene.blur:
        said = apparent_spin(motion, model.bands).message()
        if said:
            note(said)
    _render(args, scene, path, film)
    return _report(args, motion, path, settings.size)


def _scene(args: Namespace, model: Model, motion: Motion, settings: RenderSettings) -> Scene:
    from anim.rendering import Scene, framed

    seen = framed(settings, model, motion, args.follow)
    return Scene(model, motion, seen, args.motion_blur, captions=args.captions)


def _render(args: Namespace, scene: Scene, path: Path, film: Film) -> None:
    from anim.rendering import render
    from hfield.core.executors import open_executor

    shown = monotonic()
    with Progress("frames") as bar:

        def show(done: int, total: int) -> None:
            nonlocal shown
            now = monotonic()
            if now - shown >= BAR_EVERY:
                shown = now
                bar(done, total)

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


def _picture(
    args: Namespace, model: Model, clip: Clip, path: Path, recorded: Recorded | None
) -> int:
    """Write one picture: ten frames of the film, or a single one if requested."""
    from anim.commands.choices import motions_of, numbers_of, settings_of
    from anim.output.destination import file_place, refuse_early
    from anim.output.pictures import save_png
    from anim.output.writing import OutputKind, kind_of
    from anim.rendering import contact_sheet, draw

    kind, size = ("sheet", SHEET_SIZE) if args.sheet else ("frame", FILM_SIZE)
    if kind_of(path) is not OutputKind.PICTURE:
        raise UsageError(
            f"--{kind} makes one picture: expected a name such as {kind}.png, not {path.name!r}"
        )
    numbers = numbers_of(args, clip)
    settings = settings_of(args, size)
    refuse_early(path, args.force)
    (motion,) = motions_of(args, model, clip, recorded)
    scene = _scene(args, model, motion, settings)
    picture = contact_sheet(scene, numbers) if args.sheet else draw(scene.task(numbers[0]))
    with file_place(path, args.force) as part:
        save_png(picture, part)
    return _report(args, motion, path, settings.size, numbers)


def _page(args: Namespace, model: Model, clip: Clip, path: Path, recorded: Recorded | None) -> int:
    """Write the page: the four models side by side, or a single one if named; physical tops with curves."""
    from anim.commands.choices import camera_of, motions_of, simulated
    from anim.output import check
    from anim.output.destination import write_text
    from anim.picture.environment import environment
    from anim.picture.settings import colour
    from anim.viewer import Show, curves_of, page

    for name, number, most in (
        ("frames", clip.frames, MAX_FRAMES_OF_A_PAGE),
        ("points a ring", model.ring, MAX_POINTS_OF_A_PAGE),
    ):
        if number > most:
            raise UsageError(f"a page holds at most {most} {name}, not {number}")
    camera, paper = camera_of(args), environment()["paper"]["dark"] if args.dark else None
    if args.background is not None:
        paper = "#{:02x}{:02x}{:02x}".format(*colour("background", args.background))
    check(path, None, args.force)
    motions = motions_of(args, model, clip, recorded)
    text = page(
        model,
        [Show.of(motion) for motion in motions],
        clip.fps,
        curves=curves_of(motions[0]),
        camera=(camera.azimuth, camera.elevation),
        zoom=camera.zoom,
        background=paper,
        simulation=simulated(args, model, motions[0]),
    )
    write_text(path, text, args.force)
    return _report(args, motions[0], path, None)


def _seeing(args: Namespace, path: Path) -> int:
    """Write the page "Seeing quaternions"."""
    from anim.output.destination import refuse_early, write_text
    from anim.output.writing import OutputKind, kind_of
    from anim.viewer import seeing

    if kind_of(path) is not OutputKind.PAGE:
        raise UsageError(
            f"--quaternions makes a page: expected a name such as s3.html, not {path.name!r}"
        )
    refuse_early(path, args.force)
    write_text(path, seeing(), args.force)
    with open_output(None) as out:
        if args.format == "json":
            out.write_json({"schema": "hfield-render-figures/1", "files": [str(path)]})
        else:
            out.write(f"{path}: unit quaternions over the reals, GF(3) and GF(5)")
    return 0


def _figures(args: Namespace, folder: Path) -> int:
    """Write the still pictures of sections 3.3 and 3.4."""
    from anim.picture.still_pictures import NAMES, figures

    there = next((name for name in NAMES if (folder / name).exists()), None)
    if there and not args.force:
        raise UsageError(f"{str(folder / there)!r} exists; --force replaces it")
    paths = figures(folder, args.force)
    with open_output(None) as out:
        if args.format == "json":
            out.write_json({"schema": "hfield-render-figures/1", "files": [str(p) for p in paths]})
        else:
            out.write("\n".join(map(str, paths)))
    return 0


def _report(
    args: Namespace,
    motion: Motion,
    path: Path,
    size: tuple[int, int] | None,
    numbers: list[int] | None = None,
) -> int:
    """Report the film, or the picture of the frames with these numbers."""
    files = sorted(path.iterdir()) if path.is_dir() else [path]
    large = sum(file.stat().st_size for file in files)
    landed = motion.record.landed if motion.record else None
    with open_output(None) as out:
        if args.format == "json":
            out.write_json(
                {
                    "schema": "hfield-render/1",
                    "file": str(path),
                    "bytes": large,
                    "model": motion.name,
                    "frames": motion.frames if numbers is None else len(numbers),
                    "fps": motion.fps,
                    "duration": motion.duration,
                    "size": size and list(size),
                    "landed": landed,
                    **({} if numbers is None else {"shown": numbers}),
                }
            )
        else:
            made = _of_the_film(motion, size) if numbers is None else _of_frames(numbers, motion)
            fell = "" if landed is None else f", on the ground after {landed:.3g} s"
            out.write(f"{path}: {made}, {large / 1e6:.2f} MB{fell}")
    return 0


def _of_the_film(motion: Motion, size: tuple[int, int] | None) -> str:
    number = "1 frame" if motion.frames == 1 else f"{motion.frames} frames"
    shape = f" of {size[0]}x{size[1]}" if size else ""
    return f"{number}{shape} at {motion.fps:g} a second, {motion.duration:.4g} s"


def _of_frames(numbers: list[int], motion: Motion) -> str:
    if len(numbers) == 1:
        return (
            f"frame {numbers[0]} of {motion.frames}, {numbers[0] / motion.fps:.4g} s into the film"
        )
    listed = ", ".join(map(str, numbers))
    return f"{len(numbers)} frames of {motion.frames}: {listed}"
