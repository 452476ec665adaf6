"""Matplotlib's three-dimensional axes, as in the thesis.

The axes are drawn once, as a background.

The axes have their own projection, which the top, its shadow and its path share.
"""

from math import hypot
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from anim.model import Model
from anim.picture.canvas import Canvas
from anim.picture.light import places
from anim.picture.mesh import Mesh
from anim.picture.projection import View, fitting, reached
from anim.picture.settings import RGB, RenderSettings
from anim.picture.style import Style
from anim.picture.styles.flat import FlatBody
from hfield.plotting import default_settings

if TYPE_CHECKING:
    from mpl_toolkits.mplot3d import Axes3D

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]

DPI = 100
LETTERS = 30
"""The letters' height as a part of the picture's shorter side."""
SMALLEST_LETTERED = 160
"""Pictures with a shorter side than this have no letters, which nobody could read."""


@default_settings()
def axes_and_view(model: Model, settings: RenderSettings, paper: RGB) -> tuple[View, Pixels]:
    """Return the projection of matplotlib's axes and a picture (height, width, 3) of the empty axes."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d import Axes3D

    width, height = settings.size
    figure = Figure(figsize=(width / DPI, height / DPI), dpi=DPI)
    figure.set_facecolor([channel / 255 for channel in paper])
    canvas = FigureCanvasAgg(figure)
    axes = Axes3D(figure, rect=(0, 0, 1, 1))
    figure.add_axes(axes)
    axes.patch.set_visible(False)
    _set_up(axes, model, settings, reached(model, settings))
    _fit(axes, settings, places(model, settings))
    canvas.draw()
    return view_of(axes), np.asarray(canvas.buffer_rgba())[:height, :width, :3].copy()


def _set_up(axes: "Axes3D", model: Model, settings: RenderSettings, there: Floats) -> None:
    """Set camera, limits, labels and fonts; the unit has the same length on every axis."""
    from matplotlib.ticker import MaxNLocator

    camera = settings.camera
    reach = float(np.abs(there[:, :2]).max())
    tall = max(model.height, float(there[:, 2].max()))
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), zlim=(0, tall), autoscale_on=False)
    axes.set_box_aspect((2 * reach, 2 * reach, tall))
    axes.view_init(elev=camera.elevation, azim=camera.azimuth)
    if camera.perspective:
        # Matplotlib's eye is 10 focal lengths from the middle of a box whose diagonal is about 1.9 long.
        unit = 1.9 / hypot(2 * reach, 2 * reach, tall)
        axes.set_proj_type("persp", focal_length=camera.distance / model.magnified * unit / 10)
    else:
        axes.set_proj_type("ortho")
    size = min(settings.size) / LETTERS * 72 / DPI
    for name, axis in (("x", axes.xaxis), ("y", axes.yaxis), ("z", axes.zaxis)):
        axis.set_tick_params(labelsize=size, pad=size / 6)
        axis.set_major_locator(MaxNLocator(4, steps=[1, 2, 5, 10]))  # more numbers would touch
        if min(settings.size) < SMALLEST_LETTERED:
            axis.set_ticklabels([])
        else:
            axis.set_label_text(name, fontsize=size, fontstyle="italic")
            axis.labelpad = size / 4


def _fit(axes: "Axes3D", settings: RenderSettings, there: Floats) -> None:
    """Place the axes so that their box and the tilted top fill the picture."""
    (west, east), (south, north), (ground, top) = axes.get_xlim(), axes.get_ylim(), axes.get_zlim()
    box = [(x, y, z) for x in (west, east) for y in (south, north) for z in (ground, top)]
    seen = view_of(axes).project(np.concatenate([there, np.array(box)]))
    margin = 0.02 if min(settings.size) < SMALLEST_LETTERED else 0.02 + 3.2 / LETTERS
    scale, shift = fitting(seen, settings.size, margin, settings.camera.zoom)
    size = np.array(settings.size)
    # The axes take the largest square inside their rectangle.
    window = axes.get_position().frozen()
    corner = np.array([window.x0, window.y0]) * size
    side = scale * np.array([window.width, window.height]) * size
    axes.set_position([*((scale * corner + shift) / size), *(side / size)])


def view_of(axes: "Axes3D") -> View:
    """Return the axes' projection to pixels, measured from the lower left corner."""
    axes.apply_aspect()
    affine = axes.transData.get_matrix()
    place = np.eye(4)
    place[np.ix_([0, 1], [0, 1, 3])] = affine[:2]
    place[2, 2] = -1  # matplotlib's depth grows away from the eye
    return View(place @ axes.get_proj())


class Classic(Style):
    """The thesis's picture: empty axes on white paper, and the top in its two colours."""

    paper: RGB = (255, 255, 255)
    fixed_axes = True

    def scene(self, model: Model, settings: RenderSettings) -> tuple[View, Canvas]:
        """Return the axes' own projection, and the axes."""
        seen, axes = axes_and_view(model, settings, self.paper_of(settings))
        return seen, Canvas(axes, smooth=settings.quality > 1)

    def body(
        self, mesh: Mesh, colours: tuple[RGB, RGB], light: Floats, settings: RenderSettings
    ) -> FlatBody:
        """Return the body in the colours given."""
        return FlatBody(mesh, [colours] * (len(mesh.profile) - 1))


STYLE = Classic()
