"""Proving clauses: from polynomials that are 0 to one that is, over all fields of a characteristic."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from time import monotonic
from typing import Any

from hfield.proving.decision import (
    COMMUTATIVE_RINGS,
    FIELD,
    FIELDS,
    REDUCED_RINGS,
    characteristics,
)
from hfield.proving.methods.contradiction import Problem, member, refute
from hfield.proving.methods.field_rules import ROOTS, Rule, rules
from hfield.proving.methods.starting_relations import (
    nonzero_constants_of,
    quaternions_of,
    relations_of,
)
from hfield.proving.polynomials.expansion import Expanded, expand
from hfield.proving.polynomials.normal_form import Clause
from hfield.proving.polynomials.recognition import polynomial_text
from hfield.proving.polynomials.vanishing import is_nonzero_constant, vanishes
from hfield.proving.statements.language import Statement
from hfield.proving.statements.setting import Setting
from hfield.rings.base import Ring

MAX_CHOICES = 64


@dataclass(frozen=True)
class Item:
    """One entry of the evidence, with what its scope depends on."""

    evidence: Mapping[str, Any]
    direct: bool
    single: bool
    denominators: tuple[int, ...]
    rules: tuple[Rule, ...] = ()


@dataclass(frozen=True)
class Proof:
    """Items for all clauses; ``complete`` when every clause is proved over the setting's fields."""

    items: tuple[Item, ...]
    characteristic: int
    complete: bool
    has_constants: bool

    @property
    def denominator(self) -> int:
        """The product of all numbers that were divided by."""
        return math.prod(d for item in self.items for d in set(item.denominators))

    @property
    def is_direct(self) -> bool:
        """Whether the proof is valid over every commutative ring."""
        return all(item.direct for item in self.items) and abs(self.denominator) == 1

    def scope(self, statement: Statement) -> str:
        """Return where the proof is valid."""
        if self.rules or self.has_constants:
            return FIELD
        if self.characteristic:  # by contradiction it is shown over fields, not over F₂[ε]
            fields_only = statement.divides or statement.compares_unequal
            direct = self.is_direct and not fields_only
            return characteristics([self.characteristic]) if direct else FIELD
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
        """Return the proof as lines for people."""
        lines = []
        for item in self.items:
            e = item.evidence
            if "member" in e:
                shown = " + ".join(
                    f"({c})·h{n}" for n, c in enumerate(e["cofactors"], 1) if c != "0"
                )
                scale = "" if e["denominator"] == 1 else f"{e['denominator']}·"
                lines.append(f"{scale}({e['member']}) = {shown or 0}, with hₙ = 0 the hypotheses")
            else:
                nonzero = " and ".join(f"{g} ≠ 0" for g in e["nonzero"]) or "the hypotheses"
                rule_count = sum(step["step"] != "contradiction" for step in e["steps"])
                extra = f" after {rule_count} conclusions of the field" if rule_count else ""
                lines.append(f"{nonzero} would put 1 into the ideal of the hypotheses{extra}")
        return tuple(dict.fromkeys(lines))


def prove_clauses(
    statement: Statement, setting: Setting, characteristic: int, deadline: float
) -> Proof:
    """Try to prove all clauses over the fields of a characteristic, with the rules of the setting.

    The general proof, which uses no rules and no characteristic, is tried first, since it serves
    every field. A proof that is not ``complete`` proves nothing.
    """
    x = expand(statement, setting.constants)
    if not x.has_constants:
        general = _prove(statement, setting.constants, 0, None, deadline)
        if general.complete and _fits(general, characteristic):
            return general
        if characteristic:
            special = _prove(statement, setting.constants, characteristic, None, deadline)
            if special.complete:
                return special
    named = setting if setting.field is not None and setting.field.is_field else None
    if named is None or not (x.has_constants or rules(named)):
        return Proof((), characteristic, False, x.has_constants)
    return _prove(statement, setting.constants, characteristic, named, deadline)


def _fits(proof: Proof, characteristic: int) -> bool:
    return characteristic == 0 or proof.denominator % characteristic != 0


_proofs: dict[Any, Proof] = {}
MAX_KEPT = 4_096


