"""Prove clauses over all fields of one characteristic."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby, product
from typing import TYPE_CHECKING, TypedDict

from hfield.errors import shorten
from hfield.fields.base.ring import Ring
from hfield.prover.decision import (
    COMMUTATIVE_RINGS,
    FIELD,
    FIELDS,
    REDUCED_RINGS,
    Scope,
)
from hfield.prover.methods.contradiction import Conditions, member, refute
from hfield.prover.polynomials.expansion import Expanded, expand
from hfield.prover.polynomials.field_rules import ROOTS, Rule, rules
from hfield.prover.polynomials.membership import Cofactors
from hfield.prover.polynomials.normal_form import PolynomialClause
from hfield.prover.polynomials.recognition import polynomial_text
from hfield.prover.polynomials.starting_relations import (
    nonzero_constants_of,
    quaternions_of,
    relations_of,
)
from hfield.prover.polynomials.vanishing import is_nonzero_constant, known, vanishes
from hfield.prover.problem import Problem, remembered
from hfield.prover.statements.language import Statement
from hfield.prover.steps import say

if TYPE_CHECKING:
    import flint


MAX_CHOICES = 64


class ItemEvidence(TypedDict, total=False):
    """One item: ``member`` is in the ideal of ``zero``, or ``steps`` end in a contradiction."""

    characteristic: int
    zero: list[str]
    relations: list[str]
    member: str
    cofactors: list[str]
    denominator: int
    nonzero: list[str]
    steps: list[Mapping[str, object]]


@dataclass(frozen=True)
class Item:
    """One item of the evidence, with the data that determine its scope."""

    evidence: ItemEvidence
    direct: bool
    single: bool
    denominators: tuple[int, ...]
    rules: tuple[Rule, ...] = ()

    @property
    def by_contradiction(self) -> tuple[str, ...]:
        """The polynomials that are 0 in a proof by contradiction; () for a direct proof."""
        return () if self.direct else ("0", *self.evidence["zero"])


@dataclass(frozen=True)
class Proof:
    """Items that together prove all clauses over the setting's fields."""

    items: tuple[Item, ...]
    characteristic: int
    has_constants: bool

    @property
    def denominator(self) -> int:
        """The product of all numbers by which the proof divides."""
        return math.prod(d for item in self.items for d in set(item.denominators))

    @property
    def is_direct(self) -> bool:
        """Whether the proof is valid over every commutative ring."""
        return all(item.direct for item in self.items) and abs(self.denominator) == 1

    def scope(self, statement: Statement) -> Scope:
        """Return the scope in which the proof is valid."""
        if self.rules or self.has_constants:
            return FIELD
        if self.characteristic:  # by contradiction it is shown over fields, not over F₂[ε]
            fields_only = statement.divides or statement.compares_unequal
            direct = self.is_direct and not fields_only
            return Scope.characteristics([self.characteristic]) if direct else FIELD
        if abs(self.denominator) != 1:
            return FIELD
        if statement.divides or statement.compares_unequal:
            return FIELDS
        if self.is_direct:
            return COMMUTATIVE_RINGS
        return REDUCED_RINGS if all(item.single for item in self.items) else FIELDS

    @property
    def rules(self) -> tuple[Rule, ...]:
        """The rules that were used."""
        return tuple(dict.fromkeys(rule for item in self.items for rule in item.rules))

    @property
    def steps(self) -> tuple[str, ...]:
        """Return the proof as text lines; cases with the same proof share a line."""
        lines: dict[str, None] = {}
        for zero, items in groupby(self.items, key=lambda item: item.by_contradiction):
            alike = list(items)
            if zero:
                lines[_excluded(alike)] = None
                continue
            for zeros, members in groupby(alike, key=lambda item: tuple(item.evidence["zero"])):
                lines.update(dict.fromkeys((*_zeros(zeros), *map(_member, members))))
        return tuple(lines)


