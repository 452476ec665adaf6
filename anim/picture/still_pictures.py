"""The still pictures of sections 3.3 and 3.4: points, skeleton, coloured top, rotated tops.

The thesis numbers two of them, 3.1 and 3.2; those of section 3.3 have no numbers and are named here.
"""

from io import BytesIO
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from anim.errors import AnimationError
from anim.model import APEX_HEIGHT, Model
from anim.picture.painting import painter
from anim.picture.settings import RGB, Camera, RenderSettings
from anim.picture.styles.classic import STYLE as CLASSIC
from rotation.figures.saving import try_folder, write_whole
from rotation.matrices import R_z, to_matrix
from rotation.vectors import from_axis_angle

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]

GREEN: RGB = (0, 140, 60)
RED: RGB = (205, 30, 40)
BLUE: RGB = (31, 90, 180)
POINTS_OF_FIGURES = 10
"""Points of each ring in the figures of section 3.3."""

CAMERA = Camera(elevation=18)
SETTINGS = RenderSettings(style="classic", camera=CAMERA, tilt=15)
LEANING = RenderSettings(style="classic", camera=CAMERA, tilt=45)
NAMES = (
    *("points.png", "skeleton.png", "coloured.png", "turned-about-z.png", "turned-about-both.png"),
    *("figure-3.1.png", "figure-3.2.png"),
)
SPREAD = 0.5
"""The thesis's r in figure 3.2: the horizontal part of the unit vectors that the top is turned about."""


def figures(directory: str | Path, force: bool = True) -> list[Path]:
    """Write the figures as PNG files of 640 × 480 pixels and return their paths.

    The figures are points and skeleton (P₁ green, P₂ red; 10 points per ring); coloured; the same rotated
    about z, and also about a second axis; figure-3.1 (1000 points per ring); and figure-3.2 (four rotations
    by π/2 about axes tilted by 30°, in one picture of twice the size). ``force`` replaces existing files.
    Raises :class:`~hfield.cli.output.OutputError` if the directory cannot be written, and
    :class:`~anim.errors.AnimationError` if the disk is full.
    """
    folder = Path(directory)
    try_folder(folder)
    few, many = Model(ring=POINTS_OF_FIGURES), Model()
    about_z = np.asarray(R_z(np.pi / 5))
    pictures = (
        _points(few),
        _skeleton(few),
        painter(few, SETTINGS).draw(np.eye(3)),
        painter(few, LEANING).draw(about_z),
        painter(few, LEANING).draw(leaning(1) @ about_z),
        painter(many, SETTINGS).draw(np.eye(3)),
        _in_fours(many),
    )
    paths = [folder / name for name in NAMES]
    for path, picture in zip(paths, pictures, strict=True):
        try:
            write_whole(path, _png(picture), force)
        except OSError as error:
            raise AnimationError(f"{str(path)!r} could not be written: {error.strerror}") from None
    return paths


def leaning(i: int) -> Floats:
    """Return the rotation (3, 3) by π/2 about the axis [r·cos xᵢ, r·sin xᵢ, √(1 − r²)], xᵢ = iπ/2."""
    x = i * np.pi / 2
    axis = [SPREAD * np.cos(x), SPREAD * np.sin(x), np.sqrt(1 - SPREAD**2)]
    return np.asarray(to_matrix(from_axis_angle(np.array(axis), np.pi / 2)))


def _points(model: Model) -> Pixels:
    """Draw the base points as dots: P₁ green, P₂ red, tip and apex blue."""
    view, canvas = CLASSIC.scene(model, SETTINGS)
    n = model.ring
    circle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    dot = 4.5 * np.column_stack([np.cos(circle), np.sin(circle)])
    colours = [BLUE, *[GREEN] * n, *[RED] * n, BLUE]
    for place, colour in zip(view.project(model.points), colours, strict=True):
        canvas.fill([place + dot], colour)
    return canvas.rgb()


def _skeleton(model: Model) -> Pixels:
    """Draw the polygons' edges: rings in the colours of their points, the edges between them blue."""
    view, canvas = CLASSIC.scene(model, SETTINGS)
    seen = view.project(model.points)
    n = model.ring
    rings = np.arange(1, n + 1), np.arange(n + 1, 2 * n + 1)
    rims = [np.zeros(n, dtype=int), *rings, np.full(n, 2 * n + 1)]
    for low, high in pairwise(rims):
        canvas.stroke([seen[edge] for edge in np.column_stack([low, high])], BLUE, 1.5)
    for ring, colour in zip(rings, (GREEN, RED), strict=True):
        canvas.stroke([seen[[*ring, ring[0]]]], colour, 2)
    return canvas.rgb()


def _in_fours(model: Model) -> Pixels:
    """Draw figure 3.2: the four rotations in a 2 × 2 grid, with the circle of the apex."""
    around = np.linspace(0, 2 * np.pi, 181)
    height = (leaning(1) @ [0, 0, APEX_HEIGHT])[2]
    radius = np.sqrt(APEX_HEIGHT**2 - height**2)
    path = np.column_stack(
        [radius * np.cos(around), radius * np.sin(around), np.full(len(around), height)]
    )
    settings = RenderSettings(style="classic", camera=CAMERA, tilt=45, trace=True)
    brush = painter(model, settings)
    a, b, c, d = (brush.draw(leaning(i), path) for i in range(1, 5))
    return np.vstack([np.hstack([a, b]), np.hstack([c, d])])


def _png(picture: Pixels) -> bytes:
    from PIL import Image

    out = BytesIO()
    Image.fromarray(picture).save(out, format="PNG")
    return out.getvalue()
