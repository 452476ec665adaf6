"""The thesis's own functions: exact on rationals against hfield, on floats against numpy."""

import ast
import inspect
import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hfield.core.product import Constants, conjugate, multiply
from rotation import thesis

H = Constants(-1, 0, -1)
rationals = st.fractions(min_value=-9, max_value=9, max_denominator=9)
vectors = st.lists(rationals, min_size=3, max_size=3)
floats = st.floats(-10, 10).map(lambda x: round(x, 3))
points = st.lists(floats, min_size=3, max_size=3)
angles = st.floats(-7, 7)
axes = points.filter(lambda v: sum(x * x for x in v) > 1e-3)


@given(vectors, vectors, rationals)
def test_vectors(v: list[Fraction], w: list[Fraction], a: Fraction) -> None:
    assert thesis.dotProduct(v, w) == sum(x * y for x, y in zip(v, w, strict=True))
    assert thesis.crossProduct(v, w) == list(multiply(H, (0, *v), (0, *w))[1:])
    assert thesis.scalarVector(a, v) == [a * x for x in v]
    assert thesis.addingVectorPart(v, w) == [x + y for x, y in zip(v, w, strict=True)]


@given(rationals, vectors, rationals, vectors)
def test_the_product_and_the_conjugate_are_those_of_hfield(
    a1: Fraction, v1: list[Fraction], a2: Fraction, v2: list[Fraction]
) -> None:
    scalar, vector = thesis.multiQuaternion(a1, v1, a2, v2)
    assert (scalar, *vector) == multiply(H, (a1, *v1), (a2, *v2))
    scalar, vector = thesis.conjugateQuaternion(a1, v1)
    assert (scalar, *vector) == conjugate(H, (a1, *v1))


@given(rationals, vectors, vectors)
def test_a_rational_unit_quaternion_turns_rational_points_exactly(
    a: Fraction, v: list[Fraction], x: list[Fraction]
) -> None:
    norm = a * a + thesis.dotProduct(v, v)
    if not norm:
        return
    q = multiply(H, (a, *v), (a, *v))  # its norm is a square
    unit = [c / norm for c in q]
    turned = thesis.rotationquaternionChaged(unit[0], unit[1:], x)
    assert (0, *turned) == multiply(H, multiply(H, unit, (0, *x)), conjugate(H, unit))
    assert thesis.dotProduct(turned, turned) == thesis.dotProduct(x, x)


def test_the_right_hand_rule() -> None:
    quarter = math.pi / 2
    for axis, start, end in (((0, 0, 1), (1, 0, 0), (0, 1, 0)), ((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        turned = thesis.rotationquaternion(quarter, list(axis), list(start))
        assert turned == pytest.approx(end, abs=1e-15)
    assert thesis.rotationbyMatrix(thesis.yaxisMatrixrotation(quarter), [0, 0, 1]) == pytest.approx(
        [1, 0, 0], abs=1e-15
    )


@given(angles, axes, points)
def test_by_quaternion_and_by_matrix(angle: float, axis: list[float], x: list[float]) -> None:
    turned = thesis.rotationquaternionNormalized(angle, axis, x)
    matrix = thesis.rotationMatrixFromQuaternion(angle, axis)
    assert turned == pytest.approx(thesis.rotationbyMatrix(matrix, x), abs=1e-13)
    u = np.array(axis) / np.linalg.norm(axis)
    rodrigues = (
        math.cos(angle) * np.array(x)
        + math.sin(angle) * np.cross(u, x)
        + (1 - math.cos(angle)) * np.dot(u, x) * u
    )
    assert turned == pytest.approx(list(rodrigues), abs=1e-13)


@given(angles, points)
def test_the_matrices_of_the_axes(angle: float, x: list[float]) -> None:
    named = {
        thesis.xaxisMatrixrotation: [1, 0, 0],
        thesis.yaxisMatrixrotation: [0, 1, 0],
        thesis.zaxisMatrixrotation: [0, 0, 1],
    }
    for function, axis in named.items():
        turned = thesis.rotationbyMatrix(function(angle), x)
        assert turned == pytest.approx(thesis.rotationquaternion(angle, axis, x), abs=1e-13)


@given(angles, angles, angles, points)
def test_the_euler_angle_turns_about_x_first(
    psi: float, phi: float, theta: float, x: list[float]
) -> None:
    step = thesis.rotationquaternion(theta, [1, 0, 0], x)
    step = thesis.rotationquaternion(phi, [0, 1, 0], step)
    step = thesis.rotationquaternion(psi, [0, 0, 1], step)
    matrix = thesis.rotationMatrixZYX(psi, phi, theta)
    assert thesis.rotationbyMatrix(matrix, x) == pytest.approx(step, abs=1e-13)


def test_with_the_matmul_of_numpy_as_in_the_thesis() -> None:
    own = thesis.rotationMatrixZYX(0.1, 0.2, 0.3)
    numpys = thesis.rotationMatrixZYX(0.1, 0.2, 0.3, matmul=np.matmul)
    assert np.allclose(own, numpys, rtol=0, atol=1e-15)
    point = thesis.rotationbyMatrix(numpys, [1.0, 2.0, 3.0], matmul=np.matmul)
    assert np.allclose(point, thesis.rotationbyMatrix(own, [1.0, 2.0, 3.0]), rtol=0, atol=1e-15)


@given(axes)
def test_a_normalised_vector(v: list[float]) -> None:
    unit = thesis.NormalizeVector(v)
    assert math.hypot(*unit) == pytest.approx(1)
    assert thesis.crossProduct(unit, v) == pytest.approx([0, 0, 0], abs=1e-13)


def test_the_axis_0() -> None:
    for call in (
        lambda: thesis.NormalizeVector([0.0, 0.0, 0.0]),
        lambda: thesis.rotationquaternionNormalized(1.0, [0.0, 0.0, 0.0], [1.0, 2.0, 3.0]),
        lambda: thesis.rotationMatrixFromQuaternion(1.0, [0.0, 0.0, 0.0]),
    ):
        with pytest.raises(ZeroDivisionError):
            call()


def test_no_loops_and_no_conditions_as_the_thesis_decided() -> None:
    for name, function in inspect.getmembers(thesis, inspect.isfunction):
        if function.__module__ == thesis.__name__ and name != "matmul":
            tree = ast.parse(inspect.getsource(function))
            banned = (ast.For, ast.While, ast.If, ast.IfExp, ast.comprehension, ast.BoolOp)
            assert not [node for node in ast.walk(tree) if isinstance(node, banned)], name
