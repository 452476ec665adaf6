"""A budget of work for one file: each step spends its cost before it starts.

A unit is at most one microsecond and 100 bytes, whichever is reached first; docs/explanation/trust.md has
measurements. Functions that compute with long numbers spend the cost of their length themselves.
"""

from collections.abc import Callable, Collection, Hashable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache
from typing import Generic, Protocol, TypeVar

from hfield.checker.rejection import Rejected, reject

MILLIONS = 10  # of units: 10 seconds and a gigabyte, at worst

T = TypeVar("T")


class Budget:
    """The work allowed for one file, in millions of units; ``left`` is what remains."""

    def __init__(self, millions: float = MILLIONS) -> None:
        self.millions, self.left = millions, round(millions * 1e6)

    @property
    def spent(self) -> int:
        """The units spent; more than the budget if the file was rejected for exceeding it."""
        return round(self.millions * 1e6) - self.left


_current: ContextVar[Budget | None] = ContextVar("budget", default=None)


@contextmanager
def bounded(budget: Budget | None = None) -> Iterator[Budget]:
    """Bound the work inside the ``with``."""
    budget = budget or Budget()
    token = _current.set(budget)
    try:
        yield budget
    finally:
        _current.reset(token)


def spend(units: int) -> None:
    """Spend units of the budget; reject the file if nothing is left."""
    budget = _current.get()
    if budget is not None:
        budget.left -= units
        if budget.left < 0:
            reject(
                "checking this takes more work than is done for one file, "
                f"{budget.millions:g} million units; allow more with --work N, "
                "in Python with budget=Budget(N)"
            )


class Number(Protocol):
    """A number as the budget sees it: an integer, or a polynomial over a finite field."""

    def bit_length(self) -> int:
        """Return the number of bits."""


def spend_products(some: Collection[Number], others: Collection[Number]) -> None:
    """Spend the cost of multiplying, dividing or reducing each number in ``some`` by each in ``others``."""
    bits, more = (sum([n.bit_length() for n in numbers]) for numbers in (some, others))
    linear = bits * len(others) + more * len(some)
    spend(len(some) * len(others) + linear // 1_000 + bits * more // 500_000)


def spend_inverse(modulus: int) -> None:
    """Spend the cost of a modular inverse, for which Python has no fast algorithm."""
    bits = modulus.bit_length()
    spend(5 + bits // 10 + bits * bits // 15_000)


class Remembered(Generic[T]):
    """Caches a function of one argument. Each call spends its full cost, so earlier files do not matter."""

    def __init__(self, function: Callable[..., T]) -> None:
        self._function, self._found = function, lru_cache(maxsize=256)(self._measured)
        self.cache_clear = self._found.cache_clear

    def __call__(self, argument: Hashable) -> T:
        """Return the value of the function."""
        value, cost = self._found(argument)
        spend(cost)
        return value

    def _measured(self, argument: Hashable) -> tuple[T, int]:
        outer = _current.get()
        inner = Budget(outer.millions if outer else 1e9)
        inner.left = before = outer.left if outer else inner.left
        try:
            with bounded(inner):
                return self._function(argument), before - inner.left
        except Rejected:
            if outer:
                outer.left = inner.left
            raise
