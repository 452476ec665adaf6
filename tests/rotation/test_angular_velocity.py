"""The angular velocity of sampled attitudes."""

from typing import Any

import numpy as np
import pytest

from rotation import DTypeError, Rotation, RotationError, angular_velocity, integrate
from tests.subcases import slow, subcases

RNG = np.random.default_rng(12)


def omega(t: Any) -> Any:
    return np.array([np.sin(t), 0.5 * np.cos(2 * t), 1.0 + 0.2 * t])


@pytest.mark.parametrize("frame", ["body", slow("world")])
def test_the_error_is_of_fourth_order(frame: str) -> None:
    errors = []
    for n in (41, 81, 161):
        times = np.linspace(0, 4, n)
        path = integrate(omega, times, Rotation.random(seed=1), frame, tolerance=1e-13)
        found = angular_velocity(path, times, frame)
        errors.append(np.abs(found - np.array([omega(t) for t in times])).max())
    assert errors[0] < 3e-4
    assert 11 < errors[0] / errors[1] < 60
    assert 11 < errors[1] / errors[2] < 60


@subcases("n", [2, 3, 4, 5, 6, 30])
@subcases("backward", [False, True])
def test_it_is_exact_for_a_constant_velocity_at_any_times(n: int, backward: bool) -> None:
    times = np.cumsum(RNG.uniform(0.05, 0.5, n))[:: -1 if backward else 1].copy()
    w = np.array([0.3, -0.9, 0.4])
    starts = Rotation.random((4, 2), seed=2)
    path = integrate(w, times, starts)
    assert np.abs(angular_velocity(path, times) - w).max() < 1e-12
    world = angular_velocity(path, times, "world")
    np.testing.assert_allclose(world, np.broadcast_to(starts.apply(w), world.shape), atol=1e-12)


def test_signs_of_quaternions_do_not_matter() -> None:
    times = np.linspace(0, 1, 20)
    path = integrate(omega, times)
    flipped = Rotation.concatenate(
        [Rotation(s * r.as_quat()) for s, r in zip([1, -1] * 10, path, strict=True)]
    )
    np.testing.assert_allclose(
        angular_velocity(flipped, times), angular_velocity(path, times), atol=1e-13
    )


def test_what_is_refused() -> None:
    path = Rotation.random(4, seed=3)
    for rotations, times in (
        (path, [0, 1, 2]),
        (path, [0, 1, 1, 2]),
        (path, [0, 1, np.nan, 2]),
        (path[0], 0.0),
        (path[:1], [0.0]),
    ):
        with pytest.raises(RotationError):
            angular_velocity(rotations, times)
    with pytest.raises(RotationError, match="frame"):
        angular_velocity(path, [0, 1, 2, 3], "space")
    with pytest.raises(DTypeError):
        angular_velocity(path.as_quat(), [0, 1, 2, 3])
