"""The top as one object, for notebooks and scripts."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from anim.film import Clip
from anim.given_motion import MotionSource, motion_of
from anim.model import Model
from anim.motion import Motion

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from anim.picture import RenderSettings
    from anim.rendering import Scene

Pixels = NDArray[np.uint8]

FRAME_HEIGHT = 480


class Top:
    """A model in motion. It displays itself in Jupyter, as :meth:`show` does.

    ``motion`` is a :class:`~anim.motion.Motion`, the name of one of the thesis's pipelines, quaternions (n,
    4), a :class:`~rotation.Rotation`, a function of time, or the path of a file of quaternions; see
    :func:`~anim.given_motion.motion_of`. ``clip`` gives the number and rate of frames; a Motion has its own.
    Raises :class:`~anim.errors.AnimationError` if ``motion`` is invalid, and
    :class:`~hfield.errors.TableError` for a file that is not a table of numbers.

    >>> from anim import Model, Top
    >>> Top("product", Model(ring=60))
    Top('product', 60 points on a ring, 500 frames at 50 a second)
    >>> from rotation import Rotation
    >>> turns = Rotation.from_rotvec([[0, 0, 0.1 * n] for n in range(100)])
    >>> Top(turns, Model.from_outline([(0, 0), (1, 1), (3, 0)])).frame(0.5).shape
    (480, 640, 3)
    """

    def __init__(
        self,
        motion: MotionSource = "quaternions",
        model: Model | None = None,
        clip: Clip | None = None,
    ) -> None:
        self.motion = motion_of(motion, clip)
        self.model = Model() if model is None else model

    def frame(self, t: float, settings: RenderSettings | None = None) -> Pixels:
        """Return the picture at ``t`` seconds of the motion, uint8 (height, width, 3), top row first.

        The default settings are those of films: shaded, 640 × 480 pixels, with trace and shadow. At the time
        of a frame of the film the picture is that frame. Raises :class:`~anim.errors.AnimationError` for
        ``t`` outside the motion.
        """
        from anim.rendering import draw

        return draw(self._scene(settings).task_at(t))

    def frames(self, settings: RenderSettings | None = None) -> Iterator[Pixels]:
        """Yield the frames of the film in order, each uint8 (height, width, 3)."""
        from anim.rendering import frames

        return frames(self._scene(settings))

    def draw(self, ax: Axes, t: float = 0.0, settings: RenderSettings | None = None) -> Artist:
        """Draw the top at ``t`` seconds of the motion into matplotlib axes; return the artist.

        In plain axes the result is the picture of :meth:`frame`, by default with as many pixels as the axes
        have. In three-dimensional axes it is the surface, in the model's unit; hidden faces are removed
        correctly from every direction, and ``ax.set_aspect("equal")`` keeps the proportions. Raises
        :class:`~anim.errors.AnimationError` for ``t`` outside the motion, and for ``settings`` with
        three-dimensional axes, which have their own view.
        """
        from anim.matplotlib_axes import draw_in_axes

        return draw_in_axes(self.model, self.motion, ax, t, settings)

    def page(self) -> str:
        """Return the web page in which the top spins, as HTML; a physical top is computed live on it."""
        from anim.physics import FreeTop, HeavyTop
        from anim.viewer import Show, curves_of, page

        followed, curves = self.motion.sampler, curves_of(self.motion)
        live = followed if isinstance(followed, (HeavyTop, FreeTop)) else None
        shows = [Show.of(self.motion)]
        return page(self.model, shows, self.motion.fps, curves=curves, simulation=live)

    def save(
        self,
        path: str | Path,
        settings: RenderSettings | None = None,
        force: bool = False,
        frame: int = 0,
    ) -> None:
        """Write a film, a web page (.html) or one picture (.png), depending on the suffix, like ``hfield
        render``.

        A name without a suffix is a folder of pictures. Without ``settings`` films and pictures are shaded,
        with trace and shadow; a page has its own settings. ``frame``, counted from 0, is the frame of a
        picture. Raises :class:`~anim.errors.AnimationError`.
        """
        from anim.checks import whole
        from anim.output import Film, check
        from anim.output.destination import file_place, write_text
        from anim.output.pictures import save_png
        from anim.output.writing import OutputKind, kind_of
        from anim.rendering import draw, render

        place = Path(path)
        kind = kind_of(place)
        if kind is OutputKind.PAGE:
            check(place, None, force)
            return write_text(place, self.page(), force)
        scene = self._scene(settings)
        if kind is OutputKind.PICTURE:
            number = whole("frame", frame, 0, self.motion.frames - 1)
            check(place, None, force)
            with file_place(place, force) as part:
                save_png(draw(scene.task(number)), part)
            return None
        return render(
            scene,
            place,
            Film(scene.settings.size, self.motion.frames, self.motion.fps),
            force=force,
        )

    def _scene(self, settings: RenderSettings | None) -> Scene:
        """Return the scene of the frames; recent scenes are cached."""
        return _scene(self.model, self.motion, settings)

    def show(self) -> None:
        """Display the top in a notebook; elsewhere, write it as a page and open the browser."""
        try:
            from IPython import get_ipython
        except ImportError:
            in_notebook = False
        else:
            in_notebook = get_ipython() is not None
        if in_notebook:
            from IPython.display import HTML, display

            display(HTML(self._repr_html_()))
            return
        import tempfile
        import webbrowser

        with tempfile.NamedTemporaryFile(
            "w", suffix=".html", delete=False, encoding="utf-8"
        ) as file:
            file.write(self.page())
        webbrowser.open(Path(file.name).as_uri())

    def _repr_html_(self) -> str:
        """Return an inline frame, so that the page and the notebook do not affect each other."""
        return (
            f'<iframe srcdoc="{escape(self.page())}" title="A spinning top" '
            f'style="width: 100%; height: {FRAME_HEIGHT}px; border: 0"></iframe>'
        )

    def __repr__(self) -> str:
        return (
            f"Top({self.motion.name!r}, {self.model.ring} points on a ring, "
            f"{self.motion.frames} frames at {self.motion.fps:g} a second)"
        )


@lru_cache(maxsize=4)
def _scene(model: Model, motion: Motion, settings: RenderSettings | None) -> Scene:
    from anim.picture.settings import FILM_SETTINGS
    from anim.rendering import Scene, framed

    return Scene(
        model, motion, framed(FILM_SETTINGS, model, motion) if settings is None else settings
    )
