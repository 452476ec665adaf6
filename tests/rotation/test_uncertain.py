"""Covariance: against samples, against formulas on paper, and against pytransform3d where it is."""

from typing import Any

import numpy as np
import pytest

from rotation import DTypeError, RigidTransform, Rotation, RotationError, Uncertain

KINDS: dict[int, Any] = {3: Rotation, 6: RigidTransform}
MANY = 200_000


def some(n: int, size: float, seed: int) -> Uncertain:
    rng = np.random.default_rng(seed)
    a = rng.standard_normal((n, n))
    return Uncertain(KINDS[n].exp(rng.standard_normal(n)), size * a @ a.T / n)


def spread(samples: Rotation | RigidTransform, mean: Rotation | RigidTransform) -> np.ndarray:
    apart = samples.minus(mean, "left")
    return np.asarray(apart.T @ apart / len(apart))


def off(found: np.ndarray, wanted: np.ndarray) -> float:
    return float(np.linalg.norm(found - wanted) / np.linalg.norm(wanted))


@pytest.mark.parametrize("n", KINDS)
def test_a_product_to_fourth_order(n: int) -> None:
    a, b = some(n, 0.08, 1), some(n, 0.08, 2)
    product = a * b
    rng = np.random.default_rng(3)
    seen = spread(a.sample(MANY, rng) * b.sample(MANY, rng), product.mean)
    onto = a.mean.adjoint()
    second = a.covariance + onto @ b.covariance @ onto.T
    assert off(product.covariance, seen) < 0.5 * off(second, seen)


def test_headings_on_paper() -> None:
    """A unit step after a turn by N(0, s²): the place across is sin, along 1 − cos; E sin² = s² − s⁴ + …"""
    s = 0.1
    turn = Uncertain(RigidTransform.identity(), np.diag([0, 0, s**2, 0, 0, 0]))
    step = Uncertain(RigidTransform.from_translation([1, 0, 0]), np.zeros((6, 6)))
    # exp(ξ)·mean: on the left a turn leaves the place of the mean in the tangent at the origin.
    assert np.allclose((turn * step).covariance, turn.covariance)
    across = (step * turn).covariance
    assert np.isclose(across[4, 4], s**2)
    assert np.isclose(across[2, 4], -(s**2))


def test_round_ones_on_paper() -> None:
    """Of covariances a and b times 1, E ad(ξ)² is −2a and E ad(ξ)·b·ad(ξ)ᵀ is 2a·b: a + b − a·b/6."""
    r, one = Rotation.random(seed=1), np.eye(3)
    found = (Uncertain(r, 0.2 * one) * Uncertain(r, 0.3 * one)).covariance
    np.testing.assert_allclose(found, (0.2 + 0.3 - 0.2 * 0.3 / 6) * one, atol=1e-15)


@pytest.mark.parametrize("n", KINDS)
def test_inverse_and_sides(n: int) -> None:
    a = some(n, 0.1, 4)
    back = a.inv()
    np.testing.assert_allclose(back.right_covariance, a.covariance, atol=1e-13)
    np.testing.assert_allclose(back.inv().covariance, a.covariance, atol=1e-13)
    again = Uncertain(a.mean, a.right_covariance, side="right")
    np.testing.assert_allclose(again.covariance, a.covariance, atol=1e-13)
    seen = spread(a.sample(MANY, 5).inv(), back.mean)
    assert off(back.covariance, seen) < 0.02


