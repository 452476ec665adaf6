"""Applying rotations to points: broadcasting, dtypes, memory, accuracy."""

import numpy as np
import pytest

from rotation import DTypeError, Rotation, RotationError
from tests.rotation import reference
from tests.rotation.reference import mp

ULP = 2.0**-52


def test_accuracy_against_fifty_digits() -> None:
    rng = np.random.default_rng(1)
    r = Rotation.random(300, rng=1)
    v = rng.standard_normal((300, 3)) * 10.0 ** rng.integers(-100, 100, (300, 1))
    for inverse in (False, True):
        for q, x, y in zip(r.as_quat(), v, r.apply(v, inverse=inverse), strict=True):
            m = reference.matrix_of(reference.exact(q))
            wanted = (m.T if inverse else m) * mp.matrix(reference.exact(x))
            error = reference.length([mp.mpf(float(a)) - b for a, b in zip(y, wanted, strict=True)])
            assert error <= 5 * ULP * reference.length(reference.exact(x))


@pytest.mark.parametrize(
    ("batch", "points", "result"),
    [
        ((), (3,), (3,)),
        ((), (5, 3), (5, 3)),
        ((5,), (3,), (5, 3)),
        ((5,), (5, 3), (5, 3)),
        ((4, 1), (5, 3), (4, 5, 3)),
        ((2, 1, 5), (4, 1, 3), (2, 4, 5, 3)),
        ((0,), (3,), (0, 3)),
        ((), (0, 3), (0, 3)),
        ((1,), (1, 3), (1, 3)),
    ],
)
def test_batches_broadcast(
    batch: tuple[int, ...], points: tuple[int, ...], result: tuple[int, ...]
) -> None:
    r = Rotation.random(batch, rng=2)
    v = np.random.default_rng(3).standard_normal(points)
    wanted = np.einsum("...ij,...j->...i", r.as_matrix(), v)
    assert wanted.shape == result
    assert r.apply(v).shape == result
    assert r.apply(v) == pytest.approx(wanted, abs=1e-14)
    assert r.apply(r.apply(v), inverse=True) == pytest.approx(np.broadcast_to(v, result), abs=1e-14)


def test_all_pairs() -> None:
    r, v = Rotation.random((2, 3), rng=4), np.random.default_rng(5).standard_normal((4, 5, 3))
    pairs = r.apply_outer(v)
    assert pairs.shape == (2, 3, 4, 5, 3)
    assert np.array_equal(pairs[1, 2, 3, 4], r[1, 2].apply(v)[3, 4]) or pairs[
        1, 2, 3, 4
    ] == pytest.approx(r[1, 2].apply(v[3, 4]), abs=1e-15)
    assert r.apply_outer([1, 0, 0]).shape == (2, 3, 3)
    with pytest.raises(RotationError, match="broadcast"):
        Rotation.random(3).apply(np.ones((2, 3)))


def test_the_points_decide_the_dtype() -> None:
    r = Rotation.random(7, rng=6)
    for dtype, result in [
        (np.float32, np.float32),
        (np.float64, np.float64),
        (np.int16, np.float64),
    ]:
        assert r.apply(np.ones((7, 3), dtype)).dtype == result
    for dtype in (complex, object, bool, np.float16, "U3"):
        with pytest.raises(DTypeError):
            r.apply(np.ones((7, 3)).astype(dtype))


def test_any_strides_give_the_same() -> None:
    rng = np.random.default_rng(7)
    r, v = Rotation.random((6, 5), rng=7), rng.standard_normal((6, 5, 3))
    wanted = r.apply(v)
    for view in (
        np.asfortranarray(v),
        v[::-1][::-1],
        np.repeat(v, 2, axis=1)[:, ::2],
        np.moveaxis(np.ascontiguousarray(np.moveaxis(v, -1, 0)), 0, -1),
    ):
        assert r.apply(view) == pytest.approx(wanted, abs=1e-15)
    assert r[::-1, ::2].apply(v[::-1, ::2]) == pytest.approx(wanted[::-1, ::2], abs=1e-15)
    q = np.asfortranarray(r.as_quat())
    assert np.array_equal(Rotation(q).as_quat(), r.as_quat())
    assert Rotation(q[:, ::-2]).as_rotvec() == pytest.approx(r[:, ::-2].as_rotvec())


def test_out() -> None:
    r, v = Rotation.random(9, rng=8), np.random.default_rng(9).standard_normal((9, 3))
    wanted = r.apply(v)
    out = np.empty((9, 3))
    assert r.apply(v, out=out) is out
    assert np.array_equal(out, wanted)
    same = v.copy()
    r.apply(same, out=same)
    assert np.array_equal(same, wanted)
    for bad in (np.empty((8, 3)), np.empty((9, 3), np.float32), v[::-1]):
        before = bad.copy()
        with pytest.raises((RotationError, DTypeError)):
            r.apply(v, out=bad)
        assert np.array_equal(bad, before, equal_nan=True)


def test_points_that_are_none() -> None:
    r = Rotation.identity()
    for bad in (np.ones(2), np.ones((3, 2)), 1.0, [[1, 2, 3], [1, 2]]):
        with pytest.raises(RotationError):
            r.apply(bad)
