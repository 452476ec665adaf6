"""Threads that share the blocks of one call.

The calling thread always works too, so a call never waits for helpers that did not start: helpers that have
not started when the work is done are cancelled. A helper that has started may lose its processor in the
middle of a block, which no other thread can finish. So after a long wait the next calls run without helpers
for a while. A call has no state that other Python threads, a fork or the end of the interpreter could break;
numba's parallel regions fail in these cases.
"""

import os
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator
from ctypes import addressof, c_int64
from functools import partial, reduce
from itertools import pairwise
from operator import or_
from queue import SimpleQueue

from hfield.errors import HFieldError

VARIABLES = ("HFIELD_NUM_THREADS", "ROTATION_NUM_THREADS")
RESPITE = (
    20  # after a long wait calls run alone for so many times as long: it is a twentieth of all time
)


class ThreadsError(HFieldError, ValueError):
    """A number of threads that is not an integer of at least 1."""


class _State:
    """The number of threads and the waiting helper threads; reset in a child process."""

    def __init__(self) -> None:
        self.number: int | None = None
        self.alone_until = 0.0  # by the clock of `time.perf_counter`
        self.forget_helpers()

    def forget_helpers(self) -> None:
        """Forget the helpers in a child process: threads do not survive a fork, so it starts with none and a
        free lock.
        """
        self.lock = threading.RLock()  # a signal's handler may come in between
        self.helpers = 0
        self.waiting: SimpleQueue[_Part] = SimpleQueue()


class _Part:
    """A helper's part of a call; it is dropped if the call ends before the part begins.

    An executor's future takes twenty times as long, a fiftieth of the time of a frame of 550 000 points.
    """

    def __init__(self, task: Callable[[], bool]) -> None:
        self._task = task
        self._begun, self._done = threading.Lock(), threading.Lock()
        self._done.acquire()
        self._answer = False
        self._error: BaseException | None = None

    def run(self) -> None:
        """Compute the part, in a helper thread."""
        if self._begun.acquire(blocking=False):
            try:
                self._answer = self._task()
            except BaseException as error:
                self._error = error
            finally:
                self._done.release()

    def result(self) -> bool:
        """Cancel the part if it has not begun, else wait for its result."""
        if self._begun.acquire(blocking=False):
            self._task = bool  # it may stay in the queue and keep arrays alive
            return False
        self._done.acquire()
        if self._error is not None:
            raise self._error
        return self._answer


_state = _State()

if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_state.forget_helpers)


def threads(number: int | None = None) -> int:
    """Set the number of threads of a call to ``number``, if it is given; return the number.

    The initial value is the environment variable ``HFIELD_NUM_THREADS`` or ``ROTATION_NUM_THREADS``, else the
    number of processors available to this process. Raises :class:`ThreadsError` unless it is an integer of at
    least 1.
    """
    if number is not None:
        _state.number = _checked(number, "the number of threads")
    elif _state.number is None:
        given = next((name for name in VARIABLES if os.environ.get(name)), None)
        _state.number = _processors() if given is None else _checked(os.environ[given], given)
    return _state.number


def _checked(value: int | str, name: str) -> int:
    try:
        number = int(value)
    except (ValueError, OverflowError):
        number = 0
    if number < 1 or number != float(value) or isinstance(value, bool):
        raise ThreadsError(f"{name} is {value!r}; expected a whole number of at least 1")
    return number


def _processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def share(work: Callable[..., object], pieces: int, alive: object, *arguments: object) -> bool:
    """Run ``work(address of a counter, *arguments)`` in up to ``pieces`` threads; return whether any
    returned true.

    ``alive`` keeps the objects to which the arguments point until the last thread is done, even if Ctrl-C
    ends the wait. A wait for helpers is long if it exceeds the work of the caller.
    """
    counter = c_int64(0)
    task = partial(_task, work, counter, alive, arguments)
    number = min(threads(), pieces) - 1
    if number < 1:
        return task()
    start = time.perf_counter()
    if start < _state.alone_until:
        return task()
    helpers = _helpers(task, number)
    answer = task()
    finished = time.perf_counter()
    for helper in helpers:
        answer |= helper.result()
    end = time.perf_counter()
    if end - finished > finished - start:
        _state.alone_until = end + RESPITE * (end - finished)
    return answer


def in_pieces(
    work: Callable[[int, int], int], n: int, piece: int, shortest: int, alive: object
) -> int:
    """Run ``work(start, end)`` on pieces of ``range(n)``, and return the bitwise or of the results.

    There is one more thread for every ``shortest`` elements. Each begins in a separate section, and helps in
    the other sections when it is done: if two threads touched one page of new memory at once, both would
    clear its 2 MiB.
    """
    length = max(shortest, -(-n // threads()))
    if length >= n:
        return work(0, n)
    cuts = [*range(0, n, length), n]
    stretches = [(deque(range(start, end, piece)), end) for start, end in pairwise(cuts)]
    turns = deque(range(len(stretches)))
    results: list[int] = []

    def one(_: int) -> bool:
        own = turns.popleft()
        for starts, end in stretches[own:] + stretches[:own]:
            for start in _taken(starts):
                results.append(work(start, min(start + piece, end)))
        return False

    share(one, len(stretches), alive)
    return reduce(or_, results)


def _taken(starts: deque[int]) -> Iterator[int]:
    """Yield the remaining starts of a shared counter; each goes to one thread."""
    while True:
        try:
            yield starts.popleft()
        except IndexError:
            return


def _task(
    work: Callable[..., object], counter: c_int64, alive: object, arguments: tuple[object, ...]
) -> bool:
    return bool(work(addressof(counter), *arguments))


def _helpers(task: Callable[[], bool], number: int) -> list[_Part]:
    with _state.lock:
        try:
            while _state.helpers < number:
                work = (_state.waiting,)
                threading.Thread(target=_help, args=work, name="hfield", daemon=True).start()
                _state.helpers += 1
        except RuntimeError:  # the interpreter is shutting down, or no thread is to be had
            number = _state.helpers
        waiting = _state.waiting
    parts = [_Part(task) for _ in range(number)]
    for part in parts:
        waiting.put(part)
    return parts


def _help(waiting: SimpleQueue[_Part]) -> None:
    while True:
        waiting.get().run()
