"""A Dirichlet domain in Poincaré's disc, its images coloured by words: SVG of true arcs, PNG and PDF."""

from __future__ import annotations

import colorsys
from collections.abc import Iterator
from html import escape
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from hfield.core.files import whole_file
from hfield.errors import LatticeError, shorten
from hfield.fuchsian.tessellation import move, tessellation
from hfield.plotting import default_settings

if TYPE_CHECKING:
    from hfield.fuchsian.group import Domain

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
RADIUS = 320.0
"""Of the disc in an SVG, in its pixels."""
FLAT = 0.15
"""An arc that strays less than this from its chord, in pixels, is drawn as the chord."""
MIN_SIDE_PIXELS = 0.4
"""Sides of far images that are shorter than this, in pixels, are drawn together."""
DECIMALS = 1
WIDE = 0.75
"""No piece of an arc drawn as a cubic curve has a wider angle, in radians."""


class Side(NamedTuple):
    """A side of an image: the arc about ``center`` from one point to another; without centre straight."""

    start: complex
    end: complex
    center: complex | None

    @property
    def radius(self) -> float:
        """The radius of the circle, which meets the unit circle at right angles."""
        assert self.center is not None
        return abs(self.start - self.center)


class Area(NamedTuple):
    """Images of one colour: the sides of each."""

    color: str
    images: list[list[Side]]


class Drawing(NamedTuple):
    """What every format draws, in the unit disc."""

    title: str
    facts: str
    look: dict[str, str]
    areas: list[Area]
    own: list[Side]
    colors: list[str]
    """Of the domain's own sides."""
    points: list[tuple[complex, int]]
    """Elliptic points and their orders."""


def draw(
    domain: Domain, path: object, *, dark: bool, depth: int | None, replace: bool | None = None
) -> None:
    """Draw a domain to a file. Raises :class:`LatticeError` where it cannot be written."""
    drawing = drawing_of(domain, dark, depth)
    try:
        with whole_file(Path(str(path)), replace) as part:
            if part.suffix.lower() == ".svg":
                part.write_text(_svg(drawing), encoding="utf-8")
            else:
                _save(drawing, part)
    except (OSError, ValueError) as error:
        raise LatticeError(
            f"cannot draw to {shorten(path)!r}: {error}; try a file .svg, .png or .pdf"
        ) from error


def svg(domain: Domain) -> str:
    """Return the picture as SVG."""
    return _svg(drawing_of(domain, False, None))


def drawing_of(domain: Domain, dark: bool, depth: int | None) -> Drawing:
    """Return what is drawn of a domain: all that can be seen, or words of up to ``depth`` sides."""
    hues, corners = _hues(domain), np.array(domain.vertices)
    colored = sorted(tessellation(domain, depth), key=lambda t: (t.length, t.first))
    areas = [
        Area(
            _shade(hues[first], length, dark),
            [sides_of(move(tile.a, tile.b, corners)) for tile in tiles],
        )
        for (length, first), tiles in groupby(colored, key=lambda t: (t.length, t.first))
    ]
    own = sides_of(corners)
    orders = [(complex(corners[n]), order) for n, order in _orders(domain) if order > 1]
    halves = [(_middle(own[n]), 2) for n, p in enumerate(domain.partners) if n == p]
    colors = [_shade(hue, 0, dark) for hue in hues]
    look = DARK if dark else LIGHT
    return Drawing(*_words(domain), look, areas, own, colors, orders + halves)


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


def sides_of(corners: Any) -> list[Side]:
    """Return the sides of the polygon with these corners, (k,)."""
    ends = np.roll(corners, -1)
    # The centre c has the same power 1 to the unit circle: Re(c·conj(p)) = (1 + |p|²)/2 at both ends.
    cross = (corners.conj() * ends).imag
    one, other = (1 + abs(corners) ** 2) / 2, (1 + abs(ends) ** 2) / 2
    straight = abs(cross) < 1e-9 * (abs(ends - corners) + 1e-300)
    centers = 1j * (other * corners - one * ends) / np.where(straight, 1, cross)
    return [
        Side(complex(p), complex(q), None if line else complex(c))
        for p, q, c, line in zip(corners, ends, centers, straight, strict=True)
    ]


def _middle(side: Side) -> complex:
    """Return the middle of a side in the plane, halfway between its ends."""
    ends = np.array([side.start, side.end])
    stretched = 2 * ends / (1 - abs(ends) ** 2)  # horizontal coordinates on the hyperboloid
    heights = np.sqrt(1 + abs(stretched) ** 2)
    x, t = stretched.sum(), heights.sum()
    return complex(x / (t + np.sqrt(t * t - abs(x) ** 2)))


# --- SVG -------------------------------------------------------------------------------------------------


