"""Subspaces of an algebra over a field, by reduced echelon forms of their bases."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import HFieldError, NotFiniteError, RingError
from hfield.structure.linear_algebra.echelon import echelon

Row = list[Any]


class Subspace:
    """A subspace: ``in``, ``<=`` for inclusion, ``==``."""

    def __init__(self, algebra: Parent, elements: Iterable[Quaternion]) -> None:
        self.algebra = algebra
        self._rows, self._pivots = echelon(algebra.ring, [list(q.coordinates) for q in elements])

    @property
    def dimension(self) -> int:
        """The dimension over the field."""
        return len(self._rows)

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """The basis in reduced echelon form."""
        return tuple(self.algebra(*row) for row in self._rows)

    @cached_property
    def key(self) -> tuple[Any, ...]:
        """A hashable value, the same for equal subspaces."""
        return tuple(self.algebra.ring.key(x) for row in self._rows for x in row)

    def __contains__(self, x: object) -> bool:
        try:
            q = self.algebra(x)
        except HFieldError:
            return False
        ring = self.algebra.ring
        rest = list(q.coordinates)
        for row, pivot in zip(self._rows, self._pivots, strict=True):
            factor = rest[pivot]
            rest = [u - factor * v for u, v in zip(rest, row, strict=True)]
        return all(map(ring.is_zero, rest))

    def __le__(self, other: Subspace) -> bool:
        return self.algebra == other.algebra and all(q in other for q in self.basis)

    def __lt__(self, other: Subspace) -> bool:
        return self <= other and self != other

    def __ge__(self, other: Subspace) -> bool:
        return other <= self

    def __gt__(self, other: Subspace) -> bool:
        return other < self

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Subspace):
            return NotImplemented
        return self.algebra == other.algebra and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)

    @property
    def span_text(self) -> str:
        """The basis as a text, ``span(1, i)``."""
        return f"span({', '.join(map(repr, self.basis))})" if self.basis else "0"


def check_finite_field(algebra: Parent, what: str) -> int:
    """Return the order of the field. Raises :class:`NotFiniteError`, :class:`RingError` over other rings."""
    if algebra.ring.order is None:
        raise NotFiniteError(
            f"{algebra} is infinite, and its {what} are not listed: expected an algebra over a finite "
            "field, such as H(GF(7))"
        )
    if not algebra.ring.is_field:
        raise RingError(
            f"{what} are listed over finite fields, and {algebra.ring} is none: ask modulo its primes"
        )
    return int(algebra.ring.order)


def products(left: Sequence[Quaternion], right: Sequence[Quaternion]) -> list[Quaternion]:
    """Return all products of elements of two lists."""
    return [x * y for x in left for y in right]
