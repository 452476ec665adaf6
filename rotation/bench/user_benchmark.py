"""Run the benchmark with points and functions of the user: `rotation.benchmark`."""

from __future__ import annotations

import operator
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from time import perf_counter
from typing import SupportsIndex

import numpy as np
from numpy.typing import ArrayLike

from hfield.errors import shorten
from rotation.arrays import components
from rotation.bench.measure import (
    SLOW_POINTS,
    Result,
    Settings,
    points_of,
    run_test,
    wrong_result,
)
from rotation.bench.results import as_rows, table
from rotation.bench.tasks import TESTS, Array, Test
from rotation.bench.ways import WAYS, Way
from rotation.bench.ways.user_functions import (
    Function,
    OwnFunctionError,
    definition_of,
    failure,
    own_way,
)
from rotation.errors import RotationError
from rotation.kernels import threads as available
from rotation.namespaces import refuse_rows


@dataclass(frozen=True)
class Benchmark:
    """The results of `benchmark`; it prints as a table."""

    results: Sequence[Result]
    settings: Settings

    @property
    def rows(self) -> list[dict[str, object]]:
        """One dict for each test and implementation, as the rows of a table.

        Times are in milliseconds for a frame of all points: ``mean_ms``, ``median_ms`` and ``min_ms`` of
        the repeats in ``samples_ms``, and ``best_frame_ms``, the quickest frame. ``ratio_to_copy`` and
        ``ratio_to_hfield`` are ratios of the quickest frames. ``error`` is the largest error of a
        coordinate. ``status`` is "ok", "missing" for a library that is not installed, "wrong" or "failed";
        only rows that are "ok" have times.
        """
        return as_rows(self.results)

    def __str__(self) -> str:
        return table(self.results, self.settings)

    __repr__ = __str__


def benchmark(
    points: int | ArrayLike = 550_000,
    frames: int = 300,
    ways: Mapping[str, Function] | None = None,
    *,
    test: str = "1",
    repeats: int = 10,
    threads: int | None = None,
    seconds: float = 1.5,
) -> Benchmark:
    """Time the user's functions together with hfield, scipy, other libraries and the thesis (3.2).

    Before timing, the result of each function is compared with the products of :mod:`hfield.core.product`.
    All implementations are timed alternately in the same run.

    Parameters
    ----------
    points : int or array_like, shape (n, 3)
        The number of random points in the unit cube, or the points themselves.
    frames : int
        The number of frames of a run; each turns the points by another angle.
    ways : mapping of str to callable, optional
        Functions by name. ``f(points, axis, angle)`` returns the points (n, 3) turned about the axis, which
        has any length but zero, by the angle in radians. In test 1 the axis has the shape (3,) and the
        angle is a float; in test 2 each point has its own, (n, 3) and (n,). A function whose parameters are
        called ``points, angles`` does the matrix test of test 2: it turns point i by R_z(a)·R_y(b)·R_x(c),
        where (a, b, c) is row i of the angles (n, 3). Arrays are float64 and read-only. With
        several threads, each thread calls the function with its part of the points.
    test : "1" or "2"
        The number of the test in the thesis.
    repeats, threads : int
        The numbers of runs and of threads of each way; by default :func:`rotation.threads` threads.
    seconds : float
        The approximate time for a way in a test; slow ones get fewer points, frames or repeats.

    Returns
    -------
    Benchmark
        Its ``rows`` are dicts with times in milliseconds; it prints as a table.

    Raises
    ------
    OwnFunctionError
        A function fails or returns wrong points; the message shows the first one. A subclass of
        RotationError.
    RotationError
        An invalid argument.

    Examples
    --------
    >>> from rotation import benchmark, rotate
    >>> def mine(points, axis, angle):
    ...     return rotate(points, axis, angle)
    >>> rows = benchmark(points=100, frames=2, ways={"mine": mine}, repeats=1, seconds=0.01).rows
    >>> [row["status"] for row in rows if row["way"] == "mine"]
    ['ok']
    >>> try:
    ...     benchmark([[1, 2, 3]], ways={"copy": lambda points, axis, angle: points + 0})
    ... except RotationError as error:
    ...     print(str(error).partition("copy, ")[2])  # after the file and the line
    test 1: point 0 of 1, (1, 2, 3), came out as (1, 2, 3); expected (-1.14264, 1.92208, 3); ...
    """
    cloud: Array | None = None
    if isinstance(points, (int, np.integer)):
        number = _count(points, "points")
    else:
        rows = components(points, 3, "points", "aos")
        if rows.ndim != 2 or not len(rows):
            raise RotationError(
                f"expected points of shape (n, 3), n at least 1, found {rows.shape}"
            )
        refuse_rows(np.asarray(~np.isfinite(rows).all(axis=1)), "the point", "is not finite")
        cloud, number = np.ascontiguousarray(rows, np.float64), len(rows)
    if not 0 < seconds < float("inf"):
        raise RotationError(f"seconds is {seconds!r}; expected a positive number")
    settings = Settings(
        number,
        _count(frames, "frames"),
        _count(repeats, "repeats"),
        available() if threads is None else _count(threads, "threads"),
        seconds,
        cloud,
    )
    tests = chosen_tests(test)
    competitors = with_own(ways or {}, tests, settings)
    results = [r for each in tests for r in run_test(each, competitors, settings)]
    return Benchmark(results, settings)


