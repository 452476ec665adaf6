"""The quotient of an algebra over a field by a two-sided ideal, as an algebra given by a table."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.algebra.structure_algebra import AlgebraElement, StructureAlgebra
from hfield.core.product import Scalar
from hfield.errors import CoercionError, RingError
from hfield.exploring.submodules import Submodule, products
from hfield.fields.linear_algebra.echelon import echelon


class AlgebraQuotient(NamedTuple):
    """The quotient of an algebra, and the homomorphism onto it: ``algebra, projection``."""

    algebra: StructureAlgebra
    projection: Projection


class Projection:
    """The homomorphism of an algebra onto its quotient by a two-sided ideal, the ``kernel``; call it.

    >>> from hfield import H
    >>> A = H("GF(2)"); B, phi = A.quotient(A.radical())
    >>> phi(A.i), phi(A.i + A.j), phi.lift(B.one), phi.kernel.dimension
    (e, 0, 1, 3)
    """

    def __init__(self, source: Parent, kernel: Submodule) -> None:
        self.source, self.kernel = source, kernel
        # Modulo the ideal some basis vectors are combinations of those before them, and the others are
        # kept: the echelon form is that of the coordinates in reverse. So 1 is always kept.
        rows, pivots = echelon(source.ring, [list(reversed(q.coordinates)) for q in kernel.basis])
        self._relations = {3 - n: list(reversed(row)) for n, row in zip(pivots, rows, strict=True)}
        self._kept = [n for n in range(4) if n not in self._relations]
        basis = [source.basis[n] for n in self._kept]
        table = [[self._coordinates(p * q) for q in basis] for p in basis]
        self.target = StructureAlgebra(source.ring, table, ["eijk"[n] for n in self._kept])

    def _coordinates(self, q: Quaternion) -> list[Scalar]:
        rest = list(q.coordinates)
        for n, row in self._relations.items():
            factor = rest[n]
            rest = [x - factor * y for x, y in zip(rest, row, strict=True)]
        return [rest[n] for n in self._kept]

    def __call__(self, q: object) -> AlgebraElement:
        """Return the image of q, an element of the source or what the source reads as one."""
        return self.target(self._coordinates(self.source(q)))

    def lift(self, x: object) -> Quaternion:
        """Return the element with image x that is a combination of the basis vectors kept in the quotient."""
        coordinates = [self.source.ring.zero] * 4
        for n, c in zip(self._kept, self.target(x).coordinates, strict=True):
            coordinates[n] = c
        return self.source(*coordinates)

    def __repr__(self) -> str:
        images = ", ".join(
            f"{x} ↦ {self(q)!r}" for x, q in zip("eijk", self.source.basis, strict=True)
        )
        return f"{self.source} → its quotient by {self.kernel.span_text}: {images}"


def quotient(algebra: Parent, elements: Iterable[object]) -> AlgebraQuotient:
    """Return the quotient by the two-sided ideal that elements generate, over a field.

    Raises :class:`RingError` over a ring that is not a field, :class:`CoercionError` where the quotient is 0.
    """
    ring = algebra.ring
    if not ring.is_field:
        raise RingError(
            f"quotients are algebras with a basis over a field, and {ring} is none: write "
            "A.change_ring('GF(p)') for a residue field first"
        )
    generators = [algebra(x) for x in elements]
    basis = algebra.basis
    kernel = Submodule(algebra, products(products(basis, generators), basis))
    if algebra.one in kernel:
        raise CoercionError(
            f"the two-sided ideal that {', '.join(map(repr, generators))} generate is all of {algebra}: "
            "the quotient is 0"
        )
    projection = Projection(algebra, kernel)
    return AlgebraQuotient(projection.target, projection)
