"""The threads that help with a call."""

import threading
import weakref
from collections.abc import Iterator

import pytest

from hfield.compiling import threads as pool
from hfield.compiling.threads import share
from rotation.thread_count import threads
from tests.patience import PATIENCE


@pytest.fixture(autouse=True)
def two_threads(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(pool._state, "alone_until", 0.0)
    before = threads()
    threads(2)
    yield
    threads(before)


def test_what_a_helper_raises_reaches_the_caller() -> None:
    caller, both = threading.current_thread(), threading.Barrier(2, timeout=PATIENCE)

    def work(counter: int) -> bool:
        both.wait()
        if threading.current_thread() is not caller:
            raise ValueError("from the helper")
        return False

    for _ in range(3):  # the helper lives on
        with pytest.raises(ValueError, match="from the helper"):
            share(work, 2, None)


def test_what_a_helper_finds_reaches_the_caller() -> None:
    caller, both = threading.current_thread(), threading.Barrier(2, timeout=PATIENCE)

    def work(counter: int) -> bool:
        both.wait()
        return threading.current_thread() is not caller

    assert share(work, 2, None)


def test_a_call_does_not_wait_for_helpers_that_have_not_begun() -> None:
    begun, go = threading.Barrier(3, timeout=PATIENCE), threading.Event()
    occupied: list[bool] = []

    def slow(counter: int) -> bool:
        begun.wait()
        return not go.wait(PATIENCE)

    other = threading.Thread(target=lambda: occupied.append(share(slow, 2, None)))
    other.start()
    begun.wait()  # the other thread and the only helper are both in the slow call
    ran: list[str] = []
    alive = {"memory"}
    kept = weakref.ref(alive)
    assert not share(lambda counter: bool(ran.append(threading.current_thread().name)), 2, alive)
    assert ran == [threading.current_thread().name]
    del alive
    assert kept() is None  # though the helper has not come to it yet
    go.set()
    other.join(PATIENCE)
    assert occupied == [False]


def test_no_helper_is_asked_for_one_piece() -> None:
    ran: list[str] = []
    share(lambda counter: bool(ran.append(threading.current_thread().name)), 1, None)
    assert ran == [threading.current_thread().name]


def test_calls_run_alone_for_a_while_after_a_long_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    """By a clock of the test's: the caller works for 2 seconds, and waits for what is said."""
    now, waits = [100.0], iter([1.0, 5.0])
    caller, both = threading.current_thread(), threading.Barrier(2, timeout=PATIENCE)
    helped: list[float] = []

    def work(counter: int) -> bool:
        if now[0] < pool._state.alone_until:
            return False
        both.wait()
        if threading.current_thread() is caller:
            now[0] += 2.0
        else:
            helped.append(now[0])
        return False

    result = pool._Part.result

    def waited(part: object) -> bool:
        answer = result(part)  # type: ignore[arg-type]
        now[0] += next(waits)
        return answer

    monkeypatch.setattr(pool._Part, "result", waited)
    monkeypatch.setattr(pool.time, "perf_counter", lambda: now[0])
    for _ in range(2):
        share(work, 2, None)
    assert len(helped) == 2  # a wait of 1 second was not long, one of 5 was
    assert pool._state.alone_until == now[0] + pool.RESPITE * 5.0
    for _ in range(3):
        share(work, 2, None)
    assert len(helped) == 2
