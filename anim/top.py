"""The top as one object, for notebooks and scripts."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from anim.model import Model
from anim.motion import Motion
from anim.pipelines import kinematic

if TYPE_CHECKING:
    from anim.picture import Look

FRAME_HEIGHT = 480


class Top:
    """A model in motion. In Jupyter it shows itself, as does :meth:`show`.

    ``motion`` is a :class:`~anim.motion.Motion`, or the name of one of the thesis's pipelines. Raises
    :class:`~anim.errors.AnimationError` for another name.

    >>> from anim import Model, Top
    >>> Top("product", Model(ring=60))
    Top('product', 60 points on a ring, 500 frames at 50 a second)
    """

    def __init__(self, motion: Motion | str = "quaternions", model: Model | None = None) -> None:
        self.motion = kinematic(motion) if isinstance(motion, str) else motion
        self.model = Model() if model is None else model

    def page(self) -> str:
        """Return the web page in which the top turns, as HTML; one that obeys physics is live on it."""
        from anim.physics import FreeTop, HeavyTop
        from anim.viewer import Show, curves_of, page

        followed, curves = self.motion.sampler, curves_of(self.motion)
        live = followed if isinstance(followed, (HeavyTop, FreeTop)) else None
        shows = [Show.of(self.motion)]
        return page(self.model, shows, self.motion.fps, curves=curves, simulation=live)

    def save(
        self, path: str | Path, look: Look | None = None, force: bool = False, frame: int = 0
    ) -> None:
        """Write a film, a web page (.html) or one picture (.png), by the suffix, as ``hfield render`` does.

        A name without suffix is a folder of pictures. Films and pictures are without ``look`` shaded, with
        trace and shadow; a page has its own. ``frame``, counted from 0, is the one of a picture. Raises
        :class:`~anim.errors.AnimationError`.
        """
        from anim.checks import whole
        from anim.output import Film, check
        from anim.output.destination import file_place, write_text
        from anim.output.pictures import save_png
        from anim.output.writing import Kind, kind_of
        from anim.picture.look import FILM_LOOK
        from anim.rendering import Scene, draw, framed, render

        place = Path(path)
        kind = kind_of(place)
        if kind is Kind.PAGE:
            check(place, None, force)
            return write_text(place, self.page(), force)
        chosen = framed(FILM_LOOK, self.model, self.motion) if look is None else look
        scene = Scene(self.model, self.motion, chosen)
        if kind is Kind.PICTURE:
            number = whole("frame", frame, 0, self.motion.frames - 1)
            check(place, None, force)
            with file_place(place, force) as part:
                save_png(draw(scene.task(number)), part)
            return None
        return render(
            scene, place, Film(chosen.size, self.motion.frames, self.motion.fps), force=force
        )

    def show(self) -> None:
        """Display the top in a notebook; elsewhere it is written as a page and opened in the browser."""
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
        """Return a frame of its own, so that the page and the notebook leave each other alone."""
        return (
            f'<iframe srcdoc="{escape(self.page())}" title="A spinning top" '
            f'style="width: 100%; height: {FRAME_HEIGHT}px; border: 0"></iframe>'
        )

    def __repr__(self) -> str:
        return (
            f"Top({self.motion.name!r}, {self.model.ring} points on a ring, "
            f"{self.motion.frames} frames at {self.motion.fps:g} a second)"
        )
