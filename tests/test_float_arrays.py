"""Arrays of floats in and out, rotations as quaternions, complex floats, and the compiled loops."""

from typing import Any

import numpy as np
import pytest

from hfield import (
    CDF,
    RDF,
    CoercionError,
    H,
    QuaternionAlgebra,
    RingError,
    UndecidedError,
    check,
    prove,
)
from hfield.algebra.structure.elements import float_functions
from hfield.fields.base.array_storage.floats import MIN_COMPILED
from rotation import Rotation
from rotation.compat import Rotation as ScipysRotation

A, C = H(RDF), H(CDF)
RNG = np.random.default_rng(1)


@pytest.mark.parametrize("algebra", [A, C, H("GF(7)"), H("QQ"), H("ZZ")])
def test_the_axis_of_coordinates(algebra: Any) -> None:
    q = algebra([[1, 2, 3], [4, 5, 6]], 0, 1, [[0, 0, 0], [1, 1, 1]])
    count = 5 if algebra.ring.name == "QQ" else 4
    assert q.to_array().shape == (count, 2, 3)
    last = q.to_array(axis=-1)
    assert last.shape == (2, 3, count)
    assert (algebra.from_array(last, axis=-1) == q).all()
    assert (algebra.from_array(q.to_array()) == q).all()
    assert algebra.from_array(last[0, 1], axis=-1) == q[0, 1]
    with pytest.raises(CoercionError, match="axis=1"):
        q.to_array(axis=1)
    with pytest.raises(CoercionError, match="axis=2"):
        algebra.from_array(last, axis=2)


def test_no_copy_is_made_where_none_is_needed() -> None:
    x = RNG.normal(size=(5, 4))
    assert np.shares_memory(A.from_array(x, axis=-1, copy=False).to_array(axis=-1), x)
    copied = A.from_array(x, axis=-1)
    assert not np.shares_memory(copied.to_array(), x)
    assert (copied.to_array(axis=-1) == x).all()
    assert np.shares_memory(copied.to_array(), copied.to_array(axis=-1))
    with pytest.raises(ValueError, match="read-only"):
        copied.to_array()[0, 0] = 1
    q = A.from_array(x.astype(np.float32), axis=-1, copy=False)
    assert np.allclose(q.to_array(axis=-1), x)
    for wrong in (np.zeros((5, 3)), np.array(1.0), np.full((4, 2), np.nan), np.array(["a"] * 4)):
        with pytest.raises(CoercionError):
            A.from_array(wrong)
    with pytest.raises(CoercionError, match="float64"):
        A.from_array(np.zeros((4, 2), complex))


@pytest.mark.parametrize("kind", [Rotation, ScipysRotation])
def test_rotations_are_unit_quaternions(kind: Any) -> None:
    """q·v·q⁻¹ is the rotated v, and the product of quaternions the composition."""
    r, s = (
        kind.from_rotvec([[0.3, -1.0, 2.0], [0, 0, np.pi / 2]]),
        kind.from_rotvec([0.1, 0.2, 0.3]),
    )
    q, p = A(r), A(s)
    assert q.shape == (2,)
    assert p.shape == ()
    v = A(0, 1.0, 2.0, 3.0)
    turned = (q * v * q.inverse()).to_array(axis=-1)[:, 1:]
    assert np.allclose(turned, r.apply([1.0, 2.0, 3.0]))
    assert np.allclose(A(r * s).to_array(), (q * p).to_array())
    assert abs(q[1] - A(0.5**0.5, 0, 0, 0.5**0.5)) < 1e-15
    for other in (H("QQ"), QuaternionAlgebra(RDF, -1, -2)):
        with pytest.raises(CoercionError, match="rotation"):
            other(r)


def test_arrays_change_their_ring() -> None:
    q = H("QQ")([1, "1/2"], 2, 0, 1)
    assert (q.change_ring("RDF") == A([1, 0.5], 2, 0, 1)).all()
    assert (q.change_ring("RDF").change_ring("CDF") == C([1, 0.5], 2, 0, 1)).all()
    assert (q.change_ring("GF(7)") == H("GF(7)")([1, 4], 2, 0, 1)).all()


