"""ℚ as a global field."""

from typing import Any

from hfield.factorisation import Factors
from hfield.structure.forms import NormalForm
from hfield.structure.global_field import GlobalField
from hfield.structure.rationals.hilbert_rationals import (
    Place,
    discriminant_q,
    hilbert_symbol_q,
    place_of_q,
    ramified_places_q,
)


class RationalArithmetic(GlobalField):
    """The arithmetic of ℚ: symbols by formula, places as primes and ``"inf"``."""

    def read_place(self, text: Any) -> Place:
        """Return a prime or ``"inf"``."""
        return place_of_q(text)

    def hilbert_symbol(self, a: Any, b: Any, place: Any, factors: Factors | None) -> int:
        """Return the symbol by formula; nothing is factored."""
        a, b = (self.ring(x) if isinstance(x, str) else x for x in (a, b))
        return hilbert_symbol_q(a, b, place)

    def ramified(self, form: NormalForm) -> tuple[Place, ...]:
        """Return the primes, and ``"inf"``, with a symbol of −1."""
        return ramified_places_q(form.a, form.b)

    def discriminant(self, ramified: tuple[Any, ...]) -> int:
        """Return the product of the primes."""
        return discriminant_q(ramified)
