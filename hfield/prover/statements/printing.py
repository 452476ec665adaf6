"""Write statements as plain text, Unicode and LaTeX."""

from fractions import Fraction
from functools import cached_property
from typing import TypeGuard

from hfield.prover.statements.matrices import ENTRIES
from hfield.prover.statements.trees import walk_once
from hfield.syntax import (
    Binary,
    Call,
    Compare,
    Exists,
    Index,
    Logic,
    Name,
    Negate,
    Node,
    Not,
    Number,
    Power,
)

# Precedence of each kind of node; a child with lower precedence gets parentheses.
IFF, IMPLIES, OR, AND, NOT, COMPARE, SUM, PRODUCT, UNARY, POWER, POSTFIX = range(11)
_OPERATORS = {"<=>": IFF, "=>": IMPLIES, "or": OR, "and": AND}
_OPERATORS |= {"+": SUM, "-": SUM, "*": PRODUCT, "/": PRODUCT}
_BINDS: dict[type[Node], int] = {
    Exists: -1,
    Not: NOT,
    Compare: COMPARE,
    Negate: UNARY,
    Power: POWER,
    Index: POSTFIX,
    Call: POSTFIX,
    Name: POSTFIX,
    Number: POSTFIX,
}
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
UNICODE_SIGNS = {
    "<=>": " ⇔ ",
    "=>": " ⇒ ",
    "or": " ∨ ",
    "and": " ∧ ",
    "==": " = ",
    "!=": " ≠ ",
    ">=": " ≥ ",
    ">": " > ",
    "<=": " ≤ ",
    "<": " < ",
    "+": " + ",
    "-": " − ",
    "*": "·",
    "/": "/",
}
_LATEX = {
    "<=>": r" \Leftrightarrow ",
    "=>": r" \Rightarrow ",
    "or": r" \lor ",
    "and": r" \land ",
    "==": " = ",
    "!=": r" \neq ",
    ">=": r" \geq ",
    ">": " > ",
    "<=": r" \leq ",
    "<": " < ",
    "+": " + ",
    "-": " - ",
    "*": r" \cdot ",
    "/": "/",
}
SEPARATORS = {"matrix": (" & ", r" \\ ", " & "), "row": (" & ",), "column": (r" \\ ",)}
SHORT_FUNCTIONS = {"norm": "N", "trace": "tr", "scalar": "Sc", "vector": "Vec"}


def to_text(node: Node) -> str:
    """Write ``node`` in the statement language: ``parse(to_text(node)) == node``."""
    return PlainTextWriter(node).write(node)


def to_unicode(node: Node) -> str:
    """Write ``node`` for a terminal, such as ``(p·q)·r = p·(q·r)``."""
    return _Unicode(node).write(node)


def to_latex(node: Node) -> str:
    r"""Write ``node`` in LaTeX math mode, such as ``\overline{p \cdot q}``."""
    return _Latex(node).write(node)


def _precedence(node: Node) -> int:
    return _OPERATORS[node.op] if isinstance(node, Binary | Logic) else _BINDS[type(node)]


def _is_product(node: Node) -> TypeGuard[Binary]:
    return isinstance(node, Binary) and node.op == "*"


