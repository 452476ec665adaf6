"""ℚ as a global field."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from hfield.core.factorisation import Factors
from hfield.core.primality import primes
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.fields.quadratic_forms.global_field import GlobalField
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import CONIC, ZeroNorm, found
from hfield.fields.quadratic_forms.normal_forms import NormalForm
from hfield.fields.rationals.conics import solve_conic
from hfield.fields.rationals.embedding import embed_rational, traceless_root_rational
from hfield.fields.rationals.places import INFINITE, Place, place_of_q
from hfield.fields.rationals.residues import PrimePlace
from hfield.fields.rationals.symbols import (
    discriminant_q,
    from_ramification_q,
    hilbert_symbol_q,
    is_isotropic,
    ramified_places_q,
)
from hfield.fields.rationals.whole_numbers import fraction, square_class

if TYPE_CHECKING:
    import flint


class RationalArithmetic(GlobalField):
    """The arithmetic of ℚ: symbols by formula, places as primes and ``"inf"``."""

    def read_place(self, text: object) -> Place:
        """Return a prime or ``"inf"``."""
        return place_of_q(text)

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return the symbol by formula; nothing is factored."""
        a, b = (self.ring(x) if isinstance(x, str) else x for x in (a, b))
        return hilbert_symbol_q(a, b, place)

    def is_anisotropic(self, form: Sequence[flint.fmpq]) -> bool:
        """Decide it; for five or more variables, by the signs (Meyer)."""
        if len(form) > 4:
            return all(c > 0 for c in form) or all(c < 0 for c in form)
        return not is_isotropic([fraction(c) for c in form])

    def ramified(self, form: NormalForm) -> tuple[Place, ...]:
        """Return the primes, and ``"inf"``, with a symbol of −1."""
        return ramified_places_q(form.a, form.b)

    def discriminant(self, ramified: tuple[int, ...]) -> int:
        """Return the product of the primes."""
        return discriminant_q(ramified)

    def ramified_at_small_places(self, form: NormalForm) -> tuple[int, ...]:
        """Return the primes below 200 with a symbol of −1."""
        return tuple(p for p in primes(200) if hilbert_symbol_q(form.a, form.b, p) < 0)

    def with_ramification(
        self, places: Sequence[Place], infinite: bool | None = None
    ) -> tuple[Scalar, Scalar]:
        """Return constants of an algebra that ramifies at the given primes, and at ∞ if that is named or
        needed.
        """
        return from_ramification_q(places, infinite)

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return a point of the conic ``z² = a·x² + b·y²``."""
        x, y, z = (self.ring(u) for u in solve_conic(form.a, form.b))
        return found(self.ring, c, form.back((z, x, y, self.ring.zero)), "conic", CONIC)

    def residues(self, place: Place) -> PrimePlace | None:
        """Return ℤ/p."""
        return None if place == INFINITE else PrimePlace(int(place))

    def _exact(self, c: Constants) -> tuple[Constants, Scalar]:
        return Constants(*(fraction(x) for x in c)), Fraction(1)

    def _to_factor(self, x: flint.fmpq) -> tuple[int]:
        return (square_class(x),)

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J in one algebra with the relations of the other, by an isometry of lattices."""
        return embed_rational(self.ring, outer, inner)

    def traceless_root(self, form: NormalForm, s: flint.fmpq) -> Coordinates | None:
        """Return x of trace 0 with x² = s, by an isomorphism with an algebra (s, e), or None."""
        return traceless_root_rational(self.ring, Constants(form.a, self.ring.zero, form.b), s)
