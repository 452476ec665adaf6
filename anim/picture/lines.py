"""Draw antialiased lines by the covered share of each pixel, compiled."""

import math

import numpy as np
from numpy.typing import NDArray

from anim.compiling import kernel

Bytes = NDArray[np.uint8]
Floats = NDArray[np.float64]
Samples = NDArray[np.float32]


@kernel
def draw_line(pixels: Bytes, mask: Samples, points: Floats, half: float, colour: Floats) -> None:
    """Draw a line through ``points`` (k, 3), y upwards, with round ends; ``half`` is half its width.

    The third coordinate is the opacity, from 0 to 1. ``mask`` (height, width) is working memory for the
    coverage of each pixel, computed from the distance of its centre to the line; it is zero before and after.
    Pixels that the line crosses twice are painted only once.
    """
    height, width = mask.shape
    reach = half + 0.5
    left, top, right, bottom = width, height, 0, 0
    for k in range(len(points) - 1):
        x0, y0 = points[k, 0], height - points[k, 1]
        dx, dy = points[k + 1, 0] - x0, height - points[k + 1, 1] - y0
        square = max(dx * dx + dy * dy, 1e-12)
        ink = (points[k, 2] + points[k + 1, 2]) / 2
        first = max(0, math.floor(min(y0, y0 + dy) - reach))
        last = min(height, math.ceil(max(y0, y0 + dy) + reach))
        top, bottom = min(top, first), max(bottom, last)
        for y in range(first, last):
            v = y + 0.5 - y0
            begin, end = min(0.0, dx), max(0.0, dx)
            if abs(dy) > 1e-9:  # only as far as the segment comes near to this row
                one, other = (v - reach) / dy * dx, (v + reach) / dy * dx
                begin, end = max(begin, min(one, other)), min(end, max(one, other))
            start = max(0, math.floor(x0 + begin - reach))
            stop = min(width, math.ceil(x0 + end + reach))
            left, right = min(left, start), max(right, stop)
            for x in range(start, stop):
                u = x + 0.5 - x0
                t = min(1.0, max(0.0, (u * dx + v * dy) / square))
                across, along = u - t * dx, v - t * dy
                near = reach - math.sqrt(across * across + along * along)
                mask[y, x] = max(mask[y, x], ink * min(1.0, near))
    for y in range(top, bottom):
        for x in range(left, right):
            share = mask[y, x]
            if share > 0:
                mask[y, x] = 0
                pixel = pixels[y, x]
                for channel in range(3):
                    pixel[channel] = int(
                        pixel[channel] * (1 - share) + colour[channel] * share + 0.5
                    )


@kernel
def opaque(pixels: Bytes, box: tuple[int, int, int, int], picture: Bytes) -> None:
    """Copy ``pixels`` (height, width, 4) inside ``box`` to ``picture`` (height, width, 3)."""
    left, top, right, bottom = box
    for y in range(top, bottom):
        for x in range(left, right):
            picture[y, x, 0] = pixels[y, x, 0]
            picture[y, x, 1] = pixels[y, x, 1]
            picture[y, x, 2] = pixels[y, x, 2]
