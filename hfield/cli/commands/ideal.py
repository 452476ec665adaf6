"""``hfield ideal``: describe an ideal of an order, and decide whether another is equivalent."""

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
    basis_name,
    basis_text,
    elements_of,
    ideal_json,
    lattice_data,
    level_of,
)

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.evidence import CertifiedClaim
    from hfield.orders.lattice import Ideal
    from hfield.presenting import AnswerSection
    from hfield.verdicts import Verdict

HELP = (
    "Describe the ideal that elements generate in a maximal or an Eichler order: basis, "
    "norm, left and right order, and whether it is principal. With --with, decide whether "
    "it is equivalent to another ideal and print the element. The certificate is about the "
    "ideal, or about the answer to --with or --principal."
)
DOING = "computing the ideal"
EXAMPLES = (
    "hfield ideal '(-1,-1|QQ(sqrt(5)))' '3, 1 + i + j' --principal",
    "hfield ideal '(-1,-11|QQ)' '3, 1 + j'",
    "hfield ideal '(-1,-11|QQ)' '3, 1 + j' --with '9' --certificate answer.json",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_where(parser)
    parser.add_argument("generators", metavar="X,Y,…", help="elements, such as '3, 1 + j'")
    parser.add_argument(
        "--side",
        choices=("left", "right"),
        default="left",
        help="left or right ideal (default: left)",
    )
    group = parser.add_mutually_exclusive_group()
    group.add_argument("--with", dest="other", metavar="X,Y,…", help="generators of another ideal")
    group.add_argument(
        "--principal", action="store_true", help="find a generator, or prove that there is none"
    )
    add_answers(parser)


def run(args: Namespace) -> int:
    """Read the ideal, compute what the options request, and print."""
    return answer_certified(args, _answer)


def _answer(
    args: Namespace,
) -> tuple[OutputDocument, Callable[[], CertifiedClaim | Verdict[Quaternion]]]:
    I, answer = _ideal_and_answer(args)
    question = "principal" if args.principal else "equivalent"
    found = of_parts(lambda: to_json(I, answer), lambda: parts(I, answer, question))
    return found, lambda: I.claim if answer is None else answer


def _ideal_and_answer(args: Namespace) -> tuple[Ideal, Verdict[Quaternion] | None]:
    """Return the ideal, and the answer to the question about it, if one was asked."""
    A = algebra_of(args.algebra)
    O = A.eichler_order(level_of(args.level, A))
    make = O.left_ideal if args.side == "left" else O.right_ideal
    I = make(elements_of(A, args.generators, "the list of generators"))
    if args.principal:
        return I, I.is_principal()
    if args.other is None:
        return I, None
    return I, I.equivalence(make(elements_of(A, args.other, "--with")))


def to_json(I: Ideal, answer: Verdict[Quaternion] | None) -> dict[str, object]:
    """Return the JSON data."""
    data = {
        "schema": "hfield-ideal/1",
        **_lattice_json(I),
        "integral": I.is_integral(),
        "invertible": I.is_invertible(),
        "two_sided": I.is_two_sided(),
    }
    if answer is not None:
        q, text = answer.element, I.algebra.ring.text
        data |= {"holds": answer.value, "reason": answer.reason, "theorem": answer.theorem}
        data["element"] = None if q is None else [text(x) for x in q.coordinates]
    return data


def _lattice_json(I: Ideal) -> dict[str, object]:
    """Return the ideal and its order."""
    return {
        "kind": "ideal",
        "algebra": str(I.algebra),
        "side": I.side,
        **lattice_data(I),
        "order": lattice_data(I.order),
        "norm": ideal_json(I.norm(), str),
    }


def _kinds(I: Ideal) -> str:
    """Return the properties of an ideal as text that follows a colon."""
    properties = (
        ("integral", I.is_integral()),
        ("locally principal", I.is_invertible()),
        ("two-sided", I.is_two_sided()),
    )
    words = [word for word, holds in properties if holds]
    return f"{': ' * bool(words)}{', '.join(words)}"


def parts(I: Ideal, answer: Verdict[Quaternion] | None, question: str) -> list[AnswerSection]:
    """Return the text output."""
    from hfield.presenting import Facts

    other = I.right_order() if I.side == "left" else I.left_order()
    reduced = (
        [("reduced basis", ", ".join(map(str, I.reduced_basis())))] if len(I.basis) == 4 else []
    )
    facts = [
        (f"{I.side} ideal of", str(I.order)),
        (basis_name(I), basis_text(I)),
        *reduced,
        ("reduced norm", f"{I.norm()}{_kinds(I)}"),
        ("right order" if I.side == "left" else "left order", basis_text(other)),
    ]
    if answer is not None:
        facts.append((question, repr(answer)))
        if answer.theorem is not None:
            facts.append(("theorem", answer.theorem))
    formulas = {f"{I.side} ideal of": f"${I.order.latex()}$", basis_name(I): f"${I.latex()}$"}
    return [Facts(facts, 22, formulas=formulas)]
