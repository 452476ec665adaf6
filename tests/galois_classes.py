"""Classes of galois, made without the loops that galois compiles to evaluate one polynomial of each."""

from typing import Any

import galois


def galois_class(order: int, **options: Any) -> type[galois.FieldArray]:
    """Return the class for a finite field, which computes with compiled loops like any other."""
    characteristic = int(galois.factors(order)[0][0])
    below = galois.GF(characteristic, compile="python-calculate")
    found = galois.GF(order, compile="python-calculate", **options)
    for made in (below, found):
        made.compile("auto")
    return found
