"""What an algebra is: functions of a ring, of its constants (a, t, b) and of coordinates.

Nothing here knows the classes of algebras and elements, which hand over to these functions. The names
below are what others use; ``docs/structure.md`` says which module decides what, and how.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from hfield.structure.clifford import maximal_basis
    from hfield.structure.commutators import centre, is_commutative
    from hfield.structure.counts import count, has_formulas
    from hfield.structure.elements import (
        characteristic_polynomial,
        conjugator,
        is_idempotent,
        is_nilpotent,
        is_unit,
    )
    from hfield.structure.evidence import ZeroNorm
    from hfield.structure.exhaust import confirm, tally
    from hfield.structure.hilbert import from_ramification_q
    from hfield.structure.hurwitz import four_squares
    from hfield.structure.invariants import derivations, is_central_simple, radical, to_opposite
    from hfield.structure.isomorphic import is_isomorphic, isomorphism, same_parent
    from hfield.structure.ramification import (
        hilbert_symbol,
        place,
        places,
        ramified_places,
        reduced_discriminant,
    )
    from hfield.structure.reasons import norm_evidence
    from hfield.structure.roots import quadric, square_roots
    from hfield.structure.splitting import division_or_splitting, split
    from hfield.structure.torsion import multiplicative_order
    from hfield.structure.zero import is_division, zero_norm

# Where the names live. Each is imported on first use, so that asking for a centre loads no conics.
_HOMES = {
    "clifford": ["maximal_basis"],
    "commutators": ["centre", "is_commutative"],
    "counts": ["count", "has_formulas"],
    "elements": [
        "characteristic_polynomial",
        "conjugator",
        "is_idempotent",
        "is_nilpotent",
        "is_unit",
    ],
    "evidence": ["ZeroNorm"],
    "exhaust": ["confirm", "tally"],
    "hilbert": ["from_ramification_q"],
    "hurwitz": ["four_squares"],
    "invariants": ["derivations", "is_central_simple", "radical", "to_opposite"],
    "isomorphic": ["is_isomorphic", "isomorphism", "same_parent"],
    "ramification": [
        "hilbert_symbol",
        "place",
        "places",
        "ramified_places",
        "reduced_discriminant",
    ],
    "reasons": ["norm_evidence"],
    "roots": ["quadric", "square_roots"],
    "splitting": ["division_or_splitting", "split"],
    "torsion": ["multiplicative_order"],
    "zero": ["is_division", "zero_norm"],
}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names}

__all__ = [
    "ZeroNorm",
    "centre",
    "characteristic_polynomial",
    "confirm",
    "conjugator",
    "count",
    "derivations",
    "division_or_splitting",
    "four_squares",
    "from_ramification_q",
    "has_formulas",
    "hilbert_symbol",
    "is_central_simple",
    "is_commutative",
    "is_division",
    "is_idempotent",
    "is_isomorphic",
    "is_nilpotent",
    "is_unit",
    "isomorphism",
    "maximal_basis",
    "multiplicative_order",
    "norm_evidence",
    "place",
    "places",
    "quadric",
    "radical",
    "ramified_places",
    "reduced_discriminant",
    "same_parent",
    "split",
    "square_roots",
    "tally",
    "to_opposite",
    "zero_norm",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value
