"""Parallel work through any ``concurrent.futures.Executor``.

By default tasks run in this process, one after another; with ``jobs`` in a process pool, with ``dask`` on a
cluster. Any other executor can be passed where these are.
"""

from __future__ import annotations

import gc
import os
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import (
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    as_completed,
)
from contextlib import contextmanager
from importlib import import_module
from typing import TYPE_CHECKING, ParamSpec, TypeVar

from hfield.errors import HFieldError

if TYPE_CHECKING:
    from multiprocessing.process import BaseProcess

P = ParamSpec("P")
A = TypeVar("A")
T = TypeVar("T")
SCHEDULER_ANSWERS_WITHIN = "10s"


class ExecutorError(HFieldError, RuntimeError):
    """Worker processes could not be started, or died."""


class InProcess(Executor):
    """An executor that computes in this process; its futures are done when returned."""

    def submit(self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs) -> Future[T]:
        """Compute immediately; the future holds the result or the exception."""
        future: Future[T] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


def unordered(
    executor: Executor, function: Callable[[A], T], tasks: Iterable[A]
) -> Iterator[tuple[int, T]]:
    """Yield the index of each task with its result, in the order of completion."""
    waiting: dict[Future[T], int] = {}
    for n, task in enumerate(tasks):
        future = executor.submit(function, task)
        if future.done():
            yield n, future.result()
        else:
            waiting[future] = n
    for future in as_completed(waiting):
        yield waiting[future], future.result()


def ordered(
    executor: Executor, function: Callable[[A], T], tasks: Iterable[A], ahead: int
) -> Generator[T, None, None]:
    """Yield the results in the order of the tasks, with at most ``ahead`` of them waiting."""
    waiting: deque[Future[T]] = deque()
    try:
        for task in tasks:
            waiting.append(executor.submit(function, task))
            if len(waiting) >= ahead:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()
    finally:
        for future in waiting:
            future.cancel()


@contextmanager
def collecting_rarely() -> Iterator[None]:
    """Run Python's cycle collector rarely, which saves a tenth of the time if most objects are kept."""
    often = gc.get_threshold()
    gc.set_threshold(20_000, *often[1:])
    try:
        yield
    finally:
        gc.set_threshold(*often)


@contextmanager
def open_executor(jobs: int = 1, dask: str | None = None) -> Iterator[Executor]:
    """Yield an executor: this process, ``jobs`` processes, or the Dask cluster at ``dask``.

    Worker processes are forks, with all data read so far, if this process has a single thread; otherwise they
    are spawned, so that no lock of a numerical library is copied. An interrupt ends them immediately. Raises
    :class:`ExecutorError` if Dask is missing or does not respond, or if a worker dies.
    """
    if dask is not None:
        with _dask(dask) as executor:
            yield executor
    elif jobs > 1:
        with _processes(jobs) as executor:
            yield executor
    else:
        yield InProcess()


@contextmanager
def _processes(jobs: int) -> Iterator[Executor]:
    import multiprocessing
    import signal

    context = multiprocessing.get_context("fork" if _only_one_thread() else "spawn")
    pool = ProcessPoolExecutor(jobs, mp_context=context, initializer=_as_a_worker)
    before = set(multiprocessing.active_children())
    try:
        if hasattr(signal, "pthread_sigmask"):
            _start_now(pool, jobs)
        yield pool
    except BaseException as error:
        # Not by cancelling: the pool trips over futures that are cancelled when its workers end.
        for process in set(multiprocessing.active_children()) - before:
            process.terminate()
        # A worker that ends while it sends a result leaves a partial result in the pipe. The pool
        # would wait for the rest as long as any process, including this one, could write to the
        # pipe.
        results = getattr(pool, "_result_queue", None)
        if results is not None:
            results._writer.close()
        pool.shutdown()
        if isinstance(error, BrokenExecutor):
            raise ExecutorError(
                "a worker process ended abruptly, perhaps for want of memory (try fewer --jobs), or because "
                'a script starts workers elsewhere than under `if __name__ == "__main__":`'
            ) from error
        raise
    pool.shutdown()


def _only_one_thread() -> bool:
    """Return whether the system counts a single thread in this process, including those of numerical
    libraries.
    """
    try:
        return len(os.listdir("/proc/self/task")) == 1
    except OSError:  # no Linux
        return False


def _start_now(pool: Executor, jobs: int) -> None:
    """Start all workers now, before this process has more threads, which a fork would not copy.

    Ctrl-C is blocked while they start, until they ignore it; otherwise a worker being spawned would end with
    a Python traceback.
    """
    import signal

    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        for _ in range(jobs):  # a spawned worker takes one task, and no second before it runs
            pool.submit(int)
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, blocked)


def _as_a_worker() -> None:
    """Ignore Ctrl-C, which the parent handles, and end when the parent ends."""
    import signal
    from multiprocessing import parent_process
    from threading import Thread

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    parent = parent_process()
    if parent is not None:
        Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: BaseProcess) -> None:
    """End this process when its parent ends, even by SIGKILL."""
    parent.join()
    os._exit(1)


@contextmanager
def _dask(address: str) -> Iterator[Executor]:
    try:
        distributed = import_module("distributed")
    except ImportError:
        raise ExecutorError(
            "--dask needs the package distributed, which is not installed; "
            "run `pip install 'hfield[dask]'`, or use --jobs N"
        ) from None
    try:
        client = distributed.Client(address, timeout=SCHEDULER_ANSWERS_WITHIN)
    except (OSError, ValueError, TimeoutError) as error:
        raise ExecutorError(
            f"no Dask scheduler answers at {address!r} ({error}); "
            "expected an address such as tcp://127.0.0.1:8786"
        ) from None
    with client:
        yield client.get_executor()
