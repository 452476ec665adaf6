"""Degrees: quarter turns are exact, and all others as near as those in radians, against fifty digits."""

from collections.abc import Callable
from itertools import product
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from rotation import R_x, R_y, R_z, RigidTransform, Rotation, rotate, rotate_euler
from rotation.euler import SEQUENCES
from rotation.kernels import numpy_kernels
from rotation.plane import R2, reflection, rotate2
from tests.rotation.reference import mp
from tests.subcases import slow, subcases

QUARTERS = [0.0, 90.0, 180.0, 270.0, 360.0, 450.0, -90.0, -180.0, 720.0, 9e15, -90.0 * 2.0**60]
E = np.eye(3)
# The turns about z by degrees (n,), as matrices (n, 3, 3).
MATRICES: dict[str, Callable[[Any], Any]] = {
    "R_z": lambda a: R_z(a, degrees=True),
    "from_euler": lambda a: Rotation.from_euler("Z", a, degrees=True).as_matrix(),
    "from_axis_angle": lambda a: Rotation.from_axis_angle([0, 0, 3], a, degrees=True).as_matrix(),
    "from_rotvec": lambda a: Rotation.from_rotvec(np.outer(a, E[2]), degrees=True).as_matrix(),
    "from_davenport": lambda a: (
        Rotation.from_davenport(E[2], "e", a, degrees=True).as_matrix().reshape(-1, 3, 3)
    ),
    "from_screw": lambda a: RigidTransform.from_screw(
        E[2], 0 * E[2], a, 0.0, degrees=True
    ).as_matrix()[..., :3, :3],
    "rotate": lambda a: np.stack([rotate(e, E[2], a, degrees=True) for e in E], axis=-1),
    "rotate, one by one": lambda a: np.stack(
        [rotate(np.tile(E, (300, 1)), E[2], x, degrees=True)[:3].T for x in a]
    ),
    "rotate_euler": lambda a: np.stack(
        [rotate_euler(e, a[:, None], "Z", degrees=True) for e in E], axis=-1
    ),
    "the plain twin": lambda a: np.stack(
        [numpy_kernels.axis_angle(e, E[2:], a, degrees=True) for e in E], axis=-1
    ),
}


