"""``hfield embed``: embed a quadratic order optimally in an order of a quaternion algebra."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, of_parts
from hfield.cli.order_arguments import (
    add_answers,
    add_where,
    algebra_of,
    answer_certified,
    level_of,
)

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.evidence import CertifiedClaim
    from hfield.orders.quadratic_orders import Embeddings
    from hfield.presenting import AnswerSection

HELP = (
    "Embed the quadratic order of discriminant D optimally in a maximal or an Eichler order: "
    "print the image of (t + √D)/2, where t² ≡ D modulo 4 (over ZZ, t is D), or why there is none. "
    "With --all, print one image of each orbit under conjugation by units; for D < 0 in an indefinite "
    "algebra over QQ the certificate then shows that these are all."
)
DOING = "searching embeddings"
EXAMPLES = (
    "hfield embed 6 -24 --all",
    "hfield embed 6 -840 --level 35 --certificate embedding.json",
    "hfield embed '(-1,-1|QQ(sqrt(5)))' -3",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_where(parser)
    parser.add_argument(
        "discriminant", metavar="D", help="a discriminant, such as -24, 5 or '-(5 + sqrt(5))/2'"
    )
    parser.add_argument(
        "--all",
        dest="every",
        action="store_true",
        help="print one embedding of each orbit",
    )
    add_answers(parser)


def run(args: Namespace) -> int:
    """Search the embeddings, and print them."""
    return answer_certified(args, _answer)


def _answer(args: Namespace) -> tuple[OutputDocument, Callable[[], CertifiedClaim]]:
    A = algebra_of(args.algebra)
    E = A.eichler_order(level_of(args.level, A)).embeddings(A.ring(args.discriminant))
    shown = E.representatives if args.every else None
    return of_parts(
        lambda: to_json(E, shown), lambda: parts(E, shown)
    ), lambda: E.claim if not args.every or E.listed is not None else E.claim_of_orbits()


def to_json(E: Embeddings, shown: tuple[Quaternion, ...] | None) -> dict[str, object]:
    """Return the answer as JSON data."""
    write = E.order.algebra.ring.text

    def coordinates(q: Quaternion | None) -> list[str] | None:
        return None if q is None else [write(x) for x in q.coordinates]

    data = {
        "schema": "hfield-embed/1",
        "algebra": str(E.order.algebra),
        "discriminant": str(E.discriminant),
        "exists": bool(E),
        "element": coordinates(E.element),
        "reason": E.reason,
    }
    if shown is not None:
        data |= {"orbits": len(shown), "representatives": [coordinates(q) for q in shown]}
    return data


def parts(E: Embeddings, shown: tuple[Quaternion, ...] | None) -> list[AnswerSection]:
    """Return the answer as facts."""
    from hfield.presenting import Facts

    facts = [("order", str(E.order)), ("quadratic order", f"of discriminant {E.discriminant}")]
    facts.append(("embedding", str(E.element)) if E else ("embedding", f"none: {E.reason}"))
    if shown is not None:
        facts.append(("orbits", str(len(shown))))
        facts += [("" if n else "one of each", str(q)) for n, q in enumerate(shown)]
    return [Facts(facts)]
