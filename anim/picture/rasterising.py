"""Rasterise lit triangles by the covered share of each pixel, compiled.

A solid made of convex pieces needs no z-buffer: the front faces of a piece lie side by side, so their shares
of a pixel add up, and the pieces are drawn from front to back, each into the remaining share. The shares are
exact areas (E. Catmull, "A hidden-surface algorithm with anti-aliasing", SIGGRAPH 1978), at the cost of one
sample per pixel. The picture is drawn in stripes of a few rows, so that they stay in the cache. There is one
thread and no reassociation: the same input gives the same bytes.
"""

import math

import numpy as np
from numpy.typing import NDArray

from anim.compiling import called, kernel

Bytes = NDArray[np.uint8]
Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Samples = NDArray[np.float32]

LEAST = 1e-9
"""Twice the area, in pixels, below which a triangle is a line seen from its side and covers nothing."""
ROWS = 32
"""Rows of pixels in a stripe."""


def workspace(
    width: int, moments: int, triangles: int, pieces: int
) -> tuple[Samples, Samples, Samples, Indices, Indices, Indices, Floats]:
    """Return the working memory of :func:`paint` for a box of this width."""
    return (
        np.zeros((ROWS, width, 4), np.float32),
        np.empty((ROWS, width), np.float32),
        np.empty((ROWS, width, 4), np.float32),
        np.empty((ROWS, 2), np.int64),
        np.empty((moments, triangles, 3), np.int64),
        np.zeros((moments, pieces + 1), np.int64),
        np.empty((2, 3)),
    )


@kernel
def paint(
    pixels: Bytes,
    box: tuple[int, int, int, int],
    smooth: bool,
    corners: Floats,
    order: Indices,
    starts: Indices,
    triangles: Indices,
    lit: Indices,
    light: Floats,
    paints: Floats,
    linear: Floats,
    encoded: Bytes,
    covered: Samples,
    layer: Samples,
    cover: Samples,
    sums: Samples,
    reach: Indices,
    front: Indices,
    found: Indices,
    corner: Floats,
) -> None:
    """Draw the triangles that face the viewer over ``pixels`` (height, width, 3), inside ``box``.

    The picture is the mean of several moments. ``corners`` (moments, k, 2) are pixels, y downwards;
    ``triangles`` (m, 3) index them, counterclockwise as seen from outside; those of piece k begin at
    ``starts`` [k], (pieces + 1,); ``order`` (moments, pieces) lists the pieces from the farthest to the
    nearest. ``lit`` (m, 3) index ``light`` (moments, l, 2), the shares of its own colour and of white that
    each corner reflects; ``paints`` (m, 3) are linear colours. ``linear`` (256,) decodes sRGB, and
    ``encoded`` encodes equal steps of linear light. Unless ``smooth``, a pixel has the colour at its centre.
    The coverage of each pixel is written into ``covered`` (height, width) if that has the size of the
    picture.

    The other arguments are working memory made by :func:`workspace`. For a stripe of rows they are the
    colours of one piece, its coverage, the sum over moments, and the part of each row that is reached.
    ``front`` contains the front-facing triangles with their first and last rows, and their number. ``corner``
    contains the three corners of a triangle.
    """
    xs, ys = corner[0], corner[1]
    left, top, right, bottom = box
    moments, pieces = len(corners), len(starts) - 1
    for n in range(moments):
        f = 0
        for place in range(pieces):
            piece = order[n, pieces - 1 - place]
            for t in range(starts[piece], starts[piece + 1]):
                a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
                ax, ay, bx, by = (
                    corners[n, a, 0],
                    corners[n, a, 1],
                    corners[n, b, 0],
                    corners[n, b, 1],
                )
                cx, cy = corners[n, c, 0], corners[n, c, 1]
                # With y downwards the triangles that face the viewer turn clockwise.
                if (bx - ax) * (cy - ay) - (cx - ax) * (by - ay) < -LEAST:
                    front[n, f, 0] = t
                    front[n, f, 1] = math.floor(min(ay, by, cy))
                    front[n, f, 2] = math.ceil(max(ay, by, cy))
                    f += 1
            found[n, place + 1] = f
    for row in range(top, bottom, ROWS):
        rows = min(ROWS, bottom - row)
        for y in range(rows):
            for x in range(right - left):
                for channel in range(4):
                    sums[y, x, channel] = 0
        for n in range(moments):
            for y in range(rows):
                for x in range(right - left):
                    cover[y, x] = 0
            for place in range(pieces):
                for y in range(rows):
                    reach[y, 0], reach[y, 1] = right - left, 0
                for f in range(found[n, place], found[n, place + 1]):
                    start, stop = max(front[n, f, 1], row), min(front[n, f, 2], row + rows)
                    if start < stop:
                        t = front[n, f, 0]
                        spread(
                            xs,
                            ys,
                            layer,
                            reach,
                            row,
                            start,
                            stop,
                            left,
                            smooth,
                            corners[n],
                            triangles[t],
                            lit[t],
                            light[n],
                            paints[t],
                        )
                behind(sums, cover, layer, reach, rows)
        resolve(pixels, sums, row, rows, left, 1.0 / moments, linear, encoded, covered)


