"""Choose the 256 colours of a GIF from sampled frames, so that one pass over the film suffices."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from anim.output.format import Pixels

SAMPLES = 8
MAX_COLUMNS = 2_000_000  # pixels looked at


def sampled(frames: int) -> list[int]:
    """Return the numbers of the frames from which the palette is made, evenly spaced over the film."""
    return sorted({round(k * (frames - 1) / max(SAMPLES - 1, 1)) for k in range(SAMPLES)})


def write_palette(path: Path, frames: Sequence[Pixels]) -> None:
    """Write the palette of several frames, as a picture of 16 × 16 pixels.

    The most frequent colours are included unchanged, so that flat surfaces keep theirs; the rest is chosen by
    median cut.
    """
    from PIL import Image

    pixels = np.concatenate([frame.reshape(-1, 3) for frame in frames])
    pixels = pixels[:: 1 + len(pixels) // MAX_COLUMNS].astype(np.uint32)
    packed = pixels[:, 0] << 16 | pixels[:, 1] << 8 | pixels[:, 2]
    colours, counts = np.unique(packed, return_counts=True)
    common = colours[np.argsort(-counts, kind="stable")][:128]
    rest = colours[~np.isin(colours, common)] if len(colours) > 256 else colours[:0]
    chosen = _unpacked(common if len(rest) else colours)
    if len(rest):
        image = Image.fromarray(_unpacked(rest).reshape(1, -1, 3), "RGB")
        cut = image.quantize(256 - len(chosen), Image.Quantize.MEDIANCUT).getpalette() or []
        chosen = np.concatenate([chosen, np.array(cut, dtype=np.uint8).reshape(-1, 3)])[:256]
    full = np.resize(chosen, (256, 3)) if len(chosen) else np.zeros((256, 3), np.uint8)
    Image.fromarray(full.reshape(16, 16, 3), "RGB").save(path)


def _unpacked(colours: np.ndarray) -> np.ndarray:
    return np.stack([colours >> 16, colours >> 8 & 255, colours & 255], axis=-1).astype(np.uint8)
