"""First-order formulas for exponentials of rotations and rigid motions: hat and vee, Jacobians, ad.

A tangent has three coordinates, a rotation vector v, or six, the exponential coordinates (v, u) of a rigid
motion. Let θ be the length of v. Then ``J(v) = 1 + A·[v]× + B·[v]×²`` with ``A = (1 − cos θ)/θ²`` and ``B =
(θ − sin θ)/θ³``; its inverse is ``1 − ½·[v]× + C·[v]×²`` with ``C = (1 − (θ/2)·cot(θ/2))/θ²``. Rigid motions
are rotations over dual numbers: their Jacobian is ``J(v + ε·u)``, with blocks ``J(v)`` and the derivative of
J at v along u. G. S. Chirikjian, "Stochastic models, information theory, and Lie groups" 2 (2012), section
10.3; T. D. Barfoot, "State estimation for robotics" (2017), section 7.1.
"""

from __future__ import annotations

import math
from fractions import Fraction

from rotation.array_types import Array, ArrayLike, Namespace
from rotation.coordinates import Coordinates, factor, join, polynomial, split, sum_of_squares
from rotation.errors import RotationError
from rotation.namespaces import floats, namespace, quiet, refuse_rows
from rotation.rowwise import RowFormula

_TERMS = 12
# Series in t = θ² for A, B and C, whose quotients lose digits if t is small, and for twice their
# derivatives.
_A = [(-1.0) ** k / math.factorial(2 * k + 2) for k in range(_TERMS)]
_B = [(-1.0) ** k / math.factorial(2 * k + 3) for k in range(_TERMS)]
_BERNOULLI = (
    "1/6 1/30 1/42 1/30 5/66 691/2730 7/6 3617/510 43867/798 174611/330 854513/138 236364091/2730"
)
_C = [float(Fraction(b) / math.factorial(2 * k)) for k, b in enumerate(_BERNOULLI.split(), start=1)]
_DA, _DB, _DC = ([2.0 * k * x for k, x in enumerate(s) if k] for s in (_A, _B, _C))
_NEAR = 1.0
Entries = list[list[Array]]


def hat(tangent: ArrayLike) -> Array:
    """Return the matrices of tangents: ``[v]×`` (…, 3, 3) for (…, 3), ``[[ [v]×, u ], [0, 0]]`` for (…, 6).

    Their exponentials are the matrices of the rotations and of the rigid motions.

    Raises
    ------
    RotationError
        The last axis is neither of three nor of six.

    Examples
    --------
    >>> hat([1, 2, 3])
    array([[ 0., -3.,  2.],
           [ 3.,  0., -1.],
           [-2.,  1.,  0.]])
    """
    v = _tangents(tangent)
    return _HAT[v.shape[-1]](v)


@quiet
def vee(matrix: ArrayLike) -> Array:
    """Return the tangents, (…, 3) or (…, 6), of matrices (…, 3, 3) or (…, 4, 4): the inverse of `hat`.

    A matrix that contains NaN or inf gives NaN.

    Raises
    ------
    RotationError
        Another shape; or a matrix that is not a result of `hat`: the 3 × 3 block is not skew-symmetric, or
        the last of four rows is not zero, to within 1e-9 of the largest entry (float32: 1e-4).

    Examples
    --------
    >>> vee(hat([1, 2, 3, 4, 5, 6]))
    array([1., 2., 3., 4., 5., 6.])
    """
    m = floats(matrix, "matrices")
    if tuple(m.shape[-2:]) not in ((3, 3), (4, 4)):
        raise RotationError(f"matrices has shape {tuple(m.shape)}; expected (…, 3, 3) or (…, 4, 4)")
    xp = namespace(m)
    found = [m[..., 2, 1] - m[..., 1, 2], m[..., 0, 2] - m[..., 2, 0], m[..., 1, 0] - m[..., 0, 1]]
    turn = join(xp, tuple(0.5 * c for c in found))
    tangent = turn if m.shape[-1] == 3 else xp.concat([turn, m[..., :3, 3]], axis=-1)
    largest = xp.max(xp.abs(m), axis=(-2, -1))
    off = xp.max(xp.abs(m - hat(tangent)), axis=(-2, -1))
    allowed = 1e-9 if xp.finfo(m.dtype).bits == 64 else 1e-4
    refuse_rows(off > allowed * largest, "the matrix", "is not a tangent: hat does not make it")
    finite = xp.all(xp.isfinite(m), axis=(-2, -1))[..., None]
    return xp.where(finite, tangent, xp.nan * tangent)


