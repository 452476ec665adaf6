"""``hfield classes``: the ideal classes of an Eichler order, by formula and by enumeration."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, of_parts
from hfield.cli.order_arguments import (
    SECONDS_A_CLASS,
    add_answers,
    add_class_search,
    add_where,
    algebra_of,
    announce,
    answer_certified,
    class_data,
    class_search,
    ideal_json,
    level_of,
    unit_groups,
    unit_numbers,
)
from hfield.cli.parser import UsageError
from hfield.cli.status import Waiting

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from hfield.evidence import CertifiedClaim
    from hfield.orders.lattice import ClassSet, Order
    from hfield.orders.newforms import Newform
    from hfield.presenting import AnswerSection

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
    "hfield classes '(-1,t^3+2*t+1|GF(3)(t))'",
)
SHOWN = 40
FORMULA_AND_ENUMERATION = "by Eichler's formula and by enumeration"
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
        help="add the newforms of weight 2 with rational eigenvalues; `hfield newforms` lists all",
    )
    add_class_search(parser)
    add_answers(parser)


def run(args: Namespace) -> int:
    """Count the classes, enumerate them unless --count is given, and print."""
    if args.formula and args.newforms:
        raise UsageError(
            "--newforms needs the classes, and --formula does not enumerate them: leave one of them out"
        )
    if args.formula and args.certificate is not None:
        raise UsageError(
            "--certificate needs the classes, and --formula does not enumerate them: leave one of them out"
        )
    with class_search(args) as executor:
        return answer_certified(args, partial(_answer, executor=executor))


def _answer(
    args: Namespace, executor: Executor | None
) -> tuple[OutputDocument, Callable[[], CertifiedClaim]]:
    from hfield.orders.mass_formula import class_number_by_formula

    A = algebra_of(args.algebra)
    O = A.eichler_order(level_of(args.level, A))
    if not O.is_definite():
        return _indefinite(args, O)
    number = class_number_by_formula(O.value)
    if not args.formula:
        if number is not None:
            announce(number, number * SECONDS_A_CLASS, "--formula enumerates none")
        return _enumerated(args, O.class_set(executor=executor, file=args.resume), number)
    if number is None:
        raise UsageError(
            "--formula is for algebras over QQ; over other fields the classes are enumerated, up to the mass"
        )

    def parts() -> list[AnswerSection]:
        from hfield.presenting import Facts

        return [Facts(_facts(O, f"{number}, by Eichler's formula"), 14)]

    return of_parts(lambda: _data(O, number), parts), lambda: O.claim


def _data(O: Order, number: int) -> dict[str, object]:
    """Return the invariants that need no enumeration of classes, as JSON data."""
    return {
        "schema": "hfield-classes/1",
        "algebra": str(O.algebra),
        "discriminant": ideal_json(O.value.ambient.discriminant),
        "level": ideal_json(O.level),
        "class_number": number,
        "mass": str(O.mass()),
    }


def _facts(O: Order, number: str) -> list[tuple[str, str]]:
    """Return the invariants as lines of text; ``number`` is the class number and the formula used."""
    base = O.value.ambient.base
    return [
        ("algebra", f"{O.algebra}, discriminant {O.value.ambient.discriminant}, level {O.level}"),
        ("class number", number),
        ("mass", f"{O.mass()}, the sum of 1/[units : units of {base.symbol}]"),
    ]


def _enumerated(
    args: Namespace, C: ClassSet, number: int | None
) -> tuple[OutputDocument, Callable[[], CertifiedClaim]]:
    """Answer with the list of classes; ``number`` is the class number by a formula, if there is one."""
    from hfield.orders.lattice_values import rows_json

    O = C.order

    def data() -> dict[str, object]:
        classes = [
            {**class_data(I), "units": units, "group": group, "type": kind}
            for I, units, group, kind in zip(
                C, unit_numbers(C), unit_groups(C), C.types, strict=True
            )
        ]
        return {
            **_data(O, len(C)),
            "type_number": C.type_number,
            "stable_classes": C.stable_classes(),
            "order": rows_json(O.value),
            "classes": classes,
            **(_forms_data(C) if args.newforms else {}),
        }

    def parts() -> list[AnswerSection]:
        from hfield.presenting import Facts

        how = "by enumeration up to the mass" if number is None else FORMULA_AND_ENUMERATION
        cancels = ": cancellation" if C.has_cancellation() else ""
        facts = [
            *_facts(O, f"{len(C)}, {how}"),
            ("type number", str(C.type_number)),
            ("stable classes", f"{O.stable_class_number()}, where I ~ J if I ⊕ O ≅ J ⊕ O{cancels}"),
        ]
        forms = _forms(C) if args.newforms else []
        return [Facts(facts, 14), _table(C), *_types(C), *forms]

    return of_parts(data, parts), lambda: C.claim


def _table(C: ClassSet) -> AnswerSection:
    """Return a table of the first classes; ideals with a basis of four elements have a reduced basis."""
    from hfield.presenting import TextTable

    some = list(islice(C, SHOWN))
    bases = [", ".join(map(str, I.reduced_basis())) if len(I.basis) == 4 else "" for I in some]
    rows = [
        [str(n), str(I.norm()), str(units), group, str(kind), basis]
        for n, (I, units, group, kind, basis) in enumerate(
            zip(some, unit_numbers(C), unit_groups(C), C.types, bases, strict=False)
        )
    ]
    head = ("class", "norm", "units", "group", "type", "reduced basis")
    columns = 6 if any(bases) else 5
    more = len(C) - SHOWN
    return TextTable(
        [row[:columns] for row in rows],
        "><>>>"[: columns - 1],
        "rlrlr",
        head=head[:columns],
        below=f"… and {more} more; --format json lists all" if more > 0 else "",
        cells={3: lambda group: rf"$\mathrm{{{group}}}$"},
    )


def _types(C: ClassSet) -> list[AnswerSection]:
    """Return the types in the order of their labels; nothing if they are too many or have no labels."""
    from hfield.errors import UndecidedError
    from hfield.presenting import TextTable

    if C.type_number > SHOWN:
        return []
    try:
        labels = C.types_by_label()
    except UndecidedError:
        return []
    rows = [
        [str(C.types[numbers[0]]), str(len(numbers)), label] for label, numbers in labels.items()
    ]
    return [TextTable(rows, ">>", "rrl", head=("type", "classes", "label of the left orders"))]


def _indefinite(args: Namespace, O: Order) -> tuple[OutputDocument, Callable[[], CertifiedClaim]]:
    """Answer by strong approximation, if an infinite place splits."""
    from hfield.evidence import CertifiedClaim
    from hfield.orders.certificates import REFUSAL

    A = O.algebra
    if args.newforms:
        raise UsageError(f"--newforms needs a definite algebra, and {A} is indefinite")
    ideals = O.classes_by_norm()

    def data() -> dict[str, object]:
        return {
            "schema": "hfield-classes/1",
            "algebra": str(A),
            "discriminant": ideal_json(O.value.ambient.discriminant),
            "level": ideal_json(O.level),
            "class_number": len(ideals),
            "type_number": ideals.type_number,
            "classes": [class_data(I) for I in ideals],
        }

    def parts() -> list[AnswerSection]:
        from hfield.presenting import Facts

        facts = [
            ("algebra", f"{A}, discriminant of the order {O.discriminant()}: indefinite"),
            (
                "class number",
                f"{len(ideals)}, by strong approximation: the reduced norm determines the class",
            ),
            ("type number", str(ideals.type_number)),
            ("norms", ", ".join(str(I.norm()) for I in islice(ideals, SHOWN))),
        ]
        return [Facts(facts, 14)]

    claim = CertifiedClaim(A, "classes", {}, "strong approximation", refusal=REFUSAL)
    return of_parts(data, parts), lambda: claim


def _newforms(C: ClassSet) -> list[Newform]:
    """Return the newforms with rational eigenvalues."""
    Waiting.at("computing newforms")
    return [f for f in C.newforms() if f.degree == 1]


def _forms_data(C: ClassSet) -> dict[str, object]:
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


def _forms(C: ClassSet) -> list[AnswerSection]:
    """Return dimensions and newforms, as parts."""
    from hfield.presenting import Facts

    dimensions = (
        f"{C.cusp_dimension()}, newforms among them {C.new_dimension()}; rational ones below, with "
        "eigenvalues a_p and Atkin–Lehner signs w_p"
    )
    facts = [("cusp forms", dimensions)]
    for n, f in enumerate(_newforms(C), 1):
        signs = ", ".join(f"w_{P} = {w}" for P, w in f.signs.items())
        values = f.named_eigenvalues(PRIMES)
        facts.append((f"newform f{n}", f"{values}; {signs}" if signs else values))
    return [Facts(facts, 14)]
