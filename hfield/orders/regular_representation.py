"""The regular representations of an algebra over ℚ as integer matrices: what lattices multiply with.

An element is a row of four integers over a denominator; ``q ↦ e·q`` and ``q ↦ q·e`` for the four basis
elements are matrices that act on such rows from the right. They are found with the one formula of
:mod:`hfield.product`, so any constants (a, t, b) serve, fractions too.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from typing import TYPE_CHECKING, Any

from flint import fmpq_mat, fmpz, fmpz_mat

from hfield.errors import RingError
from hfield.fields.rationals.places import INFINITE
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.orders.hermite import integral
from hfield.product import Constants, conjugate, multiply, trace
from hfield.rings.integers import QQ
from hfield.rings.rational import fmpq
from hfield.rings.whole_numbers import fraction
from hfield.structure.forms import discriminant

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Parent


UNITS: list[Any] = [tuple(fmpq(int(m == n)) for n in range(4)) for m in range(4)]
PAIRS = list(combinations(range(4), 2))


class Regular:
    """Multiplication, conjugation and trace form of ``i² = a + t·i, j² = b`` on integer rows.

    Products are returned ``scale`` times too large, so that they are integral; so is ``form``, the
    matrix of ``tr(x·conj(y))``. ``conjugation`` is ``conjugate_scale`` times too large.
    """

    def __init__(self, constants: Constants) -> None:
        self.constants = constants
        c = Constants(*map(fmpq, constants))
        left = [[multiply(c, u, v) for v in UNITS] for u in UNITS]
        form = [[trace(c, multiply(c, u, conjugate(c, v))) for v in UNITS] for u in UNITS]
        self.scale = math.lcm(
            *(int(x.denominator) for row in left for q in row for x in q),
            *(int(x.denominator) for row in form for x in row),
        )

        def whole(rows: Iterable[Iterable[Any]]) -> fmpz_mat:
            return fmpz_mat([[(x * self.scale).numerator for x in row] for row in rows])

        self.left = [whole(row) for row in left]
        self.right = [whole(column) for column in zip(*left, strict=True)]
        # the coordinates of a product, one after the other, as bilinear forms
        self._coordinates = [whole((q[c] for q in row) for row in left) for c in range(4)]
        self.form = whole(form)
        self._squares = [
            (m, n, self.form[m, n] // (2 if m == n else 1))
            for m in range(4)
            for n in range(m, 4)
            if self.form[m, n]
        ]
        self.conjugate_scale, bars = integral(conjugate(c, u) for u in UNITS)
        self.conjugation = fmpz_mat(bars)
        self._norms = {
            "left": [form * self.conjugation.transpose() for form in self._coordinates],
            "right": [self.conjugation * form for form in self._coordinates],
        }
        a, t, b = constants
        self.square = a + t * t / 4
        """The square of i − t/2, which anticommutes with j."""
        self.definite = self.square < 0 and b < 0
        self.majorant = self.form if self.definite else self._majorant()

    def _majorant(self) -> fmpz_mat:
        """Return a positive definite integral form that the norm does not exceed, up to a scale."""
        h, s, b = (fmpq(x) for x in (self.constants.t / 2, abs(self.square), abs(self.constants.b)))
        # over 1, i − t/2, j and their product the norm is diagonal
        rows = fmpq_mat([[1, h, 0, 0], [0, 1, 0, 0], [0, 0, 1, h], [0, 0, 0, 1]])
        norms = fmpq_mat([[1, 0, 0, 0], [0, s, 0, 0], [0, 0, b, 0], [0, 0, 0, s * b]])
        form, _ = (rows.transpose() * norms * rows).numer_denom()
        return form

    def products(self, rows: fmpz_mat, others: fmpz_mat) -> fmpz_mat:
        """Return the products of all rows with all others, one a row, ``scale`` times too large."""
        columns = others.transpose()
        found = zip(*((rows * form * columns).entries() for form in self._coordinates), strict=True)
        return fmpz_mat(rows.nrows() * others.nrows(), 4, [x for row in found for x in row])

    def norm_products(self, rows: fmpz_mat, side: str) -> fmpz_mat:
        """Return the products ``x·conj(y)`` of the six pairs of four rows, ``conj(x)·y`` on the right.

        They are ``scale·conjugate_scale`` times too large.
        """
        columns = rows.transpose()
        found = [rows * form * columns for form in self._norms[side]]
        return fmpz_mat(6, 4, [m[pair] for pair in PAIRS for m in found])

    def left_matrix(self, row: Sequence[int]) -> fmpz_mat:
        """Return the matrix of ``q ↦ x·q`` for an integer row x, ``scale`` times too large."""
        return _combined(self.left, row)

    def right_matrix(self, row: Sequence[int]) -> fmpz_mat:
        """Return the matrix of ``q ↦ q·x`` for an integer row x, ``scale`` times too large."""
        return _combined(self.right, row)

    def norm(self, row: Sequence[fmpz | int]) -> fmpz:
        """Return the norm of a row of flint integers, ``scale`` times too large."""
        return sum(c * row[m] * row[n] for m, n, c in self._squares)

    def gram(self, rows: fmpz_mat) -> fmpz_mat:
        """Return the matrix of ``tr(x·conj(y))`` on the rows, ``scale`` times too large."""
        return rows * self.form * rows.transpose()

    @property
    def discriminant(self) -> int:
        """The reduced discriminant of the algebra, the product of the primes where it ramifies."""
        return math.prod(self.ramified)

    @property
    def ramified(self) -> tuple[int, ...]:
        """The primes where the algebra ramifies; the constants are factored for them."""
        return _ramified(self.constants)


def _combined(matrices: list[fmpz_mat], row: Sequence[int]) -> fmpz_mat:
    a, b, c, d = matrices
    w, x, y, z = row
    return a * w + b * x + c * y + d * z


@lru_cache(maxsize=256)
def _ramified(c: Constants) -> tuple[int, ...]:
    return tuple(int(p) for p in ramified_places_q(c.a + c.t * c.t / 4, c.b) if p != INFINITE)


@lru_cache(maxsize=256)
def _regular(a: Fraction, t: Fraction, b: Fraction) -> Regular:
    return Regular(Constants(a, t, b))


def regular(algebra: Parent) -> Regular:
    """Return the representation of an algebra over ℚ.

    Raises :class:`RingError` for an algebra over another ring, or for a degenerate one.
    """
    found: Regular | None = vars(algebra).get("_regular")  # every lattice asks for it
    if found is None:
        found = vars(algebra)["_regular"] = _checked(algebra)
    return found


def _checked(algebra: Parent) -> Regular:
    if algebra.ring != QQ:
        raise RingError(
            "this belongs to lattices, orders and ideals in algebras over QQ (over other number fields: "
            f"A.lattice, A.order, A.eichler_order), and {algebra} is over {algebra.ring}"
        )
    a, t, b = (fraction(x) for x in algebra.constants)
    if not discriminant(algebra.ring, algebra.constants):
        raise RingError(
            f"{algebra} is a degenerate algebra, (t² + 4a)·b = 0: it is not simple, and has no orders here"
        )
    return _regular(a, t, b)
