"""Euler angles in all 24 conventions, at and near gimbal lock."""

import itertools

import numpy as np
import pytest

from rotation import Rotation, RotationError
from rotation.euler import sequence
from tests.rotation import reference
from tests.subcases import subcases

THREE = [a + b + c for a, b, c in itertools.product("xyz", repeat=3) if a != b != c]
ALL = THREE + [s.upper() for s in THREE]
SHORT = [s for n in (1, 2) for s in map("".join, itertools.permutations("xyz", n))]


def ends(seq: str) -> tuple[float, float]:
    """The two ends of the second angle's interval, where the first and the third turn alike."""
    return (0.0, np.pi) if seq[0] == seq[2] else (-np.pi / 2, np.pi / 2)


def test_there_are_24() -> None:
    assert len(set(ALL)) == 24


@subcases("seq", ALL + SHORT + [s.upper() for s in SHORT])
def test_from_euler_is_the_product_of_the_axes_matrices(seq: str) -> None:
    angles = np.random.default_rng(1).uniform(-7, 7, (10, len(seq)))
    for found, row in zip(Rotation.from_euler(seq, angles).as_matrix(), angles, strict=True):
        assert reference.distance(found, reference.euler(seq, row)) < 1e-15


def test_zyx_of_the_thesis() -> None:
    """ZYX = R_z(a₀)·R_y(a₁)·R_x(a₂), section 2.2.4."""
    r = Rotation.from_euler("ZYX", [90, 0, 90], degrees=True)
    assert r.apply([0, 1, 0]) == pytest.approx([0, 0, 1])  # x first
    assert Rotation.from_euler("xyz", [90, 0, 90], degrees=True).approx_equal(r)


@pytest.mark.slow
@subcases("seq", ALL)
def test_angles_come_back(seq: str) -> None:
    rng = np.random.default_rng(2)
    low, high = ends(seq)
    angles = rng.uniform(-np.pi, np.pi, (2000, 3))
    angles[:, 1] = rng.uniform(low + 0.01, high - 0.01, 2000)
    back = Rotation.from_euler(seq, angles).as_euler(seq)
    assert np.abs(back - angles).max() < 1e-13
    assert Rotation.from_euler(seq, angles).as_euler(seq, degrees=True) == pytest.approx(
        np.rad2deg(back)
    )


@subcases("seq", ALL)
def test_gimbal_lock_on_both_sides(seq: str) -> None:
    rng = np.random.default_rng(3)
    for end in ends(seq):
        angles = rng.uniform(-np.pi, np.pi, (500, 3))
        angles[:, 1] = end
        r = Rotation.from_euler(seq, angles)
        for source in (r, Rotation.from_matrix(r.as_matrix()), Rotation.from_quat(-r.as_quat())):
            locked = source.as_euler(seq)
            assert np.all(locked[:, 2] == 0)
            assert np.abs(locked[:, 1] - end).max() < 4e-15
            again = Rotation.from_euler(seq, locked)
            assert np.abs(again.as_matrix() - r.as_matrix()).max() < 1e-14


@subcases("seq", ALL)
def test_near_gimbal_lock_nothing_is_lost(seq: str) -> None:
    rng = np.random.default_rng(4)
    for end in ends(seq):
        inwards = 1 if end == ends(seq)[0] else -1
        for size in 10.0 ** np.arange(-17, 0):
            angles = rng.uniform(-np.pi, np.pi, (50, 3))
            angles[:, 1] = end + inwards * size
            r = Rotation.from_euler(seq, angles)
            found = r.as_euler(seq)
            again = Rotation.from_euler(seq, found)
            assert np.abs(again.as_matrix() - r.as_matrix()).max() < 1e-14
            assert np.all(np.abs(found) <= np.pi)
            if size > 1e-13:
                assert np.abs(found[:, 1] - angles[:, 1]).max() < 1e-14
                turns = np.abs(found - angles)[:, ::2]
                assert np.minimum(turns, 2 * np.pi - turns).max() < 4e-15 / size


@subcases("seq", ALL)
def test_angles_describe_the_rotation_at_every_distance_from_gimbal_lock(seq: str) -> None:
    rng = np.random.default_rng(8)
    for end in ends(seq):
        angles = rng.uniform(-np.pi, np.pi, (40, 3))
        angles[:, 1] = end + 10.0 ** rng.uniform(-18, -1, 40) * rng.choice([-1, 1], 40)
        r = Rotation.from_euler(seq, angles)
        for q, found in zip(r.as_quat(), r.as_euler(seq), strict=True):
            off = reference.euler(seq, found).T * reference.matrix_of(reference.exact(q))
            turned = reference.length([off[i, j] - off[j, i] for i, j in ((0, 1), (0, 2), (1, 2))])
            assert turned / 2 <= (24 if found[2] == 0 else 8) * 2.0**-52


def test_small_angles_keep_their_digits() -> None:
    for size in (1e-300, 1e-20, 1e-8):
        angles = size * np.array([1.0, 2.0, -3.0])
        for seq in ("ZYX", "xyz", "YXZ"):
            assert Rotation.from_euler(seq, angles).as_euler(seq) == pytest.approx(
                angles, rel=1e-7, abs=0
            )
    middle = Rotation.from_euler("ZYX", [0.0, 1e-20, 0.0]).as_euler("ZYX")
    assert middle[1] == pytest.approx(1e-20, rel=1e-15)


def test_degrees_lose_nothing_at_any_size() -> None:
    turns = 360.0 * np.array([0, 1, -3, 1e6, 1e9, 2.0**40])
    r = Rotation.from_euler("z", turns + 60, degrees=True)
    assert np.abs(r.as_euler("ZYX", degrees=True)[:, 0] - 60).max() < 1e-13
    assert Rotation.from_euler("x", 1e-300, degrees=True).magnitude() == pytest.approx(
        1e-300 * np.pi / 180
    )


@pytest.mark.parametrize("size", [1e3, 1e6, 1e9, 1e15])
def test_large_angles(size: float) -> None:
    for angle in size * np.random.default_rng(5).uniform(-1, 1, 20):
        found = Rotation.from_euler("Z", angle).as_matrix()
        assert reference.distance(found, reference.about("z", reference.exact([angle])[0])) < 1e-15


def test_shapes() -> None:
    for seq, shape, batch in [
        ("x", (), ()),
        ("x", (5,), (5,)),
        ("x", (1,), (1,)),
        ("x", (5, 1), (5,)),
        ("xy", (2,), ()),
        ("XY", (4, 2), (4,)),
        ("xyz", (0, 3), (0,)),
        ("ZXZ", (2, 4, 3), (2, 4)),
    ]:
        r = Rotation.from_euler(seq, np.zeros(shape))
        assert r.shape == batch
        assert r.as_euler("zyx").shape == (*batch, 3)


@subcases("seq", ["", "w", "xyzx", "XyZ", "xx", "XXZ", "xyy", "x z", None, 3, ["x"], "ⅹ"])
def test_sequences_that_do_not_exist(seq: object) -> None:
    with pytest.raises(RotationError, match="sequence"):
        sequence(seq)  # type: ignore[arg-type]


def test_angles_that_do_not_fit() -> None:
    for seq, shape in [("xyz", (2,)), ("xyz", ()), ("xy", (3,)), ("x", (2, 3)), ("xyz", (3, 2))]:
        with pytest.raises(RotationError, match="shape"):
            Rotation.from_euler(seq, np.zeros(shape))
    with pytest.raises(RotationError, match="three letters"):
        Rotation.identity().as_euler("xy")
