"""From a motion to a file: frames drawn in order, here or in other processes, and handed to a writer."""

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

from anim.checks import one_of, real, whole
from anim.errors import AnimationError
from anim.model import APEX_HEIGHT, Model
from anim.motion import Motion
from anim.picture import Look, painter
from anim.picture.captions import WIDEST, WORDS, caption, captioned, strip
from anim.picture.styles import STYLES
from hfield.executors import InProcess, ordered

if TYPE_CHECKING:
    from anim.output.format import Film, Frame

FINE = 5000
"""At how many instants, at least, the apex's path is followed."""
FRAMED = 500
"""At so many instants a motion is looked at to decide how close a picture may be."""
UNSEEN = 0.1
"""How many pixels the line of the trace may stray from the apex's path."""

Progress = Callable[[int, int], None]


def framed(look: Look, model: Model, motion: Motion) -> Look:
    """Return the look, as close as all places of a top in motion allow."""
    from anim.picture.projection import outermost, swept
    from rotation.matrices import to_matrix

    times = np.linspace(0.0, motion.clip.seconds, FRAMED)
    attitudes = np.asarray(to_matrix(motion.at(times)))
    places = outermost(swept(model, attitudes, motion.tips(times)))
    return replace(look, reach=tuple(map(tuple, places.tolist())))


