"""Matrices and vectors whose entries are terms of the statement language.

Sums and products omit zeros and ones, so that terms stay short. Vectors are rows of terms; equalities are
statements, entry by entry.
"""

from __future__ import annotations

from collections.abc import Sequence

from hfield.syntax import Negate, Node, both, names, number, parse
from hfield.syntax import equal as same

ZERO, ONE = number(0), number(1)

Vector = tuple[Node, ...]
Matrix = tuple[Vector, ...]


def matrix(text: str) -> Matrix:
    """Read a matrix such as ``c, -s; s, c``, with rows separated by semicolons."""
    return tuple(vector(row) for row in text.split(";"))


def vector(text: str) -> Vector:
    """Read a vector such as ``1, -1, 1``."""
    return tuple(map(parse, text.split(",")))


def coordinates(name: str, n: int = 3) -> Vector:
    """Return a vector of unknowns: the last three coordinates of a quaternion, or its first two."""
    (unknown,) = names(name)
    return tuple(unknown[m] for m in (range(1, 4) if n == 3 else range(n)))


def general(unknowns: str) -> Matrix:
    """Return a matrix of unknowns: 2 × 2 from one quaternion, 3 × 3 from the vector parts of three."""
    if len(unknowns) == 1:
        (q,) = names(unknowns)
        return (q[0], q[1]), (q[2], q[3])
    return tuple(coordinates(name) for name in unknowns)


def identity(n: int) -> Matrix:
    """Return the identity matrix."""
    return tuple(tuple(number(int(r == c)) for c in range(n)) for r in range(n))


def product(x: Node, y: Node) -> Node:
    """Return the product of two terms."""
    if ZERO in (x, y):
        return ZERO
    if isinstance(x, Negate):
        return negative(product(x.operand, y))
    if isinstance(y, Negate):
        return negative(product(x, y.operand))
    return y if x == ONE else x if y == ONE else x * y


def negative(x: Node) -> Node:
    """Return −x."""
    if x == ZERO:
        return x
    return x.operand if isinstance(x, Negate) else -x


def total(terms: Sequence[Node]) -> Node:
    """Return a sum."""
    out: Node | None = None
    for x in terms:
        if x == ZERO:
            continue
        out = x if out is None else out - x.operand if isinstance(x, Negate) else out + x
    return out or ZERO


def dot(v: Vector, w: Vector) -> Node:
    """Return the scalar product."""
    return total([product(x, y) for x, y in zip(v, w, strict=True)])


def cross(v: Vector, w: Vector) -> Vector:
    """Return the cross product v × w."""
    pairs = ((1, 2), (2, 0), (0, 1))
    return tuple(difference(product(v[m], w[n]), product(v[n], w[m])) for m, n in pairs)


def difference(x: Node, y: Node) -> Node:
    """Return x − y."""
    return total([x, negative(y)])


def plus(v: Vector, w: Vector) -> Vector:
    """Return the sum of two vectors."""
    return tuple(total([x, y]) for x, y in zip(v, w, strict=True))


def scaled(x: Node, v: Vector) -> Vector:
    """Return x·v."""
    return tuple(product(x, y) for y in v)


def transpose(m: Matrix) -> Matrix:
    """Return the transposed matrix."""
    return tuple(zip(*m, strict=True))


def times(*factors: Matrix) -> Matrix:
    """Return the product of matrices."""
    first, *rest = factors
    for m in rest:
        first = tuple(tuple(dot(row, column) for column in transpose(m)) for row in first)
    return first


def apply(m: Matrix, v: Vector) -> Vector:
    """Return the image of a vector under a matrix."""
    return tuple(dot(row, v) for row in m)


def shifted(m: Matrix, x: Node) -> Matrix:
    """Return m + x·I."""
    return tuple(
        tuple(total([entry, x]) if r == c else entry for c, entry in enumerate(row))
        for r, row in enumerate(m)
    )


def minor(m: Matrix, row: int, column: int) -> Matrix:
    """Return the matrix without a row and a column."""
    rows = [entries for r, entries in enumerate(m) if r != row]
    return tuple(tuple(x for c, x in enumerate(entries) if c != column) for entries in rows)


def det(m: Matrix) -> Node:
    """Return the determinant, expanded along the first row."""
    if len(m) == 1:
        return m[0][0]
    terms = [product(x, det(minor(m, 0, c))) for c, x in enumerate(m[0])]
    return total([negative(x) if c % 2 else x for c, x in enumerate(terms)])


def trace(m: Matrix) -> Node:
    """Return the trace."""
    return total([row[n] for n, row in enumerate(m)])


def cofactors(m: Matrix) -> Matrix:
    """Return the matrix of cofactors, the transposed adjugate."""
    size = range(len(m))
    minors = [[det(minor(m, r, c)) for c in size] for r in size]
    return tuple(
        tuple(negative(x) if (r + c) % 2 else x for c, x in enumerate(row))
        for r, row in enumerate(minors)
    )


def equal(m: Matrix | Vector, n: Matrix | Vector) -> Node:
    """Return the equality of two matrices or vectors, entry by entry."""
    return both(*(same(x, y) for x, y in zip(_entries(m), _entries(n), strict=True)))


def symmetric(m: Matrix, n: Matrix) -> Node:
    """Return the equality of two symmetric matrices: the entries on and above the diagonal."""
    size = range(len(m))
    return both(*(same(m[r][c], n[r][c]) for r in size for c in size if r <= c))


def orthogonal(m: Matrix) -> Node:
    """Return the statement m·mᵀ = I, with each of its equations once."""
    return symmetric(times(m, transpose(m)), identity(len(m)))


def _entries(m: Matrix | Vector) -> list[Node]:
    return [entry for row in m for entry in ([row] if isinstance(row, Node) else row)]
