"""Captions in a strip above a frame: the model of motion, the tilt and the spin."""

from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from anim.checks import one_of
from anim.errors import AnimationError
from anim.picture.settings import RGB
from hfield.plotting import import_matplotlib

if TYPE_CHECKING:
    from PIL.ImageFont import FreeTypeFont

Pixels = NDArray[np.uint8]

FORMULAS = {
    "quaternions": "x ↦ q₂(q₁ x q₁⁻¹)q₂⁻¹",
    "product": "x ↦ (q₂q₁) x (q₂q₁)⁻¹",
    "matrix": "x ↦ M(q₂q₁) x",
    "euler": "x ↦ R(α, β, γ) R_z(ψ) x",
    "physics": "Iω′ + ω × Iω = mg l × Γ,   q′ = ½ q ω",
    "free": "Iω′ + ω × Iω = Σ s × F,   q′ = ½ q ω",
}
WORDS = {"en": ("tilt", "spin", "."), "pl": ("pochylenie", "wirowanie", ",")}
LETTERS, LEAST = 26, 9
"""The letters' height as a part of the picture's shorter side, and the least in pixels."""
STEP = 1.45
"""From one line to the next, in heights of letters."""
WIDEST = (180.0, -888.8)
"""A tilt and a spin that take as much width as any."""
GAP = "     "


def caption(language: str, motion: str, tilt: float, spin: float) -> tuple[str, ...]:
    """Return caption lines: the formula of a motion, the tilt in degrees and the spin in rad/s.

    >>> caption("pl", "product", 12.34, 5.0)
    ('x ↦ (q₂q₁) x (q₂q₁)⁻¹', 'pochylenie 12,3°', 'wirowanie 5,0 rad/s')
    """
    lean, turn, point = WORDS[one_of("captions", language, WORDS)]
    values = (f"{lean} {tilt:.1f}°", f"{turn} {spin:.1f} rad/s")
    said = tuple(line.replace(".", point) for line in values)
    return (FORMULAS[motion], *said) if motion in FORMULAS else said


def strip(size: tuple[int, int], language: str, motion: str) -> int:
    """Return the height of a caption strip for a picture of ``size`` (width, height).

    Raises :class:`~anim.errors.AnimationError` if it takes more than half of the picture.
    """
    letters = _letters(size)
    rows = _rows(size, caption(language, motion, *WIDEST))
    height = round((STEP * len(rows) + 0.5) * letters)
    longest = max(_font(letters).getlength(row) for row in rows)
    if 2 * height > size[1] or longest + 2 * letters > size[0]:
        raise AnimationError(
            f"captions are too large for a picture of {size[0]}x{size[1]}; try 160x120"
        )
    return height


def captioned(
    picture: Pixels, said: tuple[str, ...], widest: tuple[str, ...], height: int, paper: RGB
) -> Pixels:
    """Return a picture (height, width, 3) with a caption strip of colour ``paper`` above it.

    The lines are laid out like those of ``widest``, so that they do not move from frame to frame.
    """
    from PIL import Image, ImageDraw

    width = picture.shape[1]
    size = width, picture.shape[0] + height
    letters, ink = _letters(size), (30, 32, 36) if sum(paper) > 3 * 128 else (222, 224, 228)
    image = Image.new("RGB", (width, height), paper)
    brush = ImageDraw.Draw(image)
    for n, row in enumerate(_rows(size, widest, said)):
        brush.text((letters, (0.35 + n * STEP) * letters), row, fill=ink, font=_font(letters))
    return np.vstack([np.asarray(image), picture])


def _letters(size: tuple[int, int]) -> int:
    return max(LEAST, min(size) // LETTERS)


def _rows(
    size: tuple[int, int], widest: tuple[str, ...], said: tuple[str, ...] | None = None
) -> list[str]:
    """Return lines as rows, as few as fit: all in one row, or one each, a formula split at its comma."""
    letters = _letters(size)
    width, font = size[0] - 2 * letters, _font(letters)
    shown = widest if said is None else said
    if font.getlength(GAP.join(widest)) <= width:
        return [GAP.join(shown)]
    rows, (first, *rest) = [], widest
    pairs = zip((first, GAP.join(rest)), (shown[0], GAP.join(shown[1:])), strict=True)
    for wide, line in pairs:
        if font.getlength(wide) <= width:
            rows.append(line)
        else:
            rows += [part.strip() for part in line.replace(GAP, ",   ").split(",   ")]
    return rows


@lru_cache(maxsize=4)
def _font(size: int) -> "FreeTypeFont":
    """Return matplotlib's DejaVu Sans, which has the signs that formulas need."""
    import_matplotlib()
    import matplotlib
    from PIL import ImageFont

    return ImageFont.truetype(
        str(Path(matplotlib.get_data_path()) / "fonts" / "ttf" / "DejaVuSans.ttf"), size
    )
