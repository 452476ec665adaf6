"""Bounds of errors, shown for all inputs: docs/explanation/rotation-errors.md says from what they follow."""

import itertools
from fractions import Fraction
from functools import partial
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import arb, arb_poly, ctx

from rotation import action, matrices
from rotation.kernels import formulas
from rotation.native import elementary, tracing
from rotation.native.elementary import COSINE, SINE
from rotation.quaternions import multiplied
from tests.rotation.entry_errors import COORDINATES, MATRIX, Entry, beside, fma
from tests.rotation.roundings import (
    Number,
    U,
    fused_numbers,
    half_ulp,
    image_error,
    names,
    norm,
    proved,
    together,
    turned_error,
    two_product,
    two_sum,
)
from tests.subcases import first_quick, pairs_quick

POINT = [Number({j: (1.0, 1.0)}, degree=1) for j in range(4)]  # a coordinate is a linear form


def cube(face: int, low: Any, high: Any) -> list[Number]:
    """Return quaternions whose largest coordinate, that of the face, is 1: all others are multiples."""
    one = np.ones(len(low))
    q = [Number({-1: (low[:, k], high[:, k])}, degree=1) for k in range(3)]
    q.insert(face, Number({-1: (one, one)}, degree=1))
    return q


def boxes(least: float, cells: int) -> tuple[Any, Any]:
    """Return the corners of the boxes of a grid, from ``least`` to 1."""
    ends = np.linspace(least, 1.0, cells + 1)
    low = np.stack(np.meshgrid(*[ends[:-1]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    return low, low + (1.0 - least) / cells


def units(face: int, low: Any, high: Any) -> list[Any]:
    """Return enclosures of the coordinates of unit vectors in the directions of these boxes.

    c/√(c² + r²) grows with c, and is nearer to 0 the longer the rest r is.
    """
    c = [(low[:, k], high[:, k]) for k in range(low.shape[1])]
    c.insert(face, (np.ones(len(low)), np.ones(len(low))))
    least = [np.where(a * b <= 0.0, 0.0, np.minimum(np.abs(a), np.abs(b))) ** 2 for a, b in c]
    most = [np.maximum(np.abs(a), np.abs(b)) ** 2 for a, b in c]
    found = []
    for n, (a, b) in enumerate(c):
        short, long = (sum(x for k, x in enumerate(squares) if k != n) for squares in (least, most))
        first = a / np.sqrt(a * a + np.where(a < 0.0, short, long))
        last = b / np.sqrt(b * b + np.where(b < 0.0, long, short))
        found.append((first - 1e-15, last + 1e-15))
    return found


def matrix_of_units(face: int, low: Any, high: Any) -> tuple[list[list[Entry]], list[list[Any]]]:
    """Run the formula of `as_matrix`: the entries, and how far they may be off."""
    c = [Entry(x, *ends) for x, ends in zip(COORDINATES, units(face, low, high), strict=True)]
    entries: Any = matrices.matrix_entries(tuple(c))
    pairs = [zip(row, exact, strict=True) for row, exact in zip(entries, MATRIX, strict=True)]
    return entries, [[beside(*pair) for pair in row] for row in pairs]


@pytest.fixture(params=["fused multiply-add", "none"])
def fused(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> bool:
    """Have a fused multiply-add, or none; leave out what only finds rows to be done otherwise."""
    if request.param == "none":
        monkeypatch.delattr(tracing, "fma", raising=False)
    else:
        monkeypatch.setattr(tracing, "fma", fma, raising=False)
    monkeypatch.setattr(matrices, "namespace", lambda c: tracing)
    return request.param != "none"


def off_by(face: int, low: Any, high: Any) -> Any:
    _, errors = matrix_of_units(face, low, high)
    return np.maximum.reduce([np.broadcast_to(e, len(low)) for row in errors for e in row])


@pytest.mark.usefixtures("fused")
@pytest.mark.parametrize("face", range(4))
def test_entries_of_matrices(face: int) -> None:
    largest, _ = proved(partial(off_by, face), boxes(-1.0, 8), 4.0)
    assert largest < 4.0  # 2·2⁻⁵²


@pytest.mark.parametrize("start", [None, -0.0])
def test_rows_are_summed_as_the_bounds_suppose(
    start: float | None, fused: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The squares of all partial sums of the rows of an orthogonal matrix that are rounded."""
    if fused:
        monkeypatch.setattr(tracing, "fma", fused_numbers)
    rows = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0].tolist()
    m = [[Number({-1: (x, x)}) for x in row] for row in rows]
    squares = np.zeros((3, 3))
    monkeypatch.setattr(action, "namespace", lambda v: tracing)
    for image in action.by_rows(m, tuple(POINT[:3]), start if fused else None):
        for part in image.noise.values():
            b = np.array([part.get(k, (0.0, 0.0))[0] for k in range(3)])
            squares += np.outer(b, b)
    expected = [3.0, 2.0, 1.0] if fused else [3.0, 3.0, 2.0]  # in the latter 1, 1, 1 of products
    np.testing.assert_allclose(squares, np.diag(expected), atol=1e-12)


def few_turned(face: int, fused: bool, waves: Any, low: Any, high: Any) -> Any:
    """Return how far points may be off that `as_matrix` turns, by quaternions of any length or about axes."""
    entries, errors = matrix_of_units(face, low, high)
    own = np.array([[np.broadcast_to(e, len(low)) for e in row] for row in errors])
    sizes = np.array([[np.broadcast_to(e.size, len(low)) for e in row] for row in entries])
    c = units(face, low, high)
    # Coordinates are rounded once: the angle is off by twice as much as they.
    rounded = np.sqrt(sum(half_ulp(np.maximum(-a, b)) ** 2 for a, b in c))
    across = rounded + (waves(*c[0]) if waves else 0.0)
    return image_error(own, fused, sizes) + 2.0 * across + MARGIN


def halves(cells: int) -> tuple[Any, Any]:
    """Return boxes with y and z ≥ 0: j·q·j⁻¹ and the like have other signs, and the same sizes of entries."""
    low, high = boxes(-1.0, cells)
    right = (low[:, 1:] >= 0.0).all(axis=-1)
    return low[right], high[right]


@pytest.mark.parametrize("face", range(4))
def test_points_turned_by_quaternions_of_any_length(face: int, fused: bool) -> None:
    if fused or face == 0:  # without, i·q and the like have entries of the same sizes and roundings
        bound = 9.0 if fused else 9.4
        largest, count = proved(partial(few_turned, face, fused, None), halves(16), bound)
        assert largest < bound  # 4.5·2⁻⁵² of the length of a point, or 4.7·2⁻⁵²
        assert count >= 16**3 / 4


ENDS = np.linspace(0.0, 0.785398163397449, 65)  # up to π/4
REST = -1  # the name of what the rest of an angle is beyond a float
MARGIN = 1e-4  # for what is of second order, or far below the last digit in the reduction of angles
EXCESS = formulas._excess


def waves_off(fused: bool) -> Any:
    """Return how far sine and cosine of what is left of an angle may turn a point."""
    low, high = ENDS[:-1], ENDS[1:]
    symbols = SimpleNamespace(bit=lambda k, n: None, where=lambda condition, yes, no: no)
    if fused:
        symbols.fma = fused_numbers
    one = np.ones_like(low)
    below = Number({-1: (0.0 * one, 0.0 * one)}, {REST: {-1: (one, one)}})
    pairs = elementary.of_rest(symbols, None, Number({-1: (low, high)}), below)
    rest = half_ulp(high)  # and so far it goes
    slopes = ((np.cos(high), np.cos(low)), (-np.sin(high), -np.sin(low)))
    off = []
    for (a, b), table, first, slope in zip(pairs, (SINE, COSINE), (3, 4), slopes, strict=True):
        both = together(a, b)
        ends = both.noise.pop(REST)[-1]
        bent = np.maximum(np.abs(ends[0] - slope[1]), np.abs(ends[1] - slope[0])) + 1e-12
        table_off = [apart(table, first, x, y) / U for x, y in zip(low, high, strict=True)]
        off.append(both.moved[-1] + U * both.rest[-1] + rest * bent + table_off)
    return np.maximum.accumulate(np.cos(low) * off[0] + np.sin(high) * off[1])


def apart(table: Any, first: int, low: float, high: float) -> float:
    """Return how far a polynomial of `elementary` is from sine or cosine between two numbers, by balls."""
    sign = -1 if first == 3 else 1
    with ctx.workprec(200):
        coefficients = [arb(0)] * (first + 24)
        for k in range(12):
            taylor = sign * (-1) ** k / arb.fac_ui(first + 2 * k)
            coefficients[first + 2 * k] = (arb(table[k]) if k < len(table) else 0) - taylor
        middle, radius = arb(0.5 * (low + high)), arb(0.5 * (high - low)) * 1.0001
        near = arb_poly(coefficients)(arb_poly([middle, 1]))
        most = sum((abs(c) * radius**k for k, c in enumerate(near.coeffs())), arb(0))
        return float(most.upper()) + 2.0**-80  # what Taylor's series leaves


APART = tuple(
    max(apart(table, first, a, b) for a, b in pairwise(ENDS)) / U
    for table, first in ((SINE, 3), (COSINE, 4))
)


def by_scalar(off: Any) -> Any:
    """Return what of an enclosure of w = cos(angle/2) tells how far the quaternion may be turned."""

    def found(low: Any, high: Any) -> Any:
        ends = np.abs(np.stack([low, high]))
        least = np.where(low * high <= 0.0, 0.0, ends.min(axis=0))
        angles = np.arccos(np.clip(np.stack([least, ends.max(axis=0)]), 0.0, 1.0))
        rest = np.minimum(angles, 0.5 * np.pi - angles).max(axis=0)
        rest = np.where((angles[0] > np.pi / 4) & (angles[1] < np.pi / 4), np.pi / 4, rest)
        return off[np.clip(np.searchsorted(ENDS, rest + 1e-9) - 1, 0, len(off) - 1)]

    return found


@pytest.mark.parametrize("face", range(4))
def test_points_turned_about_axes(face: int, fused: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of few points, and without fused multiply-add of all."""
    for name, exact in (
        ("two_sum", two_sum),
        ("quick_two_sum", two_sum),
        ("two_product", two_product),
    ):
        monkeypatch.setattr(elementary, name, exact)
    off = waves_off(fused)
    assert off[-1] < 0.65
    bound = 9.0 if fused else 10.0
    largest, _ = proved(partial(few_turned, face, fused, by_scalar(off)), halves(16), bound)
    assert largest < bound  # 4.5·2⁻⁵², or 5·2⁻⁵²


def excess(axis: Any) -> Number:
    """Return what `formulas._excess` does of units: it is 0, and its last rounding of second order."""
    found = EXCESS(axis)
    last, zero = max(found.noise), 0.0 * found.value[-1][0]
    noise = {name: form for name, form in found.noise.items() if name != last}
    rest = {-1: found.rest.get(-1, 0.0) + found.moved[-1]}
    return Number({-1: (zero, zero)}, noise, rest)


def exact_difference(one: float, cosine: Number) -> tuple[Number, Number]:
    """Return 1 − cos, rounded, and what that cuts off."""
    return apart_from(together(Number({-1: (one, one)}), cosine), 1.0)


def apart_from(exact: Number, off: float) -> tuple[Number, Number]:
    """Return two numbers that add up to a plain one, the first off by so many units."""
    n, (low, high) = next(names), exact.value[-1]
    first = Number(exact.value, {**exact.noise, n: {-1: (off, off)}}, exact.rest, exact.degree)
    second = Number({-1: (0.0 * low, 0.0 * high)}, {n: {-1: (-off, -off)}}, degree=exact.degree)
    return first, second


def sines(quarter: int, low: Any, high: Any) -> tuple[Number, Number]:
    """Return sine and cosine of angles between two ends, an eighth of a turn at most, after quarters."""
    far = np.maximum(np.abs(low), np.abs(high))
    near = np.where(low * high <= 0.0, 0.0, np.minimum(np.abs(low), np.abs(high)))
    turned = half_ulp(far)  # what is left of an angle is rounded once
    ends = (
        (np.sin(low) - 1e-15, np.sin(high) + 1e-15),
        (np.cos(far) - 1e-15, np.cos(near) + 1e-15),
    )
    slopes = (ends[1], (-ends[0][1], -ends[0][0]))
    angle, found = next(names), []
    computed = formulas._sincos_of_eighth(Number({-1: (near, far)}))
    for x, value, slope, apart_by in zip(computed, ends, slopes, APART, strict=True):
        own = x.moved[-1] + U * x.rest[-1] + apart_by
        bent = (turned * slope[0], turned * slope[1])
        found.append(Number({-1: value}, {angle: {-1: bent}, next(names): {-1: (own, own)}}))
    sine, cosine = found
    return ((sine, cosine), (cosine, -sine), (-sine, -cosine), (-cosine, sine))[quarter]


def turned_about(face: int, quarter: int, low: Any, high: Any) -> Any:
    axis = [Number({-1: ends}).rounded() for ends in units(face, low[:, :2], high[:, :2])]
    matrix = formulas.matrix_about(tuple(axis), *sines(quarter, low[:, 2], high[:, 2]))
    return turned_error(matrix, True) + MARGIN


@pytest.fixture
def known(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have the formulas of many points run on numbers."""
    monkeypatch.setattr(tracing, "fma", fused_numbers, raising=False)
    monkeypatch.setattr(formulas, "_excess", excess)
    monkeypatch.setattr(formulas, "quick_two_sum", exact_difference)
    monkeypatch.setattr(formulas, "_twice_inverse_norm", twice_inverse_norm)


@pytest.mark.usefixtures("known")
@pytest.mark.parametrize(("face", "quarter"), pairs_quick(range(3), range(4), 6))
def test_many_points_turned_about_axes(face: int, quarter: int) -> None:
    """Axes with coordinates ≥ 0: the other signs come from mirrors, and from −angles about −axes."""
    least, most = np.array([0.0, 0.0, -ENDS[-1]]), np.array([1.0, 1.0, ENDS[-1]])
    cells = boxes(0.0, 10)
    low, high = (least + corner * (most - least) for corner in cells)
    largest, _ = proved(partial(turned_about, face, quarter), (low, high), 10.0)
    assert largest < 10.0  # 5·2⁻⁵²


@pytest.mark.usefixtures("known")
@pytest.mark.parametrize("quarter", range(4))
def test_the_length_of_an_axis_changes_nothing(quarter: int) -> None:
    """In first order: the length before the coordinates are rounded, by whatever it is off."""
    low = np.random.default_rng(4).uniform(0.0, 0.7, (50, 3))
    length = next(names)
    axis = [Number({-1: ends}, {length: {-1: ends}}) for ends in units(0, low[:, :2], low[:, :2])]
    for row in formulas.matrix_about(tuple(axis), *sines(quarter, low[:, 2], low[:, 2])):
        for entry in row:
            assert np.abs(entry.noise[length][-1]).max() < 1e-12


def squared(x: Number) -> Any:
    low, high = x.value[-1]
    least = np.where(low * high <= 0.0, 0.0, np.minimum(np.abs(low), np.abs(high)))
    return least**2 * (1.0 - 1e-14), np.maximum(np.abs(low), np.abs(high)) ** 2 * (1.0 + 1e-14)


def twice_inverse_norm(q: Any) -> tuple[Number, Number, Number]:
    """Return N(q) = 1, t = 2 and what is added to t, of units times a length.

    Four sums and a quotient are rounded to t. With what is added it is 2/N(q), but where the difference of a
    sum and the next is rounded: where the square added is larger than the sum.
    """
    w, x, y, z = q
    one = np.ones_like(z.value[-1][0])
    so_far = squared(z)
    norm, t = Number({-1: (one, one)}, degree=2), Number({-1: (2.0 * one, 2.0 * one)}, degree=-2)
    t, low = apart_from(t, 5.0)
    for c in (y, x, w):
        square = squared(c)
        lost = np.where(square[1] <= so_far[0], 0.0, 2.0 * square[1])
        low.noise[next(names)] = {-1: (lost, lost)}
        so_far = (so_far[0] + square[0], so_far[1] + square[1])
    return norm, t, low


def turned_by(face: int, low: Any, high: Any) -> Any:
    q = tuple(Number({-1: ends}, degree=1) for ends in units(face, low, high))
    return turned_error(formulas.matrix_of(q)[0], True) + MARGIN


@pytest.mark.usefixtures("known")
@pytest.mark.parametrize("face", first_quick(range(4), 1))
def test_many_points_turned_by_quaternions_of_any_length(face: int) -> None:
    largest, _ = proved(partial(turned_by, face), halves(16), 10.0)
    assert largest < 10.0  # 5·2⁻⁵²


def test_what_is_cut_off_from_norms(monkeypatch: pytest.MonkeyPatch) -> None:
    """In whole numbers: t + low is 2/N(q) to what the numbers of `twice_inverse_norm` allow."""
    monkeypatch.setattr(tracing, "fma", exact_fma, raising=False)
    rng = np.random.default_rng(2)
    for _ in range(500):
        q = (rng.normal(size=4) * 2.0 ** rng.integers(-30, 3, 4)).tolist()
        _, t, low = formulas._twice_inverse_norm(tuple(q))
        squares = [Fraction(c) ** 2 for c in q]
        exact, sums = 2 / sum(squares), itertools.accumulate(squares[::-1])
        lost = sum(c for c, so_far in zip(squares[2::-1], sums, strict=False) if c > so_far)
        allowed = Fraction(U) * exact * (lost * exact / 2 + Fraction(1, 10**12))
        assert abs(Fraction(t) + Fraction(low) - exact) <= allowed


def test_what_axes_are_off(monkeypatch: pytest.MonkeyPatch) -> None:
    """In whole numbers: the excess over 1 of what is measured of axes that are rounded."""
    monkeypatch.setattr(tracing, "fma", exact_fma, raising=False)
    rng = np.random.default_rng(3)
    for axis in rng.normal(size=(500, 3)):
        u = (axis / np.linalg.norm(axis) * (1.0 + 3e-16 * rng.integers(-2, 3))).tolist()
        exact = sum(Fraction(c) ** 2 for c in u) - 1
        sizes = np.cumsum([u[0] ** 2 - 0.5, u[1] ** 2, -0.5])
        allowed = U * (half_ulp(np.abs(sizes)).sum() + 1e-12)
        assert abs(Fraction(float(EXCESS(u))) - exact) <= Fraction(float(allowed))


def exact_fma(a: float, b: float, c: float) -> float:
    return float(Fraction(a) * Fraction(b) + Fraction(c))


def multiplied_by(face: int, low: Any, high: Any) -> Any:
    image = multiplied(tuple(cube(face, low, high)), tuple(POINT))
    first, second = norm(list(image), (0, 1, 2, 3))
    nearest = np.where(low * high <= 0.0, 0.0, np.minimum(np.abs(low), np.abs(high)))
    return (first + U * second) / np.sqrt(1.0 + np.sum(nearest**2, axis=-1)) * (1.0 + 1e-15)


@pytest.mark.parametrize("face", range(4))
def test_products_of_quaternions(face: int) -> None:
    """Signs of coordinates do not matter: no two terms of a product have a rounding in common."""
    largest, _ = proved(partial(multiplied_by, face), boxes(0.0, 16), 6.45)
    # The Newton step leaves what is across, and adds 3.5 units: 10 units are 5·2⁻⁵².
    assert largest + 3.5 < 10.0


def test_the_first_order_bound_is_about_what_roundings_can_do() -> None:
    """Roundings chosen for the worst give more than half of the bound: it is not far from the best."""
    rng = np.random.default_rng(0)
    p, q = rng.uniform(-1, 1, (2, 4))
    image = multiplied(tuple(Number({-1: (x, x)}, degree=1) for x in p), tuple(POINT))
    names = sorted({k for n in image for k in n.noise})
    matrices = np.array(
        [
            [[n.noise.get(k, {}).get(j, (0.0, 0.0))[0] for j in range(4)] for n in image]
            for k in names
        ]
    )
    worst = max(
        np.linalg.norm(np.tensordot(np.sign(matrices @ q @ d), matrices, 1) @ q)
        for d in rng.standard_normal((50, 4))
    )
    bound = float(np.max(norm(list(image), (0, 1, 2, 3))[0])) * np.linalg.norm(q)
    assert 0.5 * bound < worst <= bound


def test_bounds_hold_for_numbers_that_are_computed() -> None:
    """The exact error of random products and inverses, in whole numbers, is within the enclosures."""
    rng = np.random.default_rng(1)
    for _ in range(300):
        values = rng.uniform(0.5, 2.0, 4)

        def formula(a: Any, b: Any, c: Any, d: Any) -> Any:
            return (1.0 / (a * b + c)) * (c - d * a) + b

        numbers = [Number({-1: (x, x)}) for x in values.tolist()]
        bound = formula(*numbers)
        computed = formula(*values.tolist())
        a, b, c, d = (Fraction(x) for x in values.tolist())
        exact = (1 / (a * b + c)) * (c - d * a) + b
        allowed = U * bound.moved[-1] + U * U * bound.rest[-1]
        assert abs(Fraction(computed) - exact) <= Fraction(float(allowed))
        low, high = (Fraction(float(x)) for x in bound.value[-1])
        assert low <= exact <= high
