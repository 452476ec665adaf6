"""Pictures of a Dirichlet domain in Poincaré's disc, with tiles coloured by words, as SVG, PNG and PDF."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from html import escape
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hfield.core.files import whole_file
from hfield.errors import LatticeError, shorten
from hfield.fuchsian import cm_points
from hfield.fuchsian.pair_colors import CM_COLORS, DARK, LIGHT, letters, pair_numbers, shade
from hfield.fuchsian.tessellation import move, tessellation
from hfield.plotting import default_settings, save_figure

if TYPE_CHECKING:
    from matplotlib.patches import Circle
    from matplotlib.path import Path as Curve

    from hfield.fuchsian.cm_points import CMPoint
    from hfield.fuchsian.group import Domain
    from hfield.fuchsian.search import Points

RADIUS = 320.0
"""Of the disc in an SVG, in its pixels."""
FLAT = 0.15
"""An arc that strays less than this from its chord, in pixels, is drawn as the chord."""
MIN_SIDE_PIXELS = 0.4
"""Sides of far images that are shorter than this, in pixels, are drawn together."""
DECIMALS = 1
LETTER_SIZE, MIN_LETTER_SIZE = 14.0, 4.0
"""The usual size of the letters on sides, in pixels; those of short sides are smaller, or left out."""
LEGEND_SIZE, LEGEND_STEP, LEGEND_GAP = 12.0, 22.0, 16.0
"""The letters of the legend, the distance of its rows and of entries in a row, in pixels."""
ADVANCE = 0.55
"""About how wide a letter is, in terms of its size."""
MAX_LEGEND_PAIRS = 14
CM_SIZE = 5.0
"""The radius of the mark of a CM point, in pixels."""
MAX_ARC_ANGLE = 0.75
"""No piece of an arc drawn as a cubic curve has a wider angle, in radians."""


class DrawnSide(NamedTuple):
    """A side of a tile: the arc between two points about ``center``; a straight line if there is no
    centre.
    """

    start: complex
    end: complex
    center: complex | None

    @property
    def radius(self) -> float:
        """The radius of the circle, which is orthogonal to the unit circle."""
        assert self.center is not None
        return abs(self.start - self.center)


class Area(NamedTuple):
    """Tiles of one colour: the sides of each."""

    color: str
    images: list[list[DrawnSide]]


class DiscDrawing(NamedTuple):
    """A picture in the unit disc, independent of the file format."""

    title: str
    facts: str
    theme: dict[str, str]
    areas: list[Area]
    own: list[DrawnSide]
    colors: list[str]
    letters: list[str]
    """Of the domain's own sides: their colours, and what they are called."""
    points: list[tuple[complex, int]]
    """Elliptic points and their orders."""
    cm_points: list[CMPoints]


class CMPoints(NamedTuple):
    """CM points of one discriminant."""

    discriminant: str
    color: str
    places: list[complex]


def draw(
    domain: Domain,
    path: object,
    *,
    dark: bool,
    depth: int | None,
    replace: bool | None = None,
    points: Iterable[CMPoint] = (),
) -> None:
    """Draw a domain to a file. Raises :class:`LatticeError` if the file cannot be written."""
    drawing = drawing_of(domain, dark, depth, points)
    try:
        with whole_file(Path(str(path)), replace) as part:
            if part.suffix.lower() == ".svg":
                part.write_text(_svg(drawing), encoding="utf-8")
            else:
                _save(drawing, part)
    except (OSError, ValueError) as error:
        raise LatticeError(
            f"cannot draw to {shorten(path)!r}: {error}; try a file name that ends in .svg, .png or .pdf"
        ) from error


def svg(domain: Domain) -> str:
    """Return the picture as SVG."""
    return _svg(drawing_of(domain, False, None))


def drawing_of(
    domain: Domain, dark: bool, depth: int | None, points: Iterable[CMPoint] = ()
) -> DiscDrawing:
    """Return the picture of a domain, with all visible tiles or those of words of up to ``depth`` sides."""
    numbers, corners = pair_numbers(domain), np.array(domain.vertices)
    colored = sorted(tessellation(domain, depth), key=lambda t: (t.length, t.first))
    areas = [
        Area(
            shade(numbers[first], length, dark),
            [sides_of(move(tile.a, tile.b, corners)) for tile in tiles],
        )
        for (length, first), tiles in groupby(colored, key=lambda t: (t.length, t.first))
    ]
    own = sides_of(corners)
    orders = [(complex(corners[n]), order) for n, order in _orders(domain) if order > 1]
    halves = [(_middle(own[n]), 2) for n, p in enumerate(domain.partners) if n == p]
    colors = [shade(number, 0, dark) for number in numbers]
    theme = DARK if dark else LIGHT
    names = letters(domain.partners, numbers)
    marks, special = orders + halves, cm_points_in(domain, points)
    return DiscDrawing(*_words(domain), theme, areas, own, colors, names, marks, special)


