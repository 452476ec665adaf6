"""Statements that something exists, and hypotheses that nothing satisfies."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from itertools import islice, product
from time import monotonic
from typing import Any

from hfield.errors import HFieldError, TooLargeError
from hfield.proving import everywhere, named
from hfield.proving.decision import (
    FIELD,
    FIELDS,
    PROVED,
    REFUTED,
    UNDECIDED,
    VACUOUS,
    Decision,
)
from hfield.proving.language import BASIS, Sort, Statement
from hfield.proving.named import lifted
from hfield.proving.printing import to_text
from hfield.proving.search import (
    by_weight,
    prime_search,
    ring_search,
    small_scalars,
    witness_texts,
)
from hfield.proving.setting import Setting
from hfield.proving.substitute import quaternion_node, substitute
from hfield.rings import ring
from hfield.syntax import Logic, Node, Not, Number, parse

Decide = Callable[[Statement, Setting, float], Decision]
FEW, MANY = 400, 20_000
MAX_TERMS = 400  # terms tried for what is said to exist
MAX_PLACES = 2_000


def matrix(statement: Statement) -> Node:
    """Return the statement without its quantifier: hypotheses ⇒ conclusion."""
    node = statement.conclusion
    for h in reversed(statement.hypotheses):
        node = Logic("=>", h, node)
    return node


def about(statement: Statement, node: Node, names: tuple[str, ...] | None = None) -> Statement:
    """Return the statement ``node`` for all values of the unknowns of ``statement`` (or ``names``)."""
    unknowns = statement.unknowns
    if names is not None:
        unknowns = tuple((name, sort) for name, sort in unknowns if name in names)
    hypotheses: list[Node] = []
    conclusion = node
    while isinstance(conclusion, Logic) and conclusion.op == "=>":
        hypotheses.append(conclusion.left)
        conclusion = conclusion.right
    return replace(
        statement,
        text=to_text(node),
        node=node,
        unknowns=unknowns,
        exists=(),
        hypotheses=tuple(hypotheses),
        conclusion=conclusion,
    )


def vacuous(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision | None:
    """Return the decision "vacuous" if the hypotheses are proved unsatisfiable, else None."""
    node = statement.hypotheses[0]
    for h in statement.hypotheses[1:]:
        node = Logic("and", node, h)
    if _found(about(statement, node), setting, FEW, deadline) is not None:
        return None
    never = about(statement, Not(node))
    decision = decide_one(never, setting, deadline)
    if decision.verdict != PROVED:
        return None
    evidence = {"kind": "unsatisfiable", "proof": decision.evidence}
    steps = (*decision.steps, "so the hypotheses are never all true")
    return replace(decision, verdict=VACUOUS, steps=steps, evidence=evidence)


def _found(statement: Statement, setting: Setting, limit: int, deadline: float) -> Any:
    """Return values that make the statement true, or None."""
    field = setting.field
    primes = (0, 2, 3) if field is None else (field.characteristic,) if field.is_field else ()
    for p in primes:
        found = prime_search(statement, setting.constants, p, limit, deadline, True)
        if found is not None:
            return found
    if field is None:
        return None
    return ring_search(statement, setting.constants, field, limit, deadline, True)


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
    found = _found(about(statement, node), setting, FEW, deadline)
    if found is not None:
        return _witnessed(setting, found)
    decision = decide_one(about(statement, Not(node)), setting, deadline)
    if decision.verdict == REFUTED:
        evidence = {**(decision.evidence or {}), "kind": "witness"}
        steps = (f"true for {_shown(decision.witness or {})}",)
        return replace(
            decision, verdict=PROVED, method="witness", scope=FIELD, evidence=evidence, steps=steps
        )
    if decision.verdict == PROVED:
        evidence = {"kind": "none exists", "proof": decision.evidence}
        steps = (*decision.steps, "so there is none")
        return replace(decision, verdict=REFUTED, evidence=evidence, steps=steps)
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
    decision = _by_terms(statement, setting, deadline, everywhere.decide)
    if decision is not None:
        return decision
    for name in everywhere.FIELDS_TRIED:
        left = deadline - monotonic()
        if left <= 0:
            break
        there = replace(setting, field=ring(name))
        one = decide(statement, there, monotonic() + max(0.2 * left, 0.1), named.decide)
        if one.verdict == REFUTED:
            return everywhere.elsewhere(one, name)
    tried = ("terms in the unknowns", f"each of {', '.join(everywhere.FIELDS_TRIED)}")
    return Decision(UNDECIDED, "none", tried=tried)


def _for_all_exists(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> Decision:
    decision = _by_terms(statement, setting, deadline, decide_one)
    if decision is not None:
        return decision
    found = _at_zero(statement, setting, deadline, decide_one)
    if found is not None:
        decision = _by_terms(statement, setting, deadline, decide_one, [found])
        if decision is not None:
            return decision
    return _by_places(statement, setting, deadline, decide_one)


def _by_terms(
    statement: Statement,
    setting: Setting,
    deadline: float,
    decide_one: Decide,
    choices: Iterable[tuple[str, ...]] | None = None,
) -> Decision | None:
    """Prove by a term in the given unknowns for each one that is said to exist."""
    free = {name: sort for name, sort in statement.unknowns if name not in statement.exists}
    if choices is None:
        kinds = [_terms(free, statement.sorts[name]) for name in statement.exists]
        choices = islice(product(*kinds), MAX_TERMS)
    node = matrix(statement)
    for terms in choices:
        if monotonic() > deadline:
            return None
        chosen = {name: parse(term) for name, term in zip(statement.exists, terms, strict=True)}
        instance = replace(about(statement, substitute(node, chosen), tuple(free)), divides=True)
        try:
            if _found(about(instance, Not(instance.node)), setting, 30, deadline) is not None:
                continue
            decision = decide_one(instance, setting, min(deadline, monotonic() + 1.0))
        except TooLargeError:
            continue
        if decision.verdict == PROVED:
            named_terms = dict(zip(statement.exists, terms, strict=True))
            evidence: dict[str, Any] = {
                "kind": "terms",
                "terms": named_terms,
                "proof": decision.evidence,
            }
            shown = ", ".join(f"{name} = {term}" for name, term in named_terms.items())
            terms_found = {n: [t] for n, t in named_terms.items()} if free else None
            scope = FIELDS if setting.field is None else FIELD
            return replace(
                decision,
                method="witness",
                witness=terms_found,
                scope=scope,
                steps=(f"take {shown}", *decision.steps),
                evidence=evidence,
            )
    return None


def _at_zero(
    statement: Statement, setting: Setting, deadline: float, decide_one: Decide
) -> tuple[str, ...] | None:
    """Return what exists when all that is given is 0: it may serve everywhere."""
    free = [name for name, _ in statement.unknowns if name not in statement.exists]
    node = substitute(matrix(statement), {name: Number(0) for name in free})
    one = _exists(about(statement, node, statement.exists), setting, deadline, decide_one)
    if one.verdict != PROVED or one.witness is None:
        return None
    return tuple(to_text(quaternion_node(one.witness[name])) for name in statement.exists)


def _terms(free: dict[str, Sort], sort: Sort) -> list[str]:
    """Return texts of terms in the given unknowns, simple ones first."""
    quaternions = [name for name, s in free.items() if s is Sort.QUATERNION]
    scalars = [name for name, s in free.items() if s is Sort.SCALAR]
    if sort is Sort.SCALAR:
        out = ["0", "1", "-1", *scalars, *(f"-{s}" for s in scalars)]
        for q in quaternions:
            out += [f"norm({q})", f"-norm({q})", f"trace({q})", f"{q}[0]", f"1/norm({q})"]
        return out + [f"1/{s}" for s in scalars] + [f"{s}*{t}" for s in scalars for t in scalars]
    out = ["0", *BASIS, "1+i", *quaternions]
    for q in quaternions:
        out += [f"inv({q})", f"conj({q})", f"-{q}", f"vector({q})", f"-conj({q})"]
    for p in quaternions:
        for q in quaternions:
            if p != q:
                out += [f"{p}*{q}", f"inv({p})*{q}", f"{q}*inv({p})", f"{p}+{q}", f"{p}-{q}"]
    return out + scalars + [f"inv({s})" for s in scalars]


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
        instance = about(statement, substitute(node, values), statement.exists)
        try:
            one = _exists(replace(instance, divides=True), setting, deadline, decide_one)
        except (HFieldError, KeyError):
            return Decision(UNDECIDED, "none", tried=("values of the unknowns one by one",))
        if one.verdict == REFUTED:
            witness = witness_texts(field, place)
            evidence = {"kind": "place", "values": witness, "proof": one.evidence}
            steps = (f"at {_shown(witness)} there is none", *one.steps)
            return replace(one, witness=witness, steps=steps, evidence=evidence)
        if finite and one.verdict != PROVED:
            return one
        count += 1
    if finite and monotonic() < deadline:
        steps = (f"there is one for each of the {count} values of what is given",)
        counted: dict[str, Any] = {"kind": "exhaustion", "cases": count}
        return Decision(PROVED, "exhaustion", steps=steps, scope=FIELD, evidence=counted)
    return Decision(UNDECIDED, "none", tried=("terms in the unknowns", f"{count} places"))
