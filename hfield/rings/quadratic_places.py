"""The places of quadratic number fields ℚ(√d): prime ideals and infinite places, listed and read."""

from collections.abc import Iterator
from dataclasses import dataclass

import flint

from hfield.errors import RingError
from hfield.factorisation import is_prime


@dataclass(frozen=True)
class QuadraticPlace:
    """A place of ℚ(√d): the prime p it lies over (0 for an infinite place) and where √d goes.

    ``root`` is the image of √d modulo p (modulo 4 for p = 2) where p splits, ±1 at the two real
    places, and None where there is one place above p. The text (``"7"``, ``"(7, sqrt(2)-3)"``,
    ``"inf+"``, ``"inf-"``, ``"inf"``) reads back with :func:`place_of_quadratic`.
    """

    d: int
    prime: int
    root: int | None = None

    def __str__(self) -> str:
        if self.prime:
            gen = "I" if self.d == -1 else f"sqrt({self.d})"
            return str(self.prime) if self.root is None else f"({self.prime}, {gen}-{self.root})"
        return {None: "inf", 1: "inf+", -1: "inf-"}[self.root]

    def __repr__(self) -> str:
        return str(self)


def places_above(d: int, p: int) -> tuple[QuadraticPlace, ...]:
    """Return the one or two places of ℚ(√d) above the prime p, or above infinity for p = 0."""
    roots: list[int | None]
    if p == 0:
        roots = [1, -1] if d > 0 else [None]
    elif p == 2:
        roots = [1, 3] if d % 8 == 1 else [None]
    elif d % p and pow(d, (p - 1) // 2, p) == 1:
        r = int(flint.fmpz(d % p).sqrtmod(p))
        roots = [*sorted((r, p - r))]
    else:
        roots = [None]
    return tuple(QuadraticPlace(d, p, r) for r in roots)


def all_places(d: int) -> Iterator[QuadraticPlace]:
    """Run through the places of ℚ(√d): the infinite ones, then prime by prime, without end."""
    yield from places_above(d, 0)
    p = 1
    while True:
        p += 1
        if is_prime(p):
            yield from places_above(d, p)


def place_of_quadratic(d: int, place: object) -> QuadraticPlace:
    """Read a place: a :class:`QuadraticPlace`, its text, or a prime with a single place above it."""
    if isinstance(place, QuadraticPlace) and place.d == d:
        return place
    text = str(place).replace(" ", "")
    head = text.lstrip("(").split(",")[0]
    p = 0 if text.startswith("inf") else int(head) if head.isdecimal() else -1
    if p == 0 or is_prime(p):
        above = places_above(d, p)
        for v in above:
            if str(v).replace(" ", "") == text:
                return v
        names = ", ".join(f'"{v}"' for v in above)
        raise RingError(f"{place!r} names no single place of QQ(sqrt({d})): above it lie {names}")
    raise RingError(
        f'{place!r} is not a place of QQ(sqrt({d})): expected "inf", a prime, or the text of a place'
    )
