"""``hfield field``: the ring of integers, class group and unit group of a number field."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from hfield.cli.answer_formats import OutputDocument, of_parts
from hfield.cli.order_arguments import add_answers, answer_certified, ideal_json
from hfield.cli.parser import UsageError
from hfield.errors import shorten

if TYPE_CHECKING:
    from hfield.evidence import CertifiedClaim
    from hfield.fields.number_fields.classes.class_groups import ClassGroup
    from hfield.fields.number_fields.ring import NumberField
    from hfield.presenting import AnswerSection

HELP = (
    "Compute the discriminant, ring of integers, class group, narrow class group, unit "
    "group and regulator of a number field. The results are proved without hypotheses. The "
    "certificate is about the class group, or with --units about the unit group."
)
DOING = "computing classes and units"
EXAMPLES = (
    "hfield field 'QQ(sqrt(10))'",
    "hfield field 'QQ[s]/(s^3-s^2-4*s-1)' --units --certificate units.json",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("field", metavar="F", help="such as 'QQ(sqrt(10))' or 'QQ[s]/(s^3-2)'")
    parser.add_argument(
        "--units", action="store_true", help="write the certificate about the unit group"
    )
    add_answers(parser)


def run(args: Namespace) -> int:
    """Compute the groups, and print them."""
    return answer_certified(args, _answer)


def _answer(args: Namespace) -> tuple[OutputDocument, Callable[[], CertifiedClaim]]:
    from hfield.fields.names import ring

    K: Any = ring(args.field)
    if not hasattr(K, "class_group"):
        raise UsageError(
            f"{shorten(K.name)} is not a number field; expected one such as QQ(sqrt(10))"
        )
    group, units = K.class_group(), K.unit_group()
    answer = of_parts(lambda: to_json(K), lambda: parts(K))
    return answer, lambda: (units if args.units else group).claim


def to_json(K: NumberField) -> dict[str, object]:
    """Return the JSON data."""
    units = K.unit_group()

    def group(found: ClassGroup) -> dict[str, object]:
        return {
            "order": found.order,
            "invariants": list(found.invariants),
            "generators": list(map(ideal_json, found.generators)),
        }

    return {
        "schema": "hfield-field/1",
        "kind": "number field",
        "field": K.name,
        "degree": K.degree,
        "real_places": len(K.real_places()),
        "discriminant": int(K.discriminant()),
        "integral_basis": [K.text(x) for x in K.integral_basis()],
        "class_group": group(K.class_group()),
        "narrow_class_group": group(K.narrow_class_group()),
        "units": {
            "rank": units.rank,
            "torsion": units.torsion_order,
            "generators": [K.text(u) for u in units.generators],
            "regulator": units.regulator.str(15, radius=False),
        },
    }


def parts(K: NumberField) -> list[AnswerSection]:
    """Return the text output."""
    from hfield.presenting import Facts

    real, units = len(K.real_places()), K.unit_group()

    def group(found: ClassGroup) -> str:
        pairs = zip(found.invariants, found.generators, strict=True)
        return " × ".join(f"ℤ/{d} of {a}" for d, a in pairs) or "trivial"

    free = ", ".join(K.text(u) for u in units.generators)
    facts = [
        ("field", f"{K.name}, degree {K.degree}, real places: {real}"),
        ("discriminant", str(K.discriminant())),
        ("integers", f"ℤ⟨{', '.join(K.text(x) for x in K.integral_basis())}⟩"),
        ("class group", group(K.class_group())),
        ("narrow class group", group(K.narrow_class_group())),
        ("roots of unity", f"{units.torsion_order}, powers of {K.text(units.torsion)}"),
        ("units", f"rank {units.rank}{': ' * bool(free)}{free}"),
        ("regulator", units.regulator.str(15, radius=False)),
    ]
    return [Facts(facts, 16)]
