"""Motions of one's own: arrays, rotations, functions of time, files; and what is refused."""

from argparse import ArgumentParser
from math import cos, nan, sin

import numpy as np
import pytest

from anim.commands.arguments import declare
from anim.commands.choices import clip_of, recorded_of
from anim.errors import AnimationError
from anim.film import Clip, clip
from anim.given_motion import motion_of
from anim.pipelines import kinematic
from hfield.cli import main
from hfield.errors import TableError
from rotation import Rotation

HALF = 0.5**0.5
TURNS = np.array([[cos(a), 0, 0, sin(a)] for a in np.linspace(0, 1, 11)])


def test_an_array_is_one_attitude_a_frame() -> None:
    motion = motion_of(-3 * TURNS)
    assert motion.clip == Clip(11, 50.0, 11 / 50)
    np.testing.assert_allclose(abs(np.sum(motion.attitudes * TURNS, axis=1)), 1, atol=1e-15)
    np.testing.assert_allclose(motion.spin_rates([0.1]), 2 * 0.1 / motion.clip.interval)
    np.testing.assert_array_equal(motion_of(TURNS.tolist()).matrices, motion_of(TURNS).matrices)


def test_rotations_are_taken_from_either_class() -> None:
    rotations = Rotation(TURNS)
    scipys = pytest.importorskip("scipy.spatial.transform").Rotation.from_quat(
        TURNS[:, [1, 2, 3, 0]]
    )
    for source in (rotations, scipys):
        np.testing.assert_allclose(motion_of(source).matrices, rotations.as_matrix(), atol=1e-15)


@pytest.mark.parametrize(
    "function",
    [
        lambda t: (2 * cos(t), 0, 0, 2 * sin(t)),
        lambda t: Rotation.from_rotvec([0, 0, 2 * t]),
        lambda t: Rotation.from_rotvec([0, 0, 2 * t]).as_matrix(),
    ],
)
def test_a_function_of_time(function) -> None:
    motion = motion_of(function, clip(duration=0.5))
    assert (motion.frames, motion.clip.seconds) == (25, 0.5)
    turned = Rotation.from_rotvec(np.outer(2 * motion.times, [0, 0, 1])).as_matrix()
    np.testing.assert_allclose(motion.matrices, turned, atol=1e-14)


@pytest.mark.parametrize(
    ("source", "words"),
    [
        (np.zeros((0, 4)), "0 attitudes; expected two or more"),
        ([[1, 0, 0, 0]], "1 attitude; expected two or more"),
        (Rotation([1, 0, 0, 0]), r"the shape \(4,\)"),
        (np.ones((5, 3)), r"the shape \(5, 3\); expected \(n, 4\)"),
        ([[1, 0, 0, 0], [0, 0, 0, 0]], "quaternion 1 of the motion is 0"),
        ([[1, 0, 0, 0], [1, nan, 0, 0]], "quaternion 1 of the motion is not finite"),
        (object(), "expected quaternions"),
        (None, r"the shape \(\); expected"),
        ("matrices", "expected one of quaternions, product"),
        (lambda t: (0, 0, 0, 0), "t = 0 returns the quaternion 0"),
        (lambda t: t, r"returns the shape \(\)"),
        (lambda t: "x", "returns a str"),
        (lambda t: (nan, 0, 0, 0), "not finite"),
        (lambda t: 2 * np.eye(3), "not a rotation"),
        (lambda t: np.eye(3) if t else (1, 0, 0, 0), "both quaternions and matrices"),
    ],
)
def test_what_is_no_motion_is_refused(source, words) -> None:
    with pytest.raises(AnimationError, match=words):
        motion_of(source)


def test_a_file_that_cannot_be_read_is_named() -> None:
    with pytest.raises(TableError, match="could not be read"):
        motion_of("none.csv")


def test_a_motion_keeps_its_own_film() -> None:
    motion = kinematic()
    assert motion_of(motion) is motion
    with pytest.raises(AnimationError, match="its own frames"):
        motion_of(motion, clip(frames=3))


