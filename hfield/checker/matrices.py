"""Rewrite matrices in a statement as statements about their entries.

A value is a tree, for a quaternion, or a list of rows, for a matrix.
"""

from collections.abc import Callable
from typing import TypeAlias

from hfield.checker.budget import spend
from hfield.checker.language import ORDER, Operator, Tree, children, walk, with_parts
from hfield.checker.rejection import reject, shown

MATRICES = ("L", "M", "N")
ENTRIES = tuple(f"{name}{place}" for name in MATRICES for place in ("11", "12", "21", "22"))
MAKERS = ("matrix", "row", "column", "transpose")
MAX_POWER = 6
Matrix = list[list[Tree]]
Value: TypeAlias = Tree | Matrix


def without_matrices(tree: Tree, is_constant: Callable[[Tree], bool]) -> Tree:
    """Return a statement about entries; ``is_constant`` tests whether a name is an element of the field."""
    free = {name for name in MATRICES if not any(is_constant(("name", x)) for x in _names(name))}
    for node in walk(tree):
        maker = node[0] == "call" and node[1] in MAKERS
        if maker or (node[0] == "name" and node[1] in free) or _binds(node, free):
            return _MatrixWriter(free).truth(tree)
    return tree


def _binds(node: Tree, free: set[str]) -> bool:
    return bool(node[0] == "exists" and free.intersection(node[1]))


def _names(matrix: str) -> list[str]:
    return [matrix, *(x for x in ENTRIES if x[0] == matrix)]


class _MatrixWriter:
    def __init__(self, free: set[str]) -> None:
        self.free = free

    def truth(self, tree: Tree) -> Tree:
        """Rewrite a statement."""
        spend(5)
        if tree[0] == "exists":
            bound: list[str] = []
            for name in tree[1]:
                bound += _names(name)[1:] if name in self.free else [name]
            return ("exists", tuple(bound), self.truth(tree[2]))
        if tree[0] in ("and", "or", "=>", "<=>", "not"):
            return with_parts(tree, self.truth)
        if tree[0] not in ("==", "!=", *ORDER):
            return self.single(tree)
        left, right = self.value(tree[1]), self.value(tree[2])
        if isinstance(left, tuple) and isinstance(right, tuple):
            return (tree[0], left, right)
        if tree[0] in ORDER:
            reject("matrices have no order")
        rows, others = _alike(left, right)
        pairs = [
            (x, y) for r, s in zip(rows, others, strict=True) for x, y in zip(r, s, strict=True)
        ]
        found: Tree = (tree[0], *pairs[0])
        for pair in pairs[1:]:
            found = ("and" if tree[0] == "==" else "or", found, (tree[0], *pair))
        if tree[0] == "!=":  # if an entry is undefined the comparison is false
            for x in (x for pair in pairs for x in pair if _may_be_undefined(x)):
                found = ("and", found, ("==", x, x))
        return found

    def single(self, tree: Tree) -> Tree:
        """Rewrite a term that may not be a matrix."""
        found = self.value(tree)
        if isinstance(found, list):
            reject("a matrix stands where a quaternion or a scalar is expected")
        return found

    def value(self, tree: Tree) -> Value:
        """Rewrite a term."""
        spend(10)
        if tree[0] == "num":
            return tree
        if tree[0] == "name":
            if tree[1] not in self.free:
                return tree
            entries: list[Tree] = [("name", x) for x in _names(tree[1])[1:]]
            return [entries[:2], entries[2:]]
        if tree[0] == "call":
            return self.call(tree[1], tree[2])
        if tree[0] == "neg":
            return _entrywise(self.value(tree[1]), lambda x: ("neg", x))
        if tree[0] == "pow":
            base = self.value(tree[1])
            if isinstance(base, tuple):
                return ("pow", base, tree[2])
            if not 1 <= tree[2] <= MAX_POWER:
                reject(f"a matrix has the powers 1 to {MAX_POWER}, not {shown(tree[2])}")
            found: Value = base
            for _ in range(tree[2] - 1):
                found = _joined("*", found, base)
            return found
        if tree[0] in ("+", "-", "*", "/"):
            return _joined(tree[0], self.value(tree[1]), self.value(tree[2]))
        if tree[0] == "index":
            return ("index", self.single(tree[1]), tree[2])
        reject("expected a term where there is a statement")

    def call(self, function: str, arguments: tuple[Tree, ...]) -> Value:
        """Rewrite a function of quaternions or of matrices."""
        if function in MAKERS[:3]:
            if len(arguments) != (4 if function == "matrix" else 2):
                reject(f"{function} does not take {len(arguments)} arguments")
            entries = [self.single(x) for x in arguments]
            if function == "row":
                return [entries]
            if function == "column":
                return [[x] for x in entries]
            return [entries[:2], entries[2:]]
        values = [self.value(x) for x in arguments]
        trees = [x for x in values if isinstance(x, tuple)]
        if len(trees) == len(values):
            if function == "transpose":
                reject("transpose takes a matrix")
            return ("call", function, tuple(trees))
        if function == "comm" and len(values) == 2:
            return _joined("-", _joined("*", *values), _joined("*", *reversed(values)))
        rows = values[0]
        if len(values) != 1 or isinstance(rows, tuple):
            reject(f"{function} does not take {len(values)} arguments")
        if function == "transpose":
            return [[row[n] for row in rows] for n in range(len(rows[0]))]
        if function == "conj":
            return _entrywise(rows, lambda x: ("call", "conj", (x,)))
        if function not in ("norm", "trace") or (len(rows), len(rows[0])) != (2, 2):
            reject(f"{shown(function)} takes no such matrix")
        (a, b), (c, d) = rows
        if function == "trace":
            return ("call", "trace", (("+", a, d),))

        def norm(x: Tree) -> Tree:
            return ("call", "norm", (x,))

        # the determinant of the four by four matrix over a splitting field
        corner: Tree = ("*", ("*", ("call", "conj", (a,)), b), ("*", ("call", "conj", (d,)), c))
        squares: Tree = ("+", ("*", norm(a), norm(d)), ("*", norm(b), norm(c)))
        return ("-", squares, ("call", "trace", (corner,)))


