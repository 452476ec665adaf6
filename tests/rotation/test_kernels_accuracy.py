"""Accuracy against fifty digits and more, at the edges of what floats can hold."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from rotation import fused, kernels
from rotation.fused import rotate, rotate_euler, rotate_quat
from tests.rotation.reference import exact, length, matrix_of, mp
from tests.subcases import subcases

ULP = 2.0**-52
RNG = np.random.default_rng(7)


@pytest.fixture(params=["formulas", "kernels"], autouse=True)
def way(request: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Have all points rotated by the formulas of few points, then by the kernels of many."""
    few = 10**9 if request.param == "formulas" else -1
    for name in ("FEW", "FEW_OWN", "FEW_SINES"):
        monkeypatch.setattr(fused, name, few)


def errors(points: Any, turned: Any, quaternions: Any) -> float:
    """Return the largest ‖error‖₂/‖v‖, with fifty digits."""
    worst = mp.mpf(0)
    for v, got, q in zip(points, turned, quaternions, strict=True):
        right = matrix_of(exact(q)) * mp.matrix(exact(v))
        error = length([a - b for a, b in zip(exact(got), right, strict=True)])
        worst = max(worst, error / length(exact(v)))
    return float(worst)


@pytest.mark.slow
@pytest.mark.parametrize("spread", [0.0, 6.0])
def test_quaternions_are_right_to_five_ulps_of_the_length(spread: float) -> None:
    n = 400
    unit = RNG.normal(size=(n, 4)) * 10.0 ** RNG.uniform(-spread, 0, (n, 4))
    unit /= np.linalg.norm(unit, axis=-1, keepdims=True)
    points = RNG.normal(size=(n, 3)) * 10.0 ** RNG.uniform(-spread, 0, (n, 3))
    for off in (1.0, 1 + 1e-6, 1 - 1e-6, 2.0, 1e-170, 1e160):
        q = unit * off
        assert errors(points, rotate_quat(points, q), q) <= 5 * ULP
        one = rotate_quat(points[:50], q[3])
        assert errors(points[:50], one, [q[3]] * 50) <= 5 * ULP
    points32, q32 = points.astype(np.float32), unit.astype(np.float32)
    assert errors(points32, rotate_quat(points32, q32), q32) <= 2.0**-24 * 1.01
    one32 = rotate_quat(points32[:50], q32[3])
    assert errors(points32[:50], one32, [q32[3]] * 50) <= 5 * 2.0**-23


@pytest.mark.parametrize("degrees", [False, True])
def test_axes_and_angles_are_right_to_five_ulps_of_the_length(degrees: bool) -> None:
    n = 400
    axes, points = RNG.normal(size=(2, n, 3)) * 10.0 ** RNG.uniform(-3, 0, (2, n, 3))
    angles = RNG.uniform(-400, 400, n) if degrees else RNG.uniform(-7, 7, n)
    turns = []
    for axis, angle in zip(axes, exact(angles), strict=True):
        half = angle / 2 * (mp.pi / 180 if degrees else 1)
        a = exact(axis)
        turns.append([mp.cos(half) * length(a), *(mp.sin(half) * x for x in a)])
    turned = rotate(points, axes, angles, degrees=degrees)
    for v, got, q in zip(points, turned, turns, strict=True):
        right = matrix_of(q) * mp.matrix(exact(v))
        error = length([a - b for a, b in zip(exact(got), right, strict=True)])
        assert error <= 3 * ULP * length(exact(v))


# Found by a search among some 10⁹, climbing: 3.41 and 2.43 units, by the kernels.
WORST = {
    "quaternion": (
        ("-0x1.03062553c1352p+0", "0x1.22ea6db78a721p-4", "-0x1.264ec57ddf45ap-3"),
        (
            "-0x1.6ca45c2c3237fp-4",
            "0x1.f4e21f22a8964p-5",
            "0x1.6b34ce263873bp+0",
            "0x1.25c57f77999a1p-2",
        ),
    ),
    "axis and angle": (
        ("0x1.0ac3e7fd57fe1p+1", "0x1.f2d4c6d6946b4p-5", "-0x1.b6c0b856fe17fp-5"),
        (
            "0x1.047455ef25155p+1",
            "0x1.3126f23e861bcp+0",
            "-0x1.3427a9eefa949p+1",
            "0x1.5aa9bf299c9bbp+1",
        ),
    ),
}


