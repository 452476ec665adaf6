"""Conjugacy classes of an algebra under its units."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.algebra.structure.elements.trace_and_norm import element_of
from hfield.core.product import Constants, Scalar
from hfield.core.properties import WithoutCaches
from hfield.errors import HFieldError, TooLargeError, shorten
from hfield.exploring.labels import LabelledAlgebra, labelled, order_of_ring
from hfield.fields import quadratic_forms
from hfield.fields.base.coefficients import Coefficients
from hfield.fields.quadratic_forms.isomorphisms.splitting import CoordinateSplitting

if TYPE_CHECKING:
    import numpy as np

    from hfield.fields.base.ring import Ring

MAX_CLASSES = 200_000
"""The greatest number of classes that are listed."""


class ConjugacyClass(WithoutCaches, ABC):
    """The conjugates of ``representative`` under a group of units.

    >>> from hfield import H
    >>> for c in H("GF(3)").conjugacy_classes()[-2:]:
    ...     print(len(c), c.minimal_polynomial, c.representative in c)
    8 X²+X+1 True
    6 X²+X+2 True
    """

    def __init__(self, algebra: Parent, size: int, contains: Callable[[Quaternion], bool]) -> None:
        self.algebra, self._size, self._contains = algebra, size, contains

    @property
    @abstractmethod
    def representative(self) -> Quaternion:
        """An element of the class."""

    @cached_property
    def minimal_polynomial(self) -> Coefficients:
        """The minimal polynomial of the elements, a tuple of coefficients, low degree first."""
        return self.representative.minimal_polynomial()

    def __len__(self) -> int:
        return self._size

    def __contains__(self, x: object) -> bool:
        try:
            q = self.algebra(x)
        except HFieldError:
            return False
        return not q.is_batch and self._contains(q)

    def __iter__(self) -> Iterator[Quaternion]:
        return (q for q in self.algebra.elements() if self._contains(q))

    def __repr__(self) -> str:
        what = "element" if len(self) == 1 else "elements"
        return f"<class of {self.representative!r}: {len(self)} {what}, {self.minimal_polynomial}>"


class ListedClass(ConjugacyClass):
    """A class whose elements are listed by index, ascending."""

    def __init__(self, labels: LabelledAlgebra, numbers: np.ndarray) -> None:
        super().__init__(labels.algebra, len(numbers), self._is_listed)
        self._labels, self.numbers = labels, numbers

    def _is_listed(self, q: Quaternion) -> bool:
        import numpy as np

        number = self._labels.number(q)
        place = int(np.searchsorted(self.numbers, number))
        return place < len(self.numbers) and int(self.numbers[place]) == number

    @property
    def representative(self) -> Quaternion:
        """The first element of the class."""
        return self._labels.element(int(self.numbers[0]))

    def __iter__(self) -> Iterator[Quaternion]:
        return (self._labels.element(int(number)) for number in self.numbers)


@dataclass(frozen=True)
class QuadraticPolynomial:
    """A polynomial ``X² − t·X + n`` over a finite field, with its roots in the field."""

    t: Scalar
    n: Scalar
    roots: tuple[Scalar, ...]


class SplitClass(ConjugacyClass):
    """All elements of M₂(F) with a given characteristic polynomial; scalars are separate classes."""

    def __init__(self, algebra: Parent, polynomial: QuadraticPolynomial, scalar: bool) -> None:
        q = order_of_ring(algebra)
        sizes = {0: q * q - q, 1: q * q - 1, 2: q * q + q}
        super().__init__(algebra, 1 if scalar else sizes[len(polynomial.roots)], self._fits)
        self._polynomial, self._is_scalar = polynomial, scalar

    def _fits(self, q: Quaternion) -> bool:
        ring: Ring = self.algebra.ring
        equal = ring.equal(q.trace(), self._polynomial.t) and ring.equal(
            q.norm(), self._polynomial.n
        )
        return equal and bool(q.vector_part.is_zero()) == self._is_scalar and self._of_this_class(q)

    def _of_this_class(self, q: Quaternion) -> bool:
        return True

    @cached_property
    def representative(self) -> Quaternion:
        """An element of the class."""
        if self._is_scalar:
            return self.algebra.scalar(self._polynomial.roots[0])
        found = element_of(
            self.algebra.ring, self.algebra.constants, self._polynomial.t, self._polynomial.n
        )
        assert found is not None, "a split algebra has elements of every characteristic polynomial"
        return Quaternion(self.algebra, found)


class TransvectionClass(SplitClass):
    """Half of the elements s·u of SL₂(F), s = ±1 and u unipotent, in odd characteristic.

    ``u − 1`` is a matrix ((x, y), (z, −x)) of rank 1. Conjugation by a matrix of determinant d multiplies y,
    and −z, by d and squares.
    """

    def __init__(self, algebra: Parent, polynomial: QuadraticPolynomial, factor: Scalar) -> None:
        super().__init__(algebra, polynomial, False)
        self._size //= 2
        self._factor = factor

    @cached_property
    def representative(self) -> Quaternion:
        """An element of the class."""
        (s,) = self._polynomial.roots
        matrix = ((s, self._factor * s), (self.algebra.ring.zero, s))
        return Quaternion(self.algebra, splitting(self.algebra).from_matrix(matrix))

    def _of_this_class(self, q: Quaternion) -> bool:
        ring = self.algebra.ring
        (s,) = self._polynomial.roots
        (_, y), (z, _) = splitting(self.algebra).to_matrix(q.coordinates)
        value = s * y if not ring.is_zero(y) else ring.zero - s * z
        return ring.sqrt(value * self._factor) is not None


def splitting(algebra: Parent) -> CoordinateSplitting:
    """Return an isomorphism with M₂(F) over a finite field; always the same one for the same algebra."""
    return _splitting(algebra.ring, algebra.constants)


@lru_cache(maxsize=8)
def _splitting(ring: Ring, constants: Constants) -> CoordinateSplitting:
    found = quadratic_forms.split(ring, constants)
    assert found is not None, "over a finite field every central simple algebra splits"
    return found


def quadratics(ring: Ring, n: Scalar | None = None) -> Iterator[QuadraticPolynomial]:
    """Yield all polynomials X² − tX + n over a finite field, or only those with a given n."""
    assert ring.order is not None
    if ring.order**2 > MAX_CLASSES:
        raise TooLargeError(
            f"M2({ring}) has {shorten(ring.order**2 + ring.order)} classes, more than the {MAX_CLASSES} "
            "that are listed"
        )
    elements = list(ring.elements())
    roots: dict[Hashable, list[Scalar]] = {}
    for place, x in enumerate(elements):
        for y in elements[place:]:
            roots.setdefault((ring.key(x + y), ring.key(x * y)), [x] if y is x else [x, y])
    for t in elements:
        for norm in elements if n is None else [n]:
            yield QuadraticPolynomial(t, norm, tuple(roots.get((ring.key(t), ring.key(norm)), ())))


def split_classes(algebra: Parent, units_only: bool = False) -> tuple[ConjugacyClass, ...]:
    """Return the classes of M₂(F) under its units, scalars first."""
    ring = algebra.ring
    wanted = [f for f in quadratics(ring) if not (units_only and ring.is_zero(f.n))]
    scalars = [SplitClass(algebra, f, True) for f in wanted if len(f.roots) == 1]
    return (*scalars, *(SplitClass(algebra, f, False) for f in wanted))


def special_classes(algebra: Parent) -> tuple[ConjugacyClass, ...]:
    """Return the conjugacy classes of SL₂(F), scalars first."""
    ring = algebra.ring
    wanted = list(quadratics(ring, ring.one))
    found: list[ConjugacyClass] = [
        SplitClass(algebra, f, True) for f in wanted if len(f.roots) == 1
    ]
    for f in wanted:
        if len(f.roots) == 1 and ring.characteristic != 2:
            other = next(x for x in ring.elements() if ring.sqrt(x) is None)
            found += [TransvectionClass(algebra, f, x) for x in (ring.one, other)]
        else:
            found.append(SplitClass(algebra, f, False))
    return tuple(found)


def conjugacy_classes(
    algebra: Parent, generators: tuple[Quaternion, ...]
) -> tuple[ConjugacyClass, ...]:
    """Return the orbits of all elements under the units generated by the given ones."""
    from hfield.exploring.finite_groups import orbits

    labels = labelled(algebra)
    labels.check_size("classes are found")
    permutations = [labels.conjugation(u) for u in generators]
    return tuple(ListedClass(labels, numbers) for numbers in orbits(permutations, labels.size))