class PlainTextWriter:
    """The writer of plain text; subclasses override how single parts are written.

    If a product is the right factor of another, as in ``p·(q·r)``, all nested products get parentheses,
    because then the statement is about their order.
    """

    def __init__(self, node: Node) -> None:
        self.root = node
        self.written: dict[int, tuple[Node, str]] = {}  # trees share nodes: each is written once

    @cached_property
    def nested(self) -> bool:
        """Whether right factors that are products are parenthesised."""
        return any(_is_product(n) and _is_product(n.right) for n in walk_once(self.root))

    def write(self, node: Node, floor: int = -1) -> str:
        """Write a node, in parentheses if its precedence is below ``floor``."""
        if isinstance(node, Name):
            return self.name(node.name)
        if (known := self.written.get(id(node))) is None:
            known = self.written[id(node)] = node, self.bare(node)
        return self.group(known[1]) if self.precedence(node) < floor else known[1]

    def precedence(self, node: Node) -> int:
        """Return the precedence of a node."""
        return _precedence(node)

    def bare(self, node: Node) -> str:
        """Write a node without parentheses around it."""
        if (joined := self.infix(node)) is not None:
            x, left, op, y, right = joined
            return self.write(x, left) + self.operator(op) + self.write(y, right)
        match node:
            case Number(value):
                return self.number(value)
            case Negate(x):
                return self.operator("neg").strip() + self.write(x, UNARY)
            case Power(x, exponent):
                return self.power(self.write(x, POSTFIX), exponent)
            case Index(x, index):
                return self.index(self.write(x, POSTFIX), index)
            case Call(function, arguments):
                return self.call(function, arguments)
            case Not(x):
                return self.operator("not") + self.write(x, NOT)
            case Exists(names, x):
                return self.exists(names, self.write(x))
        raise AssertionError(node)

    def infix(self, node: Node) -> tuple[Node, int, str, Node, int] | None:
        """Split an infix node into its sides, each with the precedence below which it is parenthesised."""
        match node:
            case Binary(op, x, y):
                floor = _OPERATORS[op]
                # A unary minus on the right would read back, but two signs in a row read badly.
                right = max(floor + 1, POWER if isinstance(y, Negate) else 0)
                if op == "*" and _is_product(x) and self.nested:
                    floor += 1
                return x, floor, op, y, right
            case Compare(op, x, y):
                return x, SUM, op, y, SUM
            case Logic(op, x, y):
                floor = _OPERATORS[op]
                left = floor if op in ("and", "or") else floor + 1
                right = floor if op == "=>" else floor + 1
                return x, left, op, y, right
        return None

    def operator(self, op: str) -> str:
        """Write an operator with the blanks around it."""
        if op == "neg":
            return "-"
        if op == "not":
            return "not "
        return op if op in "*/" else f" {op} "

    def group(self, text: str) -> str:
        """Parenthesise a written part."""
        return f"({text})"

    def number(self, value: int | Fraction) -> str:
        """Write a number."""
        if isinstance(value, int):
            return str(value)
        # A fraction comes from a decimal literal, so some power of ten clears its denominator.
        places = next(n for n in range(10**5) if 10**n % value.denominator == 0)
        digits = str(value.numerator * (10**places // value.denominator)).rjust(places + 1, "0")
        return f"{digits[:-places]}.{digits[-places:]}" if places else f"{digits}.0"

    def name(self, name: str) -> str:
        """Write a name."""
        return name

    def power(self, base: str, exponent: int) -> str:
        """Write a power."""
        return f"{base}**{exponent}"

    def index(self, base: str, index: int) -> str:
        """Write a coordinate."""
        return f"{base}[{index}]"

    def call(self, function: str, arguments: tuple[Node, ...]) -> str:
        """Write the call of a function."""
        return f"{function}({', '.join(self.write(x) for x in arguments)})"

    def exists(self, names: tuple[str, ...], body: str) -> str:
        """Write an existential statement."""
        return f"exists {', '.join(names)}: {body}"


class _Unicode(PlainTextWriter):
    def operator(self, op: str) -> str:
        return {"neg": "−", "not": "¬"}.get(op) or UNICODE_SIGNS[op]

    def power(self, base: str, exponent: int) -> str:
        return base + str(exponent).translate(_SUPERSCRIPTS)

    def index(self, base: str, index: int) -> str:
        return base + "₀₁₂₃"[index]

    def call(self, function: str, arguments: tuple[Node, ...]) -> str:
        x = arguments[0]
        if function == "conj" and isinstance(x, Name) and sum(map(str.isalpha, x.name)) == 1:
            return self.name(x.name) + "\u0304"  # a bar over several letters is read over the last
        if function == "inv":
            return self.write(x, POSTFIX) + "⁻¹"
        inside = ", ".join(self.write(x) for x in arguments)
        if function == "comm" and not all(
            isinstance(y, Call) and y.function == "comm" for y in arguments
        ):
            return f"[{inside}]"  # [[p, q], [r, s]] would be a matrix
        return f"{SHORT_FUNCTIONS.get(function, function)}({inside})"

    def exists(self, names: tuple[str, ...], body: str) -> str:
        return f"∃ {', '.join(names)}: {body}"


class _Latex(PlainTextWriter):
    def operator(self, op: str) -> str:
        return {"neg": "-", "not": r"\lnot "}.get(op) or _LATEX[op]

    def group(self, text: str) -> str:
        return rf"\left({text}\right)"

    def bare(self, node: Node) -> str:
        if isinstance(node, Binary) and node.op == "/":
            return rf"\frac{{{self.write(node.left)}}}{{{self.write(node.right)}}}"
        return super().bare(node)

    def name(self, name: str) -> str:
        if name in ENTRIES.get(name[0], ()):
            return f"{name[0]}_{{{name[1:]}}}"
        return name if len(name) == 1 else rf"\mathrm{{{name}}}"

    def power(self, base: str, exponent: int) -> str:
        return f"{{{base}}}^{{{exponent}}}"

    def index(self, base: str, index: int) -> str:
        return f"{{{base}}}_{{{index}}}"

    def call(self, function: str, arguments: tuple[Node, ...]) -> str:
        if function == "conj":
            return rf"\overline{{{self.write(arguments[0])}}}"
        if function == "inv":
            return f"{{{self.write(arguments[0], POSTFIX)}}}^{{-1}}"
        if function == "transpose":
            return rf"{{{self.write(arguments[0], POSTFIX)}}}^{{\mathsf{{T}}}}"
        if function in SEPARATORS:
            parts = [self.write(x) for x in arguments]
            joints = [*SEPARATORS[function][: len(parts) - 1], ""]
            inside = "".join(x + joint for x, joint in zip(parts, joints, strict=False))
            return rf"\begin{{pmatrix}} {inside} \end{{pmatrix}}"
        inside = ", ".join(self.write(x) for x in arguments)
        if function == "comm":
            return rf"\left[{inside}\right]"
        if function == "sqrt":
            return rf"\sqrt{{{inside}}}"
        name = SHORT_FUNCTIONS.get(function, function)
        return rf"\operatorname{{{name}}}\left({inside}\right)"

    def exists(self, names: tuple[str, ...], body: str) -> str:
        return rf"\exists\, {', '.join(names)}\colon {body}"
