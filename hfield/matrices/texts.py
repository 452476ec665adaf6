"""Read matrices such as ``[[1, i], [j, k]]`` and expressions in them.

Where a matrix is expected, double brackets are its rows; a bracket inside an entry is a commutator.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import CoercionError, NoSolutionError, NotationError, shorten
from hfield.matrices.equations import Solutions
from hfield.matrices.matrix import Matrix
from hfield.matrices.vocabulary import vocabulary
from hfield.syntax import Reader, plain
from hfield.syntax.brackets import outside, split

EXPECTED = "expected rows such as [[1, i], [j, k]]"


def read_matrix(algebra: Parent, text: str, vector: str = "") -> Matrix:
    """Return the matrix given by a text: rows, or an expression such as ``[[1, i], [j, k]]^2 * 2``.

    ``[1, i]`` is also a matrix if ``vector`` is ``"column"`` or ``"row"``. Functions are ``inv``, ``conj`` of
    each entry, and ``transpose``. Raises :class:`NotationError` for anything else.
    """
    if vector and _is_bracket(text) and not text.strip()[1:].lstrip().startswith("["):
        entries = [algebra(x) for x in split(text.strip()[1:-1], ",")]
        return Matrix(algebra, [entries] if vector == "row" else [[x] for x in entries])
    if not has_matrix(text):
        raise NotationError(f"{shorten(text)} is not a matrix; {EXPECTED}")
    F = algebra.ring
    found, functions = vocabulary(algebra, MatrixOperand, MatrixOperand.element)
    before, rest = "", text
    while (place := _matrix_at(rest)) is not None:
        start, end = place
        name = f"matrix_{len(found)}"
        found[name] = MatrixOperand(_literal(algebra, rest[start:end]))
        before, rest = f"{before}{rest[:start]} {name} ", rest[end:]
    functions |= {
        "/": lambda x, y: x * MatrixOperand(y.element().inverse()),
        "**": lambda x, n: MatrixOperand(x.value**n),
        "inv": lambda x: MatrixOperand(x.value.inverse()),
        "conj": lambda x: MatrixOperand(x.value.conjugate()),
        "transpose": lambda x: MatrixOperand(x.matrix().T),
    }
    reader = Reader(
        lambda n: MatrixOperand(algebra.scalar(n)),
        found,
        functions,
        f"matrices over {algebra}",
        F.parse_limit,
    )
    operand: MatrixOperand = reader.read_typed(before + rest)
    return operand.matrix()


@dataclass(frozen=True)
class MatrixOperand:
    """A matrix or an element while an expression is computed; ``*`` is the product of matrices."""

    value: Matrix | Quaternion

    def matrix(self) -> Matrix:
        """Return the matrix. Raises :class:`NotationError` for an element."""
        if not isinstance(self.value, Matrix):
            raise NotationError(f"{shorten(self.value)} is not a matrix; {EXPECTED}")
        return self.value

    def element(self) -> Quaternion:
        """Return the element. Raises :class:`NotationError` for a matrix."""
        if isinstance(self.value, Matrix):
            raise NotationError(
                "an element is expected, not a matrix; for a quotient write M * inv(N)"
            )
        return self.value

    def __mul__(self, other: MatrixOperand) -> MatrixOperand:
        a, b = self.value, other.value
        both = isinstance(a, Matrix) and isinstance(b, Matrix)
        return MatrixOperand(a @ b if both else a * b)  # type: ignore[operator]

    def __add__(self, other: MatrixOperand) -> MatrixOperand:
        a, b = self.value, other.value
        if isinstance(a, Matrix) != isinstance(b, Matrix):
            raise CoercionError(
                f"a matrix and an element do not add: {shorten(a)} and {shorten(b)}"
            )
        return MatrixOperand(a + b)

    def __neg__(self) -> MatrixOperand:
        return MatrixOperand(-self.value)

    def __sub__(self, other: MatrixOperand) -> MatrixOperand:
        return self + -other


@dataclass(frozen=True, eq=False, repr=False)
class MatrixSolutions(Solutions[Matrix]):
    """All x with M·x = b, or with x·M = b if ``from_right``; kernel combinations have scalars on the other
    side.
    """

    from_right: bool = False


def read_matrix_equation(algebra: Parent, text: str, unknown: str = "x") -> MatrixSolutions:
    """Solve ``[[1, i], [j, k]]*x = [i, j]``, or ``x*M = b``; both sides are read by :func:`read_matrix`.

    The right side may be a column, or for x·M a row, written as a list. Raises :class:`NotationError`.
    """
    sides = [side.strip() for side in text.replace("==", "=").split("=")]
    x = re.escape(unknown)
    product = re.compile(rf"(?:(?P<left>.+?)\s*[*·]\s*)?{x}(?:\s*[*·]\s*(?P<right>.+))?", re.DOTALL)
    read = [found.groupdict() for side in sides if (found := product.fullmatch(side))]
    if len(sides) != 2 or len(read) != 1 or (read[0]["left"] is None) == (read[0]["right"] is None):
        raise NotationError(
            f"an equation with a matrix is M*{unknown} = b or {unknown}*M = b, as in "
            f"[[1, i], [j, k]]*{unknown} = [i, j]; found {shorten(text)!r}"
        )
    other = sides[product.fullmatch(sides[0]) is not None]
    left, right = read[0]["left"], read[0]["right"]
    if left is not None:
        M, b = read_matrix(algebra, left), read_matrix(algebra, other, "column")
    else:  # x·M = b means that M*·x* = b*
        M = read_matrix(algebra, right).conjugate_transpose()
        b = read_matrix(algebra, other, "row").conjugate_transpose()

    from_right = left is None

    def back(y: Matrix) -> Matrix:
        return y.conjugate_transpose() if from_right else y

    kernel = tuple(back(Matrix(algebra, [[q] for q in v])) for v in M.right_kernel())
    try:
        return MatrixSolutions(True, witness=back(M.solve(b)), kernel=kernel, from_right=from_right)
    except NoSolutionError as error:
        if not from_right:
            return MatrixSolutions(False, str(error), kernel=kernel, from_right=from_right)
        y = ", ".join(str(q.conjugate()) for q in map(algebra, error.witness))
        why = f"there is no {unknown} with {unknown}·M = b: M·y = 0 and b·y is not 0 for y = ({y})"
        return MatrixSolutions(False, why, kernel=kernel, from_right=from_right)


def _matrix_at(text: str) -> tuple[int, int] | None:
    """Return the start and the end of the first double bracket."""
    start = 0
    while (start := text.find("[", start)) >= 0:
        if text[start + 1 :].lstrip().startswith("["):
            depth = 0
            for end, char in enumerate(text[start:], start + 1):
                depth += (char in "([") - (char in ")]")
                if not depth:
                    return start, end
            raise NotationError(f"{shorten(text[start:])!r} lacks a closing bracket")
        start += 1
    return None


def _literal(algebra: Parent, text: str) -> Matrix:
    rows = split(text.strip()[1:-1], ",")
    for row in rows:
        if not _is_bracket(row):
            raise NotationError(f"{shorten(row.strip())!r} is not a row of a matrix; {EXPECTED}")
        plain(row)  # refuses a row that is a matrix itself
    return Matrix(algebra, [split(row.strip()[1:-1], ",") for row in rows])


def _is_bracket(text: str) -> bool:
    """Return whether a text is one matching pair of square brackets with its content."""
    text = text.strip()
    return text[:1] == "[" and text[-1:] == "]" and not any(True for _ in outside(text))


def has_matrix(text: str) -> bool:
    """Return whether a text contains a double bracket."""
    return _matrix_at(text) is not None