def cm_points_in(domain: Domain, points: Iterable[CMPoint]) -> list[CMPoints]:
    """Return the positions of CM points, moved into the domain, by discriminant."""
    places: dict[str, list[complex]] = {}
    for point in points:
        there = cm_points.place(domain, domain.reduce(point))
        places.setdefault(str(point.discriminant).replace("-", "−"), []).append(there)
    return [
        CMPoints(d, CM_COLORS[n % len(CM_COLORS)], some)
        for n, (d, some) in enumerate(places.items())
    ]


def _words(domain: Domain) -> tuple[str, str]:
    group = domain.group
    signature, order = group.signature, group.order
    orders = ", ".join(map(str, signature.orders))
    elliptic = f"elliptic points of order {orders}" if orders else "no elliptic points"
    cusps = f" · {signature.cusps} cusp{'s' * (signature.cusps > 1)}" if signature.cusps else ""
    return (
        f"Units of norm 1, {order.title} in {order.algebra}",
        f"genus {signature.genus} · {elliptic}{cusps} · area 2π·{group.area} · "
        f"{len(domain.partners)} sides",
    )


# --- geometry: points of the disc are complex numbers ----------------------------------------------------


def sides_of(corners: Points) -> list[DrawnSide]:
    """Return the sides of the polygon with these corners, (k,)."""
    ends = np.roll(corners, -1)
    # The centre c has the same power 1 to the unit circle: Re(c·conj(p)) = (1 + |p|²)/2 at both ends.
    cross = (corners.conj() * ends).imag
    one, other = (1 + abs(corners) ** 2) / 2, (1 + abs(ends) ** 2) / 2
    straight = abs(cross) < 1e-9 * (abs(ends - corners) + 1e-300)
    centers = 1j * (other * corners - one * ends) / np.where(straight, 1, cross)
    return [
        DrawnSide(complex(p), complex(q), None if line else complex(c))
        for p, q, c, line in zip(corners, ends, centers, straight, strict=True)
    ]


def _middle(side: DrawnSide) -> complex:
    """Return the hyperbolic midpoint of a side."""
    ends = np.array([side.start, side.end])
    stretched = 2 * ends / (1 - abs(ends) ** 2)  # horizontal coordinates on the hyperboloid
    heights = np.sqrt(1 + abs(stretched) ** 2)
    x, t = stretched.sum(), heights.sum()
    return complex(x / (t + np.sqrt(t * t - abs(x) ** 2)))


# --- letters and legend, in pixels from the middle of the disc, y upwards -----------------------------------


class LegendEntry(NamedTuple):
    """An entry of the legend that starts at x: a stroke of a colour, or the mark of an order (1 for the
    centre).

    An entry with both stands for a CM point.
    """

    x: float
    y: float
    color: str | None
    order: int | None
    text: str

    @property
    def text_x(self) -> float:
        """The x coordinate of the text."""
        return self.x + (0 if self.color is None and self.order is None else 22)


def letters_on_sides(drawing: DiscDrawing) -> Iterator[tuple[complex, float, str]]:
    """Yield the midpoint, the size and the letter of each side that is long enough for a letter."""
    # the straight sides of a sector may be near to one another
    between = RADIUS * abs(_summit(drawing.own[0]) - _summit(drawing.own[-1]))
    for side, text in zip(drawing.own, drawing.letters, strict=True):
        chord = (side.end - side.start) * RADIUS
        width = min(abs(chord), between) if 0 in (side.start, side.end) else abs(chord)
        size = min(LETTER_SIZE, 0.28 * width)
        if size >= MIN_LETTER_SIZE:
            inwards = 1j * chord / abs(chord)  # the corners are in positive order
            yield RADIUS * _summit(side) + inwards * (0.95 * size + 2), size, text


def _summit(side: DrawnSide) -> complex:
    """Return the point of the arc that is farthest from its chord."""
    middle = (side.start + side.end) / 2
    if side.center is None or abs(middle - side.center) < 1e-9:
        return middle
    return side.center + (middle - side.center) * side.radius / abs(middle - side.center)


