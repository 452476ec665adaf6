"""Statements that something exists, and hypotheses that nothing satisfies."""

from dataclasses import replace
from itertools import islice
from time import monotonic
from typing import Any

from hfield.errors import HFieldError
from hfield.proving import everywhere, named
from hfield.proving.decision import FIELD, PROVED, REFUTED, UNDECIDED, VACUOUS, Decision
from hfield.proving.defined import algebra_exists
from hfield.proving.language import Sort, Statement
from hfield.proving.places import lifted
from hfield.proving.printing import to_text
from hfield.proving.search import by_weight, small_scalars, witness_texts
from hfield.proving.setting import Setting, put_letters
from hfield.proving.terms import Decide, about, by_terms, constants_in, matrix, true_place
from hfield.proving.trees import quaternion_node, substitute
from hfield.rings import ring
from hfield.syntax import Logic, Negate, Not, Number, parse

FEW = 400
MAX_PLACES = 2_000


def vacuous(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision | None:
    """Return the decision "vacuous" if the hypotheses are proved unsatisfiable, else None."""
    node = statement.hypotheses[0]
    for h in statement.hypotheses[1:]:
        node = Logic("and", node, h)
    if true_place(about(statement, node), setting, FEW, deadline) is not None:
        return None
    never = about(statement, Not(node))
    decision = decide_one(never, setting, deadline)
    if decision.verdict != PROVED:
        return None
    evidence = {"kind": "unsatisfiable", "proof": decision.evidence}
    steps = (*decision.steps, "so the hypotheses are never all true")
    return replace(decision, verdict=VACUOUS, steps=steps, evidence=evidence)


def decide(statement: Statement, setting: Setting, deadline: float, decide_one: Decide) -> Decision:
    """Decide "for all the other unknowns there exist …"."""
    free = [(name, sort) for name, sort in statement.unknowns if name not in statement.exists]
    if setting.field is None:
        return _everywhere(statement, setting, deadline, bool(free))
    if free:
        return _for_all_exists(statement, setting, deadline, decide_one)
    return _exists(statement, setting, deadline, decide_one)


def _exists(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision:
    """Decide over one field, with nothing given: a witness, or a proof that there is none."""
    node = matrix(statement)
    found = true_place(about(statement, node), setting, FEW, deadline)
    if found is not None:
        return _witnessed(setting, found)
    decision = decide_one(about(statement, Not(node)), setting, deadline)
    if decision.verdict == REFUTED:
        evidence = {**(decision.evidence or {}), "kind": "witness"}
        return replace(
            decision,
            verdict=PROVED,
            method="witness",
            scope=FIELD,
            evidence=evidence,
            steps=(f"true for {_shown(decision.witness or {})}",),
        )
    if decision.verdict == PROVED:
        evidence = {"kind": "none exists", "proof": decision.evidence}
        steps = (*decision.steps, "so there is none")
        return replace(decision, verdict=REFUTED, scope=None, evidence=evidence, steps=steps)
    return decision


def _witnessed(setting: Setting, found: Any) -> Decision:
    field = setting.field
    assert field is not None
    witness = witness_texts(field, lifted(field, found))
    return Decision(
        PROVED,
        "witness",
        witness=witness,
        steps=(f"true for {_shown(witness)}",),
        scope=FIELD,
        evidence={"kind": "witness", "field": field.name, "values": witness},
    )


def _shown(witness: Any) -> str:
    return ", ".join(f"{name} = ({', '.join(v)})" for name, v in witness.items())


def _everywhere(
    statement: Statement, setting: Setting, deadline: float, has_free: bool
) -> Decision:
    """Decide over all fields: terms that serve everywhere, or a field where there is none."""
    decision = by_terms(statement, setting, deadline, everywhere.decide)
    if decision is not None:
        return decision
    for name in everywhere.FIELDS_TRIED:
        left = deadline - monotonic()
        if left <= 0:
            break
        there = replace(setting, field=ring(name))
        if not algebra_exists(statement, there, deadline):
            continue
        one = decide(statement, there, monotonic() + max(0.2 * left, 0.1), named.decide)
        if one.verdict == REFUTED:
            return everywhere.elsewhere(one, name)
    tried = ("terms in the unknowns", f"each of {', '.join(everywhere.FIELDS_TRIED)}")
    return Decision(UNDECIDED, "none", tried=tried)


def _for_all_exists(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision:
    decision = by_terms(statement, setting, deadline, decide_one)
    if decision is not None:
        return decision
    found = _at_zero(statement, setting, deadline, decide_one)
    if found is not None:
        decision = by_terms(statement, setting, deadline, decide_one, [found])
        if decision is not None:
            return decision
    return _by_places(statement, setting, deadline, decide_one)


def _at_zero(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> tuple[str, ...] | None:
    """Return what exists when all that is given is 0 (letters −1): it may serve everywhere."""
    free = [name for name, _ in statement.unknowns if name not in statement.exists]
    values = {name: Number(0) for name in free}
    there = put_letters(setting, {name: Negate(Number(1)) for name in setting.letters})
    if not algebra_exists(statement, there, deadline):
        return None
    node = substitute(matrix(statement), values)
    one = _exists(
        about(statement, node, statement.exists, setting.field), there, deadline, decide_one
    )
    if one.verdict != PROVED or one.witness is None:
        return None
    return tuple(to_text(quaternion_node(one.witness[name])) for name in statement.exists)


def _by_places(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision:
    """Refute at one place of the given unknowns, or prove at all of them over a finite field."""
    field = setting.field
    assert field is not None
    free = [(name, sort) for name, sort in statement.unknowns if name not in statement.exists]
    width = sum(1 if sort is Sort.SCALAR else 4 for _, sort in free)
    finite = field.order is not None and field.order**width <= MAX_PLACES
    scalars: list[Any] = list(field.elements()) if finite else list(small_scalars(field))[:5]
    places = by_weight(free, scalars, len(scalars) * width if finite else 4)
    node = matrix(statement)
    count = 0
    for place in places if finite else islice(places, 40):
        values = {
            name: quaternion_node([field.text(u) for u in x])
            if isinstance(x, tuple)
            else parse(field.text(x))
            for name, x in place.items()
        }
        instance = about(statement, substitute(node, values), statement.exists, field)
        there = put_letters(setting, values)
        new = (c for text in there.constants for c in constants_in(parse(text), field))
        constants = tuple(dict.fromkeys((*instance.constants, *new)))
        instance = replace(instance, divides=True, constants=constants)
        count += 1
        if not algebra_exists(instance, there, deadline):
            continue
        try:
            one = _exists(instance, there, deadline, decide_one)
        except HFieldError:
            return Decision(UNDECIDED, "none", tried=("values of the unknowns one by one",))
        if one.verdict == REFUTED:
            witness = witness_texts(field, place)
            evidence = {"kind": "place", "values": witness, "proof": one.evidence}
            steps = (f"at {_shown(witness)} there is none", *one.steps)
            return replace(one, witness=witness, steps=steps, evidence=evidence)
        if finite and one.verdict != PROVED:
            return one
    if finite and monotonic() < deadline:
        steps = (f"there is one for each of the {count} values of what is given",)
        counted: dict[str, Any] = {"kind": "exhaustion", "cases": count}
        return Decision(PROVED, "exhaustion", steps=steps, scope=FIELD, evidence=counted)
    return Decision(UNDECIDED, "none", tried=("terms in the unknowns", f"{count} places"))
