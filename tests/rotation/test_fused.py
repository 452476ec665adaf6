"""The fused calls against scipy and against each other."""

from functools import partial
from itertools import permutations
from typing import Any

import numpy as np
import pytest

from rotation import kernels
from rotation.errors import RotationError, ZeroRotationError
from rotation.fused import rotate, rotate_euler, rotate_quat
from tests.subcases import share_quick
from tests.thorough import pairwise

RNG = np.random.default_rng(3)
N = 2000
POINTS, AXES, QUATS = RNG.normal(size=(N, 3)), RNG.normal(size=(N, 3)), RNG.normal(size=(N, 4))
ANGLES, EULER = RNG.uniform(-9, 9, N), RNG.uniform(-9, 9, (N, 3))
SEQUENCES = [a + b + c for a in "XYZ" for b in "XYZ" for c in "XYZ" if a != b and b != c]
SEQUENCES += [s.lower() for s in SEQUENCES]
SHORT = ["X", "z", *("".join(p) for p in permutations("XYZ", 2)), "zy"]


def test_there_are_24_sequences() -> None:
    assert len(set(SEQUENCES)) == 24


@pytest.mark.parametrize(
    ("seq", "layout"), share_quick(pairwise(SEQUENCES + SHORT, ("aos", "soa")), 5)
)
def test_euler_angles_are_scipys(seq: str, layout: Any) -> None:
    transform = pytest.importorskip("scipy.spatial.transform")
    angles = EULER[:, : len(seq)]
    expected = transform.Rotation.from_euler(seq, angles).apply(POINTS)
    if layout == "aos":
        turned = rotate_euler(POINTS, angles, seq)
        in_degrees = rotate_euler(POINTS, np.degrees(angles), seq, degrees=True)
    else:
        p, a = POINTS.T.copy(), angles.T.copy()
        turned = rotate_euler(p, a, seq, layout="soa").T
        in_degrees = rotate_euler(p, np.degrees(a), seq, layout="soa", degrees=True).T
    np.testing.assert_allclose(turned, expected, rtol=0, atol=1e-14)
    np.testing.assert_allclose(in_degrees, expected, rtol=0, atol=2e-14)


def test_axes_and_quaternions_are_scipys() -> None:
    transform = pytest.importorskip("scipy.spatial.transform")
    unit = AXES / np.linalg.norm(AXES, axis=-1, keepdims=True)
    expected = transform.Rotation.from_rotvec(unit * ANGLES[:, None]).apply(POINTS)
    np.testing.assert_allclose(rotate(POINTS, AXES, ANGLES), expected, rtol=0, atol=2e-14)
    expected = transform.Rotation.from_quat(QUATS[:, [1, 2, 3, 0]]).apply(POINTS)
    np.testing.assert_allclose(rotate_quat(POINTS, QUATS), expected, rtol=0, atol=1e-14)


def test_one_rotation_is_the_same_as_many_equal_ones() -> None:
    one, many = rotate_quat(POINTS, QUATS[0]), rotate_quat(POINTS, QUATS[[0] * N])
    np.testing.assert_allclose(one, many, rtol=0, atol=4e-15)
    one, many = rotate(POINTS, AXES[0], ANGLES[0]), rotate(POINTS, AXES[[0] * N], ANGLES[0])
    np.testing.assert_allclose(one, many, rtol=0, atol=6e-15)


def test_quarter_turns_go_counterclockwise() -> None:
    x, y, z = np.eye(3)
    for axis, v, w in ((x, y, z), (y, z, x), (z, x, y)):
        np.testing.assert_allclose(rotate(v, axis, np.pi / 2), w, atol=4e-16)
        np.testing.assert_allclose(rotate_quat(v, [1.0, *axis]), w, atol=4e-16)
    np.testing.assert_allclose(rotate_euler(x, [90, 0, 90], degrees=True), y, atol=4e-16)
    np.testing.assert_allclose(rotate_euler(z, [90, 0, 90], degrees=True), x, atol=4e-16)


@pytest.mark.parametrize("kinds", [("f4", "f4"), ("f4", "f8"), ("f8", "f4")])
def test_float32_points_are_computed_in_float64(kinds: tuple[str, str]) -> None:
    p, (a, t, q, e) = (
        POINTS.astype(kinds[0]),
        (x.astype(kinds[1]) for x in (AXES, ANGLES, QUATS, EULER)),
    )
    wide = [x.astype("f8") for x in (p, a, t, q, e)]
    for got, expected in (
        (rotate(p, a, t), rotate(wide[0], wide[1], wide[2])),
        (rotate_quat(p, q), rotate_quat(wide[0], wide[3])),
        (rotate_euler(p, e), rotate_euler(wide[0], wide[4])),
    ):
        assert got.dtype == p.dtype
        np.testing.assert_array_equal(got, expected.astype(kinds[0]))


def test_the_result_is_new_unless_out_is_given() -> None:
    points = POINTS.copy()
    turned = rotate_quat(points, QUATS[0])
    assert turned.flags.owndata
    np.testing.assert_array_equal(points, POINTS)
    out = np.empty_like(points)
    assert rotate(points, AXES, ANGLES, out=out) is out
    assert rotate(points, AXES, ANGLES, out=points) is points
    np.testing.assert_array_equal(points, out)


def test_points_rotated_in_place_are_left_alone_by_a_zero_row() -> None:
    for call, many in ((rotate_quat, QUATS.copy()), (partial(rotate, angle=ANGLES), AXES.copy())):
        many[-1] = 0.0
        points = POINTS.copy()
        with pytest.raises(ZeroRotationError, match=f"row {len(many) - 1}"):
            call(points, many, out=points)
        np.testing.assert_array_equal(points, POINTS)


def test_threads_change_nothing_but_the_time() -> None:
    many = np.tile(POINTS, (150, 1))
    before = kernels.threads()
    try:
        results = []
        for number in (1, 2, 5):
            assert kernels.threads(number) == number
            assert kernels.threads() == number
            results.append((rotate_quat(many, QUATS[0]), rotate(many, AXES[0] * many, 1.0)))
        for one, own in results[1:]:
            np.testing.assert_array_equal(one, results[0][0])
            np.testing.assert_array_equal(own, results[0][1])
        for wrong in (0, -1, 1.5):
            with pytest.raises(RotationError, match="whole number of at least 1"):
                kernels.threads(wrong)  # type: ignore[arg-type]
    finally:
        kernels.threads(before)


@pytest.mark.parametrize("points", [np.float32, np.float64])
def test_degrees_in_float32_are_converted_in_float64(points: Any) -> None:
    angles = RNG.uniform(-1e4, 1e4, (50, 3)).astype(np.float32)
    turned = rotate_euler(np.ones((50, 3), points), angles, degrees=True)
    expected = rotate_euler(np.ones((50, 3)), angles.astype(np.float64), degrees=True)
    np.testing.assert_array_equal(turned, expected.astype(points))
