"""What the completions of a global field share: their elements are elements of that field, first of all."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from random import Random
from typing import Any

from hfield.errors import CoercionError
from hfield.rings.base import Ring
from hfield.rings.local.element import LocalElement
from hfield.rings.rational import rational, unwrap


class Completion(Ring):
    """The completion of a global field at a place; elements are :class:`LocalElement`.

    ``global_field`` and ``place`` say of what and where. Texts mean what they mean in the global field.
    """

    is_field = True

    def __init__(self, name: str, words: str, global_field: Ring, place: Any) -> None:
        self.name, self._words = name, words
        self.global_field, self.place = global_field, place
        self.characteristic = global_field.characteristic
        self.gen_name = global_field.gen_name
        self.parse_limit = global_field.parse_limit

    def in_words(self) -> str:
        """Say what the field is."""
        return self._words

    def __call__(self, x: Any) -> Any:
        """Turn a number or an element of the global field into an exact element; read a text.

        Raises :class:`CoercionError`.
        """
        x = unwrap(x)
        if isinstance(x, LocalElement):
            if x.field == self:
                return x
            raise self.refuse(x)
        if isinstance(x, str):
            return self.parse(x)
        number = rational(x)
        try:
            return LocalElement(self, self.global_field(x if number is None else number))
        except CoercionError:
            raise self.refuse(x) from None

    def truncated(self, x: Any, n: int) -> Any:
        """Return the standard element of the global field that is x up to the n-th digit."""
        raise CoercionError(f"the elements of {self.name} are exact: none is known up to O(…)")

    def order_of(self, x: Any) -> int:
        """Return the valuation of a nonzero element of the global field."""
        raise CoercionError(
            f"{self.place} is no prime: the elements of {self.name} have no valuation"
        )

    def inverse_of(self, x: Any, precision: int | None) -> Any:
        """Return 1/x for a nonzero element of the global field."""
        return self.global_field.inverse(x)

    @property
    def gen(self) -> Any:
        """The generator of the global field."""
        return LocalElement(self, self.global_field.gen) if self.gen_name else super().gen

    def names(self) -> dict[str, Any]:
        """What names mean in the global field."""
        return {name: LocalElement(self, x) for name, x in self.global_field.names().items()}

    def functions(self) -> dict[str, Callable[..., Any]]:
        """What functions mean in the global field."""
        return {name: self._lifted(f) for name, f in self.global_field.functions().items()}

    def _lifted(self, f: Callable[..., Any]) -> Callable[..., Any]:
        """Return a function of the global field as one of exact elements."""
        return lambda *xs: self(f(*(x.value for x in xs)))

    def inverse(self, x: Any) -> Any:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0, and for what may be 0."""
        return x.inverse()

    def places(self) -> Iterator[Any]:
        """Run through the places: there is one."""
        yield self.place

    def random(self, rng: Random) -> Any:
        """Return a small random exact element; the same for the same seed."""
        return LocalElement(self, self.global_field.random(rng))
