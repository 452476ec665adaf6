"""The film's numbers, the timeline's readings, and motions between frames."""

import pickle
from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from anim.aliasing import apparent_spin
from anim.errors import AnimationError
from anim.film import Clip, clip
from anim.motion import Motion
from anim.pipelines import PIPELINES, kinematic
from anim.timeline import Timeline
from rotation.vectors import from_axis_angle
from tests.subcases import subcases

UP = [0.0, 0.0, 1.0]


def spinning(rate, film):
    """A top that stands upright and spins at ``rate`` rad/s."""
    return Motion.sample("spin", film, lambda t: from_axis_angle(UP, rate * t))


@subcases(
    ("given_", "made"),
    [
        ({}, (500, 50, 10)),
        ({"frames": 100}, (100, 50, 10)),
        ({"fps": 25}, (250, 25, 10)),
        ({"frames": 100, "fps": 25}, (100, 25, 10)),
        ({"duration": 4}, (200, 50, 4)),
        ({"duration": 4, "frames": 100}, (100, 25, 4)),
        ({"duration": 4, "fps": 10}, (40, 10, 4)),
        ({"duration": 4, "fps": 25, "frames": 100}, (100, 25, 4)),
        ({"time_scale": 0.5}, (1000, 50, 10)),
        ({"time_scale": 0.5, "duration": 4}, (200, 50, 2)),
        ({"time_scale": 0.5, "frames": 100}, (100, 5, 10)),
        ({"time_scale": 2, "frames": 100, "fps": 25}, (100, 25, 8)),
        ({"time_scale": 2, "fps": 25}, (125, 25, 10)),
        ({"frames": 1}, (1, 50, 10)),
    ],
)
def test_two_numbers_make_a_film(given_, made):
    film = clip(**given_)
    assert (film.frames, film.fps, film.seconds) == pytest.approx(made)
    assert film.duration == pytest.approx(film.frames / film.fps)
    if "time_scale" in given_:
        assert film.time_scale == pytest.approx(given_["time_scale"])


@subcases(
    ("given_", "words"),
    [
        ({"frames": 0}, "frames is 0; expected a number from 1"),
        ({"frames": 2.5}, "whole number"),
        ({"fps": 0}, "fps is 0; expected a number greater than 0"),
        ({"fps": -5}, "greater than 0"),
        ({"fps": 1e9}, "at most"),
        ({"duration": float("inf")}, "finite"),
        ({"duration": 1e300, "fps": 50}, "make .* frames"),
        ({"duration": 1e-9}, "make .* frames"),
        ({"time_scale": 0}, "greater than 0"),
        ({"time_scale": "slow"}, "real number"),
        ({"frames": 10, "fps": 10, "duration": 3}, "do not last 3 seconds"),
    ],
)
def test_what_makes_no_film_is_refused(given_, words):
    with pytest.raises(AnimationError, match=words):
        clip(**given_)


def test_the_ranges_are_those_of_section_341():
    now = Timeline().at(np.linspace(0, 1, 500), 10)
    assert now.spin[[0, -1]] == pytest.approx([16 * pi, pi / 8])
    assert np.ptp(np.diff(now.spin)) < 1e-12
    turn = np.unwrap(np.arctan2(now.axes[1:, 1], now.axes[1:, 0]))
    assert np.diff(turn) == pytest.approx(32 * pi / 499)
    assert np.linalg.norm(now.axes, axis=1) == pytest.approx(1)
    assert np.hypot(*now.axes[:, :2].T) == pytest.approx(np.linspace(0, 1 / 4, 500))
    assert np.all(now.angles == pi / 2)
    assert np.hypot(*now.euler[:, 1:].T) == pytest.approx(np.linspace(0, 1 / 2, 500))
    assert np.all(now.euler[:, 0] == 0)


def test_the_accumulated_spin_is_the_integral_of_the_speed():
    progress = np.linspace(0, 1, 100_001)
    speed = Timeline().at(progress, 7).spin
    sums = np.concatenate([[0], np.cumsum((speed[1:] + speed[:-1]) / 2)]) * 7 / 100_000
    assert Timeline(spin="accumulated").at(progress, 7).spin == pytest.approx(sums, abs=1e-9)


@pytest.mark.parametrize(
    ("angle", "first", "last"),
    [("quarter", pi / 2, pi / 2), ("half", pi, pi), ("axis", 0, 32 * pi), (1.25, 1.25, 1.25)],
)
def test_the_angle_has_its_readings(angle, first, last):
    angles = Timeline(angle=angle).at(np.array([0.0, 1.0]), 10).angles
    assert angles == pytest.approx([first, last])


@pytest.mark.parametrize(
    "values",
    [{"spin": "fast"}, {"order": "both"}, {"angle": "third"}, {"angle": None}, {"euler": "xyz"}],
)
def test_other_readings_are_refused(values):
    with pytest.raises(AnimationError):
        Timeline(**values)
    with pytest.raises(AnimationError, match="progress"):
        Timeline().at(np.array([1.5]), 10)


