"""The seam for parallel work."""

import importlib.util
import operator
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from hfield.core.executors import ExecutorError, InProcess, open_executor, unordered
from tests.patience import PATIENCE


def test_in_process_goes_on_only_as_results_are_taken():
    done = []
    values = unordered(InProcess(), lambda x: done.append(x) or x * x, range(5))
    assert next(values) == (0, 0)
    assert done == [0]
    assert list(values) == [(1, 1), (2, 4), (3, 9), (4, 16)]


def test_the_first_exception_stops_the_work():
    done = []

    def work(x):
        done.append(x)
        return 1 // (2 - x)

    with pytest.raises(ZeroDivisionError):
        list(unordered(InProcess(), work, range(9)))
    assert done == [0, 1, 2]


def test_in_process_futures():
    executor = InProcess()
    assert executor.submit(pow, 2, 10).result() == 1024
    with pytest.raises(ZeroDivisionError):
        executor.submit(operator.truediv, 1, 0).result()


def test_one_job_needs_no_process():
    with open_executor() as executor:
        assert dict(unordered(executor, lambda _: os.getpid(), "ab")) == {
            0: os.getpid(),
            1: os.getpid(),
        }


def test_processes():
    with open_executor(jobs=2) as executor:
        assert dict(unordered(executor, abs, [-1, 2, -3])) == {0: 1, 1: 2, 2: 3}


ONE_THREAD_OR_TWO = """
import sys, threading
from hfield.core.executors import open_executor

if __name__ == "__main__":
    import colorsys

    done = threading.Event()
    if sys.argv[1] == "2":
        threading.Thread(target=done.wait).start()
    with open_executor(2) as executor:
        print(executor.submit(eval, "'colorsys' in __import__('sys').modules").result())
    done.set()
"""


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="workers are spawned there")
@pytest.mark.parametrize(("threads", "shared"), [("1", "True"), ("2", "False")])
def test_workers_are_forks_of_a_process_of_one_thread_only(tmp_path, threads, shared):
    script = tmp_path / "script.py"
    script.write_text(ONE_THREAD_OR_TWO)
    done = subprocess.run(
        [sys.executable, str(script), threads], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == [shared]


def test_a_worker_that_dies_is_told():
    why = "ended abruptly.*memory.*__main__"  # spawned workers run a script again that has no guard
    with pytest.raises(ExecutorError, match=why), open_executor(jobs=2) as executor:
        list(unordered(executor, os._exit, [1, 1, 1]))


def test_an_interrupt_ends_the_workers():
    import multiprocessing

    workers = set()

    def interrupted():
        before = set(multiprocessing.active_children())
        with open_executor(jobs=2) as executor:
            list(unordered(executor, abs, [-1, 2]))
            workers.update(set(multiprocessing.active_children()) - before)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert workers
    for worker in workers:
        worker.join(PATIENCE)
        assert not worker.is_alive()


@pytest.mark.skipif(importlib.util.find_spec("distributed") is not None, reason="Dask is here")
def test_a_missing_dask_is_told():
    with (
        pytest.raises(ExecutorError, match=r"pip install 'hfield\[dask\]'"),
        open_executor(dask="tcp://127.0.0.1:1"),
    ):
        pass


SPAWNED = """
import multiprocessing, os, signal, sys, threading, time
from hfield.core.executors import open_executor

if __name__ == "__main__":
    threading.Thread(target=time.sleep, args=(60,), daemon=True).start()
    with open_executor(2) as executor:
        futures = [executor.submit(abs, -1) for _ in range(2)]
        time.sleep(float(sys.argv[1]))
        for worker in multiprocessing.active_children():
            os.kill(worker.pid, signal.SIGINT)
        print([future.result() for future in futures])
"""


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="a thread more changes nothing")
@pytest.mark.parametrize("seconds", ["0", "0.05"])
def test_workers_leave_an_interrupt_to_their_parent_from_the_start(tmp_path, seconds):
    script = tmp_path / "spawned.py"
    script.write_text(SPAWNED)
    command = [sys.executable, str(script), seconds]
    done = subprocess.run(command, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("[1, 1]\n", "")


ORPHANS = """
import os, sys, time
from hfield.core.executors import open_executor

if __name__ == "__main__":
    with open_executor(2) as executor:
        for future in [executor.submit(os.getpid) for _ in range(8)]:
            print(future.result(), flush=True)
        print("ready", flush=True)
        time.sleep(120)
"""


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks at processes in /proc")
@pytest.mark.parametrize("way", [signal.SIGKILL, signal.SIGTERM])
def test_workers_end_with_the_process_that_made_them(tmp_path, way):
    script = tmp_path / "orphans.py"
    script.write_text(ORPHANS)
    command = [sys.executable, str(script)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as parent:
        lines = iter(parent.stdout.readline, "ready\n")
        workers = {int(line) for line in lines}
        parent.send_signal(way)
    assert workers
    deadline = time.monotonic() + PATIENCE
    while any(map(alive, workers)) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not any(map(alive, workers))


def alive(process):
    """Whether a process runs; one that has ended and waits to be reaped does not."""
    try:
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"
