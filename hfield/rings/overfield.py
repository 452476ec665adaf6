"""Fields above a ring that they contain: they read what that ring reads, texts and their own elements."""

from __future__ import annotations

from abc import abstractmethod

from hfield.errors import CoercionError
from hfield.rings.base import E, Ring
from hfield.rings.operators import Element
from hfield.rings.rational import unwrap


class Overfield(Ring[E]):
    """A field above a ring; its elements are :class:`~hfield.rings.operators.Element`.

    A class of such fields gives :meth:`from_below`.
    """

    is_field = True

    @abstractmethod
    def from_below(self, x: object) -> E:
        """Return as an element of the field what the ring below reads; it raises :class:`CoercionError`."""

    def __call__(self, x: object) -> E:
        """Return an element as it is, turn what the ring below reads into one, read a text.

        Raises :class:`CoercionError`.
        """
        x = unwrap(x)
        if isinstance(x, Element) and (x.field is self or x.field == self):
            return x  # type: ignore[return-value]  # a field has elements of one class
        if isinstance(x, str):
            return self.parse(x)
        try:
            return self.from_below(x)
        except CoercionError:
            raise self.refuse(x) from None
