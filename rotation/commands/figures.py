"""``hfield figures``: the thesis's figures 2.1 to 2.5 as plots."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.commands.output import open_output
from hfield.commands.parser import UsageError, suggest, whole
from hfield.errors import shorten

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rotation.figures import Drawing

SUMMARY = "draw figures 2.1 to 2.5 of the thesis"
HEADING = "Rotation and film"
HELP = (
    "Draw figures 2.1 to 2.5 of the thesis: polar and Cartesian coordinates, a rotated "
    "vector, the letter T, the rotated T, and its reflections as printed and as corrected. "
    "Print the paths of the files."
)
EXAMPLES = ("hfield figures -o figures",)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "-o",
        "--output",
        required=True,
        metavar="DIR",
        help="write figure-NUMBER.FORMAT to DIR, which is created if missing",
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


def run(args: Namespace) -> int:
    """Draw, write and tell where."""
    from rotation.figures.saving import save

    drawings = _chosen(args.only)
    if not args.output:
        raise UsageError("the name of the directory is empty; expected -o DIR")
    paths = save(drawings, Path(args.output), args.format, args.dpi)
    with open_output(None) as out:
        out.write("\n".join(str(path) for path in paths))
    return 0


def _chosen(only: Sequence[str]) -> list[Drawing]:
    """Return the drawings named, in their order; all where none is. Raises UsageError."""
    from rotation.figures import FIGURES

    wanted = [word.strip() for text in only for word in text.split(",") if word.strip()]
    if only and not wanted:
        raise UsageError(f"--only names no figure; there are {', '.join(FIGURES)}")
    for word in wanted:
        if word not in FIGURES:
            hint = suggest(word, FIGURES) or f"there are {', '.join(FIGURES)}"
            raise UsageError(f"there is no figure {shorten(word)!r}: {hint}")
    return [drawing for number, drawing in FIGURES.items() if number in wanted or not wanted]
