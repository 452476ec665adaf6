"""The one seam for work in many pieces: anything with the face of a ``concurrent.futures.Executor``.

By default pieces are computed here, one after the other; with ``jobs`` in a pool of processes, with
``dask`` on a cluster. There is no scheduler of our own: who has another executor passes it where
these are passed.
"""

from __future__ import annotations

import gc
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from concurrent.futures import (
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    as_completed,
)
from contextlib import contextmanager
from importlib import import_module
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from hfield.errors import HFieldError

if TYPE_CHECKING:
    from multiprocessing.context import BaseContext

P = ParamSpec("P")
A = TypeVar("A")
T = TypeVar("T")
SCHEDULER_ANSWERS_WITHIN = "10s"


class ExecutorError(HFieldError, RuntimeError):
    """Workers that cannot be had, or that died."""


class InProcess(Executor):
    """Computes in this process, at once: a future that it returns is done."""

    def submit(self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs) -> Future[T]:
        """Compute; the future holds the result or the exception."""
        future: Future[T] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


def unordered(
    executor: Executor, function: Callable[[A], T], tasks: Iterable[A]
) -> Iterator[tuple[int, T]]:
    """Yield the number of each task with its result, as they are finished."""
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
    """Let Python look for cycles seldom: where nearly all that is made is kept, looking takes a tenth."""
    often = gc.get_threshold()
    gc.set_threshold(20_000, *often[1:])
    try:
        yield
    finally:
        gc.set_threshold(*often)


@contextmanager
def open_executor(
    jobs: int = 1, dask: str | None = None, imports: Sequence[str] = ()
) -> Iterator[Executor]:
    """Yield an executor: this process, ``jobs`` processes, or the Dask cluster at ``dask``.

    Processes are never forked from this one, so that no lock of a numerical library is copied. Where the
    system can, one bare process reads the modules ``imports`` at once, while this one goes on, and the
    workers are its forks; elsewhere they are spawned. On an interrupt they are ended at once. Raises
    :class:`ExecutorError` when Dask is missing or silent, or when a worker dies.
    """
    if dask is not None:
        with _dask(dask) as executor:
            yield executor
    elif jobs > 1:
        with _processes(jobs, imports) as executor:
            yield executor
    else:
        yield InProcess()


@contextmanager
def _processes(jobs: int, imports: Sequence[str]) -> Iterator[Executor]:
    import multiprocessing

    context = _serving(imports) if imports else multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(jobs, mp_context=context, initializer=_as_a_worker)
    before = set(multiprocessing.active_children())
    try:
        yield pool
    except BaseException as error:
        # Not by cancelling: the pool trips over futures that are cancelled when its workers end.
        for process in set(multiprocessing.active_children()) - before:
            process.terminate()
        # A worker that ends in the middle of a result leaves half of it in the pipe, for the rest of which
        # the pool would wait as long as anyone, this process included, could write it.
        results = getattr(pool, "_result_queue", None)
        if results is not None:
            results._writer.close()
        pool.shutdown()
        if isinstance(error, BrokenExecutor):
            raise ExecutorError(
                "a worker process ended abruptly, perhaps for want of memory; try fewer --jobs"
            ) from error
        raise
    pool.shutdown()


def _serving(imports: Sequence[str]) -> BaseContext:
    """Start the process that workers are forked from, with ``imports`` read, where there are such."""
    import multiprocessing
    import os
    import signal

    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    from multiprocessing import resource_tracker
    from multiprocessing.forkserver import ensure_running

    resource_tracker.ensure_running()  # it would unblock what is blocked below
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(list(imports))
    before = os.environ.get("PYTHONSAFEPATH")
    os.environ["PYTHONSAFEPATH"] = "1"  # else it would read modules from the current directory
    signals = signal.pthread_sigmask(
        signal.SIG_BLOCK, {signal.SIGINT}
    )  # Ctrl-C is for this process
    try:
        ensure_running()
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, signals)
        if before is None:
            del os.environ["PYTHONSAFEPATH"]
        else:
            os.environ["PYTHONSAFEPATH"] = before
    return context


def _as_a_worker() -> None:
    """Leave Ctrl-C to the parent, which ends the workers, else each prints a traceback; and end with it."""
    import signal
    from multiprocessing import parent_process
    from threading import Thread

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    if parent is not None:
        Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: Any) -> None:
    """End this process when its parent has, even by SIGKILL: it would wait for tasks for ever."""
    import os

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
