"""The page as text: the viewer's files and the motion as JSON, in one file.

The page loads nothing from the network (its content security policy forbids it), so it works as a local file.
Attitudes are stored as float32, four numbers per frame: 500 frames take 11 KB.
"""

from __future__ import annotations

import json
import math
from base64 import b64encode
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING

from anim.errors import AnimationError
from anim.outline import simplified
from anim.picture.environment import environment

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from anim.model import Model
    from anim.motion import Motion
    from anim.physics import FreeTop, HeavyTop

SCRIPTS = ("vectors.js", "scene.js", "curves.js", "player.js")
LIVE_SCRIPTS = ("heavy_top.js", "free_top.js", "simulator.js")
OUTLINE_TOLERANCE, MAX_CORNERS = 0.003, 36
"""The first tolerance of the page's outline, and the largest number of corners of its shadow."""
READINGS = '<table id="readings"></table>\n'
KEYS = """<dt>l, p</dt><dd>launch the live top anew, push it</dd>
<dt>m</dt><dd>the live top, or the film</dd>
<dt>esc</dt><dd>close this list</dd>
"""
MODE = '<button id="mode" type="button" title="the live top or the film (m)"></button>\n'


@dataclass(frozen=True)
class Show:
    """One top on the page: a label, unit quaternions (frames, 4), scalar first, and positions of its tip.

    ``places`` (frames, 3) are in the model's unit; without them the tip stays at the origin.
    """

    label: str
    attitudes: ArrayLike
    places: ArrayLike | None = None

    @classmethod
    def of(cls, motion: Motion) -> Show:
        """Return the show of a motion, labelled with its name."""
        return cls(motion.name, motion.attitudes, motion.places and motion.tips(motion.times))


@dataclass(frozen=True)
class Curve:
    """A quantity over the frames, such as the energy: name, values (frames,) and unit."""

    name: str
    values: ArrayLike
    unit: str = ""


def curves_of(motion: Motion) -> list[Curve]:
    """Return tilt and energy of a simulated motion; nothing for other motions."""
    if motion.record is None:
        return []
    from numpy import degrees

    return [
        Curve("tilt", degrees(motion.tilts), "°"),
        Curve("energy", motion.record.energies, "J"),
    ]


def page(
    model: Model,
    shows: Sequence[Show],
    fps: float,
    *,
    curves: Sequence[Curve] = (),
    title: str = "The spinning top",
    camera: tuple[float, float] = (-60.0, 20.0),
    zoom: float = 1.0,
    background: str | None = None,
    simulation: HeavyTop | FreeTop | None = None,
) -> str:
    """Return the page on which the tops of ``shows`` spin side by side.

    ``camera`` is azimuth and elevation in degrees, ``zoom`` magnifies, ``background`` is a colour as
    ``#rrggbb``; without it the page follows the reader's light or dark scheme. With ``simulation`` the page
    starts with that top, computed live; a button switches to the film. Raises :class:`AnimationError` if
    there is no show, or for attitudes of another shape or values that are not finite.
    """
    if not shows:
        raise AnimationError("a page needs at least one top to show")
    azimuth, elevation = (math.radians(angle) for angle in camera)
    data = {
        "fps": fps,
        "camera": {"azimuth": azimuth, "elevation": elevation, "distance": 9.5 / zoom},
        "model": _shape(model),
        "environment": environment(),
        "shows": [
            {"label": show.label, "quaternions": _packed(show.attitudes, 4)}
            | (
                {}
                if show.places is None
                else {"places": _packed(_magnified(model, show.places), 3)}
            )
            for show in shows
        ],
        "curves": [
            {"name": curve.name, "unit": curve.unit, "values": _packed(curve.values, None)}
            for curve in curves
        ],
    }
    if simulation is not None:
        data["simulation"] = _live(simulation)
    text = _file("page.html")
    if background is None:
        text = text.replace('<html lang="en">', '<html lang="en" class="adaptive">')
    style = _style(background)
    script = "\n".join(
        _file(name) for name in (() if simulation is None else LIVE_SCRIPTS) + SCRIPTS
    )
    # A "<" inside the JSON could end the element that holds it.
    parts = {
        "title": escape(title),
        "style": style.rstrip(),
        "controls": "" if simulation is None else _file("simulator.html"),
        "readings": "" if simulation is None else READINGS,
        "keys": "" if simulation is None else KEYS,
        "modes": "" if simulation is None else MODE,
        "script": script.rstrip(),
        "data": json.dumps(data, separators=(",", ":")).replace("<", "\\u003c"),
    }
    for name, part in parts.items():
        text = text.replace(f"{{{{{name}}}}}", part)
    return text


