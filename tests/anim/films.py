"""What the tests of the outputs write, and ffmpeg to read it with; the frames are fixtures of conftest."""

import subprocess
from pathlib import Path

import numpy as np

from anim.output import Film
from anim.output.encoder import ffmpeg

SIZE = (160, 120)
FRAMES = 20
FILM = Film(SIZE, FRAMES, 25)


def decoded(path: Path, size: tuple[int, int] = SIZE) -> np.ndarray:
    """The frames of a video, (frames, height, width, 3), as ffmpeg decodes it."""
    command = [
        ffmpeg(),
        "-loglevel",
        "error",
        "-i",
        str(path),
        "-f",
        "rawvideo",
        "-pix_fmt",
        "rgb24",
        "-",
    ]
    data = subprocess.run(command, capture_output=True, check=True).stdout
    return np.frombuffer(data, np.uint8).reshape(-1, size[1], size[0], 3)


def psnr(a: np.ndarray, b: np.ndarray) -> float:
    return float(-10 * np.log10(np.mean((a / 255.0 - b / 255.0) ** 2)))
