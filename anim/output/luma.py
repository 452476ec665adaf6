"""Convert frames to video planes, compiled: luma and two chroma planes, ITU-R BT.709, studio range.

ffmpeg can convert frames too, but takes four times as long.
"""

import numpy as np
from numpy.typing import NDArray

from anim.compiling import kernel

Bytes = NDArray[np.uint8]
F = np.float32  # with wider numbers LLVM takes fewer pixels at a time

# Luma has 219 levels from 16 on, chroma 224 around 128; the half rounds.
LUMA = tuple(F(share * 219 / 255) for share in (0.2126, 0.7152, 0.0722))
BLUE = tuple(F(share * 224 / 255) for share in (-0.2126 / 1.8556, -0.7152 / 1.8556, 0.5))
RED = tuple(F(share * 224 / 255) for share in (0.5, -0.7152 / 1.5748, -0.0722 / 1.5748))
BLACK, GREY, QUARTER = F(16.5), F(128.5), F(0.25)


@kernel
def planes(frame: Bytes, luma: Bytes, blue: Bytes, red: Bytes) -> None:
    """Write the planes of ``frame`` (height, 3·width).

    Chroma has the value of each pixel, or with half as many rows and columns the mean of each block of four.
    """
    height, width = luma.shape
    for y in range(height):
        row = frame[y]
        for x in range(width):
            r, g, b = F(row[3 * x]), F(row[3 * x + 1]), F(row[3 * x + 2])
            luma[y, x] = np.uint8(np.int32(r * LUMA[0] + g * LUMA[1] + b * LUMA[2] + BLACK))
    for y in range(len(blue)):
        if len(blue) == height:
            row = frame[y]
            for x in range(width):
                r, g, b = F(row[3 * x]), F(row[3 * x + 1]), F(row[3 * x + 2])
                blue[y, x] = np.uint8(np.int32(r * BLUE[0] + g * BLUE[1] + b * BLUE[2] + GREY))
                red[y, x] = np.uint8(np.int32(r * RED[0] + g * RED[1] + b * RED[2] + GREY))
        else:
            row, under = frame[2 * y], frame[2 * y + 1]
            for x in range(width // 2):
                i, j = 6 * x, 6 * x + 3
                r = QUARTER * (F(row[i]) + row[j] + under[i] + under[j])
                g = QUARTER * (F(row[i + 1]) + row[j + 1] + under[i + 1] + under[j + 1])
                b = QUARTER * (F(row[i + 2]) + row[j + 2] + under[i + 2] + under[j + 2])
                blue[y, x] = np.uint8(np.int32(r * BLUE[0] + g * BLUE[1] + b * BLUE[2] + GREY))
                red[y, x] = np.uint8(np.int32(r * RED[0] + g * RED[1] + b * RED[2] + GREY))
