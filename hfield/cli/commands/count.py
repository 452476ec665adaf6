"""``hfield count``: numbers of elements of norm 0, nilpotents, idempotents, units and roots of ±1."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, answer_one, of_parts
from hfield.cli.parser import add_algebra, add_format, add_output, add_standalone, algebra_of

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra
    from hfield.presenting import AnswerSection

HELP = (
    "Count the elements of an algebra over a finite ring by norm and by kind. Closed "
    "formulas give the counts over fields and over ZZ/n; small algebras are also enumerated "
    "to confirm them."
)
DOING = "counting"
EXAMPLES = ("hfield count GF9", "hfield count '[1,1|GF(4))'")
MAX_PAGE_ELEMENTS = 13**4  # elements that the page of `hfield info` goes through
NORMS = 32  # of so many norms over a ring that is not a field the counts are shown


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_algebra(parser, first=True)
    parser.add_argument(
        "--formulas", action="store_true", help="use the formulas only, without enumeration"
    )
    add_format(parser, "plain", "json", "latex")
    add_standalone(parser)
    add_output(parser)


@dataclass
class CountTable:
    """The counts, one a line: kind, number, formula or None; and the number of elements enumerated."""

    algebra: QuaternionAlgebra
    lines: list[tuple[str, int, str | None]]
    exhausted: int | None = None

    def to_json(self) -> dict[str, object]:
        """Return the counts as JSON."""
        rows = [
            {"what": w.replace("−", "-").replace("≠", "!="), "count": n, "formula": formula}
            for w, n, formula in self.lines
        ]
        return {"counts": rows, "confirmed_on": self.exhausted}


def run(args: Namespace) -> int:
    """Count and print."""
    A = algebra_of(args)

    def answer() -> OutputDocument:
        result = counts(A, formulas=args.formulas)
        head = {"schema": "hfield-count/1", "algebra": A.name, "field": A.ring.name}
        return of_parts(
            lambda: {**head, "q": A.ring.order, **result.to_json()},
            lambda: parts(result, f"{A.name}, q = {A.ring.order}"),
        )

    return answer_one(args, answer)


def counts(A: QuaternionAlgebra, formulas: bool = False, quick: bool = False) -> CountTable:
    """Count, and confirm unless ``formulas``. Raises :class:`NotFiniteError` over an infinite ring.

    Over a finite ring that has no formulas (no field, and not ℤ/n) only the exhaustive count answers.
    """
    from hfield.algebra import structure
    from hfield.algebra.structure.counting.tally import LIMIT

    F, c = A.ring, A.constants
    if F.order is not None and not structure.has_formulas(F):
        return _exhausted(A)
    lines: list[tuple[str, int, str | None]] = []

    def add(label: str, kind: str, value: object = None) -> None:
        n, formula = structure.count(F, c, kind, value)
        lines.append((label, n, formula if F.is_field or formula != str(n) else None))

    add("elements", "elements")
    add("units", "units")
    if F.is_field:
        add("norm 0", "norm", 0)
        lines += _norms(A)
    else:
        for x in islice(F.elements(), NORMS):
            add(f"norm {F.text(x)}", "norm", x)
    add("nilpotent", "nilpotent")
    add("idempotent", "idempotent")
    add("square roots of 1", "square roots", 1)
    if F.characteristic != 2:
        add("square roots of −1", "square roots", -1)
    result = CountTable(A, lines)
    assert F.order is not None
    if not formulas and F.order**4 <= (MAX_PAGE_ELEMENTS if quick else LIMIT):
        result.exhausted = structure.confirm(F, c).elements
    return result


def _norms(A: QuaternionAlgebra) -> list[tuple[str, int, str | None]]:
    """Count the elements of each norm that is not 0, over a field."""
    from hfield.algebra import structure

    classes = _classes(A)
    results = [structure.count(A.ring, A.constants, "norm", value) for _, value in classes]
    if len(set(results)) == 1:
        return [("each norm n ≠ 0", *results[0])]
    return [(label, *found) for (label, _), found in zip(classes, results, strict=True)]


def _classes(A: QuaternionAlgebra) -> list[tuple[str, object]]:
    """Return one nonzero scalar of each square class, with how to call the norms in it."""
    F = A.ring
    classes: list[tuple[str, object]] = [("each norm n a square ≠ 0", F.one)]
    if F.characteristic != 2:
        from random import Random

        rng = Random(0)
        while F.sqrt(x := F.random(rng)) is not None:
            pass
        classes.append(("each norm n not a square", x))
    return classes


def _exhausted(A: QuaternionAlgebra) -> CountTable:
    """Count over a finite ring that is not a field by enumerating all elements."""
    from hfield.algebra import structure

    found = structure.tally(A.ring, A.constants)
    lines: list[tuple[str, int, str | None]] = [
        ("elements", found.elements, None),
        ("units", found.units, None),
        *((f"norm {n}", number, None) for n, number in list(found.norms.items())[:NORMS]),
        ("nilpotent", found.nilpotent, None),
        ("idempotent", found.idempotent, None),
        ("square roots of 1", found.roots[A.ring.text(A.ring.one)], None),
        ("square roots of −1", found.roots[A.ring.text(A.ring(-1))], None),
    ]
    return CountTable(A, lines, found.elements)


def parts(result: CountTable, heading: str = "") -> list[AnswerSection]:
    """Return what people read; without a heading as a part of the page about the algebra."""
    from hfield.latex import words
    from hfield.presenting import LayoutBlock, TextTable, hanging

    A, note = result.algebra, _note(result)
    return [
        LayoutBlock(
            lambda _: [heading] * bool(heading),
            lambda: rf"\[ {A.latex()}, \qquad q = {A.ring.order} \]",
        ),
        TextTable(
            [(label, str(n), formula or "") for label, n, formula in result.lines],
            "<>",
            "lrl",
            title="" if heading else "Counts",
            indent="  ",
            cells={2: lambda formula: formula and f"${words(formula).strip('$')}$"},
        ),
        LayoutBlock(
            lambda width: hanging("  ", note, width),
            lambda: rf"\noindent {words(note.capitalize())}.",
        ),
    ]


def _note(result: CountTable) -> str:
    """Say how the counts were found."""
    if result.exhausted is None:
        return "by the formulas; there are too many elements to go through them all here"
    if all(formula is None for _, _, formula in result.lines):
        return f"counted by enumerating all {result.exhausted} elements"
    return f"confirmed by enumerating all {result.exhausted} elements"
