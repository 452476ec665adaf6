"""What an algebra is: functions of a ring, of its constants (a, t, b) and of coordinates.

Nothing here knows the classes of algebras and elements, which hand over to these functions.
"""

from hfield.structure.centre import centre, is_commutative
from hfield.structure.evidence import ZeroNorm
from hfield.structure.places import hilbert_symbol
from hfield.structure.zero import is_division, zero_norm

__all__ = ["ZeroNorm", "centre", "hilbert_symbol", "is_commutative", "is_division", "zero_norm"]
