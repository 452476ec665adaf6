"""Similarities, geodesic medians, even grids, poses that face a point."""

import math
from collections.abc import Callable

import numpy as np
import pytest

from rotation import Rotation, RotationError, align, align_points, align_similarity, look_at

RNG = np.random.default_rng(11)


def test_a_similarity_is_found_again() -> None:
    r, v = Rotation.random((4,), seed=1), RNG.standard_normal((4, 9, 3))
    target = 2.5 * r[:, None].apply(v) + np.array([1, 2, 3])
    found = align_similarity(v, target)
    np.testing.assert_allclose(found.scale, 2.5)
    np.testing.assert_allclose(found.translation, np.tile([1.0, 2, 3], (4, 1)), atol=1e-13)
    assert found.rotation.approx_equal(r, 1e-13).all()
    assert np.all(found.rssd < 1e-13)
    one = align_similarity(v[0], target[0])
    np.testing.assert_allclose(one.apply(v[0]), target[0], atol=1e-13)


def test_no_similarity_near_the_best_is_better() -> None:
    a, b, w = RNG.standard_normal((8, 3)), RNG.standard_normal((8, 3)), RNG.random(8)
    best = align_similarity(a, b, w)

    def cost(scale: float, turn: Rotation, shift: np.ndarray) -> float:
        return float(np.sqrt((w[:, None] * (b - scale * turn.apply(a) - shift) ** 2).sum()))

    own = (best.scale, best.rotation, best.translation)
    assert math.isclose(cost(*own), best.rssd)
    for _ in range(50):
        s, v, t = RNG.standard_normal(7)[[0]], RNG.standard_normal(3), RNG.standard_normal(3)
        near = (best.scale + 1e-4 * s[0], best.rotation.plus(1e-4 * v), best.translation + 1e-4 * t)
        assert cost(*near) > best.rssd
    far = align_similarity(a * 1e-200, b * 1e100, w)
    assert math.isclose(far.scale, best.scale * 1e300, rel_tol=1e-12)


def test_no_similarity_of_one_place() -> None:
    with pytest.raises(RotationError):
        align_similarity(np.ones((4, 3)), RNG.standard_normal((4, 3)))


def test_the_median_is_where_the_angles_sum_to_least() -> None:
    r = Rotation.random(9, seed=4) ** 0.5
    w = RNG.random(9) + 0.1
    found = r.median(w)

    def cost(x: Rotation) -> float:
        return float((w * (x.inv() * r).magnitude()).sum())

    near = found.plus(1e-4 * RNG.standard_normal((100, 3)))
    assert all(cost(x) >= cost(found) for x in near)


def test_the_median_is_one_of_them_exactly_and_robust() -> None:
    base = Rotation.from_euler("ZYX", [0.3, 0.2, 0.1])
    good = base.plus(0.001 * RNG.standard_normal((20, 3)))
    both = Rotation.concatenate([good, Rotation.random(8, seed=1)])
    assert (both.median().inv() * base).magnitude() < 0.002 < (both.mean().inv() * base).magnitude()
    line = Rotation.from_euler("Z", [0.0, 0.1, 0.2, 0.3, 3.0])
    assert line.median() == line[2]
    heavy = Rotation.random(5, seed=2)
    assert heavy.median([1, 1, 9, 1, 1]) == heavy[2]
    assert Rotation.concatenate([heavy[0]] * 3).median() == heavy[0]
    # two at 120° pull the third with almost its own weight: the iteration alone would creep
    ways = [[0, 0, 0], [0.1, 0, 0], [0.1 * math.cos(2.1), 0.1 * math.sin(2.1), 0]]
    assert Rotation.from_rotvec(ways).median() == Rotation.identity()
    ways[2] = [0.1 * math.cos(2.09), 0.1 * math.sin(2.09), 0]  # and a little more: beside it
    assert Rotation.from_rotvec(ways).median().magnitude() < 0.01
    many = Rotation.random((6, 7), seed=3) ** 0.3
    assert many.median(axis=1).shape == (6,)
    assert many.median(axis=1)[2].approx_equal(many[2].median(), 1e-12)
    with pytest.raises(RotationError, match="negative"):
        line.median([-1, 1, 1, 1, 1])


