"""Deciding a statement without quantifiers over one ring, nearly always a field."""

from collections.abc import Sequence
from time import monotonic

from hfield.errors import TooLargeError
from hfield.proving.counterexamples.candidates import letters_in, prime_search
from hfield.proving.counterexamples.nonzero_place import nonzero_place
from hfield.proving.counterexamples.refuting import (
    FEW,
    MANY,
    SHORT,
    exhaust,
    lifted,
    look,
    look_quickly,
    solve_clauses,
)
from hfield.proving.decision import UNDECIDED, Decision
from hfield.proving.methods import over_rings
from hfield.proving.methods.answers import identity, implied, refuted, scope_of_identity
from hfield.proving.methods.field_rules import unused_norm
from hfield.proving.methods.implications import prove_clauses
from hfield.proving.polynomials.expansion import Expanded, expand
from hfield.proving.polynomials.normal_form import Clause
from hfield.proving.polynomials.vanishing import is_nonzero_constant, vanishes, vanishes_as_function
from hfield.proving.statements.language import Statement
from hfield.proving.statements.setting import Setting
from hfield.rings.base import Ring


def decide(statement: Statement, setting: Setting, deadline: float) -> Decision:
    """Decide over the ring that the setting names."""
    field = setting.field
    assert field is not None
    if not field.is_exact:
        return _floats(statement, setting, deadline)
    if not field.is_field:
        return over_rings.decide(statement, setting, deadline, decide)
    try:
        x = expand(statement, setting.constants)
    except TooLargeError as error:
        return _unexpanded(statement, setting, deadline, str(error))
    left = [c for c in x.clauses if not is_trivial(c, x, field)]
    if not left:
        return identity(statement, x, field, scope_of_identity(statement, x))
    if any(_is_hopeless(c, x, field) for c in left):
        return _refuted_identity(statement, setting, x, left, deadline)
    found = look_quickly(statement, setting, deadline)
    if found is not None:
        return refuted(field, found, statement, x)
    p = field.characteristic
    proof = prove_clauses(statement, setting, p, min(deadline, monotonic() + SHORT))
    if not proof.complete:
        found = look(statement, setting, FEW, deadline)
        if found is not None:
            return refuted(field, found, statement, x)
        found = solve_clauses(statement, setting, x, left, deadline)
        if found is not None:
            return refuted(field, found, statement, x)
        proof = prove_clauses(statement, setting, p, deadline)
    if proof.complete:
        return implied(proof, statement, setting)
    if field.order is not None:
        return exhaust(statement, setting, x, deadline)
    found = look(statement, setting, MANY, deadline)
    if found is not None:
        return refuted(field, found, statement, x)
    return Decision(UNDECIDED, "none", tried=_tried(deadline, setting, field))


def is_trivial(clause: Clause, x: Expanded, field: Ring) -> bool:
    """Tell whether a clause holds because a goal is identically 0, or a hypothesis a nonzero number."""
    if any(all(vanishes_as_function(p, x, field) for p in goal) for goal in clause.goals):
        return True
    return any(is_nonzero_constant(z, x, field) for z in clause.zeros)


def _is_hopeless(clause: Clause, x: Expanded, field: Ring) -> bool:
    """Tell whether a clause that is not trivial certainly fails somewhere: it has no hypotheses."""
    if any(not vanishes(z, x, field) for z in clause.zeros):
        return False
    return len(clause.goals) <= 1 or field.order is None


def _refuted_identity(
    statement: Statement,
    setting: Setting,
    x: Expanded,
    left: Sequence[Clause],
    deadline: float,
) -> Decision:
    field = setting.field
    assert field is not None
    letters = letters_in(statement, setting.constants)
    found = look(statement, setting, FEW, deadline)
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
    return refuted(field, found, statement, x)


def _tried(deadline: float, setting: Setting, field: Ring) -> tuple[str, ...]:
    tried = [f"{MANY} small places over {field.name}", "ideal membership of the conclusion"]
    why = unused_norm(setting)
    if why is not None:
        tried.append(why)
    if monotonic() > deadline:
        tried.append("the time was over")
    return tuple(tried)


def _unexpanded(statement: Statement, setting: Setting, deadline: float, why: str) -> Decision:
    """Do what can be done without polynomials: look for a counterexample, or try all cases."""
    field = setting.field
    assert field is not None
    found = look(statement, setting, FEW, deadline)
    if found is not None:
        return refuted(field, found, statement)
    if field.order is not None:
        return exhaust(statement, setting, None, deadline)
    return Decision(UNDECIDED, "none", tried=(why, f"{FEW} small places"))


def _floats(statement: Statement, setting: Setting, deadline: float) -> Decision:
    """Gather evidence over an inexact ring: small integers are exact there and may refute."""
    field = setting.field
    assert field is not None
    if not statement.divides and not statement.constants:
        found = prime_search(statement, setting.constants, 0, FEW, deadline)
        if found is not None:
            return refuted(field, lifted(field, found), statement)
    tried = (f"{field.name} is inexact, so nothing is proved there: decide over RR or QQ",)
    return Decision(UNDECIDED, "floats", tried=tried)
