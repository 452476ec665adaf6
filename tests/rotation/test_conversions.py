"""Quaternions, rotation vectors, axes and matrices into each other, against fifty digits."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rotation import R_x, R_y, R_z, Rotation, RotationError, T_q, ZeroRotationError
from tests.rotation import reference
from tests.rotation.reference import mp

ULP = 2.0**-52


def directions(rng: np.random.Generator, n: int) -> np.ndarray:
    v = rng.standard_normal((n, 3))
    return v / np.linalg.norm(v, axis=1)[:, None]


# Quaternions


@pytest.mark.parametrize("size", [1e-300, 1e-200, 1e-150, 1e-8, 1.0, 2.0, 1e150, 1e300])
def test_quaternions_of_every_length_are_normalised(size: float) -> None:
    q = np.random.default_rng(0).standard_normal((200, 4))
    q /= np.abs(q).max(axis=1)[:, None]
    r = Rotation.from_quat(size * q).as_quat()
    for found, given_ in zip(r, size * q, strict=True):
        c = reference.exact(given_)
        n = reference.length(c)
        assert max(abs(mp.mpf(float(a)) - b / n) for a, b in zip(found, c, strict=True)) < ULP


def test_the_smallest_floats_are_a_direction() -> None:
    assert Rotation.from_quat([0, 5e-324, 0, 0]).as_quat().tolist() == [0, 1, 0, 0]


def test_normalising_again_changes_nothing() -> None:
    q = Rotation.random(10_000, rng=1).as_quat()
    assert np.array_equal(Rotation.from_quat(q).as_quat(), q)


def test_scalar_first_and_last() -> None:
    first, last = [1.0, 2.0, 3.0, 4.0], [2.0, 3.0, 4.0, 1.0]
    r = Rotation.from_quat(first)
    assert r == Rotation.from_quat(last, scalar_first=False) == Rotation(first)
    assert np.array_equal(r.as_quat(scalar_first=False)[[3, 0, 1, 2]], r.as_quat())


def test_the_sign_is_kept_unless_canonical_is_true() -> None:
    q = Rotation.from_quat([-1.0, 1, 1, 1]).as_quat()
    assert q.tolist() == [-0.5, 0.5, 0.5, 0.5]
    assert Rotation.from_quat(q).as_quat(canonical=True).tolist() == [0.5, -0.5, -0.5, -0.5]
    for half_turn in ([0.0, -1, 0, 0], [0.0, 0, -1, 0], [0, 0, 0, -1], [0, -0.6, 0.8, 0]):
        both = [Rotation.from_quat(s * np.array(half_turn)) for s in (1, -1)]
        canonical = [r.as_quat(canonical=True) for r in both]
        assert np.array_equal(*canonical)
        assert canonical[0][canonical[0] != 0][0] > 0
        assert np.array_equal(both[0].as_rotvec(), both[1].as_rotvec())


def test_what_as_quat_returns_is_the_callers() -> None:
    r = Rotation.identity(2)
    r.as_quat()[:] = 7
    assert np.array_equal(r.as_quat(), [[1, 0, 0, 0]] * 2)


# Rotation vectors


def worst_round_trip(v: np.ndarray) -> float:
    """The largest error of rotvec → rotation → rotvec, in ulps of the vector's length."""
    back = Rotation.from_rotvec(v).as_rotvec()
    largest = np.abs(v).max(axis=1)
    size = largest * np.linalg.norm(v / largest[:, None], axis=1)
    error = np.abs(back - v) / np.spacing(size)[:, None]
    return float(np.linalg.norm(error, axis=1).max())


@pytest.mark.parametrize(
    ("low", "high"),
    [(-300, -290), (-200, -150), (-165, -150), (-142, -136), (-20, -1), (-9, -7), (-1, 0.49)],
)
def test_rotation_vectors_come_back_to_two_ulps(low: float, high: float) -> None:
    rng = np.random.default_rng(2)
    v = directions(rng, 20_000) * 10 ** rng.uniform(low, high, (20_000, 1))
    assert worst_round_trip(v) <= 2.0


