"""The compiled kernels against their plain twins, against exact rationals, and in every layout."""

from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield.core.product import Constants, conjugate, multiply, norm
from rotation import kernels
from rotation.fused import rotate, rotate_quat
from rotation.kernels import numpy_kernels
from tests.subcases import subcases
from tests.thorough import quick_part

RNG = np.random.default_rng(20)
N = 1300  # two whole blocks and a part of one
POINTS, AXES, QUATS = RNG.normal(size=(N, 3)), RNG.normal(size=(N, 3)), RNG.normal(size=(N, 4))
ANGLES, EULER = RNG.uniform(-50, 50, N), RNG.uniform(-50, 50, (N, 3))
MATRIX = np.linalg.qr(RNG.normal(size=(3, 3)))[0]
HAMILTON = Constants(Fraction(-1), Fraction(0), Fraction(-1))


def layouts(array: Any) -> dict[str, Any]:
    """Return equal arrays in every kind of memory."""
    wide = np.zeros((2 * array.shape[0], array.shape[1] + 2))
    wide[::2, 1:-1] = array
    record = np.zeros(array.shape[0], [("pad", "i1"), ("data", "f8", array.shape[1:])])
    record["data"] = array
    frozen = array.copy()
    frozen.flags.writeable = False
    return {
        "aos": array.copy(),
        "soa": array.T.copy().T,
        "strided": wide[::2, 1:-1],
        "reversed": array[::-1].copy()[::-1],
        "mirrored": array[:, ::-1].copy()[:, ::-1],
        "unaligned": record["data"],
        "frozen": frozen,
    }


KINDS = list(layouts(POINTS))


@subcases(
    ("kind", "out_kind"),
    quick_part(list(product(KINDS, ["aos", "soa", "strided", "unaligned", "the points"])), 3),
)
def test_every_layout_gives_what_the_twin_gives(kind: str, out_kind: str) -> None:
    axes, q, euler = layouts(AXES)[kind], layouts(QUATS)[kind], layouts(EULER)[kind]
    angles = layouts(ANGLES[:, None])[kind][:, 0]

    def points_and_out() -> tuple[Any, Any]:
        if out_kind == "the points":
            points = layouts(POINTS)["aos" if kind == "frozen" else kind]
            return points, points
        return layouts(POINTS)[kind], layouts(np.full((N, 3), np.nan))[out_kind]

    points, out = points_and_out()
    kernels.one(points, MATRIX, out)
    np.testing.assert_allclose(out, numpy_kernels.one(POINTS, MATRIX), rtol=0, atol=4e-15)
    points, out = points_and_out()
    assert not kernels.axis_angle(points, axes, angles, out)
    np.testing.assert_allclose(
        out, numpy_kernels.axis_angle(POINTS, AXES, ANGLES), rtol=0, atol=2e-14
    )
    points, out = points_and_out()
    assert not kernels.quaternions(points, q, out)
    np.testing.assert_allclose(out, numpy_kernels.quaternions(POINTS, QUATS), rtol=0, atol=1e-14)
    points, out = points_and_out()
    kernels.euler(points, euler, (0, 1, 2), True, out)
    expected = numpy_kernels.euler(POINTS, EULER, (0, 1, 2), True)
    np.testing.assert_allclose(out, expected, rtol=0, atol=1e-14)


@pytest.mark.parametrize("layout", ["aos", "soa"])
def test_the_angles_may_be_components_of_the_axes(layout: Any) -> None:
    turn = (lambda a: a) if layout == "aos" else (lambda a: a.T.copy())
    for k in range(3):
        axes = turn(AXES)
        angles = axes[:, k] if layout == "aos" else axes[k]
        turned = rotate(turn(POINTS), axes, angles, layout=layout)
        expected = turn(numpy_kernels.axis_angle(POINTS, AXES, AXES[:, k]))
        np.testing.assert_allclose(turned, expected, rtol=0, atol=1e-14)


@pytest.mark.parametrize("kind", KINDS)
def test_zero_rows_are_found_in_every_layout(kind: str) -> None:
    for array in (AXES, QUATS):
        assert not kernels.contains_zero(layouts(array)[kind])
        spoilt = array.copy()
        spoilt[:, 0] = 0.0
        assert not kernels.contains_zero(layouts(spoilt)[kind])
        spoilt[:, :3] = 0.0
        assert kernels.contains_zero(layouts(spoilt)[kind]) == (array is AXES)
        spoilt[N - 1] = 0.0
        assert kernels.contains_zero(layouts(spoilt)[kind])


@subcases(
    ("points", "axis", "angle"),
    [
        ((N,), (), ()),
        ((N,), (), (N,)),
        ((N,), (N,), ()),
        ((), (N,), (N,)),
        ((), (), (N,)),
        ((1,), (N,), (1,)),
        ((40,), (7, 1), ()),
        ((40,), (7, 1), (7, 1)),
        ((700, 1), (3,), (700, 3)),
        ((5, 1, 3), (4, 1), (3,)),
        ((2, 1, 3, 1), (1, 5, 1, 4), (2, 1, 1, 4)),
        ((), (), ()),
        ((0,), (0,), (0,)),
        ((0,), (), (0,)),
        ((3, 0), (), ()),
    ],
)
def test_batches_broadcast_as_in_numpy(
    points: tuple[int, ...], axis: tuple[int, ...], angle: tuple[int, ...]
) -> None:
    p, a = RNG.normal(size=(*points, 3)), RNG.normal(size=(*axis, 3))
    t = np.asarray(RNG.normal(size=angle))
    expected = numpy_kernels.axis_angle(p, a, t)
    turned = rotate(p, a, t)
    assert turned.shape == expected.shape
    np.testing.assert_allclose(turned, expected, rtol=0, atol=1e-14)
    first = lambda array: np.moveaxis(array, -1, 0)  # noqa: E731
    turned = rotate(first(p).copy(), first(a).copy(), t, layout="soa")
    np.testing.assert_allclose(turned, first(expected), rtol=0, atol=1e-14)
    q = np.concatenate([np.ones((*axis, 1)), a], axis=-1)
    expected = numpy_kernels.quaternions(p, q)
    np.testing.assert_allclose(rotate_quat(p, q), expected, rtol=0, atol=1e-14)


