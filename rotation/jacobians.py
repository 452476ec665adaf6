"""Derivatives of rotation vectors: the Jacobians of the exponential and of the logarithm.

``J(v) = 1 + A·[v]× + B·[v]×²`` with ``A = (1 − cos θ)/θ²`` and ``B = (θ − sin θ)/θ³``, θ the length
of v; its inverse is ``1 − ½·[v]× + C·[v]×²`` with ``C = (1 − (θ/2)·cot(θ/2))/θ²``. G. S. Chirikjian,
"Stochastic models, information theory, and Lie groups" 2 (2012), section 10.3.
"""

import math
from fractions import Fraction
from typing import Any

from rotation.coordinates import Coordinates, factor, join, polynomial, split, sum_of_squares
from rotation.namespaces import Array, expect_last, floats, namespace
from rotation.rowwise import Formula

_TERMS = 12
# By t = θ²: of A, B and C, whose quotients lose their digits where t is small.
_A = [(-1.0) ** k / math.factorial(2 * k + 2) for k in range(_TERMS)]
_B = [(-1.0) ** k / math.factorial(2 * k + 3) for k in range(_TERMS)]
_BERNOULLI = (
    "1/6 1/30 1/42 1/30 5/66 691/2730 7/6 3617/510 43867/798 174611/330 854513/138 236364091/2730"
)
_C = [float(Fraction(b) / math.factorial(2 * k)) for k, b in enumerate(_BERNOULLI.split(), start=1)]
_NEAR = 1.0


def left_jacobian(rotvec: Any) -> Array:
    """Return the left Jacobians (…, 3, 3) of the exponential at rotation vectors (…, 3), in radians.

    ``exp(v + dv) = exp(J(v)·dv)·exp(v)`` to first order. The right Jacobian is ``left_jacobian(-v)``. A
    body whose rotation vector changes at the rate v̇ has the angular velocity ``J(v)·v̇`` in the axes of
    the world.

    Raises
    ------
    RotationError
        The last axis is not of three.

    Examples
    --------
    >>> left_jacobian([math.pi, 0, 0]).round(4) + 0.0  # half a turn about x
    array([[ 1.    ,  0.    ,  0.    ],
           [ 0.    ,  0.    , -0.6366],
           [ 0.    ,  0.6366,  0.    ]])
    """
    return _LEFT(_vectors(rotvec))


def inverse_left_jacobian(rotvec: Any) -> Array:
    """Return the inverses (…, 3, 3) of the left Jacobians: those of the logarithm.

    ``log(exp(dv)·exp(v)) = v + J⁻¹(v)·dv`` to first order. At lengths that are multiples of 2π
    other than 0 there is none: entries are large or not finite there.

    Raises
    ------
    RotationError
        The last axis is not of three.

    Examples
    --------
    >>> (inverse_left_jacobian([1, 2, 3]) @ left_jacobian([1, 2, 3])).round(12) + 0.0
    array([[1., 0., 0.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """
    return _INVERSE(_vectors(rotvec))


def _vectors(rotvec: Any) -> Array:
    v = floats(rotvec, "rotation vectors")
    expect_last(v, (3,), "rotation vectors")
    return v


def _parts(xp: Any, v: Coordinates) -> tuple[Array, Array, Coordinates, Array]:
    """Return where v is short enough for series, θ² there, v there and elsewhere its direction, and θ/2.

    Nothing is squared where that may overflow, and where a value is not asked for it is harmless.
    """
    t = sum_of_squares(v)
    near = t < _NEAR
    far = tuple(xp.where(near, xp.ones_like(t), c) for c in v)
    f = factor(xp, far)
    scaled = tuple(f * c for c in far)
    n = xp.sqrt(sum_of_squares(scaled))
    part = 1.0 / n
    axis = tuple(xp.where(near, c, part * u) for c, u in zip(v, scaled, strict=True))
    return near, xp.where(near, t, xp.zeros_like(t)), axis, 0.5 * n / f


def exponential_factors(xp: Any, v: Coordinates) -> tuple[Coordinates, Array, Array]:
    """Return the vectors u, and a and b, for which J(v) is ``1 + a·[u]× + b·[u]×²``."""
    near, small, axis, half = _parts(xp, v)
    sine, cosine = xp.sin(half), xp.cos(half)
    a = xp.where(near, polynomial(_A, small), sine * (sine / half))
    b = xp.where(near, polynomial(_B, small), 1.0 - cosine * (sine / half))
    return axis, a, b


def logarithm_factor(xp: Any, v: Coordinates) -> tuple[Coordinates, Array]:
    """Return the vectors u, and c, for which J⁻¹(v) is ``1 − ½·[v]× + c·[u]×²``."""
    near, small, axis, half = _parts(xp, v)
    return axis, xp.where(near, polynomial(_C, small), 1.0 - half * xp.cos(half) / xp.sin(half))


def _matrix(xp: Any, linear: Coordinates, axis: Coordinates, square: Array) -> Array:
    """``1 + [linear]× + square·[axis]×²``."""
    (p, q, r), (x, y, z) = linear, axis
    one = xp.ones_like(square)
    xy, xz, yz = square * (x * y), square * (x * z), square * (y * z)
    entries = [
        [one - square * (y * y + z * z), xy - r, xz + q],
        [xy + r, one - square * (x * x + z * z), yz - p],
        [xz - q, yz + p, one - square * (x * x + y * y)],
    ]
    return xp.stack([join(xp, tuple(row)) for row in entries], axis=-2)


def _left(v: Array) -> Array:
    xp = namespace(v)
    axis, a, b = exponential_factors(xp, split(v))
    return _matrix(xp, tuple(a * c for c in axis), axis, b)


def _inverse(v: Array) -> Array:
    xp = namespace(v)
    axis, c = logarithm_factor(xp, split(v))
    return _matrix(xp, tuple(-0.5 * x for x in split(v)), axis, c)


_LEFT = Formula(_left, (3,))
_INVERSE = Formula(_inverse, (3,))
