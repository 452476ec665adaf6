"""Submodules of an algebra over a field or ℤ/n, by normal forms of generating rows.

Over a field a submodule is a subspace, and the rows are its basis in reduced echelon form. Over ℤ/n a
submodule is a lattice between n·ℤ⁴ and ℤ⁴, and the rows are those of its Hermite normal form that are not 0
modulo n.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from functools import cached_property
from math import prod
from typing import Any

import flint

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.factorisation import factorise
from hfield.core.properties import WithoutCaches
from hfield.errors import HFieldError, NotFiniteError, RingError
from hfield.exploring.labels import order_of_ring
from hfield.fields.base.modular import Modular
from hfield.fields.linear_algebra.echelon import echelon

Row = list[Any]  # scalars, over ℤ/n residues


class Submodule(WithoutCaches):
    """A submodule; it supports ``in``, ``<=`` for inclusion, and ``==``.

    ``basis`` is a basis over a field; over ℤ/n its elements generate the submodule.

    >>> from hfield import H
    >>> I = H("ZZ/4").two_sided_ideals()[1]; I.basis, I.dimension, I.invariants, I.cardinality()
    ((2 + 2*i + 2*j + 2*k,), 1, (2,), 2)
    """

    def __init__(self, algebra: Parent, elements: Iterable[Quaternion]) -> None:
        self.algebra = algebra
        rows = [list(q.coordinates) for q in elements]
        if isinstance(algebra.ring, Modular) and not algebra.ring.is_field:
            self._rows = _hermite_rows(algebra.ring, rows)
        else:
            self._rows, _ = echelon(algebra.ring, rows)

    @cached_property
    def _pivots(self) -> list[int]:
        zero = self.algebra.ring.is_zero
        return [next(n for n, x in enumerate(row) if not zero(x)) for row in self._rows]

    @property
    def dimension(self) -> int:
        """The dimension over a field; over ℤ/n the least number of generators."""
        return len(self._rows) if self.algebra.ring.is_field else len(self.invariants)

    @cached_property
    def invariants(self) -> tuple[int, ...]:
        """The orders of cyclic modules with this module over ℤ/n as direct sum, each divisible by the next.

        Over a finite field it is the order of the field, repeated as often as the dimension. Raises
        :class:`NotFiniteError` over an infinite field.
        """
        n = order_of_ring(self.algebra)
        if self.algebra.ring.is_field:
            return (n,) * self.dimension
        smith = _hermite(self._rows, n).snf()  # the order of ℤ⁴ modulo the lattice
        orders = [n // int(smith[k, k]) for k in range(4)]
        return tuple(d for d in orders if d > 1)

    def cardinality(self) -> int:
        """Return the number of elements. Raises :class:`NotFiniteError` over infinite fields."""
        return prod(self.invariants)

    @property
    def length(self) -> int:
        """The length of a composition series over the scalars; over a field, the dimension."""
        if self.algebra.ring.is_field:
            return self.dimension
        return sum(sum(factorise(d).values()) for d in self.invariants)

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """The basis in reduced echelon form; over ℤ/n, generators in Hermite normal form."""
        return tuple(self.algebra(*row) for row in self._rows)

    @cached_property
    def key(self) -> tuple[Hashable, ...]:
        """A hashable value, the same for equal submodules."""
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
            if not ring.is_field:
                # a pivot divides n
                quotient, left = divmod(int(factor), int(row[pivot]))
                if left:
                    return False
                factor = ring(quotient)
            rest = [u - factor * v for u, v in zip(rest, row, strict=True)]
        return all(map(ring.is_zero, rest))

    def _lies_in(self, other: Submodule) -> bool:
        return self.algebra == other.algebra and all(q in other for q in self.basis)

    def __le__(self, other: Submodule) -> bool:
        return self._lies_in(other)

    def __lt__(self, other: Submodule) -> bool:
        return self != other and self._lies_in(other)

    def __ge__(self, other: Submodule) -> bool:
        return other._lies_in(self)

    def __gt__(self, other: Submodule) -> bool:
        return self != other and other._lies_in(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Submodule):
            return NotImplemented
        return self.algebra == other.algebra and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)

    @property
    def span_text(self) -> str:
        """The basis as a text, ``span(1, i)``."""
        return f"span({', '.join(map(repr, self.basis))})" if self.basis else "0"


def _hermite(rows: Sequence[Row], n: int) -> flint.fmpz_mat:
    """Return the Hermite normal form (four rows) of the lattice generated by rows over ℤ/n and n·ℤ⁴."""
    entries = [int(x) for row in rows for x in row]
    entries += [n * (r == c) for r in range(4) for c in range(4)]
    found = flint.fmpz_mat(len(rows) + 4, 4, entries).hnf()
    return flint.fmpz_mat(4, 4, found.entries()[:16])


def _hermite_rows(ring: Modular, rows: Sequence[Row]) -> list[Row]:
    """Return the rows of the Hermite normal form that are not 0 modulo n."""
    form = _hermite(rows, ring.modulus)
    reduced = [[ring(int(x)) for x in row] for row in form.tolist()]
    return [row for row in reduced if not all(map(ring.is_zero, row))]


def check_listed(algebra: Parent, what: str) -> int:
    """Return the order of a finite field or ℤ/n. Raises :class:`NotFiniteError`, :class:`RingError`."""
    ring = algebra.ring
    if ring.order is None:
        raise NotFiniteError(
            f"{algebra} is infinite, and its {what} are not listed: expected an algebra over a finite "
            "field, such as H(GF(7)), or over ZZ/n"
        )
    if not (ring.is_field or isinstance(ring, Modular)):
        raise RingError(f"{what} are listed over finite fields and ZZ/n, and {ring} is neither")
    return int(ring.order)


def products(left: Sequence[Quaternion], right: Sequence[Quaternion]) -> list[Quaternion]:
    """Return all products of an element of the first list and an element of the second."""
    return [x * y for x in left for y in right]
