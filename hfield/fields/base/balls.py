"""Numbers enclosed in flint's balls: what can be read off an enclosure that may be made ever smaller."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import flint

from hfield.core import locks
from hfield.errors import UndecidedError

MAX_BITS = 100_000

Enclosure = Callable[[int], Any]  # bits of working precision ↦ a complex ball around the number
_lock = locks.lock()


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work with so many bits, one thread at a time: flint has one precision for all of them."""
    with _lock, flint.ctx.workprec(bits):
        yield


def fingerprint(enclosure: Enclosure) -> tuple[int, int]:
    """Return integers that depend on the number alone: ``⌊2³⁰·re + π⌋`` and ``⌊2³⁰·im + π⌋``.

    The shift by π keeps an algebraic number off the integers, where no enclosure would decide a floor.
    """
    return _floor(enclosure, lambda z: z.real), _floor(enclosure, lambda z: z.imag)


def _floor(enclosure: Enclosure, part: Callable[[Any], Any]) -> int:
    bits = 96
    while bits <= MAX_BITS:
        value = part(enclosure(bits))
        with precision(bits):
            floor = (value * 2**30 + flint.arb.pi()).floor().unique_fmpz()
        if floor is not None:
            return int(floor)
        bits *= 2
    raise UndecidedError("a number lies too near a rounding boundary to be hashed")
