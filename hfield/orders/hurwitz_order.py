"""The Hurwitz order as a Euclidean ring, with division with remainder on both sides."""

from __future__ import annotations

import flint

from hfield.algebra.quaternion import Quaternion
from hfield.algebra.structure import hurwitz
from hfield.core.product import Coordinates
from hfield.core.properties import cached_property
from hfield.errors import CoercionError
from hfield.orders.lattice import Order


class HurwitzOrder(Order):
    """The Hurwitz order of (−1,−1|ℚ), with division with remainder on both sides."""

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """The customary basis e, i, j, (e + i + j + k)/2."""
        e, i, j, k = self.algebra.basis
        return e, i, j, (e + i + j + k) / 2

    def coordinates(self, x: object) -> tuple[flint.fmpq, ...]:
        """Return the rational coordinates of an element with respect to :attr:`basis`."""
        w, x, y, z = self.algebra(x).coordinates
        return w - z, x - z, y - z, 2 * z

    def quo_rem(self, a: object, b: object, side: str = "right") -> tuple[Quaternion, Quaternion]:
        """Return ``(q, r)`` with ``a = q·b + r`` (``side="left"``: ``a = b·q + r``), N(r) ≤ N(b)/2.

        Raises :class:`CoercionError` for an element outside the order or another side, and
        :class:`NotInvertibleError` for b = 0.
        """
        self._check_side(side)
        q, r = hurwitz.divide(self._coordinates(a), self._coordinates(b), side)
        return self.algebra(*q), self.algebra(*r)

    def gcd(self, a: object, b: object, side: str = "right") -> Quaternion:
        """Return a greatest common right (left) divisor of a and b, unique up to a unit.

        Raises as :meth:`quo_rem` does.
        """
        self._check_side(side)
        return self.algebra(*hurwitz.gcd(self._coordinates(a), self._coordinates(b), side))

    def _coordinates(self, q: object) -> Coordinates:
        return self.algebra(q).coordinates

    @staticmethod
    def _check_side(side: str) -> None:
        if side not in ("left", "right"):
            raise CoercionError(f"the side {side!r} does not exist: expected 'left' or 'right'")
