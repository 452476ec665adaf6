"""The ground in the light, compiled: the empty ground, and the soft shadow that the top throws on it.

For its shadow the top is some slices, discs across its axis or, where it is thin, balls upon it. A ray from
the ground to the light meets a slice or passes it; the edge is the softer the farther the slice is, as
under a light of some width. What is near the top is darker besides: less of the sky is seen there.
"""

import math

import numpy as np
from numpy.typing import NDArray

from anim.compiling import called, kernel

Bytes = NDArray[np.uint8]
Floats = NDArray[np.float64]
Light = NDArray[np.float32]


THICK = 0.03
"""Half of a slice's thickness, where its nearness is what counts."""


@called
def smoothstep(low: float, high: float, x: float) -> float:
    """Return Hermite's step from 0 at ``low`` to 1 at ``high``."""
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


@called
def noise(x: int, y: int) -> float:
    """Return interleaved gradient noise in [0, 1) (J. Jimenez 2014), which hides steps of 8 bits."""
    grain = x * 0.06711056 + y * 0.00583715
    grain = 52.9829189 * (grain - math.floor(grain))
    return grain - math.floor(grain)


@kernel
def lit_ground(
    picture: Light, to_ground: Floats, paper: Floats, dark: float, numbers: Floats, above: bool
) -> None:
    """Write the empty ground into ``picture``; ``numbers`` are near, far, shade, pool, ring."""
    near, far, shade, pool, ring = numbers
    height, width, _ = picture.shape
    for y in range(height):
        for x in range(width):
            u, v = x + 0.5, y + 0.5
            scale = to_ground[2, 0] * u + to_ground[2, 1] * v + to_ground[2, 2]
            down, up = 1.0, 0.0
            if scale > 0 and above:
                gx = (to_ground[0, 0] * u + to_ground[0, 1] * v + to_ground[0, 2]) / scale
                gy = (to_ground[1, 0] * u + to_ground[1, 1] * v + to_ground[1, 2]) / scale
                r = math.sqrt(gx * gx + gy * gy)
                seen = smoothstep(far, near, r)
                line = smoothstep(0.03, 0.0, abs((r + 0.5) % 1.0 - 0.5)) * ring if r > 0.5 else 0.0
                down = 1 - (1 - dark) * (shade + line) * seen
                up = dark * (pool - line / 2) * seen * 255
            for channel in range(3):
                picture[y, x, channel] = paper[channel] * down + up


@kernel
def shade(
    grid: Light,
    start: Floats,
    step: float,
    slices: Floats,
    tip: Floats,
    axis: Floats,
    light: Floats,
    numbers: Floats,
) -> None:
    """Write into ``grid`` (rows, columns), which begins at ``start`` (2,), what is left of the light there.

    ``slices`` (k, 3) are heights on the axis, radii, and 1 for a ball; ``numbers`` are the shadow's depth,
    sharp, soft, contact, reach.
    """
    depth, sharp, soft, contact, reach = numbers
    along = light[0] * axis[0] + light[1] * axis[1] + light[2] * axis[2]
    along = min(along, -0.05) if along < 0 else max(along, 0.05)
    rows, columns = grid.shape
    grid[:] = 0
    nearest = np.full((rows, columns), np.float32(1e9))
    for k in range(len(slices)):
        height, radius, ball = slices[k, 0], slices[k, 1], slices[k, 2]
        cx, cy, cz = tip[0] + axis[0] * height, tip[1] + axis[1] * height, tip[2] + axis[2] * height
        # No ground farther than this from where the slice's middle falls is in its shadow, or near it.
        far = (radius + sharp + soft * (abs(cz) + radius) / light[2]) / light[2]
        fall = cz / light[2]
        first, last, begin, end = within(
            cx - fall * light[0] - start[0],
            cy - fall * light[1] - start[1],
            far,
            step,
            rows,
            columns,
        )
        for row in range(first, last):
            for column in range(begin, end):
                vx, vy = cx - start[0] - column * step, cy - start[1] - row * step
                if ball > 0:
                    s = vx * light[0] + vy * light[1] + cz * light[2]
                else:
                    s = (vx * axis[0] + vy * axis[1] + cz * axis[2]) / along
                if s > 0:
                    px, py, pz = s * light[0] - vx, s * light[1] - vy, s * light[2] - cz
                    wide = sharp + soft * s
                    square = px * px + py * py + pz * pz
                    if square < (radius + wide) * (radius + wide):
                        t = min(1.0, (radius + wide - math.sqrt(square)) / (2 * wide))
                        met = t * t * (3 - 2 * t) * min(1.0, radius / wide)
                        grid[row, column] = max(grid[row, column], met)
        if cz - radius > 3 * reach:
            continue
        first, last, begin, end = within(
            cx - start[0], cy - start[1], radius + 3 * reach, step, rows, columns
        )
        for row in range(first, last):
            for column in range(begin, end):
                vx, vy = cx - start[0] - column * step, cy - start[1] - row * step
                high = vx * axis[0] + vy * axis[1] + cz * axis[2]
                square = vx * vx + vy * vy + cz * cz
                out = max(0.0, math.sqrt(max(0.0, square - high * high)) - radius)
                high = max(0.0, abs(high) - THICK)
                nearest[row, column] = min(nearest[row, column], high * high + out * out)
    for row in range(rows):
        for column in range(columns):
            near = 0.0
            if nearest[row, column] < 9 * reach * reach:
                near = contact * math.exp(-nearest[row, column] / (reach * reach))
            grid[row, column] = (1 - depth * grid[row, column]) * (1 - near)


