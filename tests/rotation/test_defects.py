"""Mistakes and limits that gave a wrong or a foreign answer once."""

import copy
import weakref
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from rotation import (
    DTypeError,
    Rotation,
    RotationError,
    align,
    align_points,
    rotate,
    rotate_quat,
)
from tests.subcases import subcases

strict = pytest.importorskip("array_api_strict")
R = Rotation.random(6, seed=1)
V = np.random.default_rng(2).standard_normal((6, 3))


def test_an_infinite_weight_is_exact_and_the_others_do_their_best() -> None:
    S = pytest.importorskip("scipy.spatial.transform").Rotation
    rng = np.random.default_rng(3)
    for n in (1, 2, 3, 10):
        for _ in range(20):
            a, b = rng.standard_normal((2, n, 3)) * 10.0 ** rng.uniform(-3, 3, (2, n, 1))
            w = rng.uniform(0, 2, n)
            w[rng.integers(n)] = np.inf
            found, rssd = Rotation.align_vectors(a, b, w)
            wanted, distance = S.align_vectors(a, b, w)
            if n > 1:
                assert found.approx_equal(Rotation.from_scipy(wanted), atol=1e-9)
            assert rssd == pytest.approx(distance, rel=1e-6, abs=1e-12)
            k = int(np.argmax(w))
            images = found.apply(b[k]) / np.linalg.norm(b[k]), a[k] / np.linalg.norm(a[k])
            np.testing.assert_allclose(*images, atol=1e-14)
    assert align([[0, 0, 1], [1, 0, 0]], [[0, 0, 1], [0, 1, 0]], [np.inf, 1])[0].approx_equal(
        Rotation.from_euler("Z", 90, degrees=True)
    )


def test_infinite_weights_that_cannot_be() -> None:
    a, b = np.random.default_rng(4).standard_normal((2, 3, 3))
    with pytest.raises(RotationError, match="one infinite"):
        Rotation.align_vectors(a, b, [np.inf, np.inf, 1])
    with pytest.raises(RotationError, match="no direction"):
        Rotation.align_vectors(np.zeros((3, 3)), b, [np.inf, 1, 1])
    with pytest.raises(RotationError, match="infinite"):
        align_points(a, b, [np.inf, 1, 1])
    with pytest.raises(RotationError, match="infinite"):
        Rotation.align_vectors(
            strict.asarray(a), strict.asarray(b), strict.asarray([np.inf, 1.0, 1.0])
        )


def test_sensitivity_is_scipys() -> None:
    S = pytest.importorskip("scipy.spatial.transform").Rotation
    a = np.random.default_rng(5).standard_normal((8, 3))
    b, w = R[0].inv().apply(a) + 1e-3 * V[0], np.linspace(0.5, 2, 8)
    found = Rotation.align_vectors(a, b, w, return_sensitivity=True)[2]
    np.testing.assert_allclose(
        found, S.align_vectors(a, b, w, return_sensitivity=True)[2], rtol=1e-9
    )
    many = Rotation.align_vectors(np.stack([a, a]), np.stack([b, b]), w, return_sensitivity=True)[2]
    np.testing.assert_allclose(many, [found, found], rtol=1e-12)
    for bad in ((a[:1], b[:1]), (np.outer([1, 2], a[0]), np.outer([1, 2], b[0]))):
        with pytest.raises(RotationError, match="sensitivity"):
            Rotation.align_vectors(*bad, return_sensitivity=True)
    with pytest.raises(RotationError, match="sensitivity"):
        Rotation.align_vectors(a, b, [np.inf, *w[1:]], return_sensitivity=True)


