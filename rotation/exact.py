"""Exact rotations: quaternions over ℚ and number fields, their matrices, the finite groups.

As rotations q and c·q are equal, so quaternions may have any norm. Therefore the tetrahedral and octahedral
groups need no square roots, and the icosahedral group only √5 (F. Klein, "Vorlesungen über das Ikosaeder",
1884).
"""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import numpy as np

from hfield.algebra import H, QuaternionAlgebra
from hfield.errors import HFieldError
from hfield.fields.names import ring
from rotation.errors import RotationError
from rotation.rotation import Rotation

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.core.product import Scalar

_BITS = 200
_GROUPS = ("T", "O", "I")


def exact_matrix(q: Quaternion) -> tuple[tuple[Scalar, ...], ...]:
    """Return the exact 3 × 3 matrix of ``v ↦ q·v·q⁻¹`` over the quaternion's own field.

    Raises
    ------
    RotationError
        ``q`` is not a quaternion of Hamilton's algebra.
    HFieldError
        It has no inverse.

    Examples
    --------
    >>> from hfield import H
    >>> exact_matrix(H("QQ")(1, 2, 3, 4))[0]
    (-2/3, 2/15, 11/15)
    """
    _expect_hamilton(q)
    return q.rotation_matrix()


def exact_group(group: str) -> tuple[Quaternion, ...]:
    """Return the rotations of T, O or I as exact quaternions, over ℚ or, for I, over ℚ(√5).

    Each rotation occurs once, the identity first. q and c·q are the same rotation, so the norms are not all
    1.

    Raises
    ------
    RotationError
        Another group.

    Examples
    --------
    >>> [len(exact_group(name)) for name in "TOI"], exact_group("O")[12]
    ([12, 24, 60], 1 + i)
    """
    if group not in _GROUPS:
        raise RotationError(f"group {group!r}: one of {', '.join(_GROUPS)} is expected")
    algebra = H("QQ(sqrt(5))" if group == "I" else "QQ")
    e, i, j, k = algebra.basis
    signs = list(itertools.product((1, -1), repeat=3))
    found = [e, i, j, k, *(e + a * i + b * j + c * k for a, b, c in signs)]
    if group == "O":
        found += [e + s * u for u in (i, j, k) for s in (1, -1)]
        found += [u + s * v for u, v in ((i, j), (j, k), (k, i)) for s in (1, -1)]
    if group == "I":
        golden = (1 + algebra.ring.gen) / 2
        numbers = (1, golden, golden - 1, 0)
        for order in itertools.permutations(range(4)):
            if sum(a > b for a, b in itertools.combinations(order, 2)) % 2 == 0:
                for sign in signs:  # of those that are not 0 the first is positive
                    values = [0] * 4
                    rest = iter(sign[1:])
                    for place, n in enumerate(order):
                        if numbers[n]:
                            first = not any(values)
                            values[place] = numbers[n] if first else next(rest) * numbers[n]
                    if sign[0] == 1:
                        found.append(algebra(*values))
    return tuple(found)


def from_exact(quaternions: Quaternion | list[Quaternion] | tuple[Quaternion, ...]) -> Rotation:
    """Return the rotations of a quaternion, or of a list of them, as floats; each coordinate is rounded once.

    Parameters
    ----------
    quaternions : Quaternion, or a list of them
        Of Hamilton's algebra over ℚ, a real number field (its generator the root that its name suggests) or
        RR. Over functions give values to the variables first: ``q.subs(t="pi/3")``.

    Raises
    ------
    RotationError
        No such quaternions, or one is zero.

    Examples
    --------
    >>> from hfield import H
    >>> from_exact(H("QQ")(1, 1, 0, 0)).as_rotvec(degrees=True).round(9)
    array([90.,  0.,  0.])
    >>> from_exact(exact_group("I")).shape
    (60,)
    """
    return Rotation(exact_coordinates(quaternions))


def exact_coordinates(
    quaternions: Quaternion | list[Quaternion] | tuple[Quaternion, ...],
) -> np.ndarray:
    """Return the coordinates of a quaternion, or of a list of them, each rounded once: (4,) or (n, 4).

    Raises
    ------
    RotationError
        They do not belong to Hamilton's algebra over real numbers.

    Examples
    --------
    >>> from hfield import H
    >>> exact_coordinates(H("QQ")(1, "1/2", 0, 0))
    array([1. , 0.5, 0. , 0. ])
    """
    rows = []
    single = not isinstance(quaternions, list | tuple)
    for q in quaternions if isinstance(quaternions, list | tuple) else [quaternions]:
        _expect_hamilton(q)
        rows.append([_rounded(x) for x in q.coordinates])
    found = np.reshape(rows, (-1, 4))
    return found[0] if single else found


def _expect_hamilton(q: object) -> None:
    algebra = getattr(q, "algebra", None)
    if not isinstance(algebra, QuaternionAlgebra) or algebra != H(algebra.ring):
        raise RotationError(
            f"{q!r} is not a quaternion of Hamilton's algebra, such as hfield.H('QQ')(1, 1, 0, 0) is"
        )


def _rounded(x: Scalar) -> float:
    try:
        field = getattr(x, "field", None)
        value = getattr(field, "value_near", None)
        ball = ring("RR")(x).ball(_BITS) if value is None else value(x, _BITS)
    except (HFieldError, AttributeError) as error:
        variables = getattr(field, "variable_names", ())
        raise RotationError(
            f"{x} is not a real algebraic number, so it is not rounded"
            + (f"; give values to {', '.join(variables)} first, by subs" if variables else "")
        ) from error
    if not ball.imag.contains(0):
        raise RotationError(f"{x} is not a real number: it is not rounded")
    return float(ball.real.mid())
