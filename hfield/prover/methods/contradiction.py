"""Show that certain polynomials cannot all be 0 while others are nonzero.

Over all fields of a characteristic, this is proved by showing that 1 lies in the ideal of the zeros and of
``1 − T·g`` for every g that must be nonzero (Rabinowitsch's trick). Over a field with rules (see
``field_rules``), if an anisotropic form lies in the ideal, its arguments are added to the ideal; and products
are split into cases.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, repeat
from typing import TYPE_CHECKING

from hfield.errors import TooLargeError
from hfield.fields.base.ring import Ring
from hfield.prover.clock import Clock
from hfield.prover.polynomials.anisotropic_forms import AnisotropicForm, FormFinder
from hfield.prover.polynomials.field_rules import NORM, ROOTS, SQUARES, Rule
from hfield.prover.polynomials.membership import LARGE_PRIMES, Cofactors, PolynomialIdeal
from hfield.prover.polynomials.recognition import (
    MAX_DEGREE,
    as_squares,
    has_no_root,
    polynomial_text,
)
from hfield.prover.polynomials.sums_of_squares import as_sum_of_squares, eliminate_variables
from hfield.prover.polynomials.vanishing import factored

if TYPE_CHECKING:
    import flint


SLICE = 150  # pairs between two looks at the rules
FIRST_CHECKS = (0, 10, 20, 50)  # pairs between the first looks: often little is needed
MAX_ELEMENTS = 400
MAX_TERMS = 6_000  # of all polynomials of conditions together
MAX_CASES = 3  # how deep case distinctions nest
MAX_FACTORED = 60  # terms of a polynomial that is still factored

Step = Mapping[str, object]


@dataclass(frozen=True)
class Conditions:
    """``zeros`` are 0, ``nonzero`` are not; both over one context with ``variables`` as texts.

    The first ``unknowns`` variables are unknowns, the others constants of ``field``. ``quaternions`` are
    candidates for the norm rule: four polynomials and their norm.
    """

    variables: tuple[str, ...]
    unknowns: int
    field: Ring | None
    characteristic: int
    zeros: tuple[flint.fmpz_mpoly, ...]
    nonzero: tuple[flint.fmpz_mpoly, ...]
    quaternions: tuple[tuple[tuple[flint.fmpz_mpoly, ...], flint.fmpz_mpoly], ...] = ()


@dataclass(frozen=True)
class Refutation:
    """The steps of a proof that the conditions have no solution.

    The proof divides by ``denominators`` and uses ``rules``.
    """

    steps: tuple[Step, ...]
    denominators: tuple[int, ...]
    rules: tuple[Rule, ...]


def refute(conditions: Conditions, rules: Sequence[Rule], clock: Clock) -> Refutation | None:
    """Show that the conditions have no solution over the fields of their characteristic, using the rules.

    Returns None if no proof was found, which proves nothing.
    """
    if _is_large(conditions):
        return None
    for prime in _primes(conditions):
        search = _ContradictionSearch(conditions, rules, clock)
        try:
            if search.run(search.start(prime), 0):
                return search.result()
        except TooLargeError:
            return None
        if not search.complete or not search.unreliable:
            return None
    return None


def member(
    conditions: Conditions, targets: Sequence[flint.fmpz_mpoly], clock: Clock
) -> list[Cofactors] | None:
    """Return cofactors that express every target in the ideal of the zeros, or None."""
    if _is_large(conditions):
        return None
    ideal = PolynomialIdeal(
        len(conditions.variables), conditions.characteristic, _primes(conditions)[0], clock
    )
    try:
        ideal.extend(ideal.lift(z) for z in conditions.zeros)
        lifted = [ideal.lift(t) for t in targets]
        for pairs in chain(FIRST_CHECKS, repeat(SLICE)):
            complete = ideal.run(pairs)
            found = [ideal.cofactors(t) for t in lifted]
            if all(found):
                return [f for f in found if f]
            if complete or clock.is_late or len(ideal.basis.leads) > MAX_ELEMENTS:
                break
    except TooLargeError:
        pass
    return None


def _primes(conditions: Conditions) -> tuple[int | None, ...]:
    """Return the primes modulo which to compute; in characteristic 0 they are much larger than the
    coefficients.
    """
    if conditions.characteristic:
        return (None,)
    polynomials = (*conditions.zeros, *conditions.nonzero)
    bits = max((abs(int(c)).bit_length() for f in polynomials for c in f.coeffs()), default=1)
    return tuple(p for p in LARGE_PRIMES if p.bit_length() > 2 * bits + 8) or LARGE_PRIMES[-1:]


def _is_large(conditions: Conditions) -> bool:
    return sum(map(len, (*conditions.zeros, *conditions.nonzero))) > MAX_TERMS


class _ContradictionSearch:
    def __init__(self, conditions: Conditions, rules: Sequence[Rule], clock: Clock) -> None:
        self.conditions, self.rules, self.clock = conditions, rules, clock
        self.steps: list[Step] = []
        self.denominators: list[int] = []
        self.used: dict[Rule, None] = {}
        self.complete, self.unreliable = True, False
        self.tried_as_sums: list[flint.fmpz_mpoly] = []  # searched for sums of squares
        count = len(conditions.nonzero)
        self.names = (*conditions.variables, *(f"T{n + 1}" for n in range(count)))

    def start(self, prime: int | None) -> PolynomialIdeal:
        """Return the ideal of the conditions."""
        p = self.conditions
        ideal = PolynomialIdeal(len(self.names), p.characteristic, prime, self.clock)
        ideal.extend(ideal.lift(z) for z in p.zeros)
        variables = ideal.context.gens()[len(p.variables) :]
        for t, g in zip(variables, p.nonzero, strict=True):
            ideal.add(1 - t * ideal.lift(g))
        return ideal

    def result(self) -> Refutation:
        """Return the refutation that was found."""
        return Refutation(tuple(self.steps), tuple(self.denominators), tuple(self.used))

    def run(self, ideal: PolynomialIdeal, depth: int) -> bool:
        """Enlarge the ideal until it contains 1; append the steps of the proof."""
        one = ideal.context.constant(1)
        while True:
            complete = ideal.run(SLICE)
            if ideal.is_everything:
                found = ideal.cofactors(one)
                self.unreliable |= found is None
                if found is not None:
                    self._step({"step": "contradiction"}, found)
                return found is not None
            if self.rules and (self._norm(ideal) or self._squares(ideal)):
                continue
            if self._rootless(ideal):
                return True
            if self._forms(ideal) or self._gram(ideal):
                continue
            if self.clock.is_late or len(ideal.basis.leads) > MAX_ELEMENTS:
                self.complete = False
                return False
            if complete:
                return bool(self.rules) and depth < MAX_CASES and self._cases(ideal, depth)

    def _step(self, step: dict[str, object], found: Cofactors) -> None:
        step["cofactors"] = [self.text(f) for f in found.factors]
        step["denominator"] = found.denominator
        self.denominators.append(found.denominator)
        self.steps.append(step)

    def text(self, polynomial: flint.fmpz_mpoly) -> str:
        return polynomial_text(polynomial, self.names)

    def _derive(
        self,
        ideal: PolynomialIdeal,
        rule: Rule,
        form: flint.fmpz_mpoly,
        terms: list[flint.fmpz_mpoly],
        step: Step,
    ) -> bool:
        """Add the arguments of a form in the ideal to the ideal, unless they are all in it."""
        found = ideal.cofactors(form)
        if found is None or all(ideal.cofactors(t) is not None for t in terms):
            return False
        self.used[rule] = None
        self._step({"step": rule.form, "terms": [self.text(t) for t in terms], **step}, found)
        ideal.extend(terms)
        return True

    def _norm(self, ideal: PolynomialIdeal) -> bool:
        rule = self._rule(NORM)
        if rule is None:
            return False
        for q, norm in self.conditions.quaternions:
            terms = [ideal.lift(u) for u in q]
            if self._derive(ideal, rule, ideal.lift(norm), terms, {}):
                return True
        return False

    def _squares(self, ideal: PolynomialIdeal) -> bool:
        rule = self._rule(SQUARES)
        if rule is None:
            return False
        candidates = [*ideal.generators, *ideal.elements()]
        for f in candidates:
            parts = as_squares(f, rule)
            if parts is None:
                continue
            terms = [m for _, m in parts]
            step = {"coefficients": [c for c, _ in parts]}
            form = sum((c * m * m for c, m in parts), ideal.context.constant(0))
            if self._derive(ideal, rule, form, terms, step):
                return True
        return False

    def _gram(self, ideal: PolynomialIdeal) -> bool:
        """Write a polynomial of the ideal as a sum of squares, and add the squared polynomials to the
        ideal.
        """
        rule = self._rule(SQUARES)
        if rule is None or not rule.positive:
            return False
        candidates = [*ideal.generators, *ideal.elements()]
        candidates += eliminate_variables(ideal.generators)
        for f in sorted(candidates, key=len):
            if self.clock.is_late:
                return False
            if f in self.tried_as_sums:
                continue
            self.tried_as_sums.append(f)
            squares = as_sum_of_squares(f, self.clock)
            if squares is None:
                continue
            form = sum((c * g * g for c, g in squares), ideal.context.constant(0))
            step = {"coefficients": [c for c, _ in squares]}
            if self._derive(ideal, rule, form, [g for _, g in squares], step):
                return True
        return False

    def _rule(self, form: str) -> Rule | None:
        return next((r for r in self.rules if r.form == form), None)

    def _rootless(self, ideal: PolynomialIdeal) -> bool:
        """Find a polynomial in one variable that has no root in the field."""
        p = self.conditions
        roots = self._rule(ROOTS)
        if roots is None or p.field is None:
            return False
        for f in [*ideal.generators, *ideal.elements()]:
            if not has_no_root(f, p.variables, p.unknowns, p.field):
                continue
            found = ideal.cofactors(f)
            if found is not None:
                self.used[roots] = None
                self._step({"step": "no root", "polynomial": self.text(f)}, found)
                return True
        return False

    def _forms(self, ideal: PolynomialIdeal) -> bool:
        """Find an anisotropic form in the ideal, and add its terms to the ideal."""
        p = self.conditions
        if p.field is None or self._rule(ROOTS) is None or self.clock.is_late:
            return False
        forms = FormFinder(p.variables, p.unknowns, p.field, ideal.context)
        for f in sorted([*ideal.generators, *ideal.elements()], key=len):
            for form in forms.of(f):
                rule = form.rule or self._rule(
                    SQUARES if "squares" in form.step.values() else ROOTS
                )
                if rule is None or (rule.form == SQUARES and not fits(rule, form)):
                    continue
                if self._derive(ideal, rule, form.value, list(form.terms), form.step):
                    return True
        return False

    def _cases(self, ideal: PolynomialIdeal, depth: int) -> bool:
        """Split a product that is 0 into its factors."""
        for f in sorted([*ideal.generators, *ideal.elements()], key=len):
            if len(f) > MAX_FACTORED or not 2 <= f.total_degree() <= MAX_DEGREE:
                continue
            if self.clock.is_late:
                return False
            _, powers = factored(f, squarefree=len(f) > 20)
            factors = [g for g, _ in powers]
            if len(factors) < 2 or len(factors) > 4:
                continue
            if any(ideal.cofactors(g) is not None for g in factors):
                continue  # one factor is 0 already
            product = ideal.context.constant(1)
            for g, n in powers:
                product *= g**n
            found = ideal.cofactors(product)
            if found is None:
                continue
            branches = []
            for g in factors:
                branch = _ContradictionSearch(self.conditions, self.rules, self.clock)
                below = PolynomialIdeal(
                    len(self.names), ideal.characteristic, ideal.basis.p, self.clock
                )
                below.extend([*ideal.generators, g])
                if not branch.run(below, depth + 1):
                    break
                branches.append(branch)
            if len(branches) < len(factors):
                continue
            step: dict[str, object] = {
                "step": "cases",
                "factors": [self.text(g) for g in factors],
                "powers": [int(n) for _, n in powers],
                "branches": [list(branch.steps) for branch in branches],
            }
            for branch in branches:
                self.denominators.extend(branch.denominators)
                self.used.update(branch.used)
            self._step(step, found)
            return True
        return False


def fits(rule: Rule, form: AnisotropicForm) -> bool:
    """Return whether a rule on sums of squares applies."""
    coefficients = form.step["coefficients"]
    plain = isinstance(coefficients, list) and all(c == 1 for c in coefficients)
    return len(form.terms) <= rule.most and (plain or rule.positive)
