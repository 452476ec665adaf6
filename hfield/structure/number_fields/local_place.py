"""Prime ideals of number fields with residue fields, for :mod:`minimise` and :mod:`local_order`."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from hfield.rings import GF
from hfield.rings.functions import FunctionField
from hfield.rings.number_elements import FieldElement
from hfield.rings.number_primes import PrimeIdeal
from hfield.structure.function_fields.residue_field import ResidueField


class LocalPlace(ResidueField):
    """A prime ideal P; residues are polynomials over GF(p) modulo ``P.residue``.

    ``uniformiser`` and ``inverse_uniformiser`` have valuation 1 and −1 here, and the second is integral at
    all other primes; they are no inverses.
    """

    def __init__(self, prime: PrimeIdeal) -> None:
        super().__init__(FunctionField(GF(prime.p), "t"), prime.residue)
        self.prime = prime

    @property
    def uniformiser(self) -> FieldElement:
        """An integer of valuation 1 at P."""
        return self.prime.uniformiser  # type: ignore[no-any-return]

    @property
    def inverse_uniformiser(self) -> FieldElement:
        """A number of valuation −1 at P."""
        return self.prime.inverse_uniformiser  # type: ignore[no-any-return]

    def lift(self, x: Any) -> FieldElement:
        """Return a residue as an integer of the field."""
        return self.prime.lift(x)

    def valuation(self, x: FieldElement) -> int:
        """Return the order of a nonzero number at P."""
        return self.prime.valuation(x)

    def reduce(self, x: FieldElement) -> Any:
        """Return the class of a number of valuation ≥ 0."""
        return self.prime.residue_of(x)


@lru_cache(maxsize=256)
def local_place(prime: PrimeIdeal) -> LocalPlace:
    """Return the place of a prime ideal."""
    return LocalPlace(prime)
