"""Rigid transforms: against scipy's, against matrices, and by the laws of screws and dual quaternions."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest

from rotation import (
    DTypeError,
    RigidTransform,
    Rotation,
    RotationError,
    inverse_left_jacobian,
    left_jacobian,
    sclerp,
)
from tests.rotation.dual_numbers import Dual, dual_product

scipy = pytest.importorskip("scipy.spatial.transform")
RNG = np.random.default_rng(7)


def some(*shape: int) -> RigidTransform:
    return RigidTransform.from_components(
        RNG.standard_normal((*shape, 3)), Rotation.random(shape, rng=RNG)
    )


def theirs(t: RigidTransform) -> Any:
    return scipy.RigidTransform.from_matrix(t.as_matrix())


def close(found: RigidTransform, wanted: Any, atol: float = 1e-13) -> None:
    matrix = wanted.as_matrix()
    assert found.as_matrix().shape == matrix.shape
    np.testing.assert_allclose(found.as_matrix(), matrix, rtol=0, atol=atol)


@pytest.mark.parametrize("shape", [(), (1,), (30,), (4, 5)])
def test_made_and_read_as_scipy_does(shape: tuple[int, ...]) -> None:
    t = some(*shape)
    s = theirs(t)
    R, S = RigidTransform, scipy.RigidTransform
    x = 2 * RNG.standard_normal((*shape, 6))
    close(R.from_exp_coords(x), S.from_exp_coords(x))
    np.testing.assert_allclose(t.as_exp_coords(), s.as_exp_coords(), atol=1e-12)
    close(R.from_exp_coords(t.as_exp_coords()), s)
    d = RNG.standard_normal((*shape, 8))
    wanted = S.from_dual_quat(d, scalar_first=True)
    np.testing.assert_allclose(
        R.from_dual_quat(d).rotation.as_matrix(), wanted.rotation.as_matrix(), atol=1e-13
    )
    close(R.from_dual_quat(t.as_dual_quat()), s)
    close(R.from_dual_quat(t.as_dual_quat(scalar_first=False), scalar_first=False), s)
    sign = np.sign(np.sum(t.as_dual_quat() * s.as_dual_quat(scalar_first=True), -1, keepdims=True))
    np.testing.assert_allclose(
        t.as_dual_quat(), sign * s.as_dual_quat(scalar_first=True), atol=1e-14
    )
    close(R.from_matrix(s.as_matrix()), s)
    close(R.from_rotation(t.rotation), S.from_rotation(s.rotation))
    close(R.from_translation(t.translation), S.from_translation(t.translation))
    assert t.shape == shape
    assert t.single is (shape == ())


def test_the_group_and_the_points() -> None:
    p, q, v = some(20), some(20), RNG.standard_normal((20, 3))
    close(p * q, theirs(p) * theirs(q))
    close(p * q[3], theirs(p) * theirs(q[3]))
    close(p.inv(), theirs(p).inv())
    np.testing.assert_allclose(p.apply(v), theirs(p).apply(v), atol=1e-14)
    np.testing.assert_allclose(p.apply(v, inverse=True), theirs(p).apply(v, True), atol=1e-14)
    np.testing.assert_allclose(p[0].apply(v), theirs(p[0]).apply(v), atol=1e-14)
    np.testing.assert_allclose(p.apply(p.apply(v), inverse=True), v, atol=1e-14)
    for n in (
        0,
        1,
        -1,
        2,
        0.3,
        -2.5,
    ):  # scipy's exponential loses half its digits where angles are small
        close(p**n, theirs(p) ** n, 1e-6)
    close((p**0.5) * (p**0.5), p)
    close((p**0.3) * (p ** np.full(20, 0.7)), p)
    w = RNG.uniform(0, 1, 20)
    close(p.mean(w), theirs(p).mean(w), 1e-12)
    close(p.mean(), theirs(p).mean(), 1e-12)
    many = some(3, 4)
    close(many.mean(axis=0), theirs(many).mean(axis=0), 1e-12)


def test_dual_quaternions_multiply_as_motions_do() -> None:
    p, q = some(50), some(50)
    found = RigidTransform.from_dual_quat(dual_product(p.as_dual_quat(), q.as_dual_quat()))
    close(found, p * q)
    d = (p * q).as_dual_quat()
    np.testing.assert_allclose(np.sum(d[:, :4] ** 2, axis=1), 1.0, atol=1e-15)
    np.testing.assert_allclose(np.sum(d[:, :4] * d[:, 4:], axis=1), 0.0, atol=1e-14)


def test_the_product_over_dual_numbers_is_that_of_the_ring() -> None:
    from hfield.core import product

    e, one = Dual(0.0, 1.0), 1.0
    assert e * e == Dual(0.0, 0.0)
    assert (one + e) * (2.0 - e) == Dual(2.0, 1.0)
    assert (3.0 - e * 2.0) + -e == Dual(3.0, -3.0)
    i = (0.0 * e, one + 0.0 * e, 0.0 * e, 0.0 * e)
    square = product.multiply(product.Constants(-1.0, 0.0, -1.0), i, i)
    assert square[0] == Dual(-1.0, 0.0)


def test_screws() -> None:
    t = RigidTransform.from_screw([0, 0, 2], [1, 0, 5], 180, 3, degrees=True)
    np.testing.assert_allclose(t.apply([0, 0, 0]), [2, 0, 3], atol=1e-15)
    many = some(40)
    s = many.as_screw()
    close(RigidTransform.from_screw(*s), many, 1e-12)
    np.testing.assert_allclose(np.sum(s.axis * s.point, axis=1), 0.0, atol=1e-12)
    again = RigidTransform.from_screw(s.axis, s.point, s.angle, 0 * s.angle)
    np.testing.assert_allclose(again.apply(s.point), s.point, atol=1e-12)
    shift = RigidTransform.from_translation([[0, 3, 4], [0, 0, 0]]).as_screw()
    np.testing.assert_allclose(shift.axis, [[0, 0.6, 0.8], [0, 0, 1]])
    np.testing.assert_allclose(shift.displacement, [5, 0])
    np.testing.assert_array_equal(shift.angle, 0)
    with pytest.raises(RotationError, match="zero axis"):
        RigidTransform.from_screw([0, 0, 0], [0, 0, 0], 1, 1)


def test_sclerp_runs_along_one_screw_at_constant_rate() -> None:
    p, q = some(), some()
    path = sclerp(p, q, np.linspace(0, 1, 11))
    close(path[0], p)
    close(path[10], q, 1e-12)
    steps = (path[:-1].inv() * path[1:]).as_exp_coords()
    np.testing.assert_allclose(steps, np.tile(steps[0], (10, 1)), atol=1e-12)
    with pytest.raises(DTypeError):
        sclerp(p, q.rotation, 0.5)  # type: ignore[arg-type]


def test_alignment_finds_the_motion() -> None:
    t, v = some(), RNG.standard_normal((9, 3))
    found, rssd = RigidTransform.align(v, t.apply(v))
    assert found.approx_equal(t, atol=1e-13)
    assert rssd < 1e-13


@pytest.mark.parametrize("size", [0.0, 1e-300, 1e-9, 1e-4, 0.1, 0.99, 1.01, 3.0, 6.0])
def test_jacobians_are_the_derivatives(size: float) -> None:
    mpmath = pytest.importorskip("mpmath")
    v = RNG.standard_normal((5, 3))
    v *= size / np.linalg.norm(v, axis=1, keepdims=True)
    with mpmath.workdps(60):
        for row, j in zip(v, left_jacobian(v), strict=True):
            x, y, z = map(mpmath.mpf, row)
            k = mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
            total, term = mpmath.eye(3), mpmath.eye(3)
            for n in range(2, 60):
                term = term * k / n
                total += term
            wanted = np.array(total.tolist(), float)
            np.testing.assert_allclose(j, wanted, rtol=0, atol=1e-15)
            back = np.array((total**-1).tolist(), float)
            np.testing.assert_allclose(
                inverse_left_jacobian(row), back, rtol=0, atol=1e-14 * np.abs(back).max()
            )


def test_the_jacobian_turns_rates_into_angular_velocities() -> None:
    v, dv = RNG.standard_normal((2, 3))
    turned = Rotation.from_rotvec(v + 1e-7 * dv) * Rotation.from_rotvec(v).inv()
    np.testing.assert_allclose(turned.as_rotvec() / 1e-7, left_jacobian(v) @ dv, atol=1e-6)


def test_arrays_of_transforms() -> None:
    t = some(4, 3)
    assert (len(t), t.ndim, t[1].shape, t[1, 2].shape, t[..., 0].shape) == (4, 2, (3,), (), (4,))
    assert t[np.array([True, False, True, False])].shape == (2, 3)
    close(t[1:, 0], theirs(t[1:, 0]))
    assert RigidTransform.concatenate([t[0], t[1, 0]]).shape == (4,)
    assert len(list(t)) == 4
    assert RigidTransform.identity((2, 3)).shape == (2, 3)
    assert (t == t).all()
    assert not (t == t.inv()).any()
    again = pickle.loads(pickle.dumps(t))
    assert (again == t).all()
    assert copy.deepcopy(t) is t
    assert hash(t[0, 0]) == hash(again[0, 0])
    assert "RigidTransform.from_components" in repr(t[0, 0])


def test_nothing_of_it_can_be_changed() -> None:
    shift = np.zeros((2, 3))
    t = RigidTransform.from_components(shift, Rotation.identity())
    shift += 1.0
    t.translation[...] = 5.0
    assert not t.translation.any()
    with pytest.raises(AttributeError):
        t._t = shift
    with pytest.raises(ValueError, match="read-only"):
        t._t[0] = 1.0


def test_mistakes() -> None:
    t = some(3)
    skew = np.eye(4)
    skew[3, 0] = 1.0
    for call in (
        lambda: RigidTransform.from_matrix(np.eye(3)),
        lambda: RigidTransform.from_matrix(skew),
        lambda: RigidTransform.from_matrix(np.diag([1.0, 1, -1, 1])),
        lambda: RigidTransform.from_dual_quat(np.zeros(8)),
        lambda: RigidTransform.from_exp_coords([1.0, 2, 3]),
        lambda: RigidTransform.from_translation(1.0),
        lambda: RigidTransform.from_components(np.zeros((2, 3)), Rotation.random(3, seed=1)),
        lambda: t.apply(np.zeros((2, 3))),
        lambda: t * some(2),
        lambda: RigidTransform.concatenate([]),
    ):
        with pytest.raises(RotationError):
            call()
    for call in (lambda: t * 2, lambda: RigidTransform.concatenate([t, 1])):
        with pytest.raises(DTypeError):
            call()
    with pytest.raises(TypeError):
        len(t[0])


def test_rows_that_are_nan_stay_alone() -> None:
    t = RigidTransform.from_exp_coords([[0.1, 0, 0, 1, 2, 3], [np.nan, 0, 0, 1, 2, 3]])
    for x in (
        t.as_matrix()[..., :3, :3],
        t.as_exp_coords(),
        t.as_dual_quat(),
        t.apply([1.0, 2, 3]),
    ):
        assert np.isfinite(x[0]).all()
        assert np.isnan(x[1]).all()


def test_other_array_libraries() -> None:
    xp = pytest.importorskip("array_api_strict")
    p = some(4)
    q = RigidTransform.from_matrix(xp.asarray(p.as_matrix()))
    moved = (q * q.inv() * q).apply(xp.ones(3))
    assert type(moved) is type(xp.ones(3))
    np.testing.assert_allclose(np.asarray(moved), p.apply(np.ones(3)), atol=1e-14)
    np.testing.assert_allclose(
        np.asarray((q**0.5).as_exp_coords()), (p**0.5).as_exp_coords(), atol=1e-13
    )
    found, wanted = np.asarray(q.as_dual_quat()), p.as_dual_quat()
    signs = np.sign(np.sum(found * wanted, axis=1, keepdims=True))
    np.testing.assert_allclose(found, signs * wanted, atol=1e-14)


def test_changing_a_returned_matrix_changes_no_other() -> None:
    move = RigidTransform.from_components(np.ones((3, 3)), Rotation.random(3, seed=1))
    kept = RigidTransform.from_components(np.ones((3, 3)), Rotation.random(3, seed=1)).as_matrix()
    for _ in range(3):
        matrix = move.as_matrix()
        np.testing.assert_array_equal(matrix, kept)
        matrix[...] = 0.0
    second = move.as_matrix()
    np.testing.assert_array_equal(second, kept)
    second[...] = 0.0
    np.testing.assert_array_equal(move.as_matrix(), kept)


def test_points_keep_their_precision() -> None:
    t, v = some(5), RNG.standard_normal((5, 3))
    for inverse in (False, True):
        near = t.apply(v.astype(np.float32), inverse)
        assert near.dtype == np.float32
        exact = t.apply(v.astype(np.float32).astype(np.float64), inverse)
        np.testing.assert_array_equal(near, exact.astype(np.float32))
    assert t.apply(np.ones((5, 3), np.int32)).dtype == np.float64
    assert t.apply([1, 2, 3]).dtype == np.float64
    strict = pytest.importorskip("array_api_strict")
    other = RigidTransform.from_dual_quat(strict.asarray(t.as_dual_quat()))
    moved = other.apply(strict.asarray(v, dtype=strict.float32))
    assert moved.dtype == strict.float32
    np.testing.assert_allclose(np.asarray(moved), t.apply(v), rtol=1e-5, atol=1e-6)
    with pytest.raises(DTypeError, match="complex"):
        t.apply(1j * v)
