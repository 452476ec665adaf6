"""Walk through syntax trees, and substitute terms for unknowns."""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from hfield.syntax import (
    Binary,
    Call,
    Compare,
    Exists,
    Logic,
    Name,
    Node,
    Number,
    Power,
    children,
    parse,
    rebuild,
)

TRUE, FALSE = Compare("==", Number(0), Number(0)), Compare("==", Number(0), Number(1))


def tree_depth(node: Node) -> int:
    """Return the depth of a tree."""
    depth, level = 0, [node]
    while level:
        depth, level = depth + 1, [child for n in level for child in children(n)]
    return depth


def walk(node: Node) -> Iterator[Node]:
    """Yield ``node`` and all nodes below it."""
    stack = [node]
    while stack:
        n = stack.pop()
        yield n
        stack.extend(reversed(children(n)))


def walk_once(node: Node) -> Iterator[Node]:
    """Yield ``node`` and all nodes below it, each only once."""
    seen, stack = {id(node)}, [node]
    while stack:
        n = stack.pop()
        yield n
        for child in children(n):
            if id(child) not in seen:
                seen.add(id(child))
                stack.append(child)


def names_in(node: Node) -> frozenset[str]:
    """Return the names that stand in a tree."""
    return frozenset(n.name for n in walk_once(node) if isinstance(n, Name))


def occurrences(node: Node, name: str) -> int:
    """Return the number of times that a name occurs in a tree."""
    return sum(isinstance(n, Name) and n.name == name for n in walk(node))


def divides_in(node: Node) -> bool:
    """Return whether some part of a tree may be undefined: a quotient, an inverse, a decimal."""
    for n in walk(node):
        match n:
            case Number(Fraction()) | Binary("/", _, _) | Call("inv", _):
                return True
            case Power(_, exponent) if exponent < 0:
                return True
    return False


def substitute(node: Node, terms: Mapping[str, Node]) -> Node:
    """Return ``node`` with each name in ``terms`` replaced; names bound by "exists" are kept."""
    if isinstance(node, Name):
        return terms.get(node.name, node)
    if isinstance(node, Exists):
        terms = {name: term for name, term in terms.items() if name not in node.names}
    return rebuild(node, [substitute(x, terms) for x in children(node)])


def conjunction(nodes: Sequence[Node]) -> Node:
    """Return the statement that all are true."""
    out = nodes[0] if nodes else TRUE
    for node in nodes[1:]:
        out = Logic("and", out, node)
    return out


def conjuncts(node: Node) -> list[Node]:
    """Return the operands of ``and``, in order; the node itself if it is not a conjunction."""
    if isinstance(node, Logic) and node.op == "and":
        return [*conjuncts(node.left), *conjuncts(node.right)]
    return [node]


def implication(hypotheses: Sequence[Node], conclusion: Node) -> Node:
    """Return hypotheses ⇒ conclusion."""
    for h in reversed(hypotheses):
        conclusion = Logic("=>", h, conclusion)
    return conclusion


def taken_apart(node: Node) -> tuple[tuple[Node, ...], Node]:
    """Return the hypotheses and the conclusion of ``h1 => h2 => … => conclusion``."""
    hypotheses: list[Node] = []
    while isinstance(node, Logic) and node.op == "=>":
        hypotheses.append(node.left)
        node = node.right
    return tuple(hypotheses), node


def quaternion_node(coordinates: Sequence[str]) -> Node:
    """Return the tree of ``c0 + c1·i + c2·j + c3·k`` for texts of coordinates, or the tree of a scalar."""
    if len(coordinates) == 1:
        return parse(coordinates[0])
    out: Node | None = None
    for text, unit in zip(coordinates, "eijk", strict=True):
        if text != "0":
            part = Binary("*", parse(text), Name(unit))
            out = part if out is None else Binary("+", out, part)
    return out or Binary("*", Number(0), Name("e"))
