"""The plane: rotations, reflections as they should be and as printed, polar form, polygons."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rotation.errors import DTypeError, ForeignArrayError, RotationError
from rotation.plane import (
    LETTER_T,
    R2,
    area,
    from_complex,
    from_polar,
    orientation,
    printed_angle,
    printed_orthogonal,
    printed_reflection,
    reflect2,
    reflection,
    rotate2,
    signed_area,
    to_complex,
    to_polar,
    transform,
    unit_complex,
)

ANGLES = st.floats(-100, 100)
TENTHS = np.arange(11) * 36.0  # degrees: the angles of example 3
POINTS = np.array([[3.0, 4.0], [-3.0, 4.0], [-3.0, -4.0], [3.0, -4.0], [0.0, 2.0], [-2.0, 0.0]])


def close(a, b, tolerance=1e-14):
    return np.abs(np.asarray(a) - np.asarray(b)).max() <= tolerance


@pytest.mark.parametrize(
    ("degrees", "entries"),
    [
        (0, [[1, 0], [0, 1]]),
        (90, [[0, -1], [1, 0]]),
        (180, [[-1, 0], [0, -1]]),
        (270, [[0, 1], [-1, 0]]),
        (-90, [[0, 1], [-1, 0]]),
        (360 * 10**9 + 90, [[0, -1], [1, 0]]),
    ],
)
def test_quarter_turns_in_degrees_are_exact(degrees, entries):
    assert np.array_equal(R2(degrees, degrees=True), entries)
    assert close(R2(np.deg2rad(degrees % 360)), entries)


@given(ANGLES, ANGLES)
def test_rotations_add(a, b):
    assert close(R2(a) @ R2(b), R2(a + b), 1e-13)
    assert close(R2(a) @ R2(a).T, np.eye(2))
    assert close(np.linalg.det(R2(a)), 1)
    assert close(R2(a, degrees=True), R2(np.deg2rad(a)))


@given(ANGLES, ANGLES)
def test_reflections_are_the_orthogonal_matrices_of_determinant_minus_one(a, b):
    m = reflection(a)
    assert close(m @ m, np.eye(2))
    assert close(m, m.T)
    assert close(np.linalg.det(m), -1)
    assert close(m @ from_polar(1.0, a / 2), from_polar(1.0, a / 2))  # the mirror at a/2 stays
    assert close(reflection(a) @ reflection(b), R2(a - b), 1e-13)


def test_the_mirrors_that_the_thesis_mixes_up():
    assert np.array_equal(reflect2((3, 4), 0, degrees=True), [3, -4])  # in the x axis
    assert np.array_equal(reflect2((3, 4), 180, degrees=True), [-3, 4])  # in the y axis


@given(ANGLES)
def test_printed_matrices_scale_areas(theta):
    for printed, sign in ((printed_orthogonal, 1), (printed_reflection, -1)):
        m = printed(theta)
        assert close(np.linalg.det(m), sign * np.cos(2 * theta))
        ratio = signed_area(transform(m, LETTER_T)) / signed_area(LETTER_T)
        assert close(ratio, sign * np.cos(2 * theta), 1e-12)


def test_two_printed_images_keep_the_area_and_all_reflections_do():
    m = printed_reflection(TENTHS, degrees=True)
    kept = np.isclose(area(transform(m[:, None], LETTER_T)), area(LETTER_T))
    assert np.flatnonzero(kept).tolist() == [0, 5, 10]
    assert np.array_equal(m[0], np.diag([1, -1]))
    assert np.array_equal(m[5], np.diag([-1, 1]))
    images = reflect2(LETTER_T, TENTHS[:, None], degrees=True)
    assert images.shape == (11, 8, 2)
    assert close(area(images), area(LETTER_T), 1e-12)
    assert (orientation(images) == -orientation(LETTER_T)).all()


def test_the_letter():
    assert len(set(LETTER_T)) == 8
    assert area(LETTER_T) == 10
    assert orientation(LETTER_T) == 1
    assert orientation(LETTER_T[::-1]) == -1
    assert orientation([(0, 0), (1, 1), (2, 2)]) == 0
    quarter = rotate2(LETTER_T, 90, degrees=True)
    assert np.array_equal(quarter, [(-y, x) for x, y in LETTER_T])
    assert orientation(quarter) == 1


def test_area_far_from_the_origin_loses_nothing():
    assert signed_area(np.array(LETTER_T) + 2.0**40) == 10


def test_polar_form_in_all_quadrants():
    r, theta = to_polar(POINTS)
    assert close(r, [5, 5, 5, 5, 2, 2])
    assert close(from_polar(r, theta), POINTS)
    assert close(theta[-2:], [np.pi / 2, np.pi])
    assert [float(x) for x in to_polar((0, 0))] == [0, 0]


def test_the_printed_angle_fails_left_of_the_y_axis():
    off = to_polar(POINTS)[1] - printed_angle(POINTS)
    assert close(off, [0, np.pi, -np.pi, 0, 0, np.pi])
    assert np.isnan(printed_angle((0, 0)))


@given(ANGLES, st.floats(-1e3, 1e3), st.floats(-1e3, 1e3))
def test_rotation_is_multiplication_by_a_unit_complex_number(psi, x, y):
    by_number = from_complex(to_complex((x, y)) * unit_complex(psi))
    assert close(by_number, rotate2((x, y), psi), 1e-12)


def test_complex_numbers_and_points():
    z = to_complex(np.array([[1, 2], [3, 4]], np.float32))
    assert z.dtype == np.complex64
    assert z.tolist() == [1 + 2j, 3 + 4j]
    assert from_complex(z).dtype == np.float32
    assert from_complex(2).tolist() == [2, 0]
    assert unit_complex(90, degrees=True) == 1j


@pytest.mark.parametrize(
    ("given", "result"),
    [
        (np.float32, np.float32),
        (np.float64, np.float64),
        (np.int8, np.float64),
        (np.uint64, np.float64),
    ],
)
def test_the_points_dtype_decides(given, result):
    points = np.array(LETTER_T, given)
    assert rotate2(points, 1.0).dtype == result
    assert rotate2(points, np.float32(1)).dtype == result
    assert reflect2(points, 1.0).dtype == result
    assert signed_area(points).dtype == result
    assert from_polar(*to_polar(points)).dtype == result


def test_float32_angles_do_not_spoil_float64_points():
    angle = np.float32(0.7)
    assert close(rotate2((1.0, 0.0), angle), rotate2((1.0, 0.0), float(angle)), 0)


@pytest.mark.parametrize("bad", [np.ones(2, bool), np.ones(2, complex), [None, 1], ["a", "b"]])
def test_other_dtypes_raise(bad):
    with pytest.raises(DTypeError, match="float64"):
        rotate2(bad, 1.0)
    with pytest.raises(TypeError, match="angle"):
        rotate2((1.0, 2.0), bad)


def test_arrays_of_other_libraries_raise():
    strict = pytest.importorskip("array_api_strict")
    with pytest.raises(ForeignArrayError):
        rotate2(strict.asarray([1.0, 2.0]), 1.0)


def test_strides_and_broadcasting():
    wide = np.arange(24.0).reshape(4, 6)[::-2, ::3]
    assert close(rotate2(wide, 0.3), rotate2(wide.copy(), 0.3), 0)
    angles = np.array([0.1, 0.2, 0.3])[:, None]
    pairs = rotate2(LETTER_T, angles)
    assert pairs.shape == (3, 8, 2)
    assert close(pairs[1], rotate2(LETTER_T, 0.2), 0)
    assert rotate2(np.empty((0, 2)), 1.0).shape == (0, 2)


@pytest.mark.parametrize("hole", [np.nan, np.inf])
def test_what_is_not_finite_stays_in_its_row(hole):
    points = np.array(LETTER_T, float)
    points[2, 0] = hole
    turned = rotate2(points, 0.5)
    assert not np.isfinite(turned[2]).any()
    assert np.array_equal(np.delete(turned, 2, 0), np.delete(rotate2(LETTER_T, 0.5), 2, 0))
    assert np.isnan(R2(hole)).all()
    assert np.isnan(R2(hole, degrees=True)).all()
    assert np.isnan(orientation(points))


@pytest.mark.parametrize(
    ("call", "word"),
    [
        (lambda: rotate2([1, 2, 3], 1.0), "shape"),
        (lambda: rotate2(5, 1.0), "shape"),
        (lambda: rotate2(LETTER_T, np.zeros(3)), "broadcast"),
        (lambda: from_polar(np.ones(2), np.ones(3)), "broadcast"),
        (lambda: transform(np.eye(3), (1, 2)), "2, 2"),
        (lambda: area([(0, 0), (1, 0)]), "3 corners"),
        (lambda: to_polar([[1, 2], [3]]), "rectangular"),
    ],
)
def test_shapes_that_do_not_fit_raise(call, word):
    with pytest.raises(RotationError, match=word):
        call()


def test_inf_gives_nan_in_its_row_alone() -> None:
    points = [[np.inf, 1.0], [3.0, -4.0], [1.0, -np.inf]]
    for result in (
        rotate2(points, 0.3),
        rotate2(points, 0, degrees=True),
        reflect2(points, 1.0),
        np.stack(to_polar(points), axis=-1),
        from_polar([np.inf, 1.0, np.nan], 0.0),
    ):
        np.testing.assert_array_equal(np.isnan(result), [[True] * 2, [False] * 2, [True] * 2])
    assert np.signbit(to_polar([-1.0, -0.0])[1])
