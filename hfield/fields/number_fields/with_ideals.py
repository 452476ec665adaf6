"""What number fields of all kinds know of their ideals, classes and units; the answers stand above the rings."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from hfield.rings.base import of_fields

if TYPE_CHECKING:
    from hfield.fields.number_fields.ideals import Ideal


class WithIdeals:
    """Ideals of the integers of a number field."""

    def ideal(self, generators: object) -> Ideal:
        """Return the fractional ideal of an element, a prime ideal, an ideal, or a list of such.

        Raises :class:`RingError` for the zero ideal, :class:`CoercionError` for what is not of the field.

        >>> from hfield import ring
        >>> K = ring("QQ[s]/(s^3-2)"); a = K.ideal([3, 1 + K.gen])
        >>> a, a**3, a.norm()
        (ideal(3, s+s^2), ideal(3), 3)
        """
        found: Ideal = of_fields("number_fields.ideals.ideal")(self, generators)
        return found

    def zeta_minus_one(self) -> Fraction:
        """Return ζ_K(−1) of a totally real field, exactly, by Siegel's formula.

        Raises :class:`RingError` for other fields, :class:`TooLargeError` for large discriminants.

        >>> from hfield import ring
        >>> ring("QQ(sqrt(5))").zeta_minus_one(), ring("QQ[s]/(s^3-3*s-1)").zeta_minus_one()
        (Fraction(1, 30), Fraction(-1, 9))
        """
        found: Fraction = of_fields("number_fields.zeta.zeta_minus_one")(self)
        return found
