"""Bounds of errors, shown for all inputs: docs/rotation-errors.md says from what they follow."""

from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import arb, arb_poly, ctx

from rotation import action, matrices
from rotation.native import elementary, tracing
from rotation.native.elementary import COSINE, SINE
from rotation.quaternions import multiplied
from tests.rotation.entry_errors import COORDINATES, MATRIX, Entry, beside, fma
from tests.rotation.roundings import (
    Number,
    U,
    fused_numbers,
    half_ulp,
    names,
    norm,
    proved,
    together,
    two_product,
    two_sum,
)

POINT = [Number({j: (1.0, 1.0)}) for j in range(4)]  # a coordinate is a linear form


def cube(face: int, low: Any, high: Any) -> list[Number]:
    """Return quaternions whose largest coordinate, that of the face, is 1: all others are multiples."""
    one = np.ones(len(low))
    q = [Number({-1: (low[:, k], high[:, k])}) for k in range(3)]
    q.insert(face, Number({-1: (one, one)}))
    return q


def boxes(least: float, cells: int) -> tuple[Any, Any]:
    """Return the corners of the boxes of a grid, from ``least`` to 1."""
    ends = np.linspace(least, 1.0, cells + 1)
    low = np.stack(np.meshgrid(*[ends[:-1]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    return low, low + (1.0 - least) / cells


def units(face: int, low: Any, high: Any) -> list[Any]:
    """Return enclosures of the coordinates of unit quaternions in the directions of these boxes."""
    c = [(low[:, k], high[:, k]) for k in range(3)]
    c.insert(face, (np.ones(len(low)), np.ones(len(low))))
    least = [np.where(a * b <= 0.0, 0.0, np.minimum(np.abs(a), np.abs(b))) for a, b in c]
    most = [np.maximum(np.abs(a), np.abs(b)) for a, b in c]
    shortest, longest = (np.sqrt(sum(x * x for x in sizes)) for sizes in (least, most))
    far, near = shortest * (1.0 - 1e-12), longest * (1.0 + 1e-12)
    return [(a / np.where(a < 0.0, far, near), b / np.where(b < 0.0, near, far)) for a, b in c]


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
    monkeypatch.setattr(action, "_steadily", lambda turned, v: turned(v))
    return request.param != "none"


def off_by(face: int, low: Any, high: Any) -> Any:
    _, errors = matrix_of_units(face, low, high)
    return np.maximum.reduce([np.broadcast_to(e, len(low)) for row in errors for e in row])


@pytest.mark.usefixtures("fused")
@pytest.mark.parametrize("face", range(4))
def test_entries_of_matrices(face: int) -> None:
    largest, _ = proved(partial(off_by, face), boxes(-1.0, 8), 4.0)
    assert largest < 4.0  # 2·2⁻⁵²


def turned(face: int, waves: Any, low: Any, high: Any) -> Any:
    """Return how far points may be off that are turned by quaternions of any length, or about axes."""
    entries, errors = matrix_of_units(face, low, high)
    numbers = [
        [
            Number({-1: (e.low, e.high)}, {next(names): {-1: (-off, off)}})
            for e, off in zip(*rows, strict=True)
        ]
        for rows in zip(entries, errors, strict=True)
    ]
    first, second = norm(list(action._by_entries(numbers, tuple(POINT[:3]))), (0, 1, 2))
    c = units(face, low, high)
    # Coordinates are rounded once: the angle is off by twice as much as they.
    rounded = np.sqrt(sum(half_ulp(np.maximum(-a, b)) ** 2 for a, b in c)) * (1.0 + 1e-12)
    return first + U * second + 2.0 * (rounded + (waves(*c[0]) if waves else 0.0)) + 1e-9


def halves(cells: int) -> tuple[Any, Any]:
    """Return boxes with y and z ≥ 0: j·q·j⁻¹ and the like have other signs, and the same sizes of entries."""
    low, high = boxes(-1.0, cells)
    right = (low[:, 1:] >= 0.0).all(axis=-1)
    return low[right], high[right]


@pytest.mark.parametrize("face", range(4))
def test_points_turned_by_quaternions_of_any_length(face: int, fused: bool) -> None:
    if fused or face == 0:  # without, i·q and the like have entries of the same sizes and roundings
        largest, count = proved(partial(turned, face, None), halves(16), 10.0)
        assert largest < 10.0  # 5·2⁻⁵² of the length of a point
        assert count >= 16**3 / 4


ENDS = np.linspace(0.0, 0.785398163397449, 65)  # up to π/4
REST = -1  # the name of what the rest of an angle is beyond a float


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


@pytest.mark.slow
@pytest.mark.parametrize("face", range(4))
def test_points_turned_about_axes(face: int, fused: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, exact in (
        ("two_sum", two_sum),
        ("quick_two_sum", two_sum),
        ("two_product", two_product),
    ):
        monkeypatch.setattr(elementary, name, exact)
    with monkeypatch.context() as known:
        known.setattr(Number, "scaled", True)
        off = waves_off(fused)
    assert off[-1] < 0.65
    bound = 10.0 if fused else 10.6
    largest, _ = proved(partial(turned, face, by_scalar(off)), halves(16), bound)
    assert largest < bound  # 5·2⁻⁵², or 5.3·2⁻⁵²


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
    image = multiplied(tuple(Number({-1: (x, x)}) for x in p), tuple(POINT))
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
    from fractions import Fraction

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
