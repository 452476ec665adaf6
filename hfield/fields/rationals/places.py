"""The places of ℚ: primes, as ints, and infinity, as the text ``"inf"``."""

import math

import flint

from hfield.core.primality import is_prime
from hfield.errors import RingError, shorten

Place = int | str
INFINITE = "inf"
INFINITE_NAMES = frozenset({"inf", "oo", "∞", "infinity", "infty"})


def place_of_q(place: object) -> Place:
    """Read a place of ℚ: a prime (int or text), or ``"inf"`` (also ``"oo"``, ``∞``, −1)."""
    if isinstance(place, str) and place.strip().lower() in INFINITE_NAMES:
        return INFINITE
    if isinstance(place, float) and math.isinf(place):
        return INFINITE
    if isinstance(place, str) and place.strip().isdecimal():
        place = int(place)
    if isinstance(place, (int, flint.fmpz)) and not isinstance(place, bool):
        if place == -1:
            return INFINITE
        if is_prime(int(place)):
            return int(place)
    raise RingError(f'{shorten(repr(place))} is not a place of QQ: expected a prime or "inf"')
