"""The arguments of ``hfield render``: names, defaults, and what the help says."""

from __future__ import annotations

import re
from argparse import ArgumentParser, ArgumentTypeError, BooleanOptionalAction, _ArgumentGroup

from anim.picture.styles import STYLES
from hfield.commands.parser import add_format, processes

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
        "-o", "--output", metavar="FILE", required=True, help="the film, by its suffix"
    )
    parser.add_argument("--force", action="store_true", help="replace FILE if it exists")
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--sheet", action="store_true", help="ten frames in one picture, a .png")
    kind.add_argument(
        "--quaternions",
        action="store_true",
        help="instead of the top, the page Seeing quaternions, an .html: products as turns of S³",
    )
    kind.add_argument(
        "--figures",
        action="store_true",
        help="the still pictures of sections 3.3 and 3.4, into the folder FILE",
    )
    kind.add_argument(
        "--frame", type=int, metavar="N", help="one frame of the film, counted from 0, a .png"
    )
    parser.add_argument(
        "--preview",
        action="store_true",
        help="a quick look: the same film at half the size, its edges jagged",
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
        help="free: a heavy top that precesses, nods, falls and rolls out (the default); physics: one whose "
        "tip is held; the thesis's four ways: "
        + ", ".join(MODELS[2:])
        + " (an .html has all four)",
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
        "--style",
        metavar="|".join(STYLES),
        help="; ".join(f"{name}: {STYLES.summary(name)}" for name in STYLES) + " (default: shaded)",
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
        help="write formula, tilt and spin in the corner, in English or Polish",
    )
    group.add_argument("--dark", action="store_true", help="on dark paper, in a pool of light")
    group.add_argument("--background", metavar="COLOUR", help="such as white or '#f5f2ea'")
    for name, text in (("trace", "the path of the apex"), ("shadow", "the shadow on the ground")):
        group.add_argument(
            f"--{name}", action=BooleanOptionalAction, help=f"draw {text} (default: yes)"
        )
    group.add_argument(
        "--quality", type=int, metavar="1..4", help="smoothness; 1: jagged edges (default: 2)"
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
            "rad/s about its own axis (default: a tenth above the spin at which it sleeps; free: 30.5)",
        ),
        ("tilt", "degrees between its axis and the vertical (default: 5.7; free: 20)"),
        ("precession", "rad/s of its axis around the vertical (default: 0)"),
        ("gravity", "m/s² (default: 9.80665)"),
        ("mass", "kg (default: 1)"),
        ("density", "kg/m³, in place of the mass"),
        ("scale", "m, the radius of the rim (default: 0.5)"),
        (
            "spin-decay",
            "s in which friction slows the spin to 1/e; inf: none (default: 40; free: 30)",
        ),
        ("tilt-decay", "s for the swing of the axis (default: 12)"),
        ("tip-radius", "m, of the ball on which a free top stands (default: 0.06)"),
        ("friction", "μ between a free top and the ground (default: 0.5)"),
        ("rolling", "m, the arm of the ground's resistance to rolling (default: 0.01)"),
    ):
        group.add_argument(f"--{name}", type=float, metavar="X", help=text)
    group.add_argument(
        "--seed",
        type=int,
        metavar="N",
        help="lean to a random side (default: to the x axis)",
    )


def _size(text: str) -> tuple[int, int]:
    """Read ``640x480`` for argparse."""
    match = re.fullmatch(r"\s*(\d{1,6})\s*[x×,]\s*(\d{1,6})\s*", text, re.ASCII)
    if match is None:
        raise ArgumentTypeError(f"expected WIDTHxHEIGHT such as 640x480, found {text!r}")
    return int(match[1]), int(match[2])
