"""Check ``implication``: cofactors, multiplied out, cover every clause."""

from collections.abc import Mapping
from itertools import product

from hfield.checker.budget import spend, spend_products
from hfield.checker.check_result import CheckResult
from hfield.checker.clauses import Clause, Expansion, Frozen, freeze, without_factors
from hfield.checker.glossary import COMMUTATIVE_RINGS, FIELD, FIELDS, IMPLICATION
from hfield.checker.ideal_membership import VerifiedItem
from hfield.checker.over_field import EvaluationContext, evaluation_context, reach
from hfield.checker.polynomials import Poly, is_constant
from hfield.checker.rejection import a_list, an_object, reject
from hfield.checker.rules import Rules
from hfield.checker.scalars.finite import is_prime
from hfield.checker.statement import Setting, Statement

MAX_CHOICES = 512


def check_implication(
    expansion: Expansion, setting: Setting, data: Mapping[str, object]
) -> CheckResult:
    """Check the items, and that they cover the clauses."""
    ring = setting.field
    context = EvaluationContext(expansion, ring)
    rules = Rules(expansion, setting, context, data["facts"])
    items = [
        VerifiedItem(raw, expansion.names, context, rules) for raw in a_list(data["items"], "items")
    ]
    if ring is None:
        return CheckResult(_everywhere(expansion, items), IMPLICATION)
    if not ring.is_field and (expansion.factors or not ring.is_domain):
        items = [item for item in items if item.is_direct and item.denominators <= {1, -1}]
    _cover(expansion, context, items)
    return CheckResult(FIELD, IMPLICATION).citing(*rules.cites)


def _everywhere(expansion: Expansion, items: list[VerifiedItem]) -> str:
    """Prove the clauses over all fields, and separately in each characteristic by which the proof divides."""
    general = [item for item in items if item.p == 0]
    _cover(expansion, EvaluationContext(expansion, None), general)
    divided = {abs(d) for item in general for d in item.denominators}
    spend(100 * len(divided) + sum(d.bit_length() for d in divided))
    primes = {item.p for item in items if item.p}
    primes |= {p for d in divided for p in range(2, 1000) if d % p == 0 and is_prime(p)}
    spend(len(primes) * len(items))
    spend_products(primes, [d for item in general for d in item.denominators])
    for p in primes:
        there = [item for item in general if all(d % p for d in item.denominators)]
        there += [item for item in items if item.p == p]
        _cover(expansion, EvaluationContext(expansion, None, p), there)
    for d in divided:
        for p in primes:
            while d % p == 0:
                d //= p
        if d != 1:
            reject("a proof over all fields divides by a number that may be 0")
    direct = all(item.is_direct for item in items) and divided <= {1}
    return COMMUTATIVE_RINGS if direct else FIELDS


def _cover(expansion: Expansion, context: EvaluationContext, items: list[VerifiedItem]) -> None:
    for clause in expansion.clauses:
        if not context.is_trivial(clause) and not _covers(clause, expansion, context, items):
            reject("a case of the statement is not covered by the evidence")


def _covers(
    clause: Clause, expansion: Expansion, context: EvaluationContext, items: list[VerifiedItem]
) -> bool:
    """Return whether verified items prove the clause."""
    # Where a factor of the denominators is 0, the clause is true: so it may be divided by.
    single = {f for goal in clause.goals if len(goal) == 1 for f in goal}
    known = [f for f in expansion.factors if freeze(f) in single]

    def same(f: Frozen | Poly) -> Frozen:
        return context.same(without_factors(dict(f), known))

    spend(len(items))
    zeros: set[Frozen] = {same(z) for z in clause.zeros} | {frozenset()}
    usable = [item for item in items if all(same(z) in zeros for z in item.zero)]
    members = [item.member for item in usable if item.member is not None]
    if any(is_constant(f) and context.is_nonzero(freeze(f)) for f in members):
        return True
    proved = {same(f) for f in members}
    goals = [[same(g) for g in goal if not context.vanishes(g)] for goal in clause.goals]
    if any(all(g in proved for g in goal) for goal in goals):
        return True
    if context.ring is not None and not context.ring.is_domain:
        return False
    excluded = [{same(g) for g in item.nonzero} for item in usable if item.member is None]
    excluded += [{f} for f in proved]
    cost = len(goals) + len(excluded) + sum(map(len, excluded))
    for count, choice in enumerate(product(*goals)):
        if count >= MAX_CHOICES:
            reject("a case of the statement has too many branches")
        spend(cost)
        chosen = set(choice)
        if not any(part <= chosen for part in excluded):
            return False
    return True


def implication(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove a statement by cofactors."""
    data = an_object(evidence, "kind facts items", "the evidence")
    expansion = evaluation_context(statement, setting).expansion
    return check_implication(expansion, setting, data).within(reach(statement, setting))


CHECKS = {("proved", False, "implication"): implication}