def test_even_grids() -> None:
    """The largest gap between n even rotations is well below that between random ones."""
    probe = Rotation.random(2000, seed=5).as_quat()

    def gap(r: Rotation) -> float:
        return float(2 * np.arccos(np.abs(probe @ r.as_quat().T).max(axis=1).min()))

    even, chance = (gap(r) for r in (Rotation.super_fibonacci(4000), Rotation.random(4000, seed=6)))
    assert even < 0.26
    assert even < 0.75 * chance
    assert Rotation.super_fibonacci(0).shape == (0,)
    assert np.allclose(np.linalg.norm(Rotation.super_fibonacci(100).as_quat(), axis=1), 1)
    psi = 1.533751168755204288118041
    assert math.isclose(psi**4, psi + 4)
    with pytest.raises(RotationError, match="whole number"):
        Rotation.super_fibonacci(2.5)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("convention", "forward", "up"),
    [
        ("opengl", [0, 0, -1], [0, 1, 0]),
        ("opencv", [0, 0, 1], [0, -1, 0]),
        ("ros", [1, 0, 0], [0, 0, 1]),
    ],
)
def test_facing_a_point(convention: str, forward: list[int], up: list[int]) -> None:
    eye, target = RNG.standard_normal((2, 20, 3))
    pose = look_at(eye, target, convention=convention)
    ahead = target - eye
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    np.testing.assert_allclose(pose.rotation.apply(forward), ahead, atol=1e-13)
    above = pose.rotation.apply(up)
    assert np.all(above[:, 2] > 0)  # as near the world's up as can be: no roll
    np.testing.assert_allclose(np.cross(above, ahead)[:, 2], 0, atol=1e-13)
    np.testing.assert_allclose(pose.inv().apply(eye), 0, atol=1e-14)


def test_what_cannot_be_faced() -> None:
    for eye, target, words in (
        ([1, 1, 1], [1, 1, 1], "where the eye is"),
        ([0, 0, 0], [0, 0, 5], "straight up"),
    ):
        with pytest.raises(RotationError, match=words):
            look_at(eye, target)
    with pytest.raises(RotationError, match="left-handed"):
        look_at([0, 0, 0], [1, 0, 0], convention="unity")
    with pytest.raises(RotationError, match="convention"):
        look_at([0, 0, 0], [1, 0, 0], convention="nowhere")


def strided(x: np.ndarray) -> np.ndarray:
    wide = np.full(tuple(2 * n for n in x.shape), np.nan)
    every = tuple(slice(None, None, 2) for _ in x.shape)
    wide[every] = x
    return wide[every]


@pytest.mark.parametrize("count", [2, 7, 33, 1000])
def test_bits_do_not_depend_on_how_weights_and_vectors_lie(count: int) -> None:
    rng = np.random.default_rng(count)
    r, weights = Rotation.random(count, rng=rng), rng.uniform(0.1, 1.0, count)
    source, noise = rng.normal(size=(2, count, 3))
    target = r[0].apply(source) + 0.1 * noise
    fits: list[Callable[[np.ndarray, np.ndarray], object]] = [
        lambda v, w: r.mean(w).as_quat(),
        lambda v, w: align(v, target, w)[0].as_quat(),
        lambda v, w: align(target, v, w)[1],
        lambda v, w: align_points(v, target, w)[1],
        lambda v, w: align_similarity(v, target, w).scale,
    ]
    if count < 100:
        fits.append(lambda v, w: r.median(w).as_quat())
    others: list[Callable[[np.ndarray], np.ndarray]] = [
        lambda x: x.astype(">f8"),
        lambda x: x[::-1].copy()[::-1],
        np.asfortranarray,
        strided,
    ]
    for fit in fits:
        usual = np.asarray(fit(source, weights)).tobytes()
        for other in others:
            assert np.asarray(fit(other(source), weights)).tobytes() == usual
            assert np.asarray(fit(source, other(weights))).tobytes() == usual
