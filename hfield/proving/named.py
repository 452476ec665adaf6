"""Deciding a statement without quantifiers over one ring, nearly always a field."""

from collections.abc import Sequence
from dataclasses import replace
from time import monotonic

from hfield.errors import TooLargeError, UndecidedError
from hfield.proving import exhaustion
from hfield.proving.decision import (
    COMMUTATIVE_RINGS,
    FIELD,
    FIELDS,
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    characteristics,
)
from hfield.proving.expand import Expanded, expand
from hfield.proving.facts import rules
from hfield.proving.formulas import Clause
from hfield.proving.implication import Proof, prove_clauses
from hfield.proving.interpret import RingInterpretation
from hfield.proving.language import Statement
from hfield.proving.search import (
    Assignment,
    Searcher,
    letters_in,
    prime_search,
    ring_search,
    witness_texts,
)
from hfield.proving.setting import Setting
from hfield.proving.solve import solve
from hfield.proving.vanish import common_primes, vanishes, vanishes_as_function
from hfield.proving.witness import nonzero_place
from hfield.rings.base import Ring

QUICK, FEW, MANY = 120, 400, 20_000  # places looked at before, between and after proofs
SHORT = 0.5  # seconds for the first attempt at a proof


def decide(statement: Statement, setting: Setting, deadline: float) -> Decision:
    """Decide over the ring that the setting names."""
    field = setting.field
    assert field is not None
    if not field.is_exact:
        return _floats(statement, setting, deadline)
    if not field.is_field:
        return _ring(statement, setting, deadline)
    try:
        x = expand(statement, setting.constants)
    except TooLargeError as error:
        return _unexpanded(statement, setting, deadline, str(error))
    left = [c for c in x.clauses if not is_trivial(c, x, field)]
    scope = scope_of_identity(statement, x)
    if not left:
        return _identity(statement, x, field, scope)
    if any(_is_hopeless(c, x, field) for c in left):
        return _refuted_identity(statement, setting, x, left, deadline, scope)
    found = _look_quickly(statement, setting, deadline)
    if found is not None:
        return refuted("counterexample", field, found, scope)
    p = field.characteristic
    proof = prove_clauses(statement, setting, p, min(deadline, monotonic() + SHORT))
    if not proof.complete:
        found = _look(statement, setting, FEW, deadline)
        if found is not None:
            return refuted("counterexample", field, found, scope)
        found = _solve(statement, setting, x, left, deadline)
        if found is not None:
            return refuted("counterexample", field, found, scope)
        proof = prove_clauses(statement, setting, p, deadline)
    if proof.complete:
        return implied(proof, statement, setting)
    if field.order is not None:
        return _exhaust(statement, setting, x, deadline)
    found = _look(statement, setting, MANY, deadline)
    if found is not None:
        return refuted("counterexample", field, found, scope)
    return Decision(UNDECIDED, "none", tried=_tried(deadline, field))


def is_trivial(clause: Clause, x: Expanded, field: Ring) -> bool:
    """Tell whether a clause holds because a goal is identically 0, or a hypothesis a nonzero number."""
    if any(all(vanishes_as_function(p, x, field) for p in goal) for goal in clause.goals):
        return True
    return any(z.is_constant() and not vanishes(z, x, field) for z in clause.zeros)


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


def _is_hopeless(clause: Clause, x: Expanded, field: Ring) -> bool:
    """Tell whether a clause that is not trivial certainly fails somewhere: it has no hypotheses."""
    if any(not vanishes(z, x, field) for z in clause.zeros):
        return False
    return len(clause.goals) <= 1 or field.order is None


