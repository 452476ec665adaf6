"""Totally positive generators of ideals of a totally real field, and the totally positive units.

The reduced norms of a totally definite algebra are the totally positive elements (Hasse and Schilling). If x
is multiplied by a unit of the field, N(x) is multiplied by its square. So the algorithms need the narrow
class of an ideal, and the totally positive units modulo squares.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from hfield.fields.number_fields.ideals import FractionalIdeal, integers

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ring import NumberField


@lru_cache(maxsize=256)
def _units_by_signs(
    ring: NumberField, places: tuple[int, ...]
) -> dict[tuple[int, ...], list[FieldElement]]:
    """Return one unit for each coset of the squares of units, by signs at real places, 1 first."""
    frame = integers(ring)
    found: dict[tuple[int, ...], list[FieldElement]] = {}
    units = [frame.field.one]
    # the root of unity is −1 if there are real places
    for g in (ring.unit_group().torsion, *ring.unit_group().generators):
        units += [g * u for u in units]
    for u in units:
        found.setdefault(_signs(u, places), []).append(u)
    return found


def _signs(x: FieldElement, places: tuple[int, ...]) -> tuple[int, ...]:
    return tuple(x.field.sign_at(x, k) for k in places)


def generators(ideal: FractionalIdeal, places: tuple[int, ...]) -> list[FieldElement]:
    """Return the generators of a fractional ideal that are positive at some real places.

    The result has one generator for each coset of the squares of units; it is empty if there are none.
    """
    generator = ideal.is_principal().generator
    if generator is None:
        return []
    x = ideal.frame.field(generator)
    return [x * u for u in _units_by_signs(ideal.ring, places).get(_signs(x, places), ())]


def units_modulo_squares(ring: NumberField) -> tuple[FieldElement, ...]:
    """Return the totally positive units, one for each coset of the squares of units; 1 comes first."""
    places = _all_places(ring)
    return tuple(_units_by_signs(ring, places)[(1,) * len(places)])


def _all_places(ring: NumberField) -> tuple[int, ...]:
    return tuple(range(integers(ring).field.signature[0]))


def totally_positive_generator(ideal: FractionalIdeal) -> FieldElement | None:
    """Return a totally positive generator of a fractional ideal, or None if there is none."""
    return next(iter(generators(ideal, _all_places(ideal.ring))), None)


class NarrowClasses:
    """Write ideals as ν·a, with ν totally positive and a in a list of representatives of the narrow
    classes.
    """

    def __init__(self, ring: NumberField) -> None:
        self.group = ring.narrow_class_group()
        self.order = self.group.order
        self._numbers: dict[tuple[int, ...], int] = {}
        self.ideals: list[FractionalIdeal] = []

    def split(self, ideal: FractionalIdeal) -> tuple[int, FieldElement]:
        """Return the index of a, and ν. Classes are numbered from 0 in the order in which they occur."""
        known = self.group.class_of(ideal) if self.order > 1 else ()
        if known not in self._numbers:
            self._numbers[known] = len(self.ideals)
            self.ideals.append(ideal.frame.one if not any(known) else ideal)
        number = self._numbers[known]
        found = totally_positive_generator(ideal / self.ideals[number])
        assert found is not None, "ideals of one narrow class differ by a totally positive element"
        return number, found


@lru_cache(maxsize=256)
def narrow_classes(ring: NumberField) -> NarrowClasses:
    """Return the narrow classes of a field."""
    return NarrowClasses(ring)
