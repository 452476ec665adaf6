"""Invertible right ideals of prime norm, in an order over the integers of a number field or in its ideals.

A right ideal of relative norm P in I = y·O_P is y·K + P·I, for a right ideal K of O of norm P. K contains
P·O, and is x·O + P·O for an x in O with a norm of valuation 1: in M₂(ℤ_P) for the lines of a plane, in an
Eichler order for those in two columns and, of level P, the radical (Voight, *Quaternion Algebras*, 26.3).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import Any

import flint

from hfield.errors import LatticeError, TooLargeError
from hfield.lattices.over_integers.dedekind_modules import unique_rows
from hfield.lattices.over_integers.local_orders import Local, Rows

MOST = 10**5
"""No more ideals of one norm than this are listed."""


def generators(local: Local, rows: flint.fmpq_mat, exponent: int, ramified: bool) -> list[Rows]:
    """Return elements that generate over the integers, with P·O, the right ideals K of norm P.

    The discriminant of the order has the given exponent at P. Raises :class:`TooLargeError`.
    """
    if local.prime.norm > MOST:
        raise TooLargeError(f"there are too many ideals of norm {local.prime} to list them")
    symbol = local.symbol(rows) if exponent else 1
    if symbol == 1 and not ramified:
        return _split(local, rows, exponent)
    radical, below = local.radical(rows), local.times_prime(rows)
    if exponent == 1:  # ramified, of one maximal ideal
        return [local.independent(radical, below)]
    return _in_radical(local, rows, local.independent(radical, below), below)


def _split(local: Local, rows: flint.fmpq_mat, exponent: int) -> list[Rows]:
    """Return those of M₂(ℤ_P), or of an Eichler order of level Pᵏ, k the exponent, through matrix units."""
    frame = local.frame
    e = local.idempotent(rows, 1)
    inverse = local.times_prime(rows).inv()

    def outside(elements: flint.fmpq_mat) -> flint.fmpq_mat:
        found = elements.tolist()
        inside = (elements * inverse).tolist()
        k = next(k for k, row in enumerate(inside) if any(c.q != 1 for c in row))
        return flint.fmpq_mat([found[k]])

    u, v = map(outside, local.corners(rows, e))

    def lines(first: Any, second: Any, across: Any) -> Iterator[Rows]:
        # (first + c·second)·O, where first is idempotent and second·first = second
        by = frame.right(across.entries())
        for c in local.representatives:
            x = first + second * frame.scalar(c)
            yield [x.entries(), (x * by).entries()]

    found = list(lines(e, v, u))
    if exponent == 0:
        return [*found, [v.entries(), (v * frame.right(u.entries())).entries()]]
    found += lines(frame.row(1) - e, u, v)
    return [*found, [u.entries(), v.entries()]] if exponent == 1 else found


def _in_radical(
    local: Local, rows: flint.fmpq_mat, basis: Rows, below: flint.fmpq_mat
) -> list[Rows]:
    """Return those x·O + P·O with x in the radical, a basis of which modulo P·O is given, one by one."""
    frame = local.frame
    found: dict[str, Rows] = {}
    if local.prime.norm ** (len(basis) - 1) > MOST:
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
    y = _generator(local, ideal)
    below = local.times_prime(ideal).tolist()
    for pair in found:
        elements = [y * frame.right(row) for row in pair]
        parts = [(x * m).entries() for x in elements for m in frame.scalars]
        yield unique_rows(flint.fmpq_mat([*parts, *below]))


def _generator(local: Local, ideal: flint.fmpq_mat) -> flint.fmpq_mat:
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