def legend(drawing: DiscDrawing) -> list[LegendEntry]:
    """Return the legend below the disc, with centred rows."""
    names = dict(zip(drawing.colors, drawing.letters, strict=True))
    firsts = [(c, t) for c, t in zip(drawing.colors, drawing.letters, strict=True) if "⁻" not in t]
    pairs: list[tuple[str | None, int | None, str]] = [(c, None, t) for c, t in firsts]
    if len(pairs) > MAX_LEGEND_PAIRS:
        pairs = [*pairs[: MAX_LEGEND_PAIRS - 1], (None, None, f"… {pairs[-1][2]}")]
    rows = [pairs]
    if any("⁻" in text for text in names.values()):
        rows.append(
            [(None, None, "beyond side a lies the image under a, which maps side a⁻¹ to side a")]
        )
    orders = sorted({order for _, order in drawing.points})
    marks: list[tuple[str | None, int | None, str]] = [
        (None, order, f"{'' if n else 'fixed by a rotation '}of order {order}")
        for n, order in enumerate(orders)
    ]
    rows.append([*marks, (None, 1, "centre")])
    if drawing.cm_points:
        rows.append(
            [
                (some.color, 0, f"{'' if n else 'CM points of discriminant '}{some.discriminant}")
                for n, some in enumerate(drawing.cm_points)
            ]
        )
    return [
        entry for n, row in enumerate(rows) for entry in _row(row, -RADIUS - 30 - LEGEND_STEP * n)
    ]


def _more_legend(drawing: DiscDrawing) -> float:
    """Return the height of the additional legend row in pictures with CM points."""
    return LEGEND_STEP if drawing.cm_points else 0


def _row(row: list[tuple[str | None, int | None, str]], y: float) -> Iterator[LegendEntry]:
    entries = [LegendEntry(0, y, *words) for words in row]
    widths = [e.text_x + ADVANCE * LEGEND_SIZE * len(e.text) for e in entries]
    x = -(sum(widths) + LEGEND_GAP * (len(row) - 1)) / 2
    for entry, width in zip(entries, widths, strict=True):
        yield entry._replace(x=x)
        x += width + LEGEND_GAP


# --- SVG -------------------------------------------------------------------------------------------------


def _svg(drawing: DiscDrawing) -> str:
    """Write the picture as SVG; coordinates are pixels from the centre of the disc, y downwards."""
    theme = drawing.theme
    width, above, below = RADIUS + 12, RADIUS + 62, RADIUS + 92 + _more_legend(drawing)
    size = min(17, 780 / len(drawing.title))
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{-width:g} {-above:g} {2 * width:g} '
        f'{above + below:g}" width="{2 * width:g}" height="{above + below:g}" '
        'font-family="DejaVu Sans, Verdana, sans-serif" text-anchor="middle" stroke-linejoin="round">',
        f"<title>{escape(drawing.title)}</title>",
        f'<rect x="{-width:g}" y="{-above:g}" width="100%" height="100%" fill="{theme["page"]}"/>',
        f'<text y="{-above + 28:g}" font-size="{size:.3g}" fill="{theme["ink"]}">'
        f"{escape(drawing.title)}</text>",
        f'<text y="{-above + 49:g}" font-size="12" fill="{theme["ink"]}" opacity="0.75">'
        f"{escape(drawing.facts)}</text>",
        f'<circle r="{RADIUS:g}" fill="{theme["disc"]}"/>',
        f'<g stroke="{theme["edge"]}" stroke-width="0.4">',
    ]
    for color, images in drawing.areas:
        way = "".join(_way(sides, MIN_SIDE_PIXELS) + "z" for sides in images)
        parts.append(f'<path fill="{color}" d="{way}"/>')
    parts += [
        "</g>",
        f'<path fill="{theme["domain"]}" d="{_way(drawing.own)}z"/>',
        f'<circle r="{RADIUS:g}" fill="none" stroke="{theme["ink"]}" stroke-width="1.2"/>',
        '<g fill="none" stroke-width="3" stroke-linecap="round">',
    ]
    for side, color in zip(drawing.own, drawing.colors, strict=True):
        parts.append(f'<path stroke="{color}" d="{_way([side])}"/>')
    parts.append(f'</g><g fill="{theme["ink"]}" stroke="{theme["domain"]}" stroke-width="1">')
    for point, order in drawing.points:
        corners = " ".join(_numbers(RADIUS * point + z) for z in _mark(order))
        parts.append(f'<polygon points="{corners}"/>')
    parts.append('<circle r="2.5" stroke="none"/></g>')
    parts.append(f'<g stroke="{theme["ink"]}" stroke-width="1.2">')
    for some in drawing.cm_points:
        for point in some.places:
            cx, cy = _numbers(RADIUS * point).split()
            parts.append(f'<circle cx="{cx}" cy="{cy}" r="{CM_SIZE:g}" fill="{some.color}"/>')
    parts.append(f'</g><g fill="{theme["ink"]}">')
    for place, size, text in letters_on_sides(drawing):
        x, y = place.real, -place.imag + 0.36 * size
        parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size:.3g}">{text}</text>')
    parts.append(
        f'</g><g fill="{theme["ink"]}" color="{theme["ink"]}" font-size="{LEGEND_SIZE:g}" '
        'text-anchor="start">'
    )
    parts += [part for entry in legend(drawing) for part in _svg_entry(entry)]
    parts.append("</g></svg>")
    return "\n".join(parts) + "\n"