rational = st.integers(-40, 40)


@settings(max_examples=60)
@given(
    st.tuples(rational, rational, rational, rational).filter(any),
    st.tuples(rational, rational, rational),
)
def test_rationals_are_rotated_as_hfield_rotates_them(
    q: tuple[int, int, int, int], v: tuple[int, int, int]
) -> None:
    r = tuple(Fraction(c) for c in q)
    turned = multiply(HAMILTON, multiply(HAMILTON, r, (Fraction(0), *v)), conjugate(HAMILTON, r))
    exact = [c / norm(HAMILTON, r) for c in turned[1:]]
    bound = 5 * Fraction(1, 2**52) * Fraction(float(np.linalg.norm(v))) + Fraction(1, 10**300)
    batch = rotate_quat(np.array([v, v], float), np.array([q, q], float))
    for got in (rotate_quat(v, q), batch[0], batch[1]):
        square = sum((Fraction(float(g)) - e) ** 2 for g, e in zip(got, exact, strict=True))
        assert square <= bound**2


def test_rational_unit_quaternions_rotate_exactly() -> None:
    """24 of them permute the axes, with signs: there is nothing to round."""
    units = [np.array(q) for q in np.ndindex(3, 3, 3, 3) if np.any(np.array(q) != 1)]
    hurwitz = [q - 1 for q in units if np.sum((q - 1) ** 2) in (1, 4)]
    assert len(hurwitz) == 24
    v = np.array([3.0, -5.0, 7.0])
    for q in hurwitz:
        turned = rotate_quat(v, q)
        assert sorted(np.abs(turned)) == [3.0, 5.0, 7.0]
        np.testing.assert_array_equal(rotate_quat(np.array([v, v]), np.array([q, q]))[1], turned)


def test_running_products_are_the_twins() -> None:
    q = QUATS[:400] * np.logspace(-200, 200, 400)[:, None]
    products = kernels.cumulative(q)
    unit = QUATS[:400] / np.linalg.norm(QUATS[:400], axis=-1, keepdims=True)
    np.testing.assert_allclose(products, numpy_kernels.cumulative(unit), rtol=0, atol=1e-13)
    assert kernels.cumulative(np.empty((0, 4))).shape == (0, 4)


def test_every_operand_may_lie_in_a_way_of_its_own() -> None:
    kinds = [k for k in KINDS if k != "frozen"]
    for turn in range(len(kinds)):
        p, a, t, o = (kinds[(turn + n * turn + n) % len(kinds)] for n in range(4))
        points, axes, out = layouts(POINTS)[p], layouts(AXES)[a], layouts(0 * POINTS)[o]
        angles = layouts(ANGLES[:, None])[t][:, 0]
        assert not kernels.axis_angle(points, axes, angles, out)
        np.testing.assert_allclose(
            out, numpy_kernels.axis_angle(POINTS, AXES, ANGLES), rtol=0, atol=2e-14
        )
    for axes, angles in ((AXES[:1], ANGLES), (AXES, ANGLES[:1]), (AXES[:1], ANGLES[:1])):
        out = np.empty_like(POINTS)
        kernels.axis_angle(POINTS, axes, angles, out)
        np.testing.assert_allclose(
            out, numpy_kernels.axis_angle(POINTS, axes, angles), rtol=0, atol=2e-14
        )


@pytest.mark.parametrize("seq", [(0,), (2, 1), (0, 1, 0), (2, 0, 1)])
@pytest.mark.parametrize("backward", [False, True])
def test_one_two_and_three_angles(seq: tuple[int, ...], backward: bool) -> None:
    angles, out = EULER[:, : len(seq)], np.empty_like(POINTS)
    kernels.euler(POINTS, angles, seq, backward, out)
    expected = POINTS
    for axis, k in zip(seq, range(len(seq))[:: -1 if backward else 1], strict=True):
        expected = numpy_kernels.axis_angle(expected, np.eye(3)[axis], angles[:, k])
    np.testing.assert_allclose(out, expected, rtol=0, atol=2e-14)
    plain = numpy_kernels.euler(POINTS, angles, seq, backward)
    np.testing.assert_allclose(plain, expected, rtol=0, atol=2e-14)


def test_threads_share_the_blocks_and_rare_rows_are_told_of_in_each() -> None:
    before = kernels.threads(3)
    try:
        n = 40_001
        points, axes, angles = (np.resize(a, (n, *a.shape[1:])) for a in (POINTS, AXES, ANGLES))
        axes[33_333] *= 2.0**-900
        out = np.empty_like(points)
        assert not kernels.axis_angle(points, axes, angles, out)
        np.testing.assert_allclose(
            out, numpy_kernels.axis_angle(points, axes, angles), rtol=0, atol=2e-14
        )
        axes[n - 1] = 0.0
        assert kernels.axis_angle(points, axes, angles, out)
    finally:
        kernels.threads(before)
