"""The common part of completions of a global field, whose exact elements are those of that field."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Hashable, Iterator
from random import Random
from typing import TYPE_CHECKING, Any

from hfield.core.product import Scalar
from hfield.errors import UndecidedError
from hfield.fields.base.operators import Overfield
from hfield.fields.base.ring import E, Ring, shared

if TYPE_CHECKING:
    from collections.abc import Hashable


class Completion(Overfield[E]):
    """The completion of ``global_field`` at ``place``.

    Elements are :class:`~hfield.fields.base.operators.Element` with a ``value`` in the global field; texts
    have the same meaning as there.
    """

    def __init__(self, name: str, words: str, global_field: Ring, place: Hashable) -> None:
        self.name, self._words = name, words
        self.global_field, self.place = global_field, place
        self.characteristic = global_field.characteristic
        self.gen_name = global_field.gen_name
        self.parse_limit = global_field.parse_limit

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (self.global_field.completion, "".join(str(self.place).split()))

    @property
    def data(self) -> dict[str, object]:
        """The completed field and the place, as JSON data."""
        at = self.place_data(self.place)
        return {"kind": "completion", "of": self.global_field.data, "place": at}

    def place_data(self, place: object) -> dict[str, object]:
        """Return the place of the global field as JSON data."""
        return self.global_field.place_data(place)

    def in_words(self) -> str:
        """Return a description of the field."""
        return self._words

    def from_below(self, x: object) -> E:
        """Convert a number or an element of the global field to an exact element.

        Raises :class:`CoercionError`.
        """
        return self.exact(self.global_field(x))

    def embed_from(self, source: Ring) -> Callable[[object], E] | None:
        """Return the inclusion of the global field."""
        return self if source == self.global_field else None

    @abstractmethod
    def exact(self, value: Scalar) -> E:
        """Return an element of the global field as an element of this field."""

    @property
    def gen(self) -> E:
        """The generator of the global field."""
        return self.exact(self.global_field.gen) if self.gen_name else super().gen

    def names(self) -> dict[str, E]:
        """The names of the global field and their values."""
        return {name: self.exact(x) for name, x in self.global_field.names().items()}

    def functions(self) -> dict[str, Callable[..., E]]:
        """The functions of the global field."""
        return {name: self._lifted(f) for name, f in self.global_field.functions().items()}

    def _lifted(self, f: Callable[..., Scalar]) -> Callable[..., E]:
        """Return a function of the global field as a function of exact elements."""

        def lifted(*xs: Any) -> E:
            for x in xs:
                if not self.is_known(x):
                    raise UndecidedError(f"a function of {self.text(x)} depends on unknown digits")
            return self(f(*(x.value for x in xs)))

        return lifted

    def places(self) -> Iterator[Hashable]:
        """Yield the only place."""
        yield self.place

    def random(self, rng: Random) -> E:
        """Return a small random exact element; the same for the same seed."""
        return self.exact(self.global_field.random(rng))
