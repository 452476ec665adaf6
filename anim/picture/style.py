"""What a style is: the room that the top stands in, and what draws the top itself."""

from abc import ABC, abstractmethod
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from anim.model import Model
from anim.picture.canvas import Canvas
from anim.picture.light import SharpShadow, places
from anim.picture.look import RGB, Look, colour
from anim.picture.mesh import Mesh
from anim.picture.projection import View, view

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]

PAPER: RGB = (246, 243, 236)


class Body(Protocol):
    """What draws the top itself."""

    def draw(self, canvas: Canvas, view: View, rotation: Floats) -> None:
        """Draw the top as ``view`` sees it, a view of the top's own room, which ``rotation`` has turned."""


@runtime_checkable
class Exposing(Protocol):
    """A body that draws many moments at once, nearly at the price of one."""

    def expose(
        self, canvas: Canvas, views: list[View], rotations: list[Floats], spin: float
    ) -> None:
        """Draw the mean of moments between which the top turns by ``spin`` radians in all."""


class Shadow(Protocol):
    """What draws the top's shadow on the ground."""

    def draw(self, canvas: Canvas, rotation: Floats, tip: Floats) -> None:
        """Draw the shadow of the top that ``rotation`` has turned and whose tip is at ``tip``."""


class Style(ABC):
    """One way to draw: a module of :mod:`anim.picture.styles`, whose first line says what it is like."""

    paper = PAPER
    """The background where the look has none."""

    def scene(self, model: Model, look: Look) -> tuple[View, Pixels]:
        """Return the projection and the picture without the top, uint8 (height, width, 3)."""
        return view(look.camera, look.size, places(model, look)), self.background(look)

    def background(self, look: Look) -> Pixels:
        """Return the picture without the top: even paper."""
        width, height = look.size
        return np.full((height, width, 3), self.paper_of(look), dtype=np.uint8)

    def paper_of(self, look: Look) -> RGB:
        """Return the look's background, or the style's own."""
        return self.paper if look.background is None else colour("background", look.background)

    def sheet(self, background: Pixels, look: Look) -> Any:
        """Return what this style's body and shadow are drawn on: a canvas, or as much of one as they need."""
        return Canvas(background, smooth=look.quality > 1)

    def shadow(self, mesh: Mesh, light: Floats, view: View, look: Look) -> Shadow:
        """Return what draws the shadow: one with a sharp edge."""
        return SharpShadow(mesh, light, view)

    @abstractmethod
    def body(self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, look: Look) -> Body:
        """Return what draws the top in two colours; ``light`` (3,) points to where light comes from."""