def _zeros(zeros: Sequence[str]) -> Iterator[str]:
    """Write the polynomials that are 0 by the hypotheses and by the negation of a conclusion that is not an
    equation, with names.
    """
    if zeros:
        named = ", ".join(f"h{n} = {shorten(text, 120)}" for n, text in enumerate(zeros, 1))
        yield say("suppose", h=named) if len(zeros) == 1 else say("suppose-all", list=named)


def _member(item: Item) -> str:
    """Write how a conclusion follows from the hypotheses."""
    e = item.evidence
    shown = " + ".join(f"({c})·h{n}" for n, c in enumerate(e["cofactors"], 1) if c != "0")
    scale = "" if e["denominator"] == 1 else f"{e['denominator']}·"
    return f"{scale}({e['member']}) = {shown or 0}"


def _excluded(items: Sequence[Item]) -> str:
    """Write that the hypotheses exclude some cases."""
    cases = [" and ".join(f"{g} ≠ 0" for g in item.evidence["nonzero"]) for item in items]
    counts = [sum(s["step"] != "contradiction" for s in item.evidence["steps"]) for item in items]
    few, many = min(counts), max(counts)
    if few < many:
        end = say("contains-one-after-some", n=few, m=many)
    else:
        after = {0: "", 1: "-after-one"}.get(many, "-after")
        end = say(f"contains-one{after}", n=many)
    if len(cases) == 1:
        return say("if", conditions=cases[0], end=end) if cases[0] else end
    return say("in-each-case", n=len(cases), first=cases[0], last=cases[-1], end=end)


def prove_clauses(problem: Problem, characteristic: int) -> Proof | None:
    """Try to prove all clauses over the fields of a characteristic, using the rules of the setting.

    The general proof, without rules and in all characteristics, is tried first, since it works over every
    field. If the result is None, nothing is known.
    """
    x = expand(problem)
    if not x.has_constants:
        general = _proof(problem, 0, None, ())
        if general and (not characteristic or general.denominator % characteristic):
            return general
        special = _proof(problem, characteristic, None, ()) if characteristic else None
        if special:
            return special
    field = problem.field
    own = rules(problem.setting) if field is not None and field.is_field else ()
    if field is None or not field.is_field or not (x.has_constants or own):
        return None
    depends = x.has_constants or any(rule.form == ROOTS for rule in own)
    kinds = tuple((rule.form, rule.most, rule.positive) for rule in own)
    return _proof(problem, characteristic, field if depends else None, kinds)


@remembered
def _proof(
    problem: Problem,
    characteristic: int,
    named: Ring | None,
    kinds: tuple[tuple[str, float, bool], ...],
) -> Proof | None:
    """Prove with rules of given kinds; fields with the same rules share the proof, unless ``named``."""
    x, own = expand(problem), rules(problem.setting) if kinds else ()
    field = problem.field if kinds else named
    attempt = _Attempt(problem, x, characteristic, field, own)
    items: list[Item] = []
    for clause in x.clauses:
        found = attempt.clause(clause)
        if found is None:
            return None
        items.extend(found)
    return Proof(tuple(items), characteristic, x.has_constants)


