"""The walk over a batch that all rotating kernels share: blocks, layouts, eight points at a time.

A kernel brings two forms of its formula. ``fast(parameters, extra, point)`` takes lanes and returns the
rotated points and where they are right. ``careful``, for the rows where they are not, takes numbers and
returns the rotated point and whether it has a rotation (a zero axis is none); the point it is given is
scaled to a largest coordinate of about 1, or NaN. Parameters are four, whatever the formula takes of them.
Eight points are read before they are written, so the result may be the points.

``kinds`` and ``views`` are those of `rows`; ``steps`` tell how many numbers lie from one row to the next
in the columns of points and result, in the first three of the parameters and in the fourth.
"""

import math
from typing import Any

import numpy as np

from rotation.kernels.compiled.access import BLOCK, TAKE, blocks, packed, span, take
from rotation.kernels.compiled.compiling import called, inlined
from rotation.kernels.compiled.lanes import ALL, GROUP, bits
from rotation.kernels.compiled.ranges import scaled
from rotation.kernels.compiled.rows import (
    columns,
    deliver,
    fetch,
    number,
    room,
    row,
    write,
    write_apart,
    write_triples,
)


@called
def stretch(
    read: Any, write: Any, fast: Any, extra: Any, views: Any, first: Any, end: Any, kinds: Any
) -> Any:
    """Rotate eights from row ``first`` on; return the row where one is not right, else ``end``.

    A function by itself that calls no other, so that what it needs stays in registers.
    """
    for i in range(first, end, GROUP):
        parameters, point = read(views, i, kinds)
        point, right = fast(parameters, extra, point)
        if bits(right) != ALL:
            return i
        write(views, i, kinds, point)
    return end


@called
def eight(read: Any, fast: Any, extra: Any, views: Any, kinds: Any) -> Any:
    """Rotate one eight in columns; return the bits of the rows that are right."""
    parameters, point = read(views, 0, kinds)
    point, right = fast(parameters, extra, point)
    write_apart(views, 0, kinds, point)
    return bits(right)


@called
def few(
    apart: Any,
    fast: Any,
    careful: Any,
    extra: Any,
    views: Any,
    steps: Any,
    first: Any,
    m: Any,
    kinds: Any,
) -> Any:
    """Rotate ``m`` rows, eight at most, of whatever kind; tell whether one of them has no rotation.

    They are copied, the last repeated to fill up, so that each is computed as in any other place.
    """
    v, u, r = views
    p, t, _ = kinds
    step, wide, last = steps
    memory = np.empty(3 * 4 * 8 * GROUP, np.uint8)
    mine = room(memory, 0, GROUP), room(memory, 1, GROUP), room(memory, 2, GROUP)
    for j in range(GROUP):
        i = first + min(j, m - 1)
        for k in range(3):
            write(mine[0][k], 1, j, number(v[k], step, i, p))
            write(mine[1][k], 1, j, number(u[k], wide, i, t))
        write(mine[1][3], 1, j, number(u[3], last, i, t))
    right = eight(apart, fast, extra, mine, kinds)
    missing = False
    for j in range(m):
        if right & (1 << j):
            for k in range(3):
                write(r[k], step, first + j, number(mine[2][k], 1, j, p))
        else:
            x, y, z, _ = row(mine[0], j, p)
            point, exponent = scaled((x, y, z, 0.0))
            turned, some = careful(row(mine[1], j, t), extra, point[:3])
            missing |= not some
            for k in range(3):
                write(r[k], step, first + j, type(p)(math.ldexp(turned[k], exponent)))
    return missing and memory.size > 0  # the memory is in use until here


@inlined
def walk(
    read: Any,
    write: Any,
    apart: Any,
    fast: Any,
    careful: Any,
    extra: Any,
    views: Any,
    steps: Any,
    m: Any,
    kinds: Any,
) -> Any:
    """Rotate ``m`` rows; tell whether one of them has no rotation."""
    missing = False
    whole = m - m % GROUP
    i = stretch(read, write, fast, extra, views, 0, whole, kinds)
    while i < whole:
        missing |= few(apart, fast, careful, extra, views, steps, i, GROUP, kinds)
        i = stretch(read, write, fast, extra, views, i + GROUP, whole, kinds)
    if whole < m:
        missing |= few(apart, fast, careful, extra, views, steps, whole, m - whole, kinds)
    return missing


@inlined
def sweep(
    fast: Any,
    careful: Any,
    extra: Any,
    apart: Any,
    together: Any,
    counter: Any,
    outer: Any,
    inner: Any,
    operands: Any,
    widths: Any,
    kinds: Any,
) -> Any:
    """Rotate a batch, taking blocks from the counter; tell whether some row has no rotation.

    The operands are points, two of parameters, and result. ``widths`` are the components of those two:
    3 and 1, 3 and 0, 4 and 0, or none at all; one without components is not looked at. ``apart`` and
    ``together`` read eights from columns and from rows whose components lie side by side.
    """
    points, turns, more, result = operands
    width, four = widths[0], widths[1] == 1
    p, t, _ = kinds
    rows_together = packed(points) and packed(result) and (not four or more[3] == 1)
    rows_together = rows_together and (width == 0 or (turns[1] == 1 and turns[3] == width))
    memory = np.empty(0 if rows_together else 3 * 4 * 8 * BLOCK, np.uint8)
    missing = False
    total = blocks(outer, inner)
    while True:
        begin = take(counter, TAKE)
        if begin >= total:
            return missing and memory.size >= 0  # the memory is in use until here
        for block in range(begin, min(begin + TAKE, total)):
            o, start, m = span(block, inner)
            v, r = columns(points, o, start, p), columns(result, o, start, p)
            u, w = columns(turns, o, start, t), columns(more, o, start, t)
            if not rows_together:
                if points[3] != 1:
                    v = room(memory, 0, BLOCK)
                    fetch(points, o, start, m, 3, v, p)
                mine = room(memory, 1, BLOCK)
                if width > 0 and turns[3] != 1:
                    u = mine
                    fetch(turns, o, start, m, width, u, t)
                if four and more[3] != 1:
                    w = (mine[3], mine[3], mine[3], mine[3])
                    fetch(more, o, start, m, 1, w, t)
                if result[3] != 1:
                    r = room(memory, 2, BLOCK)
            if width == 0:  # what is read without being used must be memory of ours all the same
                u = v
            if four or width < 4:
                u = (u[0], u[1], u[2], w[0] if four else u[0])
            views = v, u, r
            if rows_together:
                steps = (3, width, 1 if four else width)
                missing |= walk(
                    together, write_triples, apart, fast, careful, extra, views, steps, m, kinds
                )
            else:
                steps = (1, 1, 1)
                missing |= walk(
                    apart, write_apart, apart, fast, careful, extra, views, steps, m, kinds
                )
                if result[3] != 1:
                    deliver(result, o, start, m, r, p)
