"""All algebras of at most 700 elements, and what is found in them by trying, without hfield's arithmetic."""

from collections.abc import Iterable
from functools import cached_property
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from hfield.algebra import QuaternionAlgebra
from tests.subcases import slow
from tests.thorough import THOROUGH


def scalars(name: str) -> tuple[np.ndarray, np.ndarray]:
    """The tables of sums and products of GF(2), GF(3), GF(5), ZZ/4, and of GF(4) with x² = x + 1."""
    if name == "GF(4)":
        sums = [[x ^ y for y in range(4)] for x in range(4)]
        products = [[0] * 4, [0, 1, 2, 3], [0, 2, 3, 1], [0, 3, 1, 2]]
        return np.array(sums), np.array(products)
    n = int(name.strip("GFZ/()"))
    numbers = np.arange(n)
    return np.add.outer(numbers, numbers) % n, np.multiply.outer(numbers, numbers) % n


class Case(NamedTuple):
    """An algebra by its ring and the labels of its constants."""

    ring: str
    a: int
    t: int
    b: int

    @property
    def algebra(self) -> QuaternionAlgebra:
        """The algebra of hfield."""
        A = QuaternionAlgebra(self.ring, 0, 0)
        a, t, b = (list(A.ring.elements())[n] for n in (self.a, self.t, self.b))
        return QuaternionAlgebra(A.ring, a, b, t)


SIZES = {"GF(2)": 2, "GF(3)": 3, "GF(4)": 4, "GF(5)": 5, "ZZ/4": 4}
ALL = [Case(name, *abt) for name, q in SIZES.items() for abt in product(range(q), repeat=3)]
TYPICAL = [
    *(Case("GF(2)", *abt) for abt in ((1, 0, 1), (0, 0, 0), (1, 1, 1), (1, 1, 0), (0, 1, 0))),
    *(
        Case("GF(3)", *abt)
        for abt in ((2, 0, 2), (0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 0, 2), (1, 2, 1))
    ),
    *(Case("ZZ/4", *abt) for abt in ((3, 0, 3), (1, 1, 1), (0, 0, 0), (2, 1, 2))),
    Case("GF(4)", 1, 0, 1),
    Case("GF(4)", 2, 1, 1),
]
CASES = ALL if THOROUGH else TYPICAL
FIELDS = [case for case in CASES if case.ring != "ZZ/4"]
QUICK = [*TYPICAL[:11], Case("ZZ/4", 1, 1, 1)]  # the tables of 256 elements take most of the time


def cases_of(cases: Iterable[Case]) -> list[Any]:
    """Return cases for ``pytest.mark.parametrize``, those with large tables marked slow."""
    return [case if case in QUICK else slow(case) for case in cases]


class BruteForce:
    """An algebra as a table of products of numbers, whose digits are the labels of the coordinates."""

    def __init__(self, case: Case) -> None:
        self.q = q = SIZES[case.ring]
        self.sums, self.products = scalars(case.ring)
        self.case = case
        self.digits = np.array(list(product(range(q), repeat=4)))
        self.weights = np.array([q**3, q**2, q, 1])
        self.one = q**3

    def add(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """The number of the sum."""
        return self.sums[self.digits[x], self.digits[y]] @ self.weights

    def scale(self, s: int, x: np.ndarray) -> np.ndarray:
        """The number of a multiple by a scalar."""
        return self.products[s, self.digits[x]] @ self.weights

    @cached_property
    def minus(self) -> list[int]:
        """The negative of each scalar."""
        return [int(np.flatnonzero(row == 0)[0]) for row in self.sums]

    @cached_property
    def table(self) -> np.ndarray:
        """The products, from ``ij = k``, ``ji = tj − k`` and what follows by associativity."""
        a, t, b = self.case.a, self.case.t, self.case.b
        m = self.minus
        times = self.products
        ab, tb = int(times[a, b]), int(times[t, b])
        # basis products as coordinates: k·i = −aj, i·k = aj + tk, k·j = bi, j·k = tb − bi, k² = −ab
        rules = {
            (1, 1): (a, t, 0, 0), (1, 2): (0, 0, 0, 1), (1, 3): (0, 0, a, t),
            (2, 1): (0, 0, t, m[1]), (2, 2): (b, 0, 0, 0), (2, 3): (tb, m[b], 0, 0),
            (3, 1): (0, 0, m[a], 0), (3, 2): (0, b, 0, 0), (3, 3): (m[ab], 0, 0, 0),
        }  # fmt: skip
        for n in range(4):
            unit = tuple(int(n == r) for r in range(4))
            rules[0, n] = rules[n, 0] = unit
        size = self.q**4
        total = np.zeros((size, size), dtype=int)
        for (r, s), value in rules.items():
            factor = times[self.digits[:, r][:, None], self.digits[:, s][None, :]]
            number = int(np.dot(value, self.weights))
            multiples = np.array([int(self.scale(x, np.array(number))) for x in range(self.q)])
            total = self.add(total, multiples[factor])
        return total

    @cached_property
    def inverses(self) -> dict[int, int]:
        """The inverse of each unit."""
        left, right = np.nonzero(self.table == self.one)
        return dict(zip(left.tolist(), right.tolist(), strict=True))

    def conjugate_classes(self, units: list[int], elements: list[int]) -> set[frozenset[int]]:
        """The orbits of elements under x ↦ u·x·u⁻¹."""
        found = set()
        for x in elements:
            found.add(frozenset(int(self.table[self.table[u, x], self.inverses[u]]) for u in units))
        return found
