"""Pictures of finite algebras: products and norms as coloured squares, ideals, and graphs."""

from __future__ import annotations

import colorsys
from collections.abc import Sequence
from math import ceil, cos, pi, sin, sqrt
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Parent
from hfield.core.files import whole_file
from hfield.errors import CoercionError, HFieldError, TooLargeError, shorten
from hfield.exploring.graphs import KINDS, numbered_edges
from hfield.exploring.ideals import AlgebraIdeal, ideals
from hfield.exploring.labels import LabelledAlgebra, labelled
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
    from matplotlib.figure import Figure

SIDES = {
    "ideals": "left",
    "left-ideals": "left",
    "right-ideals": "right",
    "two-sided-ideals": "two-sided",
}
PICTURES = ("product", "norm", *SIDES, *KINDS)
"""What can be drawn."""
MAX_ROWS = 1300
"""The greatest number of elements in a table of products."""
MAX_NODES = 200
"""The greatest number of ideals, or of vertices of a graph, that are drawn."""
MAX_EDGES = 20_000
"""The greatest number of edges that are drawn."""
PAGE_SIZE = 7, 7.7
"""In inches."""
NAMED = 14
"""So many ideals in a row have names."""


class PictureError(HFieldError, OSError):
    """A picture cannot be written."""


@default_settings()
def draw(algebra: Parent, path: object, what: str, dark: bool) -> None:
    """Draw to a .svg, .png or .pdf file.

    Raises :class:`CoercionError` for an unknown picture, :class:`PictureError` if the file cannot be written,
    :class:`NotFiniteError`, and :class:`TooLargeError` if the picture would be too large to read.
    """
    drawn = figure(algebra, what, dark)
    try:
        with whole_file(Path(str(path))) as part:
            save_figure(drawn, part)
    except (OSError, ValueError) as error:
        raise PictureError(
            f"cannot draw to {shorten(path)!r}: {error}; try a file name that ends in .svg, .png or .pdf"
        ) from error


@default_settings()
def figure(algebra: Parent, what: str, dark: bool) -> Figure:
    """Return the picture as a matplotlib figure."""
    if what not in PICTURES:
        raise CoercionError(
            f"there is no picture {what!r}: expected one of {', '.join(map(repr, PICTURES))}"
        )
    theme = DARK if dark else LIGHT
    if what in SIDES:
        return _hasse(algebra, ideals(algebra, SIDES[what]), theme)
    labels = labelled(algebra)
    if what == "product":
        return _products(labels, theme)
    if what == "norm":
        return _norms(labels, theme)
    return _graph(labels, what, theme)


# --- squares --------------------------------------------------------------------------------------


def _hues(count: int) -> list[float]:
    """Return hues such that neighbouring ones differ strongly."""
    return [(0.58 + 0.381966 * n) % 1 for n in range(count)]


