"""Terms for what is said to exist: an equation in which an unknown stands once is solved for it.

``r*u + s == i`` gives ``u = inv(r)*(i - s)``; where it stands more often, see ``two_sided``. Whether the
term serves is for a proof to tell.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace

from hfield.proving.existence.two_sided import two_sided
from hfield.proving.polynomials.starting_relations import is_scalar
from hfield.proving.statements.language import Sort, Statement
from hfield.proving.statements.printing import to_text
from hfield.proving.statements.simplified import ONE, ZERO, minus, over
from hfield.proving.statements.trees import occurrences, substitute
from hfield.syntax import Binary, Call, Compare, Logic, Name, Negate, Node, Power


def isolated(statement: Statement) -> dict[str, list[str]]:
    """Return for each name that ``exists`` binds the terms that equations with it once give."""
    out: dict[str, list[str]] = {name: [] for name in statement.exists}
    for equation in _equations(statement.conclusion):
        for name in statement.exists:
            for term in _solutions(equation, name, statement.sorts):
                if any(occurrences(term, bound) for bound in statement.exists):
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


def _solutions(equation: Compare, name: str, sorts: Mapping[str, Sort]) -> Iterator[Node]:
    """Run through terms that the name is equal to where the equation is true."""
    side, other = equation.left, equation.right
    if not occurrences(side, name):
        side, other = other, side
    count = occurrences(side, name)
    if count == 1 and not occurrences(other, name):
        term = _solve(side, other, name, sorts)
        if term is not None:
            yield term
    elif count:
        yield from two_sided(minus(side, other), ZERO, name, sorts)


def _solve(side: Node, value: Node, name: str, sorts: Mapping[str, Sort]) -> Node | None:
    """Return what the name is equal to when ``side == value``."""
    while not isinstance(side, Name):
        match side:
            case Negate(x):
                side, value = x, minus(ZERO, value)
            case Call("conj", (x,)):
                side, value = x, Call("conj", (value,))
            case Call("inv", (x,)) | Power(x, -1):
                side, value = x, over(ONE, value, is_scalar(value, sorts))
            case Power(x, 1):
                side = x
            case Binary("+", x, y):
                inside, rest = (x, y) if occurrences(x, name) else (y, x)
                side, value = inside, minus(value, rest)
            case Binary("-", x, y) if occurrences(x, name):
                side, value = x, (y if value == ZERO else Binary("+", value, y))
            case Binary("-", x, y):
                side, value = y, minus(x, value)
            case Binary("*", x, y) if occurrences(x, name):
                side, value = x, over(value, y, is_scalar(y, sorts))
            case Binary("*", x, y):
                side, value = y, over(value, x, is_scalar(x, sorts), left=True)
            case Binary("/", x, y) if occurrences(x, name):
                side, value = x, Binary("*", value, y)
            case Binary("/", x, y) if is_scalar(value, sorts):
                side, value = y, Binary("/", x, value)
            case _:
                return None
    return value
