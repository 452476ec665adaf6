"""Numbers of any size, from the smallest float to the largest: against exact arithmetic, and no warnings."""

import itertools
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from rotation import (
    RigidTransform,
    Rotation,
    RotationError,
    Slerp,
    align_points,
    compat,
    integrate,
    inverse_left_jacobian,
    left_jacobian,
    sclerp,
    slerp,
    squad,
)

LARGEST = 1.7976931348623157e308
mp = mpmath.mp.clone()
mp.dps = 400  # so that sines of the largest floats have digits
anything = st.floats(allow_nan=False, allow_infinity=False)
VECTORS = st.lists(anything, min_size=3, max_size=3)
SIZES = [1e-320, 1e-160, 1.0, 1e155, 1e200, 1e308]


def cross(v: Sequence[Any]) -> Any:
    """The matrix of ``v × …``."""
    x, y, z = (mp.mpf(c) for c in v)
    return mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def jacobian(v: Sequence[float]) -> tuple[Any, Any]:
    """The Jacobian of the exponential and, but where it is large, its inverse."""
    n = mp.sqrt(sum(mp.mpf(c) ** 2 for c in v))
    if n < 1e-40:
        return mp.eye(3) + cross(v) / 2, mp.eye(3) - cross(v) / 2
    unit = cross([mp.mpf(c) / n for c in v])
    j = mp.eye(3) + (1 - mp.cos(n)) / n * unit + (1 - mp.sin(n) / n) * unit * unit
    return j, mp.eye(3) - cross(v) / 2 + (1 - n / 2 * mp.cot(n / 2)) * unit * unit


def apart(found: Any, wanted: Any) -> float:
    """The largest difference of two matrices."""
    pairs = itertools.product(range(wanted.rows), range(wanted.cols))
    found = np.reshape(found, (wanted.rows, wanted.cols))
    return float(max(abs(mp.mpf(float(found[n])) - wanted[n]) for n in pairs))


@given(VECTORS)
def test_jacobians_of_vectors_of_any_length(v: list[float]) -> None:
    wanted, inverse = jacobian(v)
    assert apart(left_jacobian(v), wanted) < 1e-15
    if max(map(abs, v)) < 6.0 / 3**0.5:
        assert apart(inverse_left_jacobian(v), inverse) < 1e-14 * float(mp.norm(inverse, mp.inf))
    else:
        assert np.isfinite(inverse_left_jacobian(np.clip(v, -1e290, 1e290))).all()


@given(VECTORS, VECTORS)
def test_twists_of_any_size(v: list[float], u: list[float]) -> None:
    longest = max(map(abs, u))
    assume(longest < 1e308)
    found = RigidTransform.from_exp_coords([*v, *u])
    wanted = jacobian(v)[0] * mp.matrix(u)
    assert apart(found.translation, wanted) <= 1e-15 * longest + 1e-322
    assert found.rotation == Rotation.from_rotvec(v)


def test_vectors_longer_than_the_largest_float() -> None:
    v = [LARGEST] * 3
    assert np.abs(left_jacobian(v) - 1 / 3).max() < 1e-15
    assert abs(np.linalg.norm(Rotation.from_rotvec(v).as_quat()) - 1) < 1e-15
    assert Rotation.from_rotvec([0, 0, LARGEST], degrees=True).magnitude() < np.pi


@pytest.mark.parametrize("size", [5e-324, *SIZES, LARGEST])
def test_dual_quaternions_times_anything(size: float) -> None:
    d = np.array([1.0, -2.0, 3.0, 0.5, 0.25, 1.0, -0.5, 2.0])
    plain = RigidTransform.from_dual_quat(d)
    whole = d / 3.0 if size > 1.0 else 4 * d
    with np.errstate(under="ignore"):
        given = whole * size
    found = RigidTransform.from_dual_quat(given)
    digits = max(1e-15, 1e-323 / np.abs(given).min())
    np.testing.assert_allclose(found.as_dual_quat(), plain.as_dual_quat(), atol=8 * digits)
    # Far from the origin: the second half is as many times longer.
    far = RigidTransform.from_components([1e300, 1e-50, 0], Rotation.identity()).as_dual_quat()
    np.testing.assert_allclose(
        RigidTransform.from_dual_quat(1e-200 * far).translation, [1e300, 1e-50, 0], rtol=1e-14
    )


def exact_mean(numbers: Any, weights: Any) -> float:
    w = [Fraction(float(x)) for x in weights]
    return float(sum(Fraction(float(x)) * y for x, y in zip(numbers, w, strict=True)) / sum(w))


@given(
    st.lists(st.floats(-1.7e308, 1.7e308), min_size=4, max_size=4),
    st.lists(st.floats(1e-320, LARGEST), min_size=4, max_size=4),
)
def test_means_of_translations(numbers: list[float], weights: list[float]) -> None:
    t = np.stack([numbers, np.zeros(4), np.ones(4)], axis=-1)
    shifts, grid = (RigidTransform.from_translation(x) for x in (t, t.reshape(2, 2, 3)))
    tiny = 4e-16 * max(map(abs, numbers)) + 1e-323
    for w in (np.ones(4), weights):
        wanted = [exact_mean(numbers, w), 0, 1]
        theirs = compat.RigidTransform.from_translation(t).mean(w)
        for mean in (shifts.mean(w), theirs, grid.mean(np.reshape(w, (2, 2)))):
            assert abs(mean.translation[0] - wanted[0]) <= tiny
            np.testing.assert_allclose(mean.translation[1:], wanted[1:], rtol=1e-15)


