"""Check that a list of right ideal classes of an order in a totally definite algebra is complete, by the
mass.

The class of a right ideal I is recognised by the lattices x⁻¹·I for the x in I with the least Tr(N(x)/νu).
These lattices lie in the class of I, and c·I has the same ones. Here the norm of I is ν·a, where ν is totally
positive and a represents a narrow ideal class; u runs through the totally positive units modulo squares
(docs/explanation/trust.md). Over ℚ the x are the elements of least norm.
"""

from collections.abc import Callable, Hashable, Iterable, Sequence
from fractions import Fraction
from math import lcm
from typing import TypeVar

from hfield.checker.number_fields.enumeration import short_vectors
from hfield.checker.number_fields.ideals import index
from hfield.checker.number_fields.matrices import Key, N, Row, hermite, inverse, reduced, times
from hfield.checker.orders.lattice import Lattice, LatticeOf
from hfield.checker.orders.polynomial_lattices import PolynomialLattice
from hfield.checker.rejection import reject
from hfield.checker.scalars.number_fields import Element as Number

K = TypeVar("K", bound=Hashable)
L = TypeVar("L", Lattice, PolynomialLattice)
X = TypeVar("X")


def need_ideal(lattice: LatticeOf[N], order: LatticeOf[N], side: str, what: str = "this") -> None:
    """Reject unless a lattice is a locally principal ideal, that is, its index is the square of its norm."""
    factors = (order, lattice) if side == "left" else (lattice, order)
    if not factors[0].products_lie_in(factors[1], lattice):
        reject(f"{what} is no {side} ideal of the order")
    if lattice.volume != order.volume * index(lattice.norm) ** 2:
        reject(f"{what} is not locally principal: its index is not the square of its norm")


def need_class_set(
    order: L,
    classes: Iterable[tuple[L, X, int]],
    divided: Callable[[L, X], tuple[set[K], int]],
    mass: Fraction,
) -> list[int]:
    """Return the numbers of units of left orders modulo those of the field; reject an incorrect list.

    The ideals must represent each class once; each comes with 1/ν and the index of its a.

    ``divided`` maps an ideal and its 1/ν to the lattices that identify its class, and to the number of units
    of its left order modulo those of the field.
    """
    seen: dict[tuple[int, K], int] = {}
    units = []
    for number, (ideal, scale, kind) in enumerate(classes):
        need_ideal(ideal, order, "right", f"the ideal {number}")
        keys, count = divided(ideal, scale)
        for key in keys:
            if seen.setdefault((kind, key), number) != number:
                reject(f"the ideals {seen[kind, key]} and {number} are in one class")
        units.append(count)
    if sum(Fraction(1, count) for count in units) != mass:
        reject("these classes do not have the mass of all classes")
    return units


def divided_by_least(
    units: Sequence[Number], ideal: Lattice, scale: Number
) -> tuple[set[Key], int]:
    """Return the lattices x⁻¹·I, and the index of the field's units in the units of the left order of I.

    The index is the number of ±x with the same x⁻¹·I and the same N(x)/νu.
    """
    found = _least(units, ideal, scale)
    return {key for key, _ in found}, sum(map(len, found.values())) // len(found)


def left_units(units: Sequence[Number], ideal: Lattice, scale: Number) -> list[Row]:
    """Return the units of the left order of I, modulo those of the field and up to rational factors.

    They are the y·x⁻¹ for the ±y that have the lattice y⁻¹·I and N(y)/νu in common with one x.
    """
    algebra = ideal.algebra
    rows = times(next(iter(_least(units, ideal, scale).values())), ideal.rows)
    ideal.pay(2)
    return times(rows, algebra.right(algebra.conjugate(rows[0])))


def _least(
    units: Sequence[Number], ideal: Lattice, scale: Number
) -> dict[tuple[Key, Row], list[Row]]:
    """Return the ±x of least value, by x⁻¹·I and N(x)/νu."""
    integers = ideal.algebra.integers
    # 1/u differs from u by a square
    parts = [integers.coordinates(integers.field.mul(scale, u)) for u in units]
    common = lcm(*(den for den, _ in parts))
    numbers = [tuple([c * (common // den) for c in row]) for den, row in parts]
    forms = [ideal.form(integers.traces(c)) for c in numbers]
    least = min(form[k][k] for form in forms for k in range(ideal.algebra.size))
    found: list[tuple[Row, Row]] = []
    for form, c in zip(forms, numbers, strict=True):
        for x, value in short_vectors(form, least):
            if value < least:
                found, least = [], value
            if value == least:
                found.append((x, c))
    images: dict[tuple[Key, Row], list[Row]] = {}
    for x, c in found:
        norm = ideal.norm_of(x)
        images.setdefault((_divided(ideal, x, norm), integers.mul(norm, c)), []).append(x)
    return images


def _divided(ideal: Lattice, x: Row, norm: Row) -> Key:
    """Return x⁻¹·I = N(x)⁻¹·conj(x)·I; x and its norm are in the format of :meth:`Lattice.norm_of`."""
    algebra = ideal.algebra
    ideal.pay(3)
    back, det = inverse(algebra.integers.matrix(norm))
    bar = algebra.conjugate(times([x], ideal.rows)[0])
    factor = algebra.blockwise(bar, [[2 * c for c in row] for row in back])
    return reduced(det * algebra.scale, hermite(times(ideal.rows, algebra.left(factor))))
