"""Machine code: linked once whoever asks, never freed, kept on disk for this user alone."""

import ctypes
import gc
import os
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from hfield.compiling import disk_cache, machine_code
from tests.patience import PATIENCE

pytestmark = pytest.mark.skipif(
    not machine_code.available(), reason="there is nothing to compile with"
)
ADD = "define i64 @entry(i64 %a, i64 %b) {\n  %c = add i64 %a, %b\n  ret i64 %c\n}\n"


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(machine_code, "_addresses", {})
    return tmp_path / disk_cache.FOLDER


def files(place: Path) -> list[Path]:
    return [path for path in place.iterdir() if path.name != disk_cache.SECRET]


# --- on disk -----------------------------------------------------------------------------------------


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="they have places of their own")
def test_where_it_lies(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    for name in ("XDG_CACHE_HOME", "NUMBA_CACHE_DIR"):
        monkeypatch.delenv(name, raising=False)
    assert disk_cache.directory() == tmp_path / "home" / ".cache" / disk_cache.FOLDER
    for name in ("XDG_CACHE_HOME", "NUMBA_CACHE_DIR"):  # each goes before those above
        monkeypatch.setenv(name, str(tmp_path / name))
        assert disk_cache.directory() == tmp_path / name / disk_cache.FOLDER


def test_what_is_kept_is_whole_or_not_used(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert disk_cache.kept("key") is None
    disk_cache.keep("key", b"machine code")
    assert disk_cache.kept("key") == b"machine code"
    (file,) = files(place)
    file.write_bytes(file.read_bytes()[:-1])
    assert disk_cache.kept("key") is None
    file.unlink()
    file.mkdir()  # something else stands in the place
    disk_cache.keep("key", b"machine code")
    assert disk_cache.kept("key") is None
    assert files(place) == [file]
    file.rmdir()
    file.write_text("no folder")
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(file))
    disk_cache.keep("key", b"nowhere to write")
    assert disk_cache.kept("key") is None


def test_a_file_says_which_one_it_is_and_who_wrote_it(place: Path) -> None:
    disk_cache.keep("key", b"machine code")
    os.link(place / "key", place / "other")
    assert disk_cache.kept("other") is None
    secret = place / disk_cache.SECRET
    secret.write_bytes(bytes(disk_cache.SIZE))
    assert disk_cache.kept("key") is None
    secret.write_bytes(b"")  # and is made anew where it is none
    disk_cache.keep("key", b"machine code")
    assert disk_cache.kept("key") == b"machine code"


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files belong to no user here")
@pytest.mark.parametrize("name", ["key", disk_cache.SECRET])
def test_what_others_may_have_written_is_not_read(
    place: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    mask = os.umask(0)
    try:
        disk_cache.keep("key", b"machine code")
    finally:
        os.umask(mask)
    assert disk_cache.kept("key") == b"machine code"
    file = place / name
    assert file.stat().st_mode & 0o777 == 0o600
    for mode, found in ((0o620, None), (0o602, None), (0o644, b"machine code")):
        file.chmod(mode)
        assert disk_cache.kept("key") == found
    me = os.geteuid()
    monkeypatch.setattr(os, "geteuid", lambda: me + 1)
    assert disk_cache.kept("key") is None
    monkeypatch.undo()
    file.unlink()
    os.mkfifo(file)  # nobody writes there: who reads it as a file waits for ever
    assert disk_cache.kept("key") is None


@pytest.mark.slow
@pytest.mark.parametrize(
    "code",
    [
        b"",
        b"no machine code",
        b"\x7fELF" + bytes(200),
        "the first half",
        "of another function",
        "that calls what is not there",
    ],
)
def test_what_cannot_be_linked_is_compiled_again(place: Path, code: bytes | str) -> None:
    """With a stamp that fits: LLVM's older engine ended the process."""
    run = f"""
from hfield.compiling import machine_code
from hfield.compiling import disk_cache
import llvmlite.binding as llvm
ADD = {ADD!r}
def add():
    return machine_code.function(machine_code.compiled(ADD, "entry"))(40, 2)
def made(text):
    return machine_code.machine().emit_object(llvm.parse_assembly(text))
assert add() == 42
(key,) = machine_code._addresses
code = {{
    "the first half": lambda: made(ADD)[:len(made(ADD)) // 2],
    "of another function": lambda: made(ADD.replace("entry", "other")),
    "that calls what is not there": lambda: made("declare i64 @missing(i64, i64)\\n"
        + ADD.replace("add i64 %a, %b", "call i64 @missing(i64 %a, i64 %b)")),
}}.get({code!r}, lambda: {code!r})()
disk_cache.keep(key, code)
machine_code._addresses.clear()
assert add() == 42
assert disk_cache.kept(key) != code
print("alive")
"""
    done = subprocess.run([sys.executable, "-c", run], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "alive\n"), done.stderr


# --- one lock, and no end ----------------------------------------------------------------------------


def test_threads_that_ask_at_once_get_one_function(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    linked = list[int]()
    link = machine_code._linked

    def counted(code: bytes, name: str) -> int:
        linked.append(link(code, name))
        return linked[-1]

    monkeypatch.setattr(machine_code, "_linked", counted)
    count = 8
    together, found = threading.Barrier(count, timeout=PATIENCE), list[int]()

    def ask() -> None:
        together.wait()
        found.append(machine_code.compiled(ADD, "entry"))

    threads = [threading.Thread(target=ask) for _ in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(PATIENCE)
    assert found == linked * count
    assert len(linked) == 1


@pytest.mark.slow
def test_machine_code_outlives_all_that_speaks_of_it(place: Path) -> None:
    """In a process of its own: what is freed may be in use by others."""
    run = f"""
import gc, importlib
from hfield.compiling import machine_code
add = machine_code.function(machine_code.compiled({ADD!r}, "entry"))
machine_code._addresses.clear()
machine_code._linker.cache_clear()
importlib.reload(machine_code)
gc.collect()
other = machine_code.function(machine_code.compiled({ADD!r}.replace("add i64", "sub i64"), "entry"))
print(add(40, 2), other(40, 2))
"""
    done = subprocess.run([sys.executable, "-c", run], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "42 38\n"), done.stderr


def test_a_function_of_python_keeps_what_it_is_made_of() -> None:
    from rotation.quaternions import PRODUCT

    function = PRODUCT._compiled()
    assert function is not None
    array = function.__self__  # type: ignore[attr-defined]
    assert isinstance(array.base, ctypes.Structure)
    gc.unfreeze()  # what is frozen refers to nothing, for the collector
    assert any(referrer is function for referrer in gc.get_referrers(array))


FORK = """
import os, threading
from hfield.compiling import machine_code
from hfield.fields.base.balls import precision

def compiled(number):
    text = ADD.replace("add i64 %a, %b", f"add i64 %a, {number}")
    return machine_code.function(machine_code.compiled(text, "entry"))(0, 0)

begun, busy = threading.Event(), True
def work():
    for number in range(10_000):
        with precision(100):
            compiled(number)
        begun.set()
        if not busy:
            return

thread = threading.Thread(target=work)
thread.start()
begun.wait()
for turn in range(20):
    child = os.fork()
    if not child:
        with precision(200):
            os._exit(compiled(turn + 100_000) != turn + 100_000)
    assert os.waitpid(child, 0)[1] == 0
busy = False
thread.join()
print("done")
"""


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_a_child_compiles_that_was_forked_while_another_thread_did(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", f"ADD = {ADD!r}\n{FORK}"],
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE,
        env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)},
    )
    assert (done.returncode, done.stdout) == (0, "done\n"), done.stderr


@pytest.mark.slow
def test_kernels_are_compiled_once_and_run_without_numba(place: Path) -> None:
    from anim.compiling import kernel, written
    from anim.physics.heavy_top_equations import Rates, run

    states, start = np.empty((3, 7)), np.array([1.0, 0, 0, 0, 0.1, 0, 9])
    rates = Rates(0.7, 3.0, 0.1, 0.1, 0.5)
    landed = kernel(run)(states, start, 1e-3, 20, 10, rates)
    plain = np.empty_like(states)
    assert run(plain, start, 1e-3, 20, 10, rates) == landed == -1
    assert abs(plain - states).max() < 1e-14
    (kept,) = files(place)
    machine_code._addresses.clear()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("anim.compiling.written", lambda *_: pytest.fail("compiled again"))
        kernel(run)(again := np.empty_like(states), start, 1e-3, 20, 10, rates)
    assert (again == states).all()
    kept.write_bytes(b"no machine code")
    machine_code._addresses.clear()
    with pytest.MonkeyPatch.context() as patch:
        texts: list[str] = []
        patch.setattr("anim.compiling.written", lambda *a: texts.append(written(*a)) or texts[-1])
        kernel(run)(states, start, 1e-3, 20, 10, rates)
    assert len(texts) == 1


def test_a_kernel_for_other_kinds_is_another(place: Path) -> None:
    from anim.compiling import kernel

    def halved(x: float, out: np.ndarray) -> float:
        out[0] = x / 2
        return x / 2

    half = kernel(halved)
    assert half(3, np.empty(1)) == 1.5
    assert half(3.5, np.empty(1)) == 1.75
    out = np.empty(1, np.float32)
    assert half(np.float64(1) / 3, out) == 1 / 6
    assert out[0] == np.float32(1 / 6)
    with pytest.raises(ValueError, match="C-contiguous"):
        half(1.0, np.empty(4)[::2])
    assert len(files(place)) == 3


PROPERTY = """
import os, threading
from hfield import H
from hfield.compiling import machine_code

loaded = threading.Event()
def make(constants):
    loaded.set()
    threading.Event().wait(600)
A = H("GF(7)")
A.ring.array_storage = make
threading.Thread(target=lambda: A.array_storage, daemon=True).start()
loaded.wait()
child = os.fork()
if not child:
    H("GF(5)").array_storage
    os._exit(0)
for _ in range(6_000):
    if os.waitpid(child, os.WNOHANG)[0]:
        break
    threading.Event().wait(0.1)
else:
    os.kill(child, 9)
    print("the child waits")
os._exit(0)
"""


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_a_child_does_not_wait_for_a_property_that_another_thread_was_making() -> None:
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", PROPERTY],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, ""), done.stderr
