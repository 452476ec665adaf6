"""Find terms for an existential unknown by solving an equation for it.

If u occurs once, ``r*u + s == i`` gives ``u = inv(r)*(i - s)``. If u occurs twice, as in a·u·b + u·d = r,
multiplying by conjugates eliminates a, provided that b and d commute (Sylvester's equation has b = 1):

    ā·r·b + r·d = u·w  for  w = N(a)·b² + tr(a)·b·d + d²,

so that u = (ā·r·b + r·d)·w⁻¹. N(w) is the determinant of the linear map u ↦ r; for a·u − u·d, it is the
resultant of the characteristic polynomials of a and d. Whether w is invertible is proved elsewhere.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from hfield.prover.polynomials.starting_relations import is_scalar
from hfield.prover.statements.language import Sort, Statement
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.simplified import ONE, ZERO, minus, over, plus, times
from hfield.prover.statements.trees import occurrences, substitute
from hfield.syntax import Binary, Call, Compare, Logic, Name, Negate, Node, Number, Power


def isolated(statement: Statement) -> dict[str, list[str]]:
    """Return, for each name bound by ``exists``, terms from equations in which it occurs once."""
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
    """Yield terms for all names: one name solves an equation, the others are 0."""
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
    """Yield the terms that equal the name where the equation holds."""
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
    """Return the value that the equation ``side == value`` gives for the name."""
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


Sorts = Mapping[str, Sort]


@dataclass(frozen=True)
class TwoSidedMap:
    """The map u ↦ left·u·right."""

    left: Node
    right: Node


def two_sided(side: Node, value: Node, name: str, sorts: Sorts) -> Iterator[Node]:
    """Yield terms for ``name`` that solve ``side == value``, where the side has one or two parts."""
    parts, rest = _split(side, name, sorts) or ([], ZERO)
    parts = _joined(parts, sorts)
    r = minus(value, rest)
    if len(parts) == 1:
        a, b = parts[0].left, parts[0].right
        yield over(over(r, a, is_scalar(a, sorts), left=True), b, is_scalar(b, sorts))
    if len(parts) == 2:
        first, second = parts
        yield from _disappearing(first, second, r, sorts)
        yield from _disappearing(second, first, r, sorts)


def _disappearing(one: TwoSidedMap, other: TwoSidedMap, r: Node, sorts: Sorts) -> Iterator[Node]:
    """Yield solutions of a·u·b + c·u·d = r that eliminate c or d."""
    a, b, c, d = one.left, one.right, other.left, other.right
    if not (is_scalar(c, sorts) or is_scalar(d, sorts)):  # N(c) in the place of c
        bar = Call("conj", (c,))
        a, r, c = times(bar, a), times(bar, r), Call("norm", (c,))
    if is_scalar(c, sorts):
        d = times(c, d)
        if not (is_scalar(b, sorts) or is_scalar(d, sorts)):
            bar = Call("conj", (b,))
            b, r, d = Call("norm", (b,)), times(r, bar), times(d, bar)
        u = plus(times(times(Call("conj", (a,)), r), b), times(r, d))
        yield times(u, Call("inv", (_determining(a, b, d),)))
    else:
        c = times(d, c)
        if is_scalar(a, sorts) or is_scalar(c, sorts):
            u = plus(times(times(a, r), Call("conj", (b,))), times(c, r))
            yield times(Call("inv", (_determining(b, a, c),)), u)


def _determining(a: Node, b: Node, d: Node) -> Node:
    """Return N(a)·b² + tr(a)·b·d + d²."""
    norm, trace = Call("norm", (a,)), Call("trace", (a,))
    out = times(norm, times(b, b)) if b != ONE else norm
    return plus(plus(out, times(trace, times(b, d))), times(d, d))


def _split(node: Node, name: str, sorts: Sorts) -> tuple[list[TwoSidedMap], Node] | None:
    """Write a term as Σ left·u·right + rest; None if u occurs otherwise."""
    if not occurrences(node, name):
        return [], node
    match node:
        case Name():
            return [TwoSidedMap(ONE, ONE)], ZERO
        case Negate(x):
            return _scaled(_split(x, name, sorts), left=Number(-1))
        case Binary("+" | "-" as op, x, y):
            first, second = _split(x, name, sorts), _split(y, name, sorts)
            if op == "-":
                second = _scaled(second, left=Number(-1))
            if first is None or second is None:
                return None
            return [*first[0], *second[0]], plus(first[1], second[1])
        case Binary("*", x, y) if not occurrences(x, name):
            return _scaled(_split(y, name, sorts), left=x)
        case Binary("*", x, y) if not occurrences(y, name):
            by_scalar = is_scalar(y, sorts)
            inside = _split(x, name, sorts)
            return _scaled(inside, left=y) if by_scalar else _scaled(inside, right=y)
        case Binary("/", x, y) if not occurrences(y, name):
            return _scaled(_split(x, name, sorts), left=Binary("/", ONE, y))
        case Call("comm", (x, y)):
            product = Binary("-", Binary("*", x, y), Binary("*", y, x))
            return _split(product, name, sorts)
        case Power(x, 1):
            return _split(x, name, sorts)
    return None


def _scaled(
    found: tuple[list[TwoSidedMap], Node] | None, left: Node = ONE, right: Node = ONE
) -> tuple[list[TwoSidedMap], Node] | None:
    if found is None:
        return None
    parts = [TwoSidedMap(times(left, part.left), times(part.right, right)) for part in found[0]]
    return parts, times(times(left, found[1]), right)


def _joined(parts: list[TwoSidedMap], sorts: Sorts) -> list[TwoSidedMap]:
    """Return parts with the same sum, after combining parts with a common side."""
    lefts: dict[str, TwoSidedMap] = {}  # by what stands on the right
    for part in parts:
        key = to_text(part.right)
        known = lefts.get(key)
        lefts[key] = part if known is None else TwoSidedMap(plus(known.left, part.left), part.right)
    rights: dict[str, TwoSidedMap] = {}
    for part in lefts.values():
        if is_scalar(part.left, sorts):
            part = TwoSidedMap(ONE, times(part.left, part.right))
        key = to_text(part.left)
        known = rights.get(key)
        rights[key] = (
            part if known is None else TwoSidedMap(part.left, plus(known.right, part.right))
        )
    return list(rights.values())
