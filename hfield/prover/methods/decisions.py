"""Build decisions from the results of the methods."""

from hfield.checker.glossary import (
    COUNTEREXAMPLE,
    FLOATS_EXACT,
    IDENTITY,
    IMPLICATION,
    WITNESS,
)
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import Ring
from hfield.prover.counterexamples.candidates import shown, witness_texts
from hfield.prover.decision import (
    COMMUTATIVE_RINGS,
    FIELD,
    FIELDS,
    PROVED,
    REFUTED,
    Decision,
    Scope,
)
from hfield.prover.evaluation.searcher import Assignment
from hfield.prover.methods.implications import Proof
from hfield.prover.polynomials.expansion import Expanded
from hfield.prover.polynomials.field_rules import rules
from hfield.prover.polynomials.vanishing import common_primes
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Statement
from hfield.prover.statements.trees import conjuncts
from hfield.prover.steps import Step, say
from hfield.syntax import Compare, Logic, Node, Not


def expanding(x: Expanded) -> Step:
    """Describe how both sides of an identity are compared."""
    if not x.unknowns:
        return say("compute")
    return say("expand-one" if x.unknowns == 1 else "expand", n=x.unknowns)


def scope_of_identity(statement: Statement, x: Expanded) -> Scope | None:
    """Return the scope in which all clauses are polynomial identities, over all commutative rings if
    possible.

    Clauses with division or ``!=`` are claimed for fields only: over F₂ × F₂ a nonzero element need not be
    invertible.
    """
    fields_only = statement.divides or statement.compares_unequal
    if not x.clauses and not x.has_constants:
        return FIELDS if fields_only else COMMUTATIVE_RINGS
    primes = () if fields_only else primes_of_identity(x)
    return Scope.characteristics(primes) if primes else None


def primes_of_identity(x: Expanded) -> tuple[int, ...]:
    """Return the characteristics of fields over which all clauses are polynomial identities."""
    if x.has_constants or not x.clauses:
        return ()
    found: set[int] | None = None
    for c in x.clauses:
        own = {p for goal in c.goals for p in common_primes(list(goal)) or ()}
        found = own if found is None else found & own
    return tuple(sorted(found or ()))


def _algebra_may_exist(x: Expanded, p: int) -> bool:
    """Return whether no condition of the structure constants vanishes in characteristic p."""
    return all(any(int(c) % p for c in f.coeffs()) for f in x.conditions)


def is_conjunction_of_identities(statement: Statement) -> bool:
    """Return whether the statement consists of equations without division, joined by "and"."""
    return not (statement.hypotheses or statement.exists or statement.divides) and all(
        isinstance(n, Compare) and n.op == "==" for n in conjuncts(statement.conclusion)
    )


def identity(statement: Statement, x: Expanded, field: Ring, scope: Scope | None) -> Decision:
    """Return the decision "proved" for a statement that holds coefficient by coefficient."""
    p = field.characteristic
    steps = [expanding(x)]
    general = scope in (COMMUTATIVE_RINGS, FIELDS)
    holds_in_p = scope is not None and p in scope.primes
    if not (general or holds_in_p):
        scope = FIELD
    if general:
        steps.append(say("all-zero", R="ℤ"))
    elif holds_in_p:
        steps.append(say("all-divisible", p=p))
    elif field.order is not None and p not in primes_of_identity(x):
        steps.append(say("all-zero-reduced", relation=f"x^{field.order} = x"))
    else:
        steps.append(say("all-zero", R=field.name))
    evidence = Evidence(Kind.IDENTITY)
    return Decision(PROVED, IDENTITY, steps=tuple(steps), scope=scope, evidence=evidence)


def _is_identity(node: Node, said: bool, infinite: bool) -> bool:
    """Return whether the statement (or its negation) is an identity: equations joined by "and".

    Equations joined by "or" count too, if a product of polynomials vanishes everywhere only if one of them
    does.
    """
    match node:
        case Compare(op):
            return (op == "==") == said
        case Not(x):
            return _is_identity(x, not said, infinite)
        case Logic(op, left, right) if op != "<=>" and (infinite or (op == "and") == said):
            return _is_identity(left, said != (op == "=>"), infinite) and _is_identity(
                right, said, infinite
            )
    return False


def refuted_at(
    problem: Problem, found: Assignment | None, x: Expanded | None = None
) -> Decision | None:
    """Return the refutation by the values found, or None if there are none."""
    return None if found is None else refuted(problem, found, x)


def refuted(problem: Problem, found: Assignment, x: Expanded | None = None) -> Decision:
    """Return the refutation by the values found.

    The method is named after what is refuted, however the values were found: an identity, the unsolvability
    of equations (a witness is a solution), or another statement. A conjunction of identities has a scope even
    if it is refuted: the characteristics in which it holds. For other statements that hold over the fields of
    some characteristics, a step says so in words.
    """
    field = problem.ring
    witness = witness_texts(field, found)
    at = say("false-at", F=field.name, values=shown(witness)) if witness else say("false")
    steps = [at]
    primes = () if x is None else primes_of_identity(x)
    primes = tuple(p for p in primes if x is not None and _algebra_may_exist(x, p))
    scope = None
    if primes:
        where, many = ", ".join(map(str, primes)), "-some" if len(primes) > 1 else ""
        if is_conjunction_of_identities(problem.statement):
            scope = Scope.characteristics(primes)
            steps.append(say(f"exactly-in{many}", p=where))
        else:
            steps.append(say(f"holds-in{many}", p=where))
    return Decision(
        REFUTED,
        _method(problem),
        witness=witness,
        steps=tuple(steps),
        scope=scope,
        evidence=Evidence(Kind.WITNESS, ring=field.data, values=witness),
    )


def _method(problem: Problem) -> str:
    if not problem.ring.is_exact:
        return FLOATS_EXACT
    node, infinite = problem.statement.node, problem.ring.order is None
    if _is_identity(node, True, infinite):
        return IDENTITY
    return WITNESS if _is_identity(node, False, infinite) else COUNTEREXAMPLE


def implied(proof: Proof, problem: Problem) -> Decision:
    """Return the decision "proved", given a proof of all clauses."""
    setting = problem.setting
    own = {rule.form: rule for rule in rules(setting)}  # fields of a kind share proofs
    used = [rule if rule.algebra else own[rule.form] for rule in proof.rules]
    facts = [say("over", A=setting.symbol, fact=rule.fact) for rule in used]
    assumes = tuple(dict.fromkeys(a for rule in used for a in rule.assumes))
    evidence = Evidence(
        Kind.IMPLICATION,
        facts=[dict(rule.evidence) for rule in used],
        items=[dict(item.evidence) for item in proof.items],
    )
    scope, steps = proof.scope(problem.statement), (*facts, *proof.steps)
    return Decision(PROVED, IMPLICATION, None, steps, scope, assumes, (), evidence)
