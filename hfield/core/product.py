"""Product, conjugate, norm and trace for ``i² = a + t·i``, ``j² = b``, ``ij = k``, ``ji = t·j − k``.

Everything here uses only ``+``, ``−`` and ``×`` on coordinates: no literals, no division, no branches that
depend on the ring. So the same code multiplies flint scalars, arrays of Galois field elements, polynomials in
unknown coordinates, and floats. ``(a, t, b) = (−1, 0, −1)`` gives Table 1.1 of the thesis (section 1); ``t =
1`` gives the Artin–Schreier algebras ``[a, b | F)`` of characteristic 2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, NamedTuple, Protocol, Self, TypeAlias, overload


class SupportsArithmetic(Protocol):
    """The protocol of coordinates: ``+``, ``−`` and ``×``."""

    def __add__(self, other: Self, /) -> Self:
        """Return self + other."""

    def __sub__(self, other: Self, /) -> Self:
        """Return self − other."""

    def __mul__(self, other: Self, /) -> Self:
        """Return self·other."""

    def __neg__(self) -> Self:
        """Return −self."""


class Scalar(SupportsArithmetic, Protocol):
    """An element of a ring, which also takes ints as left operands."""

    def __radd__(self, other: int, /) -> Self:
        """Return other + self."""

    def __rsub__(self, other: int, /) -> Self:
        """Return other − self."""

    def __rmul__(self, other: int, /) -> Self:
        """Return other·self."""


class IntegerMultiple(Scalar, Protocol):
    """A scalar that ints multiply from the right too."""

    def __mul__(self, other: Self | int, /) -> Self:
        """Return self·other."""


if TYPE_CHECKING:
    from typing_extensions import TypeVar

    S = TypeVar("S", bound=SupportsArithmetic)
    C = TypeVar("C", default=Any)  # scalars, or objects for them: texts, numbers of a row
else:
    from typing import TypeVar

    S, C = TypeVar("S"), TypeVar("C")

Coordinates: TypeAlias = tuple[C, C, C, C]
"""The coordinates of an element over (e, i, j, k)."""


class Constants(NamedTuple, Generic[C]):
    """The structure constants ``(a, t, b)``, in the order of ``i² = a + t·i, j² = b``."""

    a: C
    t: C
    b: C


@overload
def multiply(c: Constants[S], p: Coordinates[S], q: Coordinates[S]) -> Coordinates[S]: ...
@overload  # coordinates of another type than the constants, such as arrays and floats
def multiply(c: Constants, p: Coordinates, q: Coordinates) -> Coordinates: ...
def multiply(c: Constants[S], p: Coordinates[S], q: Coordinates[S]) -> Coordinates[S]:
    """Return the coordinates of ``p·q`` over ``(e, i, j, k)``."""
    a, t, b = c
    w1, x1, y1, z1 = p
    w2, x2, y2, z2 = q
    return (
        w1 * w2 + a * (x1 * x2) + b * (y1 * y2 + t * (y1 * z2) - a * (z1 * z2)),
        w1 * x2 + x1 * w2 + t * (x1 * x2) + b * (z1 * y2 - y1 * z2),
        w1 * y2 + y1 * w2 + t * (y1 * x2) + a * (x1 * z2 - z1 * x2),
        w1 * z2 + z1 * w2 + x1 * y2 - y1 * x2 + t * (x1 * z2),
    )


def conjugate(c: Constants, q: Coordinates[S]) -> Coordinates[S]:
    """Return the standard involution of ``q``; for ``t = 0`` the thesis's conjugate (Definition 3)."""
    w, x, y, z = q
    return (w + c.t * x, -x, -y, -z)


def norm(c: Constants, q: Coordinates[S]) -> S:
    """Return the reduced norm ``N(q)``, the scalar with ``q·conj(q) = N(q)·e`` (Definition 2)."""
    a, t, b = c
    w, x, y, z = q
    value: S = w * w + t * (w * x) - a * (x * x) - b * (y * y + t * (y * z) - a * (z * z))
    return value


def trace(c: Constants, q: Coordinates[S]) -> S:
    """Return the reduced trace, the scalar with ``q + conj(q) = tr(q)·e``."""
    w, x, _, _ = q
    value: S = w + w + c.t * x
    return value
