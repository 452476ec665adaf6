"""A bound on the work for one file: whatever takes time or memory is charged for before it is begun.

A unit is a microsecond and 100 bytes at worst, whichever is reached first; docs/trust.md has measurements.
What computes with numbers of any length charges for their lengths, in the function that computes.
"""

from collections.abc import Callable, Collection, Hashable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache
from typing import Generic, TypeVar

from hfield.checker.rejection import Rejected, reject

MILLIONS = 10  # of units: 10 seconds and a gigabyte, at worst

T = TypeVar("T")


class Work:
    """The work that may be done for one file, in millions of units; ``left`` is what has not been done."""

    def __init__(self, millions: float = MILLIONS) -> None:
        self.millions, self.left = millions, round(millions * 1e6)

    @property
    def spent(self) -> int:
        """How many units were charged; more than there were, if that is why a file was rejected."""
        return round(self.millions * 1e6) - self.left


_current: ContextVar[Work | None] = ContextVar("work", default=None)


@contextmanager
def bounded(work: Work | None = None) -> Iterator[Work]:
    """Bound the work inside."""
    work = work or Work()
    token = _current.set(work)
    try:
        yield work
    finally:
        _current.reset(token)


def charge(units: int) -> None:
    """Charge for work; reject the file when nothing is left."""
    work = _current.get()
    if work is not None:
        work.left -= units
        if work.left < 0:
            reject(
                f"checking this takes more work than is done for one file, {work.millions:g} million units; "
                "more is done with --work N, in Python with work=Work(N)"
            )


def charge_products(some: Collection[int], others: Collection[int]) -> None:
    """Charge for multiplying, dividing or reducing each of some numbers by each of others."""
    bits, more = sum(map(int.bit_length, some)), sum(map(int.bit_length, others))
    linear = bits * len(others) + more * len(some)
    charge(len(some) * len(others) + linear // 1_000 + bits * more // 500_000)


def charge_inverse(modulus: int) -> None:
    """Charge for an inverse modulo a number, which Python finds without a fast algorithm."""
    bits = modulus.bit_length()
    charge(5 + bits // 10 + bits * bits // 15_000)


class Remembered(Generic[T]):
    """A function of one argument that remembers and charges each time: a file costs the same after others."""

    def __init__(self, function: Callable[..., T]) -> None:
        self._function, self._found = function, lru_cache(maxsize=256)(self._measured)
        self.cache_clear = self._found.cache_clear

    def __call__(self, argument: Hashable) -> T:
        """Return what the function does."""
        value, cost = self._found(argument)
        charge(cost)
        return value

    def _measured(self, argument: Hashable) -> tuple[T, int]:
        outer = _current.get()
        inner = Work(outer.millions if outer else 1e9)
        inner.left = before = outer.left if outer else inner.left
        try:
            with bounded(inner):
                return self._function(argument), before - inner.left
        except Rejected:
            if outer:
                outer.left = inner.left
            raise
