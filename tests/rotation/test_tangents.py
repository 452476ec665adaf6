"""Hat and vee, Jacobians, adjoints, plus and minus: against matrix exponentials and by their laws."""

from typing import Any

import numpy as np
import pytest

from rotation import (
    DTypeError,
    RigidTransform,
    Rotation,
    RotationError,
    ad,
    hat,
    inverse_left_jacobian,
    inverse_right_jacobian,
    left_jacobian,
    right_jacobian,
    vee,
)
from tests.subcases import subcases

expm = pytest.importorskip("scipy.linalg").expm
RNG = np.random.default_rng(29)
KINDS: dict[int, Any] = {3: Rotation, 6: RigidTransform}


def tangents(n: int, length: float = 1.0, count: int = 20) -> np.ndarray:
    v = RNG.standard_normal((count, n))
    v[:, :3] *= length / np.linalg.norm(v[:, :3], axis=1, keepdims=True)
    return v


@pytest.mark.parametrize("n", KINDS)
def test_hat_is_the_generator_of_the_matrix(n: int) -> None:
    for v in tangents(n, 2.5):
        np.testing.assert_allclose(KINDS[n].exp(v).as_matrix(), expm(hat(v)), atol=1e-13)
        assert np.array_equal(vee(hat(v)), v)


def test_vee_refuses_what_hat_does_not_make() -> None:
    with pytest.raises(RotationError, match="row 1"):
        vee(np.stack([hat([1, 2, 3]), np.eye(3)]))
    spoilt = hat([1, 2, 3, 4, 5, 6])
    spoilt[3, 3] = 1.0
    with pytest.raises(RotationError, match="hat does not make it"):
        vee(spoilt)
    with pytest.raises(RotationError, match=r"\(2, 2\)"):
        vee(np.eye(2))
    with pytest.raises(RotationError, match="rigid motions"):
        hat([1, 2, 3, 4])


@pytest.mark.parametrize("n", KINDS)
def test_ad_is_the_bracket_and_its_exponential_the_adjoint(n: int) -> None:
    for x, y in zip(tangents(n), tangents(n), strict=True):
        bracket = hat(x) @ hat(y) - hat(y) @ hat(x)
        np.testing.assert_allclose(hat(ad(x) @ y), bracket, atol=1e-14)
        np.testing.assert_allclose(KINDS[n].exp(x).adjoint(), expm(ad(x)), atol=1e-13)


@subcases("n", KINDS)
@subcases("length", [0.0, 1e-300, 1e-9, 0.1, 0.999999, 1.000001, 2.0, 3.1, 6.0, 40.0])
def test_jacobians_are_the_integral_of_adjoints(n: int, length: float) -> None:
    """J = ∫ exp(s·ad) ds, which is a block of the exponential of a matrix twice as large."""
    for v in tangents(n, length, 5):
        whole = np.zeros((2 * n, 2 * n))
        whole[:n, :n], whole[:n, n:] = ad(v), np.eye(n)
        wanted = expm(whole)[:n, n:]
        np.testing.assert_allclose(left_jacobian(v), wanted, atol=2e-12)
        if length < 6.0:
            np.testing.assert_allclose(inverse_left_jacobian(v) @ wanted, np.eye(n), atol=1e-12)


@pytest.mark.parametrize("n", KINDS)
def test_left_and_right(n: int) -> None:
    v = tangents(n, 2.0)
    onto = KINDS[n].exp(v).adjoint() @ right_jacobian(v)
    np.testing.assert_allclose(onto, left_jacobian(v), atol=1e-14 * 20)
    both = inverse_right_jacobian(v) @ right_jacobian(v)
    np.testing.assert_allclose(both, np.broadcast_to(np.eye(n), both.shape), atol=1e-13)


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("n", KINDS)
def test_plus_and_minus(n: int, side: str) -> None:
    p, x = KINDS[n].exp(tangents(n, 2.0)), tangents(n, 1.0)
    q = p.plus(x, side)
    np.testing.assert_allclose(q.minus(p, side), x, atol=1e-13)
    step = KINDS[n].exp(x)
    assert (q == (p * step if side == "right" else step * p)).all()
    # the same motion, seen from the world and from the body
    np.testing.assert_allclose(
        p.plus(x).minus(p, "left"), (p.adjoint() @ x[..., None])[..., 0], atol=1e-13
    )
    np.testing.assert_allclose(KINDS[n].exp(p.log()).minus(p), 0 * x, atol=1e-13)


def test_sides_and_kinds_that_do_not_fit() -> None:
    r, t = Rotation.identity(), RigidTransform.identity()
    with pytest.raises(RotationError, match="left"):
        r.plus([0, 0, 1], side="body")
    with pytest.raises(DTypeError, match="RigidTransform"):
        t.minus(r)
    with pytest.raises(DTypeError, match="Rotation"):
        r.minus(r.as_quat())