@called
def within(
    x: float, y: float, far: float, step: float, rows: int, columns: int
) -> tuple[int, int, int, int]:
    """Return the rows and columns of a grid no farther than ``far`` from (x, y)."""
    return (
        max(0, math.floor((y - far) / step)),
        min(rows, math.ceil((y + far) / step) + 1),
        max(0, math.floor((x - far) / step)),
        min(columns, math.ceil((x + far) / step) + 1),
    )


@kernel
def lay(
    pixels: Bytes,
    box: tuple[int, int, int, int],
    background: Light,
    to_ground: Floats,
    grid: Light,
    start: Floats,
    step: float,
) -> None:
    """Lay the shaded ground over ``pixels`` (height, width, 4), inside ``box``, where ``grid`` reaches."""
    left, top, right, bottom = box
    rows, columns = grid.shape
    for y in range(top, bottom):
        v, u = y + 0.5, left + 0.5
        depth = to_ground[2, 0] * u + to_ground[2, 1] * v + to_ground[2, 2]
        gx = to_ground[0, 0] * u + to_ground[0, 1] * v + to_ground[0, 2]
        gy = to_ground[1, 0] * u + to_ground[1, 1] * v + to_ground[1, 2]
        for x in range(left, right):
            n = x - left
            scale = depth + n * to_ground[2, 0]
            if scale <= 0:
                continue
            there = 1 / (scale * step)
            across = (gx + n * to_ground[0, 0]) * there - start[0] / step
            along = (gy + n * to_ground[1, 0]) * there - start[1] / step
            if across < 0 or along < 0 or across >= columns - 1 or along >= rows - 1:
                continue
            i, j = int(across), int(along)
            a, b = across - i, along - j
            left_of = grid[j, i] * (1 - b) + grid[j + 1, i] * b
            right_of = grid[j, i + 1] * (1 - b) + grid[j + 1, i + 1] * b
            lit = left_of * (1 - a) + right_of * a
            if lit > 0.999:
                continue
            grain = noise(x, y)
            for channel in range(3):
                pixels[y, x, channel] = int(background[y, x, channel] * lit + grain)


@kernel
def grained(background: Light, pixels: Bytes) -> None:
    """Write ``background`` (height, width, 3), float32, as bytes without bands into ``pixels``."""
    height, width, _ = background.shape
    for y in range(height):
        for x in range(width):
            grain = noise(x, y)
            for channel in range(3):
                pixels[y, x, channel] = int(min(255.0, background[y, x, channel] + grain))
