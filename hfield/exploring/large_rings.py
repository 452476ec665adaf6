"""List elements with a property over a finite ring too large for tables."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from random import Random
from typing import TYPE_CHECKING, Any

from hfield.algebra import structure
from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.product import Coordinates, Scalar, norm
from hfield.errors import TooLargeError
from hfield.exploring.infinite_fields import sample
from hfield.exploring.properties import Condition, has_property
from hfield.fields.base.ring import Ring

if TYPE_CHECKING:
    from hfield.exploring.elements import Elements

MAX_TRIALS = 10_000
"""So many random elements are tried for one of a sample."""


def solutions(algebra: Parent, condition: Condition) -> Iterator[Quaternion]:
    """Yield the elements with a property in the order of ``A.elements()``, over a large ring or a field."""
    ring = algebra.ring
    name, value = condition
    if ring.is_field and name in ("zero divisors", "nilpotents", "idempotents", "norm"):
        n = value if name == "norm" else ring.zero
        traces = {"nilpotents": ring.zero, "idempotents": ring.one}
        found = _of_norm(algebra, n, traces.get(name))
        if name == "idempotents":
            scalars = [(x, ring.zero, ring.zero, ring.zero) for x in (ring.zero, ring.one)]
            found = heapq.merge(scalars, found, key=_order(algebra))
    elif ring.is_field and name == "trace":
        found = (
            (w, x, y, z)
            for w, x in _of_trace(algebra, value)
            for y in ring.elements()
            for z in ring.elements()
        )
    elif name == "units":
        found = _units(algebra)
    else:
        return (q for q in algebra.elements() if has_property(q, condition))
    return (Quaternion(algebra, q) for q in found)


def _order(algebra: Parent) -> Callable[[Coordinates], tuple[int, ...]]:
    label = _label(algebra.ring)
    return lambda q: tuple(map(label, q))


def _label(ring: Ring) -> Callable[[Scalar], int]:
    """Return the function that numbers the elements in order."""
    label: Callable[[Scalar], Any] = getattr(ring, "label", ring.key)
    return label


def _of_trace(algebra: Parent, s: Scalar) -> Iterator[tuple[Scalar, Scalar]]:
    """Yield the pairs (w, x) with ``2w + t·x = s`` over a finite field, in order."""
    ring, t = algebra.ring, algebra.constants.t
    two = ring(2)
    if not ring.is_zero(t):
        yield from ((w, ring.divide(s - two * w, t)) for w in ring.elements())
    elif not ring.is_zero(two):
        w = ring.divide(s, two)
        yield from ((w, x) for x in ring.elements())
    elif ring.is_zero(s):
        yield from ((w, x) for w in ring.elements() for x in ring.elements())


def _forms(algebra: Parent) -> tuple[_BinaryForm, _BinaryForm]:
    """Return the forms of (w, x) and of (y, z), whose sum is the norm."""
    ring, c = algebra.ring, algebra.constants
    o = ring.zero
    first = _binary(ring, lambda w, x: norm(c, (w, x, o, o)))
    return first, _binary(ring, lambda y, z: norm(c, (o, o, y, z)))


def _units(algebra: Parent) -> Iterator[Coordinates]:
    """Yield the units; if the norm depends only on (w, x) or on w, the other coordinates are not tested."""
    ring = algebra.ring
    first, second = _forms(algebra)
    for w in ring.elements():
        if second.is_zero and first.is_square_of_first and not ring.is_unit(first.value(w, w)):
            continue
        for x in ring.elements():
            v = first.value(w, x)
            if second.is_zero and not ring.is_unit(v):
                continue
            for y, z in _all_pairs(ring):
                if ring.is_unit(v + second.value(y, z)):
                    yield w, x, y, z


def _of_norm(algebra: Parent, n: Scalar, s: Scalar | None) -> Iterator[Coordinates]:
    """Yield the elements of norm n, and if s is given of trace s, over a finite field.

    The norm is a binary form of (w, x) plus a binary form of (y, z). Ranges without solutions are skipped.
    """
    ring, c = algebra.ring, algebra.constants
    if s is None and structure.count(ring, c, "norm", n).value == 0:
        return
    first, second = _forms(algebra)
    pairs: Iterable[tuple[Scalar, Scalar]]
    if s is not None:
        pairs = _of_trace(algebra, s)
    elif second.is_zero:
        pairs = first.solutions(n)
    else:
        pairs = _all_pairs(ring)
    without = None  # a w for which there is no solution, whatever x is
    for w, x in pairs:
        if without is not None and ring.equal(w, without):
            continue
        found = False
        for y, z in second.solutions(n - first.value(w, x)):
            found = True
            yield w, x, y, z
        if s is None and not found and first.is_square_of_first:
            # the x that are left have the same value
            without = w


def _all_pairs(ring: Ring) -> Iterator[tuple[Scalar, Scalar]]:
    return ((y, z) for y in ring.elements() for z in ring.elements())


@dataclass(frozen=True)
class _BinaryForm:
    """A binary quadratic form ``α·y² + β·yz + γ·z²`` over a finite field."""

    ring: Ring
    coefficients: tuple[Scalar, Scalar, Scalar]

    @property
    def is_zero(self) -> bool:
        """Whether all coefficients are 0."""
        return all(map(self.ring.is_zero, self.coefficients))

    @property
    def is_square_of_first(self) -> bool:
        """Whether the form is ``α·y²``."""
        return all(map(self.ring.is_zero, self.coefficients[1:]))

    def value(self, y: Scalar, z: Scalar) -> Scalar:
        """Return the value."""
        a, b, c = self.coefficients
        return a * y * y + b * y * z + c * z * z

    def solutions(self, v: Scalar) -> Iterator[tuple[Scalar, Scalar]]:
        """Yield the pairs with the value v, in order."""
        ring = self.ring
        a, b, c = self.coefficients
        zero = ring.is_zero(v)
        if self.is_square_of_first:
            if ring.is_zero(a):
                yield from _all_pairs(ring) if zero else ()
                return
            yield from ((y, z) for y in self._roots([-v, ring.zero, a]) for z in ring.elements())
            return
        if self._is_line and not zero:
            represented = a if not ring.is_zero(a) else c
            if ring.sqrt(v * represented) is None:
                return
        for y in ring.elements():
            yield from ((y, z) for z in self._roots([a * y * y - v, b * y, c]))
            if zero and not ring.is_zero(y) and not self._roots([a, b, c]):
                return  # only 0 has the value 0

    @property
    def _is_line(self) -> bool:
        """Whether the form is a multiple of the square of a linear form, in odd characteristic."""
        a, b, c = self.coefficients
        return self.ring.characteristic != 2 and self.ring.is_zero(b * b - self.ring(4) * a * c)

    def _roots(self, coefficients: list[Scalar]) -> list[Scalar]:
        """Return the roots of a polynomial in order; for the zero polynomial, all elements of the field."""
        ring = self.ring
        while coefficients and ring.is_zero(coefficients[-1]):
            coefficients = coefficients[:-1]
        if not coefficients:
            return list(ring.elements())
        return sorted(ring.roots(coefficients), key=_label(ring)) if len(coefficients) > 1 else []


def _binary(ring: Ring, form: Callable[[Scalar, Scalar], Scalar]) -> _BinaryForm:
    """Return the coefficients of a binary form given as a function."""
    o, e = ring.zero, ring.one
    a, c = form(e, o), form(o, e)
    return _BinaryForm(ring, (a, form(e, e) - a - c, c))


def drawn(elements: Elements, n: int, rng: Random) -> tuple[Quaternion, ...]:
    """Return n distinct random elements, found by trial or by the construction for infinite fields.

    Raises :class:`TooLargeError` if the trials find too few.
    """
    algebra = elements.algebra
    if algebra.ring.is_field:
        return sample(
            algebra, elements.property, min(n, elements.cardinality()), rng.randrange(2**30)
        )
    found: dict[Quaternion, None] = {}
    for _ in range(MAX_TRIALS * max(n, 1)):
        if len(found) == min(n, elements.cardinality()):
            return tuple(found)
        q = algebra.random_element(rng.randrange(2**30))
        if q in elements:
            found[q] = None
    raise TooLargeError(
        f"among {MAX_TRIALS} random elements of {algebra} too few are {elements.title}: iterate instead"
    )
