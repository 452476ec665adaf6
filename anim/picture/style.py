"""The protocol of styles: a style makes the background and draws the top."""

from abc import ABC, abstractmethod
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from anim.model import Model
from anim.picture.canvas import Canvas
from anim.picture.light import SharpShadow, places
from anim.picture.mesh import Mesh
from anim.picture.projection import View, view
from anim.picture.settings import RGB, RenderSettings, colour

Floats = NDArray[np.float64]

PAPER: RGB = (246, 243, 236)


class TopPainter(Protocol):
    """Draws the top."""

    def draw(self, canvas: Canvas, view: View, rotation: Floats) -> None:
        """Draw the top with attitude ``rotation``; ``view`` is the view in the axes of the top."""


@runtime_checkable
class Exposing(Protocol):
    """A body that draws the mean of many moments at about the cost of one."""

    def expose(
        self, canvas: Canvas, views: list[View], rotations: list[Floats], spin: float
    ) -> None:
        """Draw the mean of several moments during which the top rotates by ``spin`` radians in total."""


class Shadow(Protocol):
    """Draws the shadow of the top on the ground."""

    def draw(self, canvas: Any, rotation: Floats, tip: Floats) -> None:
        """Draw the shadow of the top with attitude ``rotation`` and its tip at ``tip``."""


class Style(ABC):
    """A style of drawing: a module of :mod:`anim.picture.styles`, described by its first line."""

    paper = PAPER
    """The background where the settings have none."""
    fixed_axes = False
    """Whether the style draws axes in the model's unit, so that the camera does not move."""

    def scene(self, model: Model, settings: RenderSettings) -> tuple[View, Any]:
        """Return the projection and the background on which body and shadow are drawn."""
        width, height = settings.size
        paper = np.full((height, width, 3), self.paper_of(settings), dtype=np.uint8)
        seen = view(settings.camera, settings.size, places(model, settings))
        return seen, Canvas(paper, smooth=settings.quality > 1)

    def paper_of(self, settings: RenderSettings) -> RGB:
        """Return the background of the settings, or the style's own."""
        return (
            self.paper if settings.background is None else colour("background", settings.background)
        )

    def shadow(self, mesh: Mesh, light: Floats, view: View, settings: RenderSettings) -> Shadow:
        """Return the painter of a shadow with a sharp edge."""
        return SharpShadow(mesh, light, view)

    @abstractmethod
    def body(
        self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, settings: RenderSettings
    ) -> TopPainter:
        """Return the painter of the top in two colours; ``light`` (3,) points towards the light."""
