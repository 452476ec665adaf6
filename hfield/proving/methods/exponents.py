"""Products of powers of scalars, compared by their exponents: what is too large to expand as polynomials."""

from collections import Counter

from hfield.certificates.glossary import IDENTITY
from hfield.evidence import Evidence, Kind
from hfield.proving.decision import COMMUTATIVE_RINGS, FIELDS, PROVED, Decision
from hfield.proving.problem import Problem
from hfield.proving.statements.language import Sort, Statement
from hfield.proving.statements.trees import conjuncts
from hfield.proving.steps import say
from hfield.syntax import Binary, Compare, Name, Negate, Node, Number, Power


def by_exponents(problem: Problem) -> Decision | None:
    """Prove equations whose sides are the same products: sᵐ·sⁿ = s^(m + n) in every commutative ring."""
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
    """Return the exponents of numbers and scalars, that of −1 being 0 or 1; None for no such product."""
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
