"""Swing and twist, six numbers, conventions of programs, integration to a tolerance."""

import itertools

import numpy as np
import pytest

from rotation import (
    DTypeError,
    RigidTransform,
    Rotation,
    RotationError,
    change_of_axes,
    convert_points,
    convert_rotation,
    convert_transform,
    integrate,
    swing_twist,
)
from rotation.program_axes import AXES
from tests.subcases import subcases

RNG = np.random.default_rng(21)


def test_swing_and_twist_make_the_rotation() -> None:
    r, axes = Rotation.random(200, seed=1), RNG.standard_normal((200, 3))
    swing, twist = swing_twist(r, axes)
    assert (swing * twist).approx_equal(r, atol=1e-14).all()
    np.testing.assert_allclose(np.sum(swing.as_rotvec() * axes, axis=1), 0, atol=1e-13)
    np.testing.assert_allclose(np.cross(twist.as_rotvec(), axes), 0, atol=1e-13)
    for angle in np.linspace(-3, 3, 13):  # no other turn about the axis is nearer
        other = Rotation.from_axis_angle(axes, angle)
        assert (swing.magnitude() <= (r * other.inv()).magnitude() + 1e-12).all()
    half = Rotation.from_rotvec([np.pi, 0, 0])
    swing, twist = swing_twist(half, [0, 0, 1])
    assert twist == Rotation.identity()
    assert swing.approx_equal(half)
    for axis in ([0, 0, 0], np.ones((3, 3))):
        with pytest.raises(RotationError):
            swing_twist(r[:2], axis)


def test_six_numbers_come_back() -> None:
    r = Rotation.random((5, 4), seed=2)
    assert r.as_6d().shape == (5, 4, 6)
    np.testing.assert_array_equal(r.as_6d()[..., :3], r.as_matrix()[..., :, 0])
    assert Rotation.from_6d(r.as_6d()).approx_equal(r, atol=1e-15).all()
    skew = Rotation.from_6d([2, 0, 0, 5, 1e-3, 0])
    assert skew.approx_equal(Rotation.identity(), atol=1e-15)
    for bad in ([0, 0, 0, 1, 0, 0], [1, 2, 3, 2, 4, 6], [1, 0, 0, 0, 0, 0], [1, 2, 3]):
        with pytest.raises(RotationError):
            Rotation.from_6d(bad)


@subcases(("source", "target"), [*itertools.permutations(AXES, 2)])
def test_conventions_agree_about_what_happens(source: str, target: str) -> None:
    r, v = Rotation.random(10, seed=3), RNG.standard_normal((10, 3))
    turned = convert_rotation(r, source, target).apply(convert_points(v, source, target))
    np.testing.assert_allclose(turned, convert_points(r.apply(v), source, target), atol=1e-14)
    s = change_of_axes(source, target)
    np.testing.assert_array_equal(s @ change_of_axes(target, source), np.eye(3))


def test_conventions_have_the_hands_they_are_known_for() -> None:
    hands = {name: round(np.linalg.det(change_of_axes("ros", name))) for name in AXES}
    assert {name for name, hand in hands.items() if hand < 0} == {"unity", "unreal"}
    np.testing.assert_array_equal(convert_points([1, 2, 3], "ros", "unity"), [-2, 3, 1])
    np.testing.assert_array_equal(convert_points([1, 2, 3], "ros", "opencv"), [-2, -3, 1])
    np.testing.assert_array_equal(convert_points([1, 2, 3], "ros", "ned"), [1, -2, -3])
    with pytest.raises(RotationError, match="one of ros"):
        change_of_axes("ros", "maya")


@pytest.mark.slow
@pytest.mark.parametrize("frame", ["body", "world"])
def test_integration_to_a_tolerance(frame: str) -> None:
    def omega(t: float) -> list[float]:
        return [np.sin(3 * t), 2 * np.cos(t), 1 + t]

    times = [0.0, 1.0, 3.0]
    exact = integrate(omega, np.linspace(0, 3, 3001), frame=frame)[[0, 1000, 3000]]
    for tolerance in (1e-3, 1e-6, 1e-9):
        found = integrate(omega, times, frame=frame, tolerance=tolerance)
        assert (found.inv() * exact).magnitude().max() <= tolerance
    calls = []
    integrate(lambda t: calls.append(t) or omega(t), times, tolerance=1e-3)
    assert len(calls) < 300
    assert integrate(omega, [2.0], tolerance=1e-3).shape == (1,)
    assert integrate(lambda _: np.ones((0, 3)), times, tolerance=1e-3).shape == (3, 0)
    assert integrate(lambda _: np.ones((2, 4, 3)), times, tolerance=1e-3).shape == (3, 2, 4)
    assert np.isnan(integrate(lambda _: [np.nan, 0, 0], times, tolerance=1e-3)[1:].as_quat()).all()
    for bad in (0.0, -1.0, np.nan):
        with pytest.raises(RotationError, match="tolerance"):
            integrate(omega, times, tolerance=bad)
    with pytest.raises(RotationError, match="function"):
        integrate([0, 0, 1], times, tolerance=1e-3)
    with pytest.raises(RotationError, match="not reached"):
        integrate(
            lambda t: [1e6 * np.sin(1e6 * t * t), 1e5 * np.cos(t), 0], [0.0, 1.0], tolerance=1e-15
        )


@pytest.mark.parametrize(("source", "target"), [("ROS", "unity"), ("opencv", "Blender")])
def test_conventions_of_motions(source: str, target: str) -> None:
    t = RigidTransform.from_components(RNG.standard_normal((10, 3)), Rotation.random(10, seed=4))
    v = RNG.standard_normal((10, 3))
    moved = convert_transform(t, source, target).apply(convert_points(v, source, target))
    np.testing.assert_allclose(moved, convert_points(t.apply(v), source, target), atol=1e-14)
    assert convert_points(v.astype(np.float32), source, target).dtype == np.float32
    with pytest.raises(DTypeError, match="from_rotation"):
        convert_transform(t.rotation, source, target)  # type: ignore[arg-type]
    with pytest.raises(RotationError, match="one of ros"):
        change_of_axes(3, target)  # type: ignore[arg-type]


@subcases("frame", ["body", "world"])
@subcases("place", [0.5123, 0.5, 0.211, 1 / 3, 0.999, 1e-3])
def test_integration_finds_a_jump(frame: str, place: float) -> None:
    before, after = np.array([1.0, 2, -1]), np.array([-2.0, 1, 4])

    def omega(t: float) -> np.ndarray:
        return before if t < place else after

    turns = [Rotation.from_rotvec(v) for v in (place * before, (1 - place) * after, 0.5 * after)]
    ways = turns if frame == "body" else turns[::-1]
    wanted = ways[0] * ways[1] * ways[2]
    for tolerance in (1e-3, 1e-6, 1e-9):
        found = integrate(omega, [0, 1, 1.5], frame=frame, tolerance=tolerance)
        assert (found[-1].inv() * wanted).magnitude() <= tolerance
    calls = []
    integrate(lambda t: calls.append(t) or omega(t), [0, 1, 1.5], tolerance=1e-9)
    assert len(calls) < 1000
    there = integrate(
        omega, [0, place, 1.5], frame=frame, tolerance=1e-13
    )  # a piece on either side
    assert (there[1].inv() * turns[0]).magnitude() <= 1e-13
