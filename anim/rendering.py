"""Draw the frames of a motion in order, in one or several processes, and write them to a file."""

from __future__ import annotations

from collections.abc import Callable, Generator
from concurrent.futures import Executor
from contextlib import closing
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from pathlib import Path
from threading import local
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from anim import attitude
from anim.checks import one_of, real, whole
from anim.errors import AnimationError
from anim.model import Model
from anim.motion import Motion
from anim.picture import RenderSettings, painter
from anim.picture.captions import WIDEST, WORDS, caption, captioned, strip
from anim.picture.styles import STYLES
from hfield.core.executors import InProcess, ordered

if TYPE_CHECKING:
    from anim.output.format import Film, Pixels

MIN_PATH_INSTANTS = 5000
"""The least number of instants at which the apex's path is computed."""
FRAMED = 500
"""The least number of instants of a motion from which the size of the top in a picture is chosen."""
SMOOTHING_SECONDS = 0.4
"""The standard deviation, in seconds of the film, of the filter that smooths a following camera's path."""
MAX_UNFOLLOWED_EXTENTS = 1.5
"""By default the camera follows a top whose path spans more than this, in units of its extent."""
MAX_TRACKED_INSTANTS = 5000
PATH_TOLERANCE = 0.1
"""How many pixels the line of the trace may stray from the apex's path."""

Progress = Callable[[int, int], None]


def framed(
    settings: RenderSettings, model: Model, motion: Motion, follow: bool | None = None
) -> RenderSettings:
    """Return the settings with the camera as close as possible while the whole motion is visible.

    ``follow`` says whether the camera moves with the top. With None it moves if the top would otherwise
    appear small, unless the style has fixed axes.
    """
    from anim.picture.projection import outermost, rim_points
    from rotation.matrices import to_matrix

    track = Track(model, motion)
    attitudes = np.asarray(to_matrix(motion.at(track.times)))
    tips = motion.tips(track.times)
    chosen = track.is_long and not STYLES[settings.style].fixed_axes if follow is None else follow
    if chosen:
        tips[:, :2] -= track.centres
    places = outermost(rim_points(model, attitudes, tips))
    return replace(settings, reach=tuple(map(tuple, places.tolist())), follow=chosen)


class Track:
    """The path of a camera that follows the top: the smoothed path of the midpoint of the top's axis."""

    def __init__(self, model: Model, motion: Motion) -> None:
        self._extent = model.extent
        count = max(FRAMED, min(motion.frames, MAX_TRACKED_INSTANTS))
        self.times: NDArray[np.float64] = np.linspace(0.0, motion.clip.seconds, count)
        middles = motion.tips(self.times)
        if motion.places is not None:
            middles += model.height / 2 * attitude.axes(motion.at(self.times))
        # A Gaussian mean over the film's time; beyond both ends the path is continued by point reflection.
        width = SMOOTHING_SECONDS * count / motion.duration
        reach = min(count - 1, int(4 * width) + 1)
        weights = np.exp(-((np.arange(-reach, reach + 1) / width) ** 2) / 2)
        padded = np.pad(middles[:, :2], ((reach, reach), (0, 0)), "reflect", reflect_type="odd")
        means = [np.convolve(way, weights / weights.sum(), "valid") for way in padded.T]
        self.centres: NDArray[np.float64] = np.column_stack(means)
        """(k, 2), in the model's unit, at :attr:`times`."""

    @property
    def is_long(self) -> bool:
        """Whether the top would appear small in a picture of its whole path."""
        return bool(np.ptp(self.centres, axis=0).max() > MAX_UNFOLLOWED_EXTENTS * self._extent)

    def at(self, time: float) -> tuple[float, float]:
        """Return where the camera is at an instant."""
        x, y = (float(np.interp(time, self.times, way)) for way in self.centres.T)
        return x, y