def test_half_turns_come_back_to_two_ulps() -> None:
    rng = np.random.default_rng(3)
    v = directions(rng, 20_000) * rng.uniform(3.1, np.pi * (1 - 1e-15), (20_000, 1))
    assert worst_round_trip(v) <= 2.0


@pytest.mark.parametrize("size", [1e-300, 1e-160, 1e-8, 0.9, 3.0, 3.2, 100.0, 1e5, 1e9])
def test_quaternions_of_rotation_vectors(size: float) -> None:
    v = size * directions(np.random.default_rng(4), 50)
    for q, vector in zip(Rotation.from_rotvec(v).as_quat(), v, strict=True):
        wanted = reference.quaternion_of(vector)
        error = [mp.mpf(float(a)) - b for a, b in zip(q, wanted, strict=True)]
        assert float(reference.length(error)) <= 1.5 * ULP
        if size < 3:  # small parts are right relative to themselves
            assert float(reference.length(error[1:]) / reference.length(wanted[1:])) <= ULP


def test_huge_rotation_vectors_are_rotations() -> None:
    q = Rotation.from_rotvec([[1e300, 0, 0], [1e300, -1e300, 1e300], [0, 1e154, 1e153]]).as_quat()
    assert np.abs(np.linalg.norm(q, axis=1) - 1).max() < 1e-15
    assert q[0, 0] == pytest.approx(np.cos(5e299), abs=1e-15)


def test_tiny_rotations_are_not_rounded_to_nothing() -> None:
    for size in (1e-8, 1e-16, 1e-100, 1e-300):
        r = Rotation.from_rotvec([size, 0, 0])
        assert r.magnitude() == pytest.approx(size, rel=1e-15)
        assert (r * r).as_rotvec()[0] == pytest.approx(2 * size, rel=1e-15)
        assert (r**0.5).as_rotvec()[0] == pytest.approx(size / 2, rel=1e-15)
    moved = Rotation.from_rotvec([0, 0, 1e-8]).apply([1.0, 0, 0])
    assert moved.tolist() == [1.0, pytest.approx(1e-8, rel=1e-15), 0.0]


def test_the_zero_vector_is_the_identity() -> None:
    r = Rotation.from_rotvec([0.0, 0, 0])
    assert r.as_quat().tolist() == [1, 0, 0, 0]
    assert r.as_rotvec().tolist() == [0, 0, 0]
    assert r.magnitude() == 0


def test_rotation_vectors_in_degrees() -> None:
    v = [[0, 0, 90.0], [30, 0, 0], [0, 0, 0]]
    r = Rotation.from_rotvec(v, degrees=True)
    assert r.as_rotvec(degrees=True) == pytest.approx(np.array(v), abs=1e-13)
    assert Rotation.from_rotvec([0, 0, 1e9 * 360 + 90], degrees=True).as_rotvec()[
        2
    ] == pytest.approx(np.pi / 2, abs=1e-15)


@given(st.lists(st.floats(-1e300, 1e300), min_size=3, max_size=3))
def test_every_finite_vector_is_a_rotation(v: list[float]) -> None:
    r = Rotation.from_rotvec(v)
    assert abs(np.linalg.norm(r.as_quat()) - 1) <= 1e-15
    assert 0 <= r.magnitude() <= np.pi


# Axis and angle


def test_axis_and_angle() -> None:
    r = Rotation.from_axis_angle([0, 0, 2], [np.pi / 2, 0.0, -np.pi / 2])
    axis, angle = r.as_axis_angle()
    assert axis == pytest.approx(np.array([[0, 0, 1], [0, 0, 1], [0, 0, -1.0]]))
    assert angle == pytest.approx([np.pi / 2, 0, np.pi / 2])
    assert Rotation.from_axis_angle([1e-300, 0, 0], 90, degrees=True).apply(
        [0, 1, 0]
    ) == pytest.approx([0, 0, 1])


@pytest.mark.parametrize("size", [5e-324, 1e-200, 1.0, 1e300])
def test_axes_of_every_length(size: float) -> None:
    assert Rotation.from_axis_angle([0, size, 0], 1.0).as_rotvec() == pytest.approx([0, 1.0, 0])


