"""Rotations, motions and curves go through the transformations of JAX and torch; both are optional."""

import subprocess
import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from rotation import (
    BSpline,
    ForeignArrayError,
    RigidTransform,
    Rotation,
    RotationSpline,
    Slerp,
    Squad,
    Uncertain,
    align,
    pytrees,
    slerp,
)

R = Rotation.random(5, seed=1)
T = RigidTransform.from_components(np.arange(15.0).reshape(5, 3), R)
V = np.random.default_rng(0).standard_normal((5, 3))
TIMES = np.array([0.25, 1.75])
VALUES: list[Any] = [R, T, Uncertain(R, np.eye(3)), BSpline(T)]
VALUES += [curve(np.arange(5.0), R) for curve in (Slerp, Squad, RotationSpline)]


def test_the_parts_are_all_that_a_value_holds() -> None:
    registered = dict(pytrees._kinds)
    for value in VALUES:
        names = registered[type(value)]
        again = pytrees._whole(type(value), names)(pytrees._parts(names)(value))
        assert set(vars(value) if hasattr(value, "__dict__") else names) == set(names)
        called = [x(TIMES) if callable(x) else x for x in (again, value)]
        assert repr(called[0]) == repr(called[1]) if callable(value) else repr(again)


def test_jax_takes_them() -> None:
    jax = pytest.importorskip("jax")
    Rotation.identity()  # the first value after the import announces all classes
    with jax.enable_x64(True):
        for value in VALUES[:1] + VALUES[3:]:
            if callable(value):
                found = jax.jit(lambda curve, t, v: curve(t).apply(v))(value, TIMES, V[0])
                np.testing.assert_allclose(found, value(TIMES).apply(V[0]), atol=1e-13)
        turned = jax.vmap(lambda r, t, v: t.apply(r.apply(v)))(R, T, V)
        np.testing.assert_allclose(turned, T.apply(R.apply(V)), atol=1e-13)
        q = Rotation(jax.numpy.asarray(R.as_quat()))
        last, angles = jax.lax.scan(lambda r, step: (step * r, r.magnitude()), q[0], q)
        assert isinstance(last, Rotation)
        assert angles.shape == (5,)
        slope = jax.grad(lambda t: t.apply(jax.numpy.asarray(V)).sum())(
            RigidTransform(jax.numpy.eye(4))
        )
        np.testing.assert_allclose(slope._t, [5, 5, 5])
        with pytest.raises(ForeignArrayError, match=r"Rotation\(jax.numpy.asarray\(r.as_quat"):
            R.apply(jax.numpy.asarray(V))


def test_jax_takes_them_whichever_was_imported_first() -> None:
    pytest.importorskip("jax")
    code = (
        "from rotation import Rotation; import jax; r = Rotation.identity(3); "
        "print(jax.jit(lambda r: r.magnitude())(r).shape)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "(3,)\n"


def test_torch_maps_over_them() -> None:
    torch = pytest.importorskip("torch")
    pytest.importorskip("array_api_compat")
    Rotation.identity()
    q, v = torch.as_tensor(R.as_quat()), torch.as_tensor(V)
    vmap = torch.func.vmap
    for found in (
        vmap(lambda q, v: Rotation(q).apply(v))(q, v),
        vmap(lambda r, v: r.apply(v))(Rotation(q), v),
        vmap(lambda v: Rotation.from_matrix(v))(Rotation(q).as_matrix()).apply(v),
    ):
        np.testing.assert_allclose(found, R.apply(V), atol=1e-13)
    pairs = torch.randn(4, 5, 3, dtype=torch.float64, generator=torch.Generator().manual_seed(1))
    turned = torch.stack([Rotation(q[0]).apply(x) for x in pairs])
    found = vmap(lambda a, b: align(a, b)[0].as_quat())(pairs, turned)
    assert Rotation(found).approx_equal(Rotation(q[0]), atol=1e-13).all()
    with pytest.raises(ForeignArrayError, match=r"Rotation\(torch.asarray\(r.as_quat"):
        R.apply(v)


@pytest.mark.parametrize(
    "operation",
    [lambda p: slerp(p, p, 0.5), lambda p: p * p, lambda p: p**0.5, lambda p: p.inv()],
    ids=["slerp", "product", "power", "inverse"],
)
def test_every_new_rotation_registers_the_classes_with_what_was_imported_since(
    monkeypatch: pytest.MonkeyPatch, operation: Callable[[Rotation], Rotation]
) -> None:
    p = Rotation.identity()
    operation(p)  # compiled
    announced: list[object] = []
    monkeypatch.setattr(pytrees, "number_of_modules", 0)
    monkeypatch.setitem(sys.modules, "jax", ModuleType("jax"))
    monkeypatch.setattr(pytrees, "_announce", lambda kinds, register: announced.append(register))
    operation(p)
    assert pytrees._jax in announced
