"""ℚ as a global field."""

from contextlib import AbstractContextManager, nullcontext
from typing import Any

from hfield.factorisation import WORD, Factors, known_primes, shared_primes
from hfield.product import Constants, Coordinates
from hfield.structure.forms import NormalForm
from hfield.structure.global_field import GlobalField
from hfield.structure.rationals.hilbert_rationals import (
    Place,
    discriminant_q,
    hilbert_symbol_q,
    place_of_q,
    ramified_places_q,
)
from hfield.structure.rationals.rational_embedding import embed_rational, traceless_root_rational
from hfield.structure.rationals.whole_numbers import square_class


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

    def sharing_primes(self, *forms: NormalForm) -> AbstractContextManager[None]:
        """Share the primes of constants that are longer than a word."""
        numbers = [square_class(x) for form in forms for x in form.constants]
        if all(-WORD < n < WORD for n in numbers):
            return nullcontext()
        return known_primes(shared_primes(numbers), "")

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J by an isometry of lattices."""
        return embed_rational(self.ring, outer, inner)

    def traceless_root(self, form: NormalForm, s: Any) -> Coordinates | None:
        """Return x by an isometry with an algebra (s, e) of the same ramification."""
        return traceless_root_rational(self.ring, Constants(form.a, self.ring.zero, form.b), s)
