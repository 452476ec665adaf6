"""Methods about ideals, classes and units that all kinds of number fields share."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, cast

from hfield.hints import FIELD, Hinted

if TYPE_CHECKING:
    from hfield.fields.number_fields.classes.class_groups import ClassGroup
    from hfield.fields.number_fields.classes.unit_groups import UnitGroup
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import FractionalIdeal
    from hfield.fields.number_fields.ring import NumberField


class WithIdeals(Hinted):
    """Ideals of the integers of a number field."""

    foreign_names = FIELD

    @property
    def _field(self) -> NumberField:
        """The field itself: only number fields are made with this class."""
        return cast("NumberField", self)

    def ideal(self, *generators: object) -> FractionalIdeal:
        """Return the fractional ideal of elements, prime ideals and ideals, a list of such, or its text.

        Raises :class:`RingError` for the zero ideal, :class:`CoercionError` for what is not of the field.

        >>> from hfield import ring
        >>> K = ring("QQ[s]/(s^3-2)"); a = K.ideal(3, 1 + K.gen)
        >>> a, a**3, a.norm(), a == K.ideal("3, 1 + s") == K.ideal(str(a))
        (ideal(3, s+s^2), ideal(3), 3, True)
        """
        from hfield.fields.number_fields.ideals import ideal

        return ideal(self._field, *generators)

    def zeta_minus_one(self) -> Fraction:
        """Return ζ_K(−1) of a totally real field, exactly, by Siegel's formula.

        Raises :class:`RingError` for other fields, :class:`TooLargeError` for large discriminants.

        >>> from hfield import ring
        >>> ring("QQ(sqrt(5))").zeta_minus_one(), ring("QQ[s]/(s^3-3*s-1)").zeta_minus_one()
        (Fraction(1, 30), Fraction(-1, 9))
        """
        from hfield.fields.number_fields.classes.zeta import zeta_minus_one

        return zeta_minus_one(self._field)

    def class_group(self) -> ClassGroup:
        """Return the class group, proved; with ``order, invariants, generators, class_of(a), evidence``.

        Raises :class:`TooLargeError` where the discriminant is too large.

        >>> from hfield import ring
        >>> ring("QQ(sqrt(-23))").class_group().order, ring("QQ[s]/(s^3-2)").class_group().order
        (3, 1)
        """
        from hfield.fields.number_fields.classes.class_groups import class_group

        return class_group(self._field)

    def narrow_class_group(self) -> ClassGroup:
        """Return the group of ideals modulo those with a totally positive generator.

        Raises as :meth:`class_group` does.

        >>> from hfield import ring
        >>> ring("QQ(sqrt(3))").narrow_class_group().order
        2
        """
        from hfield.fields.number_fields.classes.class_groups import narrow_class_group

        return narrow_class_group(self._field)

    def unit_group(self) -> UnitGroup:
        """Return the unit group, proved; with ``rank, generators, torsion, regulator, totally_positive``.

        Raises :class:`TooLargeError` where the discriminant is too large.

        >>> from hfield import ring
        >>> U = ring("QQ[s]/(s^4-s-1)").unit_group()
        >>> U, U.torsion_order, U.regulator > 0
        (ℤ/2 × ℤ^2, 2, True)
        """
        from hfield.fields.number_fields.classes.unit_groups import unit_group

        return unit_group(self._field)

    def totally_positive_units(self) -> tuple[FieldElement, ...]:
        """Return generators of the group of totally positive units. Raises as :meth:`unit_group` does.

        >>> from hfield import ring
        >>> [u.sign() for u in ring("QQ[s]/(s^3-3*s-1)").totally_positive_units()]
        [1, 1]
        """
        from hfield.fields.number_fields.classes.unit_groups import unit_group

        return unit_group(self._field).totally_positive
