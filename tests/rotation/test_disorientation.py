"""The smallest of equivalent rotations: by brute force, by known largest angles, by invariance, with ties."""

import math

import numpy as np
import pytest

from rotation import DTypeError, Rotation, RotationError
from tests.subcases import first_quick

ONE = Rotation.identity()
# Rodrigues vectors of a corner of each fundamental zone, and the largest angle in degrees as it is printed.
CORNERS = {
    "D3": ([1.0, math.tan(math.pi / 6), math.tan(math.pi / 6)], 104.478),
    "D6": ([1.0, math.tan(math.pi / 12), math.tan(math.pi / 12)], 93.841),
    "O": ([math.sqrt(2) - 1, math.sqrt(2) - 1, 3 - 2 * math.sqrt(2)], 62.7994),
    "T": ([1.0, 0.0, 0.0], 90.0),
}


def group(name: str) -> Rotation:
    return Rotation.create_group(name)


def brute(p: Rotation, left: Rotation, right: Rotation) -> np.ndarray:
    """All l·p·r, (n, m·k, 4), w ≥ 0."""
    every = (left.reshape(-1, 1, 1) * p.reshape(1, -1, 1)) * right.reshape(1, 1, -1)
    q = every.as_quat(canonical=True)
    return np.asarray(np.moveaxis(q, 1, 0).reshape(p.size, -1, 4))


@pytest.mark.parametrize(
    ("left", "right"),
    first_quick([("O", "O"), ("D6", "O"), ("C1", "D4"), ("D3", "D3"), ("T", "I"), ("C2", "C3")], 3),
)
def test_by_brute_force(left: str, right: str) -> None:
    p = Rotation.random(300, seed=3)
    found = ONE.disorientation(p, left, right).as_quat()
    candidates = brute(p, group(left), group(right))
    for q, every in zip(found, candidates, strict=True):
        near = every[every[:, 0] > every[:, 0].max() - 1e-12]
        near = near[near[:, 1] > near[:, 1].max() - 1e-12]
        near = near[near[:, 2] > near[:, 2].max() - 1e-12]
        best = near[np.argmax(near[:, 3])]
        np.testing.assert_allclose(q, best, atol=1e-14)


@pytest.mark.parametrize(
    ("name", "most"), [("D3", 104.478), ("D6", 93.841), ("O", 62.7994), ("I", 44.478)]
)
def test_the_largest_angles(name: str, most: float) -> None:
    angles = ONE.disorientation(Rotation.super_fibonacci(60_000), name).magnitude(degrees=True)
    assert most - 1.5 < angles.max() < most + 1e-3


@pytest.mark.parametrize("name", ["D3", "D6", "O"])
def test_corners_where_many_are_as_small(name: str) -> None:
    rodrigues, most = CORNERS[name]
    corner = Rotation([1.0, *rodrigues])
    assert math.isclose(corner.magnitude(degrees=True), most, abs_tol=5e-4)
    g = group(name)
    every = (g.reshape(-1, 1) * corner) * g.reshape(1, -1)
    found = ONE.disorientation(every, name)
    assert np.allclose(found.magnitude(), corner.magnitude(), atol=1e-14)
    assert found.approx_equal(found[0, 0], 1e-13).all()  # equivalent ones get equal answers


@pytest.mark.parametrize("name", first_quick(["D3", "D6", "O", "T", "C4", "D2", "I"], 6))
def test_equivalent_ones_get_equal_answers(name: str) -> None:
    rng = np.random.default_rng(1)
    g, p = group(name), Rotation.random(500, seed=2)
    left, right = (g[rng.integers(0, len(g), 500)] for _ in range(2))
    first, second = (ONE.disorientation(q, name) for q in (p, left * p * right))
    assert first.approx_equal(second, 1e-13).all()
    # elements of the group themselves, twins and half turns tie everywhere
    twin = Rotation.from_rotvec(np.full(3, 60 / math.sqrt(3)), degrees=True)
    assert np.all(ONE.disorientation(g, name).magnitude() < 1e-7)
    for q in (twin, Rotation.from_rotvec([0, 0.6 * math.pi, 0.8 * math.pi])):
        found = ONE.disorientation((g.reshape(-1, 1) * q) * g.reshape(1, -1), name)
        assert found.approx_equal(found[0, 0], 1e-13).all()


def test_crystals_and_their_worlds() -> None:
    """What is outside, p and q turned alike, changes nothing; nor do other axes of one crystal."""
    p, q, world = (Rotation.random(100, seed=n) for n in range(3))
    g = group("O")
    found = p.disorientation(q, "O", "D6")
    assert (world * p).disorientation(world * q, "O", "D6").approx_equal(found, 1e-13).all()
    assert (p * g[5]).disorientation(q * group("D6")[7], "O", "D6").approx_equal(found, 1e-13).all()
    assert p.disorientation(q, g, group("D6")).approx_equal(found, 1e-15).all()


def test_large_groups_and_no_groups() -> None:
    p = Rotation.random(50, seed=1)
    angle = ONE.disorientation(p, "D100").magnitude()
    assert np.allclose(angle, p.reduce(group("D100"), group("D100")).magnitude(), atol=1e-13)
    with pytest.raises(RotationError, match="not a group"):
        ONE.disorientation(p, Rotation.random(3, seed=0))
    with pytest.raises(RotationError, match="group 'X'"):
        ONE.disorientation(p, "X")
    with pytest.raises(DTypeError, match="group"):
        ONE.disorientation(p, 4)  # type: ignore[arg-type]
    spoilt = Rotation([[np.nan, 0, 0, 0], [1, 0, 0, 0]])
    assert np.isnan(ONE.disorientation(spoilt, "O").as_quat()).all(axis=1).tolist() == [True, False]
