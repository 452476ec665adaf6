"""The arguments of ``hfield render``: names, defaults and help."""

from __future__ import annotations

import re
from argparse import ArgumentParser, ArgumentTypeError, BooleanOptionalAction, _ArgumentGroup

from anim.picture.styles import STYLES
from hfield.cli.parser import add_format, processes

MODELS = ("free", "physics", "quaternions", "product", "euler", "matrix")
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


def declare(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        required=True,
        help="the output; its suffix decides the kind",
    )
    parser.add_argument("--force", action="store_true", help="replace FILE if it exists")
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--sheet", action="store_true", help="draw ten frames in one .png")
    kind.add_argument(
        "--quaternions",
        action="store_true",
        help="write the page Seeing quaternions (.html) instead: products as rotations of S³",
    )
    kind.add_argument(
        "--figures",
        action="store_true",
        help="draw the pictures of sections 3.3 and 3.4 into the folder FILE",
    )
    kind.add_argument(
        "--frame",
        type=int,
        metavar="N",
        help="draw one frame as a .png, counted from 0 (default: 0)",
    )
    parser.add_argument(
        "--preview",
        action="store_true",
        help="draw quickly: half the size, jagged edges",
    )
    parser.add_argument(
        "--jobs", type=processes, default=1, metavar="N", help="draw in N processes"
    )
    _motion(parser.add_argument_group("the motion"))
    _picture(parser.add_argument_group("the picture"))
    _physics(parser.add_argument_group("the heavy top (--model free or physics), in SI units"))
    add_format(parser, "plain", "json")


def _motion(group: _ArgumentGroup) -> None:
    group.add_argument(
        "--model",
        choices=MODELS,
        metavar="M",
        help="free: a heavy top that stands free on the ground (default); physics: a heavy top with a fixed "
        "tip; "
        + ", ".join(MODELS[2:])
        + ": the four motions of the thesis (an .html shows all four)",
    )
    group.add_argument(
        "--motion",
        metavar="FILE",
        help="text or CSV file of attitudes: each line is a frame with the quaternion w, x, y, z; with five "
        "numbers on a line, the first is the time in seconds",
    )
    group.add_argument("--frames", type=int, metavar="N", help="number of frames (default: 500)")
    group.add_argument("--fps", type=float, metavar="X", help="frames per second (default: 50)")
    group.add_argument(
        "--duration", type=float, metavar="S", help="length of the film in seconds (default: 10)"
    )
    group.add_argument(
        "--time-scale",
        type=float,
        metavar="X",
        help="seconds of motion per second of film; 0.5 is slow motion",
    )
    group.add_argument(
        "--motion-blur",
        type=float,
        default=0.0,
        metavar="X",
        help="fraction of a frame for which the shutter is open, 0 to 1 (default: 0)",
    )
    group.add_argument(
        "--spin",
        default="absolute",
        metavar="absolute|accumulated",
        help="how to read the speed of the thesis (default: absolute)",
    )
    group.add_argument(
        "--order",
        default="spin-first",
        metavar="spin-first|tilt-first",
        help="which rotation is applied first (default: spin-first)",
    )
    group.add_argument(
        "--angle",
        default="quarter",
        metavar="A",
        help="angle of the second rotation: quarter, half, axis, or radians (default: quarter)",
    )
    group.add_argument(
        "--euler", default="zyx", metavar="zyx|zyz", help="axes of the Euler angles (default: zyx)"
    )


def _picture(group: _ArgumentGroup) -> None:
    group.add_argument(
        "--size", type=_size, metavar="WxH", help="size in pixels (default: 640x480)"
    )
    group.add_argument(
        "--points",
        type=int,
        default=1000,
        metavar="N",
        help="points on each circle (default: 1000)",
    )
    group.add_argument("--bands", type=int, metavar="N", help="coloured bands (default: 10)")
    group.add_argument(
        "--p2",
        default="printed",
        metavar="printed|third|R",
        help="radius of the circle P₂ (default: printed)",
    )
    group.add_argument(
        "--outline",
        metavar="FILE",
        help="text or CSV file of another shape: z and the radius on each line, from the tip up, in the same "
        "unit (--scale gives its length in m)",
    )
    group.add_argument(
        "--follow",
        action=BooleanOptionalAction,
        help="move the camera with the top (default: only if the top goes far)",
    )
    group.add_argument(
        "--style",
        metavar="|".join(STYLES),
        help="; ".join(f"{name}: {text}" for name, text in STYLES.summaries.items())
        + " (default: shaded)",
    )
    group.add_argument(
        "--camera",
        metavar="A,E[,D[,Z]]",
        help="azimuth, elevation in degrees, distance, zoom (default: -60,20,12,1); "
        "with parallel at the end, parallel rays",
    )
    group.add_argument(
        "--captions",
        nargs="?",
        const="en",
        choices=("en", "pl"),
        help="write formula, tilt and spin above the picture, in English or Polish",
    )
    group.add_argument("--dark", action="store_true", help="dark background with a pool of light")
    group.add_argument(
        "--background", metavar="COLOUR", help="background colour, such as white or '#f5f2ea'"
    )
    for name, text in (("trace", "the path of the apex"), ("shadow", "the shadow on the ground")):
        group.add_argument(
            f"--{name}", action=BooleanOptionalAction, help=f"draw {text} (default: yes)"
        )
    group.add_argument(
        "--quality", type=int, metavar="1..4", help="smoothness of edges; 1 is jagged (default: 2)"
    )
    group.add_argument(
        "--crf",
        type=int,
        metavar="N",
        help="quality of mp4 and webp, from 0 (best) to 51 (default: 18)",
    )
    group.add_argument(
        "--preset",
        choices=PRESETS,
        metavar="P",
        help="effort of the x264 encoder, for mp4 (default: medium)",
    )


def _physics(group: _ArgumentGroup) -> None:
    for name, text in (
        (
            "spin-rate",
            "rad/s about its own axis (default: a tenth above the spin of a sleeping top; free: 30.5)",
        ),
        ("tilt", "degrees between its axis and the vertical (default: 5.7; free: 20)"),
        ("precession", "rad/s of its axis around the vertical (default: 0)"),
        ("gravity", "m/s² (default: 9.80665)"),
        ("mass", "kg (default: 1)"),
        ("density", "kg/m³, in place of the mass"),
        (
            "scale",
            "m: the radius of the rim, or the length of the unit of --outline (default: 0.5, or a top "
            "of the same size)",
        ),
        (
            "spin-decay",
            "s in which friction slows the spin to 1/e; inf: none (default: 40; free: 30)",
        ),
        ("tilt-decay", "s in which the swing of the axis falls to 1/e (default: 12)"),
        ("tip-radius", "m, of the ball on which a free top stands (default: 0.06)"),
        ("friction", "μ between a free top and the ground (default: 0.5)"),
        ("rolling", "m, the arm of the ground's resistance to rolling (default: 0.01)"),
    ):
        group.add_argument(f"--{name}", type=float, metavar="X", help=text)
    group.add_argument(
        "--seed",
        type=int,
        metavar="N",
        help="seed of the random side to which the top leans (default: the x axis)",
    )


def _size(text: str) -> tuple[int, int]:
    """Read ``640x480`` for argparse."""
    match = re.fullmatch(r"\s*(\d{1,6})\s*[x×,]\s*(\d{1,6})\s*", text, re.ASCII)
    if match is None:
        raise ArgumentTypeError(f"expected WIDTHxHEIGHT such as 640x480, found {text!r}")
    return int(match[1]), int(match[2])