def _entrywise(value: Value, function: Callable[[Tree], Tree]) -> Value:
    if isinstance(value, tuple):
        return function(value)
    spend(10)
    return [[function(x) for x in row] for row in value]


def _alike(left: Value, right: Value) -> tuple[Matrix, Matrix]:
    """Return the rows of two values of one shape; a quaternion is a multiple of the identity, 0 has any
    shape.
    """
    shape = left if isinstance(left, list) else right
    out: list[Matrix] = []
    for value in (left, right):
        if isinstance(value, list):
            rows = value
        elif value == ("num", 0) or len(shape) == len(shape[0]):
            rows = [
                [value if m == n else ("num", 0) for n in range(len(shape[0]))]
                for m in range(len(shape))
            ]
        else:
            reject("only 0 is compared with, or added to, a matrix that is not square")
        out.append(rows)
    if len(out[0]) != len(out[1]) or len(out[0][0]) != len(out[1][0]):
        reject("two matrices of different shapes do not fit")
    return out[0], out[1]


def _joined(operator: Operator, left: Value, right: Value) -> Value:
    """Rewrite a sum, a difference, a product or a quotient."""
    spend(20)
    if isinstance(left, tuple) and isinstance(right, tuple):
        return (operator, left, right)
    if operator in ("+", "-"):
        rows = zip(*_alike(left, right), strict=True)
        return [[(operator, x, y) for x, y in zip(r, s, strict=True)] for r, s in rows]
    if isinstance(right, tuple):
        return _entrywise(left, lambda x: (operator, x, right))
    if operator == "/":
        reject("only scalars divide")
    if isinstance(left, tuple):
        return _entrywise(right, lambda x: (operator, left, x))
    return _product(left, right)


def _product(rows: Matrix, others: Matrix) -> Value:
    """Multiply rows by columns; the product of one row and one column is a quaternion."""
    spend(50)
    if len(rows[0]) != len(others):
        reject("two matrices whose shapes do not fit are multiplied")
    found: Matrix = []
    for row in rows:
        found.append([])
        for n in range(len(others[0])):
            total: Tree = ("*", row[0], others[0][n])
            for m in range(1, len(row)):
                total = ("+", total, ("*", row[m], others[m][n]))
            found[-1].append(total)
    return found[0][0] if len(found) == len(found[0]) == 1 else found


def _may_be_undefined(tree: Tree) -> bool:
    """Return whether a term contains a division."""
    divides = tree[0] == "/" or (tree[0] == "call" and tree[1] == "inv")
    fraction = tree[0] == "num" and not isinstance(tree[1], int)
    power = tree[0] == "pow" and tree[2] < 0
    return divides or fraction or power or any(map(_may_be_undefined, children(tree)))
