"""The arithmetic of completions of number fields at infinite places, decided by signs."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

from hfield.core.factorisation import Factors
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.errors import UndecidedError
from hfield.fields.local.arithmetic import CompletionArithmetic
from hfield.fields.quadratic_forms.isomorphisms.isomorphic import by_multiples
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm, found
from hfield.fields.quadratic_forms.norm_forms.zero_norms import zero_norm
from hfield.fields.quadratic_forms.normal_forms import NormalForm

if TYPE_CHECKING:
    from hfield.fields.local.element import LocalElement
    from hfield.fields.number_fields.completions import EmbeddedElement, InfiniteCompletion


class InfiniteArithmetic(CompletionArithmetic):
    """The arithmetic of ℝ or ℂ, whose known elements are those of a number field; in ℝ, two signs decide.

    Questions for elements are answered if the number field contains such elements.
    """

    ring: InfiniteCompletion

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return −1 if a and b are negative real numbers, else 1."""
        self.read_place(place)
        squares = map(self.ring.is_square, self._nonzero(a, b))
        return 1 if any(squares) else -1

    def ramified(self, form: NormalForm) -> tuple[Hashable, ...]:
        """Return the place, or nothing."""
        return (self.ring.place,) if self.hilbert_symbol(form.a, form.b, None, None) < 0 else ()

    def why_ramified(self, form: NormalForm, places: tuple[object, ...]) -> str:
        """Return a text with the signs that show it."""
        a, b = (self.ring.text(x) for x in form.constants)
        return f"{a} and {b} are negative real numbers in {self.ring}"

    def discriminant(self, ramified: tuple[object, ...]) -> EmbeddedElement:
        """Return 1: no prime ramifies."""
        one: EmbeddedElement = self.ring.one
        return one

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return an element of norm 0 over the number field, if there is one."""
        answer = zero_norm(self.ring.global_field, Constants(*(x.value for x in c)))
        if answer.element is None:
            raise self._beyond("its elements of norm 0 have")
        element = map(self.ring, answer.element)
        return found(self.ring, c, element, answer.method, answer.reason)

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return multiples of two of i, j, k, if the number field contains the square roots needed."""
        found = by_multiples(self.ring, outer, inner)
        if found is None:
            raise self._beyond("the images of i and j have")
        return found

    def traceless_root(self, form: NormalForm, s: LocalElement) -> Coordinates | None:
        """Raise an error: multiples of i, j, k have been tried before."""
        raise self._beyond("its square roots have")

    def _beyond(self, what: str) -> UndecidedError:
        return UndecidedError(
            f"{what} coordinates in {self.ring} that are not in {self.ring.global_field}, or were not found; "
            "only elements of that field have names here"
        )
