"""Attitudes from angular velocities."""

from collections.abc import Callable

import numpy as np
import pytest

from hfield.core.product import multiply
from rotation import Rotation, RotationError, integrate
from rotation.quaternions import HAMILTON
from tests.subcases import subcases


def velocity(t: float) -> np.ndarray:
    return np.array([np.sin(2 * t), 1.5 * np.cos(t), 0.3 * t])


def reference(frame: str, end: float, steps: int = 4000) -> Rotation:
    """q̇ = ½·q·ω or ½·ω·q by Runge and Kutta's classical method, in very small steps."""

    def slope(t: float, q: np.ndarray) -> np.ndarray:
        w = (0.0, *velocity(t))
        c = tuple(q)
        return 0.5 * np.array(multiply(HAMILTON, *((c, w) if frame == "body" else (w, c))))

    q, h = np.array([1.0, 0, 0, 0]), end / steps
    for n in range(steps):
        t = n * h
        a = slope(t, q)
        b = slope(t + h / 2, q + h / 2 * a)
        c = slope(t + h / 2, q + h / 2 * b)
        q = q + h / 6 * (a + 2 * b + 2 * c + slope(t + h, q + h * c))
    return Rotation(q)


@pytest.mark.parametrize("frame", ["body", "world"])
@pytest.mark.parametrize("sampled", [False, True])
def test_the_error_is_of_fourth_order(frame: str, sampled: bool) -> None:
    wanted, errors = reference(frame, 3.0), []
    for steps in (40, 80, 160):
        t = np.linspace(0, 3, steps + 1)
        omega: object = np.array([velocity(x) for x in t]) if sampled else velocity
        errors.append(float((integrate(omega, t, frame=frame)[-1].inv() * wanted).magnitude()))
    assert errors[0] > 13 * errors[1] > 13 * 13 * errors[2]
    assert errors[2] < 3e-8


@pytest.mark.parametrize("frame", ["body", "world"])
def test_a_constant_velocity_is_exact(frame: str) -> None:
    omega, start = np.array([0.3, -2.0, 1.0]), Rotation.random(rng=1)
    t = np.array([0.0, 0.1, 5.0, 5.5, 100.0])
    turns = Rotation.from_rotvec(t[:, None] * omega)
    wanted = start * turns if frame == "body" else turns * start
    for given in (omega, np.tile(omega, (5, 1)), lambda _: omega):
        found = integrate(given, t, start, frame)
        assert found.shape == (5,)
        assert found[0] == start
        assert found.approx_equal(wanted, atol=1e-13).all()


def test_the_two_frames_agree() -> None:
    """The velocity in the world's axes is that in the body's, turned."""
    t = np.linspace(0, 2, 401)
    body = np.array([velocity(x) for x in t])
    attitudes = integrate(body, t)
    again = integrate(attitudes.apply(body), t, frame="world")
    assert again.approx_equal(attitudes, atol=1e-8).all()


def test_time_may_run_backwards_and_unevenly() -> None:
    t = np.sort(np.random.default_rng(2).uniform(0, 2, 200))
    there = integrate(velocity, t)
    back = integrate(velocity, t[::-1], there[-1])
    assert back[::-1].approx_equal(there, atol=1e-13).all()


def test_batches_and_short_samples() -> None:
    t = np.linspace(0, 1, 11)
    omega = np.random.default_rng(3).standard_normal((11, 4, 3))
    found = integrate(omega, t, Rotation.random(4, rng=4))
    assert found.shape == (11, 4)
    assert integrate(omega[:, 0], t, Rotation.random(4, rng=4)).shape == (11, 4)
    assert integrate(lambda _: np.ones((4, 3)), t).shape == (11, 4)
    for number in (1, 2, 3):  # a polynomial through fewer than four samples
        assert integrate(omega[:number], t[:number]).shape == (number, 4)
    linear = np.array([[0.0, 0, 0], [0, 0, 2.0]])
    assert integrate(linear, [0.0, 1.0])[-1].as_rotvec() == pytest.approx([0, 0, 1.0])


def test_norms_hold_over_many_steps() -> None:
    t = np.linspace(0, 1000, 100_001)
    w = np.stack([np.sin(t), np.cos(2 * t), np.ones_like(t)], axis=1)
    q = integrate(w, t).as_quat()
    assert np.abs(np.linalg.norm(q, axis=1) - 1).max() <= 1e-15


@subcases(
    "call",
    [
        lambda: integrate([0, 0, 1], [0.0, 1.0, 1.0]),
        lambda: integrate([0, 0, 1], [0.0, np.nan]),
        lambda: integrate([0, 0, 1], []),
        lambda: integrate([0, 0, 1], 3.0),
        lambda: integrate([0, 0, 1], [0.0, 1.0], frame="moon"),
        lambda: integrate([0, 1], [0.0, 1.0]),
        lambda: integrate(np.ones((3, 3)), [0.0, 1.0]),
        lambda: integrate(np.ones((2, 4)), [0.0, 1.0]),
        lambda: integrate(1.0, [0.0, 1.0]),
        lambda: integrate(lambda _: 1.0, [0.0, 1.0]),
    ],
)
def test_motions_that_are_none(call: Callable[[], object]) -> None:
    with pytest.raises(RotationError):
        call()
