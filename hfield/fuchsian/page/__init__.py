"""One page of HTML in which the centre of a domain is dragged: offline, with scripts of its own.

The group comes along as the matrices of the units that pair the sides, in floats; the script finds the
domain around any other point of the disc by reducing them by one another. What the page computes is
not proved, and it says so.
"""

from __future__ import annotations

import json
from html import escape
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hfield.core.files import whole_file
from hfield.errors import LatticeError, shorten
from hfield.fuchsian.search import Sight

if TYPE_CHECKING:
    from hfield.fuchsian.group import Domain


def page(domain: Domain) -> str:
    """Return the page."""
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
    return text.replace("{{group}}", json.dumps(_data(domain)))


def _data(domain: Domain) -> dict[str, Any]:
    """Return the units of the sides as pairs of complex numbers, where the centre is, and the area."""
    sight = Sight(domain.polygon.plane)
    a, b = sight.motions(sight.plane.order.rows(domain.polygon.units))
    return {
        "units": [[x.real, x.imag, y.real, y.imag] for x, y in zip(a, b, strict=True)],
        "area": float(domain.group.area),
        "center": [domain.center.real, domain.center.imag],
    }


def write(domain: Domain, path: object, replace: bool | None = None) -> None:
    """Write the page. Raises :class:`LatticeError` where the file cannot be written."""
    try:
        with whole_file(Path(str(path)), replace) as part:
            part.write_text(page(domain), encoding="utf-8")
    except OSError as error:
        raise LatticeError(f"cannot write {shorten(path)!r}: {error}") from error