@pytest.mark.parametrize("size", SIZES)
def test_fits_of_points_of_any_size(size: float) -> None:
    turn, points = Rotation.random(seed=1), np.random.default_rng(1).uniform(-0.5, 0.5, (6, 3))
    shift, digits = np.array([0.1, -0.2, 0.3]), max(1e-14, 1e-322 / size)
    target = turn.apply(points) * 0.7 + shift
    target[0] += 0.25
    plain = align_points(points, target)
    found = align_points(points * size, target * size)
    assert found[0].approx_equal(plain[0], 100 * digits)
    np.testing.assert_allclose(found[1] / size, plain[1], atol=100 * digits)
    assert found[2] / size == pytest.approx(plain[2], abs=100 * digits)
    r, rssd, sensitivity = Rotation.align_vectors(target, points, return_sensitivity=True)
    large = 1e155 if size < 1e300 else 1e120
    a, b = (large * x for x in (target, points))
    again = Rotation.align_vectors(a, b, [size] * 6, return_sensitivity=True)
    assert again[0].approx_equal(r, 1e-14)
    assert again[1] == pytest.approx(large * rssd * size**0.5, rel=1e-3)
    np.testing.assert_allclose(again[2] * large * large, sensitivity, rtol=1e-3)
    exactly = [
        Rotation.align_vectors(k * target, k * points, [np.inf, *range(5)]) for k in (1, size)
    ]
    assert exactly[1][1] / size == pytest.approx(exactly[0][1], abs=100 * digits)
    theirs = compat.Rotation.align_vectors(target * size, points * size)
    assert theirs[1] / size == pytest.approx(rssd, abs=100 * digits)


def test_translations_smaller_than_what_can_be_squared() -> None:
    a, b = (RigidTransform.from_translation([x, 0, 0]) for x in (0.0, 1e-170))
    assert a.approx_equal(b, 1e-169)
    assert not a.approx_equal(b, 1e-171)
    assert not a.approx_equal(RigidTransform.from_translation([1e200, 0, 0]))


@pytest.mark.parametrize("size", [5e-324, *SIZES, LARGEST])
def test_screws_of_any_size(size: float) -> None:
    moved = RigidTransform.from_screw([size] * 3, [1, 0, 0], 2.0, 3.0)
    plain = RigidTransform.from_screw([1] * 3, [1, 0, 0], 2.0, 3.0)
    assert moved.approx_equal(plain, 1e-14)
    screw = RigidTransform.from_translation([size, size, 0]).as_screw()
    np.testing.assert_allclose(screw.axis, [0.5**0.5, 0.5**0.5, 0], rtol=1e-15)
    turn = Rotation.from_rotvec([0, 0, min(size, 1.0)])
    screw = RigidTransform.from_components([0, 0, 1], turn).as_screw()
    assert screw.point.tolist() == [0, 0, 0]
    assert screw.displacement == 1


def test_powers_that_no_float_holds() -> None:
    r, t = Rotation.from_rotvec([1, 2, 3]), RigidTransform.from_exp_coords(np.arange(6.0))
    huge = 10**400
    for call in (
        lambda: r**huge,
        lambda: r**-huge,
        lambda: t**huge,
        lambda: slerp(r, r, huge),
        lambda: squad(r, r, r, r, huge),
        lambda: sclerp(t, t, huge),
        lambda: compat.Rotation.from_rotvec([1, 2, 3]) ** huge,
    ):
        with pytest.raises(RotationError, match="of 1329 bits, beyond the largest float"):
            call()
    tiny = Rotation.from_rotvec([0, 3e-301, 4e-301]) ** (10**300)
    np.testing.assert_allclose(tiny.as_rotvec(), [0, 0.3, 0.4], rtol=1e-14)
    assert np.isfinite((r**1e300).as_quat()).all()
    shifts = RigidTransform.from_translation([1e300, 0, 0]) ** 1e10
    assert np.isnan(shifts.translation).any()  # too far, and no warning


@pytest.mark.parametrize("unit", [1e-300, 1e-160, 1e160, 1e300])
@pytest.mark.parametrize("frame", ["body", "world"])
def test_integrals_in_any_unit_of_time(unit: float, frame: str) -> None:
    times, samples = np.arange(5.0), np.random.default_rng(2).standard_normal((5, 3))
    plain = integrate(samples, times, frame=frame)
    assert integrate(samples / unit, times * unit, frame=frame).approx_equal(plain, 1e-14).all()

    def omega(t: float) -> Any:
        return samples[0] / unit * (t / unit)

    found = integrate(omega, times * unit, frame=frame, tolerance=1e-6)
    wanted = Rotation.from_rotvec(np.outer(times**2 / 2, samples[0]))
    assert found.approx_equal(wanted, 1e-6).all()


def test_turns_and_steps_that_no_float_holds() -> None:
    rate = [1e300, -2e300, 0.0]
    assert integrate(rate, [0.0, 1.0])[1] == Rotation.from_rotvec(rate)
    far = [-1e308, 1e308, 1.1e308]
    keys = Rotation.random(3, seed=1)
    theirs = compat.Rotation.from_quat(keys.as_quat(), scalar_first=True)
    for call in (
        lambda: integrate([1, 2, 3], far),
        lambda: Slerp(far, keys),
        lambda: compat.Slerp(far, theirs),
        lambda: compat.RotationSpline(far, theirs),
    ):
        with pytest.raises(RotationError, match="finite"):
            call()
    beyond = squad(keys[0], keys[1], keys[2], keys[0], np.array([0.5, 1e200]))
    assert np.isnan(beyond.as_quat()).all(axis=-1).tolist() == [False, True]


def test_a_notebook_shows_translations_of_any_size() -> None:
    assert "1e+300, -2e+304, 0" in str(
        RigidTransform.from_translation([1e300, -2e304, 0])._repr_html_()
    )
