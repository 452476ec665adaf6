"""What users do by mistake, or with values nobody thinks of: a clear answer, or a clear error."""

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from rotation import (
    DTypeError,
    R_x,
    RigidTransform,
    Rotation,
    RotationError,
    Slerp,
    align_points,
    integrate,
    rotate_euler,
    slerp,
    squad,
    threads,
)

R = Rotation.random(6, seed=1)
QUATERNIONS = R.as_quat()


@pytest.mark.parametrize(
    "call",
    [
        lambda: slerp(R, QUATERNIONS, 0.5),
        lambda: slerp(1, 2, 0.5),  # type: ignore[arg-type]
        lambda: squad(R, R, R, QUATERNIONS, 0.5),
        lambda: Slerp([0, 1], [R[0], R[1]]),  # type: ignore[arg-type]
        lambda: R.approx_equal(QUATERNIONS),
        lambda: R.outer(3),  # type: ignore[arg-type]
        lambda: integrate([0, 0, 1], [0, 1], QUATERNIONS[0]),
    ],
)
def test_what_is_no_rotation_is_named(call: Callable[[], Any]) -> None:
    with pytest.raises(DTypeError, match="expected a Rotation"):
        call()


def test_scipy_in_is_scipy_and_out_has_no_nan() -> None:
    """Our own as_quat would have been read scalar last."""
    scipy = pytest.importorskip("scipy.spatial.transform")
    with pytest.raises(DTypeError, match=r"scipy\.spatial"):
        Rotation.from_scipy(R)
    assert Rotation.from_scipy(scipy.Rotation.identity()) == Rotation.identity()
    with pytest.raises(RotationError, match="in row 1 is NaN"):
        Rotation([[1, 0, 0, 0], [np.nan] * 4]).to_scipy()


@pytest.mark.parametrize("options", [{"rng": 1, "seed": 2}, {"seed": -1}, {"seed": "one"}])
def test_seeds_that_are_none(options: dict[str, Any]) -> None:
    with pytest.raises(RotationError, match="seed"):
        Rotation.random(2, **options)


def test_shapes_and_axes_that_are_none() -> None:
    with pytest.raises(RotationError, match="negative length"):
        R.reshape(-2, -3)
    with pytest.raises(RotationError, match="axis 'a'"):
        R.mean(axis="a")
    assert R.reshape(2, 3).mean(axis=[0, 1]).approx_equal(R.mean(), 1e-14)
    with pytest.raises(RotationError, match="rectangular"):
        R.apply_outer([[1, 2], [1, 2, 3]])


def test_omega_of_changing_shape() -> None:
    with pytest.raises(RotationError, match="different shapes"):
        integrate(lambda t: np.ones((int(t) + 1, 3)), [0, 1, 2])


def test_a_single_rotation_takes_new_axes_and_no_index() -> None:
    assert R[0][None].shape == (1,)
    assert R[0][..., None].shape == (1,)
    assert R[0][...] == R[0]
    with pytest.raises(TypeError, match="single"):
        R[0][0]


def test_a_curve_keeps_its_times() -> None:
    times = np.array([0.0, 1.0])
    curve = Slerp(times, R[:2])
    times[1] = 5.0
    assert curve(1.0).approx_equal(R[1], 1e-14)
    with pytest.raises(RotationError, match="differences"):
        Slerp([-1e308, 1e308], R[:2])


@pytest.mark.parametrize("scale", [1e-300, 1e-160, 1e160, 1e300])
def test_sums_of_squares_of_any_size(scale: float) -> None:
    rng = np.random.default_rng(2)
    a, b = rng.standard_normal((2, 6, 3))
    rssd = Rotation.align_vectors(a, b)[1]
    found = Rotation.align_vectors(scale * a, scale * b)[1]
    assert found / scale == pytest.approx(rssd, rel=1e-13)


def test_weights_whose_sum_overflows() -> None:
    weights = np.full(6, 1e308)
    assert R.mean(weights).approx_equal(R.mean(), 1e-14)
    points = np.random.default_rng(3).standard_normal((6, 3))
    _, shift, _ = align_points(points, points + np.array([1, 2, 3]), weights)
    np.testing.assert_allclose(shift, [1, 2, 3], atol=1e-14)


def test_degrees_that_are_not_finite_warn_of_nothing() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        turned = rotate_euler(np.ones((2, 3)), [[np.inf, 0, 0], [90, 0, 0]], degrees=True)
    np.testing.assert_array_equal(np.isnan(turned).all(axis=-1), [True, False])


def test_a_matrix_of_no_angle_is_nan_throughout() -> None:
    assert np.isnan(R_x([np.nan, np.inf, 1.0])).all(axis=(1, 2)).tolist() == [True, True, False]


def test_infinitely_many_threads() -> None:
    with pytest.raises(RotationError, match="whole number"):
        threads(float("inf"))  # type: ignore[arg-type]


def test_points_beside_an_operator_are_told_what_to_write() -> None:
    r, v = Rotation.random(3, seed=1), np.ones((3, 3))
    t = RigidTransform.from_rotation(r)
    for call in (
        lambda: r * v,
        lambda: v * r,
        lambda: r * [1, 2, 3],
        lambda: r @ v,
        lambda: t * v,
        lambda: t @ v,
    ):
        with pytest.raises(DTypeError, match=r"write r\.apply\(points\)"):
            call()
    with pytest.raises(RotationError, match=r"points \(2,\), rotations \(3,\)"):
        r.apply(v[:2])
    with pytest.raises(RotationError, match=r"points has shape \(3, 4\); expected \(…, 3\)$"):
        r.apply(np.ones((3, 4)))
