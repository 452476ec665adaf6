"""Means of rotations, and the rotations that align vectors and points."""

from collections.abc import Callable

import numpy as np
import pytest

from rotation import Rotation, RotationError, align, align_points, align_similarity


def loss(r: Rotation, a: np.ndarray, b: np.ndarray, w: np.ndarray) -> float:
    return float(np.sum(w * np.sum((a - r.apply(b)) ** 2, axis=-1)))


# Means


def test_the_mean_minimises_the_chordal_distance() -> None:
    r, w = Rotation.random(20, rng=1), np.random.default_rng(1).uniform(0, 2, 20)

    def cost(x: Rotation) -> float:
        squares = np.sum((x.as_matrix() - r.as_matrix()) ** 2, axis=(1, 2))
        return float(np.sum(w * squares))

    best = r.mean(w)
    for step in np.random.default_rng(2).standard_normal((50, 3)) * 1e-3:
        assert cost(best * Rotation.from_rotvec(step)) > cost(best)


def test_means_of_symmetric_sets() -> None:
    tilts = Rotation.from_rotvec([[0.4, 0, 0], [-0.4, 0, 0], [0, 0.1, 0], [0, -0.1, 0]])
    at = Rotation.random(rng=3)
    assert (at * tilts).mean().approx_equal(at, atol=1e-15)
    assert Rotation(-at.as_quat()).reshape(1).mean().approx_equal(at, atol=1e-15)
    signs = np.array([1, -1, 1, -1])[:, None]
    assert Rotation(signs * (at * tilts).as_quat()).mean().approx_equal(at, atol=1e-15)
    weighted = Rotation.from_rotvec([[0.0, 0, 0], [0, 0, 1.0]]).mean([1, 0])
    assert weighted.magnitude() < 1e-15


def test_means_along_axes() -> None:
    r = Rotation.random((2, 3, 4), rng=4)
    assert r.mean().shape == ()
    assert r.mean(axis=1).shape == (2, 4)
    assert r.mean(axis=(0, -1)).shape == (3,)
    assert r.mean(axis=()).approx_equal(r, atol=1e-15).all()
    assert r.mean(axis=1)[1, 2].approx_equal(r[1, :, 2].mean(), atol=1e-14)
    assert r.mean(np.ones(4)).approx_equal(r.mean(), atol=1e-14)
    assert r[0, 0, 0].mean().approx_equal(r[0, 0, 0], atol=1e-15)


def test_means_that_are_none() -> None:
    r = Rotation.random(3, rng=5)
    half_turns = Rotation([[1, 0, 0, 0], [0, 1, 0, 0]])
    for fails in (
        lambda: r.mean([1, -1, 1]),
        lambda: r.mean([0, 0, 0]),
        lambda: r.mean([1, 1]),
        lambda: r.mean(axis=1),
        lambda: r.mean(axis=(0, 0)),
        lambda: r[:0].mean(),
        half_turns.mean,
        Rotation(np.eye(4)).mean,
    ):
        with pytest.raises(RotationError):
            fails()
    assert half_turns.mean([2, 1]) == Rotation.identity()


# Alignment


@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
def test_what_was_turned_is_found(size: float) -> None:
    rng = np.random.default_rng(6)
    r = Rotation.random(100, rng=6)
    source = size * rng.standard_normal((100, 5, 3))
    target = r[:, None].apply(source)
    found, rssd = align(source, target)
    assert found.shape == rssd.shape == (100,)
    assert found.approx_equal(r, atol=1e-13).all()
    assert rssd.max() < 1e-13 * size
    two, _ = align(source[:, :2], target[:, :2])  # two directions determine a rotation
    assert two.approx_equal(r, atol=1e-11).all()


@pytest.mark.parametrize("size", [1e-160, 1e-60, 1.0, 1e60, 1e150])
@pytest.mark.parametrize("weighted", [False, True])
def test_one_set_is_aligned_as_one_of_many(size: float, weighted: bool) -> None:
    rng = np.random.default_rng(11)
    source, target = rng.standard_normal((2, 20, 7, 3))
    weights = rng.uniform(0.1, 2.0, (20, 7)) if weighted else None
    many, rests = align(size * source, size * target, weights)
    for n in range(20):
        one, rest = align(size * source[n], size * target[n], weights[n] if weighted else None)
        assert one.approx_equal(many[n], atol=1e-13)
        assert rest == pytest.approx(rests[n], rel=1e-13)


@pytest.mark.parametrize("size", [1e-160, 1.0, 1e150])
def test_the_mean_of_all_is_that_of_one_axis(size: float) -> None:
    rng = np.random.default_rng(12)
    r, w = Rotation.random((1, 9), rng=rng), size * rng.uniform(0.1, 2.0, 9)
    for weights in (None, w):
        expected = r.mean(weights, axis=1)[0]
        assert r[0].mean(weights).approx_equal(expected, atol=1e-14)
        assert r[0].mean(weights).as_quat()[np.flatnonzero(expected.as_quat())[0]] > 0.0


