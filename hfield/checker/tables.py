"""Rewrite statements about algebras given by tables as statements about coordinates.

``table(e, i; 1 = e: e, i; i, -e|QQ)`` lists the basis, the unit if there is one, and the products of the
basis vectors, row times column. An unknown element is represented by its coordinates: those of the unknown
quaternion with the same letter, and above dimension 4 also matrix entries.
"""

import re
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

from hfield.checker.budget import spend
from hfield.checker.language import WORDS, Operator, Tree, children, parse, split, walk, with_parts
from hfield.checker.matrices import ENTRIES, MAKERS, MATRICES
from hfield.checker.rejection import reject, shown
from hfield.checker.scalars.ring import AnyRing
from hfield.checker.words import ARGUMENTS

LETTERS = "pqruvw"
BLOCKS = {
    letter: (letter, *ENTRIES[n :: len(LETTERS)]) for n, letter in enumerate(LETTERS)
}  # the quaternions whose coordinates an unknown has, four each
MAX_DIMENSION = 12
MAX_POWER, MAX_TERMS = 16, 100_000
MAX_CONSTANT = 200
ZERO: Tree = ("num", 0)
ONE: Tree = ("num", 1)
FUNCTIONS = ("conj", "inv", "norm", "trace", "scalar", "vector", "comm", *MAKERS, *ARGUMENTS)
Vector = list[Tree]
Value: TypeAlias = Tree | Vector
"""The value of a term: a tree for a scalar, coordinates for an element."""


@dataclass(frozen=True)
class Table:
    """The products of basis vectors, as coordinates; ``one`` is the unit or None."""

    ring: AnyRing
    names: tuple[str, ...]
    products: tuple[tuple[tuple[Tree, ...], ...], ...]
    one: tuple[Tree, ...] | None


def is_table(algebra: str) -> bool:
    """Return whether the text of an algebra is a table."""
    return algebra.startswith("table(")


def read_table(algebra: str, ring: AnyRing | None) -> Table:
    """Read an algebra given by a table over a named ring; the unit must be correct."""
    if ring is None or not algebra.endswith(f"|{ring.name})"):
        reject(f"the table {shown(algebra)!r} names another ring than the data")
    head, colon, body = algebra[len("table(") : -len(ring.name) - 2].partition(":")
    listed, semicolon, unit = head.partition(";")
    names = tuple(name.strip() for name in listed.split(","))
    n = len(names)
    if not colon or len(set(names)) < n or n > MAX_DIMENSION:
        reject(f"a table has at most {MAX_DIMENSION} names of basis vectors, all different")
    for name in names:
        free = re.fullmatch("[A-Za-z_][A-Za-z0-9_]*", name) and name not in WORDS
        if not free or ring.constant(("name", name)) is not None:
            reject(f"{shown(name)!r} cannot name a basis vector")
    rows = [split(row, ",") for row in split(body, ";")]
    if len(rows) != n or any(len(row) != n for row in rows):
        reject(f"a table with {n} basis vectors has {n} rows of {n} products")
    linear = _Linear(ring, names)
    products = tuple(tuple(tuple(linear.read(text)) for text in row) for row in rows)
    one = None
    if semicolon:
        said = re.fullmatch(r"\s*1\s*=(.*)", unit, re.DOTALL)
        if said is None:
            reject("expected '1 =' and the unit")
        one = tuple(linear.read(said[1]))
    table = Table(ring, names, products, one)
    _check_unit(table)
    return table


def _check_unit(table: Table) -> None:
    """Reject a false unit: 1·x = x = x·1 must hold for each basis vector x."""
    ring, n = table.ring, len(table.names)
    if table.one is None:
        return
    one = [ring.value(c, "the unit") for c in table.one]
    for m in range(n):
        for at in range(n):
            left, right = ring.number(0), ring.number(0)
            for k, c in enumerate(one):
                spend(10)
                entries = (table.products[k][m][at], table.products[m][k][at])
                x, y = (ring.value(entry, "a product") for entry in entries)
                left, right = ring.add(left, ring.mul(c, x)), ring.add(right, ring.mul(c, y))
            expected = ring.number(int(m == at))
            if not (ring.equal(left, expected) and ring.equal(right, expected)):
                reject("what is said to be the unit is not")


