"""Every format decoded again: frames, size, duration, likeness."""

import os
import re
import subprocess
from collections import deque
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

from anim.errors import AnimationError
from anim.output import Film, check, open_film, sheet
from anim.output.encoder import ffmpeg
from anim.output.luma import planes
from anim.output.palette import sampled
from anim.output.sheet import shown
from anim.picture import STYLES
from anim.rendering import Scene, contact_sheet, frames, render
from tests.anim.films import FILM, FRAMES, SIZE, decoded, psnr
from tests.thorough import pairwise


@pytest.mark.slow
def test_mp4(scene: Scene, tmp_path: Path) -> None:
    path, size = tmp_path / "top.mp4", (640, 480)
    large = Scene(scene.model, scene.motion, replace(scene.settings, size=size))
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


@pytest.mark.parametrize("block", [1, 2])
def test_luma_and_chroma_are_those_of_bt709(block: int) -> None:
    frame = np.random.default_rng(7).integers(0, 256, (8, 30, 3), dtype=np.uint8)
    frame[0, :2], frame[1, :2] = 255, 0
    frame[2:4, :2] = [0, 0, 255]
    luma = np.empty((8, 30), np.uint8)
    blue, red = np.empty((2, 8 // block, 30 // block), np.uint8)
    planes(frame.reshape(8, 90), luma, blue, red)
    r, g, b = np.moveaxis(frame / 255, 2, 0)
    y = 0.2126 * r + 0.7152 * g + 0.0722 * b
    assert np.abs(luma - (16 + 219 * y)).max() < 0.501
    for found, chroma in ((blue, (b - y) / 1.8556), (red, (r - y) / 1.5748)):
        mean = chroma.reshape(8 // block, block, 30 // block, block).mean(axis=(1, 3))
        assert np.abs(found - (128 + 224 * mean)).max() < 0.501


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


@pytest.mark.slow
@pytest.mark.parametrize(("style", "size"), pairwise(STYLES, (SIZE, (320, 240), (640, 480))))
def test_every_frame_of_an_mp4_is_like_what_was_drawn(
    scene: Scene, tmp_path: Path, style: str, size: tuple[int, int]
) -> None:
    path, count = tmp_path / "top.mp4", 6
    small = Scene(scene.model, scene.motion, replace(scene.settings, size=size, style=style))
    drawn = list(frames(small, numbers=range(FRAMES - count, FRAMES)))
    with open_film(path, Film(size, count, 25)) as write:
        deque(map(write, drawn))
    found = decoded(path, size)
    assert min(psnr(a, b) for a, b in zip(found, drawn, strict=True)) >= 34


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
    with pytest.raises(AnimationError, match=r"holds 'notes.txt', which is not a frame"):
        render(scene, path, FILM, force=True)
    assert (path / "notes.txt").read_text() == "mine"
    (path / "notes.txt").unlink()
    render(scene, path, FILM, force=True)
    assert os.listdir(tmp_path) == ["top"]


def test_sheet(scene: Scene, raw: np.ndarray) -> None:
    assert shown(500) == [0, 49, 99, 149, 199, 249, 299, 349, 399, 449]
    assert shown(1) == [0]
    assert shown(3) == [0, 1, 2]
    numbers = shown(FRAMES)
    picture = contact_sheet(scene, numbers)
    assert len(numbers) == 10
    height, width = raw.shape[1:3]
    assert picture.shape == (2 * height + 3 * 6, 5 * width + 6 * 6, 3)
    for n, number in enumerate(numbers):
        y, x = 6 + n // 5 * (height + 6), 6 + n % 5 * (width + 6)
        part = picture[y : y + height, x : x + width]
        np.testing.assert_array_equal(part[20:], raw[number][20:])  # below the label
        assert (part[:20, :40] != raw[number][:20, :40]).any()
    assert sheet(raw[:1], [0]).shape == (height + 12, width + 12, 3)


@pytest.mark.slow
def test_frames_are_the_same_in_other_processes(scene: Scene, raw: np.ndarray) -> None:
    from hfield.core.executors import open_executor

    with open_executor(2) as executor:
        for number, frame in enumerate(frames(scene, executor, 2)):
            np.testing.assert_array_equal(frame, raw[number])


def test_at_most_two_frames_a_process_are_in_flight(scene: Scene) -> None:
    from hfield.core.executors import InProcess

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
    blurred = Scene(scene.model, scene.motion, scene.settings, blur=1.0, steps=4)
    task = blurred.task(7)
    assert len(task.matrices) == 4
    singles = [next(frames(Still(scene, m), numbers=range(1))) for m in task.matrices]
    picture = next(frames(blurred, numbers=range(7, 8)))
    np.testing.assert_allclose(picture, np.mean(singles, axis=0), atol=0.5)
    assert (picture != raw[7]).any()
    with pytest.raises(AnimationError, match="from 0 to 1"):
        Scene(scene.model, scene.motion, scene.settings, blur=1.5)


class Still(Scene):
    """A scene in one attitude, with the trail of another's seventh frame."""

    def __init__(self, scene: Scene, matrix: np.ndarray) -> None:
        super().__init__(scene.model, scene.motion, scene.settings)
        object.__setattr__(self, "still", replace(scene.task(7), matrices=matrix[None]))

    def task(self, number: int):
        return self.still


def test_the_samples_of_the_palette_span_the_film() -> None:
    assert sampled(1) == [0]
    assert sampled(3) == [0, 1, 2]
    assert (sampled(500)[0], sampled(500)[-1], len(sampled(500))) == (0, 499, 8)