@subcases("name", MATRICES)
@subcases("times", [1, 100])  # by formulas, and by the loops for many
def test_quarter_turns_are_exact(name: str, times: int) -> None:
    angles = np.tile(QUARTERS, times)
    found = MATRICES[name](angles)
    whole = [[(1, 0), (0, 1), (-1, 0), (0, -1)][int(a // 90) % 4] for a in angles]
    assert np.array_equal(found, [[[c, -s, 0], [s, c, 0], [0, 0, 1]] for c, s in whole])


def test_quarter_turns_of_the_plane_and_of_all_axes_are_exact() -> None:
    found = MATRICES["R_z"](np.array(QUARTERS))
    assert np.array_equal(R2(QUARTERS, degrees=True), found[:, :2, :2])
    assert np.array_equal(reflection(QUARTERS, degrees=True), found[:, :2, :2] * [1, -1])
    assert rotate2([1, 2], 90, degrees=True).tolist() == [-2, 1]
    for k, about in enumerate((R_x, R_y)):
        shift = np.roll(np.arange(3), -1 - k)
        assert np.array_equal(about(QUARTERS, degrees=True)[:, shift][..., shift], found)


@pytest.mark.slow
@subcases("seq", SEQUENCES)
def test_quarter_turns_by_euler_angles_are_exact(seq: str) -> None:
    angles = np.array(list(product([0.0, 90.0, 180.0, 270.0, -90.0], repeat=3)))
    turns = Rotation.from_euler(seq, angles, degrees=True)
    matrices = turns.as_matrix()
    assert np.array_equal(matrices, matrices.round())
    points = rotate_euler(np.array([1.0, 2.0, 3.0]), angles, seq, degrees=True)
    assert np.array_equal(points, matrices @ [1, 2, 3])
    back = turns.as_euler(seq, degrees=True)
    assert np.array_equal(back, 90 * (back / 90).round())


def test_half_turns_are_whole_quaternions_without_a_minus_before_zero() -> None:
    assert str(Rotation.from_euler("Z", 180, degrees=True).as_quat()) == "[0. 0. 0. 1.]"
    assert str(Rotation.from_rotvec([360, 0, 0], degrees=True).as_quat()) == "[-1.  0.  0.  0.]"
    assert Rotation.from_rotvec([0, 90, 0], degrees=True).as_quat().tolist() == [
        0.5**0.5,
        0,
        0.5**0.5,
        0,
    ]
    for r, angle in ((Rotation.from_rotvec([0, 90, 0], degrees=True), 90.0),):
        assert r.magnitude(degrees=True) == r.as_axis_angle(degrees=True)[1] == angle
        assert r.as_rotvec(degrees=True).tolist() == [0, angle, 0]


def units(found: Any, wanted: Any) -> float:
    """By how many units in its last place a float is off."""
    if not wanted:
        return 0.0 if found == 0.0 else np.inf
    return float(abs(mp.mpf(float(found)) - wanted) / mp.mpf(float(np.spacing(abs(float(wanted))))))


def floats(most: float) -> st.SearchStrategy[float]:
    """Numbers of any size that have all their digits, and so have what is made of them."""
    return st.floats(-most, most).map(lambda x: x if abs(x) > 1e-290 else 0.0)


def wave(degrees: float, half: bool) -> tuple[Any, Any]:
    """Sine and cosine of degrees or of half as many, exact where they are 0."""
    with mpmath.workprec(1200):
        angle = mpmath.mpf(degrees) / (2 if half else 1)
        both = mpmath.sinpi(angle / 180), mpmath.cospi(angle / 180)
    return mp.mpf(both[0]), mp.mpf(both[1])


@given(st.one_of(floats(1000.0), floats(1.7e308)))
@example(30.0)
@example(59.99999999999999)
@example(1e300)
def test_degrees_are_as_near_as_radians(angle: float) -> None:
    sine, cosine = wave(angle, half=False)
    for m in (R_z(angle, degrees=True), R2(angle, degrees=True)):
        assert units(m[1, 0], sine) <= 0.51
        assert units(m[0, 0], cosine) <= 0.51
    sine, cosine = wave(angle, half=True)
    halves = [
        (Rotation.from_rotvec([0, 0, angle], degrees=True), 0.51),
        (Rotation.from_axis_angle([0, 0, 1], angle, degrees=True), 0.51),
        (Rotation.from_euler("Z", angle, degrees=True), 2.0),  # brought to norm 1 once more
    ]
    for r, bound in halves:
        w, _, _, z = r.as_quat()
        assert units(z, sine) <= bound
        assert units(w, cosine) <= bound


@pytest.mark.parametrize("n", [20, slow(2000)])
def test_points_are_turned_by_degrees_as_near_as_by_radians(n: int) -> None:
    rng = np.random.default_rng(n)
    angles = np.concatenate([rng.uniform(-720, 720, n), 10.0 ** rng.uniform(-300, 300, n)])
    wanted = np.array([wave(a, half=False)[::-1] for a in angles])
    for turned in (
        rotate(E[0], E[2], angles, degrees=True),
        rotate_euler(E[0], angles[:, None], "Z", degrees=True),
    ):
        assert np.abs(turned[:, :2] - wanted).max() <= 2.0**-52
    single = rotate_euler(np.float32(E[0]), angles[:, None], "Z", degrees=True)
    assert single.dtype == np.float32
    assert np.abs(single[:, :2] - wanted).max() <= 2.0**-24


@given(st.lists(floats(1e3), min_size=3, max_size=3))
def test_rotation_vectors_in_degrees(vector: list[float]) -> None:
    v = [mp.mpf(c) for c in vector]
    n = mp.sqrt(sum(c * c for c in v))
    q = Rotation.from_rotvec(vector, degrees=True).as_quat()
    wanted = [mp.cos(n * mp.pi / 360), *(mp.sin(n * mp.pi / 360) * c / n if n else n for c in v)]
    assert max(abs(mp.mpf(float(a)) - b) for a, b in zip(q, wanted, strict=True)) <= 2.0**-53


@given(floats(170.0), st.sampled_from([[0, 0, 1], [1, 2, -2], [0.3, 0.1, 5]]))
def test_read_in_degrees_is_what_is_read_in_radians(angle: float, axis: list[float]) -> None:
    r = Rotation.from_axis_angle(axis, angle, degrees=True)
    pairs = [
        (r.magnitude(True), r.magnitude()),
        (r.as_axis_angle(True)[1], r.as_axis_angle()[1]),
        *zip(r.as_euler("ZYX", True), r.as_euler("ZYX"), strict=True),
        *zip(r.as_euler("xyx", True), r.as_euler("xyx"), strict=True),
        *zip(r.as_davenport(E, "e", True), r.as_davenport(E, "e"), strict=True),
    ]
    for degrees, radians in pairs:
        assert units(degrees, mp.mpf(float(radians)) * 180 / mp.pi) <= 0.51
    with mp.workprec(200):
        w, *u = (mp.mpf(float(c)) for c in r.as_quat(canonical=True))
        n = mp.sqrt(sum(c * c for c in u))
        ratio = 2 * mp.atan2(n, w) * 180 / mp.pi / n if n else mp.mpf(0)
    for found, c in zip(r.as_rotvec(degrees=True), u, strict=True):
        assert units(found, ratio * c) <= 1.0


def test_other_libraries_reduce_degrees_too() -> None:
    xp = pytest.importorskip("array_api_strict")
    given = [*QUARTERS[:9], 30.0, 45.0, 123.0, -77.0]
    wanted, halves = (np.array([wave(a, half) for a in given], float) for half in (False, True))
    for kind in (xp.float32, xp.float64):
        angles = xp.asarray(given, dtype=kind)
        m = np.asarray(R_z(angles, degrees=True))
        assert m.dtype == np.asarray(angles).dtype
        assert np.array_equal(m[:9], m[:9].round())
        eps = np.finfo(m.dtype).eps
        assert np.abs(m[:, 1::-1, 0] - wanted).max() <= eps
        q = np.asarray(Rotation.from_euler("Z", angles, degrees=True).as_quat())
        assert np.abs(q[:, [3, 0]] - halves).max() <= 2 * eps
