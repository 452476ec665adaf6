"""Arrays of other libraries stay where they are: with array-api-strict, only the standard's functions."""

import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from rotation import (
    DTypeError,
    ForeignArrayError,
    R_x,
    R_y,
    R_z,
    Rotation,
    RotationError,
    RotationSpline,
    Slerp,
    Squad,
    T_q,
    align,
    align_points,
    integrate,
    rotate_quat,
    slerp,
    squad,
)
from tests.subcases import subcases

xp = pytest.importorskip("array_api_strict")

Q = np.random.default_rng(1).standard_normal((5, 4))
V = np.random.default_rng(2).standard_normal((5, 3))
T = np.linspace(-0.5, 1.5, 5)
AT = np.array([[-0.5, 0.0, 0.3], [0.9, 1.2, 1.5]])

# Each is run on numpy arrays and on foreign ones; `m` makes an array of the kind.
CALLS: dict[str, Callable[[Rotation, Callable[[Any], Any]], Any]] = {
    "from_quat": lambda r, m: Rotation.from_quat(m(Q), scalar_first=False).as_quat(),
    "from_quat huge": lambda r, m: Rotation.from_quat(m(1e300 * Q)).as_quat(),
    "from_matrix": lambda r, m: Rotation.from_matrix(r.as_matrix()).as_quat(canonical=True),
    "from_matrix rough": lambda r, m: Rotation.from_matrix(r.as_matrix() + 1e-7).as_quat(),
    "orthonormalize": lambda r, m: Rotation.from_matrix(
        3.0 * r.as_matrix() + 0.1, orthonormalize=True
    ).as_quat(),
    "from_rotvec": lambda r, m: Rotation.from_rotvec(m(V)).as_quat(),
    "from_rotvec small": lambda r, m: Rotation.from_rotvec(m(1e-300 * V)).as_rotvec(),
    "from_rotvec large": lambda r, m: Rotation.from_rotvec(m(1e5 * V), degrees=True).as_quat(),
    "from_axis_angle": lambda r, m: Rotation.from_axis_angle(m(V), m(T)).as_quat(),
    "from_mrp": lambda r, m: Rotation.from_mrp(m(V)).as_quat(),
    "from_euler": lambda r, m: Rotation.from_euler("ZYX", m(V)).as_quat(),
    "from_euler degrees": lambda r, m: Rotation.from_euler(
        "zxz", m(900 * V), degrees=True
    ).as_quat(),
    "from_euler one": lambda r, m: Rotation.from_euler("y", m(T)).as_quat(),
    "between": lambda r, m: Rotation.between(m(V), m(V[::-1].copy())).as_quat(),
    "between opposite": lambda r, m: Rotation.between(m(V), m(-V)).as_quat(),
    "as_quat": lambda r, m: r.as_quat(scalar_first=False, canonical=True),
    "as_matrix": lambda r, m: r.as_matrix(),
    "as_rotvec": lambda r, m: r.as_rotvec(degrees=True),
    "as_axis": lambda r, m: r.as_axis_angle()[0],
    "as_angle": lambda r, m: r.as_axis_angle()[1],
    "as_mrp": lambda r, m: r.as_mrp(),
    "as_euler": lambda r, m: r.as_euler("ZYX"),
    "as_euler proper": lambda r, m: r.as_euler("xzx", degrees=True),
    "gimbal lock": lambda r, m: Rotation.from_euler(
        "ZYX", m(V[:, :1] * [1, 0, 1] + [0, np.pi / 2, 0])
    ).as_euler("ZYX"),
    "magnitude": lambda r, m: r.magnitude(),
    "product": lambda r, m: (r * r[0]).as_quat(),
    "inverse": lambda r, m: r.inv().as_quat(),
    "power": lambda r, m: (r**0.3).as_quat(),
    "powers": lambda r, m: (r ** m(T)).as_quat(),
    "outer": lambda r, m: r.outer(r[:2]).as_quat(),
    "==": lambda r, m: r == r[0],
    "!=": lambda r, m: r != r[0],
    "approx_equal": lambda r, m: r.approx_equal(r[1], atol=0.5),
    "index": lambda r, m: r[1:4].as_quat(),
    "index of two": lambda r, m: r.reshape(5, 1)[1].as_quat(),
    "ellipsis": lambda r, m: r[..., 2].as_quat(),
    "concatenate": lambda r, m: Rotation.concatenate([r, r[0]]).as_quat(),
    "reshape": lambda r, m: r.reshape(1, -1).as_quat(),
    "apply": lambda r, m: r.apply(m(V)),
    "apply one": lambda r, m: r[0].apply(m(V)),
    "apply inverse": lambda r, m: r.apply(m(V[0]), inverse=True),
    "apply_outer": lambda r, m: r.apply_outer(m(V)),
    "mean": lambda r, m: r.mean(m(np.abs(T))).as_quat(),
    "cumprod": lambda r, m: r.cumprod("body").as_quat(),
    "slerp": lambda r, m: slerp(r, r[1], 0.3).as_quat(),
    "slerp at times": lambda r, m: slerp(r[0], r[1], m(T)).as_quat(),
    "squad": lambda r, m: squad(r[0], r[1], r[2], r[3], m(T)).as_quat(),
    "Slerp": lambda r, m: Slerp(m(T), r)(m(AT)).as_quat(),
    "Slerp of arrays": lambda r, m: Slerp(m([0, 1.5]), r[:4].reshape(2, 2))(m(0.3)).as_quat(),
    "Squad": lambda r, m: Squad(m(T), r)(m(AT)).as_quat(),
    "RotationSpline": lambda r, m: RotationSpline(m(T), r)(m(AT)).as_quat(),
    "RotationSpline's rate": lambda r, m: RotationSpline(m(T), r)(m(AT), 1),
    "integrate": lambda r, m: integrate(m(V[0]), m(T), r[0]).as_quat(),
    "integrate samples": lambda r, m: integrate(m(V), m(T), r[0], "world").as_quat(),
    "integrate a function": lambda r, m: integrate(
        lambda t: m(V[0]) * t, m(T), tolerance=1e-3
    ).as_quat(),
    "align": lambda r, m: align(m(V), r.apply(m(V))[::-1, :])[0].as_quat(),
    "align_points": lambda r, m: align_points(m(V), r[0].apply(m(V)))[1],
    "T_q": lambda r, m: T_q(m(Q), m(V)),
    "R_x": lambda r, m: R_x(m(T)),
    "R_y": lambda r, m: R_y(m(T), degrees=True),
    "R_z": lambda r, m: R_z(m(T)),
}