def _svg_entry(entry: LegendEntry) -> Iterator[str]:
    if entry.color is not None and entry.order is not None:
        x, y = entry.x + 12, -entry.y
        yield (
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{CM_SIZE:g}" fill="{entry.color}" '
            'stroke="currentColor" stroke-width="1.2"/>'
        )
    elif entry.color is not None:
        yield f'<path stroke="{entry.color}" stroke-width="3" d="M{entry.x:.1f} {-entry.y:.1f}h16"/>'
    elif entry.order is not None:
        corners = " ".join(_numbers(complex(entry.x + 8, entry.y) + z) for z in _mark(entry.order))
        yield f'<polygon points="{corners}"/>'
    yield f'<text x="{entry.text_x:.1f}" y="{-entry.y + 4:.1f}">{entry.text}</text>'


def _way(sides: list[DrawnSide], short: float = 0.0) -> str:
    """Write consecutive sides as a path; runs of sides shorter than ``short`` pixels become one segment."""
    here = np.round(sides[0].start * RADIUS, DECIMALS)
    words = ["M" + _numbers(here)]
    skipped = False
    for n, side in enumerate(sides):
        there = np.round(side.end * RADIUS, DECIMALS)
        if abs(there - here) < short and n < len(sides) - 1:
            skipped = True
            continue
        step, arc = _numbers(there - here), None if skipped else side.center
        if arc is not None and abs(there - here) ** 2 > 8 * FLAT * RADIUS * side.radius:
            radius = f"{RADIUS * side.radius:.5g}"
            clockwise = int((side.start.conjugate() * side.end).imag > 0)
            words.append(f"a{radius} {radius} 0 0 {clockwise} {step}")
        else:
            words.append("l" + step)
        here, skipped = there, False
    return "".join(words)


def _numbers(z: complex) -> str:
    """Format a point or step with y downwards, as briefly as possible."""
    x, y = (
        f"{v:.{DECIMALS}f}".removesuffix(".0").replace("0.", ".", 1)
        if abs(v) < 1
        else f"{v:.{DECIMALS}f}".removesuffix(".0")
        for v in (z.real + 0.0, -z.imag + 0.0)
    )
    return f"{x or 0} {y or 0}"


def _mark(order: int) -> Iterator[complex]:
    """Yield the corners of a mark: a point for the centre, a diamond for order 2, a polygon for higher
    orders.
    """
    corners = {1: 12, 2: 4}.get(order, order if order < 8 else 24)
    first = np.exp(1j * np.pi / 4) if order == 4 else 1j
    for n in range(corners):
        corner = complex((2.5 if order == 1 else 6.0) * first * np.exp(2j * np.pi * n / corners))
        yield complex(0.75 * corner.real, corner.imag) if order == 2 else corner


# --- PNG and PDF -----------------------------------------------------------------------------------------


