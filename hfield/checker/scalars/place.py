"""The protocol of a place in the checker: integral elements, and their residues."""

from abc import ABC, abstractmethod
from collections.abc import Hashable
from typing import Any, Generic, TypeAlias, TypeVar

E = TypeVar("E", bound=Hashable)  # the elements of the field
R = TypeVar("R", bound=Hashable)  # the residues


class Place(ABC, Generic[E, R]):
    """A valuation of a field, with ``odd``, an element of odd valuation.

    ``name`` is canonical, except for ideals described with another generator: a field has only one place of
    each name.
    """

    odd: E
    name: str

    @abstractmethod
    def residue(self, x: E) -> R | None:
        """Return the residue of an integral element; None for other elements."""

    @abstractmethod
    def is_unit(self, residue: R) -> bool:
        """Return whether a residue is the residue of a unit."""

    @abstractmethod
    def is_irreducible(self, trace: R, norm: R) -> bool:
        """Return whether X² − trace·X + norm has no root in the residue field."""


AnyPlace: TypeAlias = Place[E, Any]
"""A place that was read from data: of what type its residues are, only the place knows."""
