"""The protocol of places with a residue field, in which conics and norm forms are reduced."""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING, Any, Protocol, Self, TypeGuard


class Residue(Protocol):
    """A residue modulo a prime, or a sum or product of residues that a place has yet to reduce."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __mod__(self, modulus: Self, /) -> Self: ...


if TYPE_CHECKING:
    from typing_extensions import TypeVar

    E = TypeVar("E", default=Any)  # ``FinitePlace`` alone: of values that nobody checks
    K = TypeVar("K", bound=Residue, default=Any)
else:
    from typing import TypeVar

    E = TypeVar("E")  # an element of the field
    K = TypeVar("K")  # a residue


class FinitePlace(Protocol[E, K]):
    """A place of a field together with its residue field, a quotient of a ring of numbers or polynomials.

    Residues are added and multiplied as elements of that ring, and reduced by ``% modulus``.
    """

    modulus: K
    zero: K
    one: K

    @property
    def even(self) -> bool:
        """Whether the characteristic of the residue field is 2."""

    @property
    def uniformiser(self) -> E:
        """An element of valuation 1."""

    @property
    def inverse_uniformiser(self) -> E:
        """An element of valuation −1 that is integral at all other finite places."""

    def valuation(self, x: E) -> int:
        """Return the valuation of a nonzero element."""

    def reduce(self, x: E) -> K:
        """Return the class of an element of valuation ≥ 0."""

    def lift(self, x: K) -> E:
        """Return an element with the given class."""

    def truncated(self, x: E, n: int) -> E:
        """Return the standard element that agrees with x modulo the n-th power of the uniformiser."""

    def over_prime_field(self) -> list[K]:
        """Return a basis of the residue field over its prime field."""

    def random(self, rng: Random) -> K:
        """Return a random residue."""

    def multiply(self, x: K, y: K) -> K:
        """Return the product of two residues."""

    def inverse(self, x: K) -> K:
        """Return the inverse of a residue that is not 0."""

    def sqrt(self, x: K) -> K | None:
        """Return a square root of a residue, or None."""

    def quadratic_root(self, a: K, b: K, c: K) -> tuple[K, K] | None:
        """Return ``(x, y)`` ≠ (0, 0) with ``a·x² + b·xy + c·y² = 0`` among the residues, or None."""


class ResiduePlace(FinitePlace[E, K], Protocol[E, K]):
    """A place above the prime number ``below``, which has the valuation ``index`` there."""

    below: int
    index: int


def is_above_prime(place: FinitePlace[E, K]) -> TypeGuard[ResiduePlace[E, K]]:
    """Return whether a place is one of a number field."""
    return hasattr(place, "below")
