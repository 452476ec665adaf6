"""``hfield draw``: a picture of an algebra over a finite ring."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from hfield.cli.output import try_picture
from hfield.cli.parser import UsageError, algebra_of

HELP = (
    "Draw an algebra over a finite ring: its table of products or its norms as coloured squares, its ideals "
    "as a Hasse diagram, its zero-divisor graph or its commuting graph."
)
DOING = "drawing"
EXAMPLES = (
    "hfield draw 'H(GF(3))' -o products.svg",
    "hfield draw GF3 --what ideals --dark -o ideals.png",
)

WHATS = (
    "product",
    "norm",
    "ideals",
    "right-ideals",
    "two-sided-ideals",
    "commuting",
    "zero-divisors",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("algebra", metavar="ALGEBRA", help="an algebra or a field F, for H(F)")
    parser.add_argument(
        "--what",
        choices=WHATS,
        default=WHATS[0],
        metavar="WHAT",
        help=f"{', '.join(WHATS)} (default: {WHATS[0]})",
    )
    parser.add_argument("--dark", action="store_true", help="draw on a dark background")
    parser.add_argument("-o", "--output", metavar="FILE", help="a file .svg, .png or .pdf")


def run(args: Namespace) -> int:
    """Draw the picture, and report the file."""
    if not args.output:
        raise UsageError("expected the file of the picture: -o FILE, ending in .svg, .png or .pdf")
    A = algebra_of(Namespace(where=args.algebra, algebra=None, field=None))
    try_picture(args.output)
    A.draw(args.output, what=args.what, dark=args.dark)
    print(f"wrote {args.output}")
    return 0
