"""Decisions put together from what the procedures found."""

from hfield.proving.decision import (
    COMMUTATIVE_RINGS,
    FIELD,
    FIELDS,
    PROVED,
    REFUTED,
    Decision,
    characteristics,
)
from hfield.proving.expand import Expanded
from hfield.proving.facts import rules
from hfield.proving.implication import Proof
from hfield.proving.language import Statement
from hfield.proving.search import Assignment, witness_texts
from hfield.proving.setting import Setting
from hfield.proving.vanish import common_primes
from hfield.rings.base import Ring


def scope_of_identity(statement: Statement, x: Expanded) -> str | None:
    """Return the characteristics in which all clauses are polynomial identities."""
    if x.has_constants or any(not c.goals for c in x.clauses):
        return None
    if not x.clauses:
        fields_only = statement.divides or statement.compares_unequal
        return FIELDS if fields_only else COMMUTATIVE_RINGS
    primes: set[int] | None = None
    for c in x.clauses:
        own: set[int] = set()
        for goal in c.goals:
            own.update(common_primes(list(goal)) or ())
        primes = own if primes is None else primes & own
    return characteristics(list(primes)) if primes else None


def identity(statement: Statement, x: Expanded, field: Ring, scope: str | None) -> Decision:
    """Return the decision "proved" for what holds coefficient by coefficient."""
    p = field.characteristic
    holds_in_p = scope in (COMMUTATIVE_RINGS, FIELDS) or (
        scope is not None and p in _listed_characteristics(scope)
    )
    if not holds_in_p:
        scope = FIELD
    steps = [f"expand both sides in the {x.unknowns} coordinates of the unknowns"]
    if scope in (COMMUTATIVE_RINGS, FIELDS):
        steps.append("all coefficients of the difference are 0 in ℤ")
    elif holds_in_p:
        steps.append(f"all coefficients of the difference are divisible by {p}")
    elif field.order is not None:
        steps.append(f"all coefficients of the difference are 0 after reducing x^{field.order} = x")
    else:
        steps.append(f"all coefficients of the difference are 0 in {field.name}")
    return Decision(
        PROVED, "identity", steps=tuple(steps), scope=scope, evidence={"kind": "identity"}
    )


def _listed_characteristics(scope: str) -> list[int]:
    """Read the numbers of a scope "characteristics [...]"."""
    inside = scope.partition("[")[2].rstrip("]")
    return [int(n) for n in inside.split(",") if n.strip()]


def refuted(
    method: str,
    field: Ring,
    found: Assignment,
    scope: str | None = None,
    exactly: bool = False,
) -> Decision:
    """Return the refutation by the values found; ``exactly`` where the scope is known to be all."""
    witness = witness_texts(field, found)
    shown = ", ".join(f"{name} = ({', '.join(v)})" for name, v in witness.items())
    steps = [f"over {field.name} the statement is false for {shown}" if shown else "it is false"]
    if scope is not None and scope.startswith("char"):
        primes = _listed_characteristics(scope)
        shown = f"characteristic{'s' if len(primes) > 1 else ''} {', '.join(map(str, primes))}"
        steps.append(f"it holds {'exactly ' if exactly else ''}in {shown}")
    return Decision(
        REFUTED,
        method,
        witness=witness,
        steps=tuple(steps),
        scope=scope,
        evidence={"kind": "witness", "field": field.name, "values": witness},
    )


def implied(proof: Proof, statement: Statement, setting: Setting) -> Decision:
    """Return the decision "proved" by a complete proof."""
    used = [rule for rule in rules(setting) if rule.form in proof.forms]
    facts = [f"over {setting.algebra} {rule}" for rule in used]
    assumes = tuple(dict.fromkeys(a for rule in used for a in rule.assumes))
    evidence = {
        "kind": "implication",
        "facts": [dict(rule.evidence) for rule in used],
        "items": [dict(item.evidence) for item in proof.items],
    }
    scope, steps = proof.scope(statement), (*facts, *proof.steps)
    return Decision(PROVED, "implication", None, steps, scope, assumes, (), evidence)
