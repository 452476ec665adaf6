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
from hfield.orders.over_integers.dedekind_modules import unique_rows
from hfield.orders.over_integers.local_orders import Local, Rows

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement

MOST = 10**5
"""No more ideals of one norm than this are listed."""


def generators(local: Local, rows: flint.fmpq_mat, exponent: int) -> list[Rows]:
    """Return elements that generate over the integers, with P·O, the right ideals K of norm P.

    The discriminant of the order has the given exponent at P. Raises :class:`TooLargeError`.
    """
    if local.prime.norm() > MOST:
        raise TooLargeError(f"there are too many ideals of norm {local.prime} to list them")
    if not exponent or local.symbol(rows) == 1:
        return _split(local, rows, exponent)
    radical, below = local.radical(rows), local.times_prime(rows)
    if exponent == 1:  # ramified, of one maximal ideal
        return [local.independent(radical, below)]
    return _in_radical(local, rows, local.independent(radical, below), below)


def random_generators(local: Local, rows: flint.fmpq_mat, rng: Random) -> Rows:
    """Return those of one ideal of norm P, but for one any with the same chance; the order is M₂(ℤ_P)."""
    e, u, v = _matrix_units(local, rows)
    digits = [rng.randrange(local.p) for _ in range(local.prime.f)]
    return _line(local, e, v, u, local.lift(flint.nmod_poly(digits, local.p)))


def _split(local: Local, rows: flint.fmpq_mat, exponent: int) -> list[Rows]:
    """Return those of M₂(ℤ_P), or of an Eichler order of level Pᵏ, k the exponent, through matrix units."""
    frame = local.frame
    e, u, v = _matrix_units(local, rows)
    found = [_line(local, e, v, u, c) for c in local.representatives]
    if exponent == 0:
        return [*found, [v.entries(), (v * frame.right(u.entries())).entries()]]
    found += [_line(local, frame.row(1) - e, u, v, c) for c in local.representatives]
    return [*found, [u.entries(), v.entries()]] if exponent == 1 else found


def _matrix_units(
    local: Local, rows: flint.fmpq_mat
) -> tuple[flint.fmpq_mat, flint.fmpq_mat, flint.fmpq_mat]:
    """Return an idempotent e modulo P, and u in e·O·(1 − e) and v in (1 − e)·O·e, not in P·O."""
    e = local.idempotent(rows, 1)
    inverse = local.times_prime(rows).inv()

    def outside(elements: flint.fmpq_mat) -> flint.fmpq_mat:
        inside = (elements * inverse).tolist()
        k = next(k for k, row in enumerate(inside) if any(c.q != 1 for c in row))
        return flint.fmpq_mat([elements.tolist()[k]])

    first, second = local.corners(rows, e)
    return e, outside(first), outside(second)


def _line(
    local: Local, e: flint.fmpq_mat, v: flint.fmpq_mat, u: flint.fmpq_mat, c: FieldElement
) -> Rows:
    """Return generators of (e + c·v)·O, where e is idempotent and v·e = v."""
    x = e + v * local.frame.scalar(c)
    return [x.entries(), (x * local.frame.right(u.entries())).entries()]


def _in_radical(
    local: Local, rows: flint.fmpq_mat, basis: Rows, below: flint.fmpq_mat
) -> list[Rows]:
    """Return those x·O + P·O with x in the radical, a basis of which modulo P·O is given, one by one."""
    frame = local.frame
    found: dict[str, Rows] = {}
    if local.prime.norm() ** (len(basis) - 1) > MOST:
        raise TooLargeError(f"there are too many candidates for ideals of norm {local.prime}")
    vectors = [flint.fmpq_mat([row]) for row in basis]
    order = frame.volume(rows)
    prime = frame.integers.prime(local.prime)
    for k, first in enumerate(vectors):
        for digits in product(local.representatives, repeat=len(vectors) - k - 1):
            x = first
            for c, v in zip(digits, vectors[k + 1 :], strict=True):
                x = x + v * frame.scalar(c)
            ideal = unique_rows(
                flint.fmpq_mat([*multiples_from_left(local, x, rows), *below.tolist()])
            )
            if frame.norm_ideal(ideal) == prime and frame.volume(ideal) == order * prime * prime:
                found.setdefault(str(ideal), local.independent(ideal, below))
    return list(found.values())


def multiples_from_left(local: Local, x: flint.fmpq_mat, rows: flint.fmpq_mat) -> Rows:
    """Return the products x·y for the rows y of a lattice."""
    return [(x * local.frame.right(row)).entries() for row in rows.tolist()]


def subideals(local: Local, ideal: flint.fmpq_mat, found: list[Rows]) -> Iterator[flint.fmpq_mat]:
    """Yield the right ideals of relative norm P in an invertible one; ``found`` are those of its order."""
    frame = local.frame
    y = local_generator(local, ideal)
    below = local.times_prime(ideal).tolist()
    for pair in found:
        elements = [y * frame.right(row) for row in pair]
        parts = [(x * m).entries() for x in elements for m in frame.scalars]
        yield unique_rows(flint.fmpq_mat([*parts, *below]))


def coordinates_of_subideals(
    local: Local, spans: list[flint.fmpq_mat], ideal: flint.fmpq_mat
) -> Iterator[flint.fmpz_mat]:
    """Yield the same in coordinates of the ideal; ``spans`` are the elements found, with their multiples."""
    frame, inverse = local.frame, ideal.inv()
    y = frame.left(local_generator(local, ideal).entries()) * inverse
    below = (local.times_prime(ideal) * inverse).numer_denom()[0].tolist()
    for span in spans:
        whole = flint.fmpz_mat([*(span * y).numer_denom()[0].tolist(), *below]).hnf()
        yield flint.fmpz_mat(frame.size, frame.size, whole.entries()[: frame.size**2])


def local_generator(local: Local, ideal: flint.fmpq_mat) -> flint.fmpq_mat:
    """Return an element that generates an invertible ideal at P: its norm is that of the ideal there."""
    frame, rows = local.frame, ideal.tolist()
    least = frame.norm_ideal(ideal).valuation(local.prime)
    sums = (
        [c + d for c, d in zip(x, y, strict=True)] for k, x in enumerate(rows) for y in rows[:k]
    )
    for row in (*rows, *sums):
        norm = frame.norm(row)
        if norm and local.prime.valuation(norm) == least:
            return flint.fmpq_mat([row])
    raise LatticeError("the norms of a lattice are generated by those of a basis and its sums")
