"""Rewrite statements about an algebra given by a table as statements about coordinates.

In an algebra of dimension at most 4, an unknown p becomes the coordinates ``p[0] … p[3]``. In higher
dimensions it also uses the names of matrix entries, which do not occur in such statements. After the
rewriting only scalars remain, so the methods and the checker need not know tables.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import islice
from typing import TYPE_CHECKING, NoReturn, TypeAlias

from hfield.core.product import Scalar
from hfield.errors import NotationError
from hfield.prover.statements.matrices import ENTRIES, compared
from hfield.prover.statements.matrices import WORDS as MATRIX_WORDS
from hfield.prover.statements.trees import conjunction, walk
from hfield.prover.statements.words import ARGUMENTS
from hfield.syntax import (
    ORDER,
    Binary,
    Call,
    Compare,
    Exists,
    Index,
    Name,
    Negate,
    Node,
    Number,
    Power,
    children,
    parse,
    rebuild,
)

if TYPE_CHECKING:
    from hfield.algebra.structure_algebra import StructureAlgebra

Vector: TypeAlias = tuple[Node, ...]

LETTERS = "pqruvw"
_ENTRIES = [name for own in ENTRIES.values() for name in own]
BLOCKS: Mapping[str, tuple[str, ...]] = {
    letter: (letter, *_ENTRIES[n :: len(LETTERS)]) for n, letter in enumerate(LETTERS)
}
"""The quaternion unknowns whose coordinates are those of an unknown, four each."""
MAX_DIMENSION = 4 * len(BLOCKS["p"])
MAX_POWER, MAX_NODES = 16, 100_000
ZERO, ONE = Number(0), Number(1)
FUNCTIONS = frozenset(
    (
        "conj",
        "inv",
        "norm",
        "trace",
        "scalar",
        "vector",
        "comm",
        *MATRIX_WORDS,
        "transpose",
        *ARGUMENTS,
    )
)


def in_coordinates(
    node: Node, algebra: StructureAlgebra, taken: Collection[str], text: str
) -> Node:
    """Return a statement about the algebra as one about coordinates.

    ``taken`` are the names of elements of the field. Raises :class:`NotationError` for anything without a
    meaning in the algebra.
    """
    if algebra.dimension > MAX_DIMENSION:
        raise NotationError(
            f"statements are decided in algebras of dimension at most {MAX_DIMENSION}; this one has "
            f"dimension {algebra.dimension}"
        )
    needed = -(-algebra.dimension // 4)
    blocks = {letter: names[:needed] for letter, names in BLOCKS.items() if letter not in taken}
    written = _StatementTableWriter(algebra, blocks, frozenset(taken), text).statement(node)
    if any(True for _ in islice(walk(written), MAX_NODES, None)):
        raise NotationError(
            f"in coordinates the statement has more than {MAX_NODES} terms; write it in parts"
        )
    return written


@dataclass
class _StatementTableWriter:
    """The expansion of one text; the value of a term is a node if it is a scalar, else a tuple of
    coordinates.
    """

    algebra: StructureAlgebra
    blocks: Mapping[str, tuple[str, ...]]
    taken: frozenset[str]
    text: str
    # For a comparison: what may be undefined, and whether elements occur besides scalars. If a
    # coordinate is omitted because it is 0, a quotient in it still makes the comparison undefined.
    quotients: list[Node] = field(default_factory=list)
    elements: bool = False

    def fail(self, message: str, node: Node) -> NoReturn:
        raise NotationError(message, self.text, node.position)

    def statement(self, node: Node) -> Node:
        """Expand a statement into coordinates; a term stays as it is, and the check of sorts rejects it."""
        match node:
            case Exists(names, body):
                for name in names:
                    if name in self.algebra.names:
                        self.fail(
                            f"'exists' binds an unknown, and {name!r} is a basis vector", node
                        )
                bound = [x for name in names for x in self.blocks.get(name, (name,))]
                return Exists(tuple(bound), self.statement(body), position=node.position)
            case Compare(op, left, right):
                return self.comparison(op, left, right, node)
            case Name() | Number() | Negate() | Binary() | Power() | Call() | Index():
                self.fail("expected a statement such as p == q, found a term", node)
        return rebuild(node, [self.statement(x) for x in children(node)])

    def comparison(self, op: str, left: Node, right: Node, node: Node) -> Node:
        """Compare coordinate by coordinate, provided that all divisors are invertible."""
        if op in ORDER:
            self.fail(f"{op} is not read in an algebra by its table", node)
        self.quotients, self.elements = [], False
        x, y = self.term(left), self.term(right)
        if isinstance(x, Node) and isinstance(y, Node):
            if not self.elements:
                return Compare(op, x, y, position=node.position)
            pairs = [(x, y)]
        else:
            pairs = list(zip(self.vector(x, left), self.vector(y, right), strict=True))
        defined = [Compare("==", q, q) for q in self.quotients]
        return conjunction([compared(op, pairs, node.position), *defined])

    def vector(self, x: Node | Vector, node: Node) -> Vector:
        """Return the coordinates; a scalar s counts as s·1."""
        if not isinstance(x, Node):
            return x
        if x == ZERO:
            return (ZERO,) * self.algebra.dimension
        one = self.algebra.one
        if one is None:
            self.fail(
                "this algebra has no unit, so that a scalar other than 0 is not an element", node
            )
        return tuple(_times(self.constant(c), x) for c in one.coordinates)

    def constant(self, c: Scalar) -> Node:
        """Return an element of the ring as a tree."""
        ring = self.algebra.ring
        return ZERO if ring.is_zero(c) else parse(ring.text(c))

    def term(self, node: Node) -> Node | Vector:
        """Return a scalar or the coordinates of an element."""
        match node:
            case Name(name):
                return self.name(name, node)
            case Number(value):
                if isinstance(value, Fraction):
                    self.quotients.append(node)
                return node
            case Negate(operand):
                return self.each(self.term(operand), Negate)
            case Index(base, n):
                x = self.term(base)
                if isinstance(x, Node) or n >= self.algebra.dimension:
                    self.fail(f"there is no coordinate {n} here", node)
                return x[n]
            case Power(base, exponent):
                return self.power(self.term(base), exponent, node)
            case Binary(op, left, right):
                return self.binary(op, self.term(left), self.term(right), node)
            case Call("comm", (left, right)):
                x, y = (self.vector(self.term(z), z) for z in (left, right))
                return _joined("-", self.product(x, y), self.product(y, x))
            case Call(function, _):
                if function in FUNCTIONS:
                    self.fail(f"{function} means nothing in an algebra by its table", node)
                return node
        self.fail("expected an element or a scalar, found a statement", node)

    def name(self, name: str, node: Node) -> Node | Vector:
        """Return a basis vector, an unknown element, or a scalar."""
        names = self.algebra.names
        if name in names:
            self.elements = True
            return tuple(ONE if name == other else ZERO for other in names)
        if name in self.blocks:
            self.elements = True
            own = self.blocks[name]
            if not self.taken.isdisjoint(own):
                self.fail(
                    f"{', '.join(own)} are wanted for coordinates, and the field has one", node
                )
            places = range(self.algebra.dimension)
            return tuple(Index(Name(own[n // 4]), n % 4) for n in places)
        if name not in self.taken and (name in "eijk" or name in ENTRIES or name in _ENTRIES):
            known = ", ".join(names)
            self.fail(f"{name!r} means nothing in this algebra, whose basis is {known}", node)
        return node

    def each(self, x: Node | Vector, function: Callable[[Node], Node]) -> Node | Vector:
        """Apply a function to a scalar or to each coordinate."""
        return function(x) if isinstance(x, Node) else tuple(map(function, x))

    def power(self, x: Node | Vector, exponent: int, node: Node) -> Node | Vector:
        """Return a power; a power of an element is multiplied from the left."""
        if isinstance(x, Node):
            power = Power(x, exponent, position=node.position)
            if exponent < 0:
                self.quotients.append(power)
            return power
        if not 0 <= exponent <= MAX_POWER:
            self.fail(f"an element has the powers 0 to {MAX_POWER} here", node)
        if not exponent:
            return self.vector(ONE, node)
        out = x
        for _ in range(exponent - 1):
            out = self.product(out, x)
        return out

    def binary(self, op: str, x: Node | Vector, y: Node | Vector, node: Node) -> Node | Vector:
        """Add, subtract, multiply or divide."""
        if op == "/":
            if not isinstance(y, Node):
                self.fail("only a scalar divides", node)
            self.quotients.append(Binary("/", ONE, y))
        if isinstance(x, Node) and isinstance(y, Node):
            return Binary(op, x, y, position=node.position)
        if op in "+-":
            return _joined(op, self.vector(x, node), self.vector(y, node))
        if isinstance(y, Node):
            return self.each(x, lambda c: c if c == ZERO else Binary(op, c, y))
        if isinstance(x, Node):
            return tuple(_times(c, x) for c in y)
        return self.product(x, y)

    def product(self, x: Vector, y: Vector) -> Vector:
        """Return the product of two elements by the table."""
        table = self.algebra.table
        terms: list[list[Node]] = [[] for _ in x]
        for m, a in enumerate(x):
            for n, b in enumerate(y):
                if ZERO in (a, b):
                    continue
                for own, c in zip(terms, table[m][n], strict=True):
                    coefficient = self.constant(c)
                    if coefficient != ZERO:
                        own.append(_times(coefficient, _times(a, b)))
        return tuple(map(_sum, terms))


def _times(x: Node, y: Node) -> Node:
    if ZERO in (x, y):
        return ZERO
    if x == ONE:
        return y
    if x == Negate(ONE):
        return Negate(y)
    return x if y == ONE else Binary("*", x, y)


def _sum(terms: Sequence[Node]) -> Node:
    """Add terms in a balanced tree."""
    if len(terms) > 2:
        half = len(terms) // 2
        return Binary("+", _sum(terms[:half]), _sum(terms[half:]))
    return Binary("+", *terms) if len(terms) == 2 else terms[0] if terms else ZERO


def _joined(op: str, x: Vector, y: Vector) -> Vector:
    out: list[Node] = []
    for a, b in zip(x, y, strict=True):
        if b == ZERO:
            out.append(a)
        elif a == ZERO:
            out.append(b if op == "+" else Negate(b))
        else:
            out.append(Binary(op, a, b))
    return tuple(out)
