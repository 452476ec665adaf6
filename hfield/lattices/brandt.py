"""Brandt matrices: by neighbours at primes and the relations of the Hecke algebra, or by theta series."""

from __future__ import annotations

from typing import TYPE_CHECKING

from flint import fmpz_mat

from hfield.factorisation import factorise

if TYPE_CHECKING:
    from hfield.lattices.classes import ClassSet

Matrix = list[list[int]]


def brandt_matrix(classes: ClassSet, n: int) -> Matrix:
    """Return the Brandt matrix of n.

    At a prime it is made by neighbours; ``B(pᵏ⁺¹) = B(p)·B(pᵏ) − p·B(pᵏ⁻¹)`` off the discriminant (Voight,
    41.2), without the last term where the algebra ramifies; theta series answer at the other primes.
    """
    factors = []
    for p, e in factorise(n).items():
        if e > 1 and classes.order.level % p == 0:
            factors.append(fmpz_mat(by_theta_series(classes, p**e)))
        else:
            factors.append(_prime_power(classes, p, e))
    if not factors:
        factors.append(_identity(classes))
    product = factors[0]
    for factor in factors[1:]:
        product = product * factor
    return [[int(x) for x in row] for row in product.tolist()]


def _identity(classes: ClassSet) -> fmpz_mat:
    h = range(len(classes))
    return fmpz_mat([[int(i == j) for j in h] for i in h])


def _prime_power(classes: ClassSet, p: int, e: int) -> fmpz_mat:
    h = range(len(classes))
    step = fmpz_mat([[row[j] for j in h] for row in classes.neighbours(p)])
    if e == 1:
        return step
    before, current = _identity(classes), step
    weight = p if classes.order._discriminant % p else 0
    for _ in range(e - 1):
        before, current = current, step * current - before * weight
    return current


def by_theta_series(classes: ClassSet, n: int) -> Matrix:
    """Return the Brandt matrix by counting vectors of norm n between all pairs of classes."""
    units = classes.unit_counts
    h = range(len(classes))
    return [[classes.theta_series(i, j, n)[n] // units[j] for j in h] for i in h]


def number_of_ideals(classes: ClassSet, n: int) -> int:
    """Return how many integral right ideals of norm n, prime to the level, an Eichler order has."""
    found = 1
    for p, e in factorise(n).items():
        found *= sum(p**k for k in range(e + 1)) if classes.order._regular.discriminant % p else 1
    return found


__all__ = ["brandt_matrix", "by_theta_series", "number_of_ideals"]