def _prove(
    statement: Statement,
    constants: tuple[str, str, str],
    characteristic: int,
    setting: Setting | None,
    deadline: float,
) -> Proof:
    """Prove with a memory, since many fields ask the same; what failed for lack of time is retried."""
    kinds = () if setting is None else tuple((r.form, r.most, r.positive) for r in rules(setting))
    x = expand(statement, constants)
    depends = setting is not None and (x.has_constants or any(k[0] == ROOTS for k in kinds))
    field = setting.field if setting is not None and depends else None
    key = (statement, constants, characteristic, kinds, field)
    if key not in _proofs:
        proof = _attempt(statement, constants, x, characteristic, setting, deadline)
        if not proof.complete and monotonic() > deadline:
            return proof
        if len(_proofs) >= MAX_KEPT:
            _proofs.clear()
        _proofs[key] = proof
    return _proofs[key]


def _attempt(
    statement: Statement,
    constants: tuple[str, str, str],
    x: Expanded,
    characteristic: int,
    setting: Setting | None,
    deadline: float,
) -> Proof:
    field = setting.field if setting is not None else None
    own = rules(setting) if setting is not None else ()
    quaternions = quaternions_of(statement, constants) if own else ()
    items: list[Item] = []
    for clause in x.clauses:
        found = _clause(clause, x, characteristic, field, own, quaternions, deadline)
        if found is None:
            return Proof((), characteristic, False, x.has_constants)
        items.extend(found)
    return Proof(tuple(items), characteristic, True, x.has_constants)


def _clause(
    clause: Clause,
    x: Expanded,
    characteristic: int,
    field: Ring | None,
    own: Sequence[Rule],
    quaternions: tuple[tuple[tuple[Any, ...], Any], ...],
    deadline: float,
) -> list[Item] | None:
    def zero(p: Any) -> bool:
        if field is not None:
            return vanishes(p, x, field)
        return bool(p == 0 or (characteristic and int(p.content()) % characteristic == 0))

    def nonzero_number(p: Any) -> bool:
        if field is not None:
            return is_nonzero_constant(p, x, field)
        return bool(p.is_constant() and not zero(p) and (characteristic or p in (1, -1)))

    if any(all(map(zero, goal)) for goal in clause.goals) or any(map(nonzero_number, clause.zeros)):
        return []
    zeros = [z for z in clause.zeros if not zero(z)]
    relations = relations_of(x, field)
    problem = _problem(x, field, characteristic, (*zeros, *relations), (), ())
    texts = [polynomial_text(z, x.variables) for z in zeros]
    known = [polynomial_text(r, x.variables) for r in relations]
    for goal in clause.goals or ((x.context.constant(1),),):
        targets = [g for g in goal if not zero(g)]
        found = member(problem, targets, deadline)
        if found is not None:
            return [
                Item(
                    {
                        "characteristic": characteristic,
                        "zero": texts,
                        "relations": known,
                        "member": polynomial_text(t, x.variables),
                        "cofactors": [polynomial_text(f, x.variables) for f in c.factors],
                        "denominator": c.denominator,
                    },
                    direct=True,
                    single=True,
                    denominators=(c.denominator,),
                )
                for t, c in zip(targets, found, strict=True)
            ]
    choices = [[g for g in goal if not zero(g)] for goal in clause.goals]
    # A goal with a number in it that is not 0 is out of reach: there is nothing to choose from it.
    choices = [goal for goal in choices if not any(g.is_constant() for g in goal)]
    if math.prod(map(len, choices)) > MAX_CHOICES:
        return None
    out = []
    nonzero = nonzero_constants_of(x, field, [*zeros, *(g for goal in choices for g in goal)])
    for chosen in product(*choices):
        choice = (*chosen, *nonzero)
        if monotonic() > deadline:
            return None
        problem = _problem(x, field, characteristic, (*zeros, *relations), choice, quaternions)
        refutation = refute(problem, own, deadline)
        if refutation is None:
            return None
        evidence: dict[str, Any] = {
            "characteristic": characteristic,
            "zero": texts,
            "relations": known,
            "nonzero": [polynomial_text(g, x.variables) for g in choice],
            "steps": [dict(step) for step in refutation.steps],
        }
        out.append(
            Item(
                evidence,
                direct=False,
                single=len(choices) <= 1,
                denominators=refutation.denominators,
                rules=refutation.rules,
            )
        )
    return out


def _problem(
    x: Expanded,
    field: Ring | None,
    characteristic: int,
    zeros: tuple[Any, ...],
    nonzero: tuple[Any, ...],
    quaternions: tuple[tuple[tuple[Any, ...], Any], ...],
) -> Problem:
    return Problem(x.variables, x.unknowns, field, characteristic, zeros, nonzero, quaternions)
