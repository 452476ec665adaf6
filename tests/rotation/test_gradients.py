"""Derivatives at the identity, where lengths are 0, by JAX and torch; both are optional."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from rotation import Rotation, integrate, slerp
from rotation.namespaces import namespace
from tests.subcases import subcases

HALF = np.vstack([np.zeros(3), 0.5 * np.eye(3)])
E = np.eye(3)


def generators() -> np.ndarray:
    """The derivatives (3, 3, 3) of the matrix by the rotation vector: row, column, coordinate."""
    return -np.array([[np.cross(a, b) for b in E] for a in E])


def half_of_skew() -> np.ndarray:
    """Of the rotation vector by the entries of the matrix: half their differences across the diagonal."""
    return 0.5 * generators().transpose(2, 0, 1)


def like(x: Any, values: Any) -> Any:
    """Return values as an array of the library of x."""
    return namespace(x).asarray(np.asarray(values, float))


def differences(function: Callable[[Any], Any], at: Any) -> np.ndarray:
    """Return the derivative by central differences of numpy's answers, right to about 1e-9."""
    steps = 1e-6 * np.eye(np.size(at)).reshape(-1, *np.shape(at))
    found = [np.asarray(function(at + h)) - np.asarray(function(at - h)) for h in steps]
    return np.moveaxis(found, 0, -1).reshape(*np.shape(found[0]), *np.shape(at)) / 2e-6


# What is derived, at what, and the derivative known on paper.
CASES: dict[str, tuple[Callable[[Any], Any], Any, Any]] = {
    "from_rotvec": (lambda v: Rotation.from_rotvec(v).as_quat(), 0 * E[0], HALF),
    "from_rotvec in degrees": (
        lambda v: Rotation.from_rotvec(v, degrees=True).as_quat(),
        0 * E[0],
        np.radians(HALF),
    ),
    "as_matrix": (lambda v: Rotation.from_rotvec(v).as_matrix(), 0 * E[0], generators()),
    "there and back": (lambda v: Rotation.from_rotvec(v).as_rotvec(), 0 * E[0], E),
    "from_matrix": (lambda m: Rotation.from_matrix(m).as_rotvec(), E, half_of_skew()),
    "from_quat": (
        lambda q: Rotation.from_quat(q).as_rotvec(),
        np.eye(4)[0],
        2 * np.eye(4)[1:],
    ),
    "from_mrp": (lambda v: Rotation.from_mrp(v).as_rotvec(), 0 * E[0], 4 * E),
    "from_euler": (lambda a: Rotation.from_euler("xyz", a).as_rotvec(), 0 * E[0], E),
    "power": (lambda v: (Rotation.from_rotvec(v) ** 0.25).as_rotvec(), 0 * E[0], 0.25 * E),
    "slerp": (
        lambda v: slerp(Rotation.from_rotvec(v), Rotation.from_rotvec(0 * v), 0.25).as_rotvec(),
        0 * E[0],
        0.75 * E,
    ),
    "magnitude": (lambda v: Rotation.from_rotvec(v).magnitude(), 0 * E[0], 0 * E[0]),
    "integrate": (lambda w: integrate(w, [0.0, 2.0])[1].as_rotvec(), 0 * E[0], 2 * E),
}

SEVERAL = Rotation.random(4, seed=1)
VECTORS = np.random.default_rng(2).normal(size=(5, 3))
# Found by decompositions, also where two singular values or eigenvalues are equal.
FOUND: dict[str, tuple[Callable[[Any], Any], Any]] = {
    "unit quaternion": (lambda q: Rotation.from_quat(q).as_quat(), SEVERAL[0].as_quat()),
    "nearest to the identity": (
        lambda m: Rotation.from_matrix(m, orthonormalize=True).as_quat(),
        E,
    ),
    "nearest to twice a rotation": (
        lambda m: Rotation.from_matrix(m, orthonormalize=True).as_matrix(),
        2 * SEVERAL[1].as_matrix(),
    ),
    "nearest": (
        lambda m: Rotation.from_matrix(m, orthonormalize=True).as_matrix(),
        SEVERAL[2].as_matrix() @ np.diag([1.0, 2.0, 3.0]),
    ),
    "mean": (lambda q: Rotation.from_quat(q).mean().as_quat(), SEVERAL.as_quat()),
    "mean of one": (lambda q: Rotation.from_quat(q).mean().as_quat(), np.full((3, 4), 0.5)),
    "mean by weights": (
        lambda w: Rotation.from_quat(like(w, SEVERAL.as_quat())).mean(w).as_quat(),
        np.arange(1.0, 5.0),
    ),
    "fit of axes": (lambda a: Rotation.align_vectors(a, like(a, E))[0].as_quat(), E),
    "fit": (
        lambda a: Rotation.align_vectors(a, like(a, VECTORS))[0].as_quat(),
        VECTORS[::-1].copy(),
    ),
    "fit of one": (
        lambda a: Rotation.align_vectors(a, like(a, [0.0, 0.0, 1.0]))[0].as_quat(),
        VECTORS[0],
    ),
}


