"""The places of number fields, real places, complex places and prime ideals: listed, and read from their
texts.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING

from hfield.core.primality import is_prime, primes
from hfield.errors import HFieldError, RingError, shorten
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, primes_above

if TYPE_CHECKING:
    import flint

    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ring import NumberField


@dataclass(frozen=True)
class _InfinitePlace:
    """A place at infinity: a root of the field's polynomial, up to complex conjugation."""

    field: NumberField
    index: int

    is_finite = False

    def __str__(self) -> str:
        return "inf" if self.field.embeddings.count == 1 else f"inf{self.index}"

    def __repr__(self) -> str:
        return str(self)

    @property
    def data(self) -> dict[str, object]:
        """The place as JSON data."""
        return {"kind": "real" if isinstance(self, RealPlace) else "complex", "number": self.index}

    def value(self, x: FieldElement, digits: int = 15) -> flint.acb:
        """Return the image of x, a complex ball of flint with ``digits`` correct digits."""
        return self.field.embed(x, self.index, digits)


class RealPlace(_InfinitePlace):
    """A real place; ``index`` is the number of the real root of the polynomial, ascending from 0."""

    def sign(self, x: FieldElement) -> int:
        """Return the sign of x there: −1, 0 or 1."""
        return self.field.sign_at(self.field(x), self.index)


class ComplexPlace(_InfinitePlace):
    """A complex place; its ``index`` follows those of the real places."""


Place = PrimeIdeal | RealPlace | ComplexPlace


def all_places(field: NumberField) -> Iterator[Place]:
    """Yield the places: infinite ones, then prime by prime."""
    yield from field.infinite_places()
    yield from finite_places(field)


def finite_places(field: NumberField) -> Iterator[PrimeIdeal]:
    """Yield the prime ideals without end, prime by prime."""
    for p in primes():
        yield from primes_above(field, p)


def place_of_number_field(field: NumberField, place: object) -> Place:
    """Read a place: a place of the field, its text, or a prime with a single place above it.

    Raises :class:`RingError` for other values, and for a place of another field.
    """
    if isinstance(place, (PrimeIdeal, _InfinitePlace)):
        if place.field == field:
            return place  # type: ignore[return-value]
        raise RingError(
            f"{place} is a place of {shorten(place.field.name)}, not of {shorten(field.name)}"
        )
    text = "".join(str(place).split())
    if text.startswith("inf"):
        above: tuple[Place, ...] = field.infinite_places()
    else:
        inside = text[1:-1] if text.startswith("(") and text.endswith(")") else text
        p, comma, second = inside.partition(",")
        if not p.isdecimal() or not is_prime(int(p)) or (comma and inside == text):
            example = max(islice(finite_places(field), 12), key=lambda P: not P.is_inert)
            raise RingError(
                f"{shorten(place)!r} is not a place of {shorten(field.name)}: expected a prime ideal, such "
                f'as "{example}", or an infinite place, such as "{field.infinite_places()[0]}"'
            )
        above = primes_above(field, int(p))
        if second:
            try:
                pi = field(second)
            except HFieldError as error:
                raise RingError(f"the place {shorten(place)!r} cannot be read: {error}") from error
            # the checker's names have numbers that are integral at p, perhaps not elsewhere
            within = [P for P in primes_above(field, int(p)) if not pi or P.valuation(pi) > 0]
            if len(within) == 1:
                return within[0]
        elif len(above) == 1:
            return above[0]
    for v in above:
        texts = (str(v), v.short_name) if isinstance(v, PrimeIdeal) else (str(v),)
        if text in ("".join(t.split()) for t in texts):
            return v
    names = ", ".join(f'"{v}"' for v in above)
    raise RingError(
        f"{shorten(place)!r} is not a single place of {shorten(field.name)}: the places above it are {names}"
    )
