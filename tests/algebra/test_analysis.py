"""Modulus, polar form, exponential, logarithm, powers and roots, against mpmath and exact identities."""

import math
from collections.abc import Callable
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from hfield import RDF, H, QuaternionAlgebra
from hfield.errors import CoercionError, NoSolutionError, NotInvertibleError, RingError
from tests.thorough import cases

A = H(RDF)
UNIT = 2.0**-52


def random_batch(n: int, seed: int) -> np.ndarray:
    """Quaternions of all directions, lengths from 2⁻²⁰ to 2⁵, and some nearly real ones."""
    rng = np.random.default_rng(seed)
    q = rng.normal(size=(4, n)) * 2.0 ** rng.uniform(-20, 5, n)
    q[1:, ::7] *= 2.0 ** rng.uniform(-40, 0, q[1:, ::7].shape[1])
    return q


def by_mpmath(f: Callable[[object], object], q: np.ndarray) -> list[mpmath.mpf]:
    """Return f of w + φ·n in 200 bits, from f(w + iφ)."""
    w, *v = (mpmath.mpf(float(x)) for x in q)
    phi = mpmath.sqrt(sum(x * x for x in v))
    z = f(mpmath.mpc(w, phi))
    return [z.real, *(z.imag * x / phi for x in v)]


@pytest.mark.parametrize(
    ("name", "exact", "units"),
    [
        ("exp", mpmath.exp, 40),
        ("log", mpmath.log, 3),
        ("sqrt", mpmath.sqrt, 3),
        ("**0.3", lambda z: z ** mpmath.mpf(0.3), 3),
        ("**-2.5", lambda z: z ** mpmath.mpf(-2.5), 10),
        ("roots(3)", mpmath.cbrt, 4),
    ],
)
def test_floats_against_mpmath(name: str, exact: Callable[[object], object], units: float) -> None:
    """The errors are in units of 2⁻⁵² of the modulus of the result; exp has 40 up to modulus 2⁷.

    scripts/measure_float_functions.py takes more values.
    """
    q = random_batch(cases(1000), 1)
    batch = A(*q)
    if name.startswith("**"):
        result = batch ** float(name[2:])
    else:
        result = batch.roots(3)[0] if name == "roots(3)" else getattr(batch, name)()
    found = result.coordinates
    with mpmath.workprec(200):
        for n in range(q.shape[1]):
            right = by_mpmath(exact, q[:, n])
            error = mpmath.sqrt(sum((f[n] - r) ** 2 for f, r in zip(found, right, strict=True)))
            length = mpmath.sqrt(sum(r * r for r in right))
            assert error <= units * UNIT * length, (name, q[:, n].tolist())


def test_single_quaternions_are_computed_as_arrays_are() -> None:
    q = random_batch(30, 2)
    batch = A(*q)
    for n in range(30):
        one = A(*map(float, q[:, n]))
        for name in ("exp", "log", "sqrt"):
            assert getattr(one, name)() == getattr(batch, name)()[n]
        assert abs(abs(one) - abs(batch)[n]) <= UNIT * abs(one)  # the sums of squares differ
        assert one**0.3 == (batch**0.3)[n]
        assert one.polar().axis == batch.polar().axis[n]


def test_polar_form_and_roots_come_back() -> None:
    q = A(*random_batch(200, 3))
    r, n, theta = q.polar()
    assert (abs(n * n + 1) < 1e-14).all()
    assert ((theta >= 0) & (theta <= math.pi)).all()
    assert (abs(A.from_polar(r, n, theta) - q) <= 8 * UNIT * abs(q)).all()
    roots = q.roots(5)
    assert roots.shape == (5, 200)
    assert (abs(roots**5 - q) <= 1e-13 * abs(q)).all()
    assert abs(roots[0] - roots[1]).min() > 0


@pytest.mark.parametrize("constants", [(1, 1, 0), (2, -3, 0), (-1, -1, 1), (0, -1, 0), (0, 0, 0)])
def test_other_algebras(constants: tuple[int, int, int]) -> None:
    """Where v² is positive or 0, exp is the sum of its series, and log and sqrt its inverses."""
    B = QuaternionAlgebra("RDF", *constants)
    rng = np.random.default_rng(4)
    q = B(3.0 + rng.uniform(size=50), *rng.uniform(-0.5, 0.5, size=(3, 50)))
    power, total = B.scalar(1), B.scalar(1) + q * 0
    for n in range(1, 60):
        power = power * q * (1 / n)
        total = total + power
    for x, y in ((q.exp(), total), (q.log().exp(), q), (q.sqrt() * q.sqrt(), q)):
        difference = np.array((x - y).coordinates)
        assert np.abs(difference).max() < 1e-12 * max(1, np.abs(np.array(y.coordinates)).max())


def test_exact_values() -> None:
    R = H("RR")
    assert R.parse("pi/3*k").exp() == R.parse("1/2 + sqrt(3)/2*k")
    assert R.parse("log(2) + pi/4*i").exp() == R.parse("sqrt(2) + sqrt(2)*i")
    assert R(1, 1, 0, 0).log() == R.parse("log(2)/2 + pi/4*i")
    assert R(1, 1, 1, 1).polar()[::2] == (R.ring(2), R.ring("pi/3"))
    assert R.from_polar(2, (0, 0, 1), "pi/6") == R.parse("sqrt(3) + k")
    assert R(0, 2, 0, 0) ** -1.5 == R(-1, -1, 0, 0) / 4
    assert R(0, 2, 0, 0) ** Fraction(1, 2) == R(1, 1, 0, 0)
    assert abs(R(1, 2, 3, 4)) == R.ring("sqrt(30)")
    assert abs(H("QQ")(1, 1, 1, 1)) == 2
    assert H("QQ")(1, 1, 1, 1).unit() * 2 == H("QQ")(1, 1, 1, 1)
    assert abs(H("QQ(sqrt(2))")(1, 1, 0, 0)) == H("QQ(sqrt(2))").ring("sqrt(2)")
    assert len(R(0, 1, 0, 0).roots(3).isolated) == 3


