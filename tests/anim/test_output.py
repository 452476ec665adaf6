"""Every format decoded again: frames, size, duration, likeness; and what happens when writing fails."""

import os
import re
import signal
import subprocess
import sys
import time
from collections import deque
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

from anim.errors import AnimationError
from anim.model import Model
from anim.output import Film, check, open_film, sheet
from anim.output.encoder import ffmpeg
from anim.output.palette import sampled
from anim.output.sheet import shown
from anim.picture import Look
from anim.pipelines import kinematic
from anim.render import Scene, contact_sheet, frames, render

SIZE = (160, 120)
FRAMES = 20


@pytest.fixture(scope="module")
def scene() -> Scene:
    from anim.film import clip

    look = Look(size=SIZE, trace=True, shadow=True)
    return Scene(Model(ring=60), kinematic("product", clip(frames=FRAMES, fps=25)), look)


@pytest.fixture(scope="module")
def raw(scene: Scene) -> np.ndarray:
    return np.stack(list(frames(scene)))


FILM = Film(SIZE, FRAMES, 25)


def decoded(path: Path, size: tuple[int, int] = SIZE) -> np.ndarray:
    """The frames of a video, (frames, height, width, 3), as ffmpeg decodes it."""
    command = [
        ffmpeg(),
        "-loglevel",
        "error",
        "-i",
        str(path),
        "-f",
        "rawvideo",
        "-pix_fmt",
        "rgb24",
        "-",
    ]
    data = subprocess.run(command, capture_output=True, check=True).stdout
    return np.frombuffer(data, np.uint8).reshape(-1, size[1], size[0], 3)


def psnr(a: np.ndarray, b: np.ndarray) -> float:
    return float(-10 * np.log10(np.mean((a / 255.0 - b / 255.0) ** 2)))


def test_mp4(scene: Scene, tmp_path: Path) -> None:
    path, size = tmp_path / "top.mp4", (640, 480)
    large = Scene(scene.model, scene.motion, replace(scene.look, size=size))
    render(large, path, replace(FILM, size=size))
    raw, found = np.stack(list(frames(large))), decoded(path, size)
    assert found.shape == raw.shape
    assert psnr(found, raw) >= 36
    assert (
        abs(found[:, 0, 0].astype(int) - raw[:, 0, 0]).max() <= 3
    )  # the background keeps its colour
    said = subprocess.run(
        [ffmpeg(), "-i", str(path)], capture_output=True, text=True, check=False
    ).stderr
    assert "yuv420p(tv, bt709" in said
    duration = re.search(r"Duration: 00:00:(\d+\.\d+)", said)
    assert duration
    assert float(duration[1]) == pytest.approx(FRAMES / 25, abs=0.011)
    assert os.listdir(tmp_path) == ["top.mp4"]


@pytest.mark.parametrize(("suffix", "least"), [(".gif", 30), (".apng", 99), (".webp", 30)])
def test_moving_pictures(
    scene: Scene, raw: np.ndarray, tmp_path: Path, suffix: str, least: float
) -> None:
    path = tmp_path / f"top{suffix}"
    render(scene, path, FILM)
    with Image.open(path) as image:
        found = [np.asarray(page.convert("RGB")) for page in ImageSequence.Iterator(image)]
        assert image.size == SIZE
    assert len(found) == FRAMES
    with np.errstate(divide="ignore"):
        assert psnr(np.stack(found), raw) >= least
    assert durations(path) == pytest.approx([0.04] * FRAMES, abs=1e-9)


def durations(path: Path) -> list[float]:
    """How long each picture is shown, in seconds, read from the bytes of the file."""
    data = path.read_bytes()
    if path.suffix == ".gif":
        return [
            int.from_bytes(m[1], "little") / 100
            for m in re.finditer(rb"\x21\xf9\x04.(..).\x00", data, re.DOTALL)
        ]
    if path.suffix == ".apng":
        places = [m.end() for m in re.finditer(b"fcTL", data)]
        return [
            float(
                Fraction(
                    int.from_bytes(data[p + 20 : p + 22], "big"),
                    int.from_bytes(data[p + 22 : p + 24], "big"),
                )
            )
            for p in places
        ]
    places = [m.end() for m in re.finditer(b"ANMF", data)]
    return [int.from_bytes(data[p + 16 : p + 19], "little") / 1000 for p in places]


def test_folder(scene: Scene, raw: np.ndarray, tmp_path: Path) -> None:
    path = tmp_path / "top"
    render(scene, path, FILM)
    names = sorted(os.listdir(path))
    assert names == [f"frame_{n:05}.png" for n in range(FRAMES)]
    for name, frame in zip(names, raw, strict=True):
        with Image.open(path / name) as image:
            np.testing.assert_array_equal(np.asarray(image), frame)
    with pytest.raises(AnimationError, match="--force replaces them"):
        check(path, FILM)
    (path / "notes.txt").write_text("mine")
    with pytest.raises(AnimationError, match=r"holds 'notes.txt', which is no frame"):
        render(scene, path, FILM, force=True)
    assert (path / "notes.txt").read_text() == "mine"
    (path / "notes.txt").unlink()
    render(scene, path, FILM, force=True)
    assert os.listdir(tmp_path) == ["top"]


