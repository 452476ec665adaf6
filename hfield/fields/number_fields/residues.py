"""Prime ideals of number fields with residue fields, for :mod:`minimal_conics` and :mod:`local_order`."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from hfield.fields.finite.names import GF
from hfield.fields.function_fields.residues import ResidueField
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.prime_ideals import PrimeIdeal

if TYPE_CHECKING:
    import flint


class LocalPlace(ResidueField):
    """A prime ideal P; residues are polynomials over GF(p) modulo ``P.residue``.

    ``uniformiser`` has valuation 1 here and ``inverse_uniformiser`` −1; the second is integral at all other
    primes. They are not inverse to each other.
    """

    def __init__(self, prime: PrimeIdeal) -> None:
        super().__init__(FunctionField(GF(prime.p), "t"), prime.residue)
        self.prime, self.below, self.index = prime, prime.p, prime.e

    @property
    def uniformiser(self) -> FieldElement:
        """An integer of valuation 1 at P."""
        return self.prime.uniformiser

    @property
    def inverse_uniformiser(self) -> FieldElement:
        """A number of valuation −1 at P."""
        return self.prime.inverse_uniformiser

    def lift(self, x: flint.nmod_poly) -> FieldElement:
        """Return a residue as an integer of the field."""
        return self.prime.lift(x)

    def valuation(self, x: FieldElement) -> int:
        """Return the valuation of a nonzero number at P."""
        return self.prime.valuation(x)

    def reduce(self, x: FieldElement) -> flint.nmod_poly:
        """Return the class of a number of valuation ≥ 0."""
        return self.prime.residue_of(x)

    def truncated(self, x: FieldElement, n: int) -> FieldElement:
        """Return the sum of dₖ·πᵏ over k < n, with lifted residues dₖ, that agrees with x up to Pⁿ."""
        total: FieldElement = x.field.zero
        if not x:
            return total
        inverse, first = self.uniformiser.inverse(), self.valuation(x)
        power = self.uniformiser**first
        rest = x * inverse**first
        for _ in range(first, n):
            digit = self.lift(self.reduce(rest))
            total, power = total + digit * power, power * self.uniformiser
            rest = (rest - digit) * inverse
            if not rest:
                break
        return total


@lru_cache(maxsize=256)
def local_place(prime: PrimeIdeal) -> LocalPlace:
    """Return the place of a prime ideal."""
    return LocalPlace(prime)
