"""Base rings: ``ring("GF(9)")`` from text, or by name; the protocol they satisfy is :class:`Ring`.

Elements are raw values of the library behind the ring (see ``docs/rings.md``). Importing this module
imports neither sympy nor galois nor numpy; a ring imports them when it first needs them.
"""

import re
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
    if apart := re.search(r"\d\s+\d|[(\[].*[^\W\d_]\s+[^\W\d_]", spec):
        raise RingError(f"{shorten(apart[0])!r} has a blank inside a number or a word")
    return _ring("".join(spec.split()))


def ring_of_data(data: object) -> Ring:
    """Return the ring of the data of a certificate, as ``ring.data`` gives them.

    Raises :class:`hfield.certificates.rejection.Rejected` for data of none that the checker knows.
    """
    from hfield.certificates.scalars.fields import read_ring

    return ring(read_ring(data).name)


@lru_cache(maxsize=1024)
def _ring(spec: str) -> Ring:
    from hfield.rings.specs import build

    made = build(spec)
    canonical = "".join(made.name.split())
    return made if canonical == spec else _ring(canonical)
