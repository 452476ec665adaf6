"""What the completions of a global field share as fields with places: the one place, and the field below."""

from __future__ import annotations

from collections.abc import Hashable

from hfield.errors import RingError
from hfield.fields.local.completion import Completion
from hfield.rings.base import Ring
from hfield.structure.global_field import GlobalField, known_field


class CompletionArithmetic(GlobalField):
    """The arithmetic of a completion, which asks that of the field it completes, ``below``."""

    ring: Completion

    def __init__(self, ring: Ring) -> None:
        super().__init__(ring)
        self.below = known_field(self.ring.global_field)

    def read_place(self, text: object) -> Hashable:
        """Return the one place, from its text or from None. Raises :class:`RingError` for another."""
        place: Hashable = self.ring.place
        if text is not None and self.below.read_place(text) != place:
            raise RingError(f"{self.ring} has one place, {place}; {text} is not it")
        return place
