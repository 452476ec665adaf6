"""The lattice by which a right ideal class is known.

Of all ``x⁻¹·I``, for the x of least norm in I, it is the one whose Hermite form comes first. Equivalent
ideals have the same such lattices, and the lattice lies in the class; as many of these x as the left order
has units give the same lattice.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from flint import fmpz_mat

from hfield.lattices import enumeration, hermite

if TYPE_CHECKING:
    from hfield.lattices.lattice import Lattice

Key = tuple[int, ...]


def key_and_units(lattice: Lattice) -> tuple[Key, int]:
    """Return the lattice of a right ideal class as a key, and how many units the left order has."""
    r = lattice._regular
    rows, gram = lattice._reduced
    least = min(gram[n][n] for n in range(4))
    short: list[tuple[int, ...]] = []
    for x, value in enumeration.short_vectors(gram, least):
        if value < least:
            short, least = [], value
        if value == least:
            short.append(x)
    # N(x) = least/2·norm, and x is over the denominator of the lattice
    bars = fmpz_mat(short) * rows * r.conjugation
    norm = lattice._norm
    up = 2 * norm.denominator
    den = lattice._den * lattice._den * r.conjugate_scale * r.scale * norm.numerator * least
    keys: Counter[Key] = Counter()
    for bar in hermite.tuples(bars):
        found = hermite.hermite(den, lattice._matrix * (r.left_matrix(bar) * up))
        assert found is not None
        d, m = found
        keys[(d, *map(int, m.entries()))] += 1
    key = min(keys)
    return key, 2 * keys[key]
