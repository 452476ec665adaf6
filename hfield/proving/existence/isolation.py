"""Terms for what is said to exist: an equation in which an unknown stands once is solved for it.

``r*u + s == i`` gives ``u = inv(r)*(i - s)``. Whether the term serves is for a proof to tell.
"""

from collections.abc import Iterator
from dataclasses import replace

from hfield.proving.methods.starting_relations import is_scalar
from hfield.proving.statements.language import Sort, Statement
from hfield.proving.statements.printing import to_text
from hfield.proving.statements.trees import substitute, walk
from hfield.syntax import Binary, Call, Compare, Logic, Name, Negate, Node, Number, Power

ZERO, ONE = Number(0), Number(1)


def isolated(statement: Statement) -> dict[str, list[str]]:
    """Return for each name that ``exists`` binds the terms that equations with it once give."""
    out: dict[str, list[str]] = {name: [] for name in statement.exists}
    for equation in _equations(statement.conclusion):
        for name in statement.exists:
            for side, other in (
                (equation.left, equation.right),
                (equation.right, equation.left),
            ):
                if _count(side, name) != 1 or _count(other, name):
                    continue
                term = _solve(side, other, name, statement)
                if term is None or any(_count(term, bound) for bound in statement.exists):
                    continue
                if statement.sorts[name] is Sort.SCALAR and not is_scalar(term, statement.sorts):
                    term = Call("scalar", (term,))
                text = to_text(term)
                if text not in out[name]:
                    out[name].append(text)
    return out


def isolated_alone(statement: Statement) -> Iterator[dict[str, str]]:
    """Run through terms for all names: one solves an equation in which the others are put to 0."""
    if len(statement.exists) < 2:
        return
    for name in statement.exists:
        others = {other: ZERO for other in statement.exists if other != name}
        alone = replace(
            statement, conclusion=substitute(statement.conclusion, others), exists=(name,)
        )
        for term in isolated(alone)[name]:
            yield {**dict.fromkeys(others, "0"), name: term}


def _equations(node: Node) -> Iterator[Compare]:
    if isinstance(node, Compare) and node.op == "==":
        yield node
    elif isinstance(node, Logic) and node.op in ("and", "or"):
        yield from _equations(node.left)
        yield from _equations(node.right)


def _count(node: Node, name: str) -> int:
    return sum(isinstance(n, Name) and n.name == name for n in walk(node))


def _solve(side: Node, value: Node, name: str, statement: Statement) -> Node | None:
    """Return what the name is equal to when ``side == value``."""
    sorts = statement.sorts
    while not isinstance(side, Name):
        match side:
            case Negate(x):
                side, value = x, _minus(ZERO, value)
            case Call("conj", (x,)):
                side, value = x, Call("conj", (value,))
            case Call("inv", (x,)) | Power(x, -1):
                side, value = x, _over(ONE, value, sorts)
            case Power(x, 1):
                side = x
            case Binary("+", x, y):
                inside, rest = (x, y) if _count(x, name) else (y, x)
                side, value = inside, _minus(value, rest)
            case Binary("-", x, y) if _count(x, name):
                side, value = x, (y if value == ZERO else Binary("+", value, y))
            case Binary("-", x, y):
                side, value = y, _minus(x, value)
            case Binary("*", x, y) if _count(x, name):
                side, value = x, _over(value, y, sorts)
            case Binary("*", x, y):
                side, value = y, _over(value, x, sorts, left=True)
            case Binary("/", x, y) if _count(x, name):
                side, value = x, Binary("*", value, y)
            case Binary("/", x, y) if is_scalar(value, sorts):
                side, value = y, Binary("/", x, value)
            case _:
                return None
    return value


def _minus(x: Node, y: Node) -> Node:
    if y == ZERO:
        return x
    return Negate(y) if x == ZERO else Binary("-", x, y)


def _over(x: Node, y: Node, sorts: dict[str, Sort], left: bool = False) -> Node:
    """Return x·y⁻¹, or y⁻¹·x."""
    if x == ZERO or y == ONE:
        return x
    if is_scalar(y, sorts):
        return Binary("/", x, y)
    inverse = Call("inv", (y,))
    if x == ONE:
        return inverse
    return Binary("*", inverse, x) if left else Binary("*", x, inverse)