def _colors(labels: LabelledAlgebra, theme: Theme) -> np.ndarray:
    """Return a colour for each element: hue by norm, lightness by position among the elements of this norm; 0
    is dark.
    """
    import numpy as np

    everything = np.arange(labels.size)
    norms = labels.norm(labels.rows(everything))
    hues = _hues(labels.q)
    low, high = theme.lightness
    colors = np.zeros((labels.size, 3))
    for n in range(labels.q):
        members = np.flatnonzero(norms == n)
        for place, member in enumerate(members):
            light = low + (high - low) * (place + 0.5) / len(members)
            colors[member] = colorsys.hls_to_rgb(hues[n], light, 0.55 if n else 0.12)
    colors[0] = [int(theme.zero[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    return colors


def _products(labels: LabelledAlgebra, theme: Theme) -> Figure:
    import numpy as np

    if labels.size > MAX_ROWS:
        raise TooLargeError(
            f"{labels.algebra} has {labels.size} elements, and a table of products is drawn for at most "
            f"{MAX_ROWS}: draw the norm, what='norm'"
        )
    everything = np.arange(labels.size)
    norms = labels.norm(labels.rows(everything))
    order = np.lexsort((everything, norms))
    table = labels.products(order[:, None], order[None, :])
    title = f"Products in {labels.algebra}"
    below = (
        "row · column, sorted by norm; hue: norm of the product, shade: which element, darkest: 0"
    )
    page, axes = titled_page(theme, title, below, PAGE_SIZE)
    axes.imshow(_colors(labels, theme)[table], interpolation="none")
    for end in np.flatnonzero(np.diff(norms[order])):
        for line in (axes.axhline, axes.axvline):
            line(end + 0.5, color=theme.page, linewidth=0.8)
    return page


def _norms(labels: LabelledAlgebra, theme: Theme) -> Figure:
    import numpy as np

    size = labels.q**2
    norms = labels.norm(labels.rows(np.arange(labels.size))).reshape(size, size)
    low, high = theme.lightness
    palette = [colorsys.hls_to_rgb(hue, (low + high) / 2, 0.6) for hue in _hues(labels.q)]
    palette[0] = tuple(int(theme.zero[k : k + 2], 16) / 255 for k in (1, 3, 5))  # type: ignore[assignment]
    title = f"Norms in {labels.algebra}"
    below = "down: the coordinates of 1 and i, to the right: those of j and k; darkest: norm 0"
    page, axes = titled_page(theme, title, below, PAGE_SIZE)
    axes.imshow(np.array(palette)[norms], interpolation="none")
    for step in range(labels.q, size, labels.q):
        for line in (axes.axhline, axes.axvline):
            line(step - 0.5, color=theme.page, linewidth=0.8)
    return page


# --- ideals ---------------------------------------------------------------------------------------


def _hasse(algebra: Parent, found: Sequence[AlgebraIdeal], theme: Theme) -> Figure:
    if len(found) > MAX_NODES:
        raise TooLargeError(f"{algebra} has {len(found)} ideals, and at most {MAX_NODES} are drawn")
    levels = sorted({ideal.length for ideal in found})
    rows = {n: [ideal for ideal in found if ideal.length == n] for n in levels}
    places: dict[AlgebraIdeal, tuple[float, float]] = {}
    for height, d in enumerate(levels):
        row = rows[d]
        for n, ideal in enumerate(row):
            places[ideal] = ((n + 0.5) / len(row), height / max(len(levels) - 1, 1))
    side = found[0].side.capitalize()
    if algebra.ring.is_field:
        counts = ", ".join(f"{len(row)} of dimension {n}" for n, row in rows.items())
    else:
        counts = ", ".join(f"{len(row)} of {row[0].cardinality()}" for row in rows.values())
        counts = f"by numbers of elements: {counts}"
    page, axes = titled_page(theme, f"{side} ideals of {algebra}", counts, (7, 6.3))
    axes.set_aspect("auto")
    axes.set_xlim(-0.02, 1.02)
    axes.set_ylim(-0.09, 1.09)
    for low, high in _covers(found):
        (x, y), (u, v) = places[low], places[high]
        axes.plot([x, u], [y, v], color=theme.quiet, linewidth=1.1, zorder=1)
    hues = _hues(len(levels))
    for ideal, (x, y) in places.items():
        color = colorsys.hls_to_rgb(hues[levels.index(ideal.length)], 0.5, 0.6)
        axes.plot(
            [x], [y], marker="o", markersize=9, color=color, markeredgecolor=theme.page, zorder=3
        )
        row = rows[ideal.length]
        if len(row) <= NAMED:
            upright = len(row) > 4
            axes.annotate(_name(ideal), (x, y), xytext=(0, 10 if y else -10), textcoords="offset points",
                          ha="center", va="bottom" if y else "top", rotation=90 if upright else 0,
                          color=theme.ink, fontsize=9, zorder=4,
                          bbox={"facecolor": theme.page, "edgecolor": "none", "pad": 1.5})  # fmt: skip
    return page


def _name(ideal: AlgebraIdeal) -> str:
    if not ideal.basis:
        return "0"
    if ideal.algebra.one in ideal:
        return "A"
    if ideal.generator is None:
        return f"⟨{', '.join(x.text('unicode') for x in ideal.basis)}⟩"
    x = ideal.basis[0].text("unicode") if ideal.dimension == 1 else ideal.generator.text("unicode")
    return {"left": f"A({x})", "right": f"({x})A"}.get(ideal.side, f"({x})")


def _covers(found: Sequence[AlgebraIdeal]) -> list[tuple[AlgebraIdeal, AlgebraIdeal]]:
    """Return the pairs of ideals (first, second) such that the second covers the first."""
    above = {low: {high for high in found if low < high} for low in found}
    return [
        (low, high)
        for low in found
        for high in above[low]
        if not any(high in above[middle] for middle in above[low])
    ]


# --- graphs ---------------------------------------------------------------------------------------


def _graph(labels: LabelledAlgebra, kind: str, theme: Theme) -> Figure:
    import numpy as np
    from matplotlib.collections import LineCollection

    pairs = numbered_edges(labels, kind)
    degrees = np.bincount(pairs.ravel(), minlength=labels.size)
    everywhere = degrees == labels.size - 2  # central elements of the commuting graph
    everywhere &= not everywhere[1:].all()  # of a commutative algebra all are shown
    pairs = pairs[~everywhere[pairs].any(axis=1)]
    vertices = np.unique(pairs)
    if len(vertices) > MAX_NODES or len(pairs) > MAX_EDGES:
        raise TooLargeError(
            f"the graph has {len(vertices)} vertices and {len(pairs)} edges, and at most {MAX_NODES} and "
            f"{MAX_EDGES} are drawn: A.graph({kind!r}) lists them"
        )
    points, colors = _layout(kind, vertices, pairs)
    left_out = " without those that commute with all" if everywhere.any() else ""
    title = (
        f"{'Commuting elements' if kind == 'commuting' else 'Zero divisors'} of {labels.algebra}"
    )
    rule = "pq = qp" if kind == "commuting" else "pq = 0 or qp = 0"
    below = f"{len(vertices)} elements{left_out}, {len(pairs)} edges: {rule}"
    page, axes = titled_page(theme, title, below, PAGE_SIZE)
    where = {int(v): points[n] for n, v in enumerate(vertices)}
    lines = [(where[int(x)], where[int(y)]) for x, y in pairs]
    alpha = max(0.1, min(0.7, 60 / sqrt(len(lines) * 40 + 1)))
    axes.add_collection(
        LineCollection(lines, colors=theme.quiet, linewidths=0.7, alpha=alpha, zorder=1)
    )
    axes.scatter(points[:, 0], points[:, 1], s=46 if len(vertices) < 90 else 22, c=colors,
                 edgecolors=theme.page, linewidths=0.8, zorder=3)  # fmt: skip
    axes.set_xlim(-1.1, 1.1)
    axes.set_ylim(-1.1, 1.1)
    if len(vertices) <= 40:
        for n, v in enumerate(vertices):
            x, y = points[n] * 1.06
            axes.text(x, y, labels.element(int(v)).text("unicode"), color=theme.ink, fontsize=7,
                      ha="left" if x > 0 else "right", va="center", rotation_mode="anchor",
                      rotation=_reading_angle(x, y), zorder=4)  # fmt: skip
        axes.set_xlim(-1.45, 1.45)
        axes.set_ylim(-1.45, 1.45)
    return page


def _reading_angle(x: float, y: float) -> float:
    from math import atan2, degrees

    angle = degrees(atan2(y, x))
    return angle if -90 <= angle <= 90 else angle - 180


def _layout(
    kind: str, vertices: np.ndarray, pairs: np.ndarray
) -> tuple[np.ndarray, list[tuple[float, float, float]]]:
    """Return points and colours: a circle for each component, with vertices of equal neighbourhoods
    adjacent.
    """
    import numpy as np

    place = {int(v): n for n, v in enumerate(vertices)}
    neighbours: list[set[int]] = [set() for _ in vertices]
    for x, y in pairs.tolist():
        neighbours[place[x]].add(place[y])
        neighbours[place[y]].add(place[x])
    components = _components(neighbours)
    groups: dict[frozenset[int], int] = {}
    points = np.zeros((len(vertices), 2))
    group_of = [0] * len(vertices)
    centres, radius = _centres(len(components))
    for component, (cx, cy) in zip(components, centres, strict=True):
        # twins have the same neighbours; commuting twins are also neighbours of each other
        own = kind == "commuting"
        keys = {
            n: frozenset(neighbours[n] | {n} if own else neighbours[n] - {n}) for n in component
        }
        ordered = sorted(component, key=lambda n: (sorted(keys[n])[:6], n))
        for n, vertex in enumerate(ordered):
            angle = pi / 2 - 2 * pi * n / len(ordered)
            points[vertex] = (cx + radius * cos(angle), cy + radius * sin(angle))
            group_of[vertex] = groups.setdefault(keys[vertex], len(groups))
    hues = _hues(len(groups))
    return points, [colorsys.hls_to_rgb(hues[group], 0.52, 0.62) for group in group_of]


def _components(neighbours: Sequence[set[int]]) -> list[list[int]]:
    left = set(range(len(neighbours)))
    found = []
    while left:
        queue = [min(left)]
        left.discard(queue[0])
        component = []
        while queue:
            n = queue.pop()
            component.append(n)
            fresh = neighbours[n] & left
            left -= fresh
            queue += sorted(fresh)
        found.append(component)
    return found


def _centres(count: int) -> tuple[list[tuple[float, float]], float]:
    """Return the centres and the common radius of ``count`` circles in a square grid."""
    if count == 1:
        return [(0.0, 0.0)], 1.0
    width = ceil(sqrt(count))
    height = ceil(count / width)
    step = 2 / width
    centres = []
    for n in range(count):
        row, column = divmod(n, width)
        in_row = min(width, count - row * width)
        centres.append(((column - (in_row - 1) / 2) * step, ((height - 1) / 2 - row) * step))
    return centres, 0.4 * step
