"""The roots of a polynomial over a quaternion algebra: spheres, isolated roots, families and scalars.

S(t, n) = {q : q² = t·q − n} consists of all elements of trace t and norm n outside F, and the scalars r and s
if x² − t·x + n = (x − r)·(x − s). Roots outside F are counted by trace and norm, those in F one by one.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Quaternion
from hfield.algebra.structure.counting.formulas_finite import count_trace_and_norm
from hfield.algebra.structure.elements.trace_and_norm import all_elements_of
from hfield.core.product import Scalar
from hfield.errors import NotFiniteError, TooLargeError
from hfield.fields.quadratic_forms import split
from hfield.polynomials.singular_polynomials import Matrix, count_other_roots, other_roots

if TYPE_CHECKING:
    from hfield.fields.quadratic_forms.isomorphisms.splitting import CoordinateSplitting
    from hfield.polynomials.polynomial import Polynomial

MAX_LISTED_ROOTS = 1_000_000
MAX_LISTED_ELEMENTS = 100_000  # of an algebra neither simple nor a field modulo its radical

Spheres = tuple[tuple[Scalar, Scalar], ...]


@dataclass(frozen=True)
class Family(ABC):
    """An infinite or multiple set of roots, of trace t and norm n; if t and n are None, of several traces and
    norms.
    """

    t: Scalar | None
    n: Scalar | None
    example: Quaternion
    polynomial: Polynomial = field(repr=False)

    @abstractmethod
    def contains(self, q: Quaternion) -> bool:
        """Return whether an element is one of these roots."""

    @abstractmethod
    def elements(self) -> Iterator[Quaternion]:
        """Yield the roots of this family, over a finite field."""

    @abstractmethod
    def count(self) -> int:
        """Return the number of roots. Raises :class:`NotFiniteError` if it is infinite."""


@dataclass(frozen=True)
class AffineFamily(Family):
    """The roots of one trace and norm (not of a sphere): several points, each plus the span of directions."""

    points: tuple[Quaternion, ...] = field(repr=False)
    directions: tuple[Quaternion, ...] = field(repr=False)

    def contains(self, q: Quaternion) -> bool:
        """Return whether an element has this trace and norm and is a root."""
        F = q.algebra.ring
        return F.equal(q.trace(), self.t) and F.equal(q.norm(), self.n) and not self.polynomial(q)

    def elements(self) -> Iterator[Quaternion]:
        """Yield the roots over a finite field, or if there are no directions."""
        F = self.example.algebra.ring
        scalars = list(F.elements()) if self.directions else []
        for q in self.points:
            for factors in product(scalars, repeat=len(self.directions)):
                yield sum((v * s for v, s in zip(self.directions, factors, strict=True)), q)

    def count(self) -> int:
        """Return the number of roots: the number of points times the number of combinations of directions."""
        order = self.example.algebra.ring.order
        if self.directions and order is None:
            raise _infinite(self.polynomial)
        span: int = int(order or 1) ** len(self.directions)
        return len(self.points) * span


@dataclass(frozen=True)
class SingularFamily(Family):
    """All roots outside the spheres of a polynomial of norm 0."""

    spheres: Spheres = field(repr=False)

    def contains(self, q: Quaternion) -> bool:
        """Return whether an element is a root that lies on no sphere."""
        F = q.algebra.ring
        on_sphere = any(F.equal(q.trace(), t) and F.equal(q.norm(), n) for t, n in self.spheres)
        return not on_sphere and not self.polynomial(q)

    def elements(self) -> Iterator[Quaternion]:
        """Yield the roots over a finite field, trace by trace, or element by element."""
        A = self.example.algebra
        found = matrices_of(self.polynomial)
        if found is None:
            yield from (q for q in A.elements() if self.contains(q))
            return
        matrices, coefficients = found
        for m in other_roots(A.ring, coefficients, self.spheres):
            yield A(*matrices.from_matrix(m))

    def count(self) -> int:
        """Return the number of roots. Raises :class:`TooLargeError` over a large finite field."""
        F = self.example.algebra.ring
        if F.order is None:
            raise _infinite(self.polynomial)
        found = matrices_of(self.polynomial)
        return sum(1 for _ in self.elements()) if found is None else count_other_roots(F, found[1])


def matrices_of(f: Polynomial) -> tuple[CoordinateSplitting, list[Matrix]] | None:
    """Return a splitting of the algebra and the coefficients as matrices; None if the algebra is
    not simple.
    """
    A = f.parent.algebra
    if not A.is_central_simple():
        return None
    matrices = split(A.ring, A.constants)
    assert matrices is not None, "the norm form of a division algebra has no zeros over F(x) either"
    return matrices, [matrices.to_matrix(c.coordinates) for c in f.coefficients]


def _infinite(f: Polynomial) -> NotFiniteError:
    A = f.parent.algebra
    return NotFiniteError(
        f"{f} has infinitely many roots in {A}, which cannot be listed: spheres, isolated, families and "
        "scalars describe them"
    )


@dataclass(frozen=True)
class Roots:
    """All roots: ``spheres`` (t, n) of all q with q² = t·q − n, ``isolated`` roots, and other
    ``families``.

    ``scalars`` are all roots in the base field, whether or not they are also in other lists.
    """

    spheres: Spheres
    isolated: tuple[Quaternion, ...]
    families: tuple[Family, ...]
    scalars: tuple[Quaternion, ...]
    polynomial: Polynomial = field(repr=False)

    def __bool__(self) -> bool:
        """Return whether there is a root."""
        return bool(self.spheres or self.isolated or self.families)

    def count(self) -> int:
        """Return the number of roots.

        Raises :class:`NotFiniteError` if there are infinitely many, which never happens over a finite field,
        and :class:`TooLargeError` for a polynomial of norm 0 over a large finite field.

        >>> from hfield import H
        >>> H("GF(7)").polynomials()("x^2 - 1").roots().count()
        58
        """
        total = len(self.scalars) + sum(self._sphere_size(t, n) for t, n in self.spheres)
        total += sum(bool(q.vector_part) for q in self.isolated)
        return total + sum(m.count() - sum(map(m.contains, self.scalars)) for m in self.families)

    def elements(self) -> Iterator[Quaternion]:
        """Yield all roots without repetition, those in the base field first.

        Raises :class:`NotFiniteError` as :meth:`count` does, and :class:`TooLargeError` for more than
        ``MAX_LISTED_ROOTS``.
        """
        number = self.count()
        if number > MAX_LISTED_ROOTS:
            raise TooLargeError(
                f"{number} roots are too many to be listed: at most {MAX_LISTED_ROOTS} are"
            )
        return self._elements()

    def _elements(self) -> Iterator[Quaternion]:
        A = self.polynomial.parent.algebra
        yield from self.scalars
        yield from (q for q in self.isolated if q.vector_part)
        for t, n in self.spheres:
            on_sphere = (A(*q) for q in all_elements_of(A.ring, A.constants, t, n))
            yield from (q for q in on_sphere if q.vector_part)
        for m in self.families:
            yield from (q for q in m.elements() if q.vector_part)

    def _sphere_size(self, t: Scalar, n: Scalar) -> int:
        """Count the elements of trace t and norm n outside F."""
        A = self.polynomial.parent.algebra
        F, c = A.ring, A.constants
        if F.order is None:
            raise _infinite(self.polynomial)
        scalars = F.roots([n, -t, F.one])
        own = sum(F.equal(r + r, t) and F.equal(r * r, n) for r in scalars)
        return count_trace_and_norm(F, c, t, n) - own
