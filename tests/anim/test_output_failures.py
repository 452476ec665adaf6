"""What cannot be written, and what is left when writing fails: one clear line, and no file."""

import os
import signal
import subprocess
import sys
import time
from collections import deque
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from anim.errors import AnimationError
from anim.output import Film, check, open_film
from anim.output.destination import file_place
from anim.rendering import Scene, render
from tests.anim.films import FILM, FRAMES, SIZE, decoded
from tests.patience import PATIENCE
from tests.subcases import first_quick


@pytest.mark.parametrize(
    ("name", "film", "message"),
    [
        ("top.avi", FILM, r"'.avi' is unknown; expected \.apng, \.gif"),
        ("top.png", FILM, "--frame N makes a .png of one frame, --sheet of ten"),
        ("top.mp4", Film((161, 120), 5, 25), "try --size 162x120"),
        ("top.mp4", Film((160, 121), 5, 25), "try --size 160x122"),
        ("top.gif", Film(SIZE, 5, 60), "at most 50 frames a second"),
        ("top.webp", Film((16_384, 16), 5, 25), "at most 16383"),
        ("missing/top.mp4", FILM, "does not exist"),
    ],
)
def test_what_cannot_be_is_refused_at_once(
    tmp_path: Path, name: str, film: Film, message: str
) -> None:
    with pytest.raises(AnimationError, match=message):
        check(tmp_path / name, film)


def test_a_file_that_exists_is_kept(scene: Scene, tmp_path: Path) -> None:
    path = tmp_path / "top.mp4"
    path.write_text("mine")
    with pytest.raises(AnimationError, match="exists; --force replaces it"):
        render(scene, path, FILM)
    assert path.read_text() == "mine"
    render(scene, path, FILM, force=True)
    assert len(decoded(path)) == FRAMES


@pytest.mark.skipif(os.geteuid() == 0, reason="the superuser may write everywhere")
def test_an_unwritable_folder(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    with pytest.raises(AnimationError, match="cannot be written"):
        check(tmp_path / "top.mp4", FILM)


@pytest.mark.parametrize("suffix", [".mp4", ".gif", ""])
def test_an_error_while_drawing_leaves_nothing(
    raw: np.ndarray, tmp_path: Path, suffix: str
) -> None:
    path = tmp_path / f"top{suffix}"
    path.write_text("mine") if suffix else None

    def pictures() -> Iterator[np.ndarray]:
        yield raw[0]
        raise KeyError

    with pytest.raises(KeyError), open_film(path, FILM, lambda: raw[:2], force=True) as write:
        deque(map(write, pictures()))
    assert os.listdir(tmp_path) == (["top" + suffix] if suffix else [])


@pytest.mark.slow
def test_missing_frames_are_noticed(raw: np.ndarray, tmp_path: Path) -> None:
    for name in ("top.mp4", "top.webp", "top"):
        with (
            pytest.raises(AnimationError, match=f"of {FRAMES} frames"),
            open_film(tmp_path / name, FILM) as write,
        ):
            write(raw[0])
    assert os.listdir(tmp_path) == []


def test_a_missing_encoder_is_explained(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with (
        pytest.raises(AnimationError, match="pip install imageio-ffmpeg"),
        open_film(tmp_path / "t.mp4", FILM),
    ):
        pass


def limited(*words: str, size: int) -> subprocess.CompletedProcess[str]:
    """Run a command whose files may not grow beyond ``size`` bytes, like a disk that is full."""
    import resource

    def limit() -> None:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    return subprocess.run(
        words,
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=limit,
        timeout=PATIENCE,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},  # modules would be cut off too
    )


COMMAND = (sys.executable, "-m", "hfield", "render", "--points", "60")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["top.mp4", "top.gif", "top", "top.html"])
def test_a_full_disk_is_one_clear_message(tmp_path: Path, name: str) -> None:
    # PNG pictures of this size take about 2 KB each, so that the limit must be lower there.
    size = 20_000 if "." in name else 1000
    size_of_pictures = () if name.endswith(".html") else ("--size", "160x120")
    words = (*COMMAND, *size_of_pictures, "--frames", "300", "-o", str(tmp_path / name))
    done = limited(*words, size=size)
    assert done.returncode == 2, done
    said = done.stderr[
        done.stderr.index("hfield: error: ") :
    ]  # a note on the film may stand before
    _, *rest = said.strip().splitlines()
    assert all(line.startswith("  ") for line in rest), "one message, wrapped"
    assert "could not be written" in " ".join(done.stderr.split())
    assert "Traceback" not in done.stderr
    assert os.listdir(tmp_path) == []


