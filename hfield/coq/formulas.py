"""Statements without quantifiers as propositions of Coq, the conditions of being defined written out."""

from dataclasses import dataclass

from hfield.coq.terms import Term, Terms
from hfield.syntax import Compare, Logic, Node, Not

SIGNS = {"and": "/\\", "or": "\\/", "=>": "->", "<=>": "<->"}


@dataclass(frozen=True)
class Equation:
    """``left = right``, between scalars or between quaternions."""

    left: Term
    right: Term

    @property
    def text(self) -> str:
        """The proposition in Coq's notation."""
        return f"{self.left.text} = {self.right.text}"


@dataclass(frozen=True)
class Negation:
    """The opposite of a formula."""

    formula: "Formula"

    @property
    def text(self) -> str:
        """The proposition in Coq's notation."""
        if isinstance(self.formula, Equation):
            return f"{self.formula.left.text} <> {self.formula.right.text}"
        return f"~ {grouped(self.formula)}"


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


Formula = Equation | Negation | Junction


def grouped(formula: Formula) -> str:
    """Return the text of a formula as it stands inside another."""
    if isinstance(formula, Junction) or (
        isinstance(formula, Negation) and not isinstance(formula.formula, Equation)
    ):
        return f"({formula.text})"
    return formula.text


def nonzero(terms: Terms, d: Term) -> Formula:
    """Return ``d <> 0``."""
    return Negation(Equation(d, Term("0", terms.integer(0))))


def formula_of(terms: Terms, node: Node) -> Formula:
    """Translate a statement; a comparison says too that what it divides by is not 0."""
    match node:
        case Compare(op, x, y):
            left, right = terms.term(x), terms.term(y)
            if not (left.is_scalar and right.is_scalar):
                left, right = terms.embed(left), terms.embed(right)
            out: Formula = Equation(left, right)
            if op == "!=":
                out = Negation(out)
            divisors = {c.text: c for c in (*left.conditions, *right.conditions)}
            for d in reversed(divisors.values()):
                out = Junction("and", nonzero(terms, d), out)
            return out
        case Not(x):
            return Negation(formula_of(terms, x))
        case Logic("and", Logic("and", x, y), z):
            return formula_of(terms, Logic("and", x, Logic("and", y, z)))
        case Logic(op, x, y):
            return Junction(op, formula_of(terms, x), formula_of(terms, y))
    raise AssertionError(node)
