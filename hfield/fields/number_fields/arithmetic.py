"""The arithmetic of number fields as global fields."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager

from hfield.core.factorisation import Factors, known_primes
from hfield.core.primality import primes
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.fields.number_fields.conics import solve_conic_number_field
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.given_symbols import (
    common_slot,
    from_ramification_number_field,
    is_local_square,
)
from hfield.fields.number_fields.places import Place, place_of_number_field
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, by_other_generators
from hfield.fields.number_fields.residues import LocalPlace, local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import (
    candidates,
    finite_ramified,
    hilbert_symbol_number_field,
    norms,
    ramified_places_number_field,
)
from hfield.fields.number_fields.unimodular_lattice import embed_number_field
from hfield.fields.quadratic_forms.global_field import GlobalField, no_flag
from hfield.fields.quadratic_forms.isomorphisms.through_slots import generator_by_slot, through_slot
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import CONIC, ZeroNorm, found
from hfield.fields.quadratic_forms.normal_forms import NormalForm

SMALL_PRIMES = 50
GENERATORS = 30


class NumberFieldArithmetic(GlobalField):
    """The arithmetic of a number field of any degree."""

    ring: NumberField

    def read_place(self, text: object) -> Place:
        """Return a prime ideal or an infinite place."""
        return place_of_number_field(self.ring, text)

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return the symbol, without factoring anything."""
        return hilbert_symbol_number_field(self.ring(a), self.ring(b), self.read_place(place))

    def ramified(self, form: NormalForm) -> tuple[Place, ...]:
        """Return the places with a symbol of −1; the norms of a and b are factored."""
        return ramified_places_number_field(form.a, form.b)

    def discriminant(self, ramified: tuple[object, ...]) -> tuple[PrimeIdeal, ...]:
        """Return the prime ideals whose product is the discriminant."""
        return tuple(v for v in ramified if isinstance(v, PrimeIdeal))

    def with_ramification(
        self, places: Sequence[Place | str], infinite: bool | None = None
    ) -> tuple[FieldElement, FieldElement]:
        """Return constants, found by local classes and one more prime ideal."""
        if infinite is not None:
            raise no_flag(self.ring)
        return from_ramification_number_field(self.ring, list(places))

    def ramified_at_small_places(self, form: NormalForm) -> tuple[PrimeIdeal, ...]:
        """Return the prime ideals above primes below 50 with a symbol of −1."""
        return tuple(finite_ramified(form.a, form.b, set(primes(SMALL_PRIMES))))

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return a point of the conic ``z² = a·x² + b·y²``, by a bounded search."""
        x, y, z = solve_conic_number_field(self.ring, form.a, form.b)
        return found(self.ring, c, form.back((z, x, y, self.ring.zero)), "conic", CONIC)

    def residues(self, place: Place) -> LocalPlace | None:
        """Return the prime ideal with its residue field."""
        return local_place(place) if isinstance(place, PrimeIdeal) else None

    def evidence(self, c: Constants, places: Iterable[object]) -> Iterator[Mapping[str, object]]:
        """Yield the evidence; if ℤ[s] is not maximal at a place, also in terms of other generators."""
        for place in places:
            for data in super().evidence(c, [place]):
                yield data
                if isinstance(place, PrimeIdeal) and not place.order.plain:
                    for other in by_other_generators(place, GENERATORS):
                        yield {**data, "place": other}

    def _to_factor(self, x: FieldElement) -> tuple[int, int, int]:
        return norms(self.ring, x)

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J, by an isometry of the quaternions of trace 0; in degree 2 by a common slot."""
        if self.ring.degree > 2:
            return embed_number_field(self.ring, outer, inner)
        with self._known(outer.a, outer.b, inner.a, inner.b):
            return through_slot(self.ring, outer, inner, self._slot(inner, outer.a), self._point)

    def _known(self, *numbers: FieldElement) -> AbstractContextManager[None]:
        """Use the known primes of some numbers when products of them are factored: a slot has one
        new prime.
        """
        return known_primes({p for x in numbers for p in candidates(self.ring, x)}, "")

    def _slot(self, c: Constants, s: FieldElement) -> FieldElement:
        """Return a common slot of an algebra for a and s.

        In degree 2, three conics in rank 6 take half as long as an isometry in rank 12.
        """
        return common_slot([c.a, s], ramified_places_number_field(c.a, c.b))

    def _point(self, c: Constants) -> tuple[FieldElement, FieldElement, FieldElement]:
        x, y, w = solve_conic_number_field(self.ring, c.a, c.b)
        return w, x, y

    def traceless_root(self, form: NormalForm, s: FieldElement) -> Coordinates | None:
        """Return x of trace 0 with x² = s, from an isomorphic algebra (s, e), or None if there is none."""
        ramified = self.ramified(form)
        if any(is_local_square(v, s) for v in ramified):
            return None
        c = Constants(form.a, self.ring.zero, form.b)
        if self.ring.degree == 2:
            with self._known(form.a, form.b, s):
                return generator_by_slot(self.ring, s, c, self._slot(c, s), self._point)[0]
        outer = Constants(s, self.ring.zero, common_slot([s], ramified))
        return embed_number_field(self.ring, outer, c)[0]