class _Attempt:
    """Clauses proved over the fields of a characteristic, or over one named field."""

    def __init__(
        self,
        problem: Problem,
        x: Expanded,
        characteristic: int,
        field: Ring | None,
        own: Sequence[Rule],
    ) -> None:
        self.problem, self.x, self.field = problem, x, field
        self.characteristic, self.rules = characteristic, own
        self.quaternions = quaternions_of(problem) if own else ()
        self.relations = relations_of(x, field)

    def is_zero(self, p: flint.fmpz_mpoly) -> bool:
        """Return whether a polynomial is known to be 0 over the fields of the problem."""
        if self.field is not None:
            return known(vanishes, p, self.x, self.field) is True
        n = self.characteristic
        return bool(p == 0 or (n and int(p.content()) % n == 0))

    def is_nonzero_number(self, p: flint.fmpz_mpoly) -> bool:
        """Return whether a polynomial is a constant known to be nonzero over the fields of the problem."""
        if self.field is not None:
            return known(is_nonzero_constant, p, self.x, self.field) is True
        return bool(
            p.is_constant() and not self.is_zero(p) and (self.characteristic or p in (1, -1))
        )

    def text(self, p: flint.fmpz_mpoly) -> str:
        return polynomial_text(p, self.x.variables)

    def conditions(
        self, zeros: Sequence[flint.fmpz_mpoly], nonzero: tuple[flint.fmpz_mpoly, ...] = ()
    ) -> Conditions:
        """Return the vanishing polynomials, relations of constants included, and the nonvanishing ones."""
        x = self.x
        return Conditions(
            x.variables,
            x.unknowns,
            self.field,
            self.characteristic,
            (*zeros, *self.relations),
            nonzero,
            self.quaternions,
        )

    def clause(self, clause: PolynomialClause) -> list[Item] | None:
        """Return items that prove a clause, or None if none are found."""
        if any(all(map(self.is_zero, goal)) for goal in clause.goals):
            return []
        if any(map(self.is_nonzero_number, clause.zeros)):
            return []
        zeros = [z for z in clause.zeros if not self.is_zero(z)]
        found = self.direct(zeros, clause.goals)
        return self.by_contradiction(zeros, clause.goals) if found is None else found

    def evidence(self, zeros: Sequence[flint.fmpz_mpoly]) -> ItemEvidence:
        """Return the evidence shared by all items with the same zeros."""
        return {
            "characteristic": self.characteristic,
            "zero": [self.text(z) for z in zeros],
            "relations": [self.text(r) for r in self.relations],
        }

    def direct(
        self, zeros: list[flint.fmpz_mpoly], goals: Sequence[tuple[flint.fmpz_mpoly, ...]]
    ) -> list[Item] | None:
        """Show that all polynomials of a goal lie in the ideal of the zeros."""
        conditions = self.conditions(zeros)
        for goal in goals or ((self.x.context.constant(1),),):
            targets = [g for g in goal if not self.is_zero(g)]
            found = member(conditions, targets, self.problem.clock)
            if found is not None:
                return [self.item(zeros, t, c) for t, c in zip(targets, found, strict=True)]
        return None

    def item(
        self, zeros: Sequence[flint.fmpz_mpoly], target: flint.fmpz_mpoly, found: Cofactors
    ) -> Item:
        """Return the evidence that a polynomial lies in the ideal generated by ``zeros``."""
        own: ItemEvidence = {
            "member": self.text(target),
            "cofactors": [self.text(f) for f in found.factors],
            "denominator": found.denominator,
        }
        return Item({**self.evidence(zeros), **own}, True, True, (found.denominator,))

    def by_contradiction(
        self, zeros: list[flint.fmpz_mpoly], goals: Sequence[tuple[flint.fmpz_mpoly, ...]]
    ) -> list[Item] | None:
        """Show, for each choice of one polynomial from each goal, that one of them must be 0."""
        choices = [[g for g in goal if not self.is_zero(g)] for goal in goals]
        # A goal that contains a nonzero constant is unreachable: it offers no choice.
        choices = [goal for goal in choices if not any(g.is_constant() for g in goal)]
        if math.prod(map(len, choices)) > MAX_CHOICES:
            return None
        used = [*zeros, *(g for goal in choices for g in goal)]
        nonzero = nonzero_constants_of(self.x, self.field, used)
        out = []
        for chosen in product(*choices):
            choice = (*chosen, *nonzero)
            if self.problem.is_late:
                return None
            conditions = self.conditions(zeros, choice)
            refutation = refute(conditions, self.rules, self.problem.clock)
            if refutation is None:
                return None
            own: ItemEvidence = {
                "nonzero": [self.text(g) for g in choice],
                "steps": [dict(step) for step in refutation.steps],
            }
            out.append(
                Item(
                    {**self.evidence(zeros), **own},
                    direct=False,
                    single=len(choices) <= 1,
                    denominators=refutation.denominators,
                    rules=refutation.rules,
                )
            )
        return out
