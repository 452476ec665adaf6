"""The orders of an algebra that have names: maximal, Eichler, p-extremal, Lipschitz and Hurwitz.

A ternary lattice with an integral form gives an order, its even Clifford algebra, whose reduced
discriminant is the half-discriminant of the form (Voight, *Quaternion Algebras*, chapter 22); so a maximal
order comes from a form minimised at every prime.

A p-extremal order has a small quadratic order and its orthogonal element of norm p: in
``(−q, −p | ℚ)`` with q = 1, 2 or a small prime, a maximal order that contains the ring of integers R of
ℚ(i) and ``R·j`` (Pizer, 1980, proposition 5.2; Kohel, Lauter, Petit and Tignol, 2014, section 2.3).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import flint
from flint import fmpz_mat

from hfield.algebra.quaternion import Parent
from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime
from hfield.core.product import Constants, Coordinates, multiply
from hfield.errors import CoercionError, LatticeError
from hfield.fields.rationals.residues import PrimePlace
from hfield.orders import class_number as class_numbers
from hfield.orders import hermite
from hfield.orders.basis import basis_of
from hfield.orders.lattice_values import hermite_form
from hfield.orders.linear_algebra_mod_p import kronecker
from hfield.orders.maximal_orders import eichler_suborder, overorder
from hfield.orders.rings import generated
from hfield.orders.validation import expect_coprime, positive
from hfield.orders.z_order import ZOrder
from hfield.rings.rational import fmpq
from hfield.rings.whole_numbers import fraction
from hfield.structure.minimal_conics import Conic, ConicLattice, half_discriminant, minimise


def maximal_order(algebra: Parent) -> ZOrder:
    """Return a maximal order, by minimising a ternary form; the same for the same algebra.

    Raises :class:`UndecidedError` when the constants are too hard to factor.
    """
    ambient = basis_of(algebra)
    constants = Constants(*map(fraction, ambient.constants))
    den, rows = hermite.integral(maximal_basis(constants))
    order = ZOrder.of(hermite_form(ambient, den, fmpz_mat(rows)))
    if order.level != 1:  # also remembers the primes, which the caller may have named
        raise AssertionError("the even Clifford algebra of a minimal form is maximal")
    return order


def eichler_order(algebra: Parent, level: object) -> ZOrder:
    """Return an Eichler order of the given level inside the maximal order.

    Raises :class:`LatticeError` unless the level is a positive integer prime to the discriminant.
    """
    n = positive(level, "level")
    known: Any = algebra
    order = _maximal(known)
    return order if n == 1 else eichler_suborder(order, n)


def lipschitz_order(algebra: Parent) -> ZOrder:
    """Return the integer combinations of e, i, j, k.

    Raises :class:`CoercionError` unless a, t and b are integers.
    """
    constants = Constants(*map(fraction, basis_of(algebra).constants))
    if any(x.denominator != 1 for x in constants):
        raise CoercionError(
            "e, i, j, k span an order over the integers only if a, t and b are integers"
        )
    return ZOrder(
        basis_of(algebra), 1, fmpz_mat([[int(m == n) for n in range(4)] for m in range(4)])
    )


def hurwitz_order(algebra: Parent) -> ZOrder:
    """Return the Hurwitz order. Raises :class:`CoercionError` except for (−1,−1|ℚ)."""
    if tuple(basis_of(algebra).constants) != (-1, 0, -1):
        raise CoercionError(f"the Hurwitz order belongs to (-1,-1|QQ), not to {algebra}")
    rows = [[1, 1, 1, 1], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 2]]
    return ZOrder(basis_of(algebra), 2, fmpz_mat(rows))


def class_number(algebra: Parent, level: object) -> int:
    """Return the number of ideal classes of an Eichler order of the given level."""
    n = positive(level, "level")
    r = basis_of(algebra)
    if r.definite:
        return class_numbers.class_number(r.discriminant, n)
    expect_coprime(n, r.discriminant)
    return 1  # strong approximation


@lru_cache(maxsize=64)
def _maximal(algebra: Parent) -> ZOrder:
    return maximal_order(algebra)


def maximal_basis(c: Constants) -> list[Coordinates]:
    """Return a basis of a maximal order, over e, i, j, k, of an algebra that is not degenerate.

    The constants are Fractions. Raises :class:`UndecidedError` when they are too hard to factor.
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


def _pure(t: Any, v: Sequence[Any]) -> Coordinates:
    """Return coordinates over e, i, j, k from those over i − t/2, j and (i − t/2)j."""
    x, y, z = v
    return -t / 2 * x, x, y - t / 2 * z, z


def quadratic_part(p: int) -> int:
    """Return q = 1, 2 or a prime 3 modulo 4 for which ``(−q, −p | ℚ)`` ramifies at p and ∞."""
    if p == 2 or p % 4 == 3:
        return 1
    if p % 8 == 5:
        return 2
    q = 3
    while not (is_prime(q) and kronecker(p, q) == -1):
        q += 4
    return q


def extremal_order(algebra: Parent) -> ZOrder:
    """Return a p-extremal maximal order of a definite algebra of prime discriminant p.

    Raises :class:`LatticeError` for another algebra.
    """
    r = basis_of(algebra)
    if not r.definite or len(r.ramified) != 1:
        raise LatticeError(
            f"{algebra} has no p-extremal order: expected a definite algebra of prime discriminant"
        )
    (p,) = r.ramified
    q = quadratic_part(p)
    i, j = _generators(algebra, q, p)
    w = (1 + i) / 2 if q % 4 == 3 else i
    return overorder(ZOrder.of(generated(algebra, [w, j])))


def _generators(algebra: Parent, q: int, p: int) -> tuple[Any, Any]:
    """Return anticommuting elements with squares −q and −p."""
    _, i, j, _ = algebra.basis
    if i * i == -q and j * j == -p and i * j == -(j * i):
        return i, j
    from hfield.structure import isomorphism

    ring = algebra.ring
    source = (ring(-q), ring(0), ring(-p))
    found = isomorphism(ring, type(algebra.constants)(*source), algebra.constants)
    if found is None:
        raise AssertionError("both ramify at p and infinity")
    return algebra(*found.images[1]), algebra(*found.images[2])
