"""Statements as clauses about polynomials with integer coefficients.

The coordinates of the unknowns become variables: ``q[0] … q[3]`` for a quaternion, ``s`` for a scalar. The
letters of an algebra ``(a,b|F)`` and the constants of a field, such as its generator, become variables as
well. A statement with division is expanded with fractions of polynomials, whose denominators are separate
conditions.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, TypeAlias

import flint
from flint import Ordering, fmpz_mpoly_ctx

from hfield.core.product import Constants
from hfield.errors import TooLargeError
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.scalars import Scalars
from hfield.prover.polynomials.normal_form import (
    FALSE,
    TRUE,
    Formula,
    PolynomialClause,
    clauses,
    literal,
)
from hfield.prover.problem import Problem, remembered
from hfield.prover.statements.language import Sort

if TYPE_CHECKING:
    from hfield.core.product import Coordinates


MAX_WORK = 4_000_000  # products of terms, about one second; this limits the memory too
MAX_WEIGHT = 20_000

Term: TypeAlias = "flint.fmpz_mpoly | PolynomialFraction"  # the representation of a scalar
Conditions: TypeAlias = tuple[flint.fmpz_mpoly, ...]  # polynomials that must not be 0


@dataclass(frozen=True)
class Expanded:
    """A statement as clauses over polynomials of ``context``, whose ``variables`` are given as texts.

    The first ``unknowns`` variables are coordinates, letters and scalars; the others are constants of the
    field. There is no algebra at points where one of ``conditions`` is 0.
    """

    context: flint.fmpz_mpoly_ctx
    variables: tuple[str, ...]
    unknowns: int
    clauses: tuple[PolynomialClause, ...]
    conditions: Conditions = ()

    @property
    def has_constants(self) -> bool:
        """Whether coefficients contain constants of the field."""
        return self.unknowns < len(self.variables)


def coordinate_names(name: str, sort: Sort) -> list[str]:
    """Return the texts of an unknown's coordinates."""
    return [name] if sort is Sort.SCALAR else [f"{name}[{n}]" for n in range(4)]


@remembered
def expand(problem: Problem) -> Expanded:
    """Expand the statement of a problem, in its algebra.

    Quantifiers are ignored: hypotheses and conclusion become one formula. Raises :class:`TooLargeError`
    before an expansion that would take too long.
    """
    statement = problem.statement
    if statement.weight > MAX_WEIGHT:
        raise TooLargeError("the degree or the numbers are too large to expand")
    world = Symbolic(problem)
    hypotheses, conditions = TRUE, tuple(world.conditions)
    for condition in conditions:  # without an algebra there are no hypotheses
        hypotheses = hypotheses & literal((condition,), False)
    for h in statement.hypotheses:
        hypotheses = hypotheses & world.truth(h)
    whole = ~hypotheses | world.truth(statement.conclusion)
    return Expanded(world.context, world.variables, world.unknowns, clauses(whole), conditions)


class Symbolic(Evaluator[Term, Conditions, Formula]):
    """Evaluates the statement of a problem to a formula about polynomials in its unknowns.

    The first ``unknowns`` of the ``variables`` are coordinates of unknowns, the others constants of the
    field. The structure constants are defined at points where none of the ``conditions`` is 0.
    """

    scalars: PolynomialScalars

    def __init__(self, problem: Problem) -> None:
        statement, setting = problem.statement, problem.setting
        names = [c for name, sort in statement.unknowns for c in coordinate_names(name, sort)]
        self.variables, self.unknowns = (*names, *statement.constants), len(names)
        self.context = fmpz_mpoly_ctx.get(
            [f"v{n}" for n in range(len(self.variables))], Ordering.degrevlex
        )
        divides = statement.divides or setting.divides
        scalars = (_Fractions if divides else PolynomialScalars)(self.context)
        lifted = map(scalars.lift, self.context.gens())
        by_text = dict(zip(self.variables, lifted, strict=True))
        fixed = {text: by_text[text] for text in statement.constants}
        super().__init__(scalars, setting.trees, statement.sorts, fixed)
        values = {}
        for name, sort in statement.unknowns:
            coordinates = tuple(by_text[c] for c in coordinate_names(name, sort))
            values[name] = coordinates[0] if sort is Sort.SCALAR else coordinates
        self.conditions: Conditions = self.bind(values)

    def numerators(self, x: Term | tuple[Term, ...]) -> tuple[flint.fmpz_mpoly, ...]:
        """Return the polynomials with the same zeros as the coordinates of x, where x is defined."""
        return tuple(map(self.scalars.numerator, self.embed(x)))


class ExpansionBudget:
    """The remaining work; the cost of every product of polynomials is subtracted in advance."""

    def __init__(self) -> None:
        self.left = MAX_WORK

    def spend(self, work: int) -> None:
        """Spend ``work`` products of terms. Raises TooLargeError if that exceeds the budget."""
        if work > self.left:
            raise TooLargeError("expanding would take too many terms")
        self.left -= work


