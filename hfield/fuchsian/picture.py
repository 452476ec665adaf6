"""A Dirichlet domain in Poincaré's disc, its images around it coloured by words."""

from __future__ import annotations

import colorsys
from collections import deque
from io import StringIO
from typing import TYPE_CHECKING, Any

import numpy as np

from hfield.errors import LatticeError, shorten
from hfield.fuchsian.plane import Motion, Plane, Vector

if TYPE_CHECKING:
    from hfield.fuchsian.group import Domain

TILES = 1200
"""So many images are drawn at most."""
SMALLEST = 0.012
"""Images of a smaller diameter in the unit disc are left out."""
STEPS = 9
"""Points on a side of a far image; near ones have four times as many."""
LIGHT = {
    "page": "#ffffff",
    "disc": "#f4f5f8",
    "ink": "#1d2433",
    "edge": "#ffffff",
    "domain": "#ffffff",
}
DARK = {
    "page": "#11141b",
    "disc": "#1a1f2a",
    "ink": "#eef1f7",
    "edge": "#11141b",
    "domain": "#1f2633",
}


def draw(domain: Domain, path: object, *, dark: bool, depth: int | None) -> None:
    """Draw a domain to a file. Raises :class:`LatticeError` where it cannot be written."""
    figure = _figure(domain, dark, depth)
    try:
        figure.savefig(str(path), facecolor=figure.get_facecolor(), dpi=160)
    except (OSError, ValueError) as error:
        raise LatticeError(
            f"cannot draw to {shorten(path)!r}: {error}; try a file .svg, .png or .pdf"
        ) from error


def svg(domain: Domain) -> str:
    """Return the picture as SVG."""
    file = StringIO()
    _figure(domain, False, None).savefig(file, format="svg")
    return file.getvalue()


def _figure(domain: Domain, dark: bool, depth: int | None) -> Any:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.collections import PolyCollection
    from matplotlib.figure import Figure
    from matplotlib.patches import Circle

    look = DARK if dark else LIGHT
    figure = Figure(figsize=(7, 7.7), facecolor=look["page"])
    FigureCanvasAgg(figure)
    axes: Any = figure.add_axes((0.02, 0.005, 0.96, 0.909))
    axes.set_aspect("equal")
    axes.set_xlim(-1.03, 1.03)
    axes.set_ylim(-1.03, 1.03)
    axes.axis("off")
    axes.add_patch(Circle((0, 0), 1, facecolor=look["disc"], edgecolor="none", zorder=0))
    outline, corners = _sides(domain, 4 * STEPS)
    hues = _hues(domain)
    tiles, colors = [], []
    for motion, first, length, size in _tiles(domain, outline, depth):
        fine = outline[:, :, :: 1 if length == 1 else 4 if size > 0.15 else 12]
        tiles.append(_disc(motion @ fine.reshape(3, -1)))
        colors.append(_shade(hues[first], length, dark))
    axes.add_collection(
        PolyCollection(tiles, facecolors=colors, edgecolors=look["edge"], linewidths=0.35, zorder=1)
    )
    own = _disc(outline.reshape(3, -1))
    axes.fill(*own.T, facecolor=look["domain"], edgecolor="none", zorder=2)
    axes.add_patch(
        Circle((0, 0), 1, facecolor="none", edgecolor=look["ink"], linewidth=1.1, zorder=3)
    )
    for n in range(len(domain.partners)):
        line = _disc(np.concatenate([outline[:, n], corners[:, n + 1 : n + 2]], axis=1))
        axes.plot(
            *line.T, color=_shade(hues[n], 0, dark), linewidth=2.6, solid_capstyle="round", zorder=4
        )
    _mark(axes, domain, outline, corners, look)
    _write(figure, domain, look)
    return figure


def _write(figure: Any, domain: Domain, look: dict[str, str]) -> None:
    group = domain.group
    signature = group.signature
    order = group.order
    orders = ", ".join(map(str, signature.orders))
    elliptic = f"elliptic points of order {orders}" if orders else "no elliptic points"
    cusps = f" · {signature.cusps} cusp{'s' * (signature.cusps > 1)}" if signature.cusps else ""
    title = f"Units of norm 1, {order.title} in {order.algebra}"
    figure.text(0.5, 0.966, title, ha="center", va="center",
                color=look["ink"], fontsize=min(14, 700 / len(title)))  # fmt: skip
    figure.text(0.5, 0.932, f"genus {signature.genus} · {elliptic}{cusps} · "
                f"area 2π·{group.area} · {len(domain.partners)} sides",
                ha="center", va="center", color=look["ink"], fontsize=10, alpha=0.75)  # fmt: skip


