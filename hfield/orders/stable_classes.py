"""The stable classes of right ideals: I and J are in the same class if I ⊕ O ≅ J ⊕ O.

In a definite order these are the classes of norms of local generators in K^×₊ \\ Â^× / N(Ô^×), that is,
narrow classes of ideals and, at some primes, a class of local units modulo norms (A. Fröhlich, *J. reine
angew. Math.* 274, 1975; D. Smertnig and J. Voight, *Trans. London Math. Soc.* 6, 2019, section 2). Squares of
local units are norms, so the classes of local units are computed by linear algebra over GF(2). If the Eichler
symbol is not 0, every local unit is a norm.

Let R be the ring of integers of the base and J the radical of O_P. If the Eichler symbol is 0, the units of
O_P are the products of units of R_P and elements of 1 + J. Above an odd prime their norms are squares. Above
2 the norms of 1 + y, with y in bases of J, J², …, generate the norms of 1 + J. The powers of J in 4P·O can be
omitted, because they give norms in 1 + 4P, which are squares.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq_mat

from hfield.orders.base_values import BaseNumber, Prime
from hfield.orders.invariants import eichler_symbol
from hfield.orders.lattice_values import (
    LatticeValue,
    discriminant,
    includes,
    product,
    times_ideal,
)
from hfield.orders.orders_at_primes import OrderAtPrime


@dataclass(frozen=True)
class LocalNorms:
    """Norms of local units at one prime. A class modulo squares is an integer of ``size`` bits."""

    prime: Prime
    size: int
    square_class: Callable[[BaseNumber], int]
    """The class of the unit part of a number, for a fixed uniformiser."""
    norms: tuple[int, ...]
    """Classes that generate those of the norms."""


class StableClasses:
    """The stable classes of an order over ℤ_K; there are ``number`` of them, and ``ideals`` narrow classes.

    ``units`` generate the totally positive units modulo squares.
    """

    def __init__(
        self, places: Sequence[LocalNorms], units: Iterable[BaseNumber], ideals: int
    ) -> None:
        self.places = places
        self._basis: list[int] = []  # leading digits differ, and fall
        size = 0
        for place in places:
            for norm in place.norms:
                self._add(norm << size)
            size += place.size
        for u in units:
            self._add(self.reduced([u] * len(places)))
        self.number = ideals << (size - len(self._basis))

    def _add(self, vector: int) -> None:
        vector = self._without(vector)
        if vector:
            self._basis = sorted([*self._basis, vector], reverse=True)

    def _without(self, vector: int) -> int:
        for b in self._basis:
            vector = min(vector, vector ^ b)
        return vector

    def reduced(self, values: Iterable[BaseNumber]) -> int:
        """Return the class of numbers, one for each place, modulo the norms of local units and all units."""
        vector = size = 0
        for place, x in zip(self.places, values, strict=True):
            vector |= place.square_class(x) << size
            size += place.size
        return self._without(vector)


def stable_classes(order: LatticeValue) -> StableClasses:
    """Return the stable classes of a definite order."""
    base, places = order.ambient.base, []
    for P, _ in base.factorisation(discriminant(order)):
        if eichler_symbol(order, P) == 0:
            size, square_class = base.square_classes(P)
            norms = set(map(square_class, _norms(order, P)))
            places.append(LocalNorms(P, size, square_class, tuple(norms)))
    return StableClasses(places, base.positive_units, base.narrow_classes.order)


def _norms(order: LatticeValue, P: Prime) -> Iterator[BaseNumber]:
    """Yield norms that, together with the squares, generate the norms of units at P."""
    ambient, place = order.ambient, order.ambient.base.place(P)
    if place.below > 2:
        return
    ideal = ambient.base.prime_ideal(P)
    one, bound = ambient.one, times_ideal(order, ideal ** (2 * place.index + 1))
    radical = power = OrderAtPrime(order, P).radical
    while not includes(bound, power):
        for row in power.rows.tolist():
            yield ambient.norm((fmpq_mat([row]) + one).entries())
        power = product(power, radical)


class WithStableClasses:
    """The methods of an order that concern stable classes."""

    mass: Callable[[], Fraction]
    unit_index: Callable[[], int]

    @property
    @abstractmethod
    def _stable(self) -> StableClasses:
        """The stable classes, computed from local norms."""

    def stable_class_number(self) -> int:
        """Return the number of right ideal classes up to I ⊕ O ≅ J ⊕ O. Raises :class:`IndefiniteError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(6))", -1, -1).maximal_order()
        >>> O.stable_class_number(), O.is_hermite()
        (2, False)
        >>> O = QuaternionAlgebra("QQ", -1, -1).order(["i", "2*j"])
        >>> O.stable_class_number(), O.is_hermite()
        (2, True)
        """
        self.mass()
        return self._stable.number

    def is_hermite(self) -> bool:
        """Return whether each right ideal with I ⊕ O ≅ O ⊕ O is principal: whether stably free ideals are
        free.

        All stable classes have the same mass, and in a Hermite order the stable class of O is one class.
        Raises as :meth:`stable_class_number` does.
        """
        whole = self.mass() * self.unit_index()
        return whole.denominator == 1 and whole == self.stable_class_number()


class ByStableClasses:
    """Methods of class sets that concern stable classes."""

    order: WithStableClasses
    __len__: Callable[[], int]
    _stable_class: Callable[[int], Hashable]

    def stable_classes(self) -> list[int]:
        """Return the stable class of each class, as a number; I and J have the same one if I ⊕ O ≅ J ⊕ O.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra("QQ(sqrt(6))", -1, -1).maximal_order().class_set()
        >>> C.stable_classes(), C.has_cancellation()
        ([0, 1, 0], False)
        """
        numbers: dict[Hashable, int] = {}
        kinds = map(self._stable_class, range(len(self)))
        return [numbers.setdefault(kind, len(numbers)) for kind in kinds]

    def has_cancellation(self) -> bool:
        """Return whether I ⊕ O ≅ J ⊕ O implies I ≅ J for all right ideals."""
        return len(self) == self.order.stable_class_number()
