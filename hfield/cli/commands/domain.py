"""``hfield domain``: the Dirichlet domain of the units of norm 1 of an indefinite order."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import of_parts
from hfield.cli.order_arguments import add_algebra, algebra_of, answer_certified, level_of
from hfield.cli.output import try_picture
from hfield.cli.parser import UsageError, add_factors, add_format
from hfield.errors import shorten

if TYPE_CHECKING:
    from hfield.fuchsian.cm_points import CMPoint
    from hfield.fuchsian.group import Domain
    from hfield.presenting import AnswerSection

HELP = (
    "Compute the group of units of norm 1 of an order in an algebra that splits at exactly "
    "one real place, over QQ or a totally real field: area, signature and presentation. "
    "Draw its Dirichlet domain with -o."
)
DOING = "computing the domain"
EXAMPLES = ("hfield domain '(3,-1|QQ)' -o domain.svg", "hfield domain 6 --cm -24 -o points.svg")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_algebra(parser)
    parser.add_argument(
        "--level", metavar="N", default="1", help="take an Eichler order of this level"
    )
    parser.add_argument(
        "--center", metavar="Z", help="a point of the upper half plane, such as 0.1+2j"
    )
    parser.add_argument(
        "--cm",
        metavar="D",
        action="append",
        default=[],
        help="find the CM points of discriminant D, such as -24, and draw them in the domain; may be given "
        "more than once",
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        help="draw to FILE: .svg, .png, .pdf, or .html with a movable centre",
    )
    parser.add_argument(
        "--dark", action="store_true", help="draw on a dark background; a page begins dark"
    )
    parser.add_argument("--certificate", metavar="FILE", help="write the certificate to FILE")
    add_factors(parser)
    add_format(parser, "plain", "json")


def run(args: Namespace) -> int:
    """Compute the domain, draw it, and print its invariants."""
    center = None if args.center is None else _complex(args.center)
    replace = args.output is not None and try_picture(args.output, ".html")
    A = algebra_of(args.algebra)
    domain = A.eichler_order(level_of(args.level, A)).norm_one_group().domain(center)
    found = [point for d in args.cm for point in domain.group.cm_points(A.ring(d))]
    points = [domain.reduce(point) for point in found]
    if args.output is not None:
        domain.draw(args.output, points=points, dark=args.dark, replace=replace)
    args.output = None  # the printed output goes to the terminal
    # a given centre has its own domain, which carries less information than the group
    claim = domain.group if center is None else domain
    return answer_certified(
        args,
        lambda _: (
            of_parts(lambda: to_json(domain, points), lambda: parts(domain, points)),
            lambda: claim.claim,
        ),
    )


def _complex(text: str) -> complex:
    try:
        return complex(text.replace(" ", ""))
    except ValueError:
        raise UsageError(
            f"{shorten(repr(text))} is not a complex number; expected one such as 0.1+2j"
        ) from None


def to_json(domain: Domain, points: Sequence[CMPoint] = ()) -> dict[str, object]:
    """Return the JSON data, with CM points in the domain."""
    group = domain.group
    text = group.order.algebra.ring.text
    genus, orders, cusps = group.signature
    data: dict[str, object] = {
        "schema": "hfield-domain/1",
        "algebra": str(group.order.algebra),
        "level": group.order.level
        if isinstance(group.order.level, int)
        else str(group.order.level),
        "area": str(group.area),
        "signature": {"genus": genus, "orders": list(orders), "cusps": cusps},
        "center": [text(x) for x in domain.center_element.coordinates],
        "sides": [
            {"element": [text(x) for x in side.element.coordinates], "partner": side.partner}
            for side in domain.sides
        ],
        "vertices": [[z.real, z.imag] for z in domain.vertices],
        "generators": [[text(x) for x in g.coordinates] for g in group.generators],
        "relations": [list(r) for r in group.relations],
        "abelian_invariants": list(group.abelian_invariants),
    }
    if points:
        data["cm_points"] = [
            {
                "discriminant": str(point.discriminant),
                "element": [text(x) for x in point.element.coordinates],
                "stabiliser": [text(x) for x in point.stabiliser.coordinates],
                "place": [complex(point).real, complex(point).imag],
            }
            for point in points
        ]
    return data


def parts(domain: Domain, points: Sequence[CMPoint] = ()) -> list[AnswerSection]:
    """Return the text output, with CM points in the domain."""
    from hfield.presenting import Facts

    group = domain.group
    genus, orders, cusps = group.signature
    facts = [
        ("algebra", str(group.order.algebra)),
        ("level", str(group.order.level)),
        ("area", f"{group.area}, in units of 2π"),
        ("genus", str(genus)),
        ("elliptic points", "of order " + ", ".join(map(str, orders)) if orders else "none"),
        ("cusps", str(cusps)),
        ("centre", f"the fixed point of {domain.center_element}, about {domain.center:.4f}"),
        ("sides", f"{len(domain.sides)}, proved to bound the whole domain"),
        ("generators", ", ".join(map(str, group.generators))),
        ("relations", ", ".join(" ".join(map(str, r)) for r in group.relations) or "none"),
    ]
    for n, point in enumerate(points):
        z = f"{complex(point):.4f}"
        facts.append(("" if n else "CM points", f"{point.element} of {point.discriminant}, at {z}"))
    return [Facts(facts, 22)]
