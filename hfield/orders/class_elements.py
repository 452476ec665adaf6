"""Find the element γ with J = γ·I, for an ideal J and the representative I of its class.

The class set recognises the class of I by the lattices y⁻¹·I for the shortest elements y of I
(:mod:`hfield.orders.class_keys`). If x⁻¹·J = y⁻¹·I for a short element x of J, then γ = x·y⁻¹. Elements
are computed up to rational factors, as integer rows.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpz, fmpz_mat

from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.class_keys import Key, Norm, Reduced, ShortElement, SublatticeKeys
from hfield.orders.classes import Classes
from hfield.orders.ideals_of_norm import two_sided_prime
from hfield.orders.lattice_values import LatticeValue, product, times_ideal

Row = list[fmpz]
Located = tuple[int, Row]
"""The number of the class of an ideal J, and γ."""


class ClassElements:
    """The elements that map class representatives to other ideals, and to themselves (``units``)."""

    def __init__(self, classes: Classes) -> None:
        self.classes, self._ambient = classes, classes.ambient
        self._known: dict[Key, tuple[int, fmpz_mat]] = {}
        """For y⁻¹·I the number of the class, and the multiplication by y⁻¹ from the right."""
        self.units: list[list[Row]] = []
        """The units of the left order of each class modulo those of the base, 1 first; some come twice."""
        self._neighbours: dict[tuple[int, Prime], list[Located]] = {}
        for n in range(len(classes)):
            around = classes.class_keys(n)
            basis = around.reduced(self._ambient.identity)
            found: dict[Key, list[ShortElement]] = {}
            for x in around.all_shortest(basis):
                found.setdefault(classes.keys.quotient(basis.rows, x), []).append(x)
            for key, elements in found.items():
                self._known[key] = n, self._divisor(elements[0])
            first, *_ = found.values()
            divisor = self._divisor(first[0])
            self.units.append([self._quotient(x, divisor) for x in first])

    def _divisor(self, y: ShortElement) -> fmpz_mat:
        return self._ambient.right_matrix(y.inverse[0])

    def _quotient(self, x: ShortElement, divisor: fmpz_mat) -> Row:
        entries: Row = (fmpz_mat([x.row]) * divisor).entries()
        return entries

    def _locate(self, around: SublatticeKeys, basis: Reduced) -> Located:
        for x in self._candidates(around, basis):
            known = self._known.get(self.classes.keys.quotient(basis.rows, x))
            if known is not None:
                return known[0], self._quotient(x, known[1])
        raise AssertionError("an ideal is in none of the classes")

    def _candidates(self, around: SublatticeKeys, basis: Reduced) -> Iterator[ShortElement]:
        yield around.shortest_of(basis)
        yield from around.all_shortest(basis)

    def neighbours(self, n: int, prime: Prime) -> list[Located]:
        """Return the ideals of relative norm P in class n."""
        if (n, prime) not in self._neighbours:
            inside = self.classes.sublattices(n, prime)
            self._neighbours[n, prime] = [self._locate(around, basis) for around, basis in inside]
        return self._neighbours[n, prime]

    def exchanged(self, n: int, prime: Prime) -> Located:
        """Return class n times the two-sided prime ideal at a prime."""
        ideal = two_sided_prime(self.classes.order, prime)
        return self._moved(product(self.classes.lattice(n), ideal), n, ideal.norm)

    def multiplied(self, n: int, ideal: BaseIdeal) -> Located:
        """Return class n times an ideal of the base."""
        return self._moved(times_ideal(self.classes.lattice(n), ideal), n, ideal * ideal)

    def _moved(self, lattice: LatticeValue, n: int, ideal: BaseIdeal) -> Located:
        return self.located(lattice, self.classes.keys.multiplied(self.classes.norms[n], ideal))

    def located(self, lattice: LatticeValue, norm: Norm) -> Located:
        """Return the class of a right ideal of this norm, and the element γ."""
        around = SublatticeKeys(self.classes.keys, lattice.matrix, lattice.den, norm)
        return self._locate(around, around.reduced(self._ambient.identity))
