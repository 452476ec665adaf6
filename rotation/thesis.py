"""The thesis's own functions (3.1.1, 3.1.2, 3.4.2, 3.4.4): rotations in pure Python lists.

They are the historical baseline of the benchmark and of the animation. So names, arguments and the order of
operations are those of the text: a quaternion is passed as its scalar part and a list of three, and there are
no loops, conditions or checks. Errors of the text are corrected in the functions, and their docstrings quote
the text.

Apart from ``cos``, ``sin`` and ``sqrt`` they only add, subtract, multiply and divide, so the same code runs
on symbols; this is how the ledger proves them.

The matrix functions multiply by ``matmul``: numpy's in the thesis, here one for lists. To measure the
thesis's timings, pass ``matmul=numpy.matmul``.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, sin, sqrt
from typing import Any

Scalar = Any  # a float, or whatever else can be added and multiplied
Vector = list[Any]  # of three scalars
Matrix = list[list[Any]]  # three rows of three
Product = Callable[[Any, Any], Any]


def dotProduct(v1: Vector, v2: Vector) -> Scalar:
    """Return the sum of the products of corresponding entries (3.1.1)."""
    return v1[0] * v2[0] + v1[1] * v2[1] + v1[2] * v2[2]


def crossProduct(v1: Vector, v2: Vector) -> Vector:
    """Return the vector product ``v1 × v2`` (3.1.1)."""
    return [
        v1[1] * v2[2] - v1[2] * v2[1],
        v1[2] * v2[0] - v1[0] * v2[2],
        v1[0] * v2[1] - v1[1] * v2[0],
    ]


def scalarVector(a: Scalar, v: Vector) -> Vector:
    """Return the vector ``v`` times the scalar ``a`` (3.1.1)."""
    return [a * v[0], a * v[1], a * v[2]]


def addingVectorPart(v1: Vector, v2: Vector) -> Vector:
    """Return the sum of two vectors (3.1.1)."""
    return [v1[0] + v2[0], v1[1] + v2[1], v1[2] + v2[2]]


def multiQuaternion(a1: Scalar, v1: Vector, a2: Scalar, v2: Vector) -> list[Any]:
    """Return the product of the quaternions ``a1 + v1`` and ``a2 + v2`` as ``[scalar, vector]`` (3.1.1).

    The text prints the scalar part ``a1 - a2 - dotProduct(v1, v2)``, with the difference of a1 and a2 instead
    of their product.
    """
    return [
        a1 * a2 - dotProduct(v1, v2),
        addingVectorPart(
            addingVectorPart(crossProduct(v1, v2), scalarVector(a1, v2)), scalarVector(a2, v1)
        ),
    ]


def conjugateQuaternion(a: Scalar, v: Vector) -> list[Any]:
    """Return the conjugate of ``a + v`` as ``[a, -v]`` (3.1.1)."""
    return [a, [-v[0], -v[1], -v[2]]]


def rotationquaternion(angle: Scalar, rotation_axis: Vector, element: Vector) -> Vector:
    """Return ``element`` rotated about ``rotation_axis``, of length 1, by ``angle`` in radians (3.1.1).

    The trigonometric form with θ rotates by 2θ (Theorem 6), so θ is half of ``angle``; the text does not say
    this. Its "inverse by ``conjugateQuaternion``" is correct because the axis has length 1: with another
    length the result is neither a rotation by ``angle`` nor of the same length.
    """
    return rotationquaternionChaged(
        cos(0.5 * angle), scalarVector(sin(0.5 * angle), rotation_axis), element
    )


def rotationquaternionNormalized(angle: Scalar, rotation_axis: Vector, element: Vector) -> Vector:
    """Return the same for an axis of any nonzero length (3.1.1); the text does not name this function.

    Raises ZeroDivisionError for the axis 0.
    """
    return rotationquaternion(angle, NormalizeVector(rotation_axis), element)


def NormalizeVector(v: Vector) -> Vector:
    """Return ``v`` divided by its Euclidean norm (3.1.1). Raises ZeroDivisionError for 0."""
    norm = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return [v[0] / norm, v[1] / norm, v[2] / norm]


def rotationquaternionChaged(scalar: Scalar, rotation_axis: Vector, element: Vector) -> Vector:
    """Return ``element`` rotated by the unit quaternion ``scalar + rotation_axis`` (3.4.2).

    The name is spelt as in the thesis. The result is the vector part of q·element·q̄.
    """
    inverse = conjugateQuaternion(scalar, rotation_axis)
    left = multiQuaternion(scalar, rotation_axis, 0, element)
    vector: Vector = multiQuaternion(left[0], left[1], inverse[0], inverse[1])[1]
    return vector


def matmul(matrix: Matrix, other: Any) -> Any:
    """Return a 3 × 3 matrix times a matrix of three rows, or times a list of three."""
    if isinstance(other[0], list):
        columns = zip(
            *(matmul(matrix, list(column)) for column in zip(*other, strict=True)), strict=True
        )
        return [list(row) for row in columns]
    return [
        dotProduct(matrix[0], other),
        dotProduct(matrix[1], other),
        dotProduct(matrix[2], other),
    ]


def xaxisMatrixrotation(angle: Scalar) -> Matrix:
    """Return the matrix of the rotation about the x axis by ``angle`` in radians (3.1.2)."""
    c, s = cos(angle), sin(angle)
    return [[1, 0, 0], [0, c, -s], [0, s, c]]


def yaxisMatrixrotation(angle: Scalar) -> Matrix:
    """Return the matrix of the rotation about the y axis by ``angle`` in radians (3.1.2)."""
    c, s = cos(angle), sin(angle)
    return [[c, 0, s], [0, 1, 0], [-s, 0, c]]


def zaxisMatrixrotation(angle: Scalar) -> Matrix:
    """Return the matrix of the rotation about the z axis by ``angle`` in radians (3.1.2)."""
    c, s = cos(angle), sin(angle)
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


def rotationMatrixZYX(
    psi: Scalar, phi: Scalar, theta: Scalar, *, matmul: Product = matmul
) -> Matrix:
    """Return R_z(psi)·R_y(phi)·R_x(theta), the matrix for the Euler angle (psi, phi, theta) (3.1.2).

    Angles are in radians. The letters are those of 3.1.2; chapter 2 calls the same three φ, θ, ψ.
    """
    matrix: Matrix = matmul(
        zaxisMatrixrotation(psi), matmul(yaxisMatrixrotation(phi), xaxisMatrixrotation(theta))
    )
    return matrix


def rotationbyMatrix(matrix: Matrix, point: Vector, *, matmul: Product = matmul) -> Vector:
    """Return the 3 × 3 ``matrix`` times ``point`` (3.1.2)."""
    vector: Vector = matmul(matrix, point)
    return vector


def rotationMatrixFromQuaternion(angle: Scalar, rotation_axis: Vector) -> Matrix:
    """Return the matrix of the rotation by ``angle`` about ``rotation_axis``, normalised first (3.4.4).

    Here a + bi + cj + dk = cos(angle/2) + sin(angle/2)·u. The text prints the entry in the second row and
    third column as 2(cd + ab); the correct entry is 2(cd − ab). Raises ZeroDivisionError for the axis 0.
    """
    a = cos(0.5 * angle)
    b, c, d = scalarVector(sin(0.5 * angle), NormalizeVector(rotation_axis))
    return [
        [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
        [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
        [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d],
    ]
