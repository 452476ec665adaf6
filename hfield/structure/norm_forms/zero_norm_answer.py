"""What a question about zero norms is answered with: an element, or the reason why there is none."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from hfield.core.product import Constants, Coordinates, Scalar, conjugate, multiply
from hfield.rings.base import Ring

CONIC = "ramified nowhere, so the conic has a point (Hasse and Minkowski), and this is one"


@dataclass(frozen=True)
class ZeroNorm:
    """Either a nonzero element of norm 0 or a proof that there is none.

    ``element`` holds its four coordinates, verified by multiplying out, or None. ``method`` is a
    word or two for programs (``"squares"``, ``"ordering"``, ``"ramified places"``), ``reason`` a sentence
    for people, ``places`` the ramified places where they were computed, and ``assumes`` the theorems that
    the reason cites and nobody re-proves here.
    """

    element: Coordinates | None
    method: str
    reason: str
    places: tuple[Any, ...] = ()
    assumes: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        """Tell whether there is a nonzero element of norm 0."""
        return self.element is not None


def found(ring: Ring, c: Constants, q: Iterable[Scalar], method: str, reason: str) -> ZeroNorm:
    """Wrap a zero-norm element after multiplying it out: q ≠ 0 and q·conj(q) = 0."""
    w, x, y, z = q
    element = (w, x, y, z)
    if all(ring.vanishes(u) for u in element):
        raise AssertionError("the element found is 0, which proves nothing")
    if not all(ring.vanishes(u) for u in multiply(c, element, conjugate(c, element))):
        raise AssertionError("the element found does not have norm 0")
    return ZeroNorm(element, method, reason)


def none(method: str, reason: str, places: tuple[object, ...] = (), *assumes: str) -> ZeroNorm:
    """Wrap a proof that only 0 has norm 0."""
    return ZeroNorm(None, method, reason, places, assumes)
