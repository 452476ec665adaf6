"""Storage of elements over a small GF(pⁿ) as four labels, with tables of products and sums."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import BINARY, FIRST, GENERAL, pattern, specialise
from hfield.fields.base.storage.compact import Compact, function, statements

if TYPE_CHECKING:
    import flint

    from hfield.fields.finite.ring import ExtensionField

BELOW = 257  # the orders that have tables, q² entries each

LabelTuple = tuple[int, int, int, int]
Rows = list[list[int]]


@dataclass(frozen=True)
class ElementTables:
    """The arithmetic of GF(q) on labels, whose base-p digits are the coefficients.

    ``times[u][v]``, ``plus[u][v]``, ``minus[u][v]``, ``negative[u]``, ``inverse[u]`` (0 for 0) are labels;
    ``elements`` maps labels to flint's elements.
    """

    times: Rows
    plus: Rows
    minus: Rows
    negative: list[int]
    inverse: list[int]
    elements: list[flint.fq_default]


def tables(field: ExtensionField) -> ElementTables:
    """Compute the tables: powers of a generator, and sums digit by digit."""
    p, q = field.characteristic, field.order
    elements = list(field.elements())
    powers = _powers(field, elements)
    exponent = {u: n for n, u in enumerate(powers)}
    cycle = powers + powers
    others = [exponent[u] for u in range(1, q)]
    times = [[0] * q]
    times += [[0, *(cycle[exponent[u] + n] for n in others)] for u in range(1, q)]
    plus = digits = [[(u + v) % p for v in range(p)] for u in range(p)]
    while len(plus) < q:
        plus = [[s * p + d for s in high for d in low] for high in plus for low in digits]
    negative = [row.index(0) for row in plus]
    minus = [[row[v] for v in negative] for row in plus]
    inverse = [0, *(powers[-exponent[u] % (q - 1)] for u in range(1, q))]
    return ElementTables(times, plus, minus, negative, inverse, elements)


def _powers(field: ExtensionField, elements: list[flint.fq_default]) -> list[int]:
    """Return the labels of 1, g, g², …, all nonzero elements, for the first g whose powers they are."""
    one = elements[1]
    for g in elements[2:]:
        powers, x = [1], g
        while x != one:
            powers.append(field.label(x))
            x = x * g
        if len(powers) == len(elements) - 1:
            return powers
    raise AssertionError("the multiplicative group of a finite field is cyclic")


class Labels(Compact[LabelTuple, "flint.fq_default"]):
    """Storage of elements over a small GF(pⁿ) as four labels, with tables of products and sums."""

    def __init__(self, ring: ExtensionField, constants: Constants) -> None:
        super().__init__(ring, constants)
        self.p, self.tables, self._label = ring.characteristic, ring.tables, ring.label
        self.pattern = pattern(constants, lambda x, k: x == ring(k))

    def encode(self, coordinates: Coordinates) -> LabelTuple:
        """Return the element with these coordinates in GF(q)."""
        w, x, y, z = coordinates
        label = self._label
        return label(w), label(x), label(y), label(z)

    def whole(self, w: int, x: int, y: int, z: int) -> LabelTuple:
        """Return the labels of four integers."""
        p = self.p
        return w % p, x % p, y % p, z % p

    def coordinates(self, stored: LabelTuple) -> Coordinates:
        """Return the four coordinates, flint's elements."""
        w, x, y, z = stored
        element = self.tables.elements
        return element[w], element[x], element[y], element[z]

    def names(self) -> dict[str, object]:
        """Return the tables, and the rows of the multiplication table that belong to the constants."""
        t = self.tables
        rows = {f"T{n}": t.times[self._label(c)] for n, c in self.constants._asdict().items()}
        return rows | {
            "T": t.times,
            "plus": t.plus,
            "minus": t.minus,
            "opposite": t.negative,
            "inverse_of": t.inverse,
            "element": t.elements,
        }

    def source(self, operation: str) -> str:
        """Return the source text of an operation on four labels."""
        formula = "adjoint" if operation == "inverse" else operation
        program = specialise(formula, self.pattern, 2 if self.p == 2 else 0)
        outputs, last = ENDS.get(operation, ((*"wxyz",), ["return w, x, y, z"]))
        body = statements(program, outputs, self._write)
        rows = [f"T{n} = T[{n}]" for n in FIRST if f"T{n}[" in "".join(body)]
        operands = {"p": "w1, x1, y1, z1"}
        if operation in BINARY:
            operands["q"] = "w2, x2, y2, z2"
        return function(operation, operands, [*rows, *body, *last])

    def _write(self, operation: str, operands: Sequence[str]) -> str:
        """Return an operation on labels as a table look-up; in characteristic 2 a sum is an exclusive or."""
        if operation == "neg":
            return f"opposite[{operands[0]}]"
        left, right = operands
        if operation == "*":
            if right in ROWS and left not in ROWS:
                left, right = right, left
            return f"T{left}[{right}]" if left in ROWS else f"T[{left}][{right}]"
        if self.p == 2:
            return f"{left} ^ {right}"
        return f"{'plus' if operation == '+' else 'minus'}[{left}][{right}]"

    def scaled(self, p: LabelTuple, s: flint.fq_default) -> LabelTuple:
        """Return s·p for an element s of the field."""
        (w, x, y, z), row = p, self.tables.times[self._label(s)]
        return row[w], row[x], row[y], row[z]

    def is_zero(self, p: LabelTuple) -> bool:
        """Return whether p = 0."""
        return p == (0, 0, 0, 0)

    def key(self, p: LabelTuple) -> LabelTuple:
        """Return p itself."""
        return p


ROWS = {*FIRST, *GENERAL}  # names whose row in the table of products is at hand
INVERTED = [
    "if s == 0:",
    "    return None",
    "row = T[inverse_of[s]]",
    "return row[w], row[x], row[y], row[z]",
]
# For operations that do not return four labels: the names of their outputs, and the code that
# follows.
ENDS = {
    "norm": (("s",), ["return element[s]"]),
    "trace": (("s",), ["return element[s]"]),
    "inverse": ((*"wxyz", "s"), INVERTED),
}
