"""Brandt matrices: by ideals of prime power norm, the relations of the Hecke algebra, or theta series."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from flint import fmpz_mat

from hfield.factorisation import factorise
from hfield.lattices.ideals_of_norm import MOST, number_maximal
from hfield.lattices.z_order import eichler_symbol

if TYPE_CHECKING:
    from hfield.lattices.classes import Classes

Matrix = list[list[int]]


def brandt_matrix(classes: Classes, n: int) -> Matrix:
    """Return the Brandt matrix of n.

    At a prime it is made by neighbours; ``B(pᵏ⁺¹) = B(p)·B(pᵏ) − p·B(pᵏ⁻¹)`` off the discriminant (Voight,
    41.2), without the last term where the algebra ramifies. At a prime of the level all ideals of norm pᵉ are
    listed where they are few, and theta series answer otherwise, and for orders of any other kind.
    """
    factors = []
    for p, e in factorise(n).items():
        if classes.ring.level % p == 0:
            if _few(classes, p, e):
                factors.append(_matrix(classes.power_neighbours(p, e)))
            else:
                factors.append(fmpz_mat(by_theta_series(classes, p**e)))
        else:
            factors.append(_prime_power(classes, p, e))
    if not factors:
        factors.append(_identity(classes))
    product = factors[0]
    for factor in factors[1:]:
        product = product * factor
    return [[int(x) for x in row] for row in product.tolist()]


def _few(classes: Classes, p: int, e: int) -> bool:
    """Tell whether it is quicker to list the ideals of norm pᵉ than to look between all pairs of classes."""
    if eichler_symbol(classes.ring, p) != 1:
        return False
    h, number = len(classes), number_maximal(p, e)
    # a theta series takes as long as some five intersections or classes looked up
    return number**2 <= MOST and number**2 + 6 * h * number <= 5 * h * h


def _identity(classes: Classes) -> fmpz_mat:
    h = range(len(classes))
    return fmpz_mat([[int(i == j) for j in h] for i in h])


def _matrix(rows: list[Counter[int]]) -> fmpz_mat:
    return fmpz_mat([[row[j] for j in range(len(rows))] for row in rows])


def _prime_power(classes: Classes, p: int, e: int) -> fmpz_mat:
    step = _matrix(classes.neighbours(p))
    if e == 1:
        return step
    before, current = _identity(classes), step
    weight = p if classes.ring.discriminant % p else 0
    for _ in range(e - 1):
        before, current = current, step * current - before * weight
    return current


def by_theta_series(classes: Classes, n: int) -> Matrix:
    """Return the Brandt matrix by counting vectors of norm n between all pairs of classes."""
    units = classes.unit_counts
    h = range(len(classes))
    return [[classes.theta_series(i, j, n)[n] // units[j] for j in h] for i in h]


def number_of_ideals(classes: Classes, n: int) -> int:
    """Return how many integral right ideals of norm n, prime to the level, an Eichler order has."""
    found = 1
    for p, e in factorise(n).items():
        found *= sum(p**k for k in range(e + 1)) if classes.ring.regular.discriminant % p else 1
    return found
