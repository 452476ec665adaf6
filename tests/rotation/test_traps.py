"""What other libraries get wrong: each trap has a defined result here, or a clear ValueError."""

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import rotation
from rotation import Rotation, RotationError, ZeroRotationError, integrate, slerp
from tests.subcases import subcases

NAN, INF = np.nan, np.inf


def test_errors_are_of_hfield_and_of_python() -> None:
    from hfield.errors import HFieldError

    assert issubclass(RotationError, HFieldError)
    assert issubclass(RotationError, ValueError)


@pytest.mark.parametrize("zero", [[0, 0, 0, 0], [0.0, -0.0, 0.0, 0.0]])
def test_the_zero_quaternion_raises(zero: list[float]) -> None:
    with pytest.raises(ZeroRotationError, match="zero quaternion"):
        Rotation.from_quat(zero)
    with pytest.raises(ZeroRotationError, match="in row 1"):
        Rotation.from_quat([[1, 0, 0, 0], zero])
    with pytest.raises(ZeroRotationError, match=r"in row \(0, 1\)") as error:
        Rotation.from_quat([[[1, 0, 0, 0], zero]])
    assert error.value.row == (0, 1)
    with pytest.raises(ZeroRotationError):
        rotation.T_q(zero, [1, 0, 0])


def test_a_zero_axis_raises() -> None:
    with pytest.raises(ZeroRotationError, match="zero axis"):
        Rotation.from_axis_angle([0, 0, 0], 1.0)


def test_a_quaternion_of_length_2_does_not_scale() -> None:
    r = Rotation.from_quat([2.0, 0, 0, 0])
    assert r.apply([1, 2, 3]).tolist() == [1, 2, 3]
    assert np.linalg.norm(Rotation.from_quat([1, 1, 1, 1]).apply([1, 2, 3])) == pytest.approx(
        np.sqrt(14)
    )


def test_a_reflection_is_no_rotation() -> None:
    for m in (np.diag([1.0, 1, -1]), -np.eye(3)):
        with pytest.raises(RotationError, match="reflection"):
            Rotation.from_matrix(m)
        with pytest.raises(RotationError, match="reflection"):
            Rotation.from_matrix(m, orthonormalize=True)


def test_slerp_of_q_and_minus_q_stays() -> None:
    r = Rotation.random(100, rng=1)
    for t in (0.0, 0.3, 0.5, 1.0, 7.0):
        between = slerp(r, Rotation(-r.as_quat()), t)
        assert between.approx_equal(r, atol=1e-14).all()


def test_slerp_half_a_turn_apart_is_defined() -> None:
    p = Rotation.random(200, rng=2)
    axes = np.eye(3)[np.arange(200) % 3] * np.where(np.arange(200) % 2, 1, -1)[:, None]
    q = p * Rotation.from_axis_angle(axes, np.pi)
    middle = slerp(p, q, 0.5)
    assert (p.inv() * middle).magnitude() == pytest.approx(np.pi / 2, abs=1e-14)
    exact = Rotation([1.0, 0, 0, 0]), Rotation([0.0, 0, 0.6, 0.8])
    for sign in (1, -1):
        half = slerp(exact[0], Rotation(sign * exact[1].as_quat()), 0.5)
        assert half.as_rotvec() == pytest.approx(np.array([0, 0.6, 0.8]) * np.pi / 2)


def test_1e_8_is_not_nothing() -> None:
    r = Rotation.from_quat([1.0, 5e-9, 0, 0])
    assert r.magnitude() == pytest.approx(1e-8, rel=1e-15)
    assert r.as_rotvec()[0] == pytest.approx(1e-8, rel=1e-15)
    assert r.as_euler("XYZ")[0] == pytest.approx(1e-8, rel=1e-15)
    assert r.as_axis_angle()[1] == pytest.approx(1e-8, rel=1e-15)
    assert not r.approx_equal(Rotation.identity(), atol=9e-9)


def test_float32_points_stay_float32() -> None:
    assert Rotation.random(rng=3).apply(np.ones((5, 3), np.float32)).dtype == np.float32


def test_scalar_first_or_last_is_said() -> None:
    assert Rotation.from_quat([1, 0, 0, 0]).magnitude() == 0
    assert Rotation.from_quat([0, 0, 0, 1], scalar_first=False).magnitude() == 0
    with pytest.raises(TypeError):
        Rotation.from_quat([0, 0, 0, 1], False)  # type: ignore[misc]
    with pytest.raises(TypeError):
        Rotation.identity().as_quat(True)  # type: ignore[misc]


def test_elementwise_or_all_pairs_is_said() -> None:
    r, v = Rotation.random(4, rng=4), np.ones((4, 3))
    assert r.apply(v).shape == (4, 3)
    assert r.apply_outer(v).shape == (4, 4, 3)
    assert (r * r).shape == (4,)
    assert r.outer(r).shape == (4, 4)


