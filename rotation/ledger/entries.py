"""Matrices and vectors whose entries are terms of the statement language.

Sums and products leave out zeros and ones, so that what is built stays short. Vectors are rows of
texts; equalities are statements, entry by entry.
"""

from __future__ import annotations

from collections.abc import Sequence

Vector = tuple[str, ...]
Matrix = tuple[Vector, ...]


def matrix(text: str) -> Matrix:
    """Read a matrix written ``c, -s; s, c``: rows between semicolons."""
    return tuple(vector(row) for row in text.split(";"))


def vector(text: str) -> Vector:
    """Read a vector written ``1, -1, 1``."""
    return tuple(entry.strip() for entry in text.split(","))


def coordinates(name: str, n: int = 3) -> Vector:
    """Return a vector of unknowns: the last three coordinates of a quaternion, or its first two."""
    return tuple(f"{name}[{m}]" for m in (range(1, 4) if n == 3 else range(n)))


def general(names: str) -> Matrix:
    """Return a matrix of unknowns: 2 × 2 from one quaternion, 3 × 3 from the vector parts of three."""
    if len(names) == 1:
        return tuple(tuple(f"{names}[{2 * r + c}]" for c in (0, 1)) for r in (0, 1))
    return tuple(coordinates(name) for name in names)


def identity(n: int) -> Matrix:
    """Return the identity matrix."""
    return tuple(tuple(str(int(r == c)) for c in range(n)) for r in range(n))


def product(x: str, y: str) -> str:
    """Return the product of two terms."""
    if "0" in (x, y):
        return "0"
    if x in ("1", "-1"):
        return negative(y) if x == "-1" else y
    if y in ("1", "-1"):
        return negative(x) if y == "-1" else x
    if x[0] == "-" and _is_single(x[1:]):
        return negative(product(x[1:], y))
    if y[0] == "-" and _is_single(y[1:]):
        return negative(product(x, y[1:]))
    return f"{_factor(x)}*{_factor(y)}"


def negative(x: str) -> str:
    """Return −x."""
    if x == "0":
        return x
    if x[0] == "-" and _is_single(x[1:]):
        return x[1:]
    return f"-{x}" if _is_single(x) else f"-({x})"


def total(terms: Sequence[str]) -> str:
    """Return a sum."""
    out = ""
    for x in terms:
        if x == "0":
            continue
        if not out:
            out = x
        elif x[0] == "-" and _is_single(x[1:]):
            out += f" - {x[1:]}"
        else:
            out += f" + {x}" if x[0] != "-" else f" + ({x})"
    return out or "0"


def dot(v: Vector, w: Vector) -> str:
    """Return the scalar product."""
    return total([product(x, y) for x, y in zip(v, w, strict=True)])


def cross(v: Vector, w: Vector) -> Vector:
    """Return the cross product v × w."""
    pairs = ((1, 2), (2, 0), (0, 1))
    return tuple(difference(product(v[m], w[n]), product(v[n], w[m])) for m, n in pairs)


def difference(x: str, y: str) -> str:
    """Return x − y."""
    return total([x, negative(y)])


def plus(v: Vector, w: Vector) -> Vector:
    """Return the sum of two vectors."""
    return tuple(total([x, y]) for x, y in zip(v, w, strict=True))


def scaled(x: str, v: Vector) -> Vector:
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


def shifted(m: Matrix, x: str) -> Matrix:
    """Return m + x·I."""
    return tuple(
        tuple(total([entry, x]) if r == c else entry for c, entry in enumerate(row))
        for r, row in enumerate(m)
    )


def minor(m: Matrix, row: int, column: int) -> Matrix:
    """Return the matrix without a row and a column."""
    rows = [entries for r, entries in enumerate(m) if r != row]
    return tuple(tuple(x for c, x in enumerate(entries) if c != column) for entries in rows)


def det(m: Matrix) -> str:
    """Return the determinant, expanded along the first row."""
    if len(m) == 1:
        return m[0][0]
    terms = [product(x, det(minor(m, 0, c))) for c, x in enumerate(m[0])]
    return total([negative(x) if c % 2 else x for c, x in enumerate(terms)])


def trace(m: Matrix) -> str:
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


def equal(m: Matrix | Vector, n: Matrix | Vector) -> str:
    """Return the equality of two matrices or vectors, entry by entry."""
    return " and ".join(f"{x} == {y}" for x, y in zip(_entries(m), _entries(n), strict=True))


def symmetric(m: Matrix, n: Matrix) -> str:
    """Return the equality of two symmetric matrices: the entries on and above the diagonal."""
    size = range(len(m))
    return " and ".join(f"{m[r][c]} == {n[r][c]}" for r in size for c in size if r <= c)


def orthogonal(m: Matrix) -> str:
    """Return the statement m·mᵀ = I, each of its equations once."""
    return symmetric(times(m, transpose(m)), identity(len(m)))


def both(*parts: str) -> str:
    """Join statements by ``and``."""
    return " and ".join(part for part in parts if part)


def _entries(m: Matrix | Vector) -> list[str]:
    return [entry for row in m for entry in ([row] if isinstance(row, str) else row)]


def _is_single(x: str) -> bool:
    """Tell whether a text is no sum outside its parentheses, and does not begin with a sign."""
    depth = 0
    for n, char in enumerate(x):
        depth += (char in "([") - (char in ")]")
        if not depth and char in "+-" and (n == 0 or x[n - 1] != "*"):
            return False
    return True


def _factor(x: str) -> str:
    return x if _is_single(x) else f"({x})"
