"""The invertible right ideal classes of an order in a totally definite algebra, enumerated.

A class is known by lattices that lie in it (:mod:`hfield.orders.class_keys`), so classes are looked up and
not compared in pairs. Starting from O, neighbours at primes are taken until the mass is used up: then no
class is missing, and as all are different none comes twice (M. Kirschmer and J. Voight, *SIAM J. Comput.* 39,
2010; J. Voight, *Quaternion Algebras*, main theorem 26.1.5). Where local units do not have all norms, or
where there are several narrow classes, neighbours at one prime reach a part of the classes.

Rows of Brandt matrices are kept by primes, and continued from where the enumeration stopped.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cached_property, partial
from typing import Any

from flint import fmpz_mat

from hfield.core.progress import report, track
from hfield.errors import TooLargeError, shorten
from hfield.orders.class_keys import ClassKeys, Key, Norm, Representative, SublatticeKeys
from hfield.orders.class_number import mass
from hfield.orders.conjugators import conjugator
from hfield.orders.ideals_of_norm import two_sided_prime
from hfield.orders.invariants import good_primes, is_eichler
from hfield.orders.lattice_values import (
    LatticeValue,
    discriminant,
    hermite_form,
    order_of,
    product,
    times_ideal,
)
from hfield.orders.neighbours import Neighbours, generator_above, neighbours_at

MAX_CLASSES = 200_000
"""Sets of more classes than this are not enumerated."""
MAX_NEIGHBOURS = 500_000
"""The largest number of ideals of prime norm that are listed."""


class Classes:
    """The classes as values: lattices, norms, units of left orders, and neighbours."""

    def __init__(self, order: LatticeValue) -> None:
        self.order, self.ambient = order, order.ambient
        self.mass = mass(order)
        if self.mass > MAX_CLASSES:
            raise TooLargeError(
                f"the mass is {shorten(self.mass)}, so there are more than {MAX_CLASSES} classes: too many "
                "to enumerate; over QQ A.class_number(N) counts those of Eichler orders by Eichler's formula"
            )
        self.keys = ClassKeys(order)
        self.units: list[int] = []
        """[O_L(I)ˣ : Rˣ], class by class; R are the integers of the base."""
        self.norms: list[Norm] = []
        self._bases: list[tuple[fmpz_mat, int]] = []
        """A reduced basis of the lattice of each class, rows over a denominator."""
        self._numbers: dict[Key, int] = {}
        self._rows: dict[Any, list[Counter[int]]] = {}
        self._exchanged: dict[Any, list[int]] = {}
        self._left = self.mass
        self._enumerate()

    def _enumerate(self) -> None:
        self.class_of(self.order)
        for prime in good_primes(self.order):
            if not self._left:
                return
            self._expect_few_neighbours(1, prime)
            rows = self._rows.setdefault(prime, [])
            while len(rows) < len(self) and self._left:
                rows.append(self.neighbours_of(len(rows), prime))
                report(self.mass - self._left, self.mass, "the classes")

    def __len__(self) -> int:
        return len(self.units)

    def lattice(self, n: int) -> LatticeValue:
        """Return the lattice that represents class n; it contains the order."""
        rows, den = self._bases[n]
        return hermite_form(self.ambient, den, rows)

    # --- looking up --------------------------------------------------------------------------------

    def class_of(self, lattice: LatticeValue) -> int:
        """Return the number of the class of an invertible right ideal."""
        return self._class_of(lattice, self.keys.norm_of(lattice.norm))

    def _class_of(self, lattice: LatticeValue, norm: Norm) -> int:
        around = SublatticeKeys(self.keys, lattice.matrix, lattice.den, norm)
        return self._look_up(around, self.ambient.identity)

    def _look_up(self, around: SublatticeKeys, coordinates: fmpz_mat) -> int:
        """Return the number of the class of a sublattice, which may be new."""
        basis = around.reduced(coordinates)
        key = around.key(basis)
        found = self._numbers.get(key)
        if found is None:
            found = self._numbers[key] = self._add(around.representative(basis))
        return found

    def _add(self, found: Representative) -> int:
        """Return the number of a class, of which all keys are known if one is."""
        known = self._numbers.get(found.keys[0])
        if known is not None:
            return known
        number = len(self)
        for key in found.keys:
            self._numbers[key] = number
        self._bases.append((found.rows, found.den))
        self.units.append(found.units)
        self.norms.append(found.norm)
        self._left -= Fraction(1, found.units)
        if self._left < 0:
            raise AssertionError("the classes found exceed the mass")
        return number

    # --- neighbours --------------------------------------------------------------------------------

    def _expect_few_neighbours(self, rows: int, prime: Any) -> None:
        """Raise :class:`TooLargeError` before a list of neighbours that is too long is begun."""
        base = self.ambient.base
        count = rows * (base.absolute_norm(base.prime_ideal(prime)) + 1)
        if count > MAX_NEIGHBOURS:
            raise TooLargeError(
                f"{count} ideals of relative norm {prime} would be listed, and at most {MAX_NEIGHBOURS} are; "
                "expected a smaller prime"
            )

    def neighbours(self, prime: Any) -> list[Counter[int]]:
        """Return for each class how many right ideals of relative norm P in it belong to which class.

        Raises :class:`TooLargeError` where there are too many.
        """
        rows = self._rows.get(prime, [])
        if len(rows) < len(self):
            self._expect_few_neighbours(len(self) - len(rows), prime)
            # a loop that is interrupted is continued
            self._rows[prime] = rows
            for n in track(range(len(rows), len(self)), len(self) - len(rows), "rows"):
                rows.append(self.neighbours_of(n, prime))
        return rows

    def has_rows(self, prime: Any) -> bool:
        """Tell whether all neighbours at a prime are known."""
        return len(self._rows.get(prime, [])) == len(self)

    def neighbours_of(self, n: int, prime: Any) -> Counter[int]:
        """Return how many ideals of relative norm P in class n belong to which class."""
        self._expect_few_neighbours(1, prime)
        return Counter(self.classes_inside(n, prime))

    def classes_inside(self, n: int, prime: Any) -> list[int]:
        """Return the classes of the ideals of relative norm P in class n, ordered as in :meth:`at_prime`."""
        around, inside = self.sublattices(n, prime)
        return [self._look_up(around, J) for J in inside]

    def sublattices(self, n: int, prime: Any) -> tuple[SublatticeKeys, Iterator[fmpz_mat]]:
        """Return the keys of the ideals of relative norm P in class n, and bases in its coordinates."""
        norm, ideal = self.norms[n], self.ambient.base.prime_ideal(prime)
        around = SublatticeKeys(self.keys, *self._bases[n], self.keys.multiplied(norm, ideal))
        return around, self.at_prime(prime).inside(around, norm)

    def class_keys(self, n: int) -> SublatticeKeys:
        """Return the keys of sublattices of class n of its norm: of the lattice itself."""
        return SublatticeKeys(self.keys, *self._bases[n], self.norms[n])

    def at_prime(self, prime: Any) -> Neighbours:
        """Return the right ideals of norm P."""
        return neighbours_at(self.order, prime)

    def local_norm(self, n: int, prime: Any) -> Any:
        """Return N(x)/ν for an x that generates class n, of norm ν·a, at the primes above that below P."""
        norm, base = self.norms[n], self.ambient.base
        x = generator_above(self.class_keys(n), base.place(prime).below, norm)
        return (base.field.one if x is None else x.norm) / norm.element

    # --- permutations ------------------------------------------------------------------------------

    def moved(self, by: Callable[[LatticeValue], LatticeValue], norm: Any) -> list[int]:
        """Return which class each becomes when a change of lattices multiplies norms by an ideal."""
        return [self._moved(n, by, norm) for n in range(len(self))]

    def _moved(self, n: int, by: Callable[[LatticeValue], LatticeValue], norm: Any) -> int:
        return self._class_of(by(self.lattice(n)), self.keys.multiplied(self.norms[n], norm))

    def multiplied(self, ideal: Any) -> list[int]:
        """Return the permutation of the classes that multiplication by an ideal of the base induces."""
        if not self.ambient.base.class_generators:  # it is principal
            return list(range(len(self)))
        return self.moved(partial(times_ideal, ideal=ideal), ideal * ideal)

    @cached_property
    def central(self) -> list[list[int]]:
        """Which class each becomes by ideals of the base that generate its class group."""
        return [self.multiplied(a) for a in self.ambient.base.class_generators]

    def exchanged(self, prime: Any) -> list[int]:
        """Return which class each becomes by the two-sided prime ideal at a prime.

        Raises :class:`LatticeError` where the order is neither maximal nor Eichler there.
        """
        if prime not in self._exchanged:
            ideal = two_sided_prime(self.order, prime)
            involution, found = not self.ambient.base.class_generators, [-1] * len(self)
            for n in track(range(len(self)), len(self), "types"):
                if found[n] < 0:
                    found[n] = self._moved(n, lambda lattice: product(lattice, ideal), ideal.norm)
                    if involution:  # the square of the ideal is generated by a number
                        found[found[n]] = n
            self._exchanged[prime] = found
        return self._exchanged[prime]

    @cached_property
    def types(self) -> list[int]:
        """The number of the type of each class: which left orders are isomorphic.

        They are the orbits of the invertible two-sided ideals on the classes (Voight, section 18.5): those of
        the base and, for maximal and Eichler orders, one at each prime of the discriminant. Left orders of
        other orders are compared.
        """
        base = self.ambient.base
        if is_eichler(self.order):
            primes = [P for P, _ in base.factorisation(discriminant(self.order))]
            return orbits(len(self), [*self.central, *map(self.exchanged, primes)])
        return types_by_isomorphism(self)


def types_by_isomorphism(classes: Classes) -> list[int]:
    """Return the number of the type of each class, of any order, found by comparing left orders in pairs."""
    kinds = orbits(len(classes), classes.central)
    firsts: dict[int, tuple[int, LatticeValue]] = {}  # a type: units and left order of a class
    names: dict[int, int] = {}
    for n, kind in enumerate(kinds):
        if kind in names:
            continue
        units, order = classes.units[n], order_of(classes.lattice(n), "left")
        names[kind] = next(
            (
                other
                for other, (count, known) in firsts.items()
                if count == units and conjugator(known, order)[0] is not None
            ),
            kind,
        )
        firsts.setdefault(names[kind], (units, order))
    return renumbered([names[kind] for kind in kinds])


def orbits(size: int, moves: list[list[int]]) -> list[int]:
    """Return the number of the orbit of each of 0, …, size − 1 under permutations.

    Orbits are numbered in the order of their first elements.
    """
    kinds = [-1] * size
    for start in range(size):
        todo = [start] if kinds[start] < 0 else []
        while todo:
            n = todo.pop()
            if kinds[n] < 0:
                kinds[n] = start
                todo += [move[n] for move in moves]
    return renumbered(kinds)


def renumbered(kinds: list[int]) -> list[int]:
    """Return numbers in place of others, from 0 in the order in which they come."""
    numbers: dict[int, int] = {}
    return [numbers.setdefault(kind, len(numbers)) for kind in kinds]
