"""The protocol of a place in the checker: integral elements, and their residues."""

from abc import ABC, abstractmethod
from collections.abc import Hashable
from typing import Any


class Place(ABC):
    """A valuation of a field, and ``odd``, an element whose valuation is an odd number.

    ``name`` is canonical, but for ideals that another generator describes: a field has one place of a name.
    """

    odd: Any
    name: str

    @abstractmethod
    def residue(self, x: Any) -> Hashable | None:
        """Return the residue of an integral element; None for another."""

    @abstractmethod
    def is_unit(self, residue: Any) -> bool:
        """Return whether this is the residue of a unit."""

    @abstractmethod
    def is_irreducible(self, trace: Any, norm: Any) -> bool:
        """Return whether X² − trace·X + norm has no root in the residue field."""
