"""The walk over a batch that all rotating kernels share: blocks, layouts, eight points at a time.

A kernel brings two forms of its formula. ``fast(parameters, extra, point)`` takes lanes and returns the
rotated points and where they are right. ``careful``, for the rows where they are not, takes numbers and
returns the rotated point and whether it has a rotation (a zero axis is none); the point it is given is
scaled to a largest coordinate of about 1, or NaN. Parameters are four, whatever the formula takes of them.
Eight points are read before they are written, so the result may be the points.

Names here: ``kinds`` are zeros of the types that points and parameters have in memory, and of the type
computed in; ``views`` are the addresses of the columns of points, parameters and result at a block,
four each; ``steps`` how many numbers lie from one row to the next in the columns of points and result, in
the first three of the parameters and in the fourth.
"""

import math
from typing import Any

import numpy as np
from numba import types

from rotation.kernels.compiled.access import (
    BLOCK,
    TAKE,
    at,
    blocks,
    near,
    packed,
    put,
    span,
    take,
    view,
)
from rotation.kernels.compiled.compiling import called, inlined, primitive
from rotation.kernels.compiled.lanes import (
    ALL,
    GROUP,
    bits,
    load,
    load_rows,
    prefetch,
    store,
    store_triples,
)
from rotation.kernels.compiled.ranges import scaled

AHEAD = 8 * GROUP  # rows


@primitive
def size(context: Any, zero: Any) -> Any:
    """Return how many bytes a number of that type takes."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return context.get_constant(types.int64, zero.bitwidth // 8)

    return types.int64(zero), code


@inlined
def columns(what: Any, outer: Any, start: Any, zero: Any) -> Any:
    """Return the addresses of the columns of an operand at a block, as if it had four."""
    first = what[0] + (outer * what[2] + start * what[3]) * size(zero)
    step = what[1] * size(zero)
    return first, first + step, first + 2 * step, first + 3 * step


@inlined
def room(memory: Any, number: Any, rows: Any) -> Any:
    """Return the addresses of four columns in memory for three times as many."""
    first, step = np.int64(memory.ctypes.data) + number * 4 * 8 * rows, 8 * rows
    return first, first + step, first + 2 * step, first + 3 * step


@inlined
def number(column: Any, step: Any, i: Any, zero: Any) -> Any:
    """Return row ``i`` of a column."""
    return at((column, 0, 0), step, i, 0, zero)


@inlined
def write(column: Any, step: Any, i: Any, value: Any) -> None:
    """Write row ``i`` of a column."""
    put((column, 0, 0), step, i, 0, value)


@inlined
def row(columns: Any, i: Any, zero: Any) -> Any:
    """Return row ``i`` of four columns as float64."""
    return (
        np.float64(number(columns[0], 1, i, zero)),
        np.float64(number(columns[1], 1, i, zero)),
        np.float64(number(columns[2], 1, i, zero)),
        np.float64(number(columns[3], 1, i, zero)),
    )


@called
def fetch(what: Any, outer: Any, start: Any, m: Any, width: Any, target: Any, zero: Any) -> None:
    """Copy ``m`` rows of ``width`` components to columns."""
    if packed(what) and width == 3:
        v = near(what, outer, start)
        for i in range(m):  # the compiler turns these loads into shuffles
            write(target[0], 1, i, at(v, 3, i, 0, zero))
            write(target[1], 1, i, at(v, 3, i, 1, zero))
            write(target[2], 1, i, at(v, 3, i, 2, zero))
        return
    v, step = view(what, outer, start), what[3]
    for k in range(width):
        for i in range(m):
            write(target[k], 1, i, at(v, step, i, k, zero))


@called
def deliver(what: Any, outer: Any, start: Any, m: Any, source: Any, zero: Any) -> None:
    """Copy ``m`` points from columns to where the operand has them."""
    if packed(what):
        v = near(what, outer, start)
        for i in range(m):
            put(v, 3, i, 0, number(source[0], 1, i, zero))
            put(v, 3, i, 1, number(source[1], 1, i, zero))
            put(v, 3, i, 2, number(source[2], 1, i, zero))
        return
    v, step = view(what, outer, start), what[3]
    for k in range(3):
        for i in range(m):
            put(v, step, i, k, number(source[k], 1, i, zero))


@inlined
def ahead(column: Any, i: Any, zero: Any) -> Any:
    """Ask for the rows to come; so many columns at once are more than a processor foresees."""
    prefetch(column + (i + AHEAD) * size(zero))


@inlined
def point_apart(views: Any, i: Any, kinds: Any) -> Any:
    """Return no parameters, and eight points from columns."""
    v, _, _ = views
    p, _, kind = kinds
    o = i * size(p)
    for k in range(3):
        ahead(v[k], i, p)
    return (), (load(v[0] + o, p, kind), load(v[1] + o, p, kind), load(v[2] + o, p, kind))


@inlined
def point_together(views: Any, i: Any, kinds: Any) -> Any:
    """Return no parameters, and eight points whose components lie side by side."""
    v, _, _ = views
    p, _, kind = kinds
    return (), load_rows(v[0] + 3 * i * size(p), 3, p, kind)


@inlined
def apart(views: Any, i: Any, kinds: Any) -> Any:
    """Return the parameters of eight points and the points, all from columns."""
    _, u, _ = views
    _, t, kind = kinds
    o = i * size(t)
    for k in range(4):
        ahead(u[k], i, t)
    parameters = (
        load(u[0] + o, t, kind),
        load(u[1] + o, t, kind),
        load(u[2] + o, t, kind),
        load(u[3] + o, t, kind),
    )
    return parameters, point_apart(views, i, kinds)[1]


@inlined
def triples(views: Any, i: Any, kinds: Any) -> Any:
    """Return them where the first three parameters, and the components of points, lie side by side."""
    _, u, _ = views
    _, t, kind = kinds
    a, b, c = load_rows(u[0] + 3 * i * size(t), 3, t, kind)
    last = load(u[3] + i * size(t), t, kind)
    return (a, b, c, last), point_together(views, i, kinds)[1]


@inlined
def quadruples(views: Any, i: Any, kinds: Any) -> Any:
    """Return them where all four parameters, and the components of points, lie side by side."""
    _, u, _ = views
    _, t, kind = kinds
    parameters = load_rows(u[0] + 4 * i * size(t), 4, t, kind)
    return parameters, point_together(views, i, kinds)[1]


@inlined
def write_apart(views: Any, i: Any, kinds: Any, point: Any) -> None:
    """Write eight points to columns."""
    _, _, r = views
    o = i * size(kinds[0])
    store(r[0] + o, kinds[0], point[0])
    store(r[1] + o, kinds[0], point[1])
    store(r[2] + o, kinds[0], point[2])


@inlined
def write_triples(views: Any, i: Any, kinds: Any, point: Any) -> None:
    """Write eight points, the components side by side."""
    _, _, r = views
    store_triples(r[0] + 3 * i * size(kinds[0]), kinds[0], point[0], point[1], point[2])


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
