"""Invertible right ideals of prime norm, in an order over the integers of a number field or in its ideals.

A right ideal of relative norm P in I = y·O_P is y·K + P·I, for a right ideal K of O of norm P. K contains
P·O, and is x·O + P·O for an x in O with a norm of valuation 1: in M₂(ℤ_P) for the lines of a plane, in an
Eichler order for those in two columns and, of level P, the radical (Voight, *Quaternion Algebras*, 26.3).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.errors import LatticeError, TooLargeError
from hfield.orders.invariants import eichler_symbol
from hfield.orders.lattice_values import LatticeValue, add_elements, add_rows, discriminant
from hfield.orders.orders_at_primes import Local, Rows

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement

MOST = 10**5
"""No more ideals of one norm than this are listed."""


def generators(local: Local, order: LatticeValue) -> list[Rows]:
    """Return what generates the right ideals K of norm P with P·O. Raises :class:`TooLargeError`."""
    exponent = order.ambient.base.valuation(discriminant(order), local.prime)
    if local.prime.norm() > MOST:
        raise TooLargeError(f"there are too many ideals of norm {local.prime} to list them")
    if not exponent or eichler_symbol(order, local.prime) == 1:
        return _split(local, order, exponent)
    radical, below = local.radical(order), local.times_prime(order)
    if exponent == 1:  # ramified, of one maximal ideal
        return [local.independent(radical.rows, below)]
    return _in_radical(local, order, local.independent(radical.rows, below), below)


def random_generators(local: Local, order: LatticeValue, rng: Random) -> Rows:
    """Return those of one ideal of norm P, any with the same chance; the order is M₂(ℤ_P)."""
    e, u, v = _matrix_units(local, order)
    if not rng.randrange(local.prime.norm() + 1):
        return [v.entries(), (v * local.ambient.times(u.entries())).entries()]
    digits = [rng.randrange(local.p) for _ in range(local.prime.f)]
    return _line(local, e, v, u, local.lift(flint.nmod_poly(digits, local.p)))


def _split(local: Local, order: LatticeValue, exponent: int) -> list[Rows]:
    """Return those of M₂(ℤ_P), or of an Eichler order of level Pᵏ, k the exponent, through matrix units."""
    ambient = local.ambient
    e, u, v = _matrix_units(local, order)
    found = [_line(local, e, v, u, c) for c in local.representatives]
    if exponent == 0:
        return [*found, [v.entries(), (v * ambient.times(u.entries())).entries()]]
    found += [_line(local, ambient.row(1) - e, u, v, c) for c in local.representatives]
    return [*found, [u.entries(), v.entries()]] if exponent == 1 else found


def _matrix_units(
    local: Local, order: LatticeValue
) -> tuple[flint.fmpq_mat, flint.fmpq_mat, flint.fmpq_mat]:
    """Return an idempotent e modulo P, and u in e·O·(1 − e) and v in (1 − e)·O·e, not in P·O."""
    e = local.idempotent(order, 1)
    inverse = local.times_prime(order).inverse_rows

    def outside(elements: flint.fmpq_mat) -> flint.fmpq_mat:
        inside = (elements * inverse).tolist()
        k = next(k for k, row in enumerate(inside) if any(c.q != 1 for c in row))
        return flint.fmpq_mat([elements.tolist()[k]])

    first, second = local.corners(order, e)
    return e, outside(first), outside(second)


def _line(
    local: Local, e: flint.fmpq_mat, v: flint.fmpq_mat, u: flint.fmpq_mat, c: FieldElement
) -> Rows:
    """Return generators of (e + c·v)·O, where e is idempotent and v·e = v."""
    x = e + v * local.ambient.scalar(c)
    return [x.entries(), (x * local.ambient.times(u.entries())).entries()]


def _in_radical(local: Local, order: LatticeValue, basis: Rows, below: LatticeValue) -> list[Rows]:
    """Return those x·O + P·O with x in the radical, a basis of which modulo P·O is given, one by one."""
    ambient = local.ambient
    found: dict[LatticeValue, Rows] = {}
    if local.prime.norm() ** (len(basis) - 1) > MOST:
        raise TooLargeError(f"there are too many candidates for ideals of norm {local.prime}")
    vectors = [flint.fmpq_mat([row]) for row in basis]
    prime = ambient.base.prime_ideal(local.prime)
    for k, first in enumerate(vectors):
        for digits in product(local.representatives, repeat=len(vectors) - k - 1):
            x = first
            for c, v in zip(digits, vectors[k + 1 :], strict=True):
                x = x + v * ambient.scalar(c)
            ideal = add_rows(below, order.rows * ambient.times(x, "left"))
            if ideal.norm == prime and ideal.volume == order.volume * prime * prime:
                found.setdefault(ideal, local.independent(ideal.rows, below))
    return list(found.values())


def subideals(local: Local, ideal: LatticeValue, found: list[Rows]) -> Iterator[LatticeValue]:
    """Yield the right ideals of relative norm P in an invertible one; ``found`` are those of its order."""
    moved = local.ambient.times(local_generator(local, ideal), "left")
    below = local.times_prime(ideal)
    for pair in found:
        yield add_elements(below, flint.fmpq_mat(pair) * moved)


def coordinates_of_subideals(
    local: Local, spans: list[flint.fmpq_mat], ideal: LatticeValue
) -> Iterator[flint.fmpz_mat]:
    """Yield the same in coordinates of the ideal; ``spans`` are the elements found, with their multiples."""
    ambient, inverse = local.ambient, ideal.inverse_rows
    y = ambient.times(local_generator(local, ideal), "left") * inverse
    below = (local.times_prime(ideal).rows * inverse).numer_denom()[0].tolist()
    for span in spans:
        whole = flint.fmpz_mat([*(span * y).numer_denom()[0].tolist(), *below]).hnf()
        yield flint.fmpz_mat(ambient.size, ambient.size, whole.entries()[: ambient.size**2])


def local_generator(local: Local, ideal: LatticeValue) -> flint.fmpq_mat:
    """Return an element that generates an invertible ideal at P: its norm is that of the ideal there."""
    ambient, rows = local.ambient, ideal.rows.tolist()
    least = ideal.norm.valuation(local.prime)
    sums = (
        [c + d for c, d in zip(x, y, strict=True)] for k, x in enumerate(rows) for y in rows[:k]
    )
    for row in (*rows, *sums):
        norm = ambient.norm(row)
        if norm and local.prime.valuation(norm) == least:
            return flint.fmpq_mat([row])
    raise LatticeError("the norms of a lattice are generated by those of a basis and its sums")
