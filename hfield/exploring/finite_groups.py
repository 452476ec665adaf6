"""Finite groups whose elements are numbers: orders, classes, centre, generators, subgroups, quotients."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from math import lcm
from typing import TYPE_CHECKING

from hfield.core.factorisation import factorise

if TYPE_CHECKING:
    import numpy as np

MAX_PRUNED = 4096
"""Up to this order redundant generators are removed, and elements of greatest order are preferred."""

MAX_NORMAL = 600
"""The number of normal subgroups after which no further class is added."""

MAX_NUMBER = 4 * 10**6
"""The largest number of a group element for which a table of indices by number is kept."""

Multiply = Callable[["np.ndarray", "np.ndarray"], "np.ndarray"]


class FiniteGroup:
    """A finite group: ``members`` are numbers, ascending, and ``multiply`` multiplies arrays of them.

    Everything inside is in terms of places among the members.
    """

    def __init__(self, members: np.ndarray, multiply: Multiply, identity: int) -> None:
        import numpy as np

        self.members = members
        self.order = len(members)
        self._multiply = multiply
        self.identity = int(np.searchsorted(members, identity))

    def product(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the places of products."""
        import numpy as np

        if "table" in self.__dict__:
            looked_up: np.ndarray = self.table[x, y]
            return looked_up
        found = self._multiply(self.members[x], self.members[y])
        if self._places is None:
            return np.searchsorted(self.members, found)
        places: np.ndarray = self._places[found]
        return places

    @cached_property
    def _places(self) -> np.ndarray | None:
        """The index of each label, None where the labels are too large for a table."""
        import numpy as np

        greatest = int(self.members[-1])
        if greatest > MAX_NUMBER:
            return None
        places = np.zeros(greatest + 1, dtype=np.int64)
        places[self.members] = self.places
        return places

    @cached_property
    def places(self) -> np.ndarray:
        """The places of all members."""
        import numpy as np

        return np.arange(self.order)

    @cached_property
    def table(self) -> np.ndarray:
        """The table of indices of all products, computed once."""
        return self.product(self.places[:, None], self.places[None, :])

    def power(self, x: np.ndarray, n: int) -> np.ndarray:
        """Return the places of n-th powers, n ≥ 0."""
        import numpy as np

        result = np.full(len(x), self.identity)
        while n:
            if n & 1:
                result = self.product(result, x)
            n >>= 1
            if n:
                x = self.product(x, x)
        return result

    @cached_property
    def orders(self) -> np.ndarray:
        """The order of each element; in a large group that of one element of each class is computed."""
        import numpy as np

        if self.order <= MAX_PRUNED:
            return self.orders_of(self.places)
        orders = np.zeros(self.order, dtype=np.int64)
        representatives = np.array([places[0] for places in self.classes])
        for places, n in zip(self.classes, self.orders_of(representatives), strict=True):
            orders[places] = n
        return orders

    def orders_of(self, elements: np.ndarray) -> np.ndarray:
        """Return the orders of some elements."""
        import numpy as np

        orders = np.ones(len(elements), dtype=np.int64)
        for p, exponent in factorise(self.order).items():
            x = self.power(elements, self.order // p**exponent)
            for _ in range(exponent):
                rest = x != self.identity
                if not rest.any():
                    break
                orders[rest] *= p
                x = self.power(x, p)
        return orders

    @property
    def element_orders(self) -> dict[int, int]:
        """The number of elements of each order."""
        import numpy as np

        orders, counts = np.unique(self.orders, return_counts=True)
        return {int(m): int(n) for m, n in zip(orders, counts, strict=True)}

    @property
    def exponent(self) -> int:
        """The least n > 0 with xⁿ = 1 for all x."""
        return lcm(*self.element_orders)

    def inverse(self, x: int) -> int:
        """Return the index of the inverse."""
        return int(self.power(np_array(x), self.order - 1)[0])

    def generated(self, generators: Sequence[int]) -> np.ndarray:
        """Return a bool array: which elements these generate."""
        import numpy as np

        inside = np.zeros(self.order, dtype=bool)
        inside[self.identity] = True
        frontier = np.array([self.identity])
        while len(frontier):
            reached = [self.product(frontier, np.array([g])) for g in generators]
            fresh = np.unique(np.concatenate(reached)) if reached else np.zeros(0, dtype=int)
            frontier = fresh[~inside[fresh]]
            inside[frontier] = True
        return inside

    @cached_property
    def generators(self) -> tuple[int, ...]:
        """The places of generators, those of large order first."""
        found: list[int] = []
        inside = self.generated(found)
        while not inside.all():
            outside = self.places[~inside]
            tried = outside[:: -(-len(outside) // MAX_PRUNED)]
            found.append(int(tried[self.orders_of(tried).argmax()]))
            inside = self.generated(found)
        if self.order <= MAX_PRUNED:
            for g in found[:-1]:
                rest = [x for x in found if x != g]
                if self.generated(rest).all():
                    found = rest
        return tuple(found)

    @cached_property
    def center(self) -> np.ndarray:
        """The places of the elements that commute with all."""
        import numpy as np

        inside = np.ones(self.order, dtype=bool)
        for g in self.generators:
            one = np.array([g])
            inside &= self.product(self.places, one) == self.product(one, self.places)
        return np.flatnonzero(inside)

    @property
    def is_abelian(self) -> bool:
        """Whether all elements commute."""
        return len(self.center) == self.order

    @cached_property
    def classes(self) -> tuple[np.ndarray, ...]:
        """The conjugacy classes as arrays of places, in the order of their first elements."""
        permutations = []
        for g in self.generators:
            left, right = (np_array(x) for x in (g, self.inverse(g)))
            permutations.append(self.product(self.product(left, self.places), right))
        return orbits(permutations, self.order)

    @cached_property
    def commutators(self) -> np.ndarray:
        """Which elements the commutators generate, as a bool array."""

        wanted: set[int] = set()
        for g in self.generators:
            for h in self.generators:
                x = self.product(self.product(np_array(g), np_array(h)), np_array(self.inverse(g)))
                wanted.add(int(self.product(x, np_array(self.inverse(h)))[0]))
        return self.normal_closure(sorted(wanted))

    def normal_closure(self, elements: Sequence[int]) -> np.ndarray:
        """Return which elements are in the least normal subgroup with some elements, as a bool array."""
        found = list(elements)
        inside = self.generated(found)
        n = 0
        while n < len(found):
            for g in self.generators:
                x = self.product(
                    self.product(np_array(g), np_array(found[n])), np_array(self.inverse(g))
                )
                if not inside[x[0]]:
                    found.append(int(x[0]))
                    inside = self.generated(found)
            n += 1
        return inside

    @cached_property
    def normal_subgroups(self) -> list[np.ndarray]:
        """Normal subgroups other than 1 and the group, as bool arrays, smallest first, up to about 600."""
        import numpy as np

        found: dict[bytes, np.ndarray] = {}
        for cls in self.classes:
            inside = self.normal_closure([int(cls[0])])
            found[inside.tobytes()] = inside
        of_one_class = list(found.values())
        queue = list(of_one_class)
        while queue and len(found) < MAX_NORMAL:
            base = queue.pop()
            for other in of_one_class:
                if (other & ~base).any():
                    union = np.zeros(self.order, dtype=bool)  # the products are a subgroup
                    union[self.table[np.ix_(base, other)]] = True
                    if union.tobytes() not in found:
                        found[union.tobytes()] = union
                        queue.append(union)
        proper = [n for n in found.values() if 1 < np.count_nonzero(n) < self.order]
        return sorted(proper, key=lambda n: (int(np.count_nonzero(n)), (~n).tobytes()))

    def subgroup(self, inside: np.ndarray) -> FiniteGroup:
        """Return the subgroup of these elements, given as a bool array."""
        return FiniteGroup(self.members[inside], self._multiply, int(self.members[self.identity]))

    def quotient(self, inside: np.ndarray) -> FiniteGroup:
        """Return the quotient by a normal subgroup; its members are the least indices in the cosets."""
        import numpy as np

        normal = np.flatnonzero(inside)
        least = np.full(self.order, -1)
        for x in range(self.order):
            if least[x] < 0:
                least[self.product(np_array(x), normal)] = x
        members = np.unique(least)
        return FiniteGroup(
            members, lambda x, y: least[self.product(x, y)], int(least[self.identity])
        )


def np_array(x: int) -> np.ndarray:
    """Return an array of one number."""
    import numpy as np

    return np.array([x])


def orbits(permutations: Sequence[np.ndarray], size: int) -> tuple[np.ndarray, ...]:
    """Return the orbits of the numbers below ``size`` under permutations, ordered by their least numbers."""
    import numpy as np

    least = np.arange(size)
    while True:
        before = least
        for permutation in permutations:
            least = np.minimum(least, least[permutation])
            back = least.copy()
            back[permutation] = np.minimum(back[permutation], least)
            least = back[back]
        if (before == least).all():
            break
    order = np.argsort(least, kind="stable")
    _, starts = np.unique(least[order], return_index=True)
    return tuple(np.split(order, starts[1:]))
