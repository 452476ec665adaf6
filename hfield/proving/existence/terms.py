"""Proving that something exists by naming it: a term in what is given, that serves everywhere."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import islice, product
from time import monotonic
from typing import Any

from hfield.errors import TooLargeError
from hfield.proving.counterexamples.candidates import prime_search, ring_search
from hfield.proving.decision import FIELD, FIELDS, PROVED, Decision
from hfield.proving.statements.language import BASIS, RESULT, Sort, Statement, generators
from hfield.proving.statements.printing import to_text
from hfield.proving.statements.setting import Setting
from hfield.proving.statements.trees import children, divides_in, substitute
from hfield.rings.base import Ring
from hfield.syntax import Call, Logic, Name, Node, Not, parse

Decide = Callable[[Statement, Setting, float], Decision]
MAX_TERMS = 400


def matrix(statement: Statement) -> Node:
    """Return the statement without its quantifier: hypotheses ⇒ conclusion."""
    node = statement.conclusion
    for h in reversed(statement.hypotheses):
        node = Logic("=>", h, node)
    return node


def about(
    statement: Statement,
    node: Node,
    names: tuple[str, ...] | None = None,
    field: Ring | None = None,
) -> Statement:
    """Return the statement ``node`` for all values of the unknowns of ``statement`` (or ``names``).

    With ``field``, values from it may have been put in, whose constants are then added.
    """
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
        constants=tuple(dict.fromkeys((*statement.constants, *constants_in(node, field)))),
        divides=statement.divides or divides_in(node),
    )


def alone(
    statement: Statement, node: Node, setting: Setting, names: tuple[str, ...] | None = None
) -> Statement:
    """Return the same, without those constants of the field that are left in neither it nor the algebra."""
    made = about(statement, node, names, setting.field)
    trees = (node, *map(parse, setting.constants))
    used = {text for tree in trees for text in constants_in(tree, setting.field)}
    return replace(made, constants=tuple(text for text in made.constants if text in used))


def constants_in(node: Node, field: Ring | None) -> Iterator[str]:
    """Run through the texts of the field's constants in a tree."""
    if field is None:
        return
    if isinstance(node, Name):
        if node.name in generators(field):
            yield node.name
    elif isinstance(node, Call) and node.function not in RESULT:
        yield to_text(node)
    else:
        for child in children(node):
            yield from constants_in(child, field)


def true_place(statement: Statement, setting: Setting, limit: int, deadline: float) -> Any:
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


def by_terms(
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
        choices = combined(kinds, MAX_TERMS)
    node = matrix(statement)
    for terms in choices:
        if monotonic() > deadline:
            return None
        chosen = {name: parse(term) for name, term in zip(statement.exists, terms, strict=True)}
        instance = about(statement, substitute(node, chosen), tuple(free), setting.field)
        try:
            if true_place(about(instance, Not(instance.node)), setting, 30, deadline) is not None:
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


def combined(kinds: Sequence[Sequence[str]], most: int) -> Iterator[tuple[str, ...]]:
    """Run through choices of one term for each name, ``most`` at most."""
    return islice(product(*kinds), most)


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
    multiples = [
        *scalars,
        *(f"norm({q})" for q in quaternions),
        *(f"trace({q})" for q in quaternions),
    ]
    out += [f"{s}*{unit}" for s in multiples for unit in BASIS]
    return out + [f"inv({s})" for s in scalars]
