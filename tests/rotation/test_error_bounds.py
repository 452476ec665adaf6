"""Bounds of errors, shown for all inputs: docs/rotation-errors.md says from what they follow."""

from functools import partial
from typing import Any

import numpy as np
import pytest

from rotation.kernels import formulas
from rotation.native.symbols import Rows
from rotation.quaternions import multiplied
from tests.rotation.roundings import Number, U, norm, proved

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


@pytest.fixture
def within_reach(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out what only finds rows that the fast form does not serve: it adds −0."""
    monkeypatch.setattr(formulas, "_measured", lambda point: (0, True))
    monkeypatch.setattr(formulas, "_safe", lambda square: True)


def turned(face: int, low: Any, high: Any) -> Any:
    rows: Any = Rows((4,), cube(face, low, high)), Rows((3,), POINT[:3])  # type: ignore[arg-type]
    image, _ = formulas._quaternions(rows[1], rows[0])
    first, second = norm(list(image), (0, 1, 2))
    return first + U * second


@pytest.mark.parametrize("face", range(4))
@pytest.mark.usefixtures("within_reach")
def test_points_turned_by_quaternions_of_any_length(face: int) -> None:
    largest, count = proved(partial(turned, face), boxes(-1.0, 16), 22.0)
    assert largest < 22.0  # units of 2⁻⁵³: 11·2⁻⁵² of the length of a point
    assert count >= 16**3


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
