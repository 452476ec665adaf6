"""Settings of pictures: camera, size, style, colours. Plain values, checked once."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from re import fullmatch

from anim.checks import one_of, real, whole
from anim.errors import AnimationError
from anim.picture.styles import STYLES
from hfield.plotting import import_matplotlib

RGB = tuple[int, int, int]
Point = tuple[float, float, float]

NEAREST = 6.0
"""A camera nearer to its target than this could be inside the turning top."""
LARGEST_SIDE = 16_384
CLOSEST = 100.0
"""The greatest zoom: a pixel is then a ten-thousandth of the top."""
MAX_PIXELS = 7680 * 4320


@dataclass(frozen=True)
class Camera:
    """The position of the camera; it always looks at the top and keeps z upright.

    ``azimuth`` and ``elevation`` are in degrees as in matplotlib (azimuth from the x axis towards the y axis;
    elevation above the ground, −90 to 90). ``distance`` is the distance from the top in the thesis's unit (at
    least 6); it has no effect if ``perspective`` is false (parallel rays). ``zoom`` enlarges the picture; 1
    is the largest value at which the whole top is visible. Raises :class:`~anim.errors.AnimationError`.

    >>> Camera(azimuth=30, zoom=2).elevation
    20.0
    """

    azimuth: float = -60.0
    elevation: float = 20.0
    distance: float = 12.0
    zoom: float = 1.0
    perspective: bool = True

    def __post_init__(self) -> None:
        elevation = real("the camera's elevation", self.elevation, least=-90)
        if elevation > 90:
            raise AnimationError(f"the camera's elevation is {elevation:g}; expected -90 to 90")
        zoom = real("the camera's zoom", self.zoom, above=0)
        if zoom > CLOSEST:
            raise AnimationError(f"the camera's zoom is {zoom:g}; expected at most {CLOSEST:g}")
        values = {
            "azimuth": real("the camera's azimuth", self.azimuth),
            "elevation": elevation,
            "distance": real("the camera's distance", self.distance, least=NEAREST),
            "zoom": zoom,
            "perspective": bool(self.perspective),
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @classmethod
    def parse(cls, text: str) -> "Camera":
        """Return the camera given by a text ``azimuth,elevation[,distance[,zoom]][,parallel]``.

        >>> Camera.parse("30, 15, 10")
        Camera(azimuth=30.0, elevation=15.0, distance=10.0, zoom=1.0, perspective=True)
        >>> Camera.parse("-60,20,parallel").perspective
        False
        """
        words = [word.strip() for word in text.split(",")]
        perspective = words[-1] not in ("parallel", "orthographic")
        numbers = words if perspective else words[:-1]
        if not 1 <= len(numbers) <= 4:
            raise AnimationError(
                f"camera {text!r} cannot be read; expected azimuth,elevation[,distance[,zoom]][,parallel]"
            )
        names = ("azimuth", "elevation", "distance", "zoom")
        values = {n: real(f"the camera's {n}", w) for n, w in zip(names, numbers, strict=False)}
        return cls(**values, perspective=perspective)


@dataclass(frozen=True)
class RenderSettings:
    """All settings of a picture besides the model and its attitude. Immutable, hashable, picklable.

    ``size`` is (width, height) in pixels, ``style`` a name in :data:`~anim.picture.styles.STYLES`.
    ``background`` is a matplotlib colour ("white", "#f5f2ea") or None for the style's own; ``colours``
    replaces the model's two. ``trace`` draws the path of the apex, ``shadow`` the shadow on the ground.
    ``quality`` is 1 (jagged edges) to 4 (smooth from 2 on). The picture shows all points of ``reach`` in the
    model's unit. Without ``reach`` it shows the whole top at the origin for every direction of tilt up to
    ``tilt`` degrees. With ``follow`` the camera follows a top that moves along the ground. Raises
    :class:`~anim.errors.AnimationError`.

    >>> RenderSettings(size=(1920, 1080), style="shaded", shadow=True).style
    'shaded'
    """

    size: tuple[int, int] = (640, 480)
    style: str = "flat"
    camera: Camera = field(default_factory=Camera)
    background: str | None = None
    colours: tuple[str, str] | None = None
    trace: bool = False
    shadow: bool = False
    quality: int = 2
    tilt: float = 90.0
    reach: tuple[Point, ...] = ()
    follow: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", _size(self.size))
        one_of("style", self.style, STYLES)
        if not isinstance(self.camera, Camera):
            raise AnimationError(f"camera is {self.camera!r}; expected a Camera")
        if self.background is not None:
            colour("background", self.background)
        if self.colours is not None:
            object.__setattr__(self, "colours", _two(self.colours))
        object.__setattr__(self, "quality", whole("quality", self.quality, 1, 4))
        tilt = real("tilt", self.tilt, least=0)
        if tilt > 180:
            raise AnimationError(f"tilt is {tilt:g}; expected 0 to 180 degrees")
        object.__setattr__(self, "tilt", tilt)
        reach = tuple(tuple(real("reach", x) for x in point) for point in self.reach)
        if any(len(point) != 3 for point in reach):
            raise AnimationError("reach has a point without three coordinates; expected (x, y, z)")
        object.__setattr__(self, "reach", reach)
        object.__setattr__(self, "follow", bool(self.follow))
        if self.follow and STYLES[self.style].fixed_axes:
            raise AnimationError(
                f"the style {self.style} has fixed axes, so its camera cannot follow the top; "
                "choose another style"
            )


def colour(name: str, value: object) -> RGB:
    """Return a colour as 8-bit sRGB; ``name`` is used in error messages."""
    if isinstance(value, str) and fullmatch("#[0-9a-fA-F]{6}", value):  # without matplotlib
        red, green, blue = bytes.fromhex(value[1:])
        return red, green, blue
    import_matplotlib()
    from matplotlib.colors import to_rgba

    try:
        *channels, opacity = to_rgba(value)
    except (ValueError, TypeError):
        raise AnimationError(
            f"{name} is {value!r}; expected a colour, such as white or #f5f2ea"
        ) from None
    if opacity < 1:
        raise AnimationError(
            f"{name} is {value!r}, which is transparent; expected an opaque colour"
        )
    red, green, blue = (round(255 * channel) for channel in channels)
    return red, green, blue


def _size(size: object) -> tuple[int, int]:
    sides = tuple(size) if isinstance(size, Iterable) and not isinstance(size, str) else ()
    if len(sides) != 2:
        raise AnimationError(f"size is {size!r}; expected (width, height) in pixels")
    width = whole("the width", sides[0], 1, LARGEST_SIDE)
    height = whole("the height", sides[1], 1, LARGEST_SIDE)
    if width * height > MAX_PIXELS:
        raise AnimationError(
            f"a picture of {width} x {height} has too many pixels; expected at most {MAX_PIXELS:,}"
        )
    return width, height


def _two(colours: object) -> tuple[str, str]:
    values = tuple(colours) if isinstance(colours, (tuple, list)) else ()
    if len(values) != 2:
        raise AnimationError(f"colours is {colours!r}; expected two colours")
    for value in values:
        colour("a colour of the top", value)
    return values[0], values[1]


FILM_SETTINGS = RenderSettings(style="shaded", trace=True, shadow=True)
"""The default settings of films."""
