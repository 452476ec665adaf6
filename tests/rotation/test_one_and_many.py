"""One row, many and very many are computed by one program: to the same bits."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from rotation import RigidTransform, Rotation, align, align_points, matrices, vectors
from rotation.namespaces import quiet
from rotation.native import builtins
from tests.subcases import subcases

RNG = np.random.default_rng(2024)
Make = Callable[[Any], Any]


def quaternions() -> Any:
    """Usual ones, of all lengths, and such with zeros."""
    q = RNG.standard_normal((150, 4)) * 10.0 ** RNG.uniform(-300, 300, (150, 1))
    q[:30] = np.round(RNG.standard_normal((30, 4)) + 0.3)
    q[:30, 0] += np.all(q[:30] == 0.0, axis=-1)
    return q


def rotation_vectors() -> Any:
    """Tiny and long ones, half turns and whole turns about the axes, zero."""
    v = RNG.standard_normal((150, 3)) * 10.0 ** RNG.uniform(-300, 3, (150, 1))
    v[:30] = np.eye(3)[np.arange(30) % 3] * (np.pi * (np.arange(30) - 15))[:, None]
    v[30], v[31] = 1e300, -0.0
    return v


MAKERS: dict[str, tuple[Make, Make]] = {
    "from_quat": (Rotation.from_quat, lambda: quaternions()),
    "from_rotvec": (Rotation.from_rotvec, lambda: rotation_vectors()),
    "from_rotvec, degrees": (
        lambda v: Rotation.from_rotvec(v, degrees=True),
        lambda: rotation_vectors(),
    ),
    "from_matrix": (
        Rotation.from_matrix,
        lambda: Rotation(quaternions()).as_matrix() + 1e-8 * RNG.standard_normal((150, 3, 3)),
    ),
    "from_euler": (
        lambda a: Rotation.from_euler("ZYX", a),
        lambda: RNG.uniform(-20, 20, (150, 3)),
    ),
    "from_euler, degrees": (
        lambda a: Rotation.from_euler("zxz", a, degrees=True),
        lambda: np.round(RNG.uniform(-1000, 1000, (150, 3)), -1),
    ),
}


@pytest.mark.parametrize("name", MAKERS)
def test_one_is_made_as_many_are(name: str) -> None:
    make, draw = MAKERS[name]
    rows = draw()
    many = make(rows).as_quat()
    one = np.stack([make(row).as_quat() for row in rows])
    np.testing.assert_array_equal(one, many)
    np.testing.assert_array_equal(np.signbit(one), np.signbit(many))


READERS: dict[str, Make] = {
    "as_rotvec": lambda r: r.as_rotvec(),
    "as_matrix": lambda r: r.as_matrix(),
    "as_mrp": lambda r: r.as_mrp(),
    "as_euler": lambda r: r.as_euler("ZYX"),
    "as_euler, proper": lambda r: r.as_euler("xyx", degrees=True),
    "canonical": lambda r: r.as_quat(canonical=True),
    "magnitude": lambda r: r.magnitude(),
    "inverse": lambda r: r.inv().as_quat(),
    "power": lambda r: (r**0.3).as_quat(),
    "square": lambda r: (r * r).as_quat(),
}


@subcases("name", READERS)
def test_one_is_read_as_many_are(name: str) -> None:
    rotations, read = Rotation(quaternions()), READERS[name]
    one = [read(r) for r in rotations]
    assert {type(x) for x in one} <= {np.ndarray, np.float64}
    np.testing.assert_array_equal(np.stack(one), read(rotations))


@pytest.mark.parametrize("row", [[np.nan, 1, 1], [np.inf, 0, 0], [1, 2, -np.inf]])
def test_one_row_that_is_not_finite_is_nan(row: list[float]) -> None:
    r = Rotation.from_rotvec(row)
    for read in READERS.values():
        assert np.isnan(read(r)).all()
    assert np.isnan(Rotation.from_euler("ZYX", row).as_quat()).all()


@pytest.mark.parametrize("degrees", [False, True])
def test_compiled_rotation_vectors_are_those_of_the_formula(degrees: bool) -> None:
    v = RNG.standard_normal((60_000, 3)) * 10.0 ** RNG.choice(
        [-300, -20, 0, 0, 0.2, 3], (60_000, 1)
    )
    v[5], v[6], v[7] = 0.0, np.nan, 1e300
    v[8, 1] = np.inf
    v[9:150] = rotation_vectors()[:141]
    expected = quiet(vectors._from_rotvec)(v, degrees)
    found = Rotation.from_rotvec(v, degrees).as_quat()
    np.testing.assert_allclose(found, expected, rtol=3e-16, atol=3e-16)
    near = np.abs(v).max(axis=-1) < 1.0  # there every part has its digits
    np.testing.assert_allclose(found[near], expected[near], rtol=5e-16, atol=1e-323)
    backward = Rotation.from_rotvec(v.reshape(20, 3000, 3)[:, ::-1], degrees).as_quat()
    np.testing.assert_array_equal(backward[:, ::-1].reshape(-1, 4), found)


def exact_matrix(q: Any) -> Any:
    w, x, y, z = (Fraction(float(c)) for c in q)
    n = w * w + x * x + y * y + z * z
    return [
        [(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n],
    ]


def test_matrices_are_right_entry_by_entry_compiled_or_not() -> None:
    q = RNG.standard_normal((300, 4)) * 10.0 ** RNG.uniform(-9, 0, (300, 4))
    q[1:4] = [[1.0, 0.0, 0.0, 0.0], [-0.0, 0.0, -1.0, 0.0], [1.0, 1.0, 0.0, 0.0]]
    r = Rotation(q)
    for m in (r.as_matrix(), quiet(matrices._to_matrix)(r.as_quat())):
        for row, found in zip(r.as_quat(), m, strict=True):
            off = [
                Fraction(float(found[i, j])) - entry
                for i, line in enumerate(exact_matrix(row))
                for j, entry in enumerate(line)
            ]
            assert max(map(abs, off)) <= Fraction(1, 2**52)
    np.testing.assert_array_equal(r[::-1].as_matrix()[::-1], r.as_matrix())


def test_formulas_are_compiled_here() -> None:
    """Else the tests above would compare numpy with itself."""
    assert builtins.available()


def test_what_is_one_number_is_a_number_of_numpy() -> None:
    r, t = Rotation.random(seed=1), RigidTransform.from_rotation(Rotation.random(seed=2))
    cube = Rotation.create_group("O")
    numbers = [
        r.magnitude(),
        r.as_axis_angle()[1],
        r.approx_equal(r),
        r == r,
        *r.reduce(cube, cube, return_indices=True)[1:],
        *t.as_screw()[2:],
        *t.as_screw(degrees=True)[2:],
        t.approx_equal(t),
        align(np.eye(3), np.eye(3))[1],
        align_points(np.eye(3), np.eye(3))[2],
    ]
    for number in numbers:
        assert isinstance(number, np.generic), number
