"""Check that an implementation is correct, then time it.

An implementation whose result differs from :meth:`Task.expected` is not timed. Each repetition runs all
implementations in turn, so that a disturbance of the machine does not affect only one of them.
"""

from __future__ import annotations

import gc
import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from itertools import pairwise
from statistics import mean, median
from time import perf_counter
from typing import TYPE_CHECKING, Literal

import numpy as np

from rotation.array_types import ArrayLike
from rotation.bench.tasks import Array, Task, Test
from rotation.bench.ways.way import FrameFunction, Way

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import DTypeLike

TOLERANCE = (
    1e-13  # largest error of a coordinate, relative to the largest coordinate if that is over 1
)
SLOW_POINTS = 5_000  # points that a slow way is timed on
MIN_REPEATS = 2
SHORT_FRAME_SECONDS = (
    0.02  # frames shorter than this are timed again before the number of frames is chosen
)

Status = Literal["ok", "missing", "wrong", "failed"]
Report = Callable[[str], None]


@dataclass(frozen=True)
class Settings:
    """The extent of a benchmark; ``seconds`` limits the time of one implementation in one test, without
    checks.

    ``cloud`` are the user's points and ``points`` is their number; if ``cloud`` is None the points are
    random.
    """

    points: int = 550_000
    frames: int = 300
    repeats: int = 10
    threads: int = 1
    seconds: float = 1.5
    cloud: Array | None = field(default=None, repr=False, compare=False)

    def task(self, test: Test, points: int | None = None) -> Task:
        """Return the input of a test, restricted to the first ``points`` points if that is given."""
        number = self.points if points is None else min(points, self.points)
        return test.make(number if self.cloud is None else self.cloud[:number], self.frames)


@dataclass
class Result:
    """The result of one implementation in one test, in seconds per frame of all points.

    ``samples`` has one mean per repetition; ``best`` is the fastest frame, the one least disturbed.
    ``points`` and ``frames`` are the timed amounts; multiplying by ``scale`` gives the time for all points.
    ``error`` is the largest distance from the expected coordinates, ``moved`` the largest distance from the
    original points.
    """

    test: Test
    way: Way
    status: Status = "ok"
    reason: str = ""
    version: str = ""
    points: int = 0
    frames: int = 0
    scale: float = 1.0
    error: float = 0.0
    moved: float = 0.0
    samples: list[float] = field(default_factory=list)
    best: float = math.inf

    @property
    def mean(self) -> float:
        """The mean time of a frame in seconds, as in the thesis."""
        return mean(self.samples)

    @property
    def median(self) -> float:
        """The median time of a frame in seconds."""
        return median(self.samples)


@dataclass
class _Runner:
    result: Result
    frame: FrameFunction
    chosen: Sequence[int]
    repeats: int


def run_test(
    test: Test, ways: Sequence[Way], settings: Settings, report: Report = lambda what: None
) -> list[Result]:
    """Check and time the implementations that support the test; ``report`` is called with the current
    step.
    """
    task = settings.task(test)
    expected = task.expected(task.check)
    results, runners = [], []
    with ExitStack() as stack:
        stack.enter_context(_own_threads(settings.threads))
        deal = stack.enter_context(_dealer(settings.threads))
        for way in (way for way in ways if task.kind in way.makes):
            report(f"{test.name}: checking {way.name}")
            result = Result(test, way)
            results.append(result)
            runner = _prepare(result, task, expected, settings, deal)
            if runner is not None:
                runners.append(runner)
        stack.enter_context(_no_collector())
        for turn in range(settings.repeats):
            for runner in (runner for runner in runners if turn < runner.repeats):
                report(f"{test.name}: {runner.result.way.name}")
                _sample(runner)
    return results


