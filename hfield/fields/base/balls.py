"""Decide by enclosing numbers in flint's balls, at increasing precision."""

from collections.abc import Callable

import flint

from hfield.core import locks
from hfield.errors import UndecidedError

MAX_BITS = 100_000

Enclosure = Callable[[int], flint.acb]
"""Bits of working precision ↦ a complex ball around the number."""
_lock = locks.lock()


class precision:  # noqa: N801  # it is used as a function
    """Set flint's global precision, for one thread at a time.

    It is a class rather than a generator because class groups of small fields enter it a hundred times; a
    generator would cost them 5 % of their time.
    """

    __slots__ = ("before", "bits")

    def __init__(self, bits: int) -> None:
        self.bits = bits

    def __enter__(self) -> None:
        _lock.acquire()
        try:
            self.before = flint.ctx.prec
            flint.ctx.prec = self.bits
        except BaseException:
            _lock.release()
            raise

    def __exit__(self, *error: object) -> None:
        flint.ctx.prec = self.before
        _lock.release()


def fingerprint(enclosure: Enclosure) -> tuple[int, int]:
    """Return the integers ``⌊2³⁰·re + π⌋`` and ``⌊2³⁰·im + π⌋``, which do not depend on the precision of the
    enclosure.

    The shift by π keeps algebraic numbers away from the integers, at which no enclosure could determine the
    floor.
    """
    return _floor(enclosure, lambda z: z.real), _floor(enclosure, lambda z: z.imag)


def _floor(enclosure: Enclosure, part: Callable[[flint.acb], flint.arb]) -> int:
    bits = 96
    while bits <= MAX_BITS:
        value = part(enclosure(bits))
        with precision(bits):
            floor = (value * 2**30 + flint.arb.pi()).floor().unique_fmpz()
        if floor is not None:
            return int(floor)
        bits *= 2
    raise UndecidedError("a number lies too near a rounding boundary to be hashed")
