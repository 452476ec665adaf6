"""Numbers, ideals, primes and residues of a base, as functions that serve every base use them."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Protocol, Self, TypeAlias

Prime: TypeAlias = Hashable
"""A prime of a base: over ℤ a number, elsewhere a prime ideal. Only the base looks into it."""


class Scalar(Protocol):
    """A number of the field of a base: a rational number of flint, or an element of a number field."""

    def __add__(self, other: Self | int, /) -> Self: ...
    def __sub__(self, other: Self | int, /) -> Self: ...
    def __mul__(self, other: Self | int, /) -> Self: ...
    def __truediv__(self, other: Self | int, /) -> Self: ...
    def __rtruediv__(self, other: int, /) -> Self: ...
    def __neg__(self) -> Self: ...
    def __bool__(self) -> bool: ...


class BaseIdeal(Protocol):
    """A fractional ideal of a base: over ℤ the positive Fraction that generates it; 1 is the unit ideal."""

    def __mul__(self, other: Self, /) -> Self: ...
    def __truediv__(self, other: Self, /) -> Self: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...


ThetaSeries: TypeAlias = list[int] | dict[Scalar, int]
"""How many elements have which norm: over ℤ by multiples of a step, elsewhere by the norms."""


class Residue(Protocol):
    """A residue modulo a prime, or a sum or product of some, which a place reduces by its modulus."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __mod__(self, modulus: Self, /) -> Self: ...


class TrivialClassGroup:
    """The group of the ideal classes of a base whose ideals all have generators as wanted."""

    order = 1
    invariants: tuple[int, ...] = ()

    def class_of(self, ideal: object) -> tuple[int, ...]:
        """Return the one class."""
        return ()
