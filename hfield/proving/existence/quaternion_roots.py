"""Roots that exist in H(ℝ) by a theorem: those of polynomials in a quaternion (Eilenberg and Niven, 1944)."""

from dataclasses import dataclass

from hfield.certificates.glossary import QUATERNION_ROOT, WITNESS
from hfield.evidence import Evidence, Kind
from hfield.proving.decision import FIELD, PROVED, Decision
from hfield.proving.problem import Problem
from hfield.proving.statements.language import BASIS, Sort
from hfield.proving.statements.trees import occurrences
from hfield.proving.steps import say
from hfield.syntax import Binary, Compare, Name, Negate, Node, Number, Power

MAX_DEGREE = 1_000


@dataclass(frozen=True)
class Top:
    """What a polynomial has at the top: its degree at most, and whether that is one monomial, not 0."""

    degree: int
    single: bool

    def __add__(self, other: "Top") -> "Top":
        if self.degree == other.degree:
            return Top(self.degree, False)
        return self if self.degree > other.degree else other

    def __mul__(self, other: "Top") -> "Top":
        return Top(self.degree + other.degree, self.single and other.single)


def by_quaternion_roots(problem: Problem) -> Decision | None:
    """Prove ``exists q: f(q) == g(q)`` in H(ℝ), where a single monomial has the highest degree."""
    field, statement = problem.field, problem.statement
    node = statement.conclusion
    if field is None or field.closure != "real closed" or not problem.setting.is_hamilton:
        return None
    if statement.divides:
        return None
    if len(statement.exists) != 1 or not (isinstance(node, Compare) and node.op == "=="):
        return None
    name = statement.exists[0]
    sides = [_top(side, name) for side in (node.left, node.right)]
    if statement.sorts[name] is not Sort.QUATERNION or None in sides:
        return None
    top = sum((side for side in sides if side is not None), Top(-1, False))
    if not (1 <= top.degree <= MAX_DEGREE and top.single):
        return None
    steps = (
        say("single-top", q=name, n=top.degree),
        say("so-root", theorem=QUATERNION_ROOT),
    )
    return Decision(
        PROVED,
        WITNESS,
        steps=steps,
        scope=FIELD,
        assumes=(QUATERNION_ROOT,),
        evidence=Evidence(Kind.QUATERNION_ROOT),
    )


def _top(node: Node, name: str) -> Top | None:
    """Return what a term has at the top as a polynomial in the name, None where it is none."""
    if not occurrences(node, name):
        return Top(0, _is_not_zero(node))
    match node:
        case Name():
            return Top(1, True)
        case Negate(x):
            return _top(x, name)
        case Binary("+" | "-" | "*" as op, x, y):
            left, right = _top(x, name), _top(y, name)
            if left is None or right is None:
                return None
            return left * right if op == "*" else left + right
        case Power(x, n) if n >= 0:
            base = _top(x, name)
            return None if base is None else Top(n * base.degree, base.single)
    return None


def _is_not_zero(node: Node) -> bool:
    """Tell whether a term is certainly not 0: a product of numbers and of basis vectors."""
    match node:
        case Number(value):
            return value != 0
        case Name(name):
            return name in BASIS
        case Negate(x):
            return _is_not_zero(x)
        case Binary("*", x, y):
            return _is_not_zero(x) and _is_not_zero(y)
    return False