@pytest.mark.parametrize("pipeline", PIPELINES)
@pytest.mark.parametrize("reading", [Timeline(), Timeline(spin="accumulated", angle="half")])
def test_fewer_frames_sample_the_same_motion(pipeline, reading):
    many, few = (kinematic(pipeline, clip(frames=n), reading) for n in (499, 167))
    assert abs(many.matrices[::3] - few.matrices).max() < 1e-12
    assert kinematic(pipeline, clip(frames=1), reading).frames == 1


@pytest.mark.parametrize("pipeline", PIPELINES)
def test_a_motion_gives_a_unit_quaternion_and_a_matrix_a_frame(pipeline):
    motion = kinematic(pipeline)
    assert motion.attitudes.shape == (500, 4)
    assert motion.matrices.shape == (500, 3, 3)
    assert np.linalg.norm(motion.attitudes, axis=1) == pytest.approx(1, abs=1e-14)
    gram = np.swapaxes(motion.matrices, 1, 2) @ motion.matrices
    assert abs(gram - np.eye(3)).max() < 1e-14
    assert np.sum(motion.attitudes[1:] * motion.attitudes[:-1], axis=1).min() > 0
    assert (motion.duration, motion.fps, motion.record) == (10, 50, None)
    assert motion.apex().shape == (500, 3)
    assert np.linalg.norm(motion.apex(), axis=1) == pytest.approx(3)
    assert motion.tilts[0] == pytest.approx(0, abs=1e-7)
    for values in (motion.attitudes, motion.matrices):
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 0
    again = pickle.loads(pickle.dumps(motion))
    assert np.array_equal(again.at([1.0]), motion.at([1.0]))


def test_attitudes_between_frames_are_those_of_a_finer_film():
    reading = Timeline(spin="accumulated")
    coarse, fine = (kinematic("product", clip(frames=n), reading) for n in (101, 401))
    between = coarse.between(7, [-0.25, 0, 0.5, 1])
    same = np.abs(np.sum(between * fine.attitudes[[27, 28, 30, 32]], axis=1))
    assert same == pytest.approx(1, abs=1e-14)
    # Before the beginning and after the end the attitude stays the same.
    overlap = np.abs(np.sum(coarse.between(0, [-0.5, 0])[0] * coarse.attitudes[0]))
    assert overlap == pytest.approx(1, abs=1e-14)
    with pytest.raises(AnimationError, match="frame is 101"):
        coarse.between(101, [0])


@given(st.floats(-3, 3), st.floats(0, 1))
def test_a_motion_through_given_attitudes_turns_the_shortest_way(rate, fraction):
    film = Clip(5, 1.0, 4.0)
    motion = Motion.through("given", film, spinning(rate, film).attitudes * -2.0)
    there, wanted = motion.between(2, [fraction]), from_axis_angle(UP, [rate * (2 + fraction)])
    assert abs(np.sum(there * wanted)) == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize("values", [np.ones((4, 4)), np.zeros((5, 4)), np.full((5, 4), np.nan)])
def test_what_are_no_attitudes_is_refused(values):
    with pytest.raises(AnimationError):
        Motion.through("given", Clip(5, 1.0, 4.0), values)


@given(st.floats(-500, 500))
def test_spin_rates_are_those_of_the_motion(rate):
    motion = spinning(rate, Clip())
    assert motion.spin_rates([0, 3.3, 10]) == pytest.approx(rate, abs=1e-7)


@pytest.mark.parametrize(
    ("turn", "bands", "seen", "standing", "backwards"),
    [
        (0.1, 10, 0.1, False, False),
        (0.8, 10, 0.8 - 0.4 * pi, False, True),
        (-0.8, 10, 0.4 * pi - 0.8, False, True),
        (0.4 * pi, 10, 0.0, True, False),
        (0.4 * pi + 0.2, 10, 0.2, False, False),
        (0.8, 5, 0.8, False, False),
        (0.001, 10, 0.001, False, False),
        (2 * pi - 0.3, 1, -0.3, False, True),
    ],
)
def test_bands_may_seem_to_stand_or_to_run_backwards(turn, bands, seen, standing, backwards):
    film = Clip(20, 50.0, 19 / 50)
    spin = apparent_spin(spinning(turn * 50, film), bands)
    assert spin.true == pytest.approx(turn, abs=1e-9)
    assert spin.seen == pytest.approx(seen, abs=1e-9)
    assert np.all(spin.standing == standing)
    assert np.all(spin.backwards == backwards)
    assert spin.misleading == (standing or backwards)
    assert ("stand" in spin.message(), "backwards" in spin.message()) == (standing, backwards)


def test_the_absolute_spin_is_a_constant_slow_turn_backwards():
    spin = apparent_spin(kinematic(), 10)
    assert np.all(spin.true < 0)
    assert spin.true[0] == pytest.approx(-(16 * pi - pi / 8) / 499, rel=1e-3)
    assert spin.message() == ""


def test_the_accumulated_spin_is_too_fast_for_ten_bands_at_first():
    spin = apparent_spin(kinematic(reading=Timeline(spin="accumulated")), 10)
    assert spin.backwards[0]
    assert not spin.backwards[-1]
    assert "backwards in 38% of the frames, from frame 0 on" in spin.message()
    assert apparent_spin(kinematic(clip=clip(frames=1)), 10).message() == ""