def _identity(statement: Statement, x: Expanded, field: Ring, scope: str | None) -> Decision:
    p = field.characteristic
    holds_in_p = scope in (COMMUTATIVE_RINGS, FIELDS) or (
        scope is not None and p in eval_characteristics(scope)
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


def eval_characteristics(scope: str) -> list[int]:
    """Read the numbers of a scope "characteristics [...]"."""
    inside = scope.partition("[")[2].rstrip("]")
    return [int(n) for n in inside.split(",") if n.strip()]


def _refuted_identity(
    statement: Statement,
    setting: Setting,
    x: Expanded,
    left: Sequence[Clause],
    deadline: float,
    scope: str | None,
) -> Decision:
    field = setting.field
    assert field is not None
    letters = letters_in(statement, setting.constants)
    found = _look(statement, setting, FEW, deadline)
    if found is None:
        for c in left:
            if _is_hopeless(c, x, field):
                goals = [
                    next(p for p in g if not vanishes_as_function(p, x, field)) for g in c.goals
                ]
                found = nonzero_place(statement, x, goals, field, letters)
                if found is not None:
                    break
    if found is None:
        return Decision(
            UNDECIDED, "identity", tried=("the identity fails, but no place was found",)
        )
    return refuted("identity", field, found, scope)


def refuted(method: str, field: Ring, found: Assignment, scope: str | None = None) -> Decision:
    """Return the refutation by the values found."""
    witness = witness_texts(field, found)
    shown = ", ".join(f"{name} = ({', '.join(v)})" for name, v in witness.items())
    steps = [f"over {field.name} the statement is false for {shown}" if shown else "it is false"]
    if scope is not None and scope.startswith("char"):
        steps.append(f"as a polynomial identity it holds exactly in {scope}")
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


def _look_quickly(statement: Statement, setting: Setting, deadline: float) -> Assignment | None:
    """Look at a few places of the prime field: a witness there serves every extension."""
    field = setting.field
    assert field is not None
    found = prime_search(statement, setting.constants, field.characteristic, QUICK, deadline)
    return None if found is None else lifted(field, found)


def lifted(field: Ring, found: Assignment) -> Assignment:
    """Turn numbers into elements of the field."""
    return {
        name: tuple(map(field, x)) if isinstance(x, tuple) else field(x)
        for name, x in found.items()
    }


def _look(statement: Statement, setting: Setting, limit: int, deadline: float) -> Assignment | None:
    """Look for a counterexample: among numbers first, then among elements of the ring."""
    field = setting.field
    assert field is not None
    if field.is_field:
        p = field.characteristic
        found = prime_search(statement, setting.constants, p, limit, deadline)
        if found is not None:
            return lifted(field, found)
    return ring_search(statement, setting.constants, field, limit, deadline)


def _solve(
    statement: Statement,
    setting: Setting,
    x: Expanded,
    left: Sequence[Clause],
    deadline: float,
) -> Assignment | None:
    """Look for a counterexample by solving the hypotheses, and test it in the statement itself."""
    field = setting.field
    assert field is not None
    letters = letters_in(statement, setting.constants)
    test = Searcher(statement, setting.constants, RingInterpretation(field), deadline).test
    for clause in left:
        found = solve(statement, x, clause, field, letters, min(deadline, monotonic() + SHORT))
        if found is not None and test(found):
            return found
    return None


def _exhaust(
    statement: Statement, setting: Setting, x: Expanded | None, deadline: float
) -> Decision:
    field = setting.field
    assert field is not None
    used = None if x is None else used_variables(x)
    try:
        found, cases = exhaustion.counterexample(
            statement, setting.constants, field, used, deadline
        )
    except (TooLargeError, UndecidedError) as error:
        found = _look(statement, setting, MANY, deadline)
        if found is not None:
            return refuted("counterexample", field, found)
        return Decision(UNDECIDED, "none", tried=(str(error), f"{MANY} small places"))
    if found is not None:
        return refuted("exhaustion", field, found)
    steps = (f"true in each of the {cases} cases over {field.name}",)
    evidence = {"kind": "exhaustion", "cases": cases}
    return Decision(PROVED, "exhaustion", steps=steps, scope=FIELD, evidence=evidence)


def used_variables(x: Expanded) -> frozenset[str]:
    """Return the coordinates that the clauses depend on."""
    polynomials = [p for c in x.clauses for p in (*c.zeros, *(g for goal in c.goals for g in goal))]
    degrees: list[int] = [0] * len(x.variables)
    for p in polynomials:
        degrees = [a + int(b) for a, b in zip(degrees, p.degrees(), strict=True)]
    return frozenset(name for name, d in zip(x.variables, degrees, strict=True) if d)


def _tried(deadline: float, field: Ring) -> tuple[str, ...]:
    tried = [f"{MANY} small places over {field.name}", "ideal membership of the conclusion"]
    if monotonic() > deadline:
        tried.append("the time was over")
    return tuple(tried)


def _unexpanded(statement: Statement, setting: Setting, deadline: float, why: str) -> Decision:
    """Do what can be done without polynomials: look for a counterexample, or try all cases."""
    field = setting.field
    assert field is not None
    found = _look(statement, setting, FEW, deadline)
    if found is not None:
        return refuted("counterexample", field, found)
    if field.order is not None:
        return _exhaust(statement, setting, None, deadline)
    return Decision(UNDECIDED, "none", tried=(why, f"{FEW} small places"))


def _ring(statement: Statement, setting: Setting, deadline: float) -> Decision:
    """Decide over a ring that is no field: by what holds over all commutative rings, or by cases."""
    field = setting.field
    assert field is not None
    found = _look(statement, setting, FEW, deadline)
    if found is not None:
        return refuted("counterexample", field, found)
    tried = [f"{FEW} small places over {field.name}"]
    try:
        x = expand(statement, setting.constants)
    except TooLargeError as error:
        x = None
        tried.append(str(error))
    if x is not None and not statement.divides:
        if all(any(all(vanishes(p, x, field) for p in g) for g in c.goals) for c in x.clauses):
            return _identity(statement, x, field, scope_of_identity(statement, x))
        proof = prove_clauses(statement, setting, 0, deadline)
        if proof.complete and (proof.is_direct or field.name == "ZZ"):
            return implied(proof, statement, setting)
        tried.append("ideal membership of the conclusion")
    if field.order is not None:
        return _exhaust(statement, setting, x, deadline)
    return Decision(UNDECIDED, "none", tried=tuple(tried))


def _floats(statement: Statement, setting: Setting, deadline: float) -> Decision:
    """Gather evidence over an inexact ring: small integers are exact there and may refute."""
    field = setting.field
    assert field is not None
    exact = replace(setting, field=None)
    if not statement.divides and not statement.constants:
        found = prime_search(statement, exact.constants, 0, FEW, deadline)
        if found is not None:
            return refuted("floats, exact on small integers", field, lifted(field, found))
    tried = (f"{field.name} is inexact, so nothing is proved there: decide over RR or QQ",)
    return Decision(UNDECIDED, "floats", tried=tried)