@pytest.mark.slow
def test_killed_in_the_middle_it_leaves_no_film_and_the_next_run_cleans_up(tmp_path: Path) -> None:
    path = tmp_path / "top.mp4"
    words = [*COMMAND, "--frames", "20000", "-o", str(path)]
    running = subprocess.Popen(words, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + PATIENCE
    while not (parts := list(tmp_path.glob(".top.*.part.mp4"))) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert parts
    time.sleep(0.5)
    running.kill()
    running.wait()
    assert not path.exists()
    done = subprocess.run(
        [*COMMAND, "--frames", "10", "-o", str(path)], capture_output=True, check=False
    )
    assert done.returncode == 0
    assert os.listdir(tmp_path) == ["top.mp4"]


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("folder.mp4", "is a folder"),
        (".mp4", "a suffix without a name"),
        ("x" * 300 + ".mp4", "File name too long"),
        ("circle.mp4", "a link to itself"),
        ("nowhere.mp4", "does not exist"),
    ],
)
def test_names_that_cannot_be_written(tmp_path: Path, name: str, message: str) -> None:
    (tmp_path / "folder.mp4").mkdir()
    (tmp_path / "circle.mp4").symlink_to("circle.mp4")
    (tmp_path / "nowhere.mp4").symlink_to("no/where.mp4")
    with pytest.raises(AnimationError, match=message):
        check(tmp_path / name, FILM)


@pytest.mark.parametrize(
    "name",
    first_quick(
        ["http:x.mp4", "%d.webp", "a:b.apng", "%03d.gif", "[x]*?.gif", "y" * 250 + ".mp4"], 1
    ),
)
def test_odd_names_are_only_names(raw: np.ndarray, tmp_path: Path, name: str) -> None:
    with open_film(tmp_path / name, Film(SIZE, 2, 25), lambda: raw[:2]) as write:
        deque(map(write, raw[:2]))
    assert os.listdir(tmp_path) == [name]


def test_a_link_stays_one(raw: np.ndarray, tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    for name, target in (("top.apng", "real/a.apng"), ("top", "real")):
        (tmp_path / name).symlink_to(target)
        with open_film(tmp_path / name, Film(SIZE, 2, 25)) as write:
            deque(map(write, raw[:2]))
        assert (tmp_path / name).is_symlink()
        if name == "top.apng":
            assert (tmp_path / target).stat().st_size > 1000
            (tmp_path / target).unlink()
    assert sorted(os.listdir(tmp_path / "real")) == ["frame_00000.png", "frame_00001.png"]


def test_leftovers_of_a_dead_run_are_swept_away_even_with_our_own_number(tmp_path: Path) -> None:
    dead = 2**22 + 1  # above the greatest number of a process
    for number in (dead, os.getpid()):
        (tmp_path / f".top.{number}.part.gif").touch()
        (tmp_path / f".top.{number}.part.palette.png").touch()
    alive, strange = f".top.{os.getppid()}.part.gif", ".top.mine.part.gif"
    (tmp_path / alive).touch()
    (tmp_path / strange).touch()
    with file_place(tmp_path / "top.gif", False) as part:
        part.touch()
    assert sorted(os.listdir(tmp_path)) == sorted([alive, strange, "top.gif"])


def test_a_missing_encoder_is_found_before_any_work(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("IMAGEIO_FFMPEG_EXE", str(tmp_path / "none"))
    with pytest.raises(AnimationError, match="ffmpeg, which is missing"):
        check(tmp_path / "top.mp4", FILM)
    check(tmp_path / "top", FILM)
