"""Drawing the top: our painters against a fresh matplotlib figure and a PNG file for each frame.

    python benchmarks/top_drawing.py [FRAMES]

The other way is what the thesis describes (section 3.4): for each frame a new figure, the 3000 polygons as
one ``Poly3DCollection``, and ``savefig``; here into memory, so that no disk counts. Ours returns raw
frames. Both are measured in CPU time of this process, after one frame of warming up, best of three
rounds; the other way draws fewer frames, since a frame of it takes as long as twenty or more of ours.
"""

import io
import sys
import time
from collections.abc import Callable

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray

from anim.model import Model
from anim.picture import STYLES, RenderSettings, painter

Floats = NDArray[np.float64]

SIZES = ((640, 480), (1920, 1080))
OTHER_FRAMES = 8
TILT = 30.0


def attitudes(count: int) -> list[Floats]:
    """Return rotations that spin, precess and lean more and more, as in the thesis's film."""
    return [
        about(2, 32 * np.pi * x) @ about(1, np.radians(TILT) * x) @ about(2, 200 * x)
        for x in np.linspace(0, 1, count)
    ]


def about(axis: int, angle: float) -> Floats:
    """Return the rotation about a coordinate axis."""
    i, j = ((1, 2), (2, 0), (0, 1))[axis]
    matrix = np.eye(3)
    matrix[i, i] = matrix[j, j] = np.cos(angle)
    matrix[j, i] = np.sin(angle)
    matrix[i, j] = -matrix[j, i]
    return matrix


def thesis_frame(model: Model, matrix: Floats, size: tuple[int, int]) -> None:
    """Draw one frame the thesis's way."""
    points = model.points @ matrix.T
    figure = Figure(figsize=(size[0] / 100, size[1] / 100), dpi=100)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot(projection="3d")
    axes.set(xlim=(-1.5, 1.5), ylim=(-1.5, 1.5), zlim=(0, 3))
    faces = [*points[model.lower], *points[model.sides], *points[model.upper]]
    colours = [("yellow", "black")[band % 2] for band in model.polygon_bands]
    axes.add_collection3d(Poly3DCollection(faces, facecolors=colours))
    figure.savefig(io.BytesIO(), format="png")


def milliseconds(draw: Callable[[Floats], object], matrices: list[Floats]) -> float:
    """Return the CPU time a frame, the best of three rounds."""
    draw(matrices[0])
    rounds = []
    for _ in range(3):
        start = time.process_time()
        for matrix in matrices:
            draw(matrix)
        rounds.append((time.process_time() - start) / len(matrices) * 1e3)
    return min(rounds)


def main(frames: int) -> None:
    """Print one line a size and style."""
    model, ours, theirs = Model(), attitudes(frames), attitudes(OTHER_FRAMES)
    trail = np.array([matrix @ [0, 0, 3] for matrix in attitudes(500)])
    print(f"{'size':>10}  {'picture':>22}  {'ms':>6}  {'fps':>4}  times less than the thesis's way")
    for size in SIZES:
        other = milliseconds(lambda m, size=size: thesis_frame(model, m, size), theirs)
        name = f"{size[0]}x{size[1]}"
        print(f"{name:>10}  {'a figure and PNG each':>22}  {other:>6.1f}  {1e3 / other:>4.0f}  1")
        for style in STYLES:
            for more in (False, True):
                brush = painter(
                    model,
                    RenderSettings(size=size, style=style, tilt=TILT, trace=more, shadow=more),
                )
                ms = milliseconds(lambda m, brush=brush: brush.draw(m, trail), ours)
                label = style + (", trace, shadow" if more else "")
                print(f"{name:>10}  {label:>22}  {ms:>6.2f}  {1e3 / ms:>4.0f}  {other / ms:.0f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
