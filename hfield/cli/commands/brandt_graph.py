"""The graph of a Brandt matrix: a layout by distances in the graph, arrows, multiplicities, weights."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import atan2, cos, pi, sin, sqrt
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hfield.plotting import (
    DARK,
    LIGHT,
    Theme,
    default_settings,
    save_figure,
    titled_page,
)

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MAX_NUMBERED_EDGES = 150
"""Of a graph of more edges no multiplicities are written, and no arrows drawn."""
STEPS = 300
"""Of the iteration that lays the graph out."""
WIDTH, BOX = 7.0, 5.4
"""Of the page, and of the square that the vertices fit into, in inches."""
ABOVE, BELOW = 1.45, 1.75
"""The least distances of vertices from the ends of the page, in inches: room for title and legend."""
LONGEST_STEP = 2.0
"""The greatest distance of neighbours, in inches."""
FIXED, PAIRED = ("#2f6fb5", "#6aa5e8"), ("#c4661f", "#f0a35e")
"""Colours of vertices, on light and on dark pages."""


@dataclass(frozen=True)
class BrandtGraph:
    """The graph of a Brandt matrix: ``matrix[i][j]`` arrows from i to j, and the number of units of each
    vertex.

    ``arrows`` describes what an arrow means. ``conjugates`` gives for each supersingular curve the vertex of
    its Frobenius conjugate, for a prime discriminant and level 1; None otherwise.
    """

    matrix: Sequence[Sequence[int]]
    units: Sequence[int]
    title: str
    arrows: str = "ideals"
    conjugates: Sequence[int] | None = None


@default_settings()
def draw(graph: BrandtGraph, path: Path, dark: bool = False) -> None:
    """Write the picture. Raises OSError, and ValueError for an unknown suffix."""
    save_figure(figure(graph, dark), path)


@default_settings()
def figure(graph: BrandtGraph, dark: bool = False) -> Figure:
    """Return the picture as a matplotlib figure."""
    colors = DARK if dark else LIGHT
    places = layout(graph.matrix)
    wide, high = (places.max(axis=0) - places.min(axis=0)).tolist()
    scale = min(BOX / max(wide, high, 1e-9), LONGEST_STEP)
    height = ABOVE + high * scale + BELOW
    page, axes = titled_page(colors, graph.title, _facts(graph), (WIDTH, height))
    axes.set_position((0, 0, 1, 1))
    axes.set(xlim=(0, WIDTH), ylim=(0, height))
    middle = (places.max(axis=0) + places.min(axis=0)) / 2
    points = (places - middle) * scale + (WIDTH / 2, BELOW + high * scale / 2)
    _Drawing(axes, graph, points, colors, dark).draw()
    return page


def _facts(graph: BrandtGraph) -> str:
    edges = sum(1 for i, j in _edges(graph.matrix) if i != j)
    loops = sum(1 for n, row in enumerate(graph.matrix) if row[n])
    degrees = sorted({sum(row) for row in graph.matrix})
    counts = (
        (len(graph.matrix), "class", "classes"),
        (edges, "pair of neighbours", "pairs of neighbours"),
        (loops, "vertex with loops", "vertices with loops"),
    )
    words = [f"{count} {one if count == 1 else more}" for count, one, more in counts]
    return " · ".join((*words, f"out-degree {', '.join(map(str, degrees))}"))


def _edges(matrix: Sequence[Sequence[int]]) -> Iterator[tuple[int, int]]:
    """Yield the pairs of neighbours, i ≤ j."""
    for i, row in enumerate(matrix):
        for j in range(i, len(row)):
            if row[j] or matrix[j][i]:
                yield i, j


# --- layout ---------------------------------------------------------------------------------------


def layout(matrix: Sequence[Sequence[int]]) -> np.ndarray:
    """Return a position (x, y) for each vertex, with distances close to those in the graph.

    The stress Σ (|x_i − x_j|/d_ij − 1)² is minimised by majorisation (Gansner, Koren and North, 2004), from
    two deterministic starts: a circle in breadth-first order, and classical scaling. The long axis is
    horizontal, with the first vertex at its left end.
    """
    import numpy as np

    distances, order = _distances(matrix)
    count = len(matrix)
    if count == 1:
        return np.zeros((1, 2))
    circle = np.empty((count, 2))
    for n, vertex in enumerate(order):
        circle[vertex] = cos(2 * pi * n / count), sin(2 * pi * n / count)
    starts = (circle * distances.max() / 2, _scaled(distances))
    found = [_majorised(distances, start) for start in starts]
    stresses = [round(_stress(distances, places), 6) for places in found]
    places = found[stresses.index(min(stresses))]
    places = places - places.mean(axis=0)
    places = places @ np.linalg.svd(places, full_matrices=False)[2].T
    signs = [
        1.0 if places[int(abs(way).argmax()), n] > 0 else -1.0 for n, way in enumerate(places.T)
    ]
    places = places * signs
    if places[0, 0] > 1e-6:
        places[:, 0] *= -1
    rounded: np.ndarray = np.round(places, 3) + 0.0
    return rounded


def _distances(matrix: Sequence[Sequence[int]]) -> tuple[np.ndarray, list[int]]:
    """Return the distances in the graph, and the vertices in the order of a breadth-first search from 0.

    The distance between components is one more than the greatest distance inside them.
    """
    import numpy as np

    count = len(matrix)
    adjacent = np.array([[x != 0 for x in row] for row in matrix])
    adjacent |= adjacent.T
    distances = np.where(np.eye(count, dtype=bool), 0, -1)
    sphere, step = np.eye(count, dtype=bool), 0
    while sphere.any():
        step += 1
        sphere = ((sphere.astype(np.float32) @ adjacent) > 0) & (distances < 0)
        distances[sphere] = step
    distances[distances < 0] = step
    order: list[int] = np.argsort(distances[0], kind="stable").tolist()
    return distances.astype(float), order


def _scaled(distances: np.ndarray) -> np.ndarray:
    """Return the classical multidimensional scaling, which unfolds long chains."""
    import numpy as np

    squares = distances**2
    centred = -(squares - squares.mean(axis=0) - squares.mean(axis=1)[:, None] + squares.mean()) / 2
    values, vectors = np.linalg.eigh(centred)
    places: np.ndarray = vectors[:, -2:] * np.sqrt(np.maximum(values[-2:], 1e-3))
    # points of a symmetric graph that fall together are moved apart
    turn = np.arange(len(distances)) * 2.4
    return places + 0.05 * np.column_stack([np.cos(turn), np.sin(turn)])


def _majorised(distances: np.ndarray, places: np.ndarray) -> np.ndarray:
    import numpy as np

    count = len(distances)
    inverse = 1 / np.where(distances > 0, distances, np.inf)
    weights = inverse**2
    laplacian = np.diag(weights.sum(axis=1)) - weights
    solve = np.linalg.inv(laplacian + 1 / count) - 1 / count
    for _ in range(STEPS):
        apart = np.linalg.norm(places[:, None] - places, axis=-1)
        ratio = inverse / np.where(apart > 1e-9, apart, np.inf)
        places = solve @ ((np.diag(ratio.sum(axis=1)) - ratio) @ places)
    return places


def _stress(distances: np.ndarray, places: np.ndarray) -> float:
    import numpy as np

    apart = np.linalg.norm(places[:, None] - places, axis=-1)
    off = distances > 0
    return float((((apart - distances) / np.where(off, distances, 1))[off] ** 2).sum())


# --- drawing, in inches ---------------------------------------------------------------------------


class _Drawing:
    def __init__(
        self, axes: Axes, graph: BrandtGraph, points: np.ndarray, colors: Theme, dark: bool
    ) -> None:
        self.axes, self.graph, self.points = axes, graph, points
        self.colors, self.dark = colors, dark
        self.edges = list(_edges(graph.matrix))
        self.numbered = len(self.edges) <= MAX_NUMBERED_EDGES
        self.radius = min(0.15, max(0.035, 0.9 / sqrt(len(points))))
        self.least = min(graph.units)

    def draw(self) -> None:
        for i, j in self.edges:
            if i == j:
                self.loop(i, self.graph.matrix[i][i])
            else:
                self.edge(i, j)
        for n, point in enumerate(self.points):
            self.vertex(point, self.graph.units[n], self.is_paired(n), str(n))
        self.legend()

    def is_paired(self, n: int) -> bool:
        return self.graph.conjugates is not None and self.graph.conjugates[n] != n

    def size(self, units: int) -> float:
        """Return the radius of a vertex: its area is proportional to the number of units."""
        return self.radius * min(sqrt(units / self.least), 2.5)

    def vertex(self, place: tuple[float, float], units: int, paired: bool, text: str = "") -> None:
        from matplotlib.patches import Circle

        radius = self.size(units)
        color = (PAIRED if paired else FIXED)[self.dark]
        self.axes.add_patch(
            Circle(place, radius, facecolor=color, edgecolor=self.colors.page, lw=1, zorder=3)
        )
        letters = 72 * radius * (1.0 if len(text) < 3 else 0.75)
        self.axes.text(*place, text, ha="center", va="center_baseline", fontsize=letters,
                       color=self.colors.page, zorder=4)  # fmt: skip

    def edge(self, i: int, j: int) -> None:
        there, back = self.graph.matrix[i][j], self.graph.matrix[j][i]
        if there == back or not self.numbered:
            self.line(self.points[i], self.points[j], max(there, back))
            return
        for start, end, count in ((i, j, there), (j, i, back)):
            if count:
                self.arrow(self.points[start], self.points[end], count, self.size(self.graph.units[start]),
                           self.size(self.graph.units[end]))  # fmt: skip

    def line(self, start: np.ndarray, end: np.ndarray, count: int) -> None:
        alpha = 1.0 if self.numbered else max(0.15, min(0.8, 60 / sqrt(len(self.edges) * 30)))
        self.axes.plot(*zip(start, end, strict=True), color=self.colors.quiet, linewidth=1.1,
                       alpha=alpha, zorder=1, solid_capstyle="butt")  # fmt: skip
        if count > 1 and self.numbered:
            self.number((start + end) / 2, count)

    def arrow(
        self, start: np.ndarray, end: np.ndarray, count: int, before: float, after: float
    ) -> None:
        import numpy as np
        from matplotlib.patches import FancyArrowPatch
        from matplotlib.path import Path as Curve

        way = end - start
        across = np.array([way[1], -way[0]]) * 0.2
        control = (start + end) / 2 + across
        first, last = control - start, control - end
        begin = start + first / np.linalg.norm(first) * before
        tip = end + last / np.linalg.norm(last) * (after + 0.02)
        self.axes.add_patch(
            FancyArrowPatch(
                path=Curve([begin, control, tip], [Curve.MOVETO, Curve.CURVE3, Curve.CURVE3]),
                arrowstyle="-|>,head_length=5,head_width=2.4",
                facecolor=self.colors.quiet,
                edgecolor=self.colors.quiet,
                linewidth=1.1,
                shrinkA=0,
                shrinkB=0,
                zorder=1,
            )
        )
        if count > 1:
            self.number((begin + tip) / 4 + control / 2, count)

    def loop(self, n: int, count: int) -> None:
        from matplotlib.patches import Circle

        angle = self.free_angle(n)
        own = self.size(self.graph.units[n])
        radius = max(0.11, own) if self.numbered else own
        x, y = self.points[n]
        away = own + 0.75 * radius
        place = (x + away * cos(angle), y + away * sin(angle))
        self.axes.add_patch(
            Circle(place, radius, facecolor="none", edgecolor=self.colors.quiet, lw=1.1, zorder=1)
        )
        if count > 1 and self.numbered:
            far = away + radius
            self.number((x + far * cos(angle), y + far * sin(angle)), count)

    def free_angle(self, n: int) -> float:
        """Return the middle of the widest angle without an edge at a vertex."""
        x, y = self.points[n]
        neighbours = [i + j - n for i, j in self.edges if n in (i, j) and i != j]
        angles = sorted(atan2(self.points[m][1] - y, self.points[m][0] - x) for m in neighbours)
        if not angles:
            return pi / 2
        ends = [*angles[1:], angles[0] + 2 * pi]
        gap, start = max((round(e - a, 6), a) for a, e in zip(angles, ends, strict=True))
        return start + gap / 2

    def number(self, place: Sequence[float], count: int) -> None:
        x, y = place
        self.axes.text(x, y, str(count), ha="center", va="center", fontsize=8.5, zorder=2,
                       color=self.colors.ink, bbox={"facecolor": self.colors.page, "edgecolor": "none",
                       "boxstyle": "round,pad=0.12"})  # fmt: skip

    # --- legend ---

    def legend(self) -> None:
        """Draw a legend of sizes, colours and arrows below the graph."""
        left, y = 0.45, 0.27
        self.say(left, y, self.reading())
        if any(map(self.is_paired, range(len(self.points)))):
            y, x = y + 0.32, left + self.radius
            for paired, text in (
                (False, "curve over the prime field"),
                (True, "one of two conjugate curves"),
            ):
                self.vertex((x, y), self.least, paired)
                x = self.say(x + self.radius + 0.08, y, text) + self.radius + 0.3
        y += 0.2 + self.size(max(self.graph.units))
        x = self.say(left, y, "units of the left order:")
        for units in sorted(set(self.graph.units)):
            x += self.size(units) + 0.12
            self.vertex((x, y), units, False)
            x = self.say(x + self.size(units) + 0.06, y, str(units))

    def reading(self) -> str:
        if self.numbered:
            arrows = self.graph.arrows
            return f"line: as many {arrows} there as back; arrow: only that way; number: how many, if not 1"
        return "line: neighbours; numbers and directions are left out, --format edges lists them"

    def say(self, x: float, y: float, text: str) -> float:
        """Write a text that starts at x, and return the position where it ends."""
        written = self.axes.text(
            x, y, text, ha="left", va="center", fontsize=9, color=self.colors.ink
        )
        canvas: Any = self.axes.figure.canvas  # of Agg, which has a renderer
        box = written.get_window_extent(canvas.get_renderer())
        return float(box.x1 / self.axes.figure.dpi)
