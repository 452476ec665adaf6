"""Turn a statement into clauses: "if all of Z are 0, then all of some set in G are".

Terms with division become fractions whose denominators are products of known factors; these
factors are the conditions under which the term is defined. Formulas are nested tuples:
``("and", parts)``, ``("or", parts)`` and literals ``("zero", polynomials)``, ``("nonzero", …)``.
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Literal, TypeAlias

from hfield.checker.budget import spend
from hfield.checker.evaluate import Conditions, Evaluator, Quaternion
from hfield.checker.language import Tree
from hfield.checker.polynomials import (
    Monomial,
    Names,
    Poly,
    add,
    constant,
    divide,
    multiply,
    width,
)
from hfield.checker.rejection import reject
from hfield.checker.statement import Setting, Statement

MAX_CLAUSES = 1_024

Frozen = frozenset[tuple[Monomial, int]]  # a polynomial that can be compared and hashed
Pieces = tuple[tuple[int, int], ...]  # factors of a denominator with their multiplicities
Quotient = tuple[Poly, Pieces]
LiteralFormula = tuple[Literal["zero", "nonzero"], frozenset[Frozen]]
Formula: TypeAlias = "tuple[Literal['and', 'or'], tuple[Formula, ...]] | LiteralFormula"


def freeze(f: Poly) -> Frozen:
    """Return a hashable polynomial, the same for f and −f."""
    spend(1 + 2 * len(f) + width(f) // 4)
    return frozenset(f.items() if not f or f[max(f)] > 0 else [(m, -c) for m, c in f.items()])


@dataclass(frozen=True)
class Clause:
    """``zeros`` and the sets in ``goals`` are polynomials over ℤ."""

    zeros: frozenset[Frozen]
    goals: frozenset[frozenset[Frozen]]


@dataclass(frozen=True)
class Expansion:
    """A statement as clauses; variables after the first ``unknowns`` are constants of the field.

    ``factors`` are the polynomials by which the statement divides. ``conditions`` are those factors and other
    polynomials that must be nonzero for the algebra to exist.
    """

    names: Names
    unknowns: int
    clauses: tuple[Clause, ...]
    factors: tuple[Poly, ...]
    conditions: tuple[Poly, ...]
    evaluator: Evaluator[Quotient, Formula]


class Fractions:
    """Fractions as scalars: ``(numerator, factors of the denominator)``."""

    def __init__(self) -> None:
        self.factors = list[Poly]()
        self._places: dict[Frozen, int] = {}  # of the factors
        self._literals: dict[frozenset[Frozen], frozenset[Frozen]] = {}
        self.zero: Quotient = ({}, ())
        self.one: Quotient = self.polynomial(constant(1))

    @staticmethod
    def polynomial(f: Poly) -> Quotient:
        """Return a polynomial as a scalar."""
        return (f, ())

    def number(self, value: int | Fraction) -> tuple[Quotient, Conditions[Quotient]]:
        """Return a literal."""
        if isinstance(value, int):
            return self.polynomial(constant(value)), ()
        x, conditions = self.reciprocal(self.polynomial(constant(value.denominator)))
        return self.mul(self.polynomial(constant(value.numerator)), x), conditions

    def add(self, x: Quotient, y: Quotient) -> Quotient:
        """Return x + y over the least common denominator."""
        if not x[0] or not y[0]:
            return y if not x[0] else x
        if x[1] or y[1]:
            spend(len(x[1]) + len(y[1]))
        if x[1] == y[1]:
            return self._made(add(x[0], y[0]), x[1])
        common = dict(x[1])
        for piece, n in y[1]:
            common[piece] = max(common.get(piece, 0), n)
        pieces = tuple(sorted(common.items()))
        return self._made(add(self._over(x, common), self._over(y, common)), pieces)

    def neg(self, x: Quotient) -> Quotient:
        """Return −x."""
        spend(2 * len(x[0]))
        return {m: -c for m, c in x[0].items()}, x[1]

    def mul(self, x: Quotient, y: Quotient) -> Quotient:
        """Return x·y."""
        top = multiply(x[0], y[0])
        if not x[1] or not y[1]:
            return self._made(top, x[1] or y[1])
        spend(len(x[1]) + len(y[1]))
        pieces = dict(x[1])
        for piece, n in y[1]:
            pieces[piece] = pieces.get(piece, 0) + n
        return self._made(top, tuple(sorted(pieces.items())))

    def reciprocal(self, x: Quotient) -> tuple[Quotient, Conditions[Quotient]]:
        """Return 1/x, with the condition that its numerator is not 0."""
        top = x[0]
        if not top:
            return self.zero, (self.polynomial({}),)
        below = constant(1)
        for piece, n in x[1]:
            for _ in range(n):
                below = multiply(below, self.factors[piece])
        if top == constant(1):
            return self.polynomial(below), ()
        spend(2 * len(top))
        place = self._places.setdefault(frozenset(top.items()), len(self.factors))
        if place == len(self.factors):
            self.factors.append(top)
        return self._made(below, ((place, 1),)), (self.polynomial(top),)

    def compare(
        self, differences: list[Quotient], conditions: Conditions[Quotient], equal: bool
    ) -> Formula:
        """Return the formula "everything is defined, and all (or not all) numerators are 0"."""
        tops = [d[0] for d in differences]
        literal = self.literal(tops, equal)
        parts = [self.literal([c[0]], False) for c in conditions]
        return ("and", (*parts, ("or", (literal, *(deny(part) for part in parts)))))

    def literal(self, tops: list[Poly], zero: bool) -> Formula:
        """Return "all are 0" or "not all are 0"; equal formulas share their polynomials, so that comparison
        is fast.
        """
        polynomials = frozenset(freeze(f) for f in tops if f)
        if not polynomials:
            return ("and" if zero else "or", ())
        return ("zero" if zero else "nonzero", self._literals.setdefault(polynomials, polynomials))

    def join(self, kind: Literal["and", "or"], x: Formula, y: Formula) -> Formula:
        """Return "x and y" or "x or y"."""
        return (kind, (x, y))

    def deny(self, x: Formula) -> Formula:
        """Return the formula "not x"."""
        return deny(x)

    def _over(self, x: Quotient, common: dict[int, int]) -> Poly:
        top: Poly = x[0]
        own = dict(x[1])
        for piece, n in common.items():
            for _ in range(n - own.get(piece, 0)):
                top = multiply(top, self.factors[piece])
        return top

    def _made(self, top: Poly, pieces: Pieces) -> Quotient:
        return (top, pieces) if top else self.zero


def deny(f: Formula) -> Formula:
    """Return the negation of a formula."""
    spend(10)
    if f[0] == "zero" or f[0] == "nonzero":
        return ("nonzero" if f[0] == "zero" else "zero", f[1])
    return ("or" if f[0] == "and" else "and", tuple(deny(x) for x in f[1]))


def expand(statement: Statement, setting: Setting) -> Expansion:
    """Return the clauses of a quantifier-free statement."""
    coordinates: dict[Tree, list[Tree]] = {}
    for name, sort in statement.unknowns:
        tree: Tree = ("name", name)
        coordinates[tree] = [tree] if sort == "s" else [("index", tree, n) for n in range(4)]
    variables = [v for own in coordinates.values() for v in own]
    coordinates |= {tree: [tree] for tree in statement.constants}
    names, scalars = Names((*variables, *statement.constants)), Fractions()
    values: dict[Tree, Quotient | Quaternion[Quotient]] = {}
    for tree, own in coordinates.items():
        found = [scalars.polynomial(names.variable(v)) for v in own]
        values[tree] = Quaternion(found) if len(found) == 4 else found[0]
    evaluator = Evaluator(scalars, setting.constants, values)
    formula = evaluator.truth(statement.matrix)
    # The algebra exists only if its structure constants are defined.
    conditions = tuple(c[0] for c in evaluator.conditions)
    undefined = [scalars.literal([f], True) for f in conditions]
    clauses = tuple(_clause(c) for c in _conjunction(("or", (*undefined, formula))))
    factors = tuple(scalars.factors)
    return Expansion(names, len(variables), clauses, factors, conditions, evaluator)


def _conjunction(f: Formula) -> list[frozenset[LiteralFormula]]:
    """Return the conjunctive normal form without tautologies."""
    spend(20)
    if f[0] == "zero" or f[0] == "nonzero":
        return [frozenset([f])]
    kind = f[0]
    out: list[frozenset[LiteralFormula]] = [] if kind == "and" else [frozenset()]
    for part in f[1]:
        right = _conjunction(part)
        size = len(out) + len(right) if kind == "and" else len(out) * len(right)
        spend(20 * size)
        if size > MAX_CLAUSES:
            reject("the statement has too many clauses")
        if kind == "and":
            out += right
        else:
            spend(len(out) * sum(map(len, right)) + len(right) * sum(map(len, out)))
            out = [a | b for a in out for b in right]
    return [c for c in dict.fromkeys(out) if not any(deny(x) in c for x in c)]


def _clause(literals: frozenset[LiteralFormula]) -> Clause:
    zeros = frozenset(f for kind, fs in literals if kind == "nonzero" for f in fs)
    return Clause(zeros, frozenset(fs for kind, fs in literals if kind == "zero"))


def without_factors(f: Poly, known: list[Poly]) -> Poly:
    """Divide by factors known to be nonzero, as often as possible."""
    spend(1 + len(known))
    for factor in known:
        while f and factor not in (constant(1), constant(-1)):
            quotient = divide(f, factor)
            if quotient is None:
                break
            f = quotient
    return f
