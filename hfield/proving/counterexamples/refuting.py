"""Places where a statement fails: looked for, solved for, or all tried."""

from collections.abc import Iterator, Sequence
from time import monotonic
from typing import Any

from hfield.errors import TooLargeError, UndecidedError
from hfield.proving.counterexamples.candidates import (
    Assignment,
    Searcher,
    letters_in,
    prime_search,
    ring_search,
)
from hfield.proving.counterexamples.solving import solve
from hfield.proving.decision import FIELD, PROVED, UNDECIDED, Decision
from hfield.proving.evaluation.all_cases import counterexample
from hfield.proving.evaluation.interpretation import RingInterpretation
from hfield.proving.methods.answers import refuted
from hfield.proving.methods.starting_relations import quaternions_of
from hfield.proving.polynomials.expansion import Expanded
from hfield.proving.polynomials.normal_form import Clause
from hfield.proving.statements.language import Statement
from hfield.proving.statements.setting import Setting
from hfield.rings.base import Ring

QUICK, FEW, MANY = 120, 400, 20_000  # places looked at before, between and after proofs
MAX_AXES = 8
SHORT = 0.5  # seconds for the first attempt at a proof, and for solving one clause


def look_quickly(statement: Statement, setting: Setting, deadline: float) -> Assignment | None:
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


def look(statement: Statement, setting: Setting, limit: int, deadline: float) -> Assignment | None:
    """Look for a counterexample: among numbers first, then among elements of the ring."""
    field = setting.field
    assert field is not None
    if field.is_field:
        p = field.characteristic
        found = prime_search(statement, setting.constants, p, limit, deadline)
        if found is not None:
            return lifted(field, found)
    return ring_search(statement, setting.constants, field, limit, deadline)


def solve_clauses(
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
    quaternions = quaternions_of(statement, setting.constants)
    for clause in left:
        for narrower in (*narrowed(clause, quaternions), clause, *on_axes(clause)):
            soon = min(deadline, monotonic() + SHORT)
            found = solve(statement, x, narrower, field, letters, soon)
            if found is not None and test(found):
                return found
    return None


def on_axes(clause: Clause) -> Iterator[Clause]:
    """Run through clauses in which all variables of the conditions but one are 0."""
    gens = clause.zeros[0].context().gens() if clause.zeros else ()
    used = [g for n, g in enumerate(gens) if any(z.degrees()[n] for z in clause.zeros)]
    for own in used[:MAX_AXES] if len(used) > 1 else ():
        yield Clause((*clause.zeros, *(g for g in used if g != own)), clause.goals)


def narrowed(
    clause: Clause, quaternions: Sequence[tuple[tuple[Any, ...], Any]]
) -> Iterator[Clause]:
    """Run through clauses with more conditions, at whose places the clause fails too.

    A norm is 0 where its quaternion is, and a quadratic polynomial that is never negative where its
    gradient is: those are linear conditions, which small places may all miss, as in ``norm(p + 7)``.
    """
    for q, norm in quaternions:
        if norm in clause.zeros or -norm in clause.zeros:
            others = [z for z in clause.zeros if z not in (norm, -norm)]
            yield Clause((*others, *(u for u in q if u != 0)), clause.goals)
    bent = [z for z in clause.zeros if z.total_degree() == 2]
    if bent:
        slopes = [z.derivative(n) for z in bent for n in range(z.context().nvars())]
        yield Clause((*clause.zeros, *(f for f in slopes if f != 0)), clause.goals)


def exhaust(
    statement: Statement, setting: Setting, x: Expanded | None, deadline: float
) -> Decision:
    """Decide over a finite ring by all cases; when they are too many, look at small places."""
    field = setting.field
    assert field is not None
    used = None if x is None else used_variables(x)
    try:
        found, cases = counterexample(statement, setting.constants, field, used, deadline)
    except (TooLargeError, UndecidedError) as error:
        found = look(statement, setting, MANY, deadline)
        if found is not None:
            return refuted(field, found, statement)
        return Decision(UNDECIDED, "none", tried=(str(error), f"{MANY} small places"))
    if found is not None:
        return refuted(field, found, statement)
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
