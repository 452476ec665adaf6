"""``hfield classes``: the ideal classes of an Eichler order, by formula and by enumeration."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from itertools import islice
from typing import TYPE_CHECKING

from hfield.commands.answers import Answer, of_parts
from hfield.commands.orders import (
    SECONDS_A_CLASS,
    add_answers,
    add_where,
    algebra_of,
    announce,
    answer_certified,
    level_of,
)
from hfield.commands.parser import UsageError

if TYPE_CHECKING:
    from hfield.evidence import Claim
    from hfield.lattices.lattice import ClassSet
    from hfield.presenting import Part

HELP = (
    "Enumerate the right ideal classes of an Eichler order of a definite algebra over QQ, compare with "
    "Eichler's class number formula and with the mass, and tell the types and the units."
)
DOING = "enumerating classes"
EXAMPLES = ("hfield classes '(-1,-11|QQ)' --level 3",)
SHOWN = 40


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_where(parser)
    parser.add_argument("--formula", action="store_true", help="enumerate nothing")
    add_answers(parser)


def run(args: Namespace) -> int:
    """Count, enumerate unless told not to, and print."""
    if args.formula and args.certificate is not None:
        raise UsageError(
            "--certificate asks for the classes, and --formula enumerates none: leave one of them out"
        )
    return answer_certified(args, _answer)


def _answer(args: Namespace) -> tuple[Answer, Callable[[], Claim]]:
    A = algebra_of(args.algebra)
    level = level_of(args.level, A)
    O = A.eichler_order(level)
    number, mass = A.class_number(level), O.mass()
    if args.formula:
        C = None
    else:
        announce(number, number * SECONDS_A_CLASS, "--formula enumerates none")
        C = O.class_set()

    def data() -> dict[str, object]:
        head = {
            "schema": "hfield-classes/1",
            "algebra": A.name,
            "discriminant": A.discriminant(),
            "level": level,
            "class_number": number,
            "mass": str(mass),
        }
        tail = {} if C is None else {"type_number": C.type_number, **C.evidence}
        return {**tail, **head}

    def parts() -> list[Part]:
        from hfield.presenting import Facts

        how = "by Eichler's formula" + (" and by enumeration" if C is not None else "")
        facts = [
            ("algebra", f"{A.name}, discriminant {A.discriminant()}, level {level}"),
            ("class number", f"{number}, {how}"),
            ("mass", f"{mass}, the sum of 1/[units : ±1]"),
        ]
        if C is None:
            return [Facts(facts, 14)]
        return [Facts([*facts, ("type number", str(C.type_number))], 14), _table(C)]

    return of_parts(data, parts), lambda: O.claim if C is None else C.claim


def _table(C: ClassSet) -> Part:
    from hfield.presenting import Table

    rows = [
        [
            *(str(n), str(I.norm()), str(C.unit_counts[n])),
            *(I.left_order().unit_group(), str(C.types[n])),
            ", ".join(map(str, I.reduced_basis())),
        ]
        for n, I in enumerate(islice(C, SHOWN))
    ]
    more = len(C) - SHOWN
    return Table(
        rows,
        ">>>>>",
        "rrrlr",
        head=("class", "norm", "units", "group", "type", "reduced basis"),
        below=f"… and {more} more; --format json lists all" if more > 0 else "",
        cells={3: lambda group: rf"$\mathrm{{{group}}}$"},
    )
