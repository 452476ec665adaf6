"""The spline through rotations: it goes through them, and its rate and acceleration have no jump."""

from typing import Any

import numpy as np
import pytest

from rotation import Rotation, RotationError, RotationSpline
from rotation.curves import spline

RNG = np.random.default_rng(31)


def keyframes(n: int, scale: float) -> tuple[np.ndarray, Rotation]:
    steps = RNG.standard_normal((n, 3)) * scale
    return np.cumsum(RNG.uniform(0.5, 1.5, n)), Rotation.from_rotvec(steps).cumprod("body")


@pytest.mark.parametrize("scale", [1e-9, 0.1, 1.0])
def test_it_goes_through_the_keyframes_without_a_jump(scale: float) -> None:
    times, keys = keyframes(9, scale)
    curve = RotationSpline(times, keys)
    assert curve(times).approx_equal(keys, atol=1e-14).all()
    inner, e = times[1:-1], 1e-9
    for order in (1, 2):
        np.testing.assert_allclose(
            curve(inner - e, order), curve(inner + e, order), rtol=0, atol=1e-6 * scale
        )


@pytest.mark.parametrize("seed", [0, 598, 653])
def test_keyframes_nearly_half_a_turn_apart(seed: int) -> None:
    times, keys = np.arange(10.0), Rotation.random(10, rng=seed)
    curve, inner, e = RotationSpline(times, keys), times[1:-1], 1e-9
    np.testing.assert_allclose(curve(inner - e, 2), curve(inner + e, 2), rtol=0, atol=1e-5)


@pytest.mark.parametrize("n", [4, 10, 100, 1000])
@pytest.mark.parametrize("scale", [0.1, 0.5, 1.0])
def test_five_steps_of_newtons_method_are_enough(
    n: int, scale: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    taken: list[float] = []
    newton = spline._Jumps._newton

    def counted(self: Any, turns: Any, share: float) -> Any:
        taken.append(share)
        return newton(self, turns, share)

    monkeypatch.setattr(spline._Jumps, "_newton", counted)
    times, keys = keyframes(n, scale)
    RotationSpline(times, keys)
    assert taken[:2] == [0.0, 1.0]  # one linear step, then Newton's
    assert len(taken) <= 5


def test_rates_and_accelerations_are_the_derivatives() -> None:
    times, keys = keyframes(6, 0.9)
    curve, e = RotationSpline(times, keys), 1e-5
    at = np.linspace(times[0] + 0.01, times[-1] - 0.01, 40)
    turned = (curve(at - e).inv() * curve(at + e)).as_rotvec() / (2 * e)
    np.testing.assert_allclose(turned, curve(at, 1), atol=1e-7)
    np.testing.assert_allclose(
        (curve(at + e, 1) - curve(at - e, 1)) / (2 * e), curve(at, 2), atol=1e-6
    )


def test_it_is_scipys() -> None:
    scipy = pytest.importorskip("scipy.spatial.transform")
    times, keys = keyframes(12, 0.5)
    ours, theirs = RotationSpline(times, keys), scipy.RotationSpline(times, keys.to_scipy())
    at = np.linspace(times[0], times[-1], 50)
    assert ours(at).approx_equal(Rotation.from_scipy(theirs(at)), atol=1e-8).all()
    for order in (1, 2):
        np.testing.assert_allclose(ours(at, order), theirs(at, order), atol=1e-6)


@pytest.mark.parametrize("unit", [1e-300, 1.0, 1e300])
def test_times_as_uneven_as_one_to_a_thousand(unit: float) -> None:
    rng = np.random.default_rng(4)
    for _ in range(30):
        h = 10.0 ** rng.uniform(0, 3, rng.integers(2, 9))
        times, keys = np.cumsum([0.0, *h]) * unit, Rotation.random(len(h) + 1, rng=rng)
        curve = RotationSpline(times, keys)
        assert curve(times).approx_equal(keys, atol=1e-12).all()
        inner = times[1:-1]
        before = np.nextafter(inner, -np.inf)
        # In turns, which are rates times the shorter interval; the longer one may be turned through often.
        least, most = np.minimum(h[1:], h[:-1])[:, None], np.abs(curve(times, 1) * unit).max()
        jumps = [
            (curve(inner, order) - curve(before, order)) * unit * (unit * least) ** (order - 1)
            for order in ((1, 2) if unit == 1.0 else (1,))
        ]
        assert np.abs(jumps).max() < 1e-9 * most
        assert np.isfinite(curve(times, 0).as_quat()).all()


def test_times_too_uneven_for_a_smooth_curve() -> None:
    keys = Rotation.random(4, seed=0)
    with pytest.raises(RotationError, match=r"at keyframe 1 a turn of \d+° in 1e-100 meets"):
        RotationSpline([0, 1e-100, 1, 2], keys)
    broken = Rotation(np.where(np.arange(4)[:, None] == 2, np.nan, keys.as_quat()))
    assert np.isnan(RotationSpline([0, 1, 2, 3], broken)(0.5).as_quat()).all()


def test_two_keyframes_and_mistakes() -> None:
    keys = Rotation.from_euler("Z", [0, 60], degrees=True)
    curve = RotationSpline([0, 2], keys)
    np.testing.assert_allclose(curve(0.5).as_rotvec(degrees=True), [0, 0, 15], atol=1e-12)
    np.testing.assert_allclose(curve([0, 2], 2), 0, atol=1e-14)
    for bad in (
        lambda: RotationSpline([0, 0], keys),
        lambda: RotationSpline([0], keys[:1]),
        lambda: RotationSpline([0, 1], keys.reshape(2, 1)),
        lambda: curve(3.0),
        lambda: curve(1.0, order=3),
    ):
        with pytest.raises(RotationError):
            bad()


@pytest.mark.parametrize("few", [1, 2, 24])
@pytest.mark.parametrize("n", [0, 1, 2, 3, 8, 9, 24, 25, 50, 97])
def test_block_tridiagonal_equations(few: int, n: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spline, "_SOLVED_AS_ONE", few)
    before, after = RNG.standard_normal((2, max(n - 1, 0), 3, 3))
    own, right = RNG.standard_normal((n, 3, 3)) + 6 * np.eye(3), RNG.standard_normal((n, 3))
    whole = np.zeros((n, 3, n, 3))
    for k in range(n):
        whole[k, :, k] = own[k]
        if k:
            whole[k, :, k - 1], whole[k - 1, :, k] = before[k - 1], after[k - 1]
    wanted = np.linalg.solve(whole.reshape(3 * n, 3 * n), right.ravel()).reshape(n, 3)
    found = spline._tridiagonal(before, own, after, right)
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-13)
