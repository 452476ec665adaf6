"""``hfield order``: an order over the integers, maximal, Eichler or generated, and what it is."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from hfield.commands.answers import Answer, of_parts
from hfield.commands.orders import (
    add_algebra,
    add_answers,
    algebra_of,
    answer_certified,
    elements_of,
    ideal_json,
    level_of,
    sum_text,
    summands,
)
from hfield.errors import TooLargeError

if TYPE_CHECKING:
    from hfield.evidence import Claim
    from hfield.lattices.lattice import Order
    from hfield.lattices.over_integers.lattices import IntegersOrder
    from hfield.presenting import Part

HELP = (
    "Show an order over ZZ in an algebra over QQ, or over the integers of another number field: its basis, "
    "discriminant, units, conductor, class number. By default a maximal order; --level gives an Eichler one, "
    "--generators the ring that they generate."
)
DOING = "computing the order"
EXAMPLES = (
    "hfield order '(-1,-11|QQ)' --level 3",
    "hfield order '(-1,-1|QQ(sqrt(5)))' --level '11, 4 + sqrt(5)'",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_algebra(parser)
    group = parser.add_mutually_exclusive_group()
    group.add_argument("--level", metavar="N", help="an Eichler order of this level")
    group.add_argument("--generators", metavar="X,Y,…", help="elements, such as 'i, 1/2 + 1/2*j'")
    group.add_argument(
        "--extremal", action="store_true", help="the p-extremal order where KLPT starts"
    )
    add_answers(parser)


def run(args: Namespace) -> int:
    """Make the order, and print what it is."""
    return answer_certified(args, _answer)


def _answer(args: Namespace) -> tuple[Answer, Callable[[], Claim]]:
    O = _made(args)
    if O.algebra.over_integers:
        shown = of_parts(lambda: data_over_integers(O), lambda: parts_over_integers(O))
        return shown, lambda: O.claim
    return of_parts(lambda: to_json(O), lambda: parts(O)), lambda: O.claim


def _made(args: Namespace) -> Any:
    """Return the order that is asked for: an Order, or an IntegersOrder over other number fields."""
    A = algebra_of(args.algebra)
    if args.extremal:
        return A.extremal_order()
    if args.generators is not None:
        return A.order(elements_of(A, args.generators, "--generators"))
    return A.eichler_order(level_of(args.level or "1", A))


def to_json(O: Order) -> dict[str, Any]:
    """Return what programs read."""
    den, rows = O.hnf
    definite = "inf" in O.algebra.ramified_places()  # type: ignore[attr-defined]
    return {
        "schema": "hfield-order/1",
        "kind": "order",
        "algebra": str(O.algebra),
        "den": den,
        "rows": [list(row) for row in rows],
        "basis": [[O.algebra.ring.text(x) for x in q.coordinates] for q in O.basis],
        "discriminant": O.discriminant(),
        "level": O.level,
        "maximal": O.is_maximal(),
        "eichler": O.is_eichler(),
        "conductor": O.conductor(),
        "units": O.unit_count() if definite else None,
        "unit_group": O.unit_group(),
        "mass": str(O.mass()) if definite else None,
        **_class_number(O, definite),
    }


def _class_number(O: Order, definite: bool) -> dict[str, object]:
    """Return how many classes of ideals there are, and how that is known; nothing for no Eichler order."""
    if not O.is_eichler():
        return {"class_number": None, "class_number_by": None}
    number = O.algebra.class_number(O.level)  # type: ignore[attr-defined]
    how = "Eichler's formula" if definite else "strong approximation"
    return {"class_number": number, "class_number_by": how}


def parts(O: Order) -> list[Part]:
    """Return what people read."""
    from hfield.presenting import Facts

    data = to_json(O)
    kind = (
        "maximal"
        if data["maximal"]
        else "an Eichler order"
        if data["eichler"]
        else "no Eichler order"
    )
    units = (
        "infinitely many"
        if data["units"] is None
        else f"{data['units']}, the group {data['unit_group']}"
    )
    facts = [
        ("algebra", data["algebra"]),
        ("basis", ", ".join(str(q) for q in O.basis)),
        ("reduced discriminant", f"{data['discriminant']}, of level {data['level']}: {kind}"),
        ("conductor", str(data["conductor"])),
        ("units", units),
    ]
    if data["mass"] is not None:
        facts.append(("mass", data["mass"]))
    if data["class_number"] is not None:
        facts.append(("class number", f"{data['class_number']}, by {data['class_number_by']}"))
    formulas = {"algebra": f"${O.algebra.latex()}$", "basis": f"${O.latex()}$"}
    return [Facts(facts, 22, formulas=formulas)]


def data_over_integers(O: IntegersOrder) -> dict[str, Any]:
    """Return what programs read of an order over the integers of a number field."""
    maximal = O.is_maximal()
    return {
        "schema": "hfield-order/1",
        "kind": "order",
        "algebra": str(O.algebra),
        "basis": [[O.algebra.ring.text(x) for x in q.coordinates] for q in O.basis],
        "pseudo_basis": summands(O),
        "discriminant": ideal_json(O.discriminant()),
        "level": ideal_json(O.level),
        "maximal": bool(maximal),
        "reason": maximal.reason,
        "eichler": O.is_eichler(),
        "conductor": ideal_json(O.conductor()),
        "bass": O.is_bass(),
        "hereditary": O.is_hereditary(),
        "unit_index": _units(O)[0],
    }


def _units(O: IntegersOrder) -> tuple[int | None, str]:
    """Return how many units there are modulo those of the field, if that is known, and what people read."""
    if not O.is_definite():
        return None, "infinitely many modulo those of the field"
    try:
        return O.unit_index(), f"{O.unit_index()} modulo those of the field"
    except TooLargeError as error:
        return None, f"not counted: {error}"


def parts_over_integers(O: IntegersOrder) -> list[Part]:
    """Return what people read of it."""
    from hfield.presenting import Facts

    maximal = O.is_maximal()
    kind = "maximal" if maximal else "an Eichler order" if O.is_eichler() else "no Eichler order"
    words = [
        word
        for word, holds in (
            ("hereditary", O.is_hereditary()),
            ("Bass", O.is_bass()),
            ("Gorenstein", O.is_gorenstein()),
        )
        if holds
    ]
    facts = [
        ("algebra", str(O.algebra)),
        ("sum of", sum_text(O)),
        ("reduced discriminant", f"{O.discriminant()}, of level {O.level}: {kind}"),
        ("conductor", f"{O.conductor()}{': ' * bool(words)}{', '.join(words)}"),
        ("units", _units(O)[1]),
    ]
    if not maximal:
        facts.append(("not maximal", maximal.reason))
    return [
        Facts(facts, 22, formulas={"algebra": f"${O.algebra.latex()}$", "sum of": f"${O.latex()}$"})
    ]
