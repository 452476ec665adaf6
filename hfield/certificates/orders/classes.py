"""A set of ideal classes: that no two are the same, and that none is missing.

With a right ideal I go the lattices x⁻¹·I, for the x of least norm in I: they lie in its class, those of
c·I are the same, and each belongs to as many x as the left order of I has units.
"""

from fractions import Fraction

from hfield.certificates.orders.algebra import Row, times
from hfield.certificates.orders.enumeration import short_vectors
from hfield.certificates.orders.lattice import Key, Lattice, hermite, reduced
from hfield.certificates.orders.local_types import mass, need_locally_principal
from hfield.certificates.rejection import reject
from hfield.certificates.work import charge


def need_class_set(order: Lattice, ideals: list[Lattice]) -> None:
    """Reject unless these right ideals of an order represent every class once."""
    seen: dict[Key, int] = {}
    total = Fraction(0)
    for number, ideal in enumerate(ideals):
        if not ideal.products_lie_in(order, ideal):
            reject(f"lattice {number} is no right ideal of the order")
        need_locally_principal(ideal, order)
        least = least_vectors(ideal)
        keys = {divided(ideal, x) for x in least}
        for key in keys:
            if seen.setdefault(key, number) != number:
                reject(f"the ideals {seen[key]} and {number} are in one class")
        total += Fraction(len(keys), len(least))  # 1/[units : ±1]: one of ±x is in the list
    if total != mass(order):
        reject("these classes do not have the mass of all classes")


def least_vectors(lattice: Lattice) -> list[Row]:
    """Return the elements of least norm, one of ±x, as rows over the denominator of the lattice."""
    bound = min(lattice.gram[n][n] for n in range(4))
    found: list[Row] = []
    for x, value in short_vectors(lattice.gram, bound):
        if value < bound:
            found, bound = [], value
        if value == bound:
            found.append(x)
    return times(found, lattice.rows)


def divided(ideal: Lattice, x: Row) -> Key:
    """Return x⁻¹·I for an element x of I."""
    algebra = ideal.algebra
    charge(100 + ideal.bits**2 // 5_000)
    (image,) = times([x], algebra.form)
    value = sum(u * v for u, v in zip(image, x, strict=True))  # 2·N(x)·scale·den²
    rows = times(ideal.rows, algebra.left(algebra.conjugate(x)))
    return reduced(algebra.scale * value, hermite([[2 * y for y in row] for row in rows]))
