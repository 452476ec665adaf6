"""Write statements as MathML for web pages."""

from __future__ import annotations

from fractions import Fraction
from html import escape

from hfield.prover.statements.printing import (
    POSTFIX,
    SHORT_FUNCTIONS,
    UNICODE_SIGNS,
    PlainTextWriter,
)
from hfield.syntax import ORDER, Binary, Node

BREAKABLE = ("<=>", "=>", "or", "and", "==", "!=", *ORDER, "+", "-")


def to_mathml(node: Node) -> str:
    """Write ``node`` as MathML: formulas in a row, so that lines may break before an operator.

    >>> from hfield.syntax import parse
    >>> to_mathml(parse("p == -q**2"))
    '<math><mi>p</mi></math> <math><mo form="infix">=</mo><mo>−</mo><msup><mi>q</mi><mn>2</mn></msup></math>'
    """
    return " ".join(f"<math>{piece}</math>" for piece in _MathML(node).pieces(node))


class _MathML(PlainTextWriter):
    def pieces(self, node: Node, floor: int = -1) -> list[str]:
        """Return the parts that must stay on one line, in order; each but the first begins with an
        operator.
        """
        joined = self.infix(node)
        if joined is None or joined[2] not in BREAKABLE or self.precedence(node) < floor:
            return [self.write(node, floor)]
        x, left, op, y, right = joined
        first, *rest = self.pieces(y, right)
        # As the first of its group it would lose the spaces of an infix operator.
        sign = self.operator(op).replace("<mo>", '<mo form="infix">')
        return [*self.pieces(x, left), sign + first, *rest]

    def bare(self, node: Node) -> str:
        if isinstance(node, Binary) and node.op == "/":
            return f"<mfrac>{_row(self.write(node.left))}{_row(self.write(node.right))}</mfrac>"
        return super().bare(node)

    def operator(self, op: str) -> str:
        sign = {"neg": "−", "not": "¬"}.get(op) or UNICODE_SIGNS[op].strip()
        return f"<mo>{escape(sign)}</mo>"

    def group(self, text: str) -> str:
        tall = "" if "<mfrac>" in text else ' stretchy="false"'
        return f"<mrow><mo{tall}>(</mo>{text}<mo{tall}>)</mo></mrow>"

    def number(self, value: int | Fraction) -> str:
        return f"<mn>{super().number(value)}</mn>"

    def name(self, name: str) -> str:
        return f"<mi>{escape(name)}</mi>"

    def power(self, base: str, exponent: int) -> str:
        sign = "<mo>−</mo>" if exponent < 0 else ""
        return f"<msup>{_row(base)}{_row(f'{sign}<mn>{abs(exponent)}</mn>')}</msup>"

    def index(self, base: str, index: int) -> str:
        return f"<msub>{_row(base)}<mn>{index}</mn></msub>"

    def call(self, function: str, arguments: tuple[Node, ...]) -> str:
        inside = "<mo>,</mo>".join(self.write(x) for x in arguments)
        match function:
            case "conj":
                return f'<mover accent="true">{_row(inside)}<mo stretchy="true">¯</mo></mover>'
            case "inv":
                return self.power(self.write(arguments[0], POSTFIX), -1)
            case "comm":
                return f"<mrow><mo>[</mo>{inside}<mo>]</mo></mrow>"
            case "sqrt":
                return f"<msqrt>{inside}</msqrt>"
        name = SHORT_FUNCTIONS.get(function, function)
        return f"<mi>{escape(name)}</mi>{self.group(inside)}"

    def exists(self, names: tuple[str, ...], body: str) -> str:
        listed = "<mo>,</mo>".join(map(self.name, names))
        return f"<mo>∃</mo>{listed}<mo>:</mo>{body}"


def _row(text: str) -> str:
    """Group several elements into one, as scripts and fractions require."""
    return text if text.count("<m") == 1 else f"<mrow>{text}</mrow>"