class _Linear:
    """Reads linear combinations of basis vectors."""

    def __init__(self, ring: AnyRing, names: tuple[str, ...]) -> None:
        self.ring, self.names = ring, names

    def read(self, text: str) -> Vector:
        """Return the coordinates; zeros are the number 0."""
        tree = parse(text)
        nodes = walk(tree)
        if len(nodes) > MAX_CONSTANT * len(self.names):
            reject("an entry of the table is too large")
        found = self.vector(tree)
        return [ZERO if self.ring.is_zero(self.ring.value(c, text)) else c for c in found]

    def is_scalar(self, tree: Tree) -> bool:
        """Return whether a term contains no basis vector."""
        return not any(node[0] == "name" and node[1] in self.names for node in walk(tree))

    def vector(self, tree: Tree) -> Vector:
        """Return the coordinates as trees."""
        spend(5 + len(self.names))
        if tree[0] == "name" and tree[1] in self.names:
            return [ONE if tree[1] == name else ZERO for name in self.names]
        if tree == ZERO:
            return [ZERO for _ in self.names]
        if tree[0] == "neg":
            return _negative(self.vector(tree[1]))
        if tree[0] in ("+", "-"):
            return _added(tree[0], self.vector(tree[1]), self.vector(tree[2]))
        if tree[0] == "*" and self.is_scalar(tree[1]):
            return [_times(tree[1], c) for c in self.vector(tree[2])]
        if tree[0] in ("*", "/") and self.is_scalar(tree[2]):
            return [
                c if c == ZERO else _times(c, tree[2]) if tree[0] == "*" else ("/", c, tree[2])
                for c in self.vector(tree[1])
            ]
        reject("an entry of a table is a combination of basis vectors")


def in_coordinates(tree: Tree, table: Table) -> Tree:
    """Return a statement about elements of the algebra as a statement about their coordinates."""
    written = _TableWriter(table).truth(tree)
    size, stack = 0, [written]
    while stack:
        node = stack.pop()
        size += 1
        spend(1)
        if size > MAX_TERMS:
            reject("in coordinates the statement is too long")
        stack.extend(children(node))
    return written