def test_sheet(scene: Scene, raw: np.ndarray) -> None:
    assert shown(500) == [0, 49, 99, 149, 199, 249, 299, 349, 399, 449]
    assert shown(1) == [0]
    assert shown(3) == [0, 1]
    picture = contact_sheet(scene)
    numbers = shown(FRAMES)
    assert len(numbers) == 10
    height, width = raw.shape[1:3]
    assert picture.shape == (2 * height + 3 * 6, 5 * width + 6 * 6, 3)
    for n, number in enumerate(numbers):
        y, x = 6 + n // 5 * (height + 6), 6 + n % 5 * (width + 6)
        part = picture[y : y + height, x : x + width]
        np.testing.assert_array_equal(part[20:], raw[number][20:])  # below the label
        assert (part[:20, :40] != raw[number][:20, :40]).any()
    assert sheet(raw[:1], [0]).shape == (height + 12, width + 12, 3)


def test_frames_are_the_same_in_other_processes(scene: Scene, raw: np.ndarray) -> None:
    from hfield.executors import open_executor

    with open_executor(2) as executor:
        for number, frame in enumerate(frames(scene, executor, 2)):
            np.testing.assert_array_equal(frame, raw[number])


def test_at_most_two_frames_a_process_are_in_flight(scene: Scene) -> None:
    from hfield.executors import InProcess

    class Counting(InProcess):
        submitted = 0

        def submit(self, fn, /, *args, **kwargs):
            self.submitted += 1
            return super().submit(fn, *args, **kwargs)

    executor = Counting()
    taken = frames(scene, executor, 3)
    next(taken)
    assert executor.submitted == 6


def test_motion_blur_is_the_mean_of_moments(scene: Scene, raw: np.ndarray) -> None:
    blurred = Scene(scene.model, scene.motion, scene.look, blur=1.0, steps=4)
    task = blurred.task(7)
    assert len(task.matrices) == 4
    singles = [next(frames(Still(scene, m), numbers=range(1))) for m in task.matrices]
    picture = next(frames(blurred, numbers=range(7, 8)))
    np.testing.assert_allclose(picture, np.mean(singles, axis=0), atol=0.5)
    assert (picture != raw[7]).any()
    with pytest.raises(AnimationError, match="from 0 to 1"):
        Scene(scene.model, scene.motion, scene.look, blur=1.5)


class Still(Scene):
    """A scene in one attitude, with the trail of another's seventh frame."""

    def __init__(self, scene: Scene, matrix: np.ndarray) -> None:
        super().__init__(scene.model, scene.motion, scene.look)
        object.__setattr__(self, "matrix", matrix)

    def task(self, number: int):
        from anim.render import Task

        return Task(self.model, self.look, self.matrix[None], self.motion.apex()[:8])


@pytest.mark.parametrize(
    ("name", "film", "message"),
    [
        ("top.avi", FILM, r"as '.avi'; expected .mp4, .gif"),
        ("top.png", FILM, "--sheet makes one .png"),
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
        words, capture_output=True, text=True, check=False, preexec_fn=limit, timeout=120
    )


COMMAND = (sys.executable, "-m", "hfield", "render", "--size", "160x120", "--points", "60")


@pytest.mark.parametrize("name", ["top.mp4", "top.gif", "top"])
def test_a_full_disk_is_one_clear_line(tmp_path: Path, name: str) -> None:
    # PNG pictures of this size take about 2 KB each, so that the limit must be lower there.
    size = 20_000 if "." in name else 1000
    done = limited(*COMMAND, "--frames", "300", "-o", str(tmp_path / name), size=size)
    assert done.returncode == 2, done
    assert len(done.stderr.strip().splitlines()) == 1
    assert "could not be written" in done.stderr
    assert "Traceback" not in done.stderr
    assert os.listdir(tmp_path) == []


def test_killed_in_the_middle_it_leaves_no_film_and_the_next_run_cleans_up(tmp_path: Path) -> None:
    path = tmp_path / "top.mp4"
    words = [*COMMAND, "--frames", "100000", "-o", str(path)]
    running = subprocess.Popen(words, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 60
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


def test_the_samples_of_the_palette_span_the_film() -> None:
    assert sampled(1) == [0]
    assert sampled(3) == [0, 1, 2]
    assert (sampled(500)[0], sampled(500)[-1], len(sampled(500))) == (0, 499, 8)
