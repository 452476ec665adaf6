"""Sine, cosine and angles in vectors, against mpmath, over all exponents and where digits are lost."""

from functools import cache
from typing import Any

import numpy as np
import pytest

from rotation.native import builtins, tracing
from rotation.rowwise import RowFormula
from tests.rotation.reference import mp

pytestmark = pytest.mark.skipif(not builtins.available(), reason="there is no machine code")
RNG = np.random.default_rng(5)


def _waves(angle: Any) -> Any:
    (s, _), (c, _) = tracing.waves(angle[...])
    return s, c


def _wave_pairs(angle: Any, rest: Any) -> Any:
    (s, s_low), (c, c_low) = tracing.waves(angle[...], rest[...])
    return s, s_low, c, c_low


def _angle(y: Any, x: Any) -> Any:
    return tracing.stack((tracing.atan2(y[...], x[...]),))


def _angle_pair(y: Any, x: Any) -> Any:
    return tracing.angle_of(y[...], x[...])


@pytest.fixture(params=["as here", "without fused multiply-add"])
def made(request: Any, monkeypatch: pytest.MonkeyPatch) -> Any:
    """How to compile a function of numbers: with all that the processor has, and without."""
    if request.param != "as here" and hasattr(tracing, "fma"):
        monkeypatch.delattr(tracing, "fma")
    return lambda f, count: RowFormula(f, *[()] * count)


def ulps(found: Any, wanted: list[Any], low: Any = None) -> float:
    """Return the largest error in units in the last place of the right value."""
    rests = np.zeros(len(found)) if low is None else low
    return max(
        float(abs(mp.mpf(a) + mp.mpf(b) - c) / mp.mpf(float(np.spacing(abs(float(c))))))
        for a, b, c in zip(found.tolist(), rests.tolist(), wanted, strict=True)
    )


def angles() -> Any:
    """Return angles of every size, and next to multiples of π/4, where sines or cosines are small."""
    multiples = np.concatenate(
        [np.arange(-60, 61), 2.0 ** np.arange(6, 31), np.round(RNG.uniform(0, 2.0**30, 60))]
    )
    chosen = np.concatenate([m * multiples for m in (np.pi / 2, np.pi / 4)])
    near = np.concatenate([chosen, np.nextafter(chosen, 9e9), np.nextafter(chosen, -9e9)])
    sizes = np.ldexp(RNG.uniform(0.5, 1, 700), np.arange(-1073, 1025, 3))
    ends = [2.0**1023, 1.7976931348623157e308, 5e-324]
    return np.concatenate([near, sizes, -sizes[::7], RNG.uniform(-0.8, 0.8, 300), ends])


ANGLES = angles()
NEAR = ANGLES[np.abs(ANGLES) < 1e9]
RESTS = np.spacing(NEAR) * RNG.uniform(-0.5, 0.5, len(NEAR))


@cache
def waves(pairs: bool) -> tuple[list[Any], list[Any]]:
    """Return the sines and cosines of the angles, or of those that are pairs."""
    with mp.workprec(1200):
        exact = [mp.mpf(a) for a in (NEAR if pairs else ANGLES).tolist()]
        if pairs:
            exact = [a + mp.mpf(b) for a, b in zip(exact, RESTS.tolist(), strict=True)]
        return [mp.sin(a) for a in exact], [mp.cos(a) for a in exact]


def test_sines_and_cosines_are_right_to_an_ulp(made: Any) -> None:
    found, (sines, cosines) = made(_waves, 1)(ANGLES), waves(pairs=False)
    assert ulps(found[:, 0], sines) <= 0.75
    assert ulps(found[:, 1], cosines) <= 0.75


def test_the_double_nearest_to_a_multiple_of_a_right_angle(made: Any) -> None:
    """The system is off by some ulps there (J.-M. Muller, "Elementary functions", 2016, 11.1)."""
    (found,) = made(_waves, 1)(np.array([6381956970095103.0 * 2.0**797]))
    assert found[0] == 1.0
    assert abs(found[1] + 4.6871659242546276e-19) < 1e-33


def test_sines_and_cosines_of_pairs_are_pairs(made: Any) -> None:
    found, (sines, cosines) = made(_wave_pairs, 2)(NEAR, RESTS), waves(pairs=True)
    assert ulps(found[:, 0], sines, found[:, 1]) <= 0.3
    assert ulps(found[:, 2], cosines, found[:, 3]) <= 0.3


def test_angles_are_right_to_an_ulp(made: Any) -> None:
    sizes = np.ldexp(RNG.uniform(0.5, 1, (2, 1500)), RNG.integers(-1070, 1024, (2, 1500)))
    t = np.concatenate([RNG.uniform(-4, 4, 1000), np.arange(-8, 9) * (np.pi / 8)])
    slopes = 10.0 ** RNG.uniform(-20, 20, 500)
    y = np.concatenate([sizes[0], np.sin(t), slopes, -slopes])
    x = np.concatenate([sizes[1] * RNG.choice([-1, 1], 1500), np.cos(t), slopes**0, -(slopes**0)])
    with mp.workprec(200):
        wanted = [
            mp.atan2(mp.mpf(a), mp.mpf(b)) for a, b in zip(y.tolist(), x.tolist(), strict=True)
        ]
    assert ulps(made(_angle, 2)(y, x)[:, 0], wanted) <= 0.75
    pairs = made(_angle_pair, 2)(y, x)
    assert ulps(pairs[1500:, 0], wanted[1500:], pairs[1500:, 1]) <= 0.35


def test_infinities_zeros_and_nan_are_as_the_systems(made: Any) -> None:
    ends = np.array([0.0, -0.0, 1.0, -1.0, np.inf, -np.inf, np.nan, 5e-324, -5e-324, 1.7e308])
    y, x = (a.ravel() for a in np.meshgrid(ends, ends))
    found, wanted = made(_angle, 2)(y, x)[:, 0], np.arctan2(y, x)
    np.testing.assert_allclose(found, wanted, rtol=2.3e-16, atol=0)
    np.testing.assert_array_equal(np.signbit(found), np.signbit(wanted) & ~np.isnan(wanted))
    with np.errstate(invalid="ignore"):
        found, wanted = made(_waves, 1)(ends), np.stack([np.sin(ends), np.cos(ends)], -1)
    np.testing.assert_allclose(found, wanted, rtol=2.3e-16, atol=0)
    np.testing.assert_array_equal(np.signbit(found[:2]), np.signbit(wanted[:2]))


def test_rows_that_take_the_systems_functions_change_no_others(made: Any) -> None:
    x = RNG.uniform(-10, 10, 16)
    formula = made(_waves, 1)
    before = formula(x)
    x[3], x[9] = 1e200, np.nan
    changed = np.flatnonzero((formula(x) != before).any(axis=-1))
    assert changed.tolist() == [3, 9]
