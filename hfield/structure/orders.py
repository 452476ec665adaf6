"""Orders over ℤ in quaternion algebras over ℚ: Lipschitz, Hurwitz, maximal ones, and their units.

A ternary lattice with an integral form gives an order, its even Clifford algebra, whose reduced
discriminant is the half-discriminant of the form (Voight, *Quaternion Algebras*, chapter 22); so a maximal
order comes from a form minimised at every prime. Units are the vectors of norm 1 of a positive
definite lattice, which are enumerated after Fincke and Pohst.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from hfield.errors import CoercionError, NotFiniteError, TooLargeError
from hfield.factorisation import factorise
from hfield.product import Constants, Coordinates, conjugate, multiply, norm, trace
from hfield.structure.forms import discriminant
from hfield.structure.integers import fraction
from hfield.structure.minimise import Conic, Lattice, half_discriminant, minimise
from hfield.structure.primes import PrimePlace

Vector = tuple[Fraction, Fraction, Fraction, Fraction]
MAX_UNITS = 1000


def rational_constants(c: Constants) -> Constants:
    """Return the constants as Fractions; raise :class:`CoercionError` for a degenerate algebra."""
    a, t, b = (fraction(x) for x in c)
    if not discriminant(Constants(a, t, b)):
        raise CoercionError(
            "a degenerate algebra, (t² + 4a)·b = 0, has no orders here: it is not simple"
        )
    return Constants(a, t, b)


@dataclass(frozen=True)
class Order:
    """An order: the integer combinations of ``basis``, rational vectors over e, i, j, k."""

    constants: Constants
    basis: tuple[Vector, Vector, Vector, Vector]

    def coordinates(self, q: Sequence[Any]) -> Vector:
        """Return the rational coordinates of an element with respect to the basis."""
        solution = _solve(
            [list(column) for column in zip(*self.basis, strict=True)], [fraction(x) for x in q]
        )
        w, x, y, z = solution
        return w, x, y, z

    def __contains__(self, q: Sequence[Any]) -> bool:
        """Tell whether an element, four coordinates over e, i, j, k, lies in the order."""
        return all(x.denominator == 1 for x in self.coordinates(q))

    @property
    def discriminant(self) -> int:
        """The reduced discriminant: the square root of ``|det(tr(uᵢ·uⱼ))|``."""
        c = self.constants
        gram = [[trace(c, multiply(c, u, v)) for v in self.basis] for u in self.basis]
        return math.isqrt(abs(int(_determinant(gram))))

    @property
    def is_order(self) -> bool:
        """Whether the lattice contains 1 and is closed under multiplication."""
        products = (multiply(self.constants, u, v) for u in self.basis for v in self.basis)
        return (1, 0, 0, 0) in self and all(q in self for q in products)

    def units(self) -> tuple[Vector, ...]:
        """Return the units of norm 1 of an order in a definite algebra: all its units.

        Raises :class:`NotFiniteError` for an indefinite algebra, whose orders have infinitely many.
        """
        a, t, b = self.constants
        if a + t * t / 4 > 0 or b > 0:
            raise NotFiniteError(
                "an order in an indefinite algebra has infinitely many units: only definite ones are listed"
            )
        return tuple(sorted(self._of_norm(Fraction(1)), reverse=True))

    def _of_norm(self, n: Fraction) -> Iterator[Vector]:
        basis, gram = _short(self.constants, self.basis)
        for found, coefficients in enumerate(_vectors_of_length(gram, n)):
            if found >= MAX_UNITS:
                raise TooLargeError(f"more than {MAX_UNITS} elements of norm {n}")
            w, x, y, z = (
                sum((k * u[i] for k, u in zip(coefficients, basis, strict=True)), Fraction(0))
                for i in range(4)
            )
            yield w, x, y, z


def _short(c: Constants, basis: Sequence[Vector]) -> tuple[list[Vector], list[list[Fraction]]]:
    """Return a reduced basis of a definite lattice, and its Gram matrix with the norms on the diagonal.

    Without it the search for short vectors is as long as the coefficients are large.
    """
    import flint

    gram = [[trace(c, multiply(c, u, conjugate(c, v))) / 2 for v in basis] for u in basis]
    m = math.lcm(*(x.denominator for row in gram for x in row))
    scaled = flint.fmpz_mat([[int(x * m) for x in row] for row in gram])
    _, steps = scaled.lll(transform=True, rep="gram", gram="exact")
    short = []
    for row in steps.tolist():
        w, x, y, z = (
            sum((int(k) * u[i] for k, u in zip(row, basis, strict=True)), Fraction(0))
            for i in range(4)
        )
        short.append((w, x, y, z))
    return short, [[trace(c, multiply(c, u, conjugate(c, v))) / 2 for v in short] for u in short]


def lipschitz_order(c: Constants) -> Order:
    """Return the integer combinations of e, i, j, k.

    Raises :class:`CoercionError` unless a, t and b are integers.
    """
    constants = rational_constants(c)
    if any(x.denominator != 1 for x in constants):
        raise CoercionError(
            "e, i, j, k span an order over the integers only if a, t and b are integers"
        )
    return Order(constants, _unit_basis())


def hurwitz_order(c: Constants) -> Order:
    """Return ``ℤ⟨e, i, j, (e + i + j + k)/2⟩``, which is an order for (−1, −1 | ℚ) and like constants.

    Raises :class:`CoercionError` where it is none.
    """
    h = Fraction(1, 2)
    e, i, j, _ = _unit_basis()
    order = Order(rational_constants(c), (e, i, j, (h, h, h, h)))
    if not order.is_order:
        raise CoercionError(
            "ℤ⟨e, i, j, (e+i+j+k)/2⟩ is no order here: the Hurwitz order belongs to (-1,-1|QQ)"
        )
    return order


def maximal_order(c: Constants) -> Order:
    """Return a maximal order; its reduced discriminant is the product of the ramified primes.

    Raises :class:`CoercionError` for a degenerate algebra and :class:`UndecidedError` when its
    discriminant is too hard to factor.
    """
    constants = rational_constants(c)
    a, t, b = constants
    square = a + t * t / 4
    zero, one = Fraction(0), Fraction(1)
    # the norm on the elements of trace 0, over i − t/2, j and their product
    conic = Conic((-square, -b, square * b, zero, zero, zero), zero, one)
    lattice = Lattice(conic.start().basis, one)
    half = half_discriminant(conic.form)
    primes: set[int] = {2}
    for x in (square, b, half):
        primes |= set(factorise(x.numerator)) | set(factorise(x.denominator))
    for p in sorted(primes):
        minimise(conic, lattice, PrimePlace(p))
    u, v, w = (_pure(t, vector) for vector in lattice.basis)
    s = -lattice.scale
    products = (multiply(constants, p, q) for p, q in ((v, w), (w, u), (u, v)))
    rows = [_unit_basis()[0], *(tuple(s * x for x in q) for q in products)]
    e, i, j, k = _reduced([list(row) for row in rows])
    order = Order(constants, (e, i, j, k))
    if not order.is_order:
        raise AssertionError("the even Clifford algebra of an integral form is an order")
    return order


def _pure(t: Fraction, v: Sequence[Fraction]) -> Coordinates:
    """Return coordinates over e, i, j, k from those over i − t/2, j and (i − t/2)j."""
    x, y, z = v
    return -t / 2 * x, x, y - t / 2 * z, z


def _unit_basis() -> tuple[Vector, Vector, Vector, Vector]:
    o, e = Fraction(0), Fraction(1)
    return (e, o, o, o), (o, e, o, o), (o, o, e, o), (o, o, o, e)


def _reduced(rows: list[list[Fraction]]) -> list[Vector]:
    """Return the Hermite basis of a rational lattice, the last coordinates cleared first."""
    import flint

    m = math.lcm(*(x.denominator for row in rows for x in row))
    n = len(rows)
    matrix = flint.fmpz_mat(n, 4, [int(x * m) for row in rows for x in reversed(row)])
    hermite = [[Fraction(int(x), m) for x in reversed(row)] for row in matrix.hnf().tolist()]
    return [(r[0], r[1], r[2], r[3]) for r in reversed(hermite) if any(r)]


def _solve(matrix: list[list[Fraction]], target: list[Fraction]) -> list[Fraction]:
    """Solve a regular rational system."""
    n = len(matrix)
    rows = [[*row, x] for row, x in zip(matrix, target, strict=True)]
    for column in range(n):
        pivot = next(i for i in range(column, n) if rows[i][column])
        rows[column], rows[pivot] = rows[pivot], rows[column]
        rows[column] = [x / rows[column][column] for x in rows[column]]
        for i in range(n):
            if i != column and rows[i][column]:
                factor = rows[i][column]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[column], strict=True)]
    return [row[n] for row in rows]


def _determinant(matrix: list[list[Fraction]]) -> Fraction:
    if len(matrix) == 1:
        return matrix[0][0]
    minors = ([row[:i] + row[i + 1 :] for row in matrix[1:]] for i in range(len(matrix)))
    return sum(
        (
            (-1) ** i * x * _determinant(m)
            for i, (x, m) in enumerate(zip(matrix[0], minors, strict=True))
        ),
        Fraction(0),
    )


def _vectors_of_length(gram: list[list[Fraction]], length: Fraction) -> Iterator[list[int]]:
    """Run through the integer vectors v with ``v·gram·v = length``, for a positive definite matrix."""
    n = len(gram)
    # gram = Σ d[i]·(x[i] + Σ m[i][j]·x[j], j > i)²
    rest = [list(row) for row in gram]
    d: list[Fraction] = []
    m: list[list[Fraction]] = []
    for i in range(n):
        d.append(rest[i][i])
        m.append([rest[i][j] / rest[i][i] for j in range(n)])
        for r in range(i + 1, n):
            for s in range(i + 1, n):
                rest[r][s] -= d[i] * m[i][r] * m[i][s]

    def search(i: int, tail: list[int], left: Fraction) -> Iterator[list[int]]:
        if i < 0:
            if left == 0:
                yield tail
            return
        centre = -sum((m[i][i + 1 + k] * x for k, x in enumerate(tail)), Fraction(0))
        bound = left / d[i]
        radius = math.isqrt(math.floor(bound)) + 1
        for x in range(math.ceil(centre - radius), math.floor(centre + radius) + 1):
            used = d[i] * (x - centre) ** 2
            if used <= left:
                yield from search(i - 1, [x, *tail], left - used)

    yield from search(n - 1, [], length)


__all__ = ["Order", "hurwitz_order", "lipschitz_order", "maximal_order", "norm"]
