"""Rewrite statements about matrices as statements about their entries.

``L``, ``M`` and ``N`` are unknown 2 × 2 matrices, with entries ``M11 M12 M21 M22``, which are unknown
quaternions. ``matrix(p, q, r, u)`` has the rows p, q and r, u; ``column`` and ``row`` have two entries. After
the rewriting only quaternions remain, so provers, refuters and the checker need not know matrices.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import reduce
from operator import add
from typing import NoReturn, TypeAlias

from hfield.errors import NotationError
from hfield.prover.statements.trees import conjunction, divides_in, walk_once
from hfield.syntax import (
    ORDER,
    Binary,
    Call,
    Compare,
    Exists,
    Logic,
    Name,
    Negate,
    Node,
    Number,
    Power,
    children,
    rebuild,
)

Table: TypeAlias = tuple[tuple[Node, ...], ...]

ENTRIES: Mapping[str, tuple[str, ...]] = {
    m: tuple(f"{m}{n}" for n in (11, 12, 21, 22)) for m in "LMN"
}
"""The matrices that are unknown, and the names of their entries."""
WORDS = {"matrix": 4, "column": 2, "row": 2}
MAX_POWER, MAX_NODES = 6, 100_000
ZERO = Number(0)


def expanded(node: Node, taken: Collection[str], text: str) -> Node:
    """Return a statement with matrices replaced by entries; a statement without matrices is returned
    unchanged.

    ``taken`` are the names of elements of fields. Raises :class:`NotationError` if shapes do not fit.
    """
    known = {m for m, own in ENTRIES.items() if not {m, *own} & set(taken)}
    speaks = any(
        (isinstance(n, Name) and n.name in known)
        or (isinstance(n, Call) and n.function in (*WORDS, "transpose"))
        or (isinstance(n, Exists) and not known.isdisjoint(n.names))
        for n in walk_once(node)
    )
    return _Expansion(known, text).statement(node) if speaks else node


def compared(op: str, pairs: Sequence[tuple[Node, Node]], position: int) -> Node:
    """Return the statement that the two sides of each pair are equal, or for ``!=`` that those of some pair
    differ.
    """
    comparisons: list[Node] = [Compare(op, a, b, position=position) for a, b in pairs]
    if op == "==":
        return conjunction(comparisons)
    return reduce(lambda x, y: Logic("or", x, y), comparisons)


class _Expansion:
    """The expansion of one text; the value of a term is a node if it is a quaternion, else a table
    of nodes.
    """

    def __init__(self, known: set[str], text: str) -> None:
        self.known, self.text, self.made = known, text, 0

    def fail(self, message: str, node: Node) -> NoReturn:
        raise NotationError(message, self.text, node.position)

    def statement(self, node: Node) -> Node:
        """Expand a statement; a term in its place is left for the check of sorts."""
        match node:
            case Exists(names, body):
                own = [
                    x for name in names for x in (ENTRIES[name] if name in self.known else (name,))
                ]
                return Exists(tuple(own), self.statement(body), position=node.position)
            case Compare(op, left, right):
                return self.comparison(op, self.term(left), self.term(right), node)
            case Name() | Number() | Negate() | Binary() | Power() | Call():
                return self.quaternion(node)
        return rebuild(node, [self.statement(x) for x in children(node)])

    def comparison(self, op: str, x: Node | Table, y: Node | Table, node: Node) -> Node:
        """Compare entry by entry: all are equal; or all are defined and some differ."""
        if isinstance(x, Node) and isinstance(y, Node):
            return Compare(op, x, y, position=node.position)
        if op in ORDER:
            self.fail(f"{op} compares scalars, and this is a matrix", node)
        x, y = self.like(x, y, node), self.like(y, x, node)
        pairs = [(a, b) for r, s in zip(x, y, strict=True) for a, b in zip(r, s, strict=True)]
        some = compared(op, pairs, node.position)
        if op == "==":
            return some
        undefined = [a for pair in pairs for a in pair if divides_in(a)]
        return conjunction([some, *(Compare("==", a, a) for a in undefined)])

    def like(self, x: Node | Table, y: Node | Table, node: Node) -> Table:
        """Return a table of the shape of another; a quaternion q becomes q times the identity."""
        if isinstance(x, Node):
            assert not isinstance(y, Node)
            size = len(y)
            if x != ZERO and any(len(row) != size for row in y):
                self.fail(f"a quaternion is a square matrix, and not one of {_shape(y)}", node)
            return tuple(
                tuple(x if m == n else ZERO for n in range(len(y[0]))) for m in range(size)
            )
        if not isinstance(y, Node) and _shape(x) != _shape(y):
            self.fail(f"matrices of {_shape(x)} and {_shape(y)} do not fit here", node)
        return x

    def quaternion(self, node: Node) -> Node:
        """Read a term that may not be a matrix."""
        x = self.term(node)
        if not isinstance(x, Node):
            self.fail(f"expected a quaternion or a scalar, found a matrix of {_shape(x)}", node)
        return x

    def term(self, node: Node) -> Node | Table:
        """Return a quaternion or a table."""
        self.made += 1
        if self.made > MAX_NODES:
            self.fail("these matrices make too long a statement", node)
        match node:
            case Name(name) if name in self.known:
                a, b, c, d = (Name(x, position=node.position) for x in ENTRIES[name])
                return (a, b), (c, d)
            case Call(function, arguments) if function in (*WORDS, "transpose"):
                return self.made_of(function, arguments, node)
            case Call(function, arguments):
                return self.call(function, [self.term(x) for x in arguments], node)
            case Negate(x):
                return _each(self.term(x), lambda a: Negate(a, position=node.position))
            case Binary(op, x, y):
                return self.binary(op, self.term(x), self.term(y), node)
            case Power(x, exponent):
                base = self.term(x)
                if isinstance(base, Node):
                    return Power(base, exponent, position=node.position)
                if not 1 <= exponent <= MAX_POWER:
                    self.fail(f"a matrix has the powers 1 to {MAX_POWER} here", node)
                found: Node | Table = base
                for _ in range(exponent - 1):
                    found = self.binary("*", found, base, node)
                return found
        return rebuild(node, [self.quaternion(x) for x in children(node)])

    def made_of(self, function: str, arguments: tuple[Node, ...], node: Node) -> Table:
        """Read a matrix, a row or a column, or the transpose of one."""
        if function == "transpose":
            x = self.term(arguments[0])
            if len(arguments) != 1 or isinstance(x, Node):
                self.fail("transpose takes a matrix", node)
            return tuple(zip(*x, strict=True))
        if len(arguments) != WORDS[function]:
            self.fail(f"{function} takes {WORDS[function]} quaternions", node)
        found = [self.quaternion(x) for x in arguments]
        if function == "column":
            return tuple((x,) for x in found)
        return tuple(tuple(found[n : n + 2]) for n in range(0, len(found), 2))

    def call(self, function: str, values: list[Node | Table], node: Node) -> Node | Table:
        """Apply a function: entrywise, or by its definition for matrices."""
        if function == "comm" and len(values) == 2:
            x, y = values
            if not (isinstance(x, Node) and isinstance(y, Node)):
                there, back = (self.binary("*", u, v, node) for u, v in ((x, y), (y, x)))
                return self.binary("-", there, back, node)
        quaternions = [x for x in values if isinstance(x, Node)]
        if len(quaternions) == len(values):
            return Call(function, tuple(quaternions), position=node.position)
        x = values[0]
        if len(values) == 1 and not isinstance(x, Node):
            if function == "conj":
                return _each(x, lambda a: Call("conj", (a,), position=node.position))
            if _shape(x) == "2 × 2" and function in ("norm", "trace"):
                (a, b), (c, d) = x
                return Call("trace", (a + d,)) if function == "trace" else _reduced_norm(a, b, c, d)
        self.fail(
            f"{function} takes no matrix of {_shape(x) if not isinstance(x, Node) else ''}", node
        )

    def binary(self, op: str, x: Node | Table, y: Node | Table, node: Node) -> Node | Table:
        """Add, subtract or multiply; a quaternion is converted to a multiple of the identity."""

        def joined(a: Node, b: Node) -> Node:
            self.made += 1
            return Binary(op, a, b, position=node.position)

        if isinstance(x, Node) and isinstance(y, Node):
            return joined(x, y)
        if op in "+-":
            x, y = self.like(x, y, node), self.like(y, x, node)
            return tuple(tuple(map(joined, r, s)) for r, s in zip(x, y, strict=True))
        if isinstance(x, Node):
            if op == "/":
                self.fail("only a scalar divides, and this is a matrix", node)
            return _each(y, lambda b: joined(x, b))
        if isinstance(y, Node):
            return _each(x, lambda a: joined(a, y))
        if op == "/" or len(x[0]) != len(y):
            self.fail(f"matrices of {_shape(x)} and {_shape(y)} have no product {op}", node)
        columns = tuple(zip(*y, strict=True))
        found = tuple(tuple(_sum(map(joined, r, c)) for c in columns) for r in x)
        return found[0][0] if _shape(found) == "1 × 1" else found


def _each(x: Node | Table, function: Callable[[Node], Node]) -> Node | Table:
    return function(x) if isinstance(x, Node) else tuple(tuple(map(function, row)) for row in x)


def _sum(terms: Iterable[Node]) -> Node:
    """Add terms from left to right."""
    return reduce(add, terms)


def _shape(x: Table) -> str:
    return f"{len(x)} × {len(x[0])}"


def _reduced_norm(a: Node, b: Node, c: Node, d: Node) -> Node:
    """Return the reduced norm, the determinant over a splitting field (E. Study)."""

    def of(function: str, x: Node) -> Node:
        return Call(function, (x,))

    mixed = (of("conj", a) * b) * (of("conj", d) * c)
    return of("norm", a) * of("norm", d) + of("norm", b) * of("norm", c) - of("trace", mixed)
