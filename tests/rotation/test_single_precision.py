"""Rotations stored in single precision: half the memory, computed in double, rounded once."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import rotation
from rotation import DTypeError, ForeignArrayError, RigidTransform, Rotation, RotationSpline, Slerp
from rotation.native import builtins
from rotation.quaternions import normalised
from tests.subcases import subcases

SINGLE, U = np.dtype(np.float32), 2.0**-24
SEQUENCE = "ZYX"


@pytest.fixture(params=[(), (1,), (7,), (8, 3), (20_000,)], ids=str)
def pair(request: pytest.FixtureRequest) -> tuple[Rotation, Rotation]:
    """Rotations in float32, and the very same in float64: their coordinates made unit there."""
    single = Rotation.random(request.param, seed=5, dtype=np.float32)
    return single, Rotation(single.as_quat().astype(np.float64))


READ: dict[str, Callable[[Rotation], Any]] = {
    "matrix": Rotation.as_matrix,
    "6d": Rotation.as_6d,
    "rotvec": Rotation.as_rotvec,
    "mrp": Rotation.as_mrp,
    "magnitude": Rotation.magnitude,
    "axis": lambda r: r.as_axis_angle()[0],
    "angle": lambda r: r.as_axis_angle()[1],
    "canonical": lambda r: r.as_quat(canonical=True, scalar_first=False),
    "inverse": lambda r: r.inv().as_quat(),
    "square": lambda r: (r * r).as_quat(),
    "power": lambda r: (r**0.3).as_quat(),
    "powers": lambda r: (r ** np.linspace(0.1, 3.0, r.shape[-1] if r.ndim else 2)[:1]).as_quat(),
    "euler": lambda r: r.as_euler(SEQUENCE),
    "davenport": lambda r: r.as_davenport(np.eye(3)[::-1], "i"),
    "reduce": lambda r: r.reduce(Rotation.create_group("O")).as_quat(canonical=True),
    "outer": lambda r: r.reshape(-1)[:3].outer(r.reshape(-1)[:2]).as_quat(),
}


@subcases("name", READ)
def test_what_is_read_is_right_to_one_rounding(name: str, pair: tuple[Rotation, Rotation]) -> None:
    single, double = map(READ[name], pair)
    assert single.dtype == SINGLE
    # ½ ulp; unit quaternions are off by what storing took from their norm, another 2⁻²⁴ of each coordinate.
    near = 1.0001 * U * np.maximum(1.0, np.abs(double)) * 2.0
    if name in ("euler", "davenport"):  # near the lock angles move far: the rotation counts
        wrong = Rotation.from_euler(SEQUENCE, single.astype(float)).inv() * pair[1]
        assert wrong.magnitude().max() <= 8.0 * U
    else:
        assert (np.abs(single - double) <= near).all()


def test_entries_of_matrices_are_rounded_once() -> None:
    single = Rotation.random(5000, seed=2).astype(np.float32)
    exact = normalised(single.as_quat())
    off = single.as_matrix() - Rotation(exact).as_matrix()
    assert np.abs(off).max() <= 0.5001 * 2.0 * U  # half the distance of floats below 1
    m = single.as_matrix().astype(np.float64)
    assert np.abs(m @ m.swapaxes(-1, -2) - np.eye(3)).max() < 3.0 * U


MADE: dict[str, Callable[..., Rotation]] = {
    "quat": lambda **k: Rotation([1, 2, 3, 4], **k),
    "from_quat": lambda **k: Rotation.from_quat([[1, 2, 3, 4]], scalar_first=False, **k),
    "matrix": lambda **k: Rotation.from_matrix(np.eye(3)[[1, 2, 0]], **k),
    "euler": lambda **k: Rotation.from_euler(SEQUENCE, [[0.1, 0.2, 0.3]] * 9, **k),
    "davenport": lambda **k: Rotation.from_davenport(np.eye(3), "e", [0.1, 0.2, 0.3], **k),
    "rotvec": lambda **k: Rotation.from_rotvec([0.1, 0.2, 0.3], **k),
    "axis": lambda **k: Rotation.from_axis_angle([1, 2, 3], 0.4, **k),
    "mrp": lambda **k: Rotation.from_mrp([0.1, 0.2, 0.3], **k),
    "6d": lambda **k: Rotation.from_6d([1, 2, 3, 4, 5, 7], **k),
    "identity": lambda **k: Rotation.identity((2, 3), **k),
    "random": lambda **k: Rotation.random(4, seed=1, **k),
}


@subcases("name", MADE)
def test_all_are_made_in_the_precision_asked_for(name: str) -> None:
    double = MADE[name]()
    for dtype in (np.float32, "f4", SINGLE):
        single = MADE[name](dtype=dtype)
        assert single.dtype == SINGLE
        assert (single.as_quat() == double.as_quat().astype(np.float32)).all()
    assert double.dtype == MADE[name](dtype=float).dtype == np.float64
    with pytest.raises(DTypeError, match="float32 or"):
        MADE[name](dtype=np.float16)
    with pytest.raises(DTypeError, match="float32 or"):
        MADE[name](dtype="quick")


def test_precision_is_kept_and_the_finer_decides() -> None:
    single, double = Rotation.random(6, seed=0, dtype="f4"), Rotation.random(6, seed=3)
    assert {r.dtype for r in (single * single, single[2], single.reshape(2, 3), single**2)} == {
        SINGLE
    }
    assert (single * double).dtype == (double * single).dtype == np.float64
    near = single.inv() * (single * double)
    assert (near.inv() * double).magnitude().max() < 4.0 * U
    assert Rotation.concatenate([single, single[0]]).dtype == SINGLE
    assert Rotation.concatenate([single, double]).dtype == np.float64
    assert (single.astype(float).astype("f4") == single).all()
    for kept in (
        single.mean(),
        single.median(),
        single.cumprod(),
        single.disorientation(single, "T"),
    ):
        assert kept.dtype == SINGLE
    assert single.disorientation(double, "T").dtype == np.float64
    assert hash(single[0]) == hash(single[0].astype(float))
    assert eval(repr(single), {"Rotation": Rotation, "array": np.array}).dtype == SINGLE


def test_long_chains_and_means_are_computed_in_double() -> None:
    single = Rotation.random(3000, seed=4, dtype="f4")
    double = Rotation(single.as_quat().astype(float))
    for frame in ("world", "body"):
        off = single.cumprod(frame).as_quat() - double.cumprod(frame).as_quat()
        assert np.abs(off).max() <= U
    w = np.linspace(1.0, 9.0, 3000)
    for axis in (None, 0):
        off = single.mean(w, axis).as_quat() - double.mean(w, axis).as_quat()
        assert np.abs(off).max() <= 2.0 * U


@pytest.mark.parametrize("number", [1, 5, 30_000])
def test_points_decide_their_own_precision(number: int) -> None:
    single = Rotation.random(number, seed=9, dtype="f4")
    double = Rotation(single.as_quat().astype(float))
    v = np.random.default_rng(0).normal(size=(number, 3))
    for r, s in ((single, double), (single[0], double[0])):
        for inverse in (False, True):
            image = r.apply(v, inverse)
            assert image.dtype == np.float64
            assert np.abs(image - s.apply(v, inverse)).max() < 1e-14
            assert r.apply(v.astype("f4"), inverse).dtype == SINGLE
    assert np.abs(rotation.rotate_quat(v, single) - double.apply(v)).max() < 1e-14
    assert single[:2].apply_outer(v).shape == (min(number, 2), number, 3)


def test_the_third_angle_is_zero_in_the_gimbal_lock_of_single_precision() -> None:
    r = Rotation.from_euler(SEQUENCE, [[0.4, np.pi / 2, 0.3], [0.4, -np.pi / 2, 0.3]], dtype="f4")
    if builtins.available():
        assert (r.as_euler(SEQUENCE)[:, 2] == 0.0).all()
    wrong = Rotation.from_euler(SEQUENCE, r.as_euler(SEQUENCE)).inv() * r
    assert wrong.magnitude().max() < 8.0 * U


def test_motions_and_curves_of_them_are_in_double() -> None:
    keys = Rotation.random(5, seed=2, dtype="f4")
    exact = Rotation(keys.as_quat().astype(float))
    t = RigidTransform.from_components([1, 2, 3], keys)
    assert t.rotation.dtype == RigidTransform.from_rotation(keys).as_matrix().dtype == np.float64
    times, at = np.arange(5.0), np.linspace(0, 4, 9)
    for curve in (RotationSpline, Slerp, rotation.Squad):
        off = curve(times, keys)(at).inv() * curve(times, exact)(at)
        assert off.magnitude().max() < 8.0 * U
    swing, twist = rotation.swing_twist(keys, [0, 0, 1])
    assert ((swing * twist).inv() * keys).magnitude().max() < 8.0 * U
    assert np.abs(keys.to_scipy().as_matrix() - keys.as_matrix()).max() < 4.0 * U
    assert (rotation.convert_rotation(keys, "ros", "unity").inv().magnitude() > 0).all()
    near = exact[0] * Rotation.from_rotvec(0.01 * np.eye(3))
    spread, same = (
        rotation.Uncertain.from_samples(r).covariance for r in (near.astype("f4"), near)
    )
    assert np.abs(spread - same).max() < 1e-8


def test_other_libraries_keep_the_precision_they_have() -> None:
    xp = pytest.importorskip("array_api_strict")
    r = Rotation(xp.asarray([1.0, 2.0, 3.0, 4.0]))
    assert r.dtype == xp.float64
    with pytest.raises(ForeignArrayError, match="convert them before"):
        r.astype(np.float32)