def ad(tangent: ArrayLike) -> Array:
    """Return the matrices of ``y ↦ [x, y]``: (…, 3, 3) for tangents (…, 3), (…, 6, 6) for tangents (…, 6).

    ``exp(ad(x))`` is the adjoint of ``exp(x)``; ``hat(ad(x)·y) = hat(x)·hat(y) − hat(y)·hat(x)``.

    Raises
    ------
    RotationError
        The last axis is neither of three nor of six.

    Examples
    --------
    >>> ad([1, 0, 0, 0, 0, 0]) @ [0, 1, 0, 0, 0, 0]
    array([0., 0., 1., 0., 0., 0.])
    """
    v = _tangents(tangent)
    return _AD[v.shape[-1]](v)


def left_jacobian(tangent: ArrayLike) -> Array:
    """Return the left Jacobians of the exponential at tangents: (…, 3, 3) for (…, 3), (…, 6, 6) for (…, 6).

    To first order ``exp(v + dv) = exp(J(v)·dv)·exp(v)``. If the rotation vector v (in radians) of a body
    changes at the rate v̇, the body has angular velocity ``J(v)·v̇`` in world axes.

    Raises
    ------
    RotationError
        The last axis is neither of three nor of six.

    Examples
    --------
    >>> left_jacobian([math.pi, 0, 0]).round(4) + 0.0  # half a turn about x
    array([[ 1.    ,  0.    ,  0.    ],
           [ 0.    ,  0.    , -0.6366],
           [ 0.    ,  0.6366,  0.    ]])
    """
    v = _tangents(tangent)
    return _LEFT[v.shape[-1]](v)


def right_jacobian(tangent: ArrayLike) -> Array:
    """Return the right Jacobians: ``exp(v + dv) = exp(v)·exp(J(v)·dv)`` to first order; see `left_jacobian`.

    ``J(v)·v̇`` is the angular velocity in body axes.

    Examples
    --------
    >>> bool((right_jacobian([1, 2, 3]) == left_jacobian([-1, -2, -3])).all())
    True
    """
    return left_jacobian(-_tangents(tangent))


def inverse_left_jacobian(tangent: ArrayLike) -> Array:
    """Return the inverses of the left Jacobians, the Jacobians of the logarithm: (…, 3, 3) or (…, 6, 6).

    To first order ``log(exp(dv)·exp(v)) = v + J⁻¹(v)·dv``. At rotation vectors whose lengths are nonzero
    multiples of 2π there is no inverse, and entries are large or not finite.

    Raises
    ------
    RotationError
        The last axis is neither of three nor of six.

    Examples
    --------
    >>> (inverse_left_jacobian([1, 2, 3]) @ left_jacobian([1, 2, 3])).round(12) + 0.0
    array([[1., 0., 0.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """
    v = _tangents(tangent)
    return _INVERSE[v.shape[-1]](v)


def inverse_right_jacobian(tangent: ArrayLike) -> Array:
    """Return the inverses of the right Jacobians, ``log(exp(v)·exp(dv)) = v + J⁻¹(v)·dv`` to first order.

    Examples
    --------
    >>> (inverse_right_jacobian([1, 2, 3]) @ [1, 2, 3]).round(12)  # along v nothing changes
    array([1., 2., 3.])
    """
    return inverse_left_jacobian(-_tangents(tangent))


def _tangents(tangent: ArrayLike) -> Array:
    v = floats(tangent, "tangents")
    if not v.ndim or v.shape[-1] not in (3, 6):
        raise RotationError(
            f"tangents has shape {tuple(v.shape)}; expected (…, 3) of rotations or (…, 6) of rigid motions"
        )
    return v


