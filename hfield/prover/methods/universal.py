"""Choose the method for a quantifier-free statement."""

from collections import Counter

from hfield.checker.glossary import FLOATS, IDENTITY
from hfield.evidence import Evidence, Kind
from hfield.prover.counterexamples.candidates import prime_search
from hfield.prover.counterexamples.search import PLACES_BETWEEN
from hfield.prover.decision import COMMUTATIVE_RINGS, FIELDS, PROVED, Decision, undecided
from hfield.prover.evaluation.searcher import lifted
from hfield.prover.methods import all_fields, one_field, over_rings
from hfield.prover.methods.decisions import refuted
from hfield.prover.polynomials.expansion import MAX_WEIGHT
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Sort, Statement
from hfield.prover.statements.trees import conjuncts
from hfield.prover.steps import say
from hfield.syntax import Binary, Compare, Name, Negate, Node, Number, Power


def decide(problem: Problem) -> Decision:
    """Decide over all fields, or over the named ring."""
    field = problem.field
    if problem.statement.weight > MAX_WEIGHT and (field is None or field.is_exact):
        found = by_exponents(problem)
        if found is not None:
            return found
    if field is None:
        return all_fields.decide(problem)
    if not field.is_exact:
        return _over_floats(problem)
    return one_field.decide(problem) if field.is_field else over_rings.decide(problem)


def _over_floats(problem: Problem) -> Decision:
    """Collect evidence over an inexact ring; small integers are exact, so they may refute."""
    field, statement = problem.ring, problem.statement
    if not statement.divides and not statement.constants:
        found = prime_search(problem, 0, PLACES_BETWEEN)
        if found is not None:
            return refuted(problem, lifted(field, found))
    exact = f"decide over {field.exact_ring} or QQ"
    tried = (f"{field.name} is inexact, so nothing is proved there: {exact}",)
    return undecided(*tried, method=FLOATS)


def by_exponents(problem: Problem) -> Decision | None:
    """Prove equations whose sides are equal products of powers: sᵐ·sⁿ = s^(m + n) in every
    commutative ring.
    """
    for equation in conjuncts(problem.statement.conclusion):
        if not isinstance(equation, Compare) or equation.op != "==":
            return None
        left, right = (_powers(x, problem.statement) for x in (equation.left, equation.right))
        if left is None or left != right:
            return None
    steps = (say("same-powers"),)
    divides = problem.statement.divides or problem.setting.divides
    scope = FIELDS if divides else COMMUTATIVE_RINGS
    return Decision(PROVED, IDENTITY, steps=steps, scope=scope, evidence=Evidence(Kind.IDENTITY))


def _powers(node: Node, statement: Statement) -> Counter[int | str] | None:
    """Return the exponents of numbers and scalars (0 or 1 for −1), or None if the term is not such
    a product.
    """
    match node:
        case Number(int() as n) if n:
            return _product(Counter({abs(n): int(abs(n) > 1)}), Counter({-1: int(n < 0)}))
        case Name(name=name) if statement.sorts.get(name) is Sort.SCALAR:
            return Counter({name: 1})
        case Negate(x):
            return _product(Counter({-1: 1}), _powers(x, statement))
        case Binary("*", x, y):
            return _product(_powers(x, statement), _powers(y, statement))
        case Power(x, n) if n >= 0:
            inside = _powers(x, statement)
            return (
                None
                if inside is None
                else _product(Counter({k: n * e for k, e in inside.items()}), Counter())
            )
    return None


def _product(
    x: Counter[int | str] | None, y: Counter[int | str] | None
) -> Counter[int | str] | None:
    if x is None or y is None:
        return None
    both = Counter({k: x[k] + y[k] for k in {*x, *y}})
    both[-1] %= 2
    return +both