@dataclass(frozen=True, eq=False)
class Scene:
    """Everything that determines the frames: the model, its motion, the settings, and the blur.

    ``blur`` is the fraction, 0 to 1, of the time between two frames during which the shutter is open; a
    blurred frame is the mean of ``steps`` pictures. ``captions`` is the language, en or pl, of the captions
    (formula, tilt and spin); None for no captions. Raises :class:`~anim.errors.AnimationError`.

    >>> from anim import RenderSettings, Model, clip, kinematic
    >>> scene = Scene(Model(10), kinematic(clip=clip(frames=2)), RenderSettings((32, 24)))
    >>> scene.task(0).matrices.shape
    (1, 3, 3)
    """

    model: Model
    motion: Motion
    settings: RenderSettings
    blur: float = 0.0
    steps: int = 8
    captions: str | None = None

    def __post_init__(self) -> None:
        if real("motion blur", self.blur, least=0) > 1:
            raise AnimationError(f"motion blur is {self.blur:g}; expected a number from 0 to 1")
        whole("the steps of the blur", self.steps, 2, 64)
        if self.captions is not None:
            one_of("captions", self.captions, WORDS)
            strip(self.settings.size, self.captions, self.motion.name)  # raises if too small

    def task(self, number: int) -> FrameTask:
        """Return the data for drawing one frame, small enough to send to another process."""
        return self._task(float(self.motion.times[number]), self.motion.matrices[number][None])

    def task_at(self, time: float) -> FrameTask:
        """Return the data for drawing the picture at an instant, in seconds of the motion.

        At the instant of a frame the picture is that frame. Raises :class:`~anim.errors.AnimationError` for
        an instant outside the motion.

        >>> from anim import RenderSettings, Model, clip, kinematic
        >>> scene = Scene(Model(10), kinematic(clip=clip(frames=2)), RenderSettings((32, 24)))
        >>> scene.task_at(0.5).places.shape
        (1, 3)
        """
        from rotation.matrices import to_matrix

        motion, instant = self.motion, real("t", time, least=0)
        if instant > motion.clip.seconds:
            raise AnimationError(
                f"t is {instant:g}; the motion lasts {motion.clip.seconds:g} seconds"
            )
        number = int(np.argmin(np.abs(motion.times - instant)))
        if abs(motion.times[number] - instant) <= 1e-9 * motion.clip.seconds:
            return self.task(number)
        return self._task(instant, np.asarray(to_matrix(motion.at([instant]))))

    def _task(self, instant: float, matrices: NDArray[np.float64]) -> FrameTask:
        """Return the task of an instant at which the top has the attitude ``matrices`` (1, 3, 3)."""
        from rotation.matrices import to_matrix

        motion, instants = self.motion, np.array([instant])
        tips = motion.tips(instants)
        trail, ages = self._trail(instant, tips[0] + self.model.height * matrices[0, :, 2])
        task = FrameTask(
            self.model,
            self._scene_settings,
            matrices,
            trail,
            tips,
            ages,
            self._track.at(instant) if self.settings.follow else (0.0, 0.0),
        )
        if self.captions:
            tilt = float(np.degrees(attitude.tilts(matrices[:, :, 2]))[0])
            said = caption(self.captions, motion.name, tilt, self._spin(instant))
            task = replace(task, said=said, widest=self._widest, strip=self._strip)
        if self.blur:
            fractions = self.blur * ((np.arange(self.steps) + 0.5) / self.steps - 0.5)
            instants = instants + fractions * motion.clip.interval
            task = replace(
                task,
                matrices=np.asarray(to_matrix(motion.at(instants))),
                places=motion.tips(instants),
                spin=self._spin(instant) * float(np.ptp(instants)),
            )
        return task

    @cached_property
    def _track(self) -> Track:
        return Track(self.model, self.motion)

    @cached_property
    def _widest(self) -> tuple[str, ...]:
        """The widest captions that a frame can have."""
        return caption(self.captions or "en", self.motion.name, *WIDEST)

    @cached_property
    def _strip(self) -> int:
        """The height of the caption strip, in pixels."""
        return strip(self.settings.size, self.captions, self.motion.name) if self.captions else 0

    @cached_property
    def _scene_settings(self) -> RenderSettings:
        """The settings of the picture below the captions."""
        if self.captions is None:
            return self.settings
        width, height = self.settings.size
        return replace(self.settings, size=(width, height - self._strip))

    def _spin(self, instant: float) -> float:
        """Return the spin at an instant in rad/s, interpolated linearly between frames."""
        return float(np.interp(instant, self.motion.times, self._spins))

    @cached_property
    def _spins(self) -> NDArray[np.float64]:
        """The spin of each frame in rad/s."""
        motion = self.motion
        return motion.record.spins if motion.record else motion.spin_rates(motion.times)

    def _trail(
        self, instant: float, apex: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]] | tuple[None, None]:
        """Return the path (k, 3) of the apex up to an instant, and its ages (k,), if the path is drawn."""
        if not self.settings.trace:
            return None, None
        times, points = self._path
        passed = int(np.searchsorted(times, instant))
        ages = (instant - np.append(times[:passed], instant)) / self.motion.clip.time_scale
        return np.vstack([points[:passed], apex]), ages

    @cached_property
    def _path(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The path of the apex at the resolution of the picture: instants (k,) and points (k, 3).

        If there are few frames, the path is also computed between them. Points whose omission is not visible
        are left out, so that the cost of a frame does not grow with the length of the film.
        """
        from anim.picture.trace import thinned

        clip = self.motion.clip
        between = -(-MIN_PATH_INSTANTS // clip.frames)
        places = np.linspace(0, clip.frames - 1, (clip.frames - 1) * between + 1)
        times = places * clip.interval
        path = self.model.height * attitude.axes(self.motion.at(times)) + self.motion.tips(times)
        # The top is two thirds of its extent wide at least, and no wider than the picture.
        pixel = 2 / (
            max(self._scene_settings.size) * self.settings.camera.zoom * self.model.magnified
        )
        kept = thinned(path, pixel * PATH_TOLERANCE)
        return times[kept], path[kept]


@dataclass(frozen=True, eq=False)
class FrameTask:
    """The data of one frame: attitudes (steps, 3, 3) and tip positions (steps, 3) to draw and average.

    ``trail`` is the apex's path so far, (k, 3); ``ages`` (k,) are the seconds of the film since it passed
    each point. ``centre`` (2,) is the position of a camera that follows the top. ``said`` are the captions,
    written above the picture in a strip of ``strip`` pixels; ``widest`` are the widest captions of the film.
    """

    model: Model
    settings: RenderSettings
    matrices: NDArray[np.float64]
    trail: NDArray[np.float64] | None
    places: NDArray[np.float64]
    ages: NDArray[np.float64] | None = None
    centre: tuple[float, float] = (0.0, 0.0)
    said: tuple[str, ...] = ()
    widest: tuple[str, ...] = ()
    strip: int = 0
    spin: float = 0.0
    """How far the top turns about its own axis from the first to the last attitude, in radians."""


def draw(task: FrameTask) -> Pixels:
    """Draw one frame, uint8 (height, width, 3)."""
    brush = _own.painter(task.model, task.settings)
    if len(task.matrices) == 1:
        path = task.trail, task.places[0], task.ages
        picture = brush.draw(task.matrices[0], *path, task.centre)
    else:
        path_of_all = task.trail, task.places, task.spin, task.ages
        picture = brush.expose(task.matrices, *path_of_all, task.centre)
    if task.said:
        paper = STYLES[task.settings.style].paper_of(task.settings)
        return captioned(picture, task.said, task.widest, task.strip, paper)
    return picture


class _Painters(local):
    """The painters of a thread, reused for all frames; each has its own canvas."""

    def __init__(self) -> None:
        self.painter = lru_cache(maxsize=2)(painter)


_own = _Painters()


def frames(
    scene: Scene, executor: Executor | None = None, jobs: int = 1, numbers: range | None = None
) -> Generator[Pixels, None, None]:
    """Yield the frames ``numbers`` (by default all) in order, with at most 2·jobs of them in progress."""
    chosen = range(scene.motion.frames) if numbers is None else numbers
    tasks = (scene.task(number) for number in chosen)
    return ordered(executor or InProcess(), draw, tasks, ahead=2 * jobs if jobs > 1 else 1)


def render(
    scene: Scene,
    path: Path,
    film: Film,
    *,
    executor: Executor | None = None,
    jobs: int = 1,
    force: bool = False,
    progress: Progress | None = None,
) -> None:
    """Draw all frames and write them to ``path``, in the format of its suffix.

    The file is written completely or not at all. Raises :class:`~anim.errors.AnimationError`.

    >>> from tempfile import TemporaryDirectory
    >>> from anim.output import Film
    >>> from anim.pipelines import kinematic
    >>> from anim.film import clip
    >>> scene = Scene(Model(10), kinematic(clip=clip(frames=2)), RenderSettings((32, 24)))
    >>> with TemporaryDirectory() as folder:
    ...     render(scene, Path(folder) / "film", Film((32, 24), 2, 50.0))
    ...     print(len(list(Path(folder, "film").iterdir())))
    2
    """
    from anim.output.palette import sampled
    from anim.output.writing import open_film
    from hfield.plotting import import_matplotlib

    if jobs > 1:
        import_matplotlib()  # first here, so that other processes know its folder

    def samples() -> list[Pixels]:
        return [draw(scene.task(number)) for number in sampled(film.frames)]

    with (
        open_film(path, film, samples, force) as write,
        closing(frames(scene, executor, jobs)) as pictures,
    ):
        for number, picture in enumerate(pictures, 1):
            write(picture)
            if progress:
                progress(number, film.frames)


def contact_sheet(scene: Scene, numbers: list[int]) -> Pixels:
    """Return the frames with these numbers in one picture (figures 3.3 and 3.4)."""
    from anim.output.sheet import sheet

    return sheet([draw(scene.task(number)) for number in numbers], numbers)
