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
        (ideal(3, 1+s), ideal(3), 3)
        """
        found: Ideal = of_fields("number_fields.ideals.ideal")(self, generators)
        return found
