"""Reduced echelon forms and solutions over fields, by flint if it has matrices over the field."""

from __future__ import annotations

from collections.abc import Sequence

import flint

from hfield.fields.base.ring import E, Ring
from hfield.fields.linear_algebra.syzygies import Row


def echelon(ring: Ring[E], rows: Sequence[Row[E]]) -> tuple[list[Row[E]], list[int]]:
    """Return the nonzero rows of the reduced echelon form over a field, and the columns of its pivots."""
    if not rows or not rows[0]:
        return [], []
    one = ring.one
    if isinstance(one, flint.fmpq | flint.nmod):
        entries = [x for row in rows for x in row]
        if isinstance(one, flint.fmpq):
            found, rank = flint.fmpq_mat(len(rows), len(rows[0]), entries).rref()
        else:
            found, rank = flint.nmod_mat(len(rows), len(rows[0]), entries, one.modulus()).rref()
        reduced: list[Row[E]] = found.tolist()[:rank]
    else:
        reduced = _eliminated(ring, rows)
    pivots = [next(n for n, x in enumerate(row) if not ring.is_zero(x)) for row in reduced]
    return reduced, pivots


def _eliminated(ring: Ring[E], rows: Sequence[Row[E]]) -> list[Row[E]]:
    rest, done = [list(row) for row in rows], list[Row[E]]()
    for column in range(len(rows[0])):
        pivot = next((row for row in rest if not ring.is_zero(row[column])), None)
        if pivot is None:
            continue
        rest = [row for row in rest if row is not pivot]
        scale = ring.inverse(pivot[column])
        pivot[:] = [x * scale for x in pivot]
        for row in (*rest, *done):
            factor = row[column]
            if not ring.is_zero(factor):
                row[:] = [x - factor * y for x, y in zip(row, pivot, strict=True)]
        done.append(pivot)
    return done


def null_space(ring: Ring[E], rows: Sequence[Row[E]], width: int) -> list[Row[E]]:
    """Return a basis of the vectors v of ``width`` entries with rows·v = 0, over a field."""
    reduced, pivots = echelon(ring, rows)
    out = []
    for free in range(width):
        if free in pivots:
            continue
        v = [ring.zero] * width
        v[free] = ring.one
        for row, pivot in zip(reduced, pivots, strict=True):
            v[pivot] = -row[free]
        out.append(v)
    return out


def solution(ring: Ring[E], rows: Sequence[Row[E]], right: Sequence[Row[E]]) -> list[Row[E]] | None:
    """Return some X with rows·X = right, over a field, or None if there is none."""
    width, extra = len(rows[0]), len(right[0])
    if len(rows) == width and isinstance(ring.one, flint.fmpq):
        try:  # Dixon's lifting is quicker than elimination
            found: list[Row[E]] = flint.fmpq_mat(rows).solve(flint.fmpq_mat(right)).tolist()
            return found
        except ZeroDivisionError:
            pass
    reduced, pivots = echelon(ring, [[*x, *y] for x, y in zip(rows, right, strict=True)])
    if pivots and pivots[-1] >= width:
        return None
    out = [[ring.zero] * extra for _ in range(width)]
    for row, pivot in zip(reduced, pivots, strict=True):
        out[pivot] = row[width:]
    return out
