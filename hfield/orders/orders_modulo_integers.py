"""Orders over ℤ modulo N as matrices: O/NO ≅ M₂(ℤ/N) for N prime to the discriminant.

Modulo a prime power in N there are an idempotent e and a v in (1 − e)·O·e with O·e = ℤ·e + ℤ·v. Elements act
on this module from the left, and x·e = a·e + c·v and x·v = b·e + d·v give the matrix of x. The coefficients
a, c, b and d are those of e·x·e, (1 − e)·x·e, e·x·v and (1 − e)·x·v. The Chinese remainder theorem combines
the prime powers.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import count
from typing import TYPE_CHECKING

from flint import fmpq, fmpq_mat, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.factorisation import Factors, factorise, known_primes
from hfield.errors import LatticeError, shorten
from hfield.fields.rationals.whole_numbers import crt, fraction
from hfield.orders import hermite
from hfield.orders.lattice_values import LatticeValue, coordinates, discriminant
from hfield.orders.orders_at_primes import OrderAtPrime
from hfield.orders.validation import integer, positive

if TYPE_CHECKING:
    from hfield.orders.lattice import Ideal, Order

Matrix = tuple[tuple[int, int], tuple[int, int]]
Table = list[list[int]]
"""The matrices of a basis of the order: four rows (a, b, c, d)."""


def matrices_of_basis(order: LatticeValue, modulus: int) -> Table:
    """Return the matrices of a basis of an order modulo N. Raises :class:`UnfactoredError`."""
    if modulus == 1:
        return [[int(m == n) for n in range(4)] for m in range(4)]
    tables = [
        (_modulo_prime_power(order, p, e), p**e) for p, e in sorted(factorise(modulus).items())
    ]
    return [[crt((table[m][n], q) for table, q in tables)[0] for n in range(4)] for m in range(4)]


def _modulo_prime_power(order: LatticeValue, p: int, k: int) -> Table:
    """Return the same modulo pᵏ."""
    at, times, q = OrderAtPrime(order, p), order.ambient.times, p**k
    e = at.idempotent(k)
    _, below = at.corners(e)
    # one of (1 − e)·b·e generates (1 − e)·O·e at p
    inverse = order.inverse_rows
    v = next(
        row
        for row in map(_one_row, below.tolist())
        if any(int(c.p) % p for c in (row * inverse).entries())
    )
    f = order.ambient.row(1) - e
    images = {"e": order.rows * times(e), "v": order.rows * times(v)}

    def coefficients(part: fmpq_mat, images: fmpq_mat, unit: fmpq_mat) -> list[int]:
        """Return, for each image x, the coefficient c with part·x = c·unit modulo pᵏ."""
        whole = [int(c.p) for c in (unit * inverse).entries()]
        place = next(n for n, c in enumerate(whole) if c % p)
        factor = pow(whole[place], -1, q)
        rows = (images * times(part, "left") * inverse).tolist()
        return [int(row[place].p) * factor % q for row in rows]

    columns = (
        coefficients(e, images["e"], e),
        coefficients(e, images["v"], e),
        coefficients(f, images["e"], v),
        coefficients(f, images["v"], v),
    )
    return [list(row) for row in zip(*columns, strict=True)]


def _one_row(entries: Sequence[fmpq]) -> fmpq_mat:
    return fmpq_mat([list(entries)])


class ResidueMatrices:
    """An isomorphism of O/NO with M₂(ℤ/N): ``M(x)`` is the matrix of x, ``M.lift(m)`` an element with matrix
    m.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order(); M = O.modulo(35)
    >>> x, y = O.basis[0], O.basis[1]
    >>> (a, b), (c, d) = M(x)
    >>> (a * d - b * c - x.norm()) % 35, M(M.lift(M(y))) == M(y)
    (0, True)
    >>> I = M.ideal((2, 3)); I.norm(), M.kernel(I)
    (35, (1, 19))
    """

    def __init__(self, order: Order, modulus: object, factors: Factors | None = None) -> None:
        self.order, self.modulus = order, positive(modulus, "modulus")
        common = math.gcd(self.modulus, int(fraction(discriminant(order.value))))
        if common > 1:
            raise LatticeError(
                f"the modulus {shorten(self.modulus)} and the discriminant of the order have the factor "
                f"{shorten(common)} in common: expected a modulus prime to the discriminant"
            )
        with known_primes(factors):
            table = matrices_of_basis(order.value, self.modulus)
        self._table = fmpz_mat(table)
        whole, den = hermite.inverse(self._table)
        inverse = pow(den, -1, self.modulus)
        self._inverse = fmpz_mat(
            [[int(x) * inverse % self.modulus for x in row] for row in whole.tolist()]
        )

    def __repr__(self) -> str:
        return f"isomorphism O/{self.modulus}O → M₂(ℤ/{self.modulus}), O the order {shorten(self.order)}"

    def __reduce__(self) -> tuple[object, ...]:
        return ResidueMatrices, (self.order, self.modulus, list(factorise(self.modulus)))

    def __call__(self, x: object) -> Matrix:
        """Return the matrix of an element, with entries from 0 to N − 1.

        Denominators prime to N are inverted. Raises :class:`LatticeError` for other elements.
        """
        n = self.modulus
        rows, den = fmpq_mat([list(coordinates(self.order.value, x))]).numer_denom()
        if math.gcd(int(den), n) > 1:
            raise LatticeError(
                f"{shorten(x)} does not lie in the order, and the denominator {shorten(int(den))} of its "
                f"coordinates is not prime to {shorten(n)}"
            )
        factor = pow(int(den), -1, n)
        a, b, c, d = (int(entry) * factor % n for entry in (rows * self._table).entries())
        return (a, b), (c, d)

    def lift(self, matrix: Iterable[Iterable[object]]) -> Quaternion:
        """Return the element of the order with a given matrix; its coordinates are at most N/2 in absolute
        value.

        Raises :class:`LatticeError` unless the argument is a 2 × 2 matrix of integers.
        """
        rows = [list(row) for row in matrix]
        if [len(row) for row in rows] != [2, 2]:
            raise LatticeError("expected a 2 × 2 matrix, such as ((1, 0), (0, 1))")
        entries = [integer(x, "entry") % self.modulus for row in rows for x in row]
        n = self.modulus
        found = (fmpz_mat([entries]) * self._inverse).entries()
        centred = ((int(c) + n // 2) % n - n // 2 for c in found)
        value = self.order.value
        return value.element(hermite.combination(list(centred), value.matrix))

    def ideal(self, v: Iterable[object]) -> Ideal:
        """Return the left ideal of all x in the order with M(x)·v = 0 modulo N, of norm N.

        v must be primitive modulo N: no prime factor of N divides both entries. Raises :class:`LatticeError`.
        """
        entries = [integer(x, "entry") for x in v]
        if len(entries) != 2:
            raise LatticeError(f"expected a vector with 2 entries, and {len(entries)} were given")
        x, y = entries
        common = math.gcd(x, y, self.modulus)
        if common > 1:
            raise LatticeError(
                f"the vector ({shorten(x)}, {shorten(y)}) is not primitive modulo {shorten(self.modulus)}: "
                f"{shorten(common)} divides both entries"
            )
        return self.order.left_ideal([self.modulus, self.lift([[y, -x], [0, 0]])])

    def kernel(self, ideal: Ideal) -> tuple[int, int]:
        """Return a primitive v with M(x)·v = 0 modulo N for all x in a left ideal, unique up to units.

        The ideal and N·O must generate an ideal of norm N with a cyclic quotient. Raises
        :class:`LatticeError` for another ideal.
        """
        n, value = self.modulus, self.order.value
        if getattr(ideal, "side", "right") == "right" or ideal.order != self.order:
            raise LatticeError(
                f"{shorten(repr(ideal))} is not a left ideal of the order of this isomorphism"
            )
        if not ideal.is_integral():
            raise LatticeError("this ideal does not lie in its order: expected an integral ideal")
        inside, den = (ideal.value.rows * value.inverse_rows).numer_denom()
        if den != 1:
            raise AssertionError("an integral ideal has integral coordinates")
        entries = (inside * self._table).entries()
        rows = fmpz_mat(len(entries) // 2, 2, entries)
        spanned = hermite.stacked(rows, fmpz_mat([[n, 0], [0, n]])).hnf()
        a, b, d = int(spanned[0, 0]), int(spanned[0, 1]), int(spanned[1, 1])
        if a * d != n or math.gcd(a, b, d) > 1:
            raise LatticeError(
                f"the ideal and {shorten(n)}·O generate no ideal of norm {shorten(n)} with a cyclic "
                "quotient: its kernel is not a line"
            )
        # the rows (a, b), (0, d) kill (d, 0) and (−b, a)
        found = next(((s * d - b) % n, a) for s in count() if math.gcd(s * d - b, a) == 1)
        return _normalised(*found, n)


def _normalised(x: int, y: int, n: int) -> tuple[int, int]:
    """Return a multiple of a vector by a unit, with first or second entry 1 if possible."""
    if math.gcd(x, n) == 1:
        return 1 % n, y * pow(x, -1, n) % n
    if math.gcd(y, n) == 1:
        return x * pow(y, -1, n) % n, 1
    return x % n, y % n
