"""``hfield classes``: the ideal classes of an Eichler order, by formula and by enumeration."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from itertools import islice
from typing import TYPE_CHECKING, Any

from hfield.cli.orders import (
    SECONDS_A_CLASS,
    add_answers,
    add_where,
    algebra_of,
    announce,
    answer_certified,
    ideal_json,
    level_of,
    summands,
)
from hfield.cli.output_document import OutputDocument, of_parts
from hfield.cli.parser import UsageError
from hfield.cli.status import Waiting

if TYPE_CHECKING:
    from hfield.evidence import Claim
    from hfield.orders.lattice import ClassSet, Order
    from hfield.presenting import Part

HELP = (
    "List the right ideal classes of an Eichler order over QQ or a totally real field, with "
    "types and unit groups. In a definite algebra the list is checked against the mass "
    "formula and, over QQ, against Eichler's class number formula. In an indefinite algebra "
    "strong approximation gives the classes by their norms."
)
DOING = "enumerating classes"
EXAMPLES = (
    "hfield classes '(-1,-11|QQ)' --level 3",
    "hfield classes '(-1,-1|QQ(sqrt(5)))' --level '6 + sqrt(5)' --newforms",
)
SHOWN = 40
PRIMES = 8
"""The number of eigenvalues of a newform that are printed."""


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_where(parser)
    parser.add_argument(
        "--formula",
        action="store_true",
        help="print the class number formula only, without enumeration",
    )
    parser.add_argument(
        "--newforms",
        action="store_true",
        help="add the newforms of weight 2 with rational eigenvalues",
    )
    add_answers(parser)


def run(args: Namespace) -> int:
    """Count the classes, enumerate them unless --count is given, and print."""
    if args.formula and args.newforms:
        raise UsageError("--newforms asks for the classes, and --formula enumerates none")
    if args.formula and args.certificate is not None:
        raise UsageError(
            "--certificate asks for the classes, and --formula enumerates none: leave one of them out"
        )
    return answer_certified(args, _answer)


def _answer(args: Namespace) -> tuple[OutputDocument, Callable[[], Claim]]:
    A = algebra_of(args.algebra)
    level = level_of(args.level, A)
    O = A.eichler_order(level)
    if not O.is_definite():
        return _indefinite(args, O)
    if A.is_over_number_field:
        return _over_number_field(args, O)
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
        return {**tail, **head, **(_forms_data(C) if args.newforms else {})}

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
        summary = Facts([*facts, ("type number", str(C.type_number))], 14)
        return [summary, _table(C), *_types(C), *(_forms(C) if args.newforms else [])]

    return of_parts(data, parts), lambda: O.claim if C is None else C.claim


def _table(C: ClassSet) -> Part:
    from hfield.presenting import TextTable

    rows = [
        [
            *(str(n), str(I.norm()), str(C.unit_counts[n])),
            *(I.left_order().unit_group(), str(C.types[n])),
            ", ".join(map(str, I.reduced_basis())),
        ]
        for n, I in enumerate(islice(C, SHOWN))
    ]
    more = len(C) - SHOWN
    return TextTable(
        rows,
        ">>>>>",
        "rrrlr",
        head=("class", "norm", "units", "group", "type", "reduced basis"),
        below=f"… and {more} more; --format json lists all" if more > 0 else "",
        cells={3: lambda group: rf"$\mathrm{{{group}}}$"},
    )


def _types(C: ClassSet) -> list[Part]:
    """Return the types in the order of their labels, unless they are many."""
    from hfield.presenting import TextTable

    if C.type_number > SHOWN:
        return []
    rows = [
        [str(C.types[numbers[0]]), str(len(numbers)), label]
        for label, numbers in C.types_by_label().items()
    ]
    return [TextTable(rows, ">>", "rrl", head=("type", "classes", "label of the left orders"))]


def _over_number_field(args: Namespace, O: Order) -> tuple[OutputDocument, Callable[[], Claim]]:
    """Answer for an order over the integers of a number field."""
    if args.formula:
        raise UsageError(
            "--formula is for algebras over QQ; over number fields the classes are enumerated, up to the mass"
        )
    C = O.class_set()

    def data() -> dict[str, object]:
        classes = [
            {
                "norm": ideal_json(I.norm()),
                "units": units,
                "group": I.left_order().unit_group(),
                "type": kind,
                "pseudo_basis": summands(I),
            }
            for I, units, kind in zip(C, C.units, C.types, strict=True)
        ]
        return {
            "schema": "hfield-classes/1",
            "algebra": str(O.algebra),
            "discriminant": ideal_json(O.discriminant()),
            "level": ideal_json(O.level),
            "class_number": len(C),
            "mass": str(C.mass),
            "type_number": C.type_number,
            "stable_classes": C.stable_classes(),
            "classes": classes,
            **(_forms_data(C) if args.newforms else {}),
        }

    def parts() -> list[Part]:
        from hfield.presenting import Facts, TextTable

        cancels = ": cancellation" if C.has_cancellation() else ""
        facts = [
            ("algebra", f"{O.algebra}, discriminant of the order {O.discriminant()}"),
            ("class number", f"{len(C)}, by enumeration up to the mass"),
            ("mass", f"{C.mass}, the sum of 1/[units : units of the field]"),
            ("type number", str(C.type_number)),
            ("stable classes", f"{O.stable_class_number()}, of I up to I ⊕ O ≅ J ⊕ O{cancels}"),
        ]
        rows = [
            [str(n), str(I.norm()), str(C.units[n]), I.left_order().unit_group(), str(C.types[n])]
            for n, I in enumerate(islice(C, SHOWN))
        ]
        more = len(C) - SHOWN
        head = ("class", "norm", "units", "group", "type")
        below = f"… and {more} more; --format json lists all" if more > 0 else ""
        table = TextTable(rows, "><><", "rlrlr", head=head, below=below)
        return [Facts(facts, 14), table, *(_forms(C) if args.newforms else [])]

    return of_parts(data, parts), lambda: C.claim


def _indefinite(args: Namespace, O: Any) -> tuple[OutputDocument, Callable[[], Claim]]:
    """Answer by strong approximation where an infinite place splits: over QQ there is one class."""
    from hfield.evidence import Claim
    from hfield.orders.certificates import REFUSAL

    A, is_over_number_field = O.algebra, O.algebra.is_over_number_field
    if args.newforms:
        raise UsageError(f"--newforms asks for a definite algebra, and {A} is indefinite")
    ideals: Any = O.classes_by_norm() if is_over_number_field else [O]
    types = ideals.type_number if is_over_number_field else 1
    to_json = ideal_json if is_over_number_field else int

    def data() -> dict[str, object]:
        classes = [
            {
                "norm": to_json(I.norm()),
                **({"pseudo_basis": summands(I)} if is_over_number_field else {}),
            }
            for I in ideals
        ]
        return {
            "schema": "hfield-classes/1",
            "algebra": str(A),
            "discriminant": to_json(O.discriminant()),
            "level": to_json(O.level),
            "class_number": len(ideals),
            "type_number": types,
            "classes": classes,
        }

    def parts() -> list[Part]:
        from hfield.presenting import Facts

        facts = [
            ("algebra", f"{A}, discriminant of the order {O.discriminant()}: indefinite"),
            (
                "class number",
                f"{len(ideals)}, by strong approximation: the reduced norm tells the class",
            ),
            ("type number", str(types)),
            ("norms", ", ".join(str(I.norm()) for I in islice(ideals, SHOWN))),
        ]
        return [Facts(facts, 14)]

    claim = Claim(A, "classes", {}, "strong approximation", refusal=REFUSAL)
    return of_parts(data, parts), lambda: claim


def _newforms(C: Any) -> list[Any]:
    Waiting.at("computing newforms")
    found: list[Any] = C.newforms()
    return found


def _forms_data(C: Any) -> dict[str, object]:
    """Return dimensions and newforms, as JSON data."""
    forms = [
        {
            "eigenvalues": {str(P): a for P, a in f.eigenvalues(PRIMES).items()},
            "signs": {str(P): sign for P, sign in f.signs.items()},
        }
        for f in _newforms(C)
    ]
    sizes = {"cusp_dimension": C.cusp_dimension(), "new_dimension": C.new_dimension()}
    return {**sizes, "newforms": forms}


def _forms(C: Any) -> list[Part]:
    """Return dimensions and newforms, as parts."""
    from hfield.presenting import Facts

    dimensions = (
        f"{C.cusp_dimension()}, newforms among them {C.new_dimension()}; rational ones below, with "
        "eigenvalues a_p and signs w_p of Atkin and Lehner"
    )
    facts = [("cusp forms", dimensions)]
    for n, f in enumerate(_newforms(C), 1):
        signs = ", ".join(f"w_{P} = {w}" for P, w in f.signs.items())
        values = f.named_eigenvalues(PRIMES)
        facts.append((f"newform f{n}", f"{values}; {signs}" if signs else values))
    return [Facts(facts, 14)]