@pytest.mark.parametrize("name", WORST)
def test_the_worst_that_was_found(name: str) -> None:
    point, numbers = ([float.fromhex(x) for x in part] for part in WORST[name])
    points, rows = np.array([point] * 2), np.array([numbers] * 2)
    if name == "quaternion":
        turned, q = rotate_quat(points, rows), exact(numbers)
    else:
        turned = rotate(points, rows[:, :3], rows[:, 3])
        *axis, angle = exact(numbers)
        q = [mp.cos(angle / 2) * length(axis), *(mp.sin(angle / 2) * x for x in axis)]
    error = matrix_of(q) * mp.matrix(exact(point)) - mp.matrix(exact(turned[0]))
    assert length(error) <= 5 * ULP * length(exact(point))


def sines(angles: Any) -> tuple[Any, Any]:
    """Return x̂ rotated about z by axis and angle, and by an Euler angle: cosine and sine."""
    n = len(angles)
    axes = np.broadcast_to([0.0, 0.0, 1.0], (n, 3))
    by_axis = rotate(np.array([1.0, 0.0, 0.0]), axes, angles)
    by_euler = rotate_euler(np.array([1.0, 0.0, 0.0]), angles[:, None], "Z")
    return by_axis, by_euler


def test_sine_and_cosine_to_1e9_and_beyond() -> None:
    multiples = np.arange(-40, 41) * (np.pi / 2)
    quarters = np.round(RNG.uniform(0, 6e8, 300)) * (np.pi / 2)
    angles = np.concatenate(
        [
            RNG.uniform(-1e9, 1e9, 1500),
            10.0 ** RNG.uniform(-300, 9, 300),
            multiples,
            np.nextafter(multiples, 9e9),
            quarters,
            [1e9, -1e9, 2.0**30, np.nextafter(2.0**30, 2e9), 0.0, 5e-324],
        ]
    )
    beyond = 10.0 ** np.concatenate([RNG.uniform(9.1, 12, 512), RNG.uniform(9, 300, 40)])
    near, far = sines(angles), sines(beyond)  # by the fast way, and by the other
    by_axis, by_euler = (np.concatenate(pair) for pair in zip(near, far, strict=True))
    angles = np.concatenate([angles, beyond])
    with mp.workdps(400):
        right = np.array([(mp.cos(a), mp.sin(a)) for a in exact(angles)])
        worst_euler = float(np.max(np.abs(by_euler[:, :2] - right)))
        worst_axis = float(np.max(np.abs(by_axis[:, :2] - right)))
    assert worst_euler <= ULP
    assert worst_axis <= ULP


def test_far_angles_in_one_row_do_not_change_the_others() -> None:
    n = 707
    points, axes, angles = RNG.normal(size=(n, 3)), RNG.normal(size=(n, 3)), RNG.normal(size=n)
    before = rotate(points, axes, angles)
    angles[300], axes[20], axes[21] = 1e200, axes[20] * 2.0**1000, axes[21] * 2.0**-1060
    angles[-1], axes[-2] = -1e12, axes[-2] * 2.0**-500
    for layout in ("aos", "soa"):
        p, a = (points.copy(), axes) if layout == "aos" else (points.T.copy(), axes.T.copy())
        for out in (None, p):
            turned = rotate(p, a, angles, out=out, layout=layout)
            rows = turned if layout == "aos" else turned.T
            changed = np.flatnonzero((rows != before).any(axis=-1))
            assert set(changed) <= {300, 20, 21, n - 1, n - 2}  # the others to the last bit
            assert np.abs(rows[[20, n - 2]] - before[[20, n - 2]]).max() < 1e-14
            assert np.abs(rows[21] - before[21]).max() < 1e-3  # a subnormal axis has few digits


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_row_has_the_same_bits_wherever_it_stands(dtype: Any) -> None:
    n = 41
    points, axes = RNG.normal(size=(n, 3)).astype(dtype), RNG.normal(size=(n, 3)).astype(dtype)
    q, angles = RNG.normal(size=(n, 4)).astype(dtype), RNG.normal(size=(n, 3)).astype(dtype)
    axes[7] *= dtype(1e-30) if dtype == np.float32 else 1e-300
    angles[11] = 1e12
    ways: list[Callable[[Any, Any], Any]] = [
        lambda i, out: rotate(points[i], axes[i], angles[i, 0], out=out),
        lambda i, out: rotate_quat(points[i], q[i], out=out),
        lambda i, out: rotate_quat(points[i], [[1.0, 2.0, 3.0, 4.0]], out=out),
        lambda i, out: rotate_euler(points[i], angles[i], out=out),
    ]
    for way in ways:
        whole = way(np.arange(n), None)
        for _ in range(30):
            order = RNG.permutation(n)[: RNG.integers(2, n)]
            column_by_column = np.empty((3, len(order)), dtype).T
            for out in (None, column_by_column):
                np.testing.assert_array_equal(way(order, out), whole[order])


