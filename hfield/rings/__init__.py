"""Base rings: ``ring("GF(9)")`` from text, or by name; the protocol they satisfy is :class:`Ring`.

Elements are raw values of the library behind the ring (see ``docs/rings.md``). Importing this module
imports neither sympy nor galois nor numpy; a ring imports them when it first needs them.
"""

from functools import lru_cache

from hfield.errors import RingError, shorten
from hfield.rings.algebraic import CC, RR
from hfield.rings.base import INFINITY, Known, Ring
from hfield.rings.field_specs import GF
from hfield.rings.floats import RDF
from hfield.rings.integers import QQ, ZZ, Zmod

__all__ = ["CC", "GF", "INFINITY", "QQ", "RDF", "RR", "ZZ", "Known", "Ring", "Zmod", "ring"]


def ring(spec: Ring | str) -> Ring:
    """Return the ring that a text names; a ring is returned as it is.

    Raises :class:`RingError` for anything else.

    >>> ring("GF(2^8)")
    GF(256)
    """
    if isinstance(spec, Ring):
        return spec
    if not isinstance(spec, str):
        raise RingError(
            f"{shorten(repr(spec))} is not the name of a ring; expected a text such as 'GF(9)'"
        )
    return _ring("".join(spec.split()))


@lru_cache(maxsize=1024)
def _ring(spec: str) -> Ring:
    from hfield.rings.specs import build

    made = build(spec)
    canonical = "".join(made.name.split())
    return made if canonical == spec else _ring(canonical)