@dataclass(frozen=True, eq=False)
class Scene:
    """All that decides the frames: the model, its motion, the look, and the blur.

    ``blur`` is the part of the time between two frames during which the shutter is open, 0 to 1; a
    blurred frame is the mean of ``steps`` pictures. ``captions`` is the language, en or pl, in which formula,
    tilt and spin are told; None: not at all. Raises :class:`~anim.errors.AnimationError`.

    >>> from anim import Look, Model, clip, kinematic
    >>> scene = Scene(Model(10), kinematic(clip=clip(frames=2)), Look((32, 24)))
    >>> scene.task(0).matrices.shape
    (1, 3, 3)
    """

    model: Model
    motion: Motion
    look: Look
    blur: float = 0.0
    steps: int = 8
    captions: str | None = None

    def __post_init__(self) -> None:
        if real("motion blur", self.blur, least=0) > 1:
            raise AnimationError(f"motion blur is {self.blur:g}; expected a number from 0 to 1")
        whole("the steps of the blur", self.steps, 2, 64)
        if self.captions is not None:
            one_of("captions", self.captions, WORDS)
            strip(self.look.size, self.captions, self.motion.name)  # refuses what is too small

    def task(self, number: int) -> Task:
        """Return what it takes to draw one frame; small, so that it travels to another process."""
        from rotation.matrices import to_matrix

        motion, instants = self.motion, self.motion.times[number][None]
        matrices = motion.matrices[number][None]
        if self.blur:
            fractions = self.blur * ((np.arange(self.steps) + 0.5) / self.steps - 0.5)
            instants = instants + fractions * motion.clip.interval
            matrices = np.asarray(to_matrix(motion.at(instants)))
        words, spin = (
            self.captions,
            self._told[number][1] * float(np.ptp(instants)) if self.blur else 0.0,
        )
        said = (
            (caption(words, motion.name, *self._told[number]), self._widest) if words else ((), ())
        )
        trail = self._trail(number)
        places = motion.tips(instants)
        return Task(self.model, self._scene_look, matrices, trail, places, *said, self._strip, spin)

    @cached_property
    def _widest(self) -> tuple[str, ...]:
        """The captions of a frame in which they take the most room."""
        return caption(self.captions or "en", self.motion.name, *WIDEST)

    @cached_property
    def _strip(self) -> int:
        """How high the strip for the captions is, in pixels."""
        return strip(self.look.size, self.captions, self.motion.name) if self.captions else 0

    @cached_property
    def _scene_look(self) -> Look:
        """The look of what is below the captions."""
        if self.captions is None:
            return self.look
        width, height = self.look.size
        return replace(self.look, size=(width, height - self._strip))

    @cached_property
    def _told(self) -> list[tuple[float, float]]:
        """Tilt in degrees and spin in rad/s of each frame."""
        motion = self.motion
        spins = motion.record.spins if motion.record else motion.spin_rates(motion.times)
        return list(zip(np.degrees(motion.tilts).tolist(), spins.tolist(), strict=True))

    def _trail(self, number: int) -> NDArray[np.float64] | None:
        """Return the apex's path (k, 3) up to a frame, if it is to be drawn."""
        if not self.look.trace:
            return None
        places, points = self._path
        here = self._apexes[number]
        return np.vstack([points[: np.searchsorted(places, number)], here])

    @cached_property
    def _apexes(self) -> NDArray[np.float64]:
        return self.motion.apex()

    @cached_property
    def _path(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The apex's path as far as a picture can show it: places (k,) counted in frames, and points (k, 3).

        Between few frames it is followed too; of many, those that make no difference are left out, so that
        what a frame costs does not grow with the film.
        """
        from anim.picture.trace import thinned
        from rotation.matrices import to_matrix

        clip = self.motion.clip
        between = -(-FINE // clip.frames)
        places = np.linspace(0, clip.frames - 1, (clip.frames - 1) * between + 1)
        turned = np.asarray(to_matrix(self.motion.at(places * clip.interval)))
        path = APEX_HEIGHT * turned[:, :, 2] + self.motion.tips(places * clip.interval)
        # The top is about two units wide at least, and no wider than the picture.
        pixel = 2 / (max(self._scene_look.size) * self.look.camera.zoom)
        kept = thinned(path, pixel * UNSEEN)
        return places[kept], path[kept]


@dataclass(frozen=True, eq=False)
class Task:
    """One frame: attitudes (steps, 3, 3) and places (steps, 3) of the tip to draw and average.

    ``trail`` is the apex's path so far, (k, 3); ``said`` the lines to be written above the picture,
    in a strip of so many pixels; ``widest`` lines that take the most room.
    """

    model: Model
    look: Look
    matrices: NDArray[np.float64]
    trail: NDArray[np.float64] | None
    places: NDArray[np.float64]
    said: tuple[str, ...] = ()
    widest: tuple[str, ...] = ()
    strip: int = 0
    spin: float = 0.0
    """How far the top turns about its own axis from the first to the last attitude, in radians."""


def draw(task: Task) -> Frame:
    """Draw one frame, uint8 (height, width, 3)."""
    brush = _own.painter(task.model, task.look)
    if len(task.matrices) == 1:
        picture = brush.draw(task.matrices[0], task.trail, task.places[0])
    else:
        picture = brush.expose(task.matrices, task.trail, task.places, task.spin)
    if task.said:
        paper = STYLES[task.look.style].paper_of(task.look)
        return captioned(picture, task.said, task.widest, task.strip, paper)
    return picture


class _Painters(local):
    """The painters of a thread, kept from one frame to the next: each draws on a canvas of its own."""

    def __init__(self) -> None:
        self.painter = lru_cache(maxsize=2)(painter)


_own = _Painters()


def frames(
    scene: Scene, executor: Executor | None = None, jobs: int = 1, numbers: range | None = None
) -> Generator[Frame, None, None]:
    """Yield the frames in order, at most 2·jobs of them in flight; all of them without ``numbers``."""
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

    The file is whole or is not there. Raises :class:`~anim.errors.AnimationError`.

    >>> from tempfile import TemporaryDirectory
    >>> from anim.output import Film
    >>> from anim.pipelines import kinematic
    >>> from anim.film import clip
    >>> scene = Scene(Model(10), kinematic(clip=clip(frames=2)), Look((32, 24)))
    >>> with TemporaryDirectory() as folder:
    ...     render(scene, Path(folder) / "film", Film((32, 24), 2, 50.0))
    ...     print(len(list(Path(folder, "film").iterdir())))
    2
    """
    from anim.output.palette import sampled
    from anim.output.writing import open_film
    from hfield.plotting import import_matplotlib

    if jobs > 1:
        import_matplotlib()  # here first, so that other processes know where its folder is

    def samples() -> list[Frame]:
        return [draw(scene.task(number)) for number in sampled(film.frames)]

    with (
        open_film(path, film, samples, force) as write,
        closing(frames(scene, executor, jobs)) as pictures,
    ):
        for number, picture in enumerate(pictures, 1):
            write(picture)
            if progress:
                progress(number, film.frames)


def contact_sheet(scene: Scene, numbers: list[int]) -> Frame:
    """Return the frames of these numbers in one picture (figures 3.3 and 3.4)."""
    from anim.output.sheet import sheet

    return sheet([draw(scene.task(number)) for number in numbers], numbers)
