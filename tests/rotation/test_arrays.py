"""What the fused calls say about their arguments, before anything is written."""

from typing import Any

import numpy as np
import pytest

from hfield.errors import HFieldError
from rotation.arrays import components, destination, real
from rotation.errors import DTypeError, ForeignArrayError, RotationError, ZeroRotationError
from rotation.fused import rotate, rotate_euler, rotate_quat

Z = (0.0, 0.0, 1.0)
Q = (1.0, 2.0, 3.0, 4.0)


@pytest.mark.parametrize("kind", ["i1", "u2", "i8", "<f8", ">f8", ">i4"])
def test_integers_and_big_endian_become_float64(kind: str) -> None:
    points = np.array([[1, 2, 3], [4, 5, 6]], kind)
    turned = rotate(points, Z, np.pi / 2)
    assert turned.dtype == np.dtype(np.float64)
    assert turned.dtype.isnative
    np.testing.assert_allclose(turned, [[-2, 1, 3], [-5, 4, 6]], atol=1e-15)


@pytest.mark.parametrize("kind", ["f4", ">f4"])
def test_float32_stays(kind: str) -> None:
    assert rotate(np.ones((2, 3), kind), Z, 1.0).dtype == np.dtype(np.float32)


@pytest.mark.parametrize("kind", ["c16", "?", "O", "f2", "U3", "M8[s]", np.longdouble])
def test_other_kinds_raise(kind: Any) -> None:
    points = np.zeros((2, 3), kind)
    for call in (
        lambda: rotate(points, Z, 1.0),
        lambda: rotate(np.ones(3), points, 1.0),
        lambda: rotate_quat(points, Q),
        lambda: rotate_euler(points, [1.0, 2.0, 3.0]),
    ):
        with pytest.raises(DTypeError, match="expected float32, float64 or integers") as caught:
            call()
        assert isinstance(caught.value, TypeError)
        assert isinstance(caught.value, HFieldError)


def test_arrays_of_other_libraries_raise() -> None:
    strict = pytest.importorskip("array_api_strict")
    with pytest.raises(ForeignArrayError, match=r"points is a array_api_strict.*numpy arrays only"):
        rotate(strict.ones((2, 3)), Z, 1.0)


def test_ragged_and_masked_raise() -> None:
    with pytest.raises(RotationError, match="not a rectangular array"):
        real([[1.0, 2.0], [3.0]], "points")
    with pytest.raises(RotationError, match="masked"):
        real(np.ma.masked_array([1.0, 2.0], [True, False]), "points")


def test_shapes_and_layouts_are_explained() -> None:
    with pytest.raises(
        RotationError, match=r'points has shape \(3, 5\).*it would fit layout="soa"'
    ):
        rotate(np.ones((3, 5)), Z, 1.0)
    with pytest.raises(RotationError, match=r'q has shape \(5, 4\).*it would fit layout="aos"'):
        rotate_quat(np.ones((3, 5)), np.ones((5, 4)), layout="soa")
    with pytest.raises(RotationError, match="layout is 'fortran'"):
        rotate(np.ones((3, 5)), Z, 1.0, layout="fortran")  # type: ignore[arg-type]
    with pytest.raises(RotationError, match=r"points has shape \(\)"):
        components(1.0, 3, "points", "aos")
    with pytest.raises(RotationError, match=r"do not broadcast: points \(5,\), axis \(4,\)"):
        rotate(np.ones((5, 3)), np.ones((4, 3)), 1.0)
    with pytest.raises(RotationError, match="angles for 'ZX' has shape"):
        rotate_euler(np.ones((5, 3)), np.ones((5, 3)), "ZX")
    for seq in ("XXZ", "XyZ", "", "ABC", "XYZX"):
        with pytest.raises(RotationError, match="sequence"):
            rotate_euler(np.ones((5, 3)), np.ones((5, 3)), seq)