def written(folder, rows, name="own.csv"):
    path = folder / name
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return path


def test_a_file_of_quaternions(tmp_path) -> None:
    path = written(tmp_path, ["w,x,y,z", *(",".join(map(repr, q)) for q in TURNS.tolist())])
    np.testing.assert_array_equal(motion_of(path).attitudes, motion_of(TURNS).attitudes)
    assert motion_of(str(path)).name == "own.csv"


def test_a_file_with_seconds_is_sampled_evenly(tmp_path) -> None:
    path = written(tmp_path, ["3 1 0 0 0", "3.5 0 0 0 1", f"5 {-HALF} 0 0 {HALF}"])
    motion = motion_of(path)
    assert (motion.frames, motion.clip.seconds) == (100, 2.0)
    np.testing.assert_allclose(abs(motion.at([0.25])[0] @ [HALF, 0, 0, HALF]), 1)
    np.testing.assert_allclose(abs(motion.at([2.0])[0] @ [-HALF, 0, 0, HALF]), 1)
    with pytest.raises(AnimationError, match="lasts 2 s, and a film of 3 s"):
        motion_of(path, clip(duration=3))


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        (["1 0 0 0", "0 0 0 0"], "own.csv, line 2: the quaternion is 0"),
        (["w x y z", "1 0 0 0"], "own.csv, line 2 is the only attitude"),
        (["1 0 0", "1 0 0"], "own.csv, line 1 has 3 numbers; expected 4 numbers (w, x, y, z"),
        (["0 1 0 0 0", "1 1 0 0 0", "1 1 0 0 0"], "own.csv, line 3: the time is not after"),
    ],
)
def test_errors_name_file_and_line(tmp_path, monkeypatch, capsys, rows, words) -> None:
    monkeypatch.chdir(tmp_path)
    written(tmp_path, rows)
    assert main(["render", "--motion", "own.csv", "-o", "top.mp4"]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "frames", "fps", "seconds"),
    [
        ([], 11, 50, 0.22),
        (["--fps", "10"], 11, 10, 1.1),
        (["--frames", "3"], 3, 3 / 0.22, 0.22),
        (["--time-scale", "0.5"], 22, 50, 0.22),
        (["--duration", "0.1"], 5, 50, 0.1),
        (["--frames", "4", "--fps", "50"], 4, 50, 0.08),
    ],
)
def test_how_long_a_recorded_motion_lasts(tmp_path, words, frames, fps, seconds) -> None:
    path = written(tmp_path, [" ".join(map(repr, q)) for q in TURNS.tolist()])
    parser = ArgumentParser()
    declare(parser)
    args = parser.parse_args(["--motion", str(path), "-o", "a.mp4", *words])
    film = clip_of(args, recorded_of(args))
    assert (film.frames, film.fps) == (frames, pytest.approx(fps))
    assert film.seconds == pytest.approx(seconds)


@pytest.mark.parametrize(
    "flag", ["--model=euler", "--spin-rate=3", "--friction=1", "--order=tilt-first"]
)
def test_a_recorded_motion_has_no_other(tmp_path, capsys, flag) -> None:
    path = written(tmp_path, ["1 0 0 0", "0 0 0 1"])
    assert main(["render", "--motion", str(path), flag, "-o", str(tmp_path / "a.mp4")]) == 2
    assert f"leave out {flag.partition('=')[0]}" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["film.gif", "top.html", "one.png", "folder"])
def test_the_command_makes_all_kinds_of_a_recorded_motion(tmp_path, name) -> None:
    path = written(tmp_path, ["1 0 0 0", "1 0.1 0 0.2", "1 0.1 0.1 0.5"])
    words = ["--points", "30", "-o", str(tmp_path / name)]
    if not name.endswith(".html"):
        words += ["--size", "64x48"]
    assert main(["render", "--motion", str(path), *words]) == 0
    assert (tmp_path / name).exists()
