"""The result of a search for elements of norm 0: an element, or the reason why there is none."""

from collections.abc import Iterable
from dataclasses import dataclass

from hfield.core.product import Constants, Coordinates, Scalar, conjugate, multiply
from hfield.fields.base.ring import Ring
from hfield.verdicts import Verdict

CONIC = "ramified nowhere, so the conic has a point (Hasse and Minkowski), and this is one"


@dataclass(frozen=True, eq=False, repr=False)
class ZeroNorm(Verdict[Coordinates]):
    """Whether there is a nonzero element of norm 0.

    ``element`` contains its four coordinates, verified by multiplication, or is None. ``method`` is a word or
    two for programs (``"squares"``, ``"ordering"``, ``"ramified places"``), ``reason`` a sentence for people,
    ``places`` the ramified places if they were computed, and ``assumes`` the theorems that the reason cites
    and that are not proved again here.
    """

    method: str = ""
    places: tuple[object, ...] = ()
    assumes: tuple[str, ...] = ()


def found(ring: Ring, c: Constants, q: Iterable[Scalar], method: str, reason: str) -> ZeroNorm:
    """Return the answer with a zero-norm element, after checking that q ≠ 0 and q·conj(q) = 0."""
    w, x, y, z = q
    element = (w, x, y, z)
    if all(ring.vanishes(u) for u in element):
        raise AssertionError("the element found is 0, which proves nothing")
    if not all(ring.vanishes(u) for u in multiply(c, element, conjugate(c, element))):
        raise AssertionError("the element found does not have norm 0")
    return ZeroNorm(True, reason, element, method=method)


def none(method: str, reason: str, places: tuple[object, ...] = (), *assumes: str) -> ZeroNorm:
    """Return the answer that only 0 has norm 0, with its proof."""
    return ZeroNorm(False, reason, method=method, places=places, assumes=assumes)
