"""Compiled loops that draw the lit ground: empty, and with the soft shadow of the top.

A ray from the ground to the light meets one of the top's cones or misses it; the point of deepest penetration
or nearest approach is known in closed form. The farther this point, the softer the edge, as under an extended
light source. The ground near the top is darker as well, because less of the sky is visible from there.

``environment``, ``lit_surface`` and ``soft_shadow`` call these loops.
"""

import math

import numpy as np
from numpy.typing import NDArray

from anim.compiling import called, kernel

Bytes = NDArray[np.uint8]
Floats = NDArray[np.float64]
Light = NDArray[np.float32]


@called
def smoothstep(low: float, high: float, x: float) -> float:
    """Return Hermite's step from 0 at ``low`` to 1 at ``high``."""
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


@called
def noise(x: int, y: int) -> float:
    """Return interleaved gradient noise in [0, 1) (J. Jimenez 2014), which hides the steps of 8-bit
    colours.
    """
    grain = x * 0.06711056 + y * 0.00583715
    grain = 52.9829189 * (grain - math.floor(grain))
    return grain - math.floor(grain)


@kernel
def lit_ground(
    picture: Light, to_ground: Floats, paper: Floats, dark: float, numbers: Floats, above: bool
) -> None:
    """Draw the empty ground into ``picture``; ``numbers`` are near, far, shade, pool, ring."""
    near, far, shade, pool, ring = numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]
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
def seen_ground(places: Light, to_ground: Floats, near: float, far: float) -> None:
    """Fill ``places`` (height, width, 5) with each pixel's ground coordinates x and y, visibility,
    noise, −1.
    """
    height, width, _ = places.shape
    for y in range(height):
        for x in range(width):
            u, v = x + 0.5, y + 0.5
            scale = to_ground[2, 0] * u + to_ground[2, 1] * v + to_ground[2, 2]
            for k in range(3):
                places[y, x, k] = 0
            if scale > 0:
                gx = (to_ground[0, 0] * u + to_ground[0, 1] * v + to_ground[0, 2]) / scale
                gy = (to_ground[1, 0] * u + to_ground[1, 1] * v + to_ground[1, 2]) / scale
                places[y, x, 0], places[y, x, 1] = gx, gy
                places[y, x, 2] = smoothstep(far, near, math.sqrt(gx * gx + gy * gy))
            places[y, x, 3], places[y, x, 4] = noise(x, y), -1.0


@kernel
def moved_ground(
    floor: Light,
    pixels: Bytes,
    top: int,
    places: Light,
    paper: Light,
    numbers: Light,
) -> None:
    """Draw the ground for a moved camera, as floats and as bytes, from row ``top`` downwards.

    The light is centred at the point at which the camera looks. ``numbers`` are the darkness of the paper,
    shade, pool, ring, and the two coordinates of the camera's displacement. Only the rings move: ``places``
    stores the share of a ring in each pixel, and pixels with an unchanged share are skipped.
    """
    dark, shade_, pool, ring = numbers[0], numbers[1], numbers[2], numbers[3]
    one, half, most = np.float32(1.0), np.float32(0.5), np.float32(255.0)
    thin, three, two = np.float32(1 / 0.03), np.float32(3.0), np.float32(2.0)
    light = one - dark
    height, width, _ = floor.shape
    for y in range(top, height):
        for x in range(width):
            seen = places[y, x, 2]
            if seen > 0:
                gx, gy = places[y, x, 0] + numbers[4], places[y, x, 1] + numbers[5]
                r = np.sqrt(gx * gx + gy * gy) + half
                t = one - min(one, abs(r - np.float32(int(r)) - half) * thin)
                line = t * t * (three - two * t) * ring if r > one else np.float32(0.0)
                if line == places[y, x, 4]:
                    continue
                places[y, x, 4] = line
                down = one - light * (shade_ + line) * seen
                up = dark * (pool - line * half) * seen * most
                for channel in range(3):
                    value = paper[channel] * down + up
                    floor[y, x, channel] = value
                    pixels[y, x, channel] = int(min(most, value + places[y, x, 3]))