def test_dot_and_cross_products() -> None:
    """The product of pure quaternions is their vector product minus their scalar product."""
    for B in (H("QQ"), QuaternionAlgebra("QQ", 2, -3), H("GF(7)")):
        p, q = B(5, 1, 2, 3), B(-1, 4, 5, 6)
        assert p.vector_part * q.vector_part == p.cross(q) - p.dot(q)
        assert p.cross(p) == 0
    p, q = A(*random_batch(10, 5)), A(*random_batch(10, 6))
    assert np.allclose(p.dot(q), sum(x * y for x, y in zip(p.vector, q.vector, strict=True)))
    assert np.allclose(
        np.array(p.cross(q).vector).T, np.cross(np.array(p.vector).T, np.array(q.vector).T)
    )


def test_matrices_of_both_sides_and_over_a_splitting_field() -> None:
    B = H("QQ")
    p, q = B(1, 2, 3, 4), B(2, -1, 0, 5)
    for side, product in (("left", q * p), ("right", p * q)):
        rows = q.matrix(side=side)
        assert tuple(
            sum(m * x for m, x in zip(row, p.coordinates, strict=True)) for row in rows
        ) == (product.coordinates)
    (a, b), (c, d) = q.matrix(over="QQ(I)")
    assert a * d - b * c == q.norm()
    with pytest.raises(CoercionError, match="side='up'"):
        q.matrix(side="up")
    with pytest.raises(CoercionError, match="division algebra"):
        q.matrix(over="QQ(sqrt(2))")


def test_numpy_and_python_call_the_methods() -> None:
    q = A(*random_batch(5, 7))
    assert (np.abs(q) == abs(q)).all()
    for f in (np.exp, np.log, np.sqrt):
        assert (f(q) == getattr(q, f.__name__)()).all()
    assert ((np.arange(5.0) * q) == q * np.arange(5.0)).all()
    assert type(np.float64(2) * q) is type(q)
    assert (np.ones(5) + q == q + 1).all()
    assert (np.ones(5) - q == 1 - q).all()
    with pytest.raises(TypeError):
        np.sin(q)
    assert float(A(3)) == 3.0
    with pytest.raises(TypeError, match="not a scalar"):
        float(A(0, 1, 0, 0))
    assert f"{H('QQ')(1, 2, 0, 0):latex}" == H("QQ")(1, 2, 0, 0).text("latex")


def test_lengths_at_the_ends_of_the_floats() -> None:
    assert abs(A(3e200, 4e200, 0, 0)) == pytest.approx(5e200)
    assert abs(A([3e-200, 0.0], 0, [4e-200, 0.0], 0)).tolist() == pytest.approx([5e-200, 0.0])
    assert A(0).polar() == (0.0, A(0, 1, 0, 0), 0.0)
    assert A(-2).polar() == (2.0, A(0, 1, 0, 0), math.pi)
    for a, b, axis in ((-3, -1, 2), (1, 1, 3)):  # the first of i, j, k whose square is −1
        B = QuaternionAlgebra("RDF", a, b)
        assert B(-2).polar() == (2.0, B.basis[axis], math.pi)
    with pytest.raises(NoSolutionError, match="the axis of a scalar"):
        QuaternionAlgebra("RDF", -2, -3)(-2).polar()
    assert A(0).exp() == 1
    assert A(0).sqrt() == 0


@pytest.mark.parametrize(
    ("call", "error", "text"),
    [
        (lambda: A(-1).log(), NoSolutionError, "negative scalar"),
        (lambda: A(0).log(), NoSolutionError, "it is 0"),
        (lambda: A([1.0, -4.0], 0, 0, 0).sqrt(), NoSolutionError, r"index \(1,\)"),
        (lambda: A(800, 0, 0, 0).exp(), NoSolutionError, "too large"),
        (lambda: A(0).unit(), NotInvertibleError, "0"),
        (lambda: abs(H("QQ")(1, 1, 0, 0)), NoSolutionError, "RR"),
        (lambda: abs(H("GF(7)")(1, 1, 0, 0)), RingError, "no ordering"),
        (lambda: H("QQ")(1, 1, 0, 0).exp(), RingError, "change_ring"),
        (lambda: H("RR")(1, 2, 0, 0).log(), CoercionError, "multiple of π"),
        (lambda: H("QQ")(-4).sqrt(), NoSolutionError, "square_roots"),
        (lambda: H("QQ")(1, 1, 0, 0) ** 0.3, CoercionError, "multiple of 1/2"),
        (lambda: H("QQ")(1) ** "2", CoercionError, "not a number"),
        (lambda: A(1, 2, 3, 4).roots(0), CoercionError, "positive int"),
        (lambda: A.from_polar(1, (1, 1, 0), 1.0), CoercionError, "modulus"),
        (
            lambda: QuaternionAlgebra("RDF", 1, 1)(0, 1, 0, 0).polar(),
            NoSolutionError,
            "no polar form",
        ),
    ],
)
def test_what_has_no_value(call: Callable[[], object], error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        call()
