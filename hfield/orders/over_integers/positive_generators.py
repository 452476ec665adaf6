"""Generators of ideals of a totally real field that are totally positive, and the units among them.

Reduced norms of a totally definite algebra are the totally positive elements (Hasse and Schilling), and those
of the multiples of x by units of the field are N(x) times squares: what counts is the narrow class of an
ideal, and the totally positive units modulo the squares.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import product
from typing import TYPE_CHECKING, Any

from hfield.fields.number_fields.ideals import Ideal, integers

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement


@lru_cache(maxsize=256)
def units_modulo_squares(ring: Any) -> tuple[FieldElement, ...]:
    """Return the totally positive units, one for each coset of the squares of units; 1 comes first."""
    frame = integers(ring)
    found = [frame.field.one]
    for g in ring.totally_positive_units():
        if all((g * u).sqrt() is None for u in found):
            found += [g * u for u in found]
    return tuple(found)


@lru_cache(maxsize=256)
def _units_by_signs(ring: Any) -> dict[tuple[int, ...], FieldElement]:
    """Return one unit for each pattern of signs at the real places that units have."""
    frame = integers(ring)
    units = [-frame.field.one, *ring.unit_group().generators]
    found: dict[tuple[int, ...], FieldElement] = {}
    for exponents in product((0, 1), repeat=len(units)):
        u = frame.field.one
        for e, g in zip(exponents, units, strict=True):
            u = u * g if e else u
        found.setdefault(_signs(u), u)
    return found


def _signs(x: FieldElement) -> tuple[int, ...]:
    return tuple(x.field.sign_at(x, k) for k in range(x.field.degree))


def totally_positive_generator(ideal: Ideal) -> FieldElement | None:
    """Return a totally positive generator of a fractional ideal, or None where there is none."""
    generator = ideal.is_principal().generator
    if generator is None:
        return None
    x = ideal.frame.field(generator)
    unit = _units_by_signs(ideal.ring).get(_signs(x))
    return None if unit is None else x * unit


class NarrowClasses:
    """Ideals as products ν·a with ν totally positive, a one of as many ideals as there are narrow classes."""

    def __init__(self, ring: Any) -> None:
        self.group = ring.narrow_class_group()
        self.order = self.group.order
        self._numbers: dict[tuple[int, ...], int] = {}
        self.ideals: list[Ideal] = []

    def split(self, ideal: Ideal) -> tuple[int, FieldElement]:
        """Return the number of a and ν. Numbers count from 0 as classes are met."""
        known = self.group.class_of(ideal) if self.order > 1 else ()
        if known not in self._numbers:
            self._numbers[known] = len(self.ideals)
            self.ideals.append(ideal.frame.one if not any(known) else ideal)
        number = self._numbers[known]
        found = totally_positive_generator(ideal / self.ideals[number])
        assert found is not None, "ideals of one narrow class differ by a totally positive element"
        return number, found


@lru_cache(maxsize=256)
def narrow_classes(ring: Any) -> NarrowClasses:
    """Return the narrow classes of a field."""
    return NarrowClasses(ring)
