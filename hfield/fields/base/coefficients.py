"""Coefficients of a polynomial, displayed as the polynomial."""

from __future__ import annotations

from collections.abc import Iterable

from hfield.core.product import Scalar
from hfield.fields.base.printing import sum_text
from hfield.fields.base.ring import Ring


class Coefficients(tuple[Scalar, ...]):
    """The coefficients of a polynomial in X over a ring, low degree first: a tuple displayed as the
    polynomial.

    >>> from hfield import QQ
    >>> f = Coefficients(QQ, [6, -2, 1])
    >>> f, f == (6, -2, 1), f[0]
    (X²−2·X+6, True, 6)
    """

    ring: Ring

    def __new__(cls, ring: Ring, values: Iterable[Scalar]) -> Coefficients:
        """Make the tuple, and record the ring by which its entries are printed."""
        made = super().__new__(cls, values)
        made.ring = ring
        return made

    def text(self, style: str = "plain") -> str:
        """Write the polynomial in the style ``plain``, ``unicode`` or ``latex``."""
        terms = [
            (self.ring.text(c, style), [("X", n)])
            for n, c in reversed(list(enumerate(self)))
            if not self.ring.is_zero(c)
        ]
        return sum_text(terms, style)

    def __repr__(self) -> str:
        return self.text("unicode")

    def _repr_latex_(self) -> str:
        return f"${self.text('latex')}$"

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.ring, list(self))
