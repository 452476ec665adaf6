"""The structure of a finite group as a text in GAP's notation: ``C4 x C2``, ``(C3 x C3) : C8``.

An abelian group is a product of cyclic groups in which each order divides the previous one. Any other group
is split into a direct product if possible, else into a semidirect product ``N : H`` of a normal subgroup N
and a complement H: first with N and H abelian, then with N as large as possible. ``N . H`` is an extension
for which no complement was found. The text describes the group correctly, but GAP may choose another such
decomposition.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice, pairwise, product
from math import gcd, lcm, prod
from typing import TYPE_CHECKING, Protocol

from hfield.core.factorisation import factorise
from hfield.core.properties import WithoutCaches
from hfield.errors import TooLargeError, UndecidedError
from hfield.exploring.finite_groups import FiniteGroup

if TYPE_CHECKING:
    import numpy as np

MAX_ORDER = 2048
"""The greatest order of a group without a name of its own, not abelian, whose structure is found."""
MAX_TRIALS = 3000
"""So many complements are tried."""


@dataclass(frozen=True)
class GroupInvariants:
    """Invariants of a finite group: orders, and abelian groups as texts.

    ``abelian_quotient`` is the group modulo its commutators. ``derived_series`` lists the orders of the group
    and of its iterated commutator subgroups, down to a perfect group, which may be trivial.

    >>> from hfield import H
    >>> print(H("GF(3)").unit_group().invariants)
    order 48, exponent 24, centre C2, abelian quotient C2, derived series 48 > 24 > 8 > 2 > 1
    """

    order: int
    exponent: int
    center: str
    abelian_quotient: str
    derived_series: tuple[int, ...]

    def __str__(self) -> str:
        series = " > ".join(map(str, self.derived_series))
        return (
            f"order {self.order}, exponent {self.exponent}, centre {self.center}, "
            f"abelian quotient {self.abelian_quotient}, derived series {series}"
        )


class NamedGroup(Protocol):
    """A group with a name and invariants."""

    def find_name(self) -> str:
        """Return the name or structure."""

    @property
    def invariants(self) -> GroupInvariants:
        """Order, exponent, centre, abelian quotient, and the orders of the derived series."""


class ListedGroup(WithoutCaches, ABC):
    """A group whose elements are listed; over ℤ/n it may be the product of the groups modulo prime powers."""

    @cached_property
    @abstractmethod
    def _group(self) -> FiniteGroup:
        """The group with listed elements."""

    @cached_property
    @abstractmethod
    def _parts(self) -> Sequence[NamedGroup]:
        """The groups whose product is this group, or none."""

    @abstractmethod
    def _theoretical_name(self) -> str | None:
        """Return the name known from theory, such as ``GL(2,3)``."""

    def find_name(self) -> str:
        """Return the name or structure. Raises :class:`TooLargeError`, :class:`UndecidedError`."""
        name = self._theoretical_name()
        if name is not None:
            return name
        if self._parts:
            return joined([part.find_name() for part in self._parts])
        return structure(self._group)

    @cached_property
    def invariants(self) -> GroupInvariants:
        """Order, exponent, centre, abelian quotient, and the orders of the derived series."""
        if self._parts:
            return product_invariants([part.invariants for part in self._parts])
        return group_invariants(self._group)


def group_invariants(group: FiniteGroup) -> GroupInvariants:
    """Return the invariants of a group."""
    import numpy as np

    series = [group]
    while not series[-1].commutators.all():  # of the group of order 1 they are all
        series.append(series[-1].subgroup(series[-1].commutators))
    center = np.zeros(group.order, dtype=bool)
    center[group.center] = True
    return GroupInvariants(
        group.order,
        group.exponent,
        cyclic_factors(invariants(group.subgroup(center))),
        cyclic_factors(invariants(group)),
        tuple(part.order for part in series),
    )


def product_invariants(parts: Sequence[GroupInvariants]) -> GroupInvariants:
    """Return the invariants of a direct product."""
    length = max(len(part.derived_series) for part in parts)
    ends = [[*part.derived_series, *[part.derived_series[-1]] * length] for part in parts]
    return GroupInvariants(
        prod(part.order for part in parts),
        lcm(*(part.exponent for part in parts)),
        joined([part.center for part in parts]),
        joined([part.abelian_quotient for part in parts]),
        tuple(prod(series[n] for series in ends) for n in range(length)),
    )


def structure(group: FiniteGroup) -> str:
    """Return the structure of a group. Raises :class:`TooLargeError`, :class:`UndecidedError`.

    >>> import numpy as np
    >>> structure(FiniteGroup(np.arange(12), lambda x, y: (x + y) % 12, 0))
    'C12'
    """
    if group.is_abelian:
        return cyclic_factors(invariants(group))
    if group.order > MAX_ORDER:
        raise TooLargeError(
            f"the structure of a group of order {group.order} is not found: it is for groups up to "
            f"{MAX_ORDER}, abelian ones, and linear groups"
        )
    _ = group.table  # from now on products are looked up
    return _named(group) or _direct_product(group) or _extension(group)


def invariants(group: FiniteGroup) -> list[int]:
    """Return the orders of the cyclic factors of the abelianisation, each divisible by the next."""
    import numpy as np

    inside = group.commutators
    size = int(np.count_nonzero(inside))
    found = {}
    for p, exponent in factorise(group.order // size).items():
        rest = group.order // size // p**exponent
        x = group.power(group.places, rest)
        logs = [0]
        for _ in range(exponent):
            x = group.power(x, p)
            logs.append(_log(int(np.count_nonzero(inside[x])) // (size * rest), p))
        ranks = [high - low for low, high in pairwise(logs)]  # factors of order ≥ p^k
        found[p] = [sum(rank > n for rank in ranks) for n in range(ranks[0])]
    return merged_invariants(found)


def _log(n: int, p: int) -> int:
    found = 0
    while n > 1:
        n //= p
        found += 1
    return found


def merged_invariants(exponents: dict[int, list[int]]) -> list[int]:
    """Return the orders of cyclic factors from the exponents for each prime, descending."""
    length = max(map(len, exponents.values()), default=0)
    return [
        prod(p ** (e[n] if n < len(e) else 0) for p, e in exponents.items()) for n in range(length)
    ]


def cyclic_factors(orders: Sequence[int]) -> str:
    """Write a product of cyclic groups with these orders.

    >>> cyclic_factors([6, 2]), cyclic_factors([])
    ('C6 x C2', '1')
    """
    return " x ".join(f"C{n}" for n in orders) or "1"


# --- groups with names ----------------------------------------------------------------------------

_BY_ORDERS = {
    (12, ((1, 1), (2, 3), (3, 8))): "A4",
    (24, ((1, 1), (2, 9), (3, 8), (4, 6))): "S4",
    (24, ((1, 1), (2, 1), (3, 8), (4, 6), (6, 8))): "SL(2,3)",
    (48, ((1, 1), (2, 13), (3, 8), (4, 6), (6, 8), (8, 12))): "GL(2,3)",
    (60, ((1, 1), (2, 15), (3, 20), (5, 24))): "A5",
}
"""Groups that are the only ones of their order with so many elements of each order."""


def _named(group: FiniteGroup) -> str | None:
    """Return the name of a symmetric, alternating, dihedral or quaternion group, or of a small
    linear group.
    """
    key = (group.order, tuple(sorted(group.element_orders.items())))
    if key in _BY_ORDERS:
        return _BY_ORDERS[key]
    half = group.order // 2
    turns = [int(x) for x in group.places[group.orders == half]] if group.order % 2 == 0 else []
    if not turns:
        return None
    r = turns[0]
    inside = group.generated([r])
    s = next(x for x in range(group.order) if not inside[x])
    turned = _conjugate(group, s, r)
    if turned != group.inverse(r):
        return None
    square = int(group.product(_one(s), _one(s))[0])
    if square == group.identity:
        return "S3" if group.order == 6 else f"D{group.order}"
    is_power_of_two = group.order & (group.order - 1) == 0
    return f"Q{group.order}" if is_power_of_two else None


def _one(x: int) -> np.ndarray:
    import numpy as np

    return np.array([x])


def _conjugate(group: FiniteGroup, g: int, x: int) -> int:
    left = group.product(_one(g), _one(x))
    return int(group.product(left, _one(group.inverse(g)))[0])


# --- products and extensions ----------------------------------------------------------------------


def _direct_product(group: FiniteGroup) -> str | None:
    """Write the group as a direct product of two normal subgroups, the smaller one first."""
    import numpy as np

    normal = group.normal_subgroups
    for small in normal:
        size = int(np.count_nonzero(small))
        if size * size > group.order or group.order % size:
            continue
        for large in normal:
            if (
                np.count_nonzero(large) * size == group.order
                and np.count_nonzero(small & large) == 1
            ):
                return direct_product([group.subgroup(small), group.subgroup(large)])
    return None


def direct_product(groups: Sequence[FiniteGroup]) -> str:
    """Write a direct product, with the abelian factors combined and first."""
    return joined([structure(group) for group in groups])


def joined(names: Sequence[str]) -> str:
    """Write the direct product of groups with these structures, with the cyclic factors combined.

    >>> joined(["C2", "C2 x S3"]), joined(["C3 : C4", "C5"])
    ('C2 x C2 x S3', 'C5 x (C3 : C4)')
    """
    exponents: dict[int, list[int]] = {}
    others: list[str] = []
    for name in names:
        for factor in _factors(name):
            if factor.startswith("C") and factor[1:].isdecimal():
                for p, e in factorise(int(factor[1:])).items():
                    exponents.setdefault(p, []).append(e)
            elif factor != "1":
                others.append(factor)
    orders = merged_invariants({p: sorted(e, reverse=True) for p, e in exponents.items()})
    shown = [f"({x})" if _is_extension(x) else x for x in others]
    return " x ".join([*(f"C{n}" for n in orders), *shown]) or "1"


def _is_extension(name: str) -> bool:
    return any(f" {sign} " in _outside_brackets(name) for sign in ":.")


def _outside_brackets(name: str) -> str:
    depth, text = 0, ""
    for char in name:
        depth += (char == "(") - (char == ")")
        text += char if depth == 0 else ""
    return text


def _factors(name: str) -> list[str]:
    """Return the factors of a direct product, without enclosing brackets."""
    if _is_extension(name):
        return [name]
    parts, depth = [""], 0
    words = name.split(" ")
    for word in words:
        if word == "x" and depth == 0:
            parts.append("")
            continue
        depth += word.count("(") - word.count(")")
        parts[-1] = f"{parts[-1]} {word}".strip()
    return [part[1:-1] if part.startswith("(") and part.endswith(")") else part for part in parts]


def _bracketed(name: str) -> str:
    return f"({name})" if " " in name else name


def _extension(group: FiniteGroup) -> str:
    """Write the group as a semidirect product, or as an extension of the quotient by its centre."""
    import numpy as np

    candidates: list[tuple[tuple[bool, bool, int], int, np.ndarray]] = []
    for inside in group.normal_subgroups:
        places = np.flatnonzero(inside)
        table = group.table[np.ix_(places, places)]
        kind = (
            not _contains(inside, group.commutators),
            bool((table != table.T).any()),
            -len(places),
        )
        candidates.append((kind, len(candidates), inside))
    for _, _, inside in sorted(candidates, key=lambda c: c[:2]):
        quotient = group.quotient(inside)
        if _splits(group, inside, quotient):
            subgroup = group.subgroup(inside)
            return f"{_bracketed(structure(subgroup))} : {_bracketed(structure(quotient))}"
    inside = np.zeros(group.order, dtype=bool)
    inside[group.center] = True
    if len(group.center) == 1:
        inside = group.commutators
    if inside.all():
        raise UndecidedError(
            f"the structure of a perfect group of order {group.order} is not found"
        )
    parts = (structure(group.subgroup(inside)), structure(group.quotient(inside)))
    return " . ".join(map(_bracketed, parts))


def _contains(larger: np.ndarray, smaller: np.ndarray) -> bool:
    return not bool((smaller & ~larger).any())


def _splits(group: FiniteGroup, inside: np.ndarray, quotient: FiniteGroup) -> bool:
    """Return whether a normal subgroup has a complement; False if :data:`MAX_TRIALS` trials find none."""
    import numpy as np

    normal = np.flatnonzero(inside)
    if gcd(len(normal), quotient.order) == 1:
        return True  # Schur and Zassenhaus
    lifts = []
    for g in quotient.generators:
        coset = group.product(_one(int(quotient.members[g])), normal)
        # a lift in a complement has the order of its image
        lifts.append([int(x) for x in coset if group.orders[x] == quotient.orders[g]])
    choices: Iterator[tuple[int, ...]] = product(*lifts)
    for choice in islice(choices, MAX_TRIALS):
        if np.count_nonzero(group.generated(choice)) == quotient.order:
            return True
    return False
