"""The contact sheet: ten frames of a film in one picture, like figures 3.3 and 3.4 of the thesis."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from anim.output.format import Pixels

COLUMNS = 5
PICTURES = 10
GAP = 6  # pixels between pictures
WHITE = 255


def shown(frames: int) -> list[int]:
    """Return the numbers of the frames on the sheet.

    >>> shown(500)
    [0, 49, 99, 149, 199, 249, 299, 349, 399, 449]
    """
    if frames <= PICTURES:
        return list(range(frames))
    ends = {max(frames * k // PICTURES - 1, 0) for k in range(1, PICTURES)}
    return sorted({0} | ends)


def sheet(pictures: Sequence[Pixels], numbers: Sequence[int]) -> Pixels:
    """Return the sheet of ``pictures``, each (height, width, 3), with frame numbers."""
    from PIL import Image, ImageDraw, ImageFont

    height, width = pictures[0].shape[:2]
    size = max(10, height // 24)
    columns = min(COLUMNS, len(pictures))
    rows = -(-len(pictures) // columns)
    whole = np.full(
        (rows * (height + GAP) + GAP, columns * (width + GAP) + GAP, 3), WHITE, np.uint8
    )
    places = []
    for n, picture in enumerate(pictures):
        y, x = (GAP + (n // columns) * (height + GAP), GAP + (n % columns) * (width + GAP))
        whole[y : y + height, x : x + width] = picture
        places.append((x, y))
    image = Image.fromarray(whole)
    draw = ImageDraw.Draw(image)
    font = ImageFont.load_default(size)
    for (x, y), number, picture in zip(places, numbers, pictures, strict=True):
        ink = "black" if picture[: size + 4, : 3 * size].mean() > 127 else "white"
        draw.text((x + size // 2, y + size // 3), str(number), fill=ink, font=font)
    return np.asarray(image)
