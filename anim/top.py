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

    def save(self, path: str | Path, look: Look | None = None, force: bool = False) -> None:
        """Write a film, in the format of the suffix; without ``look`` shaded, with trace and shadow.

        Raises :class:`~anim.errors.AnimationError`.
        """
        from anim.output import Film
        from anim.picture.look import FILM_LOOK
        from anim.rendering import Scene, framed, render

        chosen = framed(FILM_LOOK, self.model, self.motion) if look is None else look
        film = Film(chosen.size, self.motion.frames, self.motion.fps)
        render(Scene(self.model, self.motion, chosen), Path(path), film, force=force)

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
