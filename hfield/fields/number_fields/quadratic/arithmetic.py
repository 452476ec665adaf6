"""The arithmetic of quadratic fields as global fields, faster than that of general number fields."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from hfield.core.factorisation import Factors, known_primes
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.fields.number_fields.arithmetic import NumberFieldArithmetic
from hfield.fields.number_fields.places import Place
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.quadratic.places import QuadraticPrime
from hfield.fields.number_fields.quadratic.residues import DegreeOne, Inert, prime_at
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.quadratic.symbols import (
    hilbert_symbol_quadratic,
    pair,
    ramified_places_quadratic,
)
from hfield.fields.quadratic_forms.global_field import GlobalField
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import CONIC, ZeroNorm, found
from hfield.fields.quadratic_forms.normal_forms import NormalForm
from hfield.fields.rationals.conics import solve_conic
from hfield.fields.rationals.embedding import traceless_root_rational
from hfield.fields.rationals.ring import QQ
from hfield.fields.rationals.symbols import ramified_places_q


class QuadraticArithmetic(NumberFieldArithmetic):
    """The arithmetic of ℚ(√d): tame symbols, and the product formula if there is only one place above 2."""

    ring: QuadraticField

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return the symbol; at the only place above 2 the norms of a and b are factored."""
        x, y = (pair(self.ring(x)) for x in (a, b))
        with known_primes(factors):
            return hilbert_symbol_quadratic(self.ring, x, y, place)

    def ramified(self, form: NormalForm) -> tuple[Place, ...]:
        """Return the places with a symbol of −1; the norms of a and b are factored."""
        a, b = map(pair, form.constants)
        return ramified_places_quadratic(self.ring, a, b)

    def ramified_at_small_places(self, form: NormalForm) -> tuple[PrimeIdeal, ...]:
        """Return nothing: all ramified places are found quickly."""
        return ()

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return a point of the conic or, for rational a and b, a square root of d over ℚ minus √d."""
        ring = self.ring
        (a, s), (b, t) = map(pair, form.constants)
        if s or t:
            return super().unramified_zero(c, form)
        return found(ring, c, form.back(self._rational_zero(a, b)), "conic", CONIC)

    def _rational_zero(self, a: Fraction, b: Fraction) -> Coordinates:
        ring = self.ring
        if not ramified_places_q(a, b):
            x, y, z = (ring(u) for u in solve_conic(a, b))
            return z, x, y, ring.zero
        root = traceless_root_rational(QQ, Constants(QQ(a), QQ.zero, QQ(b)), QQ(ring.d))
        assert root is not None, "an algebra over ℚ that ℚ(√d) splits contains a square root of d"
        _, x, y, z = (ring(u) for u in root)
        return -ring.gen, x, y, z

    def residues(self, place: Place) -> DegreeOne | Inert | None:  # type: ignore[override]
        """Return the prime ideal with its residue field."""
        return prime_at(place) if isinstance(place, QuadraticPrime) else None

    def evidence(self, c: Constants, places: Iterable[object]) -> Iterator[Mapping[str, object]]:
        """Yield the evidence; prime ideals have only one text."""
        return GlobalField.evidence(self, c, places)
