"""Normal forms: (a, t, b) over a field becomes (a′, b′ | F), or [a′, b′ | F) in characteristic 2."""

from collections.abc import Callable
from typing import Any, NamedTuple

from hfield.product import Constants, Coordinates
from hfield.rings.base import Ring


class NormalForm(NamedTuple):
    """``kind`` is ``"symbol"`` for (a, b | F) and ``"artin-schreier"`` for [a, b | F).

    ``back`` takes coordinates in the normal basis to coordinates in the given one, and ``forth``
    the other way.
    """

    kind: str
    a: Any
    b: Any
    back: Callable[[Coordinates], Coordinates]
    forth: Callable[[Coordinates], Coordinates]

    @property
    def constants(self) -> tuple[Any, Any]:
        """The two constants of the normal form."""
        return self.a, self.b


def discriminant(c: Constants) -> Any:
    """Return ``(t² + 4a)·b``; the algebra over a field is central simple iff it is not 0."""
    a, t, b = c
    twice = a + a
    return (t * t + (twice + twice)) * b


def normal_form(ring: Ring, c: Constants) -> NormalForm:
    """Complete the square (characteristic not 2), or divide i by t (characteristic 2, t ≠ 0).

    ``i − t/2`` has the square ``a + t²/4`` and anticommutes with j; in characteristic 2, i/t has
    the square ``a/t² + i/t``. The ring must be a field.
    """
    a, t, b = c
    if ring.is_zero(t):
        return NormalForm("symbol", a, b, lambda q: q, lambda q: q)
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