@pytest.mark.parametrize("name", ["from_rotvec", "from_matrix", "power"])  # XLA takes seconds each
def test_by_jax_compiled(name: str) -> None:
    jax = pytest.importorskip("jax")
    function, at, wanted = CASES[name]
    with jax.enable_x64(True):
        found = jax.jit(jax.jacrev(function))(jax.numpy.asarray(at))
    np.testing.assert_allclose(found, wanted, atol=1e-14)


@subcases("name", CASES)
def test_by_torch(name: str) -> None:
    torch = pytest.importorskip("torch")
    pytest.importorskip("array_api_compat")
    function, at, wanted = CASES[name]
    found = torch.autograd.functional.jacobian(function, torch.tensor(np.array(at)))
    np.testing.assert_allclose(found.numpy(), wanted, atol=1e-14)


@subcases("name", FOUND)
def test_what_decompositions_find_has_derivatives_by_torch(name: str) -> None:
    torch = pytest.importorskip("torch")
    pytest.importorskip("array_api_compat")
    function, at = FOUND[name]
    found = torch.autograd.functional.jacobian(function, torch.tensor(np.array(at)))
    np.testing.assert_allclose(found.numpy(), differences(function, at), atol=1e-7)


def test_what_decompositions_find_has_second_derivatives() -> None:
    torch = pytest.importorskip("torch")
    pytest.importorskip("array_api_compat")
    function, at = FOUND["nearest to twice a rotation"]
    jacobian = torch.autograd.functional.jacobian

    def first(m: Any) -> Any:
        return jacobian(function, torch.as_tensor(m), create_graph=True)

    found = jacobian(first, torch.tensor(np.array(at)))
    wanted = differences(lambda m: first(m).detach().numpy(), at)
    np.testing.assert_allclose(found.numpy(), wanted, atol=1e-7)


def test_what_decompositions_find_has_derivatives_by_jax() -> None:
    jax = pytest.importorskip("jax")
    function, at = FOUND["nearest to the identity"]
    with jax.enable_x64(True):
        found = jax.jit(jax.jacrev(function))(at)
    np.testing.assert_allclose(found, differences(function, at), atol=1e-7)


@pytest.mark.parametrize("seq", ["ZXZ", "zyx"])
def test_angles_have_finite_derivatives_in_gimbal_lock(seq: str) -> None:
    jax = pytest.importorskip("jax")
    with jax.enable_x64(True):
        at = jax.numpy.asarray(0 * E[0])
        found = jax.jacrev(lambda v: Rotation.from_rotvec(v).as_euler(seq))(at)
    assert np.isfinite(found).all()


def test_a_traced_function_refuses_nothing() -> None:
    """No value is known while JAX traces: what would raise gives NaN."""
    jax = pytest.importorskip("jax")
    made = jax.jit(lambda q: Rotation.from_quat(q).as_matrix())(jax.numpy.zeros((2, 4)))
    assert np.isnan(made).all()


@pytest.mark.parametrize(
    ("low", "high"),
    [(1e-300, 1e-290), (1e-9, 1e-4), (2.4e-4, 2.5e-4), (1e-3, 3.1), (3, 1e6), (1e160, 1e170)],
)
def test_exponentials_and_logarithms_of_jax_are_as_near_as_rounded_lengths(
    low: float, high: float
) -> None:
    """Around 2⁻¹², where the series ends, too; numpy's, right to an ulp, are the measure."""
    jax = pytest.importorskip("jax")
    rng = np.random.default_rng(7)
    v = rng.standard_normal((2000, 3))
    v *= (
        np.exp(rng.uniform(np.log(low), np.log(high), (2000, 1)))
        / np.linalg.norm(v, axis=1)[:, None]
    )
    exact = Rotation.from_rotvec(v)
    with jax.enable_x64(True):
        made = jax.jit(lambda v: Rotation.from_rotvec(v).as_quat())(v + jax.numpy.zeros(3))
        read = jax.jit(lambda q: Rotation(q).as_rotvec())(jax.numpy.asarray(exact.as_quat()))
    size = np.abs(v).max(axis=1)
    off = np.linalg.norm(np.asarray(made) - exact.as_quat(), axis=1)
    if high < 1e150:
        assert (off <= 2.0**-52 * np.maximum(2.0, size)).all()
        apart = np.abs(np.asarray(made) - exact.as_quat())[:, 1:].max(axis=1)
        assert (apart <= 2.0**-51 * size).all()
    assert np.abs(np.linalg.norm(np.asarray(made), axis=1) - 1).max() < 1e-15
    log, near = exact.as_rotvec(), np.asarray(read)
    assert (np.abs(near - log).max(axis=1) <= 2.0**-50 * np.abs(log).max(axis=1)).all()


def test_second_derivatives_of_the_exponential_at_the_identity() -> None:
    """cos(|v|/2) bends by −¼ to every side, though no length has a derivative at 0."""
    jax = pytest.importorskip("jax")
    with jax.enable_x64(True):
        bent = jax.hessian(lambda v: Rotation.from_rotvec(v).as_quat())(jax.numpy.zeros(3))
    assert np.asarray(bent) == pytest.approx(np.stack([-0.25 * E, 0 * E, 0 * E, 0 * E]), abs=1e-15)
