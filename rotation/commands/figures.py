"""``hfield figures``: plot figures 2.1 to 2.5 of the thesis, and rotated points of the user."""

from __future__ import annotations

from argparse import ArgumentParser, ArgumentTypeError, Namespace
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.cli.output import open_output
from hfield.cli.parser import UsageError, suggest, whole
from hfield.errors import shorten

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rotation.figures import Drawing

SUMMARY = "draw figures 2.1 to 2.5 of the thesis"
HEADING = "Rotation and film"
HELP = (
    "Draw figures 2.1 to 2.5 of the thesis: polar and Cartesian coordinates, a rotated "
    "vector, the letter T, the rotated T, and its reflections as printed and as corrected. "
    "With --points and --angle draw your own points and their images rotated about the origin; "
    "with --angle alone, the letter T. Print the paths of the files."
)
DOING = "drawing"
EXAMPLES = ("hfield figures -o figures", "hfield figures --points corners.csv --angle 30")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "-o",
        "--output",
        default=".",
        metavar="DIR",
        help="write figure-NUMBER.FORMAT to DIR, which is created if missing (default: here)",
    )
    parser.add_argument(
        "--format",
        choices=("png", "svg", "pdf"),
        default="png",
        metavar="png|svg|pdf",
        help="the format of the files (default: png)",
    )
    parser.add_argument(
        "--only",
        action="append",
        default=[],
        metavar="NUMBER",
        help="only these figures, such as 2.1,2.4; repeat the option, or separate by commas",
    )
    parser.add_argument(
        "--dpi",
        type=whole(20, 1200),
        default=150,
        metavar="N",
        help="pixels per inch of a png (default: 150)",
    )
    parser.add_argument(
        "--points",
        metavar="FILE",
        help="draw these points in figure-turned: x and y on each line, separated by commas, semicolons or "
        "spaces; they are joined in order, the last to the first",
    )
    parser.add_argument(
        "--angle",
        type=_degrees,
        action="append",
        default=[],
        metavar="DEGREES",
        help="rotate the points anticlockwise by this angle; repeat the option for more images; without "
        "--points rotate the letter T",
    )
    parser.add_argument(
        "--dots", action="store_true", help="draw the points of --points alone, not joined"
    )
    parser.add_argument("--dark", action="store_true", help="draw figure-turned for a dark page")


def _degrees(text: str) -> float:
    """Read an angle for argparse."""
    try:
        angle = float(text)
    except ValueError:
        angle = float("nan")
    if not isfinite(angle):
        raise ArgumentTypeError(
            f"expected an angle in degrees, such as 30, found {shorten(text.strip())!r}"
        )
    return angle


def run(args: Namespace) -> int:
    """Draw and write the figures, and report the files."""
    from rotation.figures.saving import save

    turned = args.points is not None or bool(args.angle)
    if not turned and (args.dots or args.dark):
        raise UsageError("--dots and --dark go with --points FILE or --angle DEGREES")
    if turned and args.only:
        raise UsageError(
            "--only chooses figures of the thesis; leave it out with --points or --angle"
        )
    drawings = [_turned(args)] if turned else _chosen(args.only)
    if not args.output:
        raise UsageError("the name of the directory is empty; expected -o DIR")
    paths = save(drawings, Path(args.output), args.format, args.dpi, args.dark)
    with open_output(None) as out:
        out.write("\n".join(str(path) for path in paths))
    return 0


def _turned(args: Namespace) -> Drawing:
    """Return the drawing of the user's points. Raises UsageError, and TableError for the file."""
    from hfield.tables import read_table
    from rotation.figures import turned_points
    from rotation.plane import LETTER_T

    if not args.angle:
        raise UsageError("--points needs an angle: write --angle DEGREES, such as --angle 30")
    points = LETTER_T if args.points is None else read_table(args.points, {2: "x, y"}).rows
    return turned_points(points, args.angle, joined=not args.dots)


def _chosen(only: Sequence[str]) -> list[Drawing]:
    """Return the named drawings in order, or all if no name is given. Raises UsageError."""
    from rotation.figures import FIGURES

    wanted = [word.strip() for text in only for word in text.split(",") if word.strip()]
    if only and not wanted:
        raise UsageError(f"--only names no figure; there are {', '.join(FIGURES)}")
    for word in wanted:
        if word not in FIGURES:
            hint = suggest(word, FIGURES) or f"there are {', '.join(FIGURES)}"
            raise UsageError(f"there is no figure {shorten(word)!r}: {hint}")
    return [drawing for number, drawing in FIGURES.items() if number in wanted or not wanted]
