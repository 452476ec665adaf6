"""Constants of the theorems with bounds for class groups and regulators of number fields."""

from fractions import Fraction

# exp(−c) of Zimmert's first corollary for the degree, by the number of complex places, rounded up.
# The two ideals of the corollary lie in a class and in the product of its inverse with the class of
# the different, which is a square (Hecke). So no subgroup of index 2, and hence no proper subgroup,
# contains all prime ideals of such norms.
_ZIMMERT = {
    3: "0.1796 0.2531",
    4: "0.05405 0.08202 0.1202",
    5: "0.01460 0.02341 0.03645",
    6: "0.003654 0.006115 0.009983 0.01588",
    7: "0.0008641 0.001496 0.002536 0.004206",
    8: "0.0001955 0.0003477 0.0006080 0.001044 0.001754",
    9: "0.00004265 0.00007765 0.0001393 0.0002458 0.0004263",
    10: "0.000009033 0.00001677 0.00003073 0.00005554 0.00009884 0.0001731",
    11: "0.000001865 0.000003522 0.000006578 0.00001212 0.00002206 0.00003958",
    12: "0.0000003772 0.0000007228 0.000001371 0.000002571 0.000004768 0.000008731 0.00001578",
}
ZIMMERT_FACTORS = {n: tuple(map(Fraction, row.split())) for n, row in _ZIMMERT.items()}
"""c, by degree and number of complex places: prime ideals of norm at most c·√|D| generate the class group."""

HERMITE_POWERS = (1, 1, Fraction(4, 3), 2, 4, 8, Fraction(64, 3), 64, 256, 1424, 5669, 24376)
"""γʳ for the rank r: a lattice of determinant d has a vector of length l ≠ 0 with l²ʳ ≤ γʳ·d².

Up to rank 8 these are exact, beyond that Blichfeldt's bounds, rounded up.
"""

_LENGTHS = (100, 162, 2280, 14783, 51972, 149783, 179184, 242819, 367642, 615069, 1126809, 2243502)


def short_length(n: int, discriminant: int) -> int:
    """Return K such that a field has a few hundred integers x with Σ|xᵥ|² ≤ K over its n embeddings.

    For this K, half of a ball has the volume of 100 fundamental domains of the ring of integers in degree 3,
    of 300 and 600 in degrees 4 and 5, and of 1000 from degree 6 on. Beyond degree 12 there are fewer.
    """
    power = _LENGTHS[min(n, len(_LENGTHS)) - 1] * abs(discriminant)
    low, high = 0, 1 << power.bit_length() // n + 1
    while high - low > 1:
        middle = (low + high) // 2
        if middle**n <= power:
            low = middle
        else:
            high = middle
    return low
