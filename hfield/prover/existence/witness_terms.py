"""Prove existence by terms in the given values."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, product

from hfield.checker.glossary import WITNESS
from hfield.errors import HFieldError
from hfield.evidence import Evidence, Kind
from hfield.prover.counterexamples.candidates import true_place
from hfield.prover.decision import FIELD, FIELDS, PROVED, Decision
from hfield.prover.methods import universal
from hfield.prover.problem import Problem
from hfield.prover.statements.language import BASIS, Sort
from hfield.prover.statements.trees import divides_in, implication, substitute
from hfield.prover.steps import say
from hfield.syntax import Compare, Logic, Node, Not, parse

MAX_TERMS = 400


def by_terms(problem: Problem, choices: Iterable[tuple[str, ...]] | None = None) -> Decision | None:
    """Prove by a term in the given unknowns for each sought one."""
    statement = problem.statement
    free = dict(statement.given)
    if choices is None:
        kinds = [_terms(free, statement.sorts[name]) for name in statement.exists]
        choices = combined(kinds, MAX_TERMS)
    for terms in choices:
        if problem.is_late:
            return None
        chosen = {name: parse(term) for name, term in zip(statement.exists, terms, strict=True)}
        node = implication(statement.hypotheses, put_in(statement.conclusion, chosen))
        instance = problem.for_formula(node, tuple(free))
        try:
            if true_place(instance.for_formula(Not(instance.statement.node)), 30) is not None:
                continue
            decision = universal.decide(instance.within(1.0))
        except HFieldError:
            continue
        if decision.verdict == PROVED:
            named_terms = dict(zip(statement.exists, terms, strict=True))
            evidence = Evidence(Kind.TERMS, terms=named_terms, proof=decision.evidence)
            shown = ", ".join(f"{name} = {term}" for name, term in named_terms.items())
            terms_found = {n: [t] for n, t in named_terms.items()} if free else None
            return replace(
                decision,
                method=WITNESS,
                witness=terms_found,
                scope=FIELDS if problem.field is None else FIELD,
                steps=(say("take", terms=shown), *decision.steps),
                evidence=evidence,
            )
    return None


def put_in(conclusion: Node, terms: Mapping[str, Node]) -> Node:
    """Return a conclusion with terms for the existential unknowns, and the statement that these terms are
    defined.

    Comparisons with an undefined term are false. So if a conclusion consists only of comparisons, "and" and
    "or", and is true where a term is undefined, it stays true when any value replaces the term. For other
    conclusions definedness must be proved.
    """
    inside = substitute(conclusion, terms)
    if not _is_monotone(conclusion):
        for term in filter(divides_in, terms.values()):
            inside = Logic("and", Compare("==", term, term), inside)
    return inside


def _is_monotone(node: Node) -> bool:
    """Return whether a statement is built from comparisons by "and" and "or" only."""
    if isinstance(node, Logic):
        return node.op in ("and", "or") and _is_monotone(node.left) and _is_monotone(node.right)
    return isinstance(node, Compare)


def combined(kinds: Sequence[Sequence[str]], most: int) -> Iterator[tuple[str, ...]]:
    """Yield choices of one term for each name, at most ``most`` choices."""
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