def _save(drawing: DiscDrawing, path: Path) -> None:
    with default_settings():
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
        from matplotlib.patches import Circle, PathPatch, Polygon

        theme = drawing.theme
        more = _more_legend(drawing) / RADIUS
        height = 7 * (2.54 + more) / 2.08
        figure = Figure(figsize=(7, height), facecolor=theme["page"])
        FigureCanvasAgg(figure)
        axes = figure.add_axes((0, 0, 1, 1))
        axes.set(aspect="equal", xlim=(-1.04, 1.04), ylim=(-1.305 - more, 1.235))
        axes.axis("off")
        axes.add_patch(Circle((0, 0), 1, facecolor=theme["disc"], edgecolor="none"))
        for color, images in drawing.areas:
            for sides in images:
                axes.add_patch(
                    PathPatch(_curve(sides), facecolor=color, edgecolor=theme["edge"], lw=0.35)
                )
        axes.add_patch(PathPatch(_curve(drawing.own), facecolor=theme["domain"], edgecolor="none"))
        axes.add_patch(Circle((0, 0), 1, facecolor="none", edgecolor=theme["ink"], lw=1.1))
        for side, color in zip(drawing.own, drawing.colors, strict=True):
            axes.add_patch(
                PathPatch(
                    _curve([side]), facecolor="none", edgecolor=color, lw=2.6, capstyle="round"
                )
            )
        for point, order in drawing.points:
            corners = [point + z / RADIUS for z in _mark(order)]
            axes.add_patch(
                Polygon(
                    [(z.real, z.imag) for z in corners],
                    facecolor=theme["ink"],
                    edgecolor=theme["domain"],
                    lw=1,
                )
            )
        axes.add_patch(Circle((0, 0), 2.5 / RADIUS, facecolor=theme["ink"], edgecolor="none"))
        for some in drawing.cm_points:
            for point in some.places:
                axes.add_patch(_cm_mark(point, some.color, theme["ink"]))
        points = 72 * 7 / (2.08 * RADIUS)  # of type, in a pixel
        for place, size, text in letters_on_sides(drawing):
            axes.text(place.real / RADIUS, place.imag / RADIUS, text, ha="center", va="center_baseline",
                      color=theme["ink"], fontsize=size * points)  # fmt: skip
        for entry in legend(drawing):
            x, y = entry.x / RADIUS, entry.y / RADIUS
            if entry.color is not None and entry.order is not None:
                axes.add_patch(_cm_mark(complex(x + 12 / RADIUS, y), entry.color, theme["ink"]))
            elif entry.color is not None:
                axes.plot([x, x + 16 / RADIUS], [y, y], color=entry.color, linewidth=2.2)
            elif entry.order is not None:
                ends = [(entry.x + 8 + z.real, entry.y + z.imag) for z in _mark(entry.order)]
                axes.add_patch(Polygon(np.array(ends) / RADIUS, facecolor=theme["ink"], lw=0))
            axes.text(entry.text_x / RADIUS, y, entry.text, va="center_baseline", color=theme["ink"],
                      fontsize=LEGEND_SIZE * points)  # fmt: skip
        for patch in axes.patches:
            patch.set_zorder(1)  # in this order
        figure.text(0.5, 1 - 0.2565 / height, drawing.title, ha="center", va="center", color=theme["ink"],
                    fontsize=min(14, 700 / len(drawing.title)))  # fmt: skip
        figure.text(0.5, 1 - 0.513 / height, drawing.facts, ha="center", va="center", color=theme["ink"],
                    fontsize=10, alpha=0.75)  # fmt: skip
        save_figure(figure, path)


def _cm_mark(point: complex, color: str, ink: str) -> Circle:
    """Return the matplotlib marker of a CM point."""
    from matplotlib.patches import Circle

    center = (point.real, point.imag)
    return Circle(center, CM_SIZE / RADIUS, facecolor=color, edgecolor=ink, lw=1)


def _curve(sides: list[DrawnSide]) -> Curve:
    """Return the matplotlib path along consecutive sides, with arcs as cubic curves."""
    from matplotlib.path import Path as Curve

    points, codes = [sides[0].start], [Curve.MOVETO]
    for start, end, center in sides:
        if center is None:
            points, codes = [*points, end], [*codes, Curve.LINETO]
            continue
        spoke, turn = start - center, float(np.angle((end - center) / (start - center)))
        pieces = max(1, int(np.ceil(abs(turn) / MAX_ARC_ANGLE)))
        part = turn / pieces
        pull = 1j * 4 / 3 * np.tan(part / 4)  # along the tangents
        for n in range(pieces):
            one, other = spoke * np.exp(1j * part * n), spoke * np.exp(1j * part * (n + 1))
            points += [center + one * (1 + pull), center + other * (1 - pull), center + other]
            codes += [Curve.CURVE4] * 3
    return Curve([(z.real, z.imag) for z in points], codes)


def _orders(domain: Domain) -> list[tuple[int, int]]:
    """Return each vertex with the order of its stabiliser."""
    found = []
    for cycle in domain.cycles:
        n = cycle.start
        for side in cycle.sides:
            found.append((n, cycle.order))
            n = (domain.partners[side] + 1) % len(domain.partners)
    return found
