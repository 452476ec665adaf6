"""The types that users see: mypy checks this module, and running it compares them with the values."""

from typing import Any, assert_type

import numpy as np

from hfield import GF, QQ, RDF, H, NumberField, QuaternionAlgebra, norm
from hfield.algebra.quaternion import Quaternion, SquareRoots
from hfield.fields.number_fields.elements import FieldElement
from hfield.orders.lattice import Lattice
from hfield.polynomials.roots import Roots
from rotation import BSpline, RigidTransform, Rotation, RotationSpline


def test_elements_have_the_coordinates_of_their_ring() -> None:
    q = H(RDF)(1, 2, 0, 1)
    assert_type(q, Quaternion[float])
    for x in (assert_type(q.norm(), float), assert_type(norm(q), float), *q.coordinates):
        assert isinstance(x, float)
    K = NumberField("s^2-2")
    p = QuaternionAlgebra(K, -1, -1)("1 + s*i")
    for y in (assert_type(p.trace(), FieldElement), *p.vector, *p.matrix()[0]):
        assert isinstance(y, FieldElement)
    assert isinstance(assert_type(p.square_roots(), SquareRoots[FieldElement]), SquareRoots)
    assert isinstance(assert_type(H(QQ)("1/2*i").change_ring(RDF).norm(), float), float)


def test_arithmetic_keeps_the_type_of_single_elements() -> None:
    q = H(RDF)(1, 2, 0, 1)
    for x in (q * q + 1, 2 * q - q / 3, -q, q**2, q.conj().inverse()):
        assert isinstance(assert_type(x, Quaternion[float]).norm(), float)
    assert isinstance(assert_type(q.is_zero(), bool), bool)
    assert isinstance(assert_type(q.roots(2), Roots), Roots)


def test_arrays_are_told_apart_from_single_elements() -> None:
    rows = H(RDF)(np.zeros(2), 0, 0, 1)
    assert_type(rows, Quaternion[Any])
    assert assert_type(rows.norm(), Any).shape == (2,)
    assert rows.is_zero().shape == (2,)
    assert assert_type(H(RDF)(1, 2, 0, 1) * np.zeros(2), Quaternion[Any]).shape == (2,)


def test_texts_name_algebras_of_any_elements() -> None:
    assert_type(QuaternionAlgebra("QQ", -1, -1), QuaternionAlgebra[Any])
    assert_type(H("GF(7)").one, Quaternion[Any])
    read = H(QQ).read("[1, i, j, k]")
    assert isinstance(read, Lattice)
    assert isinstance(H(GF(7)).read("[1, 2, 0, 1]"), Quaternion)


def test_flags_and_orders_choose_results_of_rotations() -> None:
    axes = np.eye(3)
    r, _ = Rotation.align_vectors(axes, axes)
    assert_type(r, Rotation)
    r, _, covariance = Rotation.align_vectors(axes, axes, return_sensitivity=True)
    assert covariance.shape == (3, 3)
    assert isinstance(assert_type(r.reduce(), Rotation), Rotation)
    keys = Rotation.from_rotvec([[0, 0, 0.1 * n] for n in range(4)])
    spline = RotationSpline(range(4), keys)
    assert isinstance(assert_type(spline(1.5), Rotation), Rotation)
    assert spline(1.5, 1).shape == (3,)
    motions = BSpline(RigidTransform.from_rotation(keys))
    assert isinstance(assert_type(motions(0.5), RigidTransform), RigidTransform)
