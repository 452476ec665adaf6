"""Write quantifier-free statements as Coq propositions."""

from dataclasses import dataclass

from hfield.export.coq.terms import Term, Terms
from hfield.syntax import Compare, Logic, Node, Not

SIGNS = {"and": "/\\", "or": "\\/", "=>": "->", "<=>": "<->"}
DATA = {"and": "And", "or": "Or", "=>": "Imp", "<=>": "Iff"}


@dataclass(frozen=True)
class Equation:
    """An equation ``left = right`` of scalars or quaternions; their coordinates have the given ``type``."""

    left: Term
    right: Term
    type: str

    @property
    def text(self) -> str:
        """The proposition in Coq's notation."""
        return self.shown("=")

    def shown(self, sign: str) -> str:
        """Return the proposition with this sign; the type is written if no unknown determines it."""
        text = f"{self.left.text} {sign} {self.right.text}"
        if not (self.left.closed and self.right.closed):
            return text
        inner = f"({self.type})" if " " in self.type else self.type
        kind = self.type if self.left.is_scalar else f"quaternion {inner}"
        return f"{text} :> {kind}"

    @property
    def data(self) -> str:
        """The formula as data."""
        kind = "Equal" if self.left.is_scalar else "Same"
        return f"{kind} {self.left.argument} {self.right.argument}"


@dataclass(frozen=True)
class Invertible:
    """``term`` has an inverse."""

    term: Term
    type: str

    @property
    def text(self) -> str:
        """The proposition in Coq's notation."""
        return f"unit {self.term.inner if not self.term.closed else f'({self.term.text} : {self.type})'}"

    @property
    def data(self) -> str:
        """The formula as data."""
        return f"Unit {self.term.argument}"


@dataclass(frozen=True)
class NegatedFormula:
    """The opposite of a formula."""

    formula: "Formula"

    @property
    def text(self) -> str:
        """The proposition in Coq's notation."""
        if isinstance(self.formula, Equation):
            return self.formula.shown("<>")
        return f"~ {grouped(self.formula)}"

    @property
    def data(self) -> str:
        """The formula as data."""
        return f"Not ({self.formula.data})"


@dataclass(frozen=True)
class Junction:
    """``left op right`` with op one of ``and or => <=>``."""

    op: str
    left: "Formula"
    right: "Formula"

    @property
    def text(self) -> str:
        """The proposition in Coq's notation."""
        right = self.right
        chain = isinstance(right, Junction) and right.op == self.op and self.op != "<=>"
        return f"{grouped(self.left)} {SIGNS[self.op]} {right.text if chain else grouped(right)}"

    @property
    def data(self) -> str:
        """The formula as data."""
        return f"{DATA[self.op]} ({self.left.data}) ({self.right.data})"


Formula = Equation | Invertible | NegatedFormula | Junction


def grouped(formula: Formula) -> str:
    """Return the text of a formula as part of another formula."""
    if isinstance(formula, Junction) or (
        isinstance(formula, NegatedFormula) and not isinstance(formula.formula, Equation)
    ):
        return f"({formula.text})"
    return formula.text


@dataclass(frozen=True)
class Formulas:
    """Translates statements over one ring; divisors must be nonzero in a field, and units in other rings."""

    terms: Terms
    type: str
    is_field: bool

    def defined(self, d: Term) -> Formula:
        """Return the formula that d has an inverse."""
        if not self.is_field:
            return Invertible(d, self.type)
        return NegatedFormula(Equation(d, self.terms.number(0), self.type))

    def of(self, node: Node) -> Formula:
        """Translate a statement; a comparison also states that all divisors in it have inverses."""
        match node:
            case Compare(op, x, y):
                left, right = self.terms.term(x), self.terms.term(y)
                if not (left.is_scalar and right.is_scalar):
                    left, right = self.terms.embed(left), self.terms.embed(right)
                out: Formula = Equation(left, right, self.type)
                if op == "!=":
                    out = NegatedFormula(out)
                divisors = {c.text: c for c in (*left.conditions, *right.conditions)}
                for d in reversed(divisors.values()):
                    out = Junction("and", self.defined(d), out)
                return out
            case Not(x):
                return NegatedFormula(self.of(x))
            case Logic("and", Logic("and", x, y), z):
                return self.of(Logic("and", x, Logic("and", y, z)))
            case Logic(op, x, y):
                return Junction(op, self.of(x), self.of(y))
        raise AssertionError(node)


def equations(formula: Formula) -> list[Equation]:
    """Return all equations in a formula."""
    match formula:
        case Equation():
            return [formula]
        case NegatedFormula(inner):
            return equations(inner)
        case Junction(_, left, right):
            return equations(left) + equations(right)
    return []