def test_a_zero_axis_is_refused_by_name() -> None:
    with pytest.raises(ZeroRotationError, match="axis in row 2"):
        Rotation.from_axis_angle([[1, 0, 0], [0, 1, 0], [0, 0, 0]], 0.0)
    with pytest.raises(RotationError, match="broadcast"):
        Rotation.from_axis_angle(np.ones((2, 3)), np.ones(3))


def test_modified_rodrigues_parameters() -> None:
    r = Rotation.random(1000, rng=5)
    assert Rotation.from_mrp(r.as_mrp()).approx_equal(r, atol=1e-15).all()
    assert np.linalg.norm(r.as_mrp(), axis=1).max() <= 1
    shadow = -r.as_mrp() / (r.as_mrp() ** 2).sum(axis=1)[:, None]  # the same, the long way round
    assert Rotation.from_mrp(shadow).approx_equal(r, atol=1e-14).all()
    assert Rotation.from_mrp([1e300, 0, 0]).magnitude() == pytest.approx(0, abs=1e-15)
    assert Rotation.from_mrp([1e-300, 0, 0]).as_mrp()[0] == pytest.approx(1e-300)
    assert Rotation.from_mrp([0, 0, 1]).apply([1, 2, 3]) == pytest.approx([-1, -2, 3])


# The shortest turn between two directions


def test_between_directions() -> None:
    rng = np.random.default_rng(6)
    a, b = rng.standard_normal((2, 1000, 3)) * 10.0 ** rng.integers(-200, 200, (2, 1000, 1))
    r = Rotation.between(a, b)
    unit = [v / np.abs(v).max(axis=1)[:, None] for v in (a, b)]
    a, b = (v / np.linalg.norm(v, axis=1)[:, None] for v in unit)
    assert np.abs(r.apply(a) - b).max() < 1e-15
    assert np.abs((r.as_axis_angle()[0] * (a + b)).sum(axis=1)).max() < 1e-14
    assert r.magnitude() == pytest.approx(
        2 * np.arctan2(np.linalg.norm(a - b, axis=1), np.linalg.norm(a + b, axis=1)), abs=1e-15
    )


def test_between_directions_that_are_all_but_opposite() -> None:
    rng = np.random.default_rng(14)
    a = directions(rng, 500)
    for tilt in (0.0, 1e-300, 1e-16, 1e-12, 1e-8, 1e-4):
        for stretch in (1.0, 3.0):
            b = -stretch * (a + tilt * directions(rng, 500))
            r = Rotation.between(a, b)
            b /= np.linalg.norm(b, axis=1)[:, None]
            assert np.abs(r.apply(a) - b).max() < 4e-15
            assert r.magnitude().min() > np.pi - 2 * tilt - 1e-14


def test_between_nearly_equal_and_opposite_directions() -> None:
    for tilt in (1e-300, 1e-20, 1e-8):
        r = Rotation.between([1, 0, 0], [1, tilt, 0])
        assert r.as_rotvec() == pytest.approx([0, 0, tilt], rel=1e-15)
    r = Rotation.between([1, 0, 0], [-1, 1e-8, 0])
    assert r.apply([1, 0, 0]) == pytest.approx([-1, 1e-8, 0], abs=1e-16)
    for a in ([1, 0, 0], [0, -2, 0], [0.6, 0, 0.8], [1, 1, 1]):
        r = Rotation.between(a, -np.array(a))
        assert r.magnitude() == np.pi
        assert r.apply(a) == pytest.approx(-np.array(a), abs=1e-15)
    assert Rotation.between([3, 4, 5], [3, 4, 5]) == Rotation.identity()
    with pytest.raises(ZeroRotationError, match="target"):
        Rotation.between([1, 0, 0], [0, 0, 0])


# Matrices


def test_matrices_of_the_axes() -> None:
    c, s = np.cos(0.3), np.sin(0.3)
    assert np.array_equal(R_x(0.3), [[1, 0, 0], [0, c, -s], [0, s, c]])
    assert np.array_equal(R_y(0.3), [[c, 0, s], [0, 1, 0], [-s, 0, c]])
    assert np.array_equal(R_z(0.3), [[c, -s, 0], [s, c, 0], [0, 0, 1]])
    assert R_x([[0.1, 0.2]]).shape == (1, 2, 3, 3)
    assert np.array_equal(
        R_y(90 * np.arange(4), degrees=True)[1], [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]
    )


