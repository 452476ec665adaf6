"""Slerp and squad, pointwise and through keyframes."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rotation import Rotation, RotationError, Slerp, Squad, slerp, squad
from tests.subcases import subcases


def near(p: Rotation, q: Rotation, atol: float = 1e-14) -> bool:
    return bool(np.all(p.approx_equal(q, atol=atol)))


def rates(curve: Slerp, t: float, h: float) -> np.ndarray:
    """The angular velocities just before and just after t."""
    before = (curve(t - h).inv() * curve(t)).as_rotvec() / h
    after = (curve(t).inv() * curve(t + h)).as_rotvec() / h
    return np.array([before, after])


def test_slerp_ends_and_goes_on_evenly() -> None:
    p, q = Rotation.random((2, 500), rng=1)
    assert near(slerp(p, q, 0.0), p)
    assert near(slerp(p, q, 1.0), q)
    for t in (0.25, 0.5, -1.0, 1.5):
        step = p.inv() * slerp(p, q, t)
        assert near(step, (p.inv() * q) ** t, 1e-14)
    assert near(slerp(p, q, 0.3), slerp(q, p, 0.7), 1e-13)


@pytest.mark.parametrize("shape", [(), (3,), (500,)])
def test_between_a_rotation_and_itself_lies_nothing_else(shape: tuple[int, ...]) -> None:
    p = Rotation.random(shape, rng=5)
    q, curve = Rotation.from_quat(-p.as_quat()), Rotation.concatenate([p, p]).reshape(2, *shape)
    for t in (0.0, 0.3, np.array(0.7), 1.0, -2.0, 1e300):
        for end in (p, q):
            np.testing.assert_array_equal(slerp(p, end, t).as_quat(), p.as_quat())
        if 0.0 <= t <= 1.0:
            np.testing.assert_array_equal(Slerp([0, 1], curve)(t).as_quat(), p.as_quat())
    assert np.isnan(slerp(p, p, np.nan).as_quat()).all()


def test_slerp_takes_the_shorter_way() -> None:
    p, q = Rotation.random((2, 500), rng=2)
    for sign in (1, -1):
        half = slerp(p, Rotation(sign * q.as_quat()), 0.5)
        assert (p.inv() * half).magnitude() == pytest.approx((p.inv() * q).magnitude() / 2)
        assert (p.inv() * half).magnitude().max() <= np.pi / 2


def test_slerp_broadcasts() -> None:
    p, q = Rotation.random((4, 1), rng=3), Rotation.random(3, rng=4)
    assert slerp(p, q, 0.5).shape == (4, 3)
    assert slerp(p[0, 0], q[0], np.linspace(0, 1, 7)).shape == (7,)
    assert slerp(p, q, np.zeros((2, 1, 1))).shape == (2, 4, 3)
    with pytest.raises(RotationError, match="broadcast"):
        slerp(q, q, [0.1, 0.2])


def test_nearly_equal_rotations_are_told_apart() -> None:
    p = Rotation.identity()
    for size in (1e-300, 1e-16, 1e-8):
        q = Rotation.from_rotvec([0, size, 0])
        assert slerp(p, q, 0.25).as_rotvec() == pytest.approx([0, size / 4, 0], rel=1e-14)


def test_squad_by_its_formula() -> None:
    p, q, a, b = Rotation.from_rotvec(np.random.default_rng(5).uniform(-0.5, 0.5, (4, 3)))
    for t in (0.0, 0.2, 0.5, 1.0):
        wanted = slerp(slerp(p, q, t), slerp(a, b, t), 2 * t * (1 - t))
        assert near(squad(p, q, a, b, t), wanted)
        signed = (Rotation(-x.as_quat()) for x in (q, a))
        assert near(squad(p, *signed, b, t), wanted)


@pytest.mark.parametrize("curve", [Slerp, Squad])
def test_curves_pass_through_their_keyframes(curve: type[Slerp]) -> None:
    times = np.array([0.0, 1.0, 1.5, 4.0, 4.25])
    keys = Rotation.random((5, 2), rng=6)
    path = curve(times, keys)
    assert path(times).shape == (5, 2)
    assert near(path(times), keys, 1e-13)
    assert path(0.5).shape == (2,)
    assert path([[0.5, 1.0, 2.0]]).shape == (1, 3, 2)
    assert np.isnan(path(np.nan).as_quat()).all()
    assert path([]).shape == (0, 2)
    for outside in (-1e-9, 4.26, [1.0, 5.0]):
        with pytest.raises(RotationError, match=r"from 0 to 4\.25"):
            path(outside)


def test_slerp_through_keyframes_is_slerp_between_them() -> None:
    keys = Rotation.random(3, rng=7)
    path = Slerp([0.0, 2.0, 3.0], keys)
    assert near(
        path([0.5, 2.25]),
        Rotation.concatenate([slerp(keys[0], keys[1], 0.25), slerp(keys[1], keys[2], 0.25)]),
    )


@subcases("seed", range(10))
def test_squad_has_no_corners(seed: int) -> None:
    keys = Rotation.random(6, rng=seed)
    times = np.cumsum(np.random.default_rng(seed).uniform(0.3, 1.0, 6))
    path = Squad(times, keys)
    for t in times[1:-1]:
        corners = [np.abs(np.diff(rates(path, t, h), axis=0)).max() for h in (1e-4, 1e-5)]
        assert corners[1] < 0.2 * corners[0] or corners[1] < 1e-6  # they shrink with the step
    broken = rates(Slerp(times, keys), times[2], 1e-5)
    assert np.abs(np.diff(broken, axis=0)).max() > 0.1


def velocity(curve: Squad, t: float, step: float) -> np.ndarray:
    """The angular velocity at t on the side to which the step leads, to the third power of the step."""
    steps = step / np.array([1.0, 2.0, 4.0])
    found = (curve(t).inv() * curve(t + steps)).as_rotvec() / steps[:, None]
    better = 2 * found[1:] - found[:-1]
    return (4 * better[1] - better[0]) / 3


def jump(times: list[float], keys: Rotation) -> float:
    """The largest jump of the velocity, of one that would turn by 1 in the longer interval."""
    curve, h = Squad(times, keys), np.diff(times)
    sides = [
        [velocity(curve, times[n], part * h[n + k]) * max(h[n - 1], h[n])
         for k, part in ((-1, -1e-3), (0, 1e-3))]
        for n in range(1, len(h))
    ]  # fmt: skip
    return float(np.abs(np.diff(sides, axis=1)).max())


@given(st.lists(st.floats(0, 3), min_size=2, max_size=7), st.integers(0, 10**6))
def test_squad_has_no_corners_for_any_times(logarithms: list[float], seed: int) -> None:
    times = np.cumsum([0.0, *10.0 ** np.array(logarithms)])
    keys = Rotation.random(len(times), rng=seed)
    assert jump(list(times), keys) < 1e-3
    # Nor does the curve itself jump: nothing turns faster than twice round in an interval.
    curve = Squad(times, keys)
    for start, end in itertools.pairwise(times):
        path = curve(np.linspace(start, end, 400))
        assert (path[:-1].inv() * path[1:]).magnitude().max() < 4 * np.pi / 399


def test_squad_where_a_short_turn_is_between_rests() -> None:
    keys = Rotation.from_euler("Z", [0, 0, 90, 90], degrees=True)
    assert jump([0, 1, 1.1, 2.1], keys) < 1e-6
    path = Squad([0, 1, 1.1, 2.1], keys)(np.linspace(0, 2.1, 500)).as_rotvec(degrees=True)
    assert np.abs(path[:, :2]).max() == 0.0
    assert path[:, 2].min() > -60
    assert path[:, 2].max() < 150


def test_squad_of_half_turns_has_no_corners() -> None:
    cube = Rotation.create_group("O")
    rng = np.random.default_rng(3)
    for _ in range(40):
        keys = cube[rng.integers(0, 24, 5)]
        assert jump(list(np.cumsum(10.0 ** rng.uniform(0, 2, 5))), keys) < 1e-4


@pytest.mark.parametrize(
    "times", [[0, 5e-324, 1], [0, 1e-300, 1e300], [-1e308, 0, 1e-308], [-8e307, 0, 8e307]]
)
def test_curves_at_times_of_any_size(times: list[float]) -> None:
    keys = Rotation.random(3, seed=1)
    at = [0.3 * a + 0.7 * b for a, b in itertools.pairwise(times)]
    for curve in (Slerp, Squad):
        assert near(curve(times, keys)(times), keys, 1e-13)
        assert np.isfinite(curve(times, keys)(at).as_quat()).all()


def test_squad_takes_the_velocity_of_a_steady_acceleration() -> None:
    """About one axis by t²/2: the velocity at a keyframe is t, however uneven the keyframes are."""
    times = np.array([0.0, 0.3, 1.3, 1.5, 2.0])
    path = Squad(times, Rotation.from_rotvec(np.outer(times**2 / 2, [0, 0, 1.0])))
    for t in times[1:-1]:
        assert rates(path, t, 1e-6)[:, 2] == pytest.approx([t, t], abs=1e-5)


def test_squad_of_a_steady_turn_is_steady() -> None:
    turn = Rotation.from_rotvec(np.outer([0.0, 1.0, 1.5, 4.0], [0.3, -0.2, 0.5]))
    path = Squad([0.0, 1.0, 1.5, 4.0], turn)
    t = np.linspace(0, 4, 50)
    assert near(path(t), Rotation.from_rotvec(np.outer(t, [0.3, -0.2, 0.5])))
    two = Rotation.random(2, rng=8)
    assert near(Squad([0, 1], two)(t / 4), Slerp([0, 1], two)(t / 4))


def test_keyframes_that_are_none() -> None:
    keys = Rotation.random(3, rng=9)
    for times, rotations in [
        ([0.0, 1.0], keys),
        ([0.0, 1.0, 1.0], keys),
        ([0.0, 2.0, 1.0], keys),
        ([0.0, 1.0, np.nan], keys),
        ([0.0, 1.0, np.inf], keys),
        ([0.0], keys[:1]),
        (0.0, keys[0]),
        ([[0.0, 1.0, 2.0]], keys),
    ]:
        for curve in (Slerp, Squad):
            with pytest.raises(RotationError, match="times"):
                curve(times, rotations)
