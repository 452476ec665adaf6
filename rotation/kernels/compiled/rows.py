"""Rows of points and parameters in memory: as columns or side by side, one at a time or in eights.

``kinds`` are zeros of the types that points and parameters have in memory, and of the type computed in;
``views`` are the addresses of the columns of points, parameters and result at a block, four each.
"""

from typing import Any

import numpy as np
from numba import types

from rotation.kernels.compiled.access import at, near, packed, put, view
from rotation.kernels.compiled.compiling import called, inlined, primitive
from rotation.kernels.compiled.lanes import (
    GROUP,
    load,
    load_rows,
    prefetch,
    store,
    store_triples,
)

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