def _svg(drawing: Drawing) -> str:
    """Write the picture: numbers are pixels from the middle of the disc, y downwards."""
    look = drawing.look
    width, above, below = RADIUS + 12, RADIUS + 62, RADIUS + 12
    size = min(17, 780 / len(drawing.title))
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{-width:g} {-above:g} {2 * width:g} '
        f'{above + below:g}" width="{2 * width:g}" height="{above + below:g}" '
        'font-family="DejaVu Sans, Verdana, sans-serif" text-anchor="middle" stroke-linejoin="round">',
        f"<title>{escape(drawing.title)}</title>",
        f'<rect x="{-width:g}" y="{-above:g}" width="100%" height="100%" fill="{look["page"]}"/>',
        f'<text y="{-above + 28:g}" font-size="{size:.3g}" fill="{look["ink"]}">'
        f"{escape(drawing.title)}</text>",
        f'<text y="{-above + 49:g}" font-size="12" fill="{look["ink"]}" opacity="0.75">'
        f"{escape(drawing.facts)}</text>",
        f'<circle r="{RADIUS:g}" fill="{look["disc"]}"/>',
        f'<g stroke="{look["edge"]}" stroke-width="0.4">',
    ]
    for color, images in drawing.areas:
        way = "".join(_way(sides, MIN_SIDE_PIXELS) + "z" for sides in images)
        parts.append(f'<path fill="{color}" d="{way}"/>')
    parts += [
        "</g>",
        f'<path fill="{look["domain"]}" d="{_way(drawing.own)}z"/>',
        f'<circle r="{RADIUS:g}" fill="none" stroke="{look["ink"]}" stroke-width="1.2"/>',
        '<g fill="none" stroke-width="3" stroke-linecap="round">',
    ]
    for side, color in zip(drawing.own, drawing.colors, strict=True):
        parts.append(f'<path stroke="{color}" d="{_way([side])}"/>')
    parts.append(f'</g><g fill="{look["ink"]}" stroke="{look["domain"]}" stroke-width="1">')
    for point, order in drawing.points:
        corners = " ".join(_numbers(RADIUS * point + z) for z in _mark(order))
        parts.append(f'<polygon points="{corners}"/>')
    parts.append('<circle r="2.5" stroke="none"/></g></svg>')
    return "\n".join(parts) + "\n"


def _way(sides: list[Side], short: float = 0.0) -> str:
    """Write sides that follow one another as a path; those shorter than ``short`` pixels are drawn as one."""
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
    """Write a point or step, y downwards, as briefly as it goes."""
    x, y = (
        f"{v:.{DECIMALS}f}".removesuffix(".0").replace("0.", ".", 1)
        if abs(v) < 1
        else f"{v:.{DECIMALS}f}".removesuffix(".0")
        for v in (z.real + 0.0, -z.imag + 0.0)
    )
    return f"{x or 0} {y or 0}"


def _mark(order: int) -> Iterator[complex]:
    """Yield the corners of the mark of an elliptic point: a diamond for order 2, a triangle for 3."""
    corners = {2: 4, 3: 3}.get(order, 12)
    for n in range(corners):
        yield 6.0 * 1j * np.exp(2j * np.pi * n / corners)


# --- PNG and PDF -----------------------------------------------------------------------------------------


def _save(drawing: Drawing, path: Path) -> None:
    with default_settings():
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
        from matplotlib.patches import Circle, PathPatch, Polygon

        look = drawing.look
        figure = Figure(figsize=(7, 7.7), facecolor=look["page"])
        FigureCanvasAgg(figure)
        axes: Any = figure.add_axes((0.02, 0.005, 0.96, 0.909))
        axes.set(aspect="equal", xlim=(-1.03, 1.03), ylim=(-1.03, 1.03))
        axes.axis("off")
        axes.add_patch(Circle((0, 0), 1, facecolor=look["disc"], edgecolor="none"))
        for color, images in drawing.areas:
            for sides in images:
                axes.add_patch(
                    PathPatch(_curve(sides), facecolor=color, edgecolor=look["edge"], lw=0.35)
                )
        axes.add_patch(PathPatch(_curve(drawing.own), facecolor=look["domain"], edgecolor="none"))
        axes.add_patch(Circle((0, 0), 1, facecolor="none", edgecolor=look["ink"], lw=1.1))
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
                    facecolor=look["ink"],
                    edgecolor=look["domain"],
                    lw=1,
                )
            )
        axes.add_patch(Circle((0, 0), 2.5 / RADIUS, facecolor=look["ink"], edgecolor="none"))
        for patch in axes.patches:
            patch.set_zorder(1)  # in this order
        figure.text(0.5, 0.966, drawing.title, ha="center", va="center", color=look["ink"],
                    fontsize=min(14, 700 / len(drawing.title)))  # fmt: skip
        figure.text(0.5, 0.932, drawing.facts, ha="center", va="center", color=look["ink"],
                    fontsize=10, alpha=0.75)  # fmt: skip
        dateless = {"CreationDate": None} if path.suffix.lower() == ".pdf" else {}
        figure.savefig(path, facecolor=figure.get_facecolor(), dpi=160, metadata=dateless)


def _curve(sides: list[Side]) -> Any:
    """Return matplotlib's path along sides that follow one another, arcs as cubic curves."""
    from matplotlib.path import Path as Curve

    points, codes = [sides[0].start], [Curve.MOVETO]
    for start, end, center in sides:
        if center is None:
            points, codes = [*points, end], [*codes, Curve.LINETO]
            continue
        spoke, turn = start - center, float(np.angle((end - center) / (start - center)))
        pieces = max(1, int(np.ceil(abs(turn) / WIDE)))
        part = turn / pieces
        pull = 1j * 4 / 3 * np.tan(part / 4)  # along the tangents
        for n in range(pieces):
            one, other = spoke * np.exp(1j * part * n), spoke * np.exp(1j * part * (n + 1))
            points += [center + one * (1 + pull), center + other * (1 - pull), center + other]
            codes += [Curve.CURVE4] * 3
    return Curve([(z.real, z.imag) for z in points], codes)


# --- colours ---------------------------------------------------------------------------------------------


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


def _shade(hue: float, length: int, dark: bool) -> str:
    """Return a colour for words of a length that begin with a side; length 0 is the side itself."""
    if length == 0:
        lightness, saturation = 0.62 if dark else 0.45, 0.72
    elif dark:
        lightness, saturation = max(0.18, 0.44 - 0.07 * length), 0.42
    else:
        lightness, saturation = min(0.93, 0.70 + 0.055 * length), 0.55
    channels = colorsys.hls_to_rgb(hue, lightness, saturation)
    return "#{:02x}{:02x}{:02x}".format(*(round(255 * channel) for channel in channels))
