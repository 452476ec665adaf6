"""Functions of quaternions for users: methods under the names of the statement language."""

from __future__ import annotations

from hfield.algebra.quaternion import Quaternion
from hfield.errors import CoercionError, shorten
from hfield.fields.base.ring import E


def conj(q: Quaternion[E]) -> Quaternion[E]:
    """Return the standard involution of q (thesis, Definition 3), as the method ``conjugate`` does.

    >>> from hfield import H, QQ
    >>> conj(H(QQ)(1, 2, 0, 1))
    1 - 2*i - k

    Raises :class:`CoercionError` if q is not a quaternion.
    """
    return _quaternion("conj", q).conjugate()


def inv(q: Quaternion[E]) -> Quaternion[E]:
    """Return the inverse of q, as the method ``inverse`` does.

    >>> from hfield import H, QQ
    >>> inv(H(QQ)(1, 0, 1, 0))
    1/2 - 1/2*j

    Raises :class:`NotInvertibleError` for a zero divisor, :class:`CoercionError` if q is not a quaternion.
    """
    return _quaternion("inv", q).inverse()


def norm(q: Quaternion[E]) -> E:
    """Return the reduced norm of q (thesis, Definition 2), an element of the base ring.

    >>> from hfield import H, QQ
    >>> norm(H(QQ)(1, 2, 0, 1))
    6

    Raises :class:`CoercionError` if q is not a quaternion.
    """
    return _quaternion("norm", q).norm()


def trace(q: Quaternion[E]) -> E:
    """Return the reduced trace of q, an element of the base ring.

    >>> from hfield import H, QQ
    >>> trace(H(QQ)(3, 2, 0, 1))
    6

    Raises :class:`CoercionError` if q is not a quaternion.
    """
    return _quaternion("trace", q).trace()


def conjugator(p: Quaternion[E], q: object) -> Quaternion[E] | None:
    """Return a unit x with ``x·p·x⁻¹ = q``, or None; ``p.conjugacy(q)`` gives the reason.

    >>> from hfield import H
    >>> _, i, j, _ = H("QQ").basis
    >>> x = conjugator(i, j)
    >>> x * i * inv(x)
    j

    Raises :class:`CoercionError` if p is not a quaternion.
    """
    return _quaternion("conjugator", p).conjugator(q)


def _quaternion(function: str, q: Quaternion[E]) -> Quaternion[E]:
    if isinstance(q, Quaternion):
        return q
    shown = shorten(repr(q))
    raise CoercionError(
        f"{function} takes a quaternion, found {shown}; A({shown}) makes one in an algebra A"
    )