def test_the_sine_of_minus_zero_is_minus_zero() -> None:
    angles = np.array([-0.0, 0.0])
    turned = rotate_euler(np.array([1.0, -0.0, 0.0]), angles[:, None], "Z")
    np.testing.assert_array_equal(turned, [[1.0, 0.0, 0.0]] * 2)
    np.testing.assert_array_equal(np.signbit(turned[:, 1]), [True, False])


@subcases("size", [5e-324, 1e-310, 1e-300, 1e-160, 1.0, 1e160, 1e300, 1.7e308])
def test_axes_of_every_length(size: float) -> None:
    expected = rotate(np.array([1.0, 2.0, 3.0]), [0.0, 1.0, 0.0], 0.7)
    one = rotate(np.array([1.0, 2.0, 3.0]), [0.0, size, 0.0], 0.7)
    many = rotate(np.array([1.0, 2.0, 3.0]), [[0.0, size, 0.0]] * 2, 0.7)
    q = np.array([np.cos(0.35) * size, 0.0, np.sin(0.35) * size, 0.0])
    np.testing.assert_allclose(one, expected, rtol=0, atol=2e-15)
    np.testing.assert_allclose(many[1], expected, rtol=0, atol=2e-15)
    if size > 1e-310:
        np.testing.assert_allclose(rotate_quat([[1, 2, 3]] * 2, [q, q])[1], expected, atol=2e-14)
        np.testing.assert_allclose(rotate_quat([1, 2, 3], q), expected, atol=2e-14)


@subcases("size", [1e-280, 1e-200, 1e-100, 1e-10, 1e10, 1e100, 1e200, 1e307])
@subcases("many", [1e-150, 1e-30, 1.0, 1e30, 1e150])
def test_points_of_every_size_by_quaternions_of_every_length(size: float, many: float) -> None:
    points, q = RNG.normal(size=(20, 3)), RNG.normal(size=(20, 4))
    points *= size / np.abs(points).max()
    q *= many
    assert errors(points, rotate_quat(points, q), q) <= 5 * ULP
    axes, angles = q[:, 1:], RNG.uniform(-4, 4, 20)
    turned = rotate(points, axes, angles)
    half, unit = angles / 2, axes / np.linalg.norm(axes / many, axis=-1, keepdims=True) / many
    turns = np.concatenate([np.cos(half)[:, None], np.sin(half)[:, None] * unit], axis=-1)
    assert errors(points, turned, turns) <= 12 * ULP  # the quaternions are rounded here
    points[5] = 0.0
    np.testing.assert_array_equal(rotate(points, axes, angles)[5], 0.0)


def test_coordinates_near_the_largest_float() -> None:
    points = np.array([[1e308, 1e308, 1e308]] * 9)
    turned = rotate_quat(points, [[1.0, 1.0, 0.0, 0.0]] * 9)
    np.testing.assert_allclose(turned, points * [1.0, -1.0, 1.0], rtol=1e-15)
    turned = rotate(points, [[1.0, 0.0, 0.0]] * 9, np.full(9, np.pi / 2))
    np.testing.assert_allclose(turned, points * [1.0, -1.0, 1.0], rtol=1e-15)
    turned = rotate_euler(points, [[np.pi / 2, 0.0, 0.0]] * 9, "XYZ")
    np.testing.assert_allclose(turned, points * [1.0, -1.0, 1.0], rtol=1e-15)