class PolynomialScalars(Scalars[Term, Conditions, Formula]):
    """Integer polynomials as scalars; statements become formulas about their zeros."""

    always = ()
    true, false = TRUE, FALSE
    reflexive = True  # that a thing is itself needs no expanding

    def __init__(self, context: flint.fmpz_mpoly_ctx) -> None:
        self.context, self.budget = context, ExpansionBudget()
        self.never = (context.constant(0),)
        self.zero, self.one = self.lift(context.constant(0)), self.lift(context.constant(1))

    def lift(self, x: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
        """Convert a polynomial to a scalar."""
        return x

    def numerator(self, x: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
        """Return the polynomial with the same zeros as x, where x is defined."""
        return x

    def number(self, value: int | Fraction) -> tuple[Term, Conditions]:
        """Return a literal."""
        return self.lift(self.context.constant(value.numerator)), ()

    def reciprocal(self, x: flint.fmpz_mpoly) -> tuple[Term, Conditions]:
        """Never called: a statement with division is expanded with fractions."""
        raise AssertionError("division of polynomials without denominators")

    def times(self, x: Term, y: Term) -> Term:
        """Return the product, after spending its cost from the budget."""
        self.budget.spend(len(x) * len(y))
        return x * y

    def scale(self, q: Coordinates, s: Term) -> Coordinates:
        """Return the product with a scalar, after spending its cost from the budget."""
        self.budget.spend(_size(q) * len(s))
        return super().scale(q, s)

    def multiply(self, constants: Constants, p: Coordinates, q: Coordinates) -> Coordinates:
        """Return the product, after spending its cost from the budget."""
        self.budget.spend(_size(p) * _size(q))
        return super().multiply(constants, p, q)

    def norm(self, constants: Constants, q: Coordinates) -> Term:
        """Return the norm, after spending its cost from the budget."""
        self.budget.spend(_size(q) ** 2)
        return super().norm(constants, q)

    def together(self, x: Conditions, y: Conditions) -> Conditions:
        """Return the union of two lists of polynomials, without repetitions."""
        return x if x == y or not y else x + tuple(p for p in y if p not in x)

    def both(self, x: Formula, y: Formula) -> Formula:
        """Return the formula "x and y"."""
        return x & y

    def either(self, x: Formula, y: Formula) -> Formula:
        """Return the formula "x or y"."""
        return x | y

    def negate(self, x: Formula) -> Formula:
        """Return the negated formula."""
        return ~x

    def equal(self, differences: Iterable[Term], defined: Conditions) -> Formula:
        """Return the formula "defined, and all numerators are 0"."""
        return self._comparison(differences, defined, True)

    def unequal(self, differences: Iterable[Term], defined: Conditions) -> Formula:
        """Return the formula "defined, and some numerator is not 0"."""
        return self._comparison(differences, defined, False)

    def _comparison(self, differences: Iterable[Term], defined: Conditions, zero: bool) -> Formula:
        f = literal((self.numerator(d) for d in differences), zero)
        for condition in defined:
            f = f & literal((condition,), False)
        return f


class _Fractions(PolynomialScalars):
    """Fractions of polynomials as scalars."""

    reflexive = False  # a thing that is not defined is not itself

    def lift(self, x: flint.fmpz_mpoly) -> PolynomialFraction:
        return PolynomialFraction(x, self.context.constant(1), self.budget)

    def numerator(self, x: PolynomialFraction) -> flint.fmpz_mpoly:
        return x.top

    def number(self, value: int | Fraction) -> tuple[PolynomialFraction, Conditions]:
        top, bottom = (self.context.constant(n) for n in (value.numerator, value.denominator))
        return PolynomialFraction(top, bottom, self.budget), (() if bottom == 1 else (bottom,))

    def reciprocal(self, x: PolynomialFraction) -> tuple[PolynomialFraction, Conditions]:
        if x.top == 0:
            return self.zero, (x.top,)
        return PolynomialFraction(x.bottom, x.top, self.budget), (() if x.top == 1 else (x.top,))


class PolynomialFraction:
    """A fraction of polynomials that is never reduced, so that the numerator is well defined.

    u/d + v/d = (u + v)/d, u/d + v/f = (u·f + v·d)/(d·f), and 0 is always 0/1.
    """

    __slots__ = ("bottom", "budget", "top")

    def __init__(
        self, top: flint.fmpz_mpoly, bottom: flint.fmpz_mpoly, budget: ExpansionBudget
    ) -> None:
        self.top, self.bottom, self.budget = top, bottom if top != 0 else top**0, budget

    def __len__(self) -> int:
        return len(self.top) + len(self.bottom)

    def __neg__(self) -> PolynomialFraction:
        return PolynomialFraction(-self.top, self.bottom, self.budget)

    def __add__(self, other: PolynomialFraction) -> PolynomialFraction:
        return self._sum(other.top, other.bottom)

    def __sub__(self, other: PolynomialFraction) -> PolynomialFraction:
        return self._sum(-other.top, other.bottom)

    def _sum(self, top: flint.fmpz_mpoly, bottom: flint.fmpz_mpoly) -> PolynomialFraction:
        if top == 0:
            return self
        if self.top == 0:
            return PolynomialFraction(top, bottom, self.budget)
        if self.bottom == bottom:
            return PolynomialFraction(self.top + top, bottom, self.budget)
        self._charge(top, bottom)
        top = self.top * bottom + top * self.bottom
        return PolynomialFraction(top, self.bottom * bottom, self.budget)

    def __mul__(self, other: PolynomialFraction) -> PolynomialFraction:
        self._charge(other.top, other.bottom)
        return PolynomialFraction(self.top * other.top, self.bottom * other.bottom, self.budget)

    def _charge(self, top: flint.fmpz_mpoly, bottom: flint.fmpz_mpoly) -> None:
        self.budget.spend((len(self.top) + len(self.bottom)) * (len(top) + len(bottom)))


def _size(q: Coordinates) -> int:
    return sum(map(len, q))
