"""Quadratic number fields as global fields."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

from hfield.factorisation import Factors, known_primes
from hfield.fields.number_fields.arithmetic import NumberFieldArithmetic
from hfield.fields.number_fields.conics import solve_conic_number_field
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.quadratic.as_number_field import (
    as_number_field,
    from_number_field,
    into_number_field,
    place_in_number_field,
)
from hfield.fields.number_fields.quadratic.places import QuadraticPlace, place_of_quadratic
from hfield.fields.number_fields.quadratic.residues import DegreeOne, Inert, prime_at
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.quadratic.symbols import (
    hilbert_symbol_quadratic,
    pair,
    ramified_places_quadratic,
)
from hfield.fields.rationals.conics import solve_conic
from hfield.fields.rationals.embedding import traceless_root_rational
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.product import Constants, Coordinates, Scalar
from hfield.rings.integers import QQ
from hfield.structure.forms import NormalForm
from hfield.structure.global_field import GlobalField
from hfield.structure.norm_forms.zero_norm_answer import CONIC, ZeroNorm, found

if TYPE_CHECKING:
    from hfield.rings.closed_fields.surds import Surd


class QuadraticArithmetic(GlobalField):
    """The arithmetic of ℚ(√d): tame symbols, and the product formula at a lone place above 2."""

    ring: QuadraticField
    # a root of unity of degree at most 2 over it has order 1 to 6, 8, 10 or 12
    finite_orders: ClassVar[Mapping[int, int]] = {2: 3, 3: 1, 5: 1}

    def read_place(self, text: object) -> QuadraticPlace:
        """Return a prime ideal or an infinite place."""
        return place_of_quadratic(self.ring, text)

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return the symbol; at a lone place above 2 the norms of a and b are factored."""
        x, y = (pair(self.ring, self.ring(x)) for x in (a, b))
        with known_primes(factors):
            return hilbert_symbol_quadratic(self.ring, x, y, place)

    def ramified(self, form: NormalForm) -> tuple[QuadraticPlace, ...]:
        """Return the places with a symbol of −1; the norms of a and b are factored."""
        a, b = (pair(self.ring, x) for x in form.constants)
        return ramified_places_quadratic(self.ring, a, b)

    def discriminant(self, ramified: tuple[QuadraticPlace, ...]) -> tuple[QuadraticPlace, ...]:
        """Return the prime ideals, whose product it is."""
        return tuple(v for v in ramified if v.prime)

    def with_ramification(
        self, places: Sequence[object], infinite: bool | None = None
    ) -> tuple[Surd, Surd]:
        """Return constants found in ℚ[s]/(s² − d), which is the same field."""
        same = [place_in_number_field(self.same.ring, self.read_place(v)) for v in places]
        a, b = self.same.with_ramification(same, infinite)
        return self._back(a), self._back(b)

    @cached_property
    def same(self) -> NumberFieldArithmetic:
        """The arithmetic of the same field as ℚ[s]/(s² − d), which looks for points and isomorphisms."""
        return NumberFieldArithmetic(as_number_field(self.ring))

    def _there(self, c: Constants) -> Constants:
        return Constants(*(into_number_field(self.same.ring, x, self.ring.d) for x in c))

    def _back(self, x: FieldElement) -> Surd:
        return from_number_field(self.ring, x)

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return a point of the conic, or, for rational a and b, a square root of d over ℚ less √d."""
        q = form.back(self._zero(form))
        return found(self.ring, c, q, "conic", CONIC)

    def _zero(self, form: NormalForm) -> Coordinates:
        ring = self.ring
        (a, s), (b, t) = (pair(ring, x) for x in form.constants)
        if s or t:
            c = self._there(Constants(form.a, ring.zero, form.b))
            x, y, z = map(self._back, solve_conic_number_field(self.same.ring, c.a, c.b))
            return z, x, y, ring.zero
        if not ramified_places_q(a, b):
            x, y, z = (ring(u) for u in solve_conic(a, b))
            return z, x, y, ring.zero
        root = traceless_root_rational(QQ, Constants(QQ(a), QQ.zero, QQ(b)), QQ(ring.d))
        assert root is not None, "an algebra over ℚ that ℚ(√d) splits contains a square root of d"
        _, x, y, z = (ring(u) for u in root)
        return -ring.gen, x, y, z

    def residues(self, place: QuadraticPlace) -> DegreeOne | Inert | None:
        """Return the prime ideal with its residue field."""
        return prime_at(place) if place.prime else None

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J as they are found in ℚ[s]/(s² − d)."""
        i, j = self.same.embed(self._there(outer), self._there(inner))
        return self._all_back(i), self._all_back(j)

    def traceless_root(self, form: NormalForm, s: Surd) -> Coordinates | None:
        """Return x as it is found in ℚ[s]/(s² − d)."""
        a, b, square = self._there(Constants(form.a, form.b, s))
        x = self.same.traceless_root(form._replace(a=a, b=b), square)
        return None if x is None else self._all_back(x)

    def _all_back(self, q: Coordinates) -> Coordinates:
        w, x, y, z = map(self._back, q)
        return w, x, y, z