def seeing() -> str:
    """Return the page "Seeing quaternions": products as rotations of S³, and the units over GF(3) and GF(5).

    >>> "600-cell" in seeing()
    True
    """
    parts = {"style": _style(None), "script": _file("seeing.js")}
    text = _file("seeing.html")
    for name, part in parts.items():
        text = text.replace(f"{{{{{name}}}}}", part.rstrip())
    return text


def _style(background: str | None) -> str:
    """Return the page's style, with the paper of the environment, or with one paper for light and dark
    schemes.
    """
    paper = environment()["paper"]
    style = _file("page.css").replace("{{paper}}", background or paper["light"])
    return style.replace("{{dark}}", paper["dark"])


def _shape(model: Model) -> dict[str, object]:
    """Return the profile of the top, its colours, and the colour index of each sector.

    As in pictures, the farthest point of a top of any size has distance 3 from its tip.
    """
    profile, tolerance = model.scaled(model.magnified).profile, OUTLINE_TOLERANCE
    while len(profile) > MAX_CORNERS:
        profile, tolerance = simplified(profile, tolerance), 2 * tolerance
    return {
        "profile": profile,
        "sectors": "".join(str(band % len(model.palette)) for band in model.sectors.tolist()),
        "colours": [[round(part / 255, 4) for part in colour] for colour in model.palette],
    }


def _magnified(model: Model, places: ArrayLike) -> ArrayLike:
    """Convert places from the model's unit to that of the page."""
    import numpy as np

    return model.magnified * np.asarray(places, dtype=np.float64)


def _live(top: HeavyTop | FreeTop) -> dict[str, object]:
    """Return the launch data of a heavy top, in the terms of heavy_top.js and free_top.js."""
    from anim.physics import Contact, FreeTop

    body, launch = top.body, top.launch
    contact = asdict(top.contact) if isinstance(top, FreeTop) else asdict(Contact()) | {"radius": 0}
    return {
        "body": {
            name: getattr(body, name) for name in ("mass", "height", "axial", "transverse", "reach")
        },
        "spin": top.spin,
        "tilt": launch.tilt,
        "precession": launch.precession,
        "heading": launch.heading,
        "gravity": launch.gravity,
        "contact": contact,
        "losses": [1 / launch.tilt_decay, 1 / launch.spin_decay],
    }


def _packed(values: ArrayLike, columns: int | None) -> str:
    """Return an array (frames,) or (frames, columns) as float32 in base64."""
    import numpy as np

    array = np.asarray(values, dtype=np.float64)
    wanted = (len(array),) if columns is None else (len(array), columns)
    if array.shape != wanted or not len(array):
        raise AnimationError(
            f"an array of shape {array.shape} does not fit: expected "
            f"({'frames,' if columns is None else f'frames, {columns}'}) with at least one frame"
        )
    with np.errstate(over="ignore"):
        single = array.astype("<f4")
    if not np.isfinite(single).all():
        raise AnimationError("the page cannot show values that are not finite, or 1e38 and more")
    return b64encode(single.tobytes()).decode()


def _file(name: str) -> str:
    return (files(__package__) / name).read_text(encoding="utf-8")