def test_nothing_at_all_is_allowed() -> None:
    none = Rotation.from_quat(np.empty((0, 4)))
    assert len(none) == 0
    assert none.as_matrix().shape == (0, 3, 3)
    assert none.apply(np.empty((0, 3))).shape == (0, 3)
    assert (none * none).shape == none[::-1].shape == none.inv().shape == (0,)
    assert slerp(none, none, 0.5).shape == (0,)
    assert Rotation.from_matrix(np.empty((0, 3, 3))).shape == (0,)
    assert Rotation.from_matrix(np.empty((2, 0, 3, 3)), orthonormalize=True).shape == (2, 0)
    for fails in (none.mean, lambda: Rotation.align_vectors(np.empty((0, 3)), np.empty((0, 3)))):
        with pytest.raises(RotationError):
            fails()
    with pytest.raises(RotationError, match="shape"):
        Rotation.from_quat([])


def test_gimbal_lock_is_quiet_and_defined() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for end in (90, -90):
            a = Rotation.from_euler("ZYX", [30, end, 20], degrees=True).as_euler(
                "ZYX", degrees=True
            )
            assert a == pytest.approx([30 - 20 * np.sign(end), end, 0])


ROWS: list[tuple[Callable[[Any], Any], Any]] = [
    (Rotation.from_quat, [1.0, 2, 3, 4]),
    (Rotation.from_rotvec, [1.0, 2, 3]),
    (lambda x: Rotation.from_rotvec(x, degrees=True), [1.0, 2, 3]),
    (Rotation.from_mrp, [1.0, 2, 3]),
    (lambda x: Rotation.from_euler("ZYX", x), [1.0, 2, 3]),
    (lambda x: Rotation.from_euler("zxz", x, degrees=True), [1.0, 2, 3]),
    (lambda x: Rotation.from_euler("x", x), [1.0]),
    (lambda x: Rotation.from_axis_angle(x, 1.0), [1.0, 2, 3]),
    (lambda x: Rotation.from_axis_angle([0, 0, 1], x[..., 0]), [1.0]),
    (lambda x: Rotation.between(x, [1, 0, 0]), [1.0, 2, 3]),
    (lambda x: Rotation.between([1, 0, 0], x), [1.0, 2, 3]),
    (lambda x: Rotation.from_matrix(x.reshape(*x.shape[:-1], 3, 3)), list(np.eye(3).ravel())),
    (
        lambda x: Rotation.from_matrix(x.reshape(*x.shape[:-1], 3, 3), orthonormalize=True),
        list(2 * np.eye(3).ravel()),
    ),
]


@subcases(("make", "row"), ROWS)
@subcases("bad", [NAN, INF, -INF])
def test_nan_and_inf_spoil_their_own_row_only(
    make: Callable[[Any], Any], row: list[float], bad: float
) -> None:
    good = make(np.array([row])).as_quat()[0]
    for place in range(len(row)):
        x = np.tile(row, (3, 1))
        x[1, place] = bad
        r = make(x)
        assert np.isnan(r.as_quat()[1]).all()
        assert np.array_equal(r.as_quat()[[0, 2]], [good, good])
        assert np.isnan(make(x[1:2]).as_quat()).all()


def test_nan_goes_through_everything_quietly() -> None:
    r = Rotation.from_quat([[1.0, 2, 3, 4], [NAN, 0, 0, 1], [0, 0, INF, 0]])
    for x in (
        r.as_matrix(),
        r.as_rotvec(),
        r.as_rotvec(degrees=True),
        r.as_euler("ZYX"),
        r.as_euler("xyx"),
        r.as_mrp(),
        r.as_axis_angle()[0],
        r.as_axis_angle()[1],
        r.magnitude(),
        r.inv().as_quat(),
        (r * r[0]).as_quat(),
        (r**0.5).as_quat(),
        slerp(r, r[0], 0.5).as_quat(),
        r.apply([1.0, 2, 3]),
    ):
        flat = np.reshape(x, (3, -1))
        assert np.isfinite(flat[0]).all()
        assert np.isnan(flat[1:]).all()
    assert (r == r).tolist() == [True, False, False]
    assert np.isnan(r.mean().as_quat()).all()
    assert np.isnan((r[0] ** NAN).as_quat()).all()
    assert np.isnan(slerp(r[0], r[0] ** 2, NAN).as_quat()).all()
    v = r[0].apply([[1.0, NAN, 0], [1, 2, 3], [INF, 0, 0]])
    assert np.isnan(v[[0, 2]]).all()
    assert np.isfinite(v[1]).all()


@pytest.mark.parametrize("value", [1 + 2j, "abc", None, True, [1, 2, "x", 4], object()])
def test_values_that_are_no_numbers(value: object) -> None:
    for make in (Rotation.from_quat, Rotation.from_rotvec, Rotation.from_matrix):
        with pytest.raises((RotationError, TypeError)):
            make(value)


def test_ragged_lists_and_wrong_shapes() -> None:
    for make in (Rotation.from_quat, Rotation.from_rotvec, Rotation.from_mrp):
        for bad in ([[1, 2, 3], [1, 2]], [1.0, 2], 3.0, np.ones((4, 5))):
            with pytest.raises(RotationError):
                make(bad)


def test_a_constant_velocity_is_exact_even_where_it_is_tiny() -> None:
    r = integrate([0, 1e-200, 0], [0.0, 1e-100])
    assert r[1].as_rotvec().tolist() == [0, pytest.approx(1e-300), 0]
