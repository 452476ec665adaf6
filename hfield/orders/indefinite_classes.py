"""The right ideal classes of orders over ℤ_K in algebras that split at an infinite place.

Assume that every local unit of the base is a norm of a unit of the order. This holds if the Eichler symbol is
1 or −1 at each prime of the discriminant. Then, by strong approximation, I and J are in one class exactly if
N(I)/N(J) has a generator that is positive at the real places at which the algebra ramifies (M. Eichler, 1938;
Voight, *Quaternion Algebras*, ch. 28).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, ClassVar

import flint

from hfield.core.properties import cached_property
from hfield.errors import IndefiniteError, LatticeError, shorten
from hfield.hints import CLASSES, Hinted
from hfield.orders.invariants import eichler_symbol, good_primes
from hfield.orders.lattice_values import discriminant, is_locally_principal, product

if TYPE_CHECKING:
    from hfield.orders.lattice import Ideal, Lattice, Order


class IndefiniteClassSet(Hinted):
    """The invertible right ideal classes of an order: ``len(C)``, iteration over representatives, ``C[n]``.

    ``group`` is the group of ideals modulo principal ideals with a generator positive at the ramified real
    places; it has ``class_of``.
    """

    foreign_names: ClassVar = {name: hint for name, hint in CLASSES.items() if "brandt" not in hint}

    def __init__(self, order: Order) -> None:
        self.order, ambient = order, order.value.ambient
        if order.is_definite():
            raise IndefiniteError(
                f"{order.algebra} is totally definite: class_set() enumerates its classes, and norms "
                "determine only stable classes"
            )
        for P, _ in ambient.base.factorisation(discriminant(order.value)):
            if eichler_symbol(order.value, P) == 0:
                raise IndefiniteError(
                    "classes are determined by narrow classes of norms only where all local units are norms; "
                    f"at {P} the order has the Eichler symbol 0, which needs a ray class group, and these "
                    "are not computed"
                )
        self.group = ambient.base.classes_modulo_signs(ambient)

    def __len__(self) -> int:
        return int(self.group.order)

    @cached_property
    def _ideals(self) -> dict[tuple[int, ...], Ideal]:
        """A representative of each class, by its class in the group: O, or an ideal of prime norm."""
        order, base = self.order, self.order.value.ambient.base
        found = {self.group.class_of(base.one): order.right_ideal([1])}
        for P in good_primes(order.value):
            if len(found) == len(self):
                break
            ideal = base.prime_ideal(P)
            kind = self.group.class_of(ideal)
            if kind not in found:
                found[kind] = order.ideals_of_norm(ideal, "right")[0]
        return found

    def __getitem__(self, n: int) -> Ideal:
        """Return the representative of class n, an integral right ideal; class 0 is that of O."""
        return list(self._ideals.values())[n]

    def __iter__(self) -> Iterator[Ideal]:
        return iter(self._ideals.values())

    def index(self, ideal: Lattice) -> int:
        """Return the number of the class of a right ideal. Raises :class:`LatticeError` for others."""
        value, order = ideal.value, self.order.value
        if not is_locally_principal(value, order) or product(value, order) != value:
            raise LatticeError(f"{shorten(ideal)} is not an invertible right ideal of the order")
        return list(self._ideals).index(self.group.class_of(value.norm))

    @property
    def type_number(self) -> int:
        """The number of isomorphism classes of left orders, for Eichler orders; other orders raise an error.

        They correspond to the classes modulo squares and norms of two-sided ideals (Voight, 28.5).
        """
        if not self.order.is_eichler():
            raise LatticeError(
                "types of indefinite orders are counted for Eichler orders only, and this order is not one"
            )
        even = [k for k, d in enumerate(self.group.invariants) if d % 2 == 0]
        ambient = self.order.value.ambient
        primes = ambient.base.factorisation(discriminant(self.order.value))
        norms = [ambient.base.prime_ideal(P) ** e for P, e in primes]
        rows = [[self.group.class_of(a)[k] % 2 for k in even] for a in norms]
        rank = flint.nmod_mat(rows, 2).rank() if rows and even else 0
        return 1 << (len(even) - rank)

    def __repr__(self) -> str:
        return f"{len(self)} right ideal classes, by strong approximation, of {self.order}"