def _prepare(
    result: Result,
    task: Task,
    expected: Array,
    settings: Settings,
    deal: Callable[[Way, Task], FrameFunction],
) -> _Runner | None:
    """Prepare the task for an implementation, check it, and choose the number of frames; None if it cannot
    run.
    """
    way = result.way
    if way.slow:
        task = task.part(0, min(SLOW_POINTS, settings.points))
    result.points, result.scale = len(task.points), settings.points / len(task.points)
    if find_spec(way.module) is None:
        result.status = "missing"
        return None
    result.version = _version(way.distribution)
    try:
        frame = deal(way, task)
        turned = points_of(frame(task.check))
        seconds = _times(frame, [0])[0]
        if seconds < SHORT_FRAME_SECONDS:
            seconds = min(_times(frame, [0, 0, 0]))
    except Exception as error:
        if way.role not in ("peer", "own"):
            raise
        result.status, result.reason = "failed", f"{type(error).__name__}: {error}"
        return None
    difference = wrong_result(way, turned, expected[: len(task.points)], task)
    if difference is not None:
        result.status, result.reason = "wrong", difference
        return None
    result.moved = float(np.abs(turned - task.points).max())
    if way.rotates:
        result.error = float(np.abs(turned - expected[: len(turned)]).max())
    repeats = int(
        np.clip(settings.seconds / seconds, min(MIN_REPEATS, settings.repeats), settings.repeats)
    )
    result.frames = int(np.clip(settings.seconds / (repeats * seconds), 1, settings.frames))
    chosen = np.linspace(0, settings.frames - 1, result.frames).astype(int).tolist()
    return _Runner(result, frame, chosen, repeats)


def points_of(found: object) -> Array:
    """Return a copy of the result of a frame, because the next frame may overwrite its memory.

    A result that is not an array of real numbers becomes NaN of shape ().
    """
    try:
        given = np.asarray(found)
        return np.array(np.nan if given.dtype.kind == "c" else given, np.float64)
    except (TypeError, ValueError):
        return np.array(np.nan)


def wrong_result(way: Way, turned: Array, expected: Array, task: Task) -> str | None:
    """Return a description of the first wrong point of a frame; None if all are right."""
    if turned.shape != expected.shape:
        what = f"has the shape {turned.shape}" if turned.shape else "is not an array of points"
        return f"the result {what}; expected the shape {expected.shape}"
    if not way.rotates:
        return None
    allowed = TOLERANCE * max(1.0, float(np.abs(task.points).max()))
    error = np.abs(turned - expected).max(axis=1)
    wrong = np.flatnonzero(~(error <= allowed))
    if not len(wrong):
        return None
    n = int(wrong[0])
    before, found, right = (_written(a[n]) for a in (task.points, turned, expected))
    return (
        f"point {n} of {len(turned)}, {before}, came out as {found}; expected {right}; "
        f"a coordinate is off by {error[n]:.1e}"
    )


def _written(point: Array) -> str:
    return f"({', '.join(f'{x:.6g}' for x in point.tolist())})"


def _version(distribution: str) -> str:
    try:
        return version(distribution) if distribution else ""
    except PackageNotFoundError:  # run from its source
        return ""


def _sample(runner: _Runner) -> None:
    """Time one repeat, and add it to the result."""
    result = runner.result
    times = [seconds * result.scale for seconds in _times(runner.frame, runner.chosen)]
    result.samples.append(mean(times))
    result.best = min(result.best, *times)


def _times(frame: FrameFunction, chosen: Sequence[int]) -> list[float]:
    """Return the time of each frame in seconds."""
    times = []
    for n in chosen:
        start = perf_counter()
        frame(n)
        times.append(perf_counter() - start)
    return times


@contextmanager
def _no_collector() -> Iterator[None]:
    """Disable the garbage collector while timing, as :mod:`timeit` does."""
    enabled = gc.isenabled()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


@contextmanager
def _own_threads(number: int) -> Iterator[None]:
    """Make hfield use ``number`` threads."""
    from rotation.kernels import threads

    before = threads()
    threads(number)
    try:
        yield
    finally:
        threads(before)


@contextmanager
def _dealer(number: int) -> Iterator[Callable[[Way, Task], FrameFunction]]:
    """Yield a function that prepares an implementation for ``number`` threads.

    The functions of this package use threads themselves. Other implementations use one thread, so the points
    are divided, and each thread runs the implementation on its part.
    """
    with ThreadPoolExecutor(number) as pool:

        def deal(way: Way, task: Task) -> FrameFunction:
            make = way.makes[task.kind]
            if number == 1 or way.role == "ours":
                return make(task)
            edges = np.linspace(0, len(task.points), number + 1).astype(int).tolist()
            parts = [
                make(task.part(start, stop)) for start, stop in pairwise(edges) if start < stop
            ]
            return partial(_together, pool, parts)

        yield deal


class _Pieces(list[ArrayLike]):
    """The parts of a frame, joined on access."""

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Array:
        return np.concatenate([np.asarray(part) for part in self])


def _together(pool: ThreadPoolExecutor, parts: Sequence[FrameFunction], n: int) -> _Pieces:
    return _Pieces(pool.map(lambda part: part(n), parts))