def test_align_vectors_is_scipys_order() -> None:
    r = Rotation.random(rng=7)
    b = np.random.default_rng(7).standard_normal((6, 3))
    found, rssd = Rotation.align_vectors(r.apply(b), b)
    assert found.approx_equal(r, atol=1e-14)
    assert rssd < 1e-14


def test_the_loss_is_least() -> None:
    rng = np.random.default_rng(8)
    for _ in range(20):
        a, b = rng.standard_normal((2, 6, 3))
        w = rng.uniform(0, 3, 6)
        best, rssd = align(b, a, w)
        assert rssd**2 == pytest.approx(loss(best, a, b, w), rel=1e-12)
        for step in rng.standard_normal((30, 3)) * 1e-3:
            assert loss(best * Rotation.from_rotvec(step), a, b, w) > rssd**2
        for other in Rotation.random(50, rng=rng):
            assert loss(other, a, b, w) > rssd**2


def test_mirror_images_are_turned_not_reflected() -> None:
    b = np.random.default_rng(9).standard_normal((8, 3))
    best, rssd = align(b, b * [1, 1, -1])
    assert np.linalg.det(best.as_matrix()) == pytest.approx(1)
    assert rssd > 0.1


def test_one_direction_takes_the_shortest_turn() -> None:
    r, rssd = align([0, 0, 2], [0, 3, 0])
    assert r.as_rotvec() == pytest.approx([-np.pi / 2, 0, 0])
    assert rssd == pytest.approx(1)
    r, _ = align([[0, 0, 1], [0, 0, -2.0]], [[1, 0, 0], [-2.0, 0, 0]])
    assert r.as_rotvec() == pytest.approx([0, np.pi / 2, 0])
    r, rssd = Rotation.align_vectors([0, 0, 1], [0, 0, -1])
    assert r.magnitude() == np.pi
    assert rssd == pytest.approx(0, abs=1e-15)


def test_points_are_aligned_with_their_centres() -> None:
    rng = np.random.default_rng(10)
    r, t = Rotation.random(rng=10), np.array([10.0, -20, 5])
    source = rng.standard_normal((30, 3)) + 100
    w = rng.uniform(0.5, 2, 30)
    found, shift, rssd = align_points(source, r.apply(source) + t, w)
    assert found.approx_equal(r, atol=1e-13)
    assert shift == pytest.approx(t, abs=1e-11)
    assert rssd < 1e-12
    noisy = r.apply(source) + t + 0.1 * rng.standard_normal((30, 3))
    found, shift, rssd = align_points(source, noisy, w)
    rest = noisy - found.apply(source) - shift
    assert rssd == pytest.approx(np.sqrt(np.sum(w[:, None] * rest**2)))
    assert np.sum(w[:, None] * rest, axis=0) == pytest.approx(0, abs=1e-10)


def test_nan_spoils_its_own_set() -> None:
    b = np.random.default_rng(11).standard_normal((3, 4, 3))
    a = Rotation.random((3, 1), rng=11).apply(b)
    a[1, 2, 0] = np.nan
    r, rssd = align(b, a)
    assert np.isnan(r.as_quat()[1]).all()
    assert np.isnan(rssd).tolist() == [False, True, False]
    assert np.isfinite(r.as_quat()[[0, 2]]).all()


@pytest.mark.parametrize(
    "call",
    [
        lambda: align(np.ones((2, 3)), np.ones((3, 3))),
        lambda: align(np.ones((2, 2)), np.ones((2, 2))),
        lambda: align(np.zeros((2, 3)), np.ones((2, 3))),
        lambda: align(np.ones((2, 3)), np.ones((2, 3)), [0, 0]),
        lambda: align(np.ones((2, 3)), np.ones((2, 3)), [1, -1]),
        lambda: align(np.ones((2, 3)), np.ones((2, 3)), [1, 1, 1]),
        lambda: align(np.eye(3), -np.eye(3)),
        lambda: align_points(np.eye(3), np.eye(3), [0, 0, 0]),
    ],
)
def test_alignments_that_are_not_determined(call: Callable[[], object]) -> None:
    with pytest.raises(RotationError):
        call()


@pytest.mark.parametrize("wrong", [1e308, 1e200, np.nan, np.inf])
@pytest.mark.parametrize("stacked", [True, False])
def test_a_pair_of_weight_0_has_no_influence(wrong: float, stacked: bool) -> None:
    a = np.random.default_rng(3).standard_normal((2, 5, 3))
    r = Rotation.random(2, rng=4)
    b, w = np.stack([q.apply(v) for q, v in zip(r, a, strict=True)]), np.ones((2, 5))
    w[1, 2], a[1, 2], b[1, 2] = 0.0, wrong, -wrong
    if not stacked:
        a, b, w, r = a[1], b[1], w[1], r[1]
    found = [align(a, b, w)[0], align_points(a, b, w)[0], align_similarity(a, b, w).rotation]
    for q in found:
        assert (q * r.inv()).magnitude() == pytest.approx(0.0, abs=1e-7)
