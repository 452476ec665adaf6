"""Words in the corner of a frame: what moves the top, how far it leans, how fast it spins."""

from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from anim.checks import one_of
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


def caption(language: str, motion: str, tilt: float, spin: float) -> tuple[str, ...]:
    """Return the lines that say a motion's formula, its tilt in degrees and its spin in rad/s.

    >>> caption("pl", "product", 12.34, 5.0)
    ('x ↦ (q₂q₁) x (q₂q₁)⁻¹', 'pochylenie 12,3°', 'wirowanie 5,0 rad/s')
    """
    lean, turn, point = WORDS[one_of("captions", language, WORDS)]
    told = (f"{lean} {tilt:.1f}°", f"{turn} {spin:.1f} rad/s")
    said = tuple(line.replace(".", point) for line in told)
    return (FORMULAS[motion], *said) if motion in FORMULAS else said


def write(picture: Pixels, lines: tuple[str, ...]) -> None:
    """Write lines into the upper left corner of a picture (height, width, 3), in place."""
    from PIL import Image, ImageDraw

    height, width = picture.shape[:2]
    letters = max(LEAST, min(height, width) // LETTERS)
    font, edge, step = _font(letters), letters, round(1.45 * letters)
    tall = min(height, 2 * edge + step * len(lines))
    corner = picture[:tall, : round(min(width, 26 * letters))]
    ink = (30, 32, 36) if corner.mean() > 128 else (222, 224, 228)
    image = Image.fromarray(np.ascontiguousarray(corner))
    brush = ImageDraw.Draw(image)
    for n, line in enumerate(lines):
        brush.text((edge, edge + n * step), line, fill=ink, font=font)
    corner[:] = np.asarray(image)


@lru_cache(maxsize=4)
def _font(size: int) -> "FreeTypeFont":
    """Return matplotlib's DejaVu Sans, which has the signs that formulas need."""
    import_matplotlib()
    import matplotlib
    from PIL import ImageFont

    return ImageFont.truetype(
        str(Path(matplotlib.get_data_path()) / "fonts" / "ttf" / "DejaVuSans.ttf"), size
    )