def test_example_4_of_the_thesis() -> None:
    """Turning about x and then z brings (1, 1, 1) back to (1, 1, 1); the other order does not."""
    x, z = (Rotation.from_matrix(m(np.pi / 2)) for m in (R_x, R_z))
    assert (z * x).apply([1, 1, 1]) == pytest.approx([1, 1, 1])
    assert (x * z).apply([1, 1, 1]) == pytest.approx([-1, -1, 1])


def test_matrices_of_quaternions_and_back() -> None:
    rng = np.random.default_rng(7)
    q = np.concatenate([rng.standard_normal((200, 4)), np.eye(4), rng.integers(-1, 2, (50, 4))])
    q = q[np.any(q != 0, axis=1)]
    r = Rotation.from_quat(q)
    for found, given_ in zip(r.as_matrix(), r.as_quat(), strict=True):
        assert reference.distance(found, reference.matrix_of(reference.exact(given_))) <= 3 * ULP
    back = Rotation.from_matrix(r.as_matrix())
    assert back.approx_equal(r, atol=8e-16).all()
    assert np.array_equal(Rotation.from_matrix(np.eye(3)).as_quat(), [1, 0, 0, 0])


def test_a_small_turn_survives_its_matrix() -> None:
    v = 1e-8 * directions(np.random.default_rng(8), 100)
    back = Rotation.from_matrix(Rotation.from_rotvec(v).as_matrix()).as_rotvec()
    assert np.abs(back - v).max() < 1e-15 * 1e-8


def test_the_24_rotations_of_the_cube_are_exact() -> None:
    for order in itertools.permutations(range(3)):
        for signs in itertools.product([1, -1], repeat=3):
            m = np.diag(signs)[list(order)]
            if np.linalg.det(m) > 0:
                assert Rotation.from_matrix(m).as_matrix() == pytest.approx(m, abs=5e-16)


def test_a_row_does_not_depend_on_its_neighbours() -> None:
    rng = np.random.default_rng(9)
    good = Rotation.random(40_000, rng=9).as_matrix()
    rough = good + 1e-8 * rng.standard_normal(good.shape)
    alone = Rotation.from_matrix(good[17]).as_quat()
    mixed = rough.copy()
    mixed[17] = good[17]
    assert np.array_equal(Rotation.from_matrix(mixed).as_quat()[17], alone)


def test_the_nearest_rotation_is_taken_within_tolerance() -> None:
    rng = np.random.default_rng(10)
    good = Rotation.random(200, rng=10).as_matrix()
    for dtype, noise in ((np.float64, 1e-7), (np.float32, 1e-4)):
        rough = (good + noise * rng.standard_normal(good.shape)).astype(dtype)
        u, _, vt = np.linalg.svd(rough.astype(float))
        assert Rotation.from_matrix(rough).as_matrix() == pytest.approx(u @ vt, abs=1e-14)


def test_matrices_that_are_no_rotations() -> None:
    m = np.tile(np.eye(3), (4, 1, 1))
    with pytest.raises(RotationError, match=r"in row 2 is a reflection"):
        Rotation.from_matrix(m * np.array([1, 1, -1, 1])[:, None, None])
    for dtype, tolerance in ((np.float64, 1e-6), (np.float32, 1e-3)):
        near = np.eye(3)
        near[1, 2] = 0.99 * tolerance
        Rotation.from_matrix(near.astype(dtype))
        near[1, 2] = 1.01 * tolerance
        with pytest.raises(RotationError, match="not orthogonal"):
            Rotation.from_matrix(near.astype(dtype))
    off = m.copy()
    off[3, 0, 1] = 1e-5
    with pytest.raises(RotationError, match=r"in row 3 is not orthogonal to within 1e-06"):
        Rotation.from_matrix(off)
    with pytest.raises(RotationError, match=r"in row \(1, 1\) is not orthogonal"):
        Rotation.from_matrix(off.reshape(2, 2, 3, 3))
    Rotation.from_matrix(off.astype(np.float32))
    with pytest.raises(RotationError, match=r"within 0\.001"):
        Rotation.from_matrix((off * 1.01).astype(np.float32))
    for zero in (np.zeros((3, 3)), np.diag([1.0, 1, 0])):
        with pytest.raises(RotationError, match="not orthogonal"):
            Rotation.from_matrix(zero)
        with pytest.raises(RotationError, match="singular"):
            Rotation.from_matrix(zero, orthonormalize=True)
    with pytest.raises(RotationError, match="reflection"):
        Rotation.from_matrix(-np.eye(3), orthonormalize=True)
    with pytest.raises(RotationError, match="shape"):
        Rotation.from_matrix(np.eye(4))


