"""What an element is: the methods of :class:`hfield.Quaternion` that hand over to ``structure``."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any, Generic, NamedTuple, Self, TypeVar

from hfield import product, structure
from hfield.embedding import embedding
from hfield.errors import CoercionError, MixedParentsError, NotFiniteError, shorten
from hfield.hints import ELEMENT, Hinted
from hfield.product import Coordinates, Scalar
from hfield.rings.base import Ring
from hfield.rings.coefficients import Coefficients

Q = TypeVar("Q")


class Conjugacy(NamedTuple):
    """Whether ``x·p·x⁻¹ = q`` is solvable: ``element`` is such an x or None, ``reason`` says why."""

    element: Any
    reason: str

    def __bool__(self) -> bool:
        """Tell whether there is one."""
        return self.element is not None


class _TooManyError(NotFiniteError, OverflowError):
    """More than ``len`` can tell: a TypeError to ``list``, which then goes on without the length."""


class SquareRoots(Generic[Q]):
    """The square roots of ``element``: ``x in roots`` asks, iteration lists those that are known.

    All are listed when they are finitely many. Over an infinite field a scalar may have a whole
    quadric of roots, the elements of trace 0 and norm −s: then ``is_finite`` is False and of these
    only one and its negative are listed.
    """

    def __init__(self, element: Any, found: Any) -> None:
        A = element.algebra
        self.element = element
        self.isolated: tuple[Q, ...] = tuple(A(*x) for x in found.isolated)
        self.quadric: Q | None = None if found.quadric is None else A(*found.quadric)

    @property
    def is_finite(self) -> bool:
        """Whether there are finitely many, and iteration lists all of them."""
        return self.quadric is None or self.element.ring.order is not None

    def __bool__(self) -> bool:
        return bool(self.isolated) or self.quadric is not None

    def __contains__(self, x: Scalar) -> bool:
        return bool(x * x == self.element)

    def __iter__(self) -> Iterator[Q]:
        yield from self.isolated
        if self.quadric is None:
            return
        if self.is_finite:
            yield from self._quadric()
        else:
            root: Any = self.quadric
            yield root
            if root != -root:
                yield -root

    def _quadric(self) -> Iterator[Q]:
        """Run through the elements of trace 0 and norm −s over a finite field."""
        A = self.element.algebra
        return (A(*x) for x in structure.quadric(A.ring, A.constants, self.element.scalar_part))

    def __len__(self) -> int:
        """Return how many there are.

        Raises :class:`NotFiniteError`, also an OverflowError, where they are infinitely many, or more than
        ``len`` can tell; ``A.count(square=s)`` tells all numbers over finite fields.
        """
        if not self.is_finite:
            raise _TooManyError(f"{shorten(self.element)} has infinitely many square roots")
        if self.quadric is None:
            return len(self.isolated)
        n: int = self.element.algebra.count(square=self.element.scalar_part)
        if n > sys.maxsize:
            raise _TooManyError(
                f"{shorten(self.element)} has {n} square roots, more than len can tell: ask "
                "A.count(square=…)"
            )
        return n

    def __repr__(self) -> str:
        shown = ", ".join(str(x) for _, x in zip(range(6), self, strict=False))
        more = "" if self.is_finite else ", … (all elements of trace 0 and this norm)"
        return f"SquareRoots({shown}{more})"


class ElementFacts(Hinted):
    """The part of a quaternion's methods that answer what it is; but for its parts, asked of single ones."""

    __slots__ = ()
    elsewhere = ELEMENT

    algebra: Any
    coordinates: Coordinates

    def _new(self, w: Any, x: Any, y: Any, z: Any) -> Self:
        raise NotImplementedError

    def _single(self) -> tuple[Any, product.Constants, Coordinates]:
        """Return the arguments that functions of ``structure`` take."""
        coordinates = self.coordinates
        if hasattr(coordinates[0], "dtype") and hasattr(coordinates[0], "ndim"):
            raise CoercionError(
                "this is asked of a single quaternion, not of an array: take one, q[n], or loop"
            )
        return self.algebra.ring, self.algebra.constants, coordinates

    # --- parts ---------------------------------------------------------------------------------

    @property
    def scalar_part(self) -> Any:
        """The coordinate of e, in the base ring (thesis 1.4.2)."""
        return self.coordinates[0]

    @property
    def vector_part(self) -> Self:
        """The element without its scalar part, ``x·i + y·j + z·k`` (thesis 1.4.2)."""
        w, x, y, z = self.coordinates
        return self._new(w - w, x, y, z)

    def matrix(self) -> tuple[tuple[Any, ...], ...]:
        """Return the 4 × 4 matrix of ``p ↦ q·p``: column n holds the coordinates of q·(basis n)."""
        columns = [(self * b).coordinates for b in self.algebra.basis]
        return tuple(zip(*columns, strict=True))

    def change_ring(self, ring: Ring | str) -> Self:
        """Return q in the algebra with the same constants over ``ring``, which must contain them."""
        A = self.algebra.change_ring(ring)
        q: Self = A(*map(embedding(self.algebra.ring, A.ring), self.coordinates))
        return q

    # --- units and zero divisors ---------------------------------------------------------------

    def is_unit(self) -> bool:
        """Tell whether q has an inverse: its norm is a unit of the base ring."""
        return structure.is_unit(*self._single())

    def is_zero_divisor(self) -> bool:
        """Tell whether q·y = 0 for some y ≠ 0. By this definition 0 is a zero divisor."""
        ring, c, q = self._single()
        return ring.annihilator(product.norm(c, q)) is not None

    def annihilator(self) -> Any:
        """Return some nonzero y with ``q·y = 0``, or None if q is not a zero divisor.

        q is one exactly when its norm is 0 or a zero divisor of the base ring: then ``conj(q)``
        times an annihilator of the norm serves, and where that vanishes, an annihilator of all of
        the coordinates of ``conj(q)``.
        """
        ring, c, q = self._single()
        s = ring.annihilator(product.norm(c, q))
        if s is None:
            return None
        y = self.algebra(*(s * x for x in product.conjugate(c, q)))
        # If s·conj(q) = 0, then s·q = 0: the scalar s itself annihilates q.
        return self.algebra.scalar(s) if y.is_zero() else y

    def _why_no_inverse(self) -> str:
        """Say why this single quaternion has no inverse."""
        ring, c, q = self._single()
        if all(map(ring.is_zero, q)):
            return f"cannot invert 0 in {self.algebra}"
        norm, y = shorten(ring.text(product.norm(c, q))), self.annihilator()
        start = f"cannot invert q = {shorten(self)} in {self.algebra}: its norm"
        if y is None:
            return f"{start} {norm} is not a unit of {ring}"
        return f"{start} is {norm}, and q·y = 0 for y = {shorten(y)}"

    def order(self) -> int | None:
        """Return the least n > 0 with ``qⁿ = 1``, or None if there is none.

        Raises :class:`NotInvertibleError` unless q is a unit, and :class:`UndecidedError` where it is not
        known: for some transcendental numbers, over infinite rings of one's own, over RDF, and where a
        factorisation is out of reach.

        >>> from hfield import H
        >>> H("RR").parse("cos(2*pi/7) + sin(2*pi/7)*k").order(), H("RR")(1, 1, 1, 1).order()
        (7, None)
        """
        return structure.multiplicative_order(*self._single())

    # --- polynomials and equations -------------------------------------------------------------

    def minimal_polynomial(self) -> Coefficients:
        """Return the coefficients, low degree first, monic: ``(−w, 1)`` or ``(N(q), −tr(q), 1)``.

        They are a tuple that shows as the polynomial, in X.

        >>> from hfield import H
        >>> H("QQ")(1, 2, 0, 1).minimal_polynomial()
        X²−2·X+6
        """
        ring, _, q = self._single()
        if all(ring.is_zero(x) for x in q[1:]):
            return Coefficients(ring, (-q[0], ring.one))
        return self.characteristic_polynomial()

    def characteristic_polynomial(self) -> Coefficients:
        """Return the reduced one, ``x² − tr(q)·x + N(q)``: its coefficients, low degree first."""
        ring, constants, q = self._single()
        return Coefficients(ring, structure.characteristic_polynomial(ring, constants, q))

    def is_nilpotent(self) -> bool:
        """Tell whether some power of q is 0."""
        return structure.is_nilpotent(*self._single())

    def is_idempotent(self) -> bool:
        """Tell whether ``q² = q``."""
        return structure.is_idempotent(*self._single())

    def square_roots(self) -> SquareRoots[Any]:
        """Return the x with ``x² = q``, verified by squaring. The base ring must be a field.

        Raises :class:`UndecidedError` where square roots of the base ring, or whether an element of
        given trace and norm exists, are not decided.

        >>> from hfield import H
        >>> list(H("QQ").parse("2*i").square_roots())
        [1 + i, −1 − i]
        """
        return SquareRoots(self, structure.square_roots(*self._single()))

    def conjugacy(self, other: Any) -> Conjugacy:
        """Return x with ``x·q·x⁻¹ = other``, or the reason why there is none, as evidence.

        Raises :class:`MixedParentsError` for elements of two algebras, and :class:`UndecidedError`
        over a ring that is not a field.
        """
        ring, c, q = self._single()
        if not isinstance(other, ElementFacts):
            other = self.algebra(other)
        if other.algebra != self.algebra:
            raise MixedParentsError(
                f"{shorten(self)} is an element of {self.algebra} and {shorten(other)} one of "
                f"{other.algebra}: only elements of one algebra can be conjugate"
            )
        found = structure.conjugator(ring, c, q, other._single()[2])
        x = None if found.element is None else self.algebra(*found.element)
        return Conjugacy(x, found.reason)

    def conjugator(self, other: object) -> Any:
        """Return a unit x with ``x·q·x⁻¹ = other``, or None; :meth:`conjugacy` tells why.

        In a central simple algebra there is one exactly when both have the same minimal polynomial
        (Skolem and Noether).
        """
        return self.conjugacy(other).element


def conjugator(p: Any, q: Any) -> Any:
    """Return a unit x with ``x·p·x⁻¹ = q``, or None; ``p.conjugacy(q)`` tells why there is none.

    >>> from hfield import H, inv
    >>> _, i, j, _ = H("QQ").basis
    >>> x = conjugator(i, j)
    >>> x * i * inv(x)
    j
    """
    return p.conjugator(q)