def test_half_precision_is_refused_in_every_library(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(DTypeError, match="float16"):
        Rotation(np.ones(4, np.float16))

    class Coarse:
        bits = 16

    q = strict.asarray(R.as_quat())
    monkeypatch.setattr(type(q).__array_namespace__(q), "finfo", lambda dtype: Coarse)
    for make in (Rotation.from_quat, Rotation.from_mrp):
        with pytest.raises(DTypeError, match="too coarse"):
            make(q)


@subcases(
    "call",
    [
        lambda xp: Rotation(xp.asarray(R.as_quat())).apply(xp.asarray(V[:5])),
        lambda xp: Rotation(xp.asarray(R.as_quat())).mean(xp.asarray(V[:5, 0])),
        lambda xp: Rotation(xp.asarray(R.as_quat())) * Rotation(xp.asarray(R[:5].as_quat())),
        lambda xp: Rotation.align_vectors(xp.asarray(V), xp.asarray(V), xp.asarray(V[:5, 0] ** 2)),
        lambda xp: Rotation.align_vectors(xp.asarray(V), xp.asarray(V[:5])),
        lambda xp: Rotation.from_axis_angle(xp.asarray(V), xp.asarray(V[:5, 0])),
        lambda xp: Rotation.between(xp.asarray(V), xp.asarray(V[:5])),
    ],
)
@subcases("xp", [strict, np])
def test_shapes_that_do_not_fit_are_our_error(call: Callable[[Any], Any], xp: Any) -> None:
    with pytest.raises(RotationError):
        call(xp)


def test_concatenate_takes_rotations() -> None:
    for bad in ([R, 1], 1, [R.as_quat()]):
        with pytest.raises(DTypeError, match="takes rotations"):
            Rotation.concatenate(bad)
    with pytest.raises(RotationError):
        Rotation.concatenate([])


def test_a_power_has_one_sign_however_the_exponent_is_written() -> None:
    p = Rotation(-np.abs(R.as_quat()))
    for n in (1, -1, 2, 0):
        forms = [
            (p**e).as_quat() for e in (n, float(n), np.float64(n), np.array(float(n)), np.array(n))
        ]
        for q in forms[1:]:
            np.testing.assert_allclose(q, forms[0], atol=1e-15)
    assert (p**1 == p).all()


def test_rotations_are_weakly_referenced_and_copied() -> None:
    r = Rotation.random(2, seed=1)
    assert weakref.ref(r)() is r
    assert copy.copy(r) is r
    assert "__dict__" not in dir(r)


def test_out_may_not_be_masked() -> None:
    out = np.ma.masked_array(np.zeros((6, 3)), mask=True)
    for call in (
        lambda: R.apply(V, out=out),
        lambda: rotate_quat(V, [1, 0, 0, 0], out=out),
        lambda: rotate(V, [0, 0, 1], 1.0, out=out),
    ):
        with pytest.raises(RotationError, match="masked"):
            call()
    assert not out.data.any()


def test_approx_equal_in_degrees() -> None:
    a, b = Rotation.identity(), Rotation.from_euler("Z", 0.5, degrees=True)
    assert a.approx_equal(b, atol=0.6, degrees=True)
    assert not a.approx_equal(b, atol=0.4, degrees=True)
    assert "degrees" in str(Rotation.approx_equal.__doc__)


def test_rotate_quat_takes_rotations_and_rotate_degrees() -> None:
    np.testing.assert_array_equal(rotate_quat(V, R), rotate_quat(V, R.as_quat()))
    np.testing.assert_array_equal(
        rotate_quat(V.T, R, layout="soa"), rotate_quat(V.T, R.as_quat().T, layout="soa")
    )
    turned = rotate([1.0, 0, 0], [0, 0, 1], [90, 360e9], degrees=True)
    np.testing.assert_allclose(turned, [[0, 1, 0], [1, 0, 0]], atol=1e-15)
    many = rotate(np.tile(V, (10_000, 1)), [0, 0, 1], 90.0, degrees=True)
    np.testing.assert_allclose(many[:6], rotate(V, [0, 0, 1], np.pi / 2), atol=1e-15)


@pytest.mark.parametrize(
    ("call", "advice"),
    [
        (lambda: R @ V, r"r\.apply\(points\)"),
        (lambda: R @ R, r"p \* q"),
        (lambda: V @ R, r"inverse=True"),
        (lambda: rotate(V, "z", 1.0), r"\[0, 0, 1\]"),
        (lambda: rotate(V, "w", 1.0), "axis is the text 'w'"),
        (lambda: Rotation.from_axis_angle("X", 1.0), r"\[1, 0, 0\]"),
    ],
)
def test_what_should_be_written_is_said(call: Callable[[], Any], advice: str) -> None:
    with pytest.raises(DTypeError, match=advice):
        call()


def test_scipys_rotation_meets_ours() -> None:
    s = pytest.importorskip("scipy.spatial.transform").Rotation.identity()
    for call in (lambda: R * s, lambda: s * R):
        with pytest.raises(DTypeError, match="from_scipy"):
            call()