@called
def spread(
    xs: Floats,
    ys: Floats,
    layer: Samples,
    reach: Indices,
    row: int,
    start: int,
    stop: int,
    left: int,
    smooth: bool,
    corners: Floats,
    triangle: Indices,
    lit: Indices,
    light: Floats,
    paint: Floats,
) -> None:
    """Add one triangle's light and share of the pixels to ``layer``, in the rows ``start`` … ``stop`` − 1.

    ``layer`` begins at ``row``; ``reach`` (rows, 2) is extended to the columns that were touched.
    """
    for k in range(3):
        xs[k], ys[k] = corners[triangle[k], 0] - left, corners[triangle[k], 1]
    ux, uy, vx, vy = xs[1] - xs[0], ys[1] - ys[0], xs[2] - xs[0], ys[2] - ys[0]
    area = ux * vy - vx * uy
    p0, p1, p2 = light[lit[0], 0], light[lit[1], 0], light[lit[2], 0]
    g0, g1, g2 = light[lit[0], 1], light[lit[1], 1], light[lit[2], 1]
    pu, pv, gu, gv = p1 - p0, p2 - p0, g1 - g0, g2 - g0
    px, gx = (pu * vy - pv * uy) / area, (gu * vy - gv * uy) / area
    py, gy = (pv * ux - pu * vx) / area, (gv * ux - gu * vx) / area
    # The middle of a pixel may be outside its triangle, where the light would be extrapolated.
    least, most = min(p0, p1, p2), max(p0, p1, p2)
    dull, bright = min(g0, g1, g2), max(g0, g1, g2)
    # The corners by height. Crossings on an edge are computed from its upper end, so that both
    # adjacent triangles get the same crossings, and no pixel between them is omitted or drawn
    # twice.
    u, m, d = 0, 1, 2
    if ys[u] > ys[m]:
        u, m = m, u
    if ys[m] > ys[d]:
        m, d = d, m
    if ys[u] > ys[m]:
        u, m = m, u
    long, wide = slope(xs, ys, u, d), layer.shape[1]
    above, below = slope(xs, ys, u, m), slope(xs, ys, m, d)
    for y in range(start, stop):
        for half in range(2):
            k, end = (u, m) if half == 0 else (m, d)
            high, low = max(float(y), ys[k]), min(y + 1.0, ys[end])
            share = low - high
            if not smooth:
                if not (ys[k] <= y + 0.5 < ys[end]):
                    continue
                high, low, share = y + 0.5, y + 0.5, 1.0
            if share <= 0:
                continue
            side = above if half == 0 else below
            w0, w1 = xs[u] + (high - ys[u]) * long, xs[u] + (low - ys[u]) * long
            e0, e1 = xs[k] + (high - ys[k]) * side, xs[k] + (low - ys[k]) * side
            if w0 + w1 > e0 + e1:
                w0, w1, e0, e1 = e0, e1, w0, w1
            if not smooth:
                w0, e0 = math.ceil(w0 - 0.5), math.ceil(e0 - 0.5)
                w1, e1 = w0, e0
            begin, end = max(0, math.floor(min(w0, w1))), min(wide, math.ceil(max(e0, e1)))
            whole, broken = max(w0, w1), min(e0, e1)
            across, down = begin + 0.5 - xs[0], y + 0.5 - ys[0]
            p = p0 + px * across + py * down
            g = g0 + gx * across + gy * down
            for x in range(begin, end):
                part = share
                if x < whole:
                    part *= beyond(w0, w1, x)
                if x + 1 > broken:
                    part -= share * beyond(e0, e1, x)
                if part > 0:
                    own = part * min(most, max(least, p))
                    white = part * min(bright, max(dull, g))
                    here = layer[y - row, x]
                    here[0] += paint[0] * own + white
                    here[1] += paint[1] * own + white
                    here[2] += paint[2] * own + white
                    here[3] += part
                p += px
                g += gx
            if begin < end:
                reach[y - row, 0] = min(reach[y - row, 0], begin)
                reach[y - row, 1] = max(reach[y - row, 1], end)


