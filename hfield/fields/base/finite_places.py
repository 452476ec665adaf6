"""The protocol of places with a residue field, at which conics and norm forms are reduced."""

from __future__ import annotations

from random import Random
from typing import Any, Protocol


class FinitePlace(Protocol):
    """A place of a field with its residue field, which is a quotient of a ring of numbers or polynomials.

    Residues are added and multiplied as such, and reduced by ``% modulus``.
    """

    modulus: Any
    zero: Any
    one: Any

    @property
    def even(self) -> bool:
        """Whether the characteristic of the residue field is 2."""

    @property
    def uniformiser(self) -> Any:
        """An element of valuation 1."""

    @property
    def inverse_uniformiser(self) -> Any:
        """An element of valuation −1 that is integral at all other finite places."""

    def valuation(self, x: Any) -> int:
        """Return the order of a nonzero element."""

    def reduce(self, x: Any) -> Any:
        """Return the class of an element of valuation ≥ 0."""

    def lift(self, x: Any) -> Any:
        """Return an element with the given class."""

    def truncated(self, x: Any, n: int) -> Any:
        """Return the standard element that is x up to the n-th power of the uniformiser."""

    def over_prime_field(self) -> list[Any]:
        """Return a basis of the residue field over its prime field."""

    def random(self, rng: Random) -> Any:
        """Return a random residue."""

    def multiply(self, x: Any, y: Any) -> Any:
        """Return the product of two residues."""

    def inverse(self, x: Any) -> Any:
        """Return the inverse of a residue that is not 0."""

    def sqrt(self, x: Any) -> Any:
        """Return a square root of a residue, or None."""

    def quadratic_root(self, a: Any, b: Any, c: Any) -> tuple[Any, Any] | None:
        """Return ``(x, y)`` ≠ (0, 0) with ``a·x² + b·xy + c·y² = 0`` among the residues, or None."""
