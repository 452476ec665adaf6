"""Finite groups, the nearest of equivalent rotations, and Davenport angles."""

import itertools

import numpy as np
import pytest

from rotation import Rotation, RotationError
from tests.subcases import subcases

RNG = np.random.default_rng(12)
GROUPS = {"I": 60, "O": 24, "T": 12, "C1": 1, "C7": 7, "D1": 2, "D2": 4, "D6": 12}


@subcases(("name", "order"), GROUPS.items())
@subcases("axis", ["X", "y", "Z"])
def test_groups_are_groups(name: str, order: int, axis: str) -> None:
    g = Rotation.create_group(name, axis)
    assert g.shape == (order,)
    assert g[0] == Rotation.identity()
    products = g.outer(g).as_quat().reshape(-1, 4)
    near = np.abs(products @ g.as_quat().T)
    np.testing.assert_allclose(near.max(axis=1), 1.0, atol=1e-14)
    assert (np.sum(near > 1 - 1e-9, axis=1) == 1).all()


@subcases(("name", "axis"), [*itertools.product(GROUPS, "XYZ")])
def test_groups_are_scipys(name: str, axis: str) -> None:
    S = pytest.importorskip("scipy.spatial.transform").Rotation
    ours = Rotation.create_group(name, axis).as_quat()
    theirs = S.create_group(name, axis).as_quat(scalar_first=True)
    np.testing.assert_allclose(np.abs(ours @ theirs.T).max(axis=1), 1.0, atol=1e-14)


def test_reduce_finds_the_least_angle_of_all() -> None:
    left, r = Rotation.create_group("O"), Rotation.create_group("D3", "X")
    p = Rotation.random((7, 3), seed=1)
    found, m, n = p.reduce(left, r, return_indices=True)
    every = left.outer(p.reshape(21)).outer(r).magnitude()
    np.testing.assert_allclose(found.magnitude().ravel(), every.min(axis=(0, 2)), atol=1e-14)
    assert (left[m] * p * r[n]).approx_equal(found, atol=1e-14).all()
    assert p.reduce().approx_equal(p, atol=1e-15).all()
    assert p[0, 0].reduce(left).shape == ()
    for bad in (lambda: p.reduce(left[0]), lambda: p.reduce(right=left.reshape(2, 12))):
        with pytest.raises(RotationError):
            bad()


@pytest.mark.parametrize(
    ("group", "axis"), [("A", "Z"), ("C0", "Z"), ("C", "Z"), ("D-1", "Z"), ("O", "W"), (3, "Z")]
)
def test_groups_that_are_none(group: str, axis: str) -> None:
    with pytest.raises(RotationError):
        Rotation.create_group(group, axis)


@subcases("order", ["intrinsic", "e"])
@subcases("lean", [-2.5, -np.pi / 2, -0.4, 0.0, 0.4, np.pi / 2, 2.5, np.pi])
def test_davenport_angles_come_back(order: str, lean: float) -> None:
    frame = Rotation.random(seed=3)
    axes = frame.apply([[1, 0, 0], [0, 1, 0], [np.cos(lean), 0, -np.sin(lean)]]) * [[2], [1], [5]]
    r = Rotation.random(200, seed=4)
    angles = r.as_davenport(axes, order)
    assert Rotation.from_davenport(axes, order, angles).approx_equal(r, atol=1e-13).all()
    assert np.ptp(angles[:, 1]) <= np.pi + 1e-12
    S = pytest.importorskip("scipy.spatial.transform").Rotation
    unit = axes / np.linalg.norm(axes, axis=1, keepdims=True)
    theirs = S.from_davenport(unit, order, angles)
    assert Rotation.from_scipy(theirs).approx_equal(r, atol=1e-13).all()
    locked = Rotation.from_davenport(axes, order, [0.3, angles[:, 1].min() * 0 + lean, 0.5])
    again = locked.as_davenport(axes, order)
    assert Rotation.from_davenport(axes, order, again).approx_equal(locked, atol=1e-13)


@pytest.mark.slow
def test_davenport_angles_about_coordinate_axes_are_eulers() -> None:
    e = {c: np.eye(3)["xyz".index(c)] for c in "xyz"}
    r = Rotation.random(50, seed=5)
    for seq in ("xyz", "zyx", "zxz", "yxz", "xyx"):
        axes = [e[c] for c in seq]
        for order, name in (("extrinsic", seq), ("intrinsic", seq.upper())):
            np.testing.assert_allclose(
                r.as_davenport(axes, order, degrees=True), r.as_euler(name, degrees=True), atol=1e-9
            )
    assert Rotation.from_davenport(e["z"], "i", [0.1, 0.2, 0.3]).shape == (3,)
    assert Rotation.from_davenport([e["z"], e["x"]], "e", [10, 20], degrees=True).approx_equal(
        Rotation.from_euler("zx", [10, 20], degrees=True)
    )


@pytest.mark.parametrize("order", ["intrinsic", "e"])
def test_every_rotation_may_have_its_own_davenport_axes(order: str) -> None:
    frames, r = Rotation.random((4, 1), seed=6), Rotation.random((4, 5), seed=7)
    axes = frames[..., None].apply([[2, 0, 0], [0, 1, 0], [0.6, 0, -0.8]])
    angles = r.as_davenport(axes, order, degrees=True)
    assert (axes.shape, angles.shape) == ((4, 1, 3, 3), (4, 5, 3))
    for row in range(4):
        one = r[row].as_davenport(axes[row, 0], order, degrees=True)
        np.testing.assert_array_equal(angles[row], one)
    again = Rotation.from_davenport(axes, order, angles, degrees=True)
    assert again.approx_equal(r, atol=1e-14).all()
    pairs = Rotation.from_davenport(axes[..., :2, :], order, [0.1, 0.2])
    assert pairs.shape == (4, 1)
    assert pairs[3, 0].approx_equal(Rotation.from_davenport(axes[3, 0, :2], order, [0.1, 0.2]))
    with pytest.raises(RotationError, match="row 2"):
        Rotation.from_davenport(
            np.where(np.arange(4)[:, None, None] == 2, 1.0, axes[:, 0]), order, [0, 0, 0]
        )
    with pytest.raises(RotationError, match="broadcast"):
        Rotation.random(3, seed=1).as_davenport(axes[:, 0], order)


def test_davenport_axes_that_do_not_fit() -> None:
    x, y = np.eye(3)[:2]
    for axes, order in (
        ([x, x], "e"),
        ([x, x + y], "i"),
        ([x, 0 * y], "e"),
        ([x, y], "both"),
        (np.eye(4)[:, :3], "e"),
        ([[1.0, 2.0]], "e"),
    ):
        with pytest.raises(RotationError):
            Rotation.from_davenport(axes, order, [1.0, 2.0])
    with pytest.raises(RotationError):
        Rotation.identity().as_davenport([x, y], "e")
