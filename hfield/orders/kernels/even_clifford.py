"""Maximal orders over ℤ from ternary forms, also at large primes.

A ternary lattice with an integral form gives an order, its even Clifford algebra, whose reduced discriminant
is the half-discriminant of the form (Voight, *Quaternion Algebras*, chapter 22). So a form that is minimal at
every prime gives a maximal order.
"""

from __future__ import annotations

from collections.abc import Sequence

import flint

from hfield.core.factorisation import factorise
from hfield.core.product import Constants, Coordinates, multiply
from hfield.fields.base.coercion import fmpq
from hfield.fields.quadratic_forms.minimal_conics import (
    Conic,
    ConicLattice,
    half_discriminant,
    minimise,
)
from hfield.fields.rationals.residues import PrimePlace
from hfield.fields.rationals.whole_numbers import fraction


def maximal_basis(c: Constants) -> list[Coordinates]:
    """Return a basis of a maximal order, over e, i, j, k, of a nondegenerate algebra.

    The constants are Fractions. Raises :class:`UndecidedError` if they cannot be factored.
    """
    c = Constants(*map(fmpq, c))  # quicker than Fractions
    a, t, b = c
    square = a + t * t / 4
    zero, one = fmpq(0), fmpq(1)
    # the norm on the elements of trace 0, over i − t/2, j and their product
    conic = Conic((-square, -b, square * b, zero, zero, zero), zero, one)
    lattice = ConicLattice(conic.start().basis, one)
    half = half_discriminant(conic.form)
    primes: set[int] = {2}
    for x in (square, b, half):
        primes |= set(factorise(int(x.numerator))) | set(factorise(int(x.denominator)))
    for p in sorted(primes):
        minimise(conic, lattice, PrimePlace(p, flint.fmpq))
    u, v, w = (_pure(t, vector) for vector in lattice.basis)
    s = -lattice.scale
    products = (multiply(c, p, q) for p, q in ((v, w), (w, u), (u, v)))
    scaled = [(s * q[0], s * q[1], s * q[2], s * q[3]) for q in products]
    basis = [(one, zero, zero, zero), *scaled]
    return [tuple(map(fraction, q)) for q in basis]  # type: ignore[misc]


def _pure(t: flint.fmpq, v: Sequence[flint.fmpq]) -> Coordinates:
    """Return coordinates over e, i, j, k from those over i − t/2, j and (i − t/2)j."""
    x, y, z = v
    return -t / 2 * x, x, y - t / 2 * z, z
