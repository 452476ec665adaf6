"""The names of rings, read: ``QQ``, ``ZZ/6``, ``GF(9, x^2+1)``, ``QQ(sqrt(-7))``, ``GF(4)(t)``."""

from functools import lru_cache

from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars import (
    completions,
    finite,
    floats,
    functions,
    multiquadratic,
    number_fields,
    polynomials,
    quadratic,
    rationals,
    surds,
)
from hfield.certificates.scalars.names import without_blanks
from hfield.certificates.scalars.ring import Ring

MAX_NAME = 4_000
# One module a kind: its ``read`` returns the ring of a name, or None; the first that knows it is asked.
KINDS = (
    completions,
    rationals,
    floats,
    surds,
    finite,
    quadratic,
    multiquadratic,
    number_fields,
    functions,
    polynomials,
)


@lru_cache(maxsize=64)
def read_field(text: str) -> Ring:
    """Return the ring of that name."""
    if len(text) > MAX_NAME:
        reject(f"the name of a ring has {len(text)} characters; at most {MAX_NAME} are read")
    name = without_blanks(text)
    for kind in KINDS:
        found: Ring | None = kind.read(name, read_field)
        if found is not None:
            return found
    reject(f"there is no ring {shown(name)!r}")