def test_small_rotations_are_not_lost() -> None:
    turned = rotate(np.array([[1.0, 0.0, 0.0]] * 2), [[0.0, 0.0, 3.0]] * 2, 1e-200)
    np.testing.assert_allclose(turned[:, 1], 1e-200, rtol=1e-15)
    assert rotate_quat([1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1e-200])[1] == 2e-200
    assert rotate_quat([[1.0, 0.0, 0.0]], [[1.0, 0.0, 0.0, 1e-20]] * 2)[0, 1] == 2e-20


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_what_is_not_finite_spoils_its_row_and_no_other(bad: float) -> None:
    n = 600
    points, axes, q = RNG.normal(size=(n, 3)), RNG.normal(size=(n, 3)), RNG.normal(size=(n, 4))
    angles, euler = RNG.normal(size=n), RNG.normal(size=(n, 3))
    euler[:, 1] = 0.0  # exact zeros in the matrix must not hide anything
    for row, k in enumerate((0, 1, 2)):
        points[row, k] = bad
        axes[10 + row, k], q[10 + row, k], euler[10 + row, k] = bad, bad, bad
    angles[13], q[13, 3] = bad, bad
    results = {
        "one": (rotate_quat(points, [1.0, 0.0, 0.0, 0.0]), {0, 1, 2}),
        "one, soa": (rotate_quat(points.T.copy(), [0.0, 1.0, 0, 0], layout="soa").T, {0, 1, 2}),
        "one, float32": (rotate_quat(points.astype("f4"), [1.0, 1, 0, 0]), {0, 1, 2}),
        "axes": (rotate(points, axes, angles), {0, 1, 2, 10, 11, 12, 13}),
        "quaternions": (rotate_quat(points, q), {0, 1, 2, 10, 11, 12, 13}),
        "euler": (rotate_euler(points, euler), {0, 1, 2, 10, 11, 12}),
        "proper euler": (rotate_euler(points, euler, "xzx"), {0, 1, 2, 10, 11, 12}),
    }
    for name, (turned, rows) in results.items():
        spoilt = np.isnan(turned)
        assert set(np.flatnonzero(spoilt.all(axis=-1))) == rows, name
        assert np.isfinite(turned).sum() == 3 * (n - len(rows)), name
    for axis, angle in (([bad, 0.0, 1.0], 1.0), ([0.0, 0.0, 1.0], bad)):
        assert np.isnan(rotate(np.ones((2, 3)), axis, angle)).all()
    assert np.isnan(rotate_quat(np.ones((2, 3)), [bad, 0.0, 0.0, 1.0])).all()


def exact_product(q: Any) -> Any:
    """Return the product of the floats, newest on the left, with some sixty digits, normalised."""
    bits = 200
    product = [1 << bits, 0, 0, 0]
    for row in q.tolist():
        a, b, c, d = (int(v * 2.0**100) << (bits - 100) for v in row)
        w, x, y, z = product
        product = [
            (a * w - b * x - c * y - d * z) >> bits,
            (a * x + b * w + c * z - d * y) >> bits,
            (a * y - b * z + c * w + d * x) >> bits,
            (a * z + b * y - c * x + d * w) >> bits,
        ]
    size = mp.sqrt(mp.mpf(sum(c * c for c in product)))
    return np.array([float(mp.mpf(c) / size) for c in product])


def test_long_products_do_not_drift() -> None:
    n = 20_000
    q = RNG.normal(size=(n, 4))
    q /= np.linalg.norm(q, axis=-1, keepdims=True)
    for factors in (q, np.broadcast_to(q[0], (n, 4))):
        products = kernels.cumulative(factors)
        np.testing.assert_allclose(products[-1], exact_product(factors), rtol=0, atol=1e-15)
        assert np.abs(np.linalg.norm(products, axis=-1) - 1).max() <= 1e-15