@called
def beyond(x0: float, x1: float, x: int) -> float:
    """Return the share of the pixel at ``x`` to the right of a line that crosses its row from x0 to x1."""
    near, far = x + 1 - max(x0, x1), x + 1 - min(x0, x1)
    if near >= 1 or far <= 0:
        return 1.0 if near >= 1 else 0.0
    if far - near < 1e-4:
        return min(1.0, max(0.0, (near + far) / 2))
    below = max(0.0, near)
    above = far - 0.5 if far > 1 else far * far / 2
    return (above - below * below / 2) / (far - near)


@called
def slope(xs: Floats, ys: Floats, i: int, j: int) -> float:
    """Return the horizontal displacement per row of the edge between two corners; 0 for a horizontal edge."""
    return (xs[j] - xs[i]) / (ys[j] - ys[i]) if ys[i] != ys[j] else 0.0


@called
def behind(sums: Samples, cover: Samples, layer: Samples, reach: Indices, rows: int) -> None:
    """Add a piece's ``layer`` to ``sums`` where pieces in front do not cover it, and clear the layer.

    Pieces that meet in a pixel are assumed to lie side by side in it, as along their common rim.
    """
    for y in range(rows):
        for x in range(reach[y, 0], reach[y, 1]):
            here = layer[y, x]
            if here[3] > 0:
                rest = np.float32(1.0) - cover[y, x]
                if rest > 0:
                    share = min(np.float32(1.0), rest / here[3])
                    cover[y, x] += here[3] * share
                    for channel in range(4):
                        sums[y, x, channel] += here[channel] * share
                for channel in range(4):
                    here[channel] = 0


@called
def resolve(
    pixels: Bytes,
    sums: Samples,
    row: int,
    rows: int,
    left: int,
    share: float,
    linear: Floats,
    encoded: Bytes,
    covered: Samples,
) -> None:
    """Write the means of a stripe, in linear light; ``share`` is the weight of one moment."""
    steps, noted = len(encoded) - 1, len(covered) == len(pixels)
    for y in range(rows):
        for x in range(sums.shape[1]):
            if sums[y, x, 3] > 0:
                pixel = pixels[row + y, left + x]
                rest = 1.0 - sums[y, x, 3] * share
                if noted:
                    covered[row + y, left + x] = min(1.0, 1.0 - rest)
                for channel in range(3):
                    value = sums[y, x, channel] * share
                    if rest > 1e-3:
                        value += rest * linear[pixel[channel]]
                    pixel[channel] = encoded[int(min(1.0, max(0.0, value)) * steps)]


@kernel
def outline(
    pixels: Bytes,
    covered: Samples,
    box: tuple[int, int, int, int],
    reach: int,
    share: float,
    colour: Floats,
) -> None:
    """Blend a colour with weight ``share`` over pixels within ``reach`` of the edge of ``covered``.

    ``covered`` (height, width) is set to zero.
    """
    left, top, right, bottom = box
    height, width = covered.shape
    aside = max(1, int(0.7 * reach + 0.5))
    for y in range(top, bottom):
        above, below = covered[max(0, y - reach)], covered[min(height - 1, y + reach)]
        higher, lower = covered[max(0, y - aside)], covered[min(height - 1, y + aside)]
        row = covered[y]
        for x in range(left, right):
            here = row[x]
            if here > 0:
                west, east = max(0, x - aside), min(width - 1, x + aside)
                least = min(row[max(0, x - reach)], row[min(width - 1, x + reach)])
                least = min(least, min(above[x], below[x]))
                least = min(least, min(higher[west], higher[east]))
                least = min(least, min(lower[west], lower[east]))
                light = share * (here - least)
                if light > 0:
                    pixel = pixels[y, x]
                    for channel in range(3):
                        pixel[channel] = int(
                            pixel[channel] + light * (colour[channel] - pixel[channel]) + 0.5
                        )
    for y in range(top, bottom):
        for x in range(left, right):
            covered[y, x] = 0
