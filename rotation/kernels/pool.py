"""Threads that help with one call: they take blocks from its counter until none is left.

The calling thread always works too, so a call never waits for help that did not come: helpers that
have not started when the work is done are called off. There is no state in a call that other Python
threads, a fork or the end of the interpreter could break; numba's own parallel regions fail there.
"""

import os
import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from functools import partial
from typing import Any

import numpy as np

from rotation.errors import RotationError

VARIABLE = "ROTATION_NUM_THREADS"


class _State:
    """The number of threads and the executor; both are made when first needed, anew in a child."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.number: int | None = None
        self.executor: ThreadPoolExecutor | None = None
        self.room = 0  # the number of threads for which the executor was made


_state = _State()


def _forget_executor() -> None:
    """Threads do not survive a fork: the child starts without them, and with a free lock."""
    _state.lock, _state.executor = threading.Lock(), None


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_executor)


def threads(number: int | None = None) -> int:
    """Return how many threads a call may use, after setting it to ``number`` if that is given.

    At first it is the environment variable ``ROTATION_NUM_THREADS``, else the number of processors
    this process may run on. Raises `RotationError` unless it is a whole number of at least 1.
    """
    with _state.lock:
        if number is not None:
            _set(_checked(number, "the number of threads"))
        elif _state.number is None:
            given = os.environ.get(VARIABLE)
            _state.number = _processors() if not given else _checked(given, VARIABLE)
        return _state.number or 1


def _set(number: int) -> None:
    if _state.executor is not None and number > _state.room:
        _state.executor.shutdown(wait=False)
        _state.executor = None
    _state.number = number


def _checked(value: int | str, name: str) -> int:
    try:
        number = int(value)
    except (ValueError, OverflowError):
        number = 0
    if number < 1 or number != float(value):
        raise RotationError(f"{name} is {value!r}; expected a whole number of at least 1")
    return number


def _processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def share(work: Callable[..., Any], pieces: int, alive: object, *arguments: Any) -> bool:
    """Run ``work(address of a counter, *arguments)`` in up to ``pieces`` threads; tell if any said true.

    ``alive`` is what the arguments point into: it is kept until the last thread is done, also when
    Ctrl-C ends the wait for it.
    """
    counter = np.zeros(1, np.int64)
    task = partial(_task, work, counter, alive, arguments)
    helpers = _helpers(task, min(threads(), pieces) - 1)
    answer = task()
    for helper in helpers:
        if not helper.cancel():
            answer |= helper.result()
    return answer


def _task(
    work: Callable[..., Any], counter: Any, alive: object, arguments: tuple[Any, ...]
) -> bool:
    return bool(work(counter.ctypes.data, *arguments))


def _helpers(task: Callable[[], bool], number: int) -> list[Future[bool]]:
    if number < 1:
        return []
    with _state.lock:
        if _state.executor is None:
            _state.room = max(2, _state.number or 2)
            _state.executor = ThreadPoolExecutor(_state.room - 1, "rotation")
        executor = _state.executor
    try:
        return [executor.submit(task) for _ in range(number)]
    except RuntimeError:  # the interpreter, or this executor, is shutting down
        return []
