"""Quadratic number fields as global fields."""

from __future__ import annotations

import functools
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar

from hfield.factorisation import Factors, known_primes
from hfield.fields.number_fields.quadratic.as_number_field import (
    as_number_field,
    from_number_field,
    place_in_number_field,
)
from hfield.fields.number_fields.quadratic.conics import solve_conic_quadratic
from hfield.fields.number_fields.quadratic.places import QuadraticPlace, place_of_quadratic
from hfield.fields.number_fields.quadratic.residues import PrimeIdeal, prime_at
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.quadratic.slots import common_slot
from hfield.fields.number_fields.quadratic.symbols import (
    hilbert_symbol_quadratic,
    integral,
    is_local_square,
    pair,
    ramified_places_quadratic,
)
from hfield.fields.number_fields.slots import from_ramification_number_field
from hfield.fields.rationals.conics import solve_conic
from hfield.fields.rationals.embedding import traceless_root_rational
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.product import Constants, Coordinates, Scalar
from hfield.rings.integers import QQ
from hfield.structure.forms import NormalForm
from hfield.structure.global_field import GlobalField, no_flag
from hfield.structure.isomorphisms.through_slots import Point, generator_by_slot, through_slot
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
        if infinite is not None:
            raise no_flag(self.ring)
        field = as_number_field(self.ring)
        same = [place_in_number_field(field, self.read_place(v)) for v in places]
        a, b = from_ramification_number_field(field, same)
        return from_number_field(self.ring, a), from_number_field(self.ring, b)

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return a point of the conic, or, for rational a and b, a square root of d over ℚ less √d."""
        q = form.back(self._zero(form))
        return found(self.ring, c, q, "conic", CONIC)

    def _zero(self, form: NormalForm) -> Coordinates:
        ring = self.ring
        (a, s), (b, t) = (pair(ring, x) for x in form.constants)
        if s or t:
            x, y, z = solve_conic_quadratic(ring, form.a, form.b)
            return z, x, y, ring.zero
        if not ramified_places_q(a, b):
            x, y, z = (ring(u) for u in solve_conic(a, b))
            return z, x, y, ring.zero
        root = traceless_root_rational(QQ, Constants(QQ(a), QQ.zero, QQ(b)), QQ(ring.d))
        assert root is not None, "an algebra over ℚ that ℚ(√d) splits contains a square root of d"
        _, x, y, z = (ring(u) for u in root)
        return -ring.gen, x, y, z

    def residues(self, place: QuadraticPlace) -> PrimeIdeal | None:
        """Return the prime ideal with its residue field."""
        return prime_at(self.ring, place) if place.prime else None

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J by a common slot and three conics."""
        return through_slot(self.ring, outer, inner, *self._slot(outer, [outer.a, inner.a]))

    def traceless_root(self, form: NormalForm, s: Surd) -> Coordinates | None:
        """Return x by a common slot, unless s is a square at a ramified place."""
        c = Constants(form.a, self.ring.zero, form.b)
        local = integral(pair(self.ring, s))
        if any(is_local_square(v, local) for v in self.ramified(form)):
            return None
        return generator_by_slot(self.ring, s, c, *self._slot(c, [c.a, s]))[0]

    def _slot(self, c: Constants, numbers: list[Surd]) -> tuple[Surd, Point]:
        """Return a common slot built from local classes, and what solves conics with its primes."""
        e, primes = common_slot(self.ring, c, numbers)
        return e, functools.partial(_conic_point, self.ring, primes)


def _conic_point(
    field: QuadraticField, known: Iterable[int], c: Constants
) -> tuple[Surd, Surd, Surd]:
    """Return ``(w, x, y)`` ≠ 0 with ``w² = a·x² + b·y²``, given the primes of the norms of a and b."""
    x, y, w = solve_conic_quadratic(field, c.a, c.b, known)
    return w, x, y
