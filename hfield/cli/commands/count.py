"""``hfield count``: numbers of elements of norm 0, nilpotents, idempotents, units and roots of ±1."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument, answer_one, of_parts
from hfield.cli.parser import add_algebra, add_format, add_output, add_standalone, algebra_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from hfield.algebra import QuaternionAlgebra
    from hfield.algebra.structure.counting.counted_kinds import CountedKind
    from hfield.core.product import Scalar
    from hfield.fields.base.ring import Ring
    from hfield.presenting import AnswerSection

    Number = tuple[int, str | None]  # how many, and the formula
    Line = tuple[str, int, str | None]

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
    """The counts, one per line: kind, number, formula or None; and the number of elements enumerated."""

    algebra: QuaternionAlgebra
    lines: list[Line]
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

    Over a finite ring without formulas (neither a field nor ℤ/n) only enumeration is used.
    """
    from hfield.algebra import structure
    from hfield.algebra.structure.counting.tally import LIMIT

    F, c = A.ring, A.constants
    if F.order is not None and not structure.has_formulas(F):
        found = structure.tally(F, c)
        lines = _lines(A, lambda kind, x: (found.number(kind, F.text(x)), None))
        return CountTable(A, lines, found.elements)

    def by_formula(kind: str, x: Scalar) -> Number:
        n, formula = structure.count(F, c, kind, x)
        return n, formula if F.is_field or formula != str(n) else None

    result = CountTable(A, _lines(A, by_formula))
    assert F.order is not None
    if not formulas and F.order**4 <= (MAX_PAGE_ELEMENTS if quick else LIMIT):
        result.exhausted = structure.confirm(F, c).elements
    return result


def _lines(A: QuaternionAlgebra, number: Callable[[str, Scalar], Number]) -> list[Line]:
    """Return the lines of a table: each kind, for each of its scalars, with its count by ``number``."""
    from hfield.algebra.structure.counting.counted_kinds import KINDS

    lines: list[Line] = []
    for kind in KINDS.values():
        if kind.name == "norm" and A.ring.is_field:
            lines += _norms(A, number)
        elif kind.needs:
            lines += [(label, *number(kind.name, x)) for label, x in _labelled(A.ring, kind)]
        else:
            lines.append((kind.name, *number(kind.name, A.ring.zero)))
    return lines


def _labelled(F: Ring, kind: CountedKind) -> Iterator[tuple[str, Scalar]]:
    """Yield the scalars that have a line in the table of a kind, with labels."""
    if not kind.scalars:
        yield from ((kind.label.format(F.text(x)), x) for x in islice(F.elements(), NORMS))
    for n in kind.scalars:
        if n != -1 or F.characteristic != 2:  # there it is 1
            yield kind.label.format(str(n).replace("-", "−")), F(n)


def _norms(A: QuaternionAlgebra, number: Callable[[str, Scalar], Number]) -> list[Line]:
    """Return the lines for norms over a field: norm 0, and one line per square class of nonzero norms."""
    zero = ("norm 0", *number("norm", A.ring.zero))
    classes = _classes(A)
    results = [number("norm", x) for _, x in classes]
    if len(set(results)) == 1:
        return [zero, ("each norm n ≠ 0", *results[0])]
    return [zero, *((label, *found) for (label, _), found in zip(classes, results, strict=True))]


def _classes(A: QuaternionAlgebra) -> list[tuple[str, Scalar]]:
    """Return one nonzero scalar of each square class, with a label for the norms in the class."""
    F = A.ring
    classes: list[tuple[str, Scalar]] = [("each norm n a square ≠ 0", F.one)]
    if F.characteristic != 2:
        from random import Random

        rng = Random(0)
        while F.sqrt(x := F.random(rng)) is not None:
            pass
        classes.append(("each norm n not a square", x))
    return classes


def parts(result: CountTable, heading: str = "") -> list[AnswerSection]:
    """Return the text output; without a heading, as a section of the page about the algebra."""
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
    """Describe how the counts were computed."""
    if result.exhausted is None:
        return "by formulas, not confirmed by enumeration"
    if all(formula is None for _, _, formula in result.lines):
        return f"counted by enumerating all {result.exhausted} elements"
    return f"confirmed by enumerating all {result.exhausted} elements"