@kernel
def shade(
    grid: Light,
    start: Floats,
    step: float,
    cones: Floats,
    tip: Floats,
    axis: Floats,
    light: Floats,
    numbers: Floats,
) -> None:
    """Write the share of unshadowed light into ``grid`` (rows, columns), whose first point is ``start`` (2,).

    ``cones`` (k, 5) are the radius and the height on the axis of one end and of the other, and the slope of
    the radius; ``numbers`` are the shadow's depth, sharp, soft, contact, reach.
    """
    depth, sharp, soft, contact, reach = numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]
    along = light[0] * axis[0] + light[1] * axis[1] + light[2] * axis[2]
    along = min(along, -1e-6) if along < 0 else max(along, 1e-6)
    across, back = 1 - along * along, 1 / along
    rows, columns = grid.shape
    for row in range(rows):
        vy = start[1] + row * step - tip[1]
        for column in range(columns):
            vx = start[0] + column * step - tip[0]
            high = vx * axis[0] + vy * axis[1] - tip[2] * axis[2]
            out = max(0.0, vx * vx + vy * vy + tip[2] * tip[2] - high * high)
            turn = vx * light[0] + vy * light[1] - tip[2] * light[2] - high * along
            middle = turn / across if across > 1e-9 else 0.0
            aside = math.sqrt(max(0.0, out - turn * middle))
            radius = math.sqrt(out)
            met, nearest = 0.0, 1e9
            for k in range(len(cones)):
                r0, z0, r1, z1 = cones[k, 0], cones[k, 1], cones[k, 2], cones[k, 3]
                growth = cones[k, 4]
                rate = growth * along  # how fast it widens along the ray
                bend = across - rate * rate
                # The ray is at the height high + s·along and √(out + 2s·turn + s²·across) from the axis.
                first, last = (z0 - high) * back, (z1 - high) * back
                first, last = max(0.0, min(first, last)), max(first, last)
                if last > first:
                    if bend > 1e-9:
                        s = rate * aside / math.sqrt(across * bend) - middle
                    else:
                        s = last if rate > 0 else first
                    s = min(last, max(first, s))
                    thick = r0 + growth * (high - z0) + rate * s
                    wide = sharp + soft * s
                    square = max(0.0, out + s * (2 * turn + s * across))
                    if square < (thick + wide) * (thick + wide):
                        part = min(1.0, (thick + wide - math.sqrt(square)) / (2 * wide))
                        met = max(met, part * part * (3 - 2 * part) * min(1.0, thick / wide))
                wider, taller = r1 - r0, z1 - z0
                t = (radius - r0) * wider + (high - z0) * taller
                t = min(1.0, max(0.0, t / (wider * wider + taller * taller)))
                dx, dy = radius - r0 - t * wider, high - z0 - t * taller
                inside = z0 <= high <= z1 and radius <= r0 + growth * (high - z0)
                nearest = 0.0 if inside else min(nearest, dx * dx + dy * dy)
            near = 0.0
            if nearest < 9 * reach * reach:
                near = contact * math.exp(-nearest / (reach * reach))
            grid[row, column] = (1 - depth * met) * (1 - near)


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
    """Draw the shaded ground into ``pixels`` (height, width, 3), inside ``box``, as far as ``grid``
    extends.
    """
    left, top, right, bottom = box
    rows, columns = grid.shape
    west, south = start[0] / step, start[1] / step
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
            across = (gx + n * to_ground[0, 0]) * there - west
            along = (gy + n * to_ground[1, 0]) * there - south
            if across < 0 or along < 0 or across >= columns - 1 or along >= rows - 1:
                continue
            i, j = int(across), int(along)
            a, b = np.float32(across - i), np.float32(along - j)
            one, other = grid[j, i], grid[j, i + 1]
            one += (grid[j + 1, i] - one) * b
            other += (grid[j + 1, i + 1] - other) * b
            lit = one + (other - one) * a
            if lit < np.float32(0.999):
                grain = np.float32(noise(x, y))
                for channel in range(3):
                    pixels[y, x, channel] = int(background[y, x, channel] * lit + grain)


@kernel
def grained(background: Light, pixels: Bytes) -> None:
    """Write ``background`` (height, width, 3), float32, as bytes to ``pixels``, dithered to avoid banding."""
    height, width, _ = background.shape
    for y in range(height):
        for x in range(width):
            grain = noise(x, y)
            for channel in range(3):
                pixels[y, x, channel] = int(min(255.0, background[y, x, channel] + grain))
