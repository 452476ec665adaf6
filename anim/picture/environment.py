"""The environment of the top, read from `environment.toml`: paper, light, shadow and ground."""

import tomllib
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from anim.picture.projection import View
from anim.picture.settings import RGB, Camera, RenderSettings, colour

Floats = NDArray[np.float64]
Light = NDArray[np.float32]


@cache
def environment() -> dict[str, Any]:
    """Return the description of the environment, as a dict of tables.

    >>> environment()["paper"]["light"]
    '#e9ecef'
    """
    return tomllib.loads((files(__package__) / "environment.toml").read_text(encoding="utf-8"))


def darkness(paper: RGB) -> float:
    """Return the darkness of a paper: 0 for light paper, 1 for dark, smoothly in between."""
    t = min(1.0, max(0.0, (paper[1] / 255 - 0.2) / 0.4))
    return 1 - t * t * (3 - 2 * t)


def of_darkness(table: str, name: str, dark: float) -> float:
    """Return a number of the environment, interpolated for a paper of darkness ``dark``."""
    light, other = float(environment()[table][name]), float(environment()["dark"][name])
    return light + dark * (other - light)


def trace_of(paper: RGB) -> RGB:
    """Return the colour of the apex's path on a paper."""
    shown: RGB = colour(
        "trace", environment()["trace"]["dark" if darkness(paper) > 0.5 else "light"]
    )
    return shown


def ground(view: View, settings: RenderSettings, paper: RGB) -> Light:
    """Return the empty ground and the background behind it, float32 (height, width, 3), from 0 to 255."""
    from anim.picture.ground_kernels import lit_ground

    width, height = settings.size
    picture = np.empty((height, width, 3), np.float32)
    numbers = environment()["ground"]
    lit_ground(
        picture,
        to_ground(view, height),
        np.array(paper, dtype=np.float64),
        darkness(paper),
        np.array([numbers[n] for n in ("near", "far", "shade", "pool", "ring")]),
        bool(view.eye[2] > 0),
    )
    return picture


def to_ground(view: View, height: int) -> Floats:
    """Return the map (3, 3) from pixels, y downwards, to the ground: (x, y, 1) divided by the depth."""
    rows = view.matrix[np.ix_([0, 1, 3], [0, 1, 3])]
    flip = np.array([[1.0, 0, 0], [0, -1, height], [0, 0, 1]])
    if abs(np.linalg.det(rows)) < 1e-9 * np.abs(rows).max() ** 2:  # seen from its side
        return np.zeros((3, 3))
    return np.asarray(np.linalg.inv(rows) @ flip)


def direction(camera: Camera) -> Floats:
    """Return the unit vector (3,) towards the distant light."""
    a = np.radians(camera.azimuth + environment()["light"]["aside"])
    e = np.radians(environment()["light"]["height"])
    return np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