def rejected(out: Any, points: Any, message: str, error: type[Exception] = RotationError) -> None:
    """Check that out is refused, and that nothing was written."""
    before = np.array(out)
    for call in (
        lambda: rotate(points, Z, 1.0, out=out),
        lambda: rotate(points, Z, np.ones(len(points)), out=out),
        lambda: rotate_quat(points, Q, out=out),
        lambda: rotate_euler(points, [1.0, 2.0, 3.0], out=out),
    ):
        with pytest.raises(error, match=message):
            call()
    np.testing.assert_array_equal(out, before)


def test_out_that_does_not_fit_is_refused() -> None:
    memory = np.arange(60.0).reshape(20, 3)
    points = memory[:10]
    frozen = np.zeros((10, 3))
    frozen.flags.writeable = False
    rejected(frozen, points, "read-only")
    rejected(np.zeros((9, 3)), points, r"out has shape \(9, 3\); expected \(10, 3\)")
    rejected(np.zeros((10, 3), np.float32), points, "out has dtype <f4; expected <f8", DTypeError)
    rejected(np.zeros((10, 3), ">f8"), points, "out has dtype >f8", DTypeError)
    rejected([[0.0] * 3] * 10, points, "out is a list", DTypeError)
    rejected(memory[1:11], points, "overlaps the points in part")
    rejected(points[::-1], points, "overlaps the points in part")
    rejected(points[:, ::-1], points, "overlaps the points in part")
    strided = np.lib.stride_tricks.as_strided(np.zeros(30), (10, 3), (8, 8))
    rejected(strided, points, "overlaps itself")
    rejected(np.zeros((2, 10, 3))[:, :1], np.zeros((1, 3)), "shape")


def test_out_may_lie_between_the_points() -> None:
    memory = np.arange(60.0).reshape(10, 6)
    points, out = memory[:, :3], memory[:, 3:]
    expected = rotate_quat(points.copy(), Q)
    assert rotate_quat(points, Q, out=out) is out
    np.testing.assert_array_equal(out, expected)


def test_out_must_not_be_the_parameters() -> None:
    axes = np.ones((10, 3))
    with pytest.raises(RotationError, match="overlaps the axes"):
        rotate(np.ones((10, 3)), axes, 1.0, out=axes)
    same, _ = destination(axes, (10,), axes, (), "aos")
    assert same is axes


@pytest.mark.parametrize("layout", ["aos", "soa"])
def test_a_zero_axis_or_quaternion_is_named_before_anything_is_written(layout: Any) -> None:
    rng = np.random.default_rng(1)
    points, axes, q = (
        rng.normal(size=(3000, 3)),
        rng.normal(size=(3000, 3)),
        rng.normal(size=(3000, 4)),
    )
    axes[2100], q[2200], q[2300] = 0.0, 0.0, 0.0
    axes[:2000, 0], q[:2000, 0] = 0.0, -0.0  # zero components alone do not matter
    axes[5], q[5] = (np.nan, 0.0, 0.0), (0.0, 0.0, 0.0, np.nan)  # NaN is not zero
    if layout == "soa":
        points, axes, q = points.T.copy(), axes.T.copy(), q.T.copy()
    before = points.copy()
    for out in (None, points):
        with pytest.raises(ZeroRotationError, match=r"zero axis in row 2100") as caught:
            rotate(points, axes, 1.0, out=out, layout=layout)
        assert caught.value.row == (2100,)
        with pytest.raises(ZeroRotationError, match=r"zero quaternion in row 2200"):
            rotate_quat(points, q, out=out, layout=layout)
    np.testing.assert_array_equal(points, before)


def test_a_single_zero_axis_and_rows_of_batches() -> None:
    with pytest.raises(ZeroRotationError, match="zero axis: it names"):
        rotate(np.ones((5, 3)), np.zeros(3), 1.0)
    with pytest.raises(ZeroRotationError, match="zero quaternion: it names"):
        rotate_quat(np.ones((5, 3)), np.zeros(4))
    axes = np.ones((2, 4, 1, 3))
    axes[1, 2] = -0.0
    with pytest.raises(ZeroRotationError, match=r"in row \(1, 2, 0\)"):
        rotate(np.ones((7, 3)), axes, 1.0)
