"""Normal forms: (a, t, b) over a field becomes (a′, b′ | F), or [a′, b′ | F) in characteristic 2."""

from collections.abc import Callable, Sequence
from typing import Generic, NamedTuple

from hfield.core.product import Constants, Coordinates, Scalar
from hfield.errors import UndecidedError
from hfield.fields.base.ring import E, Ring, WithSquares


class NormalForm(NamedTuple, Generic[E]):
    """``kind`` is ``"symbol"`` for (a, b | F) and ``"artin-schreier"`` for [a, b | F).

    ``back`` maps coordinates in the normal basis to coordinates in the given basis, and ``forth`` is the
    inverse map.
    """

    kind: str
    a: E
    b: E
    back: Callable[[Coordinates], Coordinates]
    forth: Callable[[Coordinates], Coordinates]

    @property
    def constants(self) -> tuple[E, E]:
        """The two constants of the normal form."""
        return self.a, self.b


def basis_of(ring: Ring) -> tuple[Coordinates, Coordinates, Coordinates, Coordinates]:
    """Return the coordinates of e, i, j, k."""
    o, e = ring.zero, ring.one
    return (e, o, o, o), (o, e, o, o), (o, o, e, o), (o, o, o, e)


def discriminant(ring: Ring[E], c: Constants[E]) -> E:
    """Return ``(t² + 4a)·b``; the algebra over a field is central simple if and only if this is not 0."""
    a, t, b = c
    return (t * t + ring(4) * a) * b  # of a p-adic a, 4a is known to more digits than a + a + a + a


def normal_form(ring: Ring[E], c: Constants[E]) -> NormalForm[E]:
    """Complete the square (characteristic not 2), or divide i by t (characteristic 2, t ≠ 0).

    The square of ``i − t/2`` is ``a + t²/4``, and it anticommutes with j; in characteristic 2, the square of
    i/t is ``a/t² + i/t``. The ring must be a field.
    """
    a, t, b = c
    if ring.is_zero(t):
        return NormalForm("symbol", a, b, _same, _same)
    if ring.characteristic == 2:
        s = ring.inverse(t)
        return NormalForm(
            "artin-schreier",
            a * s * s,
            b,
            lambda q: (q[0], q[1] * s, q[2], q[3] * s),
            lambda q: (q[0], q[1] * t, q[2], q[3] * t),
        )
    h = ring.divide(t, ring(2))
    return NormalForm(
        "symbol",
        a + h * h,
        b,
        lambda q: (q[0] - h * q[1], q[1], q[2] - h * q[3], q[3]),
        lambda q: (q[0] + h * q[1], q[1], q[2] + h * q[3], q[3]),
    )


def _same(q: Coordinates) -> Coordinates:
    return q


def from_pairings(ring: Ring, c: Constants, pairings: Sequence[Scalar]) -> Coordinates:
    """Return the q for which ``tr(q·conj(u))`` are the given scalars, u = e, i, j, k; the algebra is simple.

    On (e, i) the form has the matrix ``((2, t), (t, −2a))``, on (j, k) −b times that; all other entries are
    0.
    """
    a, t, b = c
    m, n, p, q = pairings
    scale = ring.inverse(t * t + ring(4) * a)
    other = ring.inverse(ring.zero - b) * scale
    twice = ring(2) * a
    return (
        scale * (twice * m + t * n),
        scale * (t * m - n - n),
        other * (twice * p + t * q),
        other * (t * p - q - q),
    )


def pairing_matrix(ring: Ring[E], c: Constants[E]) -> list[list[E]]:
    """Return the matrix of ``tr(u·conj(v))`` on e, i, j, k; its determinant is ``((t² + 4a)·b)²``."""
    a, t, b = c
    o, two = ring.zero, ring(2)
    return [
        [two, t, o, o],
        [t, o - a - a, o, o],
        [o, o, o - b - b, o - b * t],
        [o, o, o - b * t, b * (a + a)],
    ]


def root_if_known(ring: WithSquares, x: Scalar) -> Scalar | None:
    """Return a square root; None if there is none or that is not decided."""
    try:
        return ring.sqrt(x)
    except UndecidedError:
        return None