@pytest.mark.slow
@subcases("name", CALLS)
@subcases("version", ["2023.12", "2024.12"])
def test_the_same_as_numpy(name: str, version: str) -> None:
    with xp.ArrayAPIStrictFlags(api_version=version):
        found = CALLS[name](Rotation.from_quat(xp.asarray(Q)), xp.asarray)
        assert found.__array_namespace__() is xp
    wanted = CALLS[name](Rotation.from_quat(Q), np.asarray)
    assert np.asarray(found).shape == np.shape(wanted)
    assert np.asarray(found).astype(float) == pytest.approx(
        np.asarray(wanted, float), rel=4e-16, abs=2e-15
    )


@subcases("name", CALLS)
def test_float32_stays_float32(name: str) -> None:
    if name in ("from_quat huge", "from_rotvec small"):
        pytest.skip("beyond the range of float32")

    def make(a: Any) -> Any:
        return xp.asarray(np.asarray(a, np.float32))

    found = CALLS[name](Rotation.from_quat(make(Q)), make)
    if found.dtype != xp.bool:
        assert found.dtype == xp.float32
    wanted = CALLS[name](Rotation.from_quat(Q), np.asarray)
    large = 2e-4 if name in ("from_euler degrees", "from_rotvec large") else 4e-6
    scale = max(1.0, float(np.abs(np.asarray(wanted, float)).max()))
    assert np.asarray(found).astype(float) == pytest.approx(
        np.asarray(wanted, float), abs=large * scale
    )


def test_the_points_decide_the_precision() -> None:
    points = xp.asarray(V.astype(np.float32))
    assert Rotation.from_quat(xp.asarray(Q)).apply(points).dtype == xp.float32


def test_errors_are_those_of_numpy() -> None:
    for bad in ([[1.0, 0, 0, 0], [0, 0, 0, 0]], [1.0, 0, 0]):
        with pytest.raises(RotationError) as ours:
            Rotation.from_quat(np.asarray(bad))
        with pytest.raises(RotationError) as theirs:
            Rotation.from_quat(xp.asarray(bad))
        assert str(ours.value) == str(theirs.value)
    for matrix in (-np.eye(3), 2 * np.eye(3)):
        with pytest.raises(RotationError):
            Rotation.from_matrix(xp.asarray(matrix))
    with pytest.raises(DTypeError):
        Rotation.from_quat(xp.asarray([1j, 0, 0, 0]))
    assert Rotation.from_quat(xp.asarray([1, 0, 0, 0])).as_quat().dtype == xp.float64


def test_libraries_are_not_mixed() -> None:
    r = Rotation.from_quat(xp.asarray(Q))
    for fails in (
        lambda: r.apply(V),
        lambda: Rotation.from_quat(Q).apply(xp.asarray(V)),
        lambda: r * Rotation.from_quat(Q),
        lambda: slerp(r, r, T),
        lambda: Rotation.concatenate([r, Rotation.from_quat(Q)]),
        lambda: r.apply(xp.asarray(V), out=xp.asarray(V)),
        lambda: rotate_quat(xp.asarray(V), Q),
        lambda: Slerp(T, r),
        lambda: integrate(V, T, r[0]),
        lambda: integrate(lambda t: xp.ones(3), [0.0, 1.0]),
    ):
        with pytest.raises(ForeignArrayError):
            fails()
    assert np.asarray(r.apply([[1.0, 0, 0]])).shape == (5, 3)  # lists fit everywhere


def test_python_sides_of_foreign_rotations() -> None:
    r = Rotation.from_quat(xp.asarray(Q))
    assert "Rotation.from_quat" in repr(r)
    assert hash(r[0]) == hash(Rotation.from_quat(Q)[0])
    assert len(list(r)) == 5
    with pytest.raises(ForeignArrayError, match="numpy arrays only"):
        r.to_scipy()


def test_masks_choose_rotations() -> None:
    q = np.random.default_rng(3).standard_normal((2, 3, 4))
    ours, foreign = Rotation.from_quat(q), Rotation.from_quat(xp.asarray(q))
    for mask in ([True, False], [[True, False, True], [False, False, True]]):
        chosen = foreign[xp.asarray(mask)].as_quat()
        np.testing.assert_array_equal(np.asarray(chosen), ours[np.array(mask)].as_quat())


def test_libraries_that_do_not_name_their_namespace(monkeypatch: pytest.MonkeyPatch) -> None:
    """As torch does not: array-api-compat names it, and where that is missing the error says so."""

    class Tensor:
        __module__ = "torch"

    monkeypatch.setitem(sys.modules, "array_api_compat", None)
    with pytest.raises(ForeignArrayError, match="array-api-compat"):
        Rotation.from_quat(Tensor())
    compat = ModuleType("array_api_compat")
    compat.array_namespace = lambda _: xp  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "array_api_compat", compat)
    from rotation.namespaces import namespace

    assert namespace(Tensor()) is xp
