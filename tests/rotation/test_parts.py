"""Swing and twist, six numbers, conventions of programs, integration to a tolerance."""

import itertools

import numpy as np
import pytest

from rotation import (
    Rotation,
    RotationError,
    change_of_axes,
    convert_points,
    convert_rotation,
    integrate,
    swing_twist,
)
from rotation.conventions import AXES

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


@pytest.mark.parametrize(("source", "target"), [*itertools.permutations(AXES, 2)])
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
    for bad in (0.0, -1.0, np.nan):
        with pytest.raises(RotationError, match="tolerance"):
            integrate(omega, times, tolerance=bad)
    with pytest.raises(RotationError, match="function"):
        integrate([0, 0, 1], times, tolerance=1e-3)
    with pytest.raises(RotationError, match="not reached"):
        integrate(
            lambda t: [1e6 * np.sin(1e6 * t * t), 1e5 * np.cos(t), 0], [0.0, 1.0], tolerance=1e-15
        )