def test_compiled_loops_beside_the_formulas(monkeypatch: pytest.MonkeyPatch) -> None:
    """Loops over many elements give what numpy gives, up to rounding."""
    p, q = (A.from_array(RNG.normal(size=(4, MIN_COMPILED + 7))) for _ in range(2))
    B = QuaternionAlgebra(RDF, 2, -3, 1)
    x, y = B.from_array(p.to_array()), B.from_array(q.to_array())

    def results() -> list[np.ndarray]:
        found = [p * q, p + q, p - q, -p, p.conjugate(), p * q[3], p.sqrt(), x * y, x.conjugate()]
        return [*(z.to_array() for z in found), abs(p), p.norm(), x.norm()]

    quick = results()
    for algebra in (A, B):
        monkeypatch.setattr(algebra.array_storage, "_compiles", lambda size: False)
    monkeypatch.setattr(float_functions, "MIN_COMPILED", 10**9)
    for fast, slow in zip(quick, results(), strict=True):
        assert np.abs(fast - slow).max() <= 1e-14 * (1 + np.abs(slow).max())


def test_loops_leave_what_is_out_of_range_to_the_careful_way() -> None:
    q = np.zeros((4, MIN_COMPILED))
    q[0] = 1.0
    q[:, 5] = (3e200, 4e200, 0, 0)
    assert abs(A.from_array(q))[5] == pytest.approx(5e200)
    q[:, 5] = 0
    assert A.from_array(q).sqrt()[5] == 0
    q[:, 6] = (-1, 0, 0, 0)
    with pytest.raises(ValueError, match=r"index \(6,\)"):
        A.from_array(q).sqrt()


# --- CDF ----------------------------------------------------------------------------------------------


def test_complex_floats() -> None:
    assert CDF("1 + 2*I") == 1 + 2j
    assert CDF("sqrt(-2)") == pytest.approx(2**0.5 * 1j)
    assert CDF(np.complex64(1j)) == 1j
    assert CDF(CDF.text(0.5 - 2j)) == 0.5 - 2j
    assert CDF.sqrt(CDF("-1")) == 1j
    for junk in (float("nan"), complex("inf"), None, "x"):
        with pytest.raises((CoercionError, ValueError)):
            CDF(junk)
    assert not CDF.is_exact
    assert "CC is exact" in CDF.level.reason


def test_matrices_over_complex_floats() -> None:
    """They multiply as the quaternions do; their determinants are the norms (thesis 1.4.3)."""
    for B in (A, QuaternionAlgebra(RDF, 2, -3, 1), QuaternionAlgebra(RDF, -2, -5)):
        p, q = B(1, 2, -3, 0.5), B(0.5, -1, 1, 3)
        m, n, product = (np.array(x.matrix(over="CDF")) for x in (p, q, p * q))
        assert np.allclose(m @ n, product)
        assert np.linalg.det(m) == pytest.approx(p.norm())
    exact = H("QQ")(1, 2, 3, 4).matrix(over="QQ(I)")
    shown = [[complex(str(x).replace("*I", "j")) for x in row] for row in exact]
    assert np.allclose(A(1, 2, 3, 4).matrix(over="CDF"), shown)
    (a, _), _ = A([1, 2], 0, 0, 1).matrix(over="CDF")
    assert a.shape == (2,)
    assert C.from_matrix(C.to_matrix(C(1, 2j, 3, 4))) == C(1, 2j, 3, 4)


def test_complex_floats_prove_nothing() -> None:
    assert prove("norm(p*q) == norm(p)*norm(q)", field="CDF").verdict == "undecided"
    refuted = prove("p*q == q*p", field="CDF")
    assert refuted.verdict == "refuted"
    assert check(refuted.certificate).verdict == "refuted"
    q = C([1, 2], "I", 0, 1)
    for call in (C.is_division_algebra, C.zero_norm_element, C.split, q[0].square_roots):
        with pytest.raises(UndecidedError, match="inexact"):
            call()
    for call in (q.exp, q.log, q.sqrt, q.polar, lambda: abs(q), lambda: q**0.5):
        with pytest.raises(RingError, match="over RDF"):
            call()
    with pytest.raises(CoercionError, match="RDF"):
        C.matrix([["i", 1], [0, "j"]]).svd()
    with pytest.raises(TypeError):
        hash(q[0])