def _parts(xp: Namespace, v: Coordinates) -> tuple[Array, Array, Coordinates, Array]:
    """Return a mask of short v (for series), θ², v for short ones and its direction for others, and θ/2.

    Squares that may overflow are not computed; values that are not needed are set to harmless ones.
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


def exponential_factors(xp: Namespace, v: Coordinates) -> tuple[Coordinates, Array, Array]:
    """Return the vectors u, and a and b, such that J(v) is ``1 + a·[u]× + b·[u]×²``."""
    near, small, axis, half = _parts(xp, v)
    sine, cosine = xp.sin(half), xp.cos(half)
    a = xp.where(near, polynomial(_A, small), sine * (sine / half))
    b = xp.where(near, polynomial(_B, small), 1.0 - cosine * (sine / half))
    return axis, a, b


def logarithm_factor(xp: Namespace, v: Coordinates) -> tuple[Coordinates, Array]:
    """Return the vectors u, and c, such that J⁻¹(v) is ``1 − ½·[v]× + c·[u]×²``."""
    near, small, axis, half = _parts(xp, v)
    return axis, xp.where(near, polynomial(_C, small), 1.0 - half * xp.cos(half) / xp.sin(half))


def _entries(linear: Coordinates, axis: Coordinates, square: Array, one: Array) -> Entries:
    """Return ``one + [linear]× + square·[axis]×²``."""
    (p, q, r), (x, y, z) = linear, axis
    xy, xz, yz = square * (x * y), square * (x * z), square * (y * z)
    return [
        [one - square * (y * y + z * z), xy - r, xz + q],
        [xy + r, one - square * (x * x + z * z), yz - p],
        [xz - q, yz + p, one - square * (x * x + y * y)],
    ]


def _mixed(axis: Coordinates, u: Coordinates, linear: Coordinates, b: Array, db: Array) -> Entries:
    """Return ``[linear]× + b·([axis]×[u]× + [u]×[axis]×) + db·(axis·u)·[axis]×²``."""
    along = axis[0] * u[0] + axis[1] * u[1] + axis[2] * u[2]
    found = _entries(linear, axis, db * along, -2.0 * (b * along))
    for row, (x, y) in zip(found, zip(axis, u, strict=True), strict=True):
        row[:] = [c + b * (x * v + y * w) for c, w, v in zip(row, axis, u, strict=True)]
    return found


def _stacked(xp: Namespace, rows: Entries) -> Array:
    return xp.stack([join(xp, tuple(row)) for row in rows], axis=-2)


def _blocks(xp: Namespace, block: Entries, mixed: Entries) -> Array:
    """Return the matrix ``[[block, 0], [mixed, block]]``."""
    nothing = [xp.zeros_like(block[0][0])] * 3
    above = [[*row, *nothing] for row in block]
    return _stacked(xp, above + [[*m, *row] for m, row in zip(mixed, block, strict=True)])


def _skew(v: Coordinates) -> Entries:
    x, y, z = v
    zero = 0.0 * x
    return [[zero, -z, y], [z, zero, -x], [-y, x, zero]]


def _hat(v: Array) -> Array:
    c = split(v)
    rows = _skew(c[:3])
    if len(c) == 6:
        rows = [*([*row, x] for row, x in zip(rows, c[3:], strict=True)), [0.0 * c[0]] * 4]
    return _stacked(namespace(v), rows)


def _ad(v: Array) -> Array:
    c, xp = split(v), namespace(v)
    return _stacked(xp, _skew(c)) if len(c) == 3 else _blocks(xp, _skew(c[:3]), _skew(c[3:]))


def _left(v: Array) -> Array:
    xp, c = namespace(v), split(v)
    axis, a, b = exponential_factors(xp, c[:3])
    block = _entries(tuple(a * x for x in axis), axis, b, xp.ones_like(b))
    if len(c) == 3:
        return _stacked(xp, block)
    near, small, _, half = _parts(xp, c[:3])
    u, part = c[3:], 0.5 / half
    sine, cosine = xp.sin(half), xp.cos(half)
    whole, versine = 2.0 * (sine * cosine), 2.0 * (sine * sine)
    flat = part * (versine * part)
    a = xp.where(near, polynomial(_A, small), flat)
    b = xp.where(near, polynomial(_B, small), part * (1.0 - part * whole))
    da = xp.where(near, polynomial(_DA, small), part * whole - 2.0 * flat)
    db = part * (part * (3.0 * whole) - (1.0 - versine) - 2.0)
    db = xp.where(near, polynomial(_DB, small), db)
    along = da * (axis[0] * u[0] + axis[1] * u[1] + axis[2] * u[2])
    linear = tuple(a * y + along * x for x, y in zip(axis, u, strict=True))
    return _blocks(xp, block, _mixed(axis, u, linear, b, db))


def _inverse(v: Array) -> Array:
    xp, c = namespace(v), split(v)
    axis, square = logarithm_factor(xp, c[:3])
    block = _entries(tuple(-0.5 * x for x in c[:3]), axis, square, xp.ones_like(square))
    if len(c) == 3:
        return _stacked(xp, block)
    near, small, _, half = _parts(xp, c[:3])
    u, part, sine = c[3:], 0.5 / half, xp.sin(half)
    cot = xp.cos(half) / sine
    b = xp.where(near, polynomial(_C, small), part * (1.0 - half * cot))
    db = 0.5 * (half / sine / sine + cot) - 2.0 * part
    db = xp.where(near, polynomial(_DC, small), db)
    return _blocks(xp, block, _mixed(axis, u, tuple(-0.5 * y for y in u), b, db))


_HAT, _AD, _LEFT, _INVERSE = (
    {n: RowFormula(formula, (n,)) for n in (3, 6)} for formula in (_hat, _ad, _left, _inverse)
)
