"""``hfield newforms``: Galois orbits of newforms, from the ideal classes of an Eichler order."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from hfield.cli.answer_formats import OutputDocument, of_parts
from hfield.cli.order_arguments import (
    SECONDS_A_CLASS,
    add_answers,
    add_where,
    algebra_of,
    announce,
    answer_certified,
    ideal_json,
    level_of,
)
from hfield.cli.parser import UsageError, whole
from hfield.cli.status import Waiting

if TYPE_CHECKING:
    from hfield.evidence import CertifiedClaim
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.orders.lattice import ClassSet
    from hfield.orders.newforms import Newform
    from hfield.presenting import AnswerSection

HELP = (
    "List the newforms of weight k that an Eichler order gives, one for each Galois orbit: the field of the "
    "eigenvalues, eigenvalues a_P, and Atkin–Lehner signs w_P. Over QQ they are all newforms of level "
    "D·N, where D is the discriminant of the algebra and N the level of the order, with q-expansions and the "
    "labels of the LMFDB. Over a totally real field they are Hilbert modular forms of parallel weight. "
    "--certificate FILE writes a proof that these are all orbits, with their eigenvalues and signs: over QQ "
    "in weights up to 100, over totally real fields in weight 2."
)
DOING = "enumerating classes"
EXAMPLES = (
    "hfield newforms 389",
    "hfield newforms 3 --level 5 --weight 4 --primes 100",
    "hfield newforms '(-1,-1|QQ(sqrt(5)))' --level '6 + sqrt(5)' --certificate newforms.json",
)
MAX_WEIGHT = 1_000
MAX_PRIME = 10**5
MAX_DIMENSION = 10_000
"""Larger spaces are not split: a matrix of so many rows takes a gigabyte."""
MAX_SHOWN_DEGREE = 6
"""Of newforms of a larger degree the page shows traces of eigenvalues."""
TERMS = 10
"""The page shows q-expansions up to this power of q."""
SECONDS_A_CUBE = 4e-8
"""The time to split a space, divided by the cube of its dimension."""


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_where(parser)
    parser.add_argument(
        "--weight",
        metavar="K",
        type=whole(2, MAX_WEIGHT),
        default=2,
        help="the weight, an even number, the same at all real places (default: 2)",
    )
    parser.add_argument(
        "--primes",
        metavar="B",
        type=whole(2, MAX_PRIME),
        default=20,
        help="print eigenvalues at the primes of norm up to B (default: 20)",
    )
    add_answers(parser)


def run(args: Namespace) -> int:
    """Compute the newforms, and print them."""
    return answer_certified(args, _answer)


def _answer(args: Namespace) -> tuple[OutputDocument, Callable[[], CertifiedClaim]]:
    A = algebra_of(args.algebra)
    level, k = level_of(args.level, A), args.weight
    O = A.eichler_order(level)
    if not A.is_over_number_field and O.is_definite():
        number = A.class_number(level)
        dimension = number * (k - 1)
        if dimension > MAX_DIMENSION:
            raise UsageError(
                f"there are {number} classes by Eichler's formula, so the space of forms has about "
                f"{dimension} dimensions: spaces of at most {MAX_DIMENSION} are split"
            )
        seconds = number * SECONDS_A_CLASS + dimension**3 * SECONDS_A_CUBE
        announce(number, seconds, "hfield classes --formula counts them")
    C = O.class_set()
    Waiting.at("computing newforms")
    forms = C.newforms(weight=k)
    document = of_parts(
        lambda: _data(C, k, forms, args.primes), lambda: _parts(C, k, forms, args.primes)
    )
    return document, lambda: C.claim_of_newforms(k, args.primes, signs=True)


def _data(C: ClassSet, k: int, forms: list[Newform], bound: int) -> dict[str, object]:
    """Return the newforms as JSON data; an eigenvalue is an int, or coefficients of powers of the root."""
    A: Any = C.order.algebra
    if A.is_over_number_field:
        discriminant: object = [str(P) for P in A.discriminant()]
    else:
        discriminant = ideal_json(C.order.value.ambient.discriminant)
    return {
        "schema": "hfield-newforms/1",
        "algebra": str(A),
        "discriminant": discriminant,
        "level": ideal_json(C.order.level),
        "weight": k,
        "cusp_dimension": C.cusp_dimension(weight=k),
        "new_dimension": C.new_dimension(weight=k),
        "newforms": [_form_data(f, bound) for f in forms],
    }


def _form_data(f: Newform, bound: int) -> dict[str, object]:
    def number(a: int | FieldElement) -> object:
        return a if isinstance(a, int) else a.field.coordinates(a)

    return {
        "label": f.label,
        "degree": f.degree,
        "field": [0, 1] if f.degree == 1 else f.field.data["modulus"],
        "signs": {str(P): sign for P, sign in f.signs.items()},
        "eigenvalues": {str(P): number(a) for P, a in f.eigenvalues_up_to(bound).items()},
    }


def _parts(C: ClassSet, k: int, forms: list[Newform], bound: int) -> list[AnswerSection]:
    from hfield.presenting import Facts

    O = C.order
    orbits = "1 Galois orbit" if len(forms) == 1 else f"{len(forms)} Galois orbits"
    dimensions = (
        f"{C.cusp_dimension(weight=k)} of weight {k}, newforms among them {C.new_dimension(weight=k)}, in "
        f"{orbits}"
    )
    facts = [("order", str(O)), ("classes", str(len(C))), ("cusp forms", dimensions)]
    titles = (f.label or f"f{n}" for n, f in enumerate(forms, 1))
    return [
        Facts(facts, 12),
        *(Facts(_facts(f, bound), 12, title) for f, title in zip(forms, titles, strict=True)),
    ]


def _facts(f: Newform, bound: int) -> list[tuple[str, str]]:
    """Return the text output for a newform."""
    facts = [("signs", ", ".join(f"w_{P} = {w}" for P, w in f.signs.items()))] if f.signs else []
    if f.degree > MAX_SHOWN_DEGREE:
        traces = ", ".join(f"a_{P} = {t}" for P, t in f.traces_up_to(bound).items())
        return [("degree", str(f.degree)), ("traces", traces), *facts]
    values = ", ".join(f"a_{P} = {a}" for P, a in f.eigenvalues_up_to(bound).items())
    facts = [("field", str(f.field)), ("eigenvalues", values), *facts]
    return [*facts, ("q-expansion", f.q_expansion(TERMS))] if f.label else facts
