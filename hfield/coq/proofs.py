"""Finding a proof and writing it as a script of Coq's tactics, every hypothesis by its name.

Over commutative rings only direct arguments are used, which need no decision whether two elements
are equal. Over a field, whose equality is decidable, formulas are taken apart as in a tableau, and
what is not 0 has an inverse. Either way each branch ends in one equation that is a linear
combination of known ones, with cofactors from :mod:`hfield.proving.polynomials.membership`.
"""

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

from hfield.coq.facts import Facts, NoProofError, combine
from hfield.coq.formulas import Equation, Formula, Junction, Negation
from hfield.coq.terms import Term, Terms
from hfield.proving.polynomials.vanishing import prime_factors

Lines = list[str]
Rest = Callable[[Facts], Lines]
DECIDED = "ltac:(decided)"
MAX_LINES = 5_000


def block(lines: Iterable[str]) -> Lines:
    """Return a focused subproof."""
    first, *rest = lines
    inner = [f"{{ {first}", *(f"  {line}" for line in rest)]
    return [*inner[:-1], f"{inner[-1]} }}"]


class Proof:
    """Writes one proof; ``field`` tells whether the theorem is about fields or commutative rings."""

    def __init__(self, terms: Terms, field: bool, deadline: float) -> None:
        self.terms, self.field, self.deadline = terms, field, deadline
        self.count = self.written = 0

    def fresh(self) -> str:
        """Return a name for a hypothesis."""
        self.count += 1
        if self.count > MAX_LINES:
            raise NoProofError("the proof has too many cases")
        return f"h{self.count}"

    def need_field(self) -> None:
        """Raise NoProofError unless equality can be decided."""
        if not self.field:
            raise NoProofError("this needs a field, in which equality is decidable")

    # --- what is known ---------------------------------------------------------------------------

    def assume(self, name: str, formula: Formula, facts: Facts, rest: Rest) -> Lines:
        """Use that the formula holds, by the hypothesis ``name``."""
        match formula:
            case Equation(left, right):
                return rest(facts.with_equation(name, left, right))
            case Negation(inner):
                return self.deny(name, inner, facts, rest)
            case Junction("and", left, right):
                return self._both(f"destruct {name}", left, right, facts, rest, self.assume)
            case Junction("or", left, right):
                return self._cases(
                    f"destruct {name}", (self.assume, left), (self.assume, right), facts, rest
                )
            case Junction("=>", left, right):
                self.need_field()
                how = f"destruct (either _ _ {name} {DECIDED})"
                return self._cases(how, (self.deny, left), (self.assume, right), facts, rest)
        parts = (
            Junction("=>", formula.left, formula.right),
            Junction("=>", formula.right, formula.left),
        )
        return self._both(f"destruct {name}", *parts, facts, rest, self.assume)

    def deny(self, name: str, formula: Formula, facts: Facts, rest: Rest) -> Lines:
        """Use that the formula does not hold, by the hypothesis ``name : ~ formula``."""
        self.need_field()
        match formula:
            case Equation(left, right):
                return rest(facts.with_difference(self.terms, name, left, right))
            case Negation(inner):
                new = self.fresh()
                line = f"pose proof (twice_not _ {name} {DECIDED}) as {new}."
                return [line, *self.assume(new, inner, facts, rest)]
            case Junction("and", left, right):
                how = f"destruct (not_both _ _ {name} {DECIDED})"
                return self._cases(how, (self.deny, left), (self.deny, right), facts, rest)
            case Junction("or", left, right):
                return self._both(
                    f"destruct (not_or _ _ {name})", left, right, facts, rest, self.deny
                )
            case Junction("=>", left, right):
                how = f"destruct (not_implied _ _ {name} {DECIDED})"
                return self._both(how, left, Negation(right), facts, rest, self.assume)
        how = f"destruct (not_equivalent _ _ {name} {DECIDED} {DECIDED})"
        first, second = formula.left, formula.right
        choices = [
            Junction("and", first, Negation(second)),
            Junction("and", Negation(first), second),
        ]
        return self._cases(how, (self.assume, choices[0]), (self.assume, choices[1]), facts, rest)

    def _both(
        self, how: str, left: Formula, right: Formula, facts: Facts, rest: Rest, use: Any
    ) -> Lines:
        a, b = self.fresh(), self.fresh()
        return [
            f"{how} as [{a} {b}].",
            *use(a, left, facts, lambda known: use(b, right, known, rest)),
        ]

    def _cases(self, how: str, one: Any, other: Any, facts: Facts, rest: Rest) -> Lines:
        a, b = self.fresh(), self.fresh()
        return [
            f"{how} as [{a} | {b}].",
            *block(one[0](a, one[1], facts, rest)),
            *block(other[0](b, other[1], facts, rest)),
        ]

    # --- what is to be proved --------------------------------------------------------------------

    def prove(self, goal: Formula, facts: Facts) -> Lines:
        """Prove the goal. Raises :class:`NoProofError` when no proof is found."""
        match goal:
            case Equation(left, right) if left.is_scalar:
                return self.equation(left, right, facts)
            case Equation(left, right):
                pairs = [[self.terms.coordinate(x, n) for x in (left, right)] for n in range(4)]
                parts = [self.equation(x, y, facts) for x, y in pairs]
                if all(part == ["calculate."] for part in parts):
                    return ["apply coordinates; calculate."]
                return ["apply coordinates.", *(line for part in parts for line in block(part))]
            case Negation(inner):
                name = self.fresh()
                return [f"intro {name}.", *self.assume(name, inner, facts, self.contradiction)]
            case Junction("and", first, second) if isinstance(first, Negation):
                name = self.fresh()
                return [
                    f"assert ({name} : {first.text}).",
                    *block(self.prove(first, facts)),
                    f"split; [exact {name} |].",
                    *self.assume(name, first, facts, lambda known: self.prove(second, known)),
                ]
            case Junction("and", first, second):
                parts = [self.prove(first, facts), self.prove(second, facts)]
                return ["split.", *(line for part in parts for line in block(part))]
            case Junction("=>", first, second):
                name = self.fresh()
                known = self.assume(name, first, facts, lambda more: self.prove(second, more))
                return [f"intro {name}.", *known]
            case Junction("<=>", left, right):
                ways = Junction("=>", left, right), Junction("=>", right, left)
                parts = [self.prove(way, facts) for way in ways]
                return ["split.", *(line for part in parts for line in block(part))]
        return self._choose(goal.left, goal.right, facts)

    def _choose(self, left: Formula, right: Formula, facts: Facts) -> Lines:
        """Prove one of two formulas; over a field one may be proved where the other fails."""
        for side, formula in (("left", left), ("right", right)):
            try:
                return [f"{side}.", *self.prove(formula, facts)]
            except NoProofError:
                continue
        self.need_field()
        a, b = self.fresh(), self.fresh()
        assertion = f"assert (dec : decidable ({left.text})) by decided."
        otherwise = self.deny(b, left, facts, lambda known: ["right.", *self.prove(right, known)])
        return [
            assertion,
            f"destruct dec as [{a} | {b}]; [left; exact {a} |].",
            *otherwise,
        ]

    def equation(self, left: Term, right: Term, facts: Facts) -> Lines:
        """Prove an equation of scalars; over a field that they cannot differ will do."""
        try:
            return self.close(facts, left.value - right.value)
        except NoProofError:
            self.need_field()
        a, b = self.fresh(), self.fresh()
        known = facts.with_difference(self.terms, b, left, right)
        return [
            f"destruct (equal_or_not {left.inner} {right.inner}) as [{a} | {b}]; [exact {a} |].",
            *self.contradiction(known),
        ]

    def contradiction(self, facts: Facts) -> Lines:
        """Prove anything from what contradicts itself."""
        self.need_field()
        one = self.terms.integer(1)
        return ["exfalso; apply one_is_not_zero.", *self.close(facts, one)]

    def close(self, facts: Facts, target: Any) -> Lines:
        """Prove ``x = y``, where ``target`` is ``x - y``, by what is known."""
        found = combine(self.terms, facts, target, self.deadline)
        if found is None:
            return self._look_into(facts, target)
        if found.denominator == 1:
            return [f"combine {found.text}." if found.parts else "calculate."]
        self.need_field()
        units, lines = dict(facts.units), []
        for p in prime_factors(found.denominator) or self._give_up():
            proof = units.get(f"num {p}")
            if proof is None:
                return self._by_characteristic(p, facts, target)
            rest = found.denominator
            while rest % p == 0:
                lines.append(f"refine (cancel (num {p}) _ _ {proof} _).")
                rest //= p
        return [*lines, f"combine {found.text}."]

    def _give_up(self) -> list[int]:
        raise NoProofError("no proof was found")

    def _by_characteristic(self, p: int, facts: Facts, target: Any) -> Lines:
        a, b = self.fresh(), self.fresh()
        number, zero = self.terms.number(p), self.terms.number(0)
        divides = facts.with_equation(a, number, zero)
        other = facts.with_unit(self.terms, b, number)
        return [
            f"destruct (equal_or_not (num {p}) 0) as [{a} | {b}].",
            *block(self.close(divides, target)),
            *block(self.close(other, target)),
        ]

    def _look_into(self, facts: Facts, target: Any) -> Lines:
        """Go on with one case for each coordinate in which two quaternions may differ."""
        if not facts.apart:
            self._give_up()
        first, *others = facts.apart
        names = [self.fresh() for _ in range(4)]
        a, b, c, d = names
        pattern = f"[{a} | [{b} | [{c} | {d}]]]"
        lines = [f"destruct (differ_somewhere _ _ {first.name}) as {pattern}."]
        known = replace(facts, apart=tuple(others))
        for n, name in enumerate(names):
            left, right = (self.terms.coordinate(x, n) for x in (first.left, first.right))
            more = known.with_difference(self.terms, name, left, right)
            lines += block(self.close(more, target))
        return lines
