"""The values of forms of weight k over ℚ, and the action of quaternions on them.

Let s be a common denominator of the constants of a definite algebra, X = s·(2i − t), Y = s·j and Z = X·Y.
These are a basis of the elements of trace 0. They anticommute; X² = α and Y² = β are integers, Z² = −αβ.
Conjugation by a quaternion preserves Z² − β·X² − α·Y², as a polynomial in three variables. So it acts on the
polynomials of degree m = k/2 − 1 modulo multiples of this one: on p(X, Y) + Z·q(X, Y), where p has degree m
and q degree m − 1. This representation of dimension k − 1 is irreducible, and isomorphic to that of the
harmonic polynomials of degree m. In weight 2 it is trivial.
"""

from collections.abc import Sequence
from math import gcd

from hfield.checker.budget import spend
from hfield.checker.number_fields.matrices import Row, Rows, longest, times
from hfield.checker.orders.algebra import Algebra
from hfield.checker.rejection import reject

MAX_WEIGHT = 100
Value = tuple[list[int], list[int]]
"""The coefficients of p and q, by the exponents of Y."""


class Values:
    """Polynomials of degree k/2 − 1 as rows of k − 1 coefficients, and the action of quaternions."""

    def __init__(self, algebra: Algebra, weight: int) -> None:
        if weight < 2 or weight % 2 or weight > MAX_WEIGHT:
            reject(f"newforms are checked in even weights from 2 to {MAX_WEIGHT}")
        if weight > 2 and algebra.n > 1:
            reject("newforms of weights above 2 are checked over QQ")
        self.algebra, self.degree, self.dimension = algebra, weight // 2 - 1, weight - 1

    def action(self, x: Row) -> tuple[Rows, int]:
        """Return the matrix by which an element acts on rows, times an integer, and this integer.

        The element is not 0. Rational multiples of an element act in the same way.
        """
        if not self.degree:
            return ((1,),), 1
        forms, scale = self._conjugation(x)
        m, bits = self.degree, longest([*forms, self._relation])
        spend(m**3 * (1 + m * bits // 1_000 + m * bits * bits // 500_000))
        pure: list[Value] = [([1], [])]
        """The images of Xⁿ, Xⁿ⁻¹·Y, …, Yⁿ."""
        for _ in range(1, m):
            pure = self._next(pure, forms)
        found = [*self._next(pure, forms), *(self._product(v, forms[2]) for v in pure)]
        return tuple((*p, *q) for p, q in found), scale**m

    def _next(self, pure: Sequence[Value], forms: Sequence[Row]) -> list[Value]:
        """Return the images of the monomials in X and Y of the next degree."""
        return [*(self._product(v, forms[0]) for v in pure), self._product(pure[-1], forms[1])]

    @property
    def _relation(self) -> Row:
        """The numbers α and β."""
        (first,), (second,) = self.algebra.signs
        return first, second * self.algebra.scale

    def _product(self, value: Value, form: Row) -> Value:
        """Return (p + Z·q)·(u·X + v·Y + w·Z)."""
        (p, q), (u, v, w) = value, form
        alpha, beta = self._relation
        square = [w * beta * c for c in q] + [0, 0]
        for n, c in enumerate(q, 2):
            square[n] += w * alpha * c
        first = [
            u * x + v * y + z
            for x, y, z in zip([*p, 0], [0, *p], square if q else [0, 0], strict=True)
        ]
        second = [u * x + v * y + w * z for x, y, z in zip([*q, 0], [0, *q], p, strict=True)]
        return first, second

    def _conjugation(self, x: Row) -> tuple[list[Row], int]:
        """Return the images of X, Y and Z under conjugation, times an integer, and this integer."""
        algebra = self.algebra
        s, t = algebra.scale, algebra.trace_of_i[0]
        bits = longest([x]) + algebra.bits
        spend(90 + bits * bits // 15_000)
        basis = [(s, 0, 0, 0), (-t, 2 * s, 0, 0), (0, 0, s, 0), (0, 0, -s * t, 2 * s * s)]
        moved = times(times(basis, algebra.left(x)), algebra.right(algebra.conjugate(x)))
        # z·k is z/(2s²)·(Z + s·t·Y)
        scale = 2 * s * moved[0][0]
        rows = [(s * b, 2 * s * c + t * d, d) for _, b, c, d in moved[1:]]
        common = gcd(scale, *(c for row in rows for c in row))
        return [tuple(c // common for c in row) for row in rows], scale // common