def chosen_tests(number: str | None) -> list[Test]:
    """Return the tests with that number in the thesis, or all if it is None. Raises RotationError."""
    tests = [test for test in TESTS if number in (None, test.name[0])]
    if not tests:
        raise RotationError(f'test {number!r}: the tests of the thesis are "1" and "2"')
    return tests


def with_own(
    functions: Mapping[str, Function], tests: Sequence[Test], settings: Settings
) -> tuple[Way, ...]:
    """Check the user's functions, and return all implementations, with the user's after the copy.

    Raises :class:`OwnFunctionError` for a function that fails or is wrong, and RotationError for a name
    already in use, or a function that fits no test.
    """
    taken = {way.name for way in WAYS}
    for name in functions:
        if name in taken:
            raise RotationError(f"there is already a way called {name!r}; choose another name")
    kinds = {settings.task(test, 1).kind for test in tests}
    for name, function in functions.items():
        if kinds.isdisjoint(own_way(name, function).makes):
            raise RotationError(
                f"{name}(points, angles) does the matrix test of test 2, which was not chosen; "
                "a function for the other tests has the parameters (points, axis, angle)"
            )
    own = [_checked(name, function, tests, settings) for name, function in functions.items()]
    return (*WAYS[:1], *own, *WAYS[1:])


def _checked(name: str, function: Function, tests: Sequence[Test], settings: Settings) -> Way:
    """Return a function as an implementation, after trying it on a few points in all tests that it
    supports.
    """
    way = own_way(name, function)
    file, line = definition_of(function)
    for test in tests:
        task = settings.task(test, SLOW_POINTS)
        if task.kind not in way.makes:
            continue
        try:
            frame = way.makes[task.kind](task)
            turned = points_of(frame(task.check))
            start = perf_counter()
            frame(0)
            seconds = perf_counter() - start
        except (Exception, SystemExit) as error:
            raise OwnFunctionError(failure(error, file, f"{name}, test {test.name}: ")) from error
        difference = wrong_result(way, turned, task.expected(task.check), task)
        if difference is not None:
            where = f"{shorten(file)}, line {line}: " if file else ""
            raise OwnFunctionError(f"{where}{name}, test {test.name}: {difference}")
        if seconds * settings.points / len(task.points) > settings.seconds:
            way = replace(way, slow=True)
    return way


def _count(value: SupportsIndex, name: str) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        number = 0
    if number < 1:
        raise RotationError(f"{name} is {value!r}; expected a whole number of at least 1")
    return number