@pytest.mark.parametrize("size", [1e-200, 1.0, 1e200])
def test_orthonormalize_takes_the_polar_factor(size: float) -> None:
    rng = np.random.default_rng(11)
    m = rng.standard_normal((100, 3, 3))
    m *= np.sign(np.linalg.det(m))[:, None, None]
    u, _, vt = np.linalg.svd(m)
    found = Rotation.from_matrix(size * m, orthonormalize=True).as_matrix()
    assert found == pytest.approx(u @ vt, abs=1e-13)


# The definition


def test_T_q_is_the_rotation() -> None:
    q = np.random.default_rng(12).standard_normal((100, 4))
    v = np.random.default_rng(13).standard_normal((100, 3))
    assert T_q(q, v) == pytest.approx(Rotation.from_quat(q).apply(v), abs=1e-14)
    assert T_q(q[:, None], v).shape == (100, 100, 3)


# Matrices of quaternions, and the sine of an angle on its way through a rotation


def test_entries_of_matrices_are_right_to_an_ulp_of_one() -> None:
    r = Rotation.random(3000, seed=8)
    q, m = r.as_quat(), r.as_matrix()
    for row, found in zip(q, m, strict=True):
        right = reference.matrix_of(reference.exact(row))
        assert (
            max(abs(mp.mpf(float(found[i, k])) - right[i, k]) for i in range(3) for k in range(3))
            < ULP
        )


@pytest.mark.parametrize("reach", [4.0, 1e9])
def test_sines_and_cosines_of_matrices_that_come_from_angles(reach: float) -> None:
    angles = np.random.default_rng(9).uniform(-reach, reach, 4000)
    vectors = angles[:, None] * [0.0, 0.0, 1.0]
    expected = [(mp.cos(a), mp.sin(a)) for a in reference.exact(angles)]
    for r in (
        Rotation.from_rotvec(vectors),
        Rotation.from_axis_angle([0.0, 0.0, 1.0], angles),
        Rotation.from_euler("Z", angles[:, None]),
    ):
        for found, (cosine, sine) in zip(r.as_matrix()[:, :2, 0], expected, strict=True):
            c, s = reference.exact(found)
            assert max(abs(c - cosine), abs(s - sine)) <= ULP


# Columns


@pytest.mark.parametrize("shape", [(), (0,), (7,), (2, 3)])
def test_columns_are_the_rows_of_a_table(shape: tuple[int, ...]) -> None:
    r = Rotation.random(shape, seed=3)
    columns = r.as_columns(degrees=True)
    assert {column.shape for column in columns.values()} == {(r.size,)}
    flat = r.reshape(-1)
    assert np.array_equal(np.stack([columns[c] for c in "wxyz"], axis=-1), flat.as_quat())
    axes = np.stack([columns[f"axis_{c}"] for c in "xyz"], axis=-1)
    assert Rotation.from_axis_angle(axes, columns["angle"], True).approx_equal(flat, 1e-14).all()


def test_columns_may_be_written_and_keep_the_precision() -> None:
    r = Rotation.random(3, seed=3, dtype=np.float32)
    for column in r.as_columns().values():
        assert column.dtype == np.float32
        assert column.flags.c_contiguous
        column[:] = 0
    assert (r == Rotation.random(3, seed=3, dtype=np.float32)).all()
