"""Cumulative B-splines of rotations and rigid motions: derivatives by differences, joins, and laws."""

import numpy as np
import pytest

from rotation import BSpline, DTypeError, RigidTransform, Rotation, RotationError

RNG = np.random.default_rng(5)
CONTROL = [
    Rotation.exp(RNG.standard_normal((7, 3))),
    RigidTransform.exp(RNG.standard_normal((7, 6))),
]
TIMES = np.array([1.01, 1.2, 1.49, 1.7, 2.2, 2.99])
H = 1e-5


@pytest.mark.parametrize("control", CONTROL)
def test_velocity_and_acceleration_by_differences(control: Rotation) -> None:
    s = BSpline(control, start=1.0, step=0.5)
    velocity = s(TIMES + H).minus(s(TIMES - H)) / (2 * H)
    np.testing.assert_allclose(s(TIMES, 1), velocity, atol=1e-7)
    bend = (s(TIMES + H, 1) - s(TIMES - H, 1)) / (2 * H)
    np.testing.assert_allclose(s(TIMES, 2), bend, atol=1e-6)


@pytest.mark.parametrize("control", CONTROL)
def test_two_derivatives_are_continuous(control: Rotation) -> None:
    s, joins = BSpline(control, 1.0, 0.5), np.array([1.5, 2.0, 2.5])
    for order in (1, 2):
        gap = s(joins - 1e-10, order) - s(joins, order)
        assert np.abs(gap).max() < 1e-7
    assert s.end == 3.0
    assert s(s.end).approx_equal(s(s.end - 1e-12), 1e-10)


@pytest.mark.parametrize("control", CONTROL)
def test_moved_control_points_move_the_curve(control: Rotation) -> None:
    move = control[3]
    s, moved = BSpline(control), BSpline(move * control)
    t = np.linspace(0, 4, 9)
    assert (move * s(t)).approx_equal(moved(t), 1e-13).all()
    np.testing.assert_allclose(s(t, 2), moved(t, 2), atol=1e-12)  # as the body feels it


def test_about_one_axis_it_is_the_usual_spline() -> None:
    interpolate = pytest.importorskip("scipy.interpolate")
    angles = np.array([0.0, 0.3, 1.0, 0.2, -0.5, 0.1])
    s = BSpline(Rotation.from_euler("Z", angles), start=2.0, step=0.25)
    usual = interpolate.BSpline(2.0 + 0.25 * (np.arange(10) - 3), angles, 3)
    t = np.linspace(2.0, 2.75, 11)
    np.testing.assert_allclose(s(t).as_rotvec()[:, 2], usual(t), atol=1e-14)
    for order in (1, 2):
        np.testing.assert_allclose(s(t, order)[:, 2], usual.derivative(order)(t), atol=1e-12)


def test_what_makes_no_curve() -> None:
    with pytest.raises(RotationError, match="four"):
        BSpline(Rotation.identity(3))
    with pytest.raises(RotationError, match="step"):
        BSpline(Rotation.identity(4), step=0.0)
    with pytest.raises(DTypeError, match="control"):
        BSpline(np.eye(4))  # type: ignore[arg-type]
    s = BSpline(Rotation.identity(4))
    with pytest.raises(RotationError, match="from 0 to 1"):
        s(1.5)
    with pytest.raises(RotationError, match="order"):
        s(0.5, order=3)
    assert np.isnan(s([0.5, np.nan]).as_quat()).all(axis=1).tolist() == [False, True]
