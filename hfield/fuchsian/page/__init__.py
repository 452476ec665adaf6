"""An HTML page on which the centre of a domain can be dragged; it works offline, with its own scripts.

The page contains the units that pair the sides, as float matrices; the script reduces them by one another to
find the domain around any other point of the disc. If the centre is a point that units fix, the units are
those of another domain. The results on the page are not proved, and the page says so.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from html import escape
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from hfield.core.files import whole_file
from hfield.errors import LatticeError, shorten
from hfield.fuchsian.pair_colors import (
    DARK,
    DARK_PAIRS,
    GREATEST_SHARE,
    LIGHT,
    LIGHT_PAIRS,
    NEAREST_SHARE,
    NEXT_SHARE,
)
from hfield.fuchsian.picture import cm_points_in
from hfield.fuchsian.search import Sight

if TYPE_CHECKING:
    from hfield.fuchsian.cm_points import CMPoint
    from hfield.fuchsian.group import Domain


def page(domain: Domain, dark: bool = False, points: Iterable[CMPoint] = ()) -> str:
    """Return the page; it starts dark if ``dark``, else in the colour scheme of the reader's system."""
    here = files(__name__)
    group, order = domain.group, domain.group.order
    genus, orders, cusps = group.signature
    elliptic = f"elliptic points of order {', '.join(map(str, orders))}" if orders else ""
    facts = [f"genus {genus}", elliptic or "no elliptic points"]
    facts += [f"{cusps} cusp{'s' * (cusps > 1)}"] if cusps else []
    filled = {
        "title": f"Units of norm 1, {order.title} in {order.algebra}",
        "facts": " · ".join([*facts, f"area 2π·{group.area}"]),
    }
    text = (here / "page.html").read_text(encoding="utf-8")
    for name, value in filled.items():
        text = text.replace(f"{{{{{name}}}}}", escape(value))
    parts = {"style": "page.css", "script": "page.js"}
    for name, file in parts.items():
        text = text.replace(f"{{{{{name}}}}}", (here / file).read_text(encoding="utf-8"))
    text = text.replace("{{look}}", "dark" if dark else "system")
    return text.replace("{{group}}", json.dumps(_data(domain, points)))


def _data(domain: Domain, points: Iterable[CMPoint]) -> dict[str, object]:
    """Return the units of the sides as pairs of complex numbers, the position of the centre, and the area.

    The units pair the sides of a domain around ``first``, a point of the disc that no unit fixes. ``corner``
    is the direction of the first side of a sector.
    """
    plane = domain.polygon.plane
    sight, given = Sight(plane), domain if domain.stabiliser == 1 else domain.group.domain()
    a, b = sight.motions(np.array(plane.order.rows(given.polygon.units)))
    first = plane.vector(given.center_element)
    if plane.order.sign(first[0]) < 0:
        first = (-first[0], -first[1], -first[2])
    there, corner = plane.disc(first), domain.vertices[1]
    return {
        "first": [there.real, there.imag],
        "corner": [corner.real, corner.imag],
        "units": [[x.real, x.imag, y.real, y.imag] for x, y in zip(a, b, strict=True)],
        "area": float(domain.group.area),
        "center": [domain.center.real, domain.center.imag],
        "points": [
            {"name": d, "color": color, "places": [[z.real, z.imag] for z in places]}
            for d, color, places in cm_points_in(domain, points)
        ],
        "colors": {
            "light": {**LIGHT, "pairs": LIGHT_PAIRS},
            "dark": {**DARK, "pairs": DARK_PAIRS},
            "shares": [NEAREST_SHARE, NEXT_SHARE, GREATEST_SHARE],
        },
    }


def write(
    domain: Domain,
    path: object,
    dark: bool = False,
    replace: bool | None = None,
    points: Iterable[CMPoint] = (),
) -> None:
    """Write the page. Raises :class:`LatticeError` if the file cannot be written."""
    try:
        with whole_file(Path(str(path)), replace) as part:
            part.write_text(page(domain, dark, points), encoding="utf-8")
    except OSError as error:
        raise LatticeError(f"cannot write {shorten(path)!r}: {error}") from error
