"""Lattices and orders over the integers of a number field, made of what a user gives."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import flint

from hfield.errors import LatticeError, shorten
from hfield.fields.number_fields.ideals import Ideal
from hfield.orders.basis import AlgebraBasis, basis_of
from hfield.orders.checked_arguments import listed
from hfield.orders.lattice_values import (
    LatticeValue,
    contains,
    discriminant,
    hermite_form,
    of_rows,
    spanned,
    spanning_rows,
)
from hfield.orders.over_integers import local_orders


def order_of_basis(algebra: Any, elements: Iterable[object]) -> LatticeValue:
    """Return the order that elements, or pairs (ideal, element), span over ℤ_K.

    Raises :class:`LatticeError` unless they span a ring with 1; the message names a product that is missing.
    """
    return checked_ring(spanned(algebra, elements))


def checked_ring(lattice: LatticeValue) -> LatticeValue:
    """Return a lattice as an order. Raises :class:`LatticeError` unless it is a ring with 1."""
    if not contains(lattice, 1):
        raise LatticeError("this lattice is no order: 1 is not in it")
    for q, row in zip(lattice.basis, lattice.rows.tolist(), strict=True):
        products = lattice.rows * lattice.ambient.times(row) * lattice.inverse_rows
        for p, found in zip(lattice.basis, products.tolist(), strict=True):
            if any(c.q != 1 for c in found):
                raise LatticeError(
                    f"this lattice is no order: the product of {shorten(p)} and {shorten(q)} is not in "
                    "it; A.order(elements) returns the ring that they generate"
                )
    return lattice


def generated(algebra: Any, elements: Iterable[object]) -> LatticeValue:
    """Return the ℤ_K-algebra that elements generate.

    Raises :class:`LatticeError` where its rank is below 4, or where it has elements that are not integral.
    """
    ambient, given = basis_of(algebra), listed(elements)
    for x in given:
        _check_integral(ambient, ambient.row(x))
    letters = [ambient.times(ambient.row(x)) for x in given]
    den, rows = spanning_rows(ambient, [1, *given])
    span = _reduced((rows * flint.fmpq(1, den)).tolist())
    for _ in range(3):  # words of three letters span the algebra over K, if any do
        longer = [row for m in letters for row in (span * m).tolist()]
        span = _reduced([*span.tolist(), *longer])
    if span.nrows() < ambient.size:
        raise LatticeError(
            f"these elements generate a ring of rank {span.nrows() // ambient.degree} over the integers, and "
            "orders have rank 4: give elements of no smaller algebra, such as two that do not commute"
        )
    while True:
        for row in span.tolist():
            _check_integral(ambient, flint.fmpq_mat([row]))
        longer = [row for m in letters for row in (span * m).tolist()]
        wider = _reduced([*span.tolist(), *longer])
        if wider == span:
            return of_rows(ambient, span)
        span = wider


def _reduced(rows: list[list[flint.fmpq]]) -> flint.fmpq_mat:
    """Return the rows other than 0 of the Hermite normal form."""
    whole, den = flint.fmpq_mat(rows).numer_denom()
    table = [row for row in whole.hnf().tolist() if any(row)]
    return flint.fmpq_mat(flint.fmpz_mat(table)) * flint.fmpq(1, int(den))


def _check_integral(ambient: AlgebraBasis, row: flint.fmpq_mat) -> None:
    """Raise :class:`LatticeError` unless an element has an integral trace and norm."""
    if not ambient.is_integral(row.entries()):
        q = ambient.quaternion(row.entries())
        raise LatticeError(
            f"these elements generate no order: {shorten(q)} has trace {q.trace()} and norm {q.norm()}, "
            "which are not both integers of the field"
        )


def maximal_order(algebra: Any) -> LatticeValue:
    """Return a maximal order over the integers of a number field, always the same.

    Raises :class:`LatticeError` for a degenerate algebra, :class:`UnfactoredError` where a norm or the
    discriminant of the field is too hard to factor, :class:`TooLargeError` at primes of 64 bits and more.
    """
    ambient = basis_of(algebra)
    start = hermite_form(ambient, 1, ambient.identity)
    found = local_orders.maximal(start, discriminant(start) / ambient.discriminant)
    if discriminant(found) != ambient.discriminant:
        raise AssertionError("a maximal order has the discriminant of its algebra")
    return found


def eichler_order(algebra: Any, level: object) -> LatticeValue:
    """Return an Eichler order of a level prime to the discriminant of the algebra, always the same.

    The level is a number, an ideal, or pairs (prime ideal, exponent). Raises :class:`LatticeError`.
    """
    ambient = basis_of(algebra)
    ideal = read_level(ambient, level)
    common = [P for P, _ in ideal.factorisation() if ambient.base.prime(P) in ambient.ramified]
    if common:
        raise LatticeError(
            f"the level {ideal} and the discriminant of {shorten(algebra)} have the prime {common[0]} in "
            "common: Eichler orders have a level prime to the discriminant"
        )
    return local_orders.eichler(maximal_order(algebra), ideal)


def read_level(ambient: AlgebraBasis, level: object) -> Ideal:
    """Return an integral ideal, given as a number, an ideal or pairs. Raises :class:`LatticeError`."""
    if isinstance(level, list | tuple) and all(isinstance(x, tuple | list) for x in level):
        ideal: Ideal = ambient.base.ideal(1)
        for pair in level:
            if len(pair) != 2 or not isinstance(pair[1], int) or pair[1] < 0:
                raise LatticeError(
                    f"{shorten(pair)} is no pair of a prime ideal and an exponent ≥ 0"
                )
            ideal = ideal * ambient.base.prime_ideal(ambient.base.prime(pair[0])) ** pair[1]
        return ideal
    ideal = ambient.base.ideal(level)
    if not ideal.is_integral():
        raise LatticeError(f"the level {ideal} is no ideal of integers")
    return ideal
