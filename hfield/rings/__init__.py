"""Base rings: the protocol that they satisfy, :class:`Ring`, and those that have no theory of places.

Elements are raw values of the library behind the ring (see ``docs/rings.md``). Importing this module
imports neither sympy nor galois nor numpy; a ring imports them when it first needs them.
"""

from typing import Any

from hfield.rings.base import INFINITY, Known, Ring
from hfield.rings.checking import RingReport, check_ring
from hfield.rings.closed_fields.algebraic import CC, RR
from hfield.rings.field_specs import GF
from hfield.rings.floats import CDF, RDF
from hfield.rings.integers import QQ, ZZ, Zmod

__all__ = [
    "CC",
    "CDF",
    "GF",
    "INFINITY",
    "QQ",
    "RDF",
    "RR",
    "ZZ",
    "Known",
    "Ring",
    "RingReport",
    "Zmod",
    "check_ring",
    "ring",
]


def __getattr__(name: str) -> Any:
    """Hand out ``ring``, which reads names; it stands above, since it knows all kinds of fields."""
    if name in ("ring", "ring_of_data"):
        from hfield.fields import names

        return getattr(names, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
