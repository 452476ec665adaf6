"""The compiled z-buffer: triangles with a light interpolated over them, several samples a pixel.

The picture is made in stripes of a few rows, so that the samples stay in the cache and memory does not grow
with the picture. One thread, no reassociation: the same input gives the same bytes.
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


@kernel
def paint(
    pixels: Bytes,
    box: tuple[int, int, int, int],
    samples: int,
    corners: Floats,
    triangles: Indices,
    lit: Indices,
    light: Floats,
    paints: Floats,
    linear: Floats,
    encoded: Bytes,
) -> None:
    """Draw the triangles that face the viewer over ``pixels`` (height, width, 4), inside ``box``.

    The picture is the mean of some moments. ``corners`` (moments, k, 3) are x and y in pixels, y downwards,
    and a depth growing towards the viewer; ``triangles`` (m, 3) index them, counter-clockwise as seen from
    outside; ``lit`` (m, 3) index ``light`` (moments, l, 2), the share of its own colour and the white that
    each corner sends; ``paints`` (m, 3) are linear colours. ``linear`` (256,) decodes sRGB, ``encoded``
    encodes equal steps of linear light. ``samples`` is per pixel and axis.
    """
    left, top, right, bottom = box
    s = samples
    wide = (right - left) * s
    depth = np.empty((ROWS * s, wide), np.float32)
    colours = np.empty((ROWS * s, wide, 4), np.float32)
    moments = len(corners)
    sums = np.empty((ROWS, right - left, 4), np.float32)
    front = np.empty((moments, len(triangles)), np.int64)
    spans = np.empty((moments, len(triangles), 2), np.int64)
    found = np.zeros(moments, np.int64)
    xs, ys = np.empty(3), np.empty(3)
    for n in range(moments):
        for t in range(len(triangles)):
            a, b, c = triangles[t]
            ax, ay, bx, by = corners[n, a, 0], corners[n, a, 1], corners[n, b, 0], corners[n, b, 1]
            cx, cy = corners[n, c, 0], corners[n, c, 1]
            # With y downwards the triangles that face the viewer turn clockwise.
            if (bx - ax) * (cy - ay) - (cx - ax) * (by - ay) < -LEAST:
                f = found[n]
                front[n, f] = t
                spans[n, f, 0] = math.ceil(min(ay, by, cy) * s - 0.5)
                spans[n, f, 1] = math.ceil(max(ay, by, cy) * s - 0.5)
                found[n] += 1
    for row in range(top, bottom, ROWS):
        rows = min(ROWS, bottom - row)
        first, last = row * s, (row + rows) * s
        sums[:] = 0
        for n in range(moments):
            depth[:] = -np.inf
            colours[:] = 0
            for f in range(found[n]):
                start, stop = max(spans[n, f, 0], first), min(spans[n, f, 1], last)
                if start < stop:
                    t = front[n, f]
                    scan(
                        xs,
                        ys,
                        depth,
                        colours,
                        first,
                        start,
                        stop,
                        left * s,
                        s,
                        corners[n],
                        triangles[t],
                        lit[t],
                        light[n],
                        paints[t],
                    )
            gather(sums, colours, rows, s)
        resolve(pixels, sums, row, rows, left, 1.0 / (s * s * moments), linear, encoded)


@called
def scan(
    xs: Floats,
    ys: Floats,
    depth: Samples,
    colours: Samples,
    first: int,
    start: int,
    stop: int,
    left: int,
    s: int,
    corners: Floats,
    triangle: Indices,
    lit: Indices,
    light: Floats,
    paint: Floats,
) -> None:
    """Fill the samples of one triangle in the rows of samples ``start`` … ``stop`` − 1."""
    for k in range(3):
        xs[k], ys[k] = corners[triangle[k], 0] * s - left, corners[triangle[k], 1] * s
    ux, uy, vx, vy = xs[1] - xs[0], ys[1] - ys[0], xs[2] - xs[0], ys[2] - ys[0]
    area = ux * vy - vx * uy
    z0, p0, g0 = corners[triangle[0], 2], light[lit[0], 0], light[lit[0], 1]
    zu, zv = corners[triangle[1], 2] - z0, corners[triangle[2], 2] - z0
    pu, pv = light[lit[1], 0] - p0, light[lit[2], 0] - p0
    gu, gv = light[lit[1], 1] - g0, light[lit[2], 1] - g0
    zx, px, gx = (zu * vy - zv * uy) / area, (pu * vy - pv * uy) / area, (gu * vy - gv * uy) / area
    zy, py, gy = (zv * ux - zu * vx) / area, (pv * ux - pu * vx) / area, (gv * ux - gu * vx) / area
    # The corners by height. Each edge is reckoned from its upper end, so that both its triangles get the
    # same crossings and no sample is lost or drawn twice between them.
    u, m, d = 0, 1, 2
    if ys[u] > ys[m]:
        u, m = m, u
    if ys[m] > ys[d]:
        m, d = d, m
    if ys[u] > ys[m]:
        u, m = m, u
    long, upper, lower = slope(xs, ys, u, d), slope(xs, ys, u, m), slope(xs, ys, m, d)
    wide = depth.shape[1]
    for y in range(start, stop):
        middle = y + 0.5
        near = xs[u] + (middle - ys[u]) * long
        k, side = (u, upper) if middle < ys[m] else (m, lower)
        far = xs[k] + (middle - ys[k]) * side
        # Rows of samples lie a little to one side by turns: a steep edge has twice as many levels then.
        place = 0.5 if s == 1 else 0.25 + 0.5 * (y % 2)
        begin, end = math.ceil(min(near, far) - place), math.ceil(max(near, far) - place)
        begin, end = max(0, begin), min(wide, end)
        if begin >= end:
            continue
        across, down = begin + place - xs[0], middle - ys[0]
        z = z0 + zx * across + zy * down
        p = p0 + px * across + py * down
        g = g0 + gx * across + gy * down
        for x in range(begin, end):
            if z > depth[y - first, x]:
                depth[y - first, x] = z
                colours[y - first, x, 0] = paint[0] * p + g
                colours[y - first, x, 1] = paint[1] * p + g
                colours[y - first, x, 2] = paint[2] * p + g
                colours[y - first, x, 3] = 1
            z += zx
            p += px
            g += gx


@kernel
def opaque(pixels: Bytes, box: tuple[int, int, int, int], picture: Bytes) -> None:
    """Copy ``pixels`` (height, width, 4) inside ``box`` to ``picture`` (height, width, 3)."""
    left, top, right, bottom = box
    for y in range(top, bottom):
        for x in range(left, right):
            picture[y, x, 0] = pixels[y, x, 0]
            picture[y, x, 1] = pixels[y, x, 1]
            picture[y, x, 2] = pixels[y, x, 2]


@called
def slope(xs: Floats, ys: Floats, i: int, j: int) -> float:
    """Return how far the edge between two corners moves sideways in a row; 0 where it is level."""
    return (xs[j] - xs[i]) / (ys[j] - ys[i]) if ys[i] != ys[j] else 0.0


@called
def gather(sums: Samples, colours: Samples, rows: int, s: int) -> None:
    """Add the samples of each pixel of a stripe to ``sums`` (rows, width, 4): three colours and a count."""
    for y in range(rows):
        for j in range(y * s, (y + 1) * s):
            for x in range(sums.shape[1]):
                for i in range(x * s, (x + 1) * s):
                    for channel in range(4):
                        sums[y, x, channel] += colours[j, i, channel]


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
) -> None:
    """Write the means of a stripe, in linear light, over what is there; ``share`` is that of one sample."""
    steps = len(encoded) - 1
    for y in range(rows):
        for x in range(sums.shape[1]):
            if sums[y, x, 3] > 0:
                pixel = pixels[row + y, left + x]
                rest = 1.0 - sums[y, x, 3] * share
                for channel in range(3):
                    value = sums[y, x, channel] * share + rest * linear[pixel[channel]]
                    pixel[channel] = encoded[int(min(1.0, max(0.0, value)) * steps)]
