"""The geodesic median is the global minimum of the sum of angles, also where local minima abound."""

import numpy as np
import pytest

from rotation import Rotation, RotationError, geodesic_median

GRID = Rotation.super_fibonacci(10_000).as_quat()
SPREAD = [[0, 2, 1, -1], [-2, -1, 2, 1], [0, -2, -2, -1], [2, 1, -1, 1], [0, 0, -1, -1]]


def sums(x: np.ndarray, q: np.ndarray, w: np.ndarray) -> np.ndarray:
    """The weighted sums of angles at quaternions (m, 4)."""
    return 2.0 * np.arccos(np.minimum(np.abs(x @ q.T), 1.0)) @ w


def least_sum(q: np.ndarray, w: np.ndarray) -> float:
    """The least sum on a grid of 11°, refined around its best places by random steps of every size."""
    rng = np.random.default_rng(0)
    values = sums(GRID, q, w)
    best = np.concatenate([GRID[np.argsort(values)[:20]], q])
    for size in 0.1 * 0.5 ** np.arange(22):
        near = best[:, None] + size * rng.standard_normal((len(best), 30, 4))
        near = np.concatenate([best[:, None], near], axis=1)
        near /= np.linalg.norm(near, axis=-1, keepdims=True)
        values = sums(near.reshape(-1, 4), q, w).reshape(near.shape[:2])
        best = near[np.arange(len(best)), values.argmin(axis=1)]
    return float(sums(best, q, w).min())


def sum_at(m: Rotation, r: Rotation, w: np.ndarray) -> float:
    return float(w @ (m.inv() * r).magnitude())


def test_spread_sets_against_a_grid() -> None:
    rng = np.random.default_rng(1)
    for number in (5, 5, 5, 5, 5, 3, 4, 20):
        r, w = Rotation.random(number, seed=rng), rng.random(number) + 0.2
        own = sum_at(r.median(w), r, w)
        assert own == pytest.approx(least_sum(r.as_quat(), w), abs=1e-5)


def test_a_set_on_which_the_way_down_from_the_mean_ends_too_early() -> None:
    r = Rotation(SPREAD)
    assert sum_at(r.median(), r, np.ones(5)) == pytest.approx(8.388065747260887, abs=1e-12)
    both = Rotation.concatenate([r[None], Rotation.random((1, 5), seed=1)])
    assert both.median(axis=1)[0] == r.median()


def test_every_median_has_no_slope() -> None:
    """In no direction does the sum become less; at one of the rotations by its weight at least."""
    for seed in range(30):
        r = Rotation.random(6, seed=seed)
        m = r.median()
        away = (r * m.inv()).as_rotvec()
        angles = np.linalg.norm(away, axis=1)
        distant = angles > 1e-9
        pull = (away[distant] / angles[distant, None]).sum(axis=0)
        assert np.linalg.norm(pull) <= (~distant).sum() + 1e-9


def test_bounds_are_below_all_sums_in_a_box() -> None:
    rng = np.random.default_rng(3)
    q, w = Rotation.random(7, seed=rng).as_quat(), rng.random(7)
    boxes = geodesic_median._Boxes(np.arange(4), np.zeros((4, 3)), 1.0).divided().divided()
    for _ in range(3):
        centers = boxes.quaternions(np.zeros(3))
        bounds = geodesic_median._bounds(q, w, centers, boxes.radii(centers))
        for _ in range(40):
            inside = boxes.quaternions(rng.uniform(-1, 1, 3))
            assert (sums(inside, q, w) >= bounds.least - 1e-6).all()
            cells = geodesic_median._cells(inside @ q.T)
            assert all(a in (None, b) for a, b in zip(bounds.cell, cells, strict=True))
        boxes = boxes.selected(rng.integers(0, len(centers), 50)).divided()


def test_ties_and_only_ties_are_refused() -> None:
    half_turns = Rotation([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    with pytest.raises(RotationError, match="not determined"):
        half_turns.median()  # eight rotations are as near
    assert half_turns.median([1, 1, 4, 1]) == half_turns[2]
    with pytest.raises(RotationError, match="not determined"):
        half_turns[:2].median()  # each on the way between them, and there are two
    r, w = Rotation.from_euler("Z", [0, 150, 210], degrees=True), [1.0, 3**-0.5, 3**-0.5]
    with pytest.raises(RotationError, match="not determined"):
        r.mean(w)
    assert r.median(w) == r[0]
    assert half_turns[[0, 0, 1, 2, 3]].median() == half_turns[0]  # on the planes of three others
    for seed in range(8):  # none of these has a reason to fail
        Rotation.random(2 + seed, seed=seed).median()
    assert np.isnan(
        Rotation.concatenate([half_turns, Rotation([[np.nan] * 4])]).median().as_quat()
    ).all()
    assert half_turns.median([0, 1, 0, 0]) == half_turns[1]