class _TableWriter:
    """The expansion of one statement; a value is a tree for a scalar, or a list of trees."""

    def __init__(self, table: Table) -> None:
        self.table, self.names = table, table.names
        # For a comparison: what may be undefined, and whether elements occur besides scalars. If a
        # coordinate is omitted because it is 0, a quotient in it still makes the comparison
        # undefined.
        self.quotients: list[Tree] = []
        self.elements = False
        needed = -(-len(self.names) // 4)
        self.blocks = {
            letter: own[:needed]
            for letter, own in BLOCKS.items()
            if not self.is_constant(letter) and letter not in self.names
        }
        for own in self.blocks.values():
            if any(self.is_constant(name) for name in own):
                reject("the field has an element with the name of a coordinate")

    def is_constant(self, name: str) -> bool:
        """Return whether a name is an element of the field."""
        return self.table.ring.constant(("name", name)) is not None

    def truth(self, tree: Tree) -> Tree:
        """Rewrite a statement."""
        spend(5)
        if tree[0] == "exists":
            if any(name in self.names for name in tree[1]):
                reject("'exists' binds no basis vector")
            bound = [x for name in tree[1] for x in self.blocks.get(name, (name,))]
            return ("exists", tuple(bound), self.truth(tree[2]))
        if tree[0] in ("and", "or", "=>", "<=>", "not"):
            return with_parts(tree, self.truth)
        if tree[0] not in ("==", "!="):
            reject("expected a statement such as p == q where there is a term")
        self.quotients, self.elements = [], False
        left, right = self.value(tree[1]), self.value(tree[2])
        if isinstance(left, tuple) and isinstance(right, tuple):
            parts: list[Tree] = [(tree[0], left, right)]
            if not self.elements:
                return parts[0]
        else:
            x, y = self.vector(left), self.vector(right)
            parts = [(tree[0], a, b) for a, b in zip(x, y, strict=True)]
        out = parts[0]
        for part in parts[1:]:
            out = ("and" if tree[0] == "==" else "or", out, part)
        for q in self.quotients:
            out = ("and", out, ("==", q, q))
        return out

    def vector(self, x: Value) -> Vector:
        """Return the coordinates of an element, or of a multiple of the unit."""
        if isinstance(x, list):
            return x
        if x == ZERO:
            return [ZERO for _ in self.names]
        if self.table.one is None:
            reject("a scalar other than 0 is not an element of an algebra without unit")
        return [_times(c, x) for c in self.table.one]

    def value(self, tree: Tree) -> Value:
        """Rewrite a term."""
        spend(5 + len(self.names))
        if tree[0] == "num":
            if isinstance(tree[1], Fraction):
                self.quotients.append(tree)
            return tree
        if tree[0] == "name":
            return self.name(tree[1], tree)
        if tree[0] == "neg":
            x = self.value(tree[1])
            return [("neg", c) for c in x] if isinstance(x, list) else ("neg", x)
        if tree[0] == "index":
            x = self.value(tree[1])
            if not isinstance(x, list) or tree[2] >= len(x):
                reject(f"there is no coordinate {tree[2]} here")
            return x[tree[2]]
        if tree[0] == "pow":
            return self.power(self.value(tree[1]), tree[2])
        if tree[0] in ("+", "-", "*", "/"):
            return self.binary(tree[0], self.value(tree[1]), self.value(tree[2]))
        if tree[0] == "call":
            if tree[1] == "comm" and len(tree[2]) == 2:
                x, y = (self.vector(self.value(z)) for z in tree[2])
                return _added("-", self.product(x, y), self.product(y, x))
            if tree[1] in FUNCTIONS or self.table.ring.constant(tree) is None:
                reject(f"{shown(tree[1])} means nothing in an algebra by its table")
            return tree
        reject("expected a term where there is a statement")

    def name(self, name: str, tree: Tree) -> Value:
        """Return the coordinates of a basis vector or an unknown; a scalar is returned unchanged."""
        if name in self.names:
            self.elements = True
            return [ONE if name == other else ZERO for other in self.names]
        if name in self.blocks:
            self.elements = True
            own = self.blocks[name]
            return [("index", ("name", own[n // 4]), n % 4) for n in range(len(self.names))]
        if not self.is_constant(name) and (
            (len(name) == 1 and name in "eijk") or name in (*MATRICES, *ENTRIES)
        ):
            reject(f"{shown(name)!r} means nothing in this algebra")
        return tree

    def power(self, x: Value, exponent: int) -> Value:
        """Return the left-associated power."""
        if isinstance(x, tuple):
            power: Tree = ("pow", x, exponent)
            if exponent < 0:
                self.quotients.append(power)
            return power
        if not 0 <= exponent <= MAX_POWER:
            reject(f"an element has the powers 0 to {MAX_POWER}")
        if not exponent:
            return self.vector(ONE)
        out = x
        for _ in range(exponent - 1):
            out = self.product(out, x)
        return out

    def binary(self, kind: Operator, x: Value, y: Value) -> Value:
        """Add, subtract, multiply or divide."""
        if kind == "/":
            if isinstance(y, list):
                reject("only scalars divide")
            self.quotients.append(("/", ONE, y))
        if isinstance(x, tuple) and isinstance(y, tuple):
            return (kind, x, y)
        if kind in ("+", "-"):
            return _added(kind, self.vector(x), self.vector(y))
        if isinstance(y, tuple):
            return [c if c == ZERO else (kind, c, y) for c in self.vector(x)]
        if isinstance(x, tuple):
            return [_times(c, x) for c in y]
        return self.product(x, y)

    def product(self, x: Vector, y: Vector) -> Vector:
        """Multiply two elements by the table."""
        terms: list[Vector] = [[] for _ in x]
        for m, a in enumerate(x):
            for n, b in enumerate(y):
                spend(5)
                if ZERO in (a, b):
                    continue
                for own, c in zip(terms, self.table.products[m][n], strict=True):
                    spend(1)
                    if c != ZERO:
                        own.append(_times(c, _times(a, b)))
        return [_total(own) for own in terms]


def _times(x: Tree, y: Tree) -> Tree:
    if ZERO in (x, y):
        return ZERO
    if x == ONE or y == ONE:
        return y if x == ONE else x
    return ("neg", y) if x == ("neg", ONE) else ("*", x, y)


def _negative(x: Vector) -> Vector:
    return [c if c == ZERO else ("neg", c) for c in x]


def _total(terms: Vector) -> Tree:
    """Add terms in a balanced tree."""
    while len(terms) > 1:
        pairs = zip(terms[::2], [*terms[1::2], None], strict=False)
        terms = [x if y is None else ("+", x, y) for x, y in pairs]
    return terms[0] if terms else ZERO


def _added(kind: Operator, x: Vector, y: Vector) -> Vector:
    out: Vector = []
    for a, b in zip(x, y, strict=True):
        if ZERO not in (a, b):
            out.append((kind, a, b))
        elif b == ZERO:
            out.append(a)
        else:
            out.append(b if kind == "+" else ("neg", b))
    return out
