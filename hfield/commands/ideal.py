"""``hfield ideal``: an ideal of an order, what it is, and whether another one is equivalent."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import TYPE_CHECKING

from hfield.commands.answers import Answer, of_parts
from hfield.commands.orders import (
    add_answers,
    add_where,
    algebra_of,
    answer_certified,
    elements_of,
    level_of,
)

if TYPE_CHECKING:
    from hfield.evidence import Claim
    from hfield.lattices.certificates import Answer as Verdict
    from hfield.lattices.lattice import Ideal
    from hfield.presenting import Part

HELP = (
    "Show the ideal of a maximal or an Eichler order that elements generate: its basis, norm, orders, and "
    "whether it is principal. --with asks whether another ideal is equivalent, and gives the element. The "
    "certificate is about the ideal; with --with or --principal about that answer."
)
DOING = "computing the ideal"
EXAMPLES = (
    "hfield ideal '(-1,-11|QQ)' '3, 1 + j'",
    "hfield ideal '(-1,-11|QQ)' '3, 1 + j' --with '9' --certificate answer.json",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_where(parser)
    parser.add_argument("generators", metavar="X,Y,…", help="elements, such as '3, 1 + j'")
    parser.add_argument(
        "--side", choices=("left", "right"), default="left", help="the side (default: left)"
    )
    group = parser.add_mutually_exclusive_group()
    group.add_argument("--with", dest="other", metavar="X,Y,…", help="generators of another ideal")
    group.add_argument("--principal", action="store_true", help="ask for a generator")
    add_answers(parser)


def run(args: Namespace) -> int:
    """Make the ideal, ask what is asked, and print."""
    return answer_certified(args, _answer)


def _answer(args: Namespace) -> tuple[Answer, Callable[[], Claim | Verdict]]:
    I, answer = _asked(args)
    found = of_parts(lambda: to_json(I, answer), lambda: parts(I, answer))
    return found, lambda: I.claim if answer is None else answer


def _asked(args: Namespace) -> tuple[Ideal, Verdict | None]:
    A = algebra_of(args.algebra)
    O = A.eichler_order(level_of(args.level))
    make = O.left_ideal if args.side == "left" else O.right_ideal
    I = make(elements_of(A, args.generators, "the list of generators"))
    if args.principal:
        return I, I.is_principal()
    if args.other is None:
        return I, None
    return I, I.equivalence(make(elements_of(A, args.other, "--with")))


def to_json(I: Ideal, answer: Verdict | None) -> dict[str, object]:
    """Return what programs read."""
    data = {
        "schema": "hfield-ideal/1",
        **I.evidence,
        "integral": I.is_integral(),
        "invertible": I.is_invertible(),
        "two_sided": I.is_two_sided(),
    }
    if answer is not None:
        data |= {"holds": answer.holds, "reason": answer.reason, "theorem": answer.theorem}
        data["element"] = answer.evidence.get("element")
    return data


def parts(I: Ideal, answer: Verdict | None) -> list[Part]:
    """Return what people read."""
    from hfield.presenting import Facts

    kinds = [
        word
        for word, holds in (
            ("integral", I.is_integral()),
            ("locally principal", I.is_invertible()),
            ("two-sided", I.is_two_sided()),
        )
        if holds
    ]
    other = I.right_order() if I.side == "left" else I.left_order()
    facts = [
        (f"{I.side} ideal of", str(I.order)),
        ("basis", ", ".join(map(str, I.basis))),
        ("reduced basis", ", ".join(map(str, I.reduced_basis()))),
        ("reduced norm", f"{I.norm()}{': ' * bool(kinds)}{', '.join(kinds)}"),
        ("right order" if I.side == "left" else "left order", ", ".join(map(str, other.basis))),
    ]
    if answer is not None:
        question = "principal" if answer.lattices[0] == I.order.value else "equivalent"
        facts.append((question, repr(answer)))
    if answer is not None and answer.theorem is not None:
        facts.append(("theorem", answer.theorem))
    formulas = {f"{I.side} ideal of": f"${I.order.latex()}$", "basis": f"${I.latex()}$"}
    return [Facts(facts, 22, formulas=formulas)]