@pytest.mark.parametrize("t", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("n", KINDS)
def test_interpolation(n: int, t: float) -> None:
    a, b = some(n, 1e-3, 6), some(n, 1e-3, 7)
    rng = np.random.default_rng(8)
    p, q = a.sample(MANY, rng), b.sample(MANY, rng)
    found = a.interpolate(b, t)
    seen = spread(p.plus(t * q.minus(p, "left"), "left"), found.mean)
    assert off(found.covariance, seen) < 0.03
    with pytest.raises(DTypeError):
        some(3, 1, 0).interpolate(some(6, 1, 0), t)


@pytest.mark.parametrize("n", KINDS)
def test_fusion_is_the_most_likely(n: int) -> None:
    truth = some(n, 1, 9).mean
    estimates = []
    for seed in (1, 2, 3):
        p = some(n, 0.02, seed).covariance
        estimates.append(Uncertain(Uncertain(truth, p).sample(seed=seed), p))
    fused = Uncertain.fuse(estimates)

    def cost(x: Rotation | RigidTransform) -> float:
        es = [(m.mean.minus(x, "left"), m.covariance) for m in estimates]
        return float(sum(e @ np.linalg.solve(p, e) for e, p in es))

    steps = np.random.default_rng(0).standard_normal((50, n)) * 1e-3
    least = cost(fused.mean)
    assert all(cost(fused.mean.plus(step, "left")) > least for step in steps)
    # the curvature of the cost is twice the information
    for step in np.eye(n) * 1e-3:
        bend = (
            cost(fused.mean.plus(step, "left")) + cost(fused.mean.plus(-step, "left")) - 2 * least
        )
        assert np.isclose(bend / 2, step @ np.linalg.solve(fused.covariance, step), rtol=0.1)


def test_fusion_of_equals_and_of_one() -> None:
    a = some(6, 0.1, 3)
    one, two = Uncertain.fuse([a]), Uncertain.fuse([a, a])
    np.testing.assert_allclose(one.covariance, a.covariance, atol=1e-13)
    np.testing.assert_allclose(two.covariance, a.covariance / 2, atol=1e-13)
    assert two.mean.approx_equal(a.mean, 1e-12)


@pytest.mark.parametrize("n", KINDS)
def test_samples_give_it_back(n: int) -> None:
    a = some(n, 0.05, 10)
    found = Uncertain.from_samples(a.sample(MANY, seed=1))
    assert off(found.covariance, a.covariance) < 0.03
    assert a.sample((2, 5), seed=1).shape == (2, 5)
    assert (a.sample(4, seed=1) == a.sample(4, rng=1)).all()


def test_arrays_of_them() -> None:
    a = Uncertain(Rotation.random((4,), seed=1), np.eye(3) * 0.01)
    b = some(3, 0.01, 2)
    product = a * b
    assert product.covariance.shape == (4, 3, 3)
    one = Uncertain(a.mean[2], np.eye(3) * 0.01) * b
    np.testing.assert_allclose(product.covariance[2], one.covariance, atol=1e-15)
    fused = Uncertain.fuse([a, Uncertain(a.mean, np.eye(3) * 0.03)])
    np.testing.assert_allclose(fused.covariance, np.broadcast_to(np.eye(3) * 0.0075, (4, 3, 3)))
    assert a.sample(7, seed=0).shape == (7, 4)


def test_what_is_no_covariance() -> None:
    r = Rotation.identity()
    for bad, words in (
        (np.eye(6), "expected"),
        (np.triu(np.ones((3, 3))), "not symmetric"),
        (np.diag([1, 1, -1]), "negative variance"),
    ):
        with pytest.raises(RotationError, match=words):
            Uncertain(r, bad)
    with pytest.raises(DTypeError, match="mean"):
        Uncertain([1, 0, 0, 0], np.eye(3))  # type: ignore[arg-type]
    exact = Uncertain(r, np.diag([1, 1, 0]))
    with pytest.raises(RotationError, match="singular"):
        Uncertain.fuse([exact, exact])
    with pytest.raises(RotationError, match="at least one"):
        Uncertain.fuse([])
    with pytest.raises(RotationError, match="two samples"):
        Uncertain.from_samples(Rotation.identity(1))


def test_as_pytransform3d() -> None:
    """Its order of exponential coordinates is ours; its "global" is our left."""
    theirs = pytest.importorskip("pytransform3d.uncertainty")
    a, b = some(6, 0.05, 1), some(6, 0.05, 2)
    mean, covariance = theirs.concat_globally_uncertain_transforms(
        b.mean.as_matrix(), b.covariance, a.mean.as_matrix(), a.covariance
    )
    product = a * b
    np.testing.assert_allclose(mean, product.mean.as_matrix(), atol=1e-12)
    np.testing.assert_allclose(covariance, product.covariance, atol=1e-12)
    means = np.array([m.mean.as_matrix() for m in (a, a)])
    means[1] = a.mean.plus([0.1, 0, 0.1, 0.1, 0, 0], "left").as_matrix()
    fused = Uncertain.fuse(
        [
            Uncertain(RigidTransform(means[0]), a.covariance),
            Uncertain(RigidTransform(means[1]), b.covariance),
        ]
    )
    mean, covariance, _ = theirs.pose_fusion(means, np.array([a.covariance, b.covariance]))
    np.testing.assert_allclose(mean, fused.mean.as_matrix(), atol=1e-5)