def _mark(axes: Any, domain: Domain, outline: Any, corners: Any, look: dict[str, str]) -> None:
    """Mark the centre, and elliptic points: diamonds for order 2, triangles for order 3."""
    markers = {2: "D", 3: "^"}
    points = [(corners[:, n : n + 1], order) for n, order in _orders(domain) if order > 1]
    points += [(_middle(corners[:, n : n + 2]), 2) for n, p in enumerate(domain.partners) if n == p]
    for point, order in points:
        x, y = _disc(point)[0]
        axes.plot([x], [y], marker=markers.get(order, "o"), markersize=6.5 if order == 2 else 8,
                  color=look["ink"], markeredgecolor=look["domain"], zorder=6)  # fmt: skip
    axes.plot([0], [0], marker="o", markersize=3.5, color=look["ink"], zorder=6)


def _orders(domain: Domain) -> list[tuple[int, int]]:
    """Return each vertex with the order of its stabiliser."""
    found = []
    for cycle in domain.cycles:
        n = cycle.start
        for side in cycle.sides:
            found.append((n, cycle.order))
            n = (domain.partners[side] + 1) % len(domain.partners)
    return found


def _hues(domain: Domain) -> list[float]:
    """Return a hue for each side, one for a pair, neighbours far apart on the circle of colours."""
    firsts = [min(n, p) for n, p in enumerate(domain.partners)]
    number = {first: k for k, first in enumerate(sorted(set(firsts)))}
    return [(0.58 + 0.381966 * number[first]) % 1 for first in firsts]


def _shade(hue: float, length: int, dark: bool) -> tuple[float, float, float]:
    """Return a colour for words of a length that begin with a side; length 0 is the side itself."""
    if length == 0:
        return colorsys.hls_to_rgb(hue, 0.62 if dark else 0.45, 0.72)
    if dark:
        return colorsys.hls_to_rgb(hue, max(0.18, 0.44 - 0.07 * length), 0.42)
    return colorsys.hls_to_rgb(hue, min(0.93, 0.70 + 0.055 * length), 0.55)


# --- floats: points are columns, on the hyperboloid x² − y² − z² or beside it ----------------------------


def _column(plane: Plane, x: Vector) -> list[float]:
    return list(plane.floats((x[0] / x[0], x[1] / x[0], x[2] / x[0])))


def _matrix(plane: Plane, motion: Motion) -> Any:
    stretch = np.array([1.0, *plane.stretch])
    return (
        np.array([list(map(plane.order.real, row)) for row in motion]) * stretch[:, None] / stretch
    )


def _disc(points: Any) -> Any:
    """Return columns as rows in Poincaré's disc."""
    q = points[1:] / points[0]
    return (q / (1 + np.sqrt(np.maximum(0.0, 1 - (q * q).sum(axis=0))))).T


def _middle(ends: Any) -> Any:
    """Return the middle of a side in the plane."""
    size = np.sqrt(ends[0] ** 2 - (ends[1:] ** 2).sum(axis=0))
    return (ends / size).sum(axis=1, keepdims=True)


def _sides(domain: Domain, steps: int) -> tuple[Any, Any]:
    """Return points on all sides, (3, sides, points), and the corners, the first one again at the end."""
    plane = domain.polygon.plane
    corners = np.array([_column(plane, x) for x in domain.polygon.starts]).T
    corners = np.concatenate([corners, corners[:, :1]], axis=1)
    along = (1 - np.cos(np.linspace(0, np.pi, steps, endpoint=False))) / 2  # denser at the ends
    return corners[:, :-1, None] * (1 - along) + corners[:, 1:, None] * along, corners


def _tiles(domain: Domain, outline: Any, depth: int | None) -> list[tuple[Any, int, int, float]]:
    """Return images of the domain: the motion, the first side of its word, the word's length, the size."""
    plane, count = domain.polygon.plane, len(domain.partners)
    # across side n lies the image by its unit
    steps = [_matrix(plane, plane.motion(unit)) for unit in domain.polygon.units]
    seen = {(0.0, 0.0)}
    found: list[tuple[Any, int, int, float]] = []
    queue: deque[tuple[Any, int, int, float]] = deque([(np.eye(3), -1, 0, 2.0)])
    while queue and len(found) < TILES:
        motion, first, length, _ = queue.popleft()
        for n in range(count if depth is None or length < depth else 0):
            image = motion @ steps[n]
            center = _disc(image[:, :1])[0]
            key = (round(float(center[0]), 6), round(float(center[1]), 6))
            if key in seen:
                continue
            seen.add(key)
            points = _disc(image @ outline[:, :, 0])
            size = float(np.ptp(points, axis=0).max())
            if size >= SMALLEST and len(found) < TILES:
                tile = (image, n if first < 0 else first, length + 1, size)
                found.append(tile)
                queue.append(tile)
    return found
