"""Fields of rational functions k(t) as global fields, and ℚ(x), which is none but has residues."""

from __future__ import annotations

from typing import Any

from hfield.errors import RingError, UndecidedError
from hfield.factorisation import Factors
from hfield.product import Constants
from hfield.rings.base import Ring
from hfield.rings.function_places import FunctionPlace, place_of_functions
from hfield.rings.functions import FunctionField, Quotient
from hfield.structure.forms import NormalForm, normal_form
from hfield.structure.function_fields.hilbert_functions import ramified_places_functions, symbol
from hfield.structure.global_field import GlobalField


class FunctionArithmetic(GlobalField):
    """The arithmetic of k(t): what k = GF(q), q odd or even, and k = ℚ have in common."""

    ring: FunctionField

    @classmethod
    def of(cls, ring: Ring) -> FunctionArithmetic:
        """Return the arithmetic of k(t) by the field of constants k."""
        assert isinstance(ring, FunctionField)
        if ring.base.order is None:
            return OverRationals(ring)
        return OverEven(ring) if ring.characteristic == 2 else OverOdd(ring)

    @classmethod
    def named_by(cls, *elements: Any, place: Any = None) -> Ring | None:
        """Return the field of a place or of a quotient."""
        if isinstance(place, FunctionPlace):
            return place.field
        found: Ring | None = next((x.field for x in elements if isinstance(x, Quotient)), None)
        return found

    def read_place(self, text: Any) -> FunctionPlace:
        """Return a monic irreducible polynomial or infinity."""
        return place_of_functions(self.ring, text)

    def hilbert_symbol(self, a: Any, b: Any, place: Any, factors: Factors | None) -> int:
        """Return the symbol by a residue; in characteristic 2 that of [a, b | F), where a may be 0."""
        field = self.ring
        even = field.characteristic == 2
        a, b = field(a), field(b)
        if field.is_zero(b) or (field.is_zero(a) and not even):
            raise RingError(
                "a Hilbert symbol is defined for nonzero elements only, and one of these is 0"
            )
        v = self.read_place(place)
        form = normal_form(field, Constants(a, field.one if even else field.zero, b))
        return self._symbol(form, v)

    def _symbol(self, form: NormalForm, v: FunctionPlace) -> int:
        return symbol(self.ring, form, v)

    def ramified(self, form: NormalForm) -> tuple[FunctionPlace, ...]:
        """Return the places with a residue that is not trivial, by degree, infinity last."""
        return ramified_places_functions(self.ring, form)

    def discriminant(self, ramified: tuple[Any, ...]) -> Any:
        """Return the product of the polynomials."""
        product = self.ring.one
        for v in ramified:
            if v.poly is not None:
                product = product * self.ring.quotient(v.poly, self.ring.one.num)
        return product


class OverOdd(FunctionArithmetic):
    """The arithmetic of GF(q)(t), q odd."""


class OverEven(FunctionArithmetic):
    """The arithmetic of GF(q)(t), q even."""


class OverRationals(FunctionArithmetic):
    """The arithmetic of ℚ(x): residues decide up to an algebra over ℚ (Faddeev's exact sequence)."""

    def _symbol(self, form: NormalForm, v: FunctionPlace) -> int:
        raise UndecidedError(
            f"the completions of {self.ring} are not local fields: the residue alone does not decide there"
        )
