"""The automorphisms of a finite algebra that fix its scalars.

The automorphisms of a central simple algebra are inner (Skolem and Noether), and form PGL(2, q). In other
algebras an automorphism is a pair (x, y) of images of i and j with ``x² = a + t·x``, ``y² = b`` and ``yx =
t·y − xy``, such that 1, x, y and xy form a basis.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from hfield.algebra import structure
from hfield.algebra.maps import Isomorphism
from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import TooLargeError, UndecidedError
from hfield.exploring.finite_groups import FiniteGroup
from hfield.exploring.group_names import ListedGroup
from hfield.exploring.labels import LabelledAlgebra, Rows, labelled, order_of_ring
from hfield.exploring.unit_groups import linear_name, prime_power_parts, unit_group

if TYPE_CHECKING:
    import numpy as np

MAX_PAIRS = 5 * 10**6
"""The greatest number of pairs (x, y) that are tried."""


class AutomorphismGroup(ListedGroup):
    """The group of automorphisms of a finite algebra that fix its scalars, as maps.

    >>> from hfield import H
    >>> G = H("GF(3)").automorphism_group(); G.order, G.structure, len(G.generators)
    (24, 'PGL(2,3)', 2)
    """

    def __init__(self, algebra: Parent) -> None:
        self.algebra = algebra
        self._q = order_of_ring(algebra)

    @property
    def _is_simple(self) -> bool:
        return structure.is_central_simple(self.algebra.ring, self.algebra.constants)

    @cached_property
    def order(self) -> int:
        """The number of automorphisms."""
        if self._is_simple:
            return self._q**3 - self._q
        return self._group.order

    @cached_property
    def structure(self) -> str:
        """The name ``PGL(2,q)``, else the structure in GAP's notation, else the invariants as a text.

        Raises :class:`TooLargeError` for groups that are too large to list.
        """
        try:
            return self.find_name()
        except (TooLargeError, UndecidedError):
            return str(self.invariants)

    @cached_property
    def _parts(self) -> list[AutomorphismGroup]:
        """The groups modulo the prime powers of n; a group over ℤ/n is their product."""
        parts = prime_power_parts(self.algebra)
        return [AutomorphismGroup(part) for part in parts] if len(parts) > 1 else []

    def _theoretical_name(self) -> str | None:
        return linear_name(self.algebra, "PGL")

    @cached_property
    def generators(self) -> tuple[Isomorphism, ...]:
        """Automorphisms that generate the group."""
        if self._is_simple:
            units = (u for u in unit_group(self.algebra).generators)
            return tuple(inner for u in units if not _is_identity(inner := conjugation(u)))
        return tuple(self._map(int(self._group.members[n])) for n in self._group.generators)

    def __len__(self) -> int:
        return self.order

    def __iter__(self) -> Iterator[Isomorphism]:
        return (self._map(int(number)) for number in self._group.members)

    def __repr__(self) -> str:
        return f"<the automorphism group of {self.algebra}: order {self.order}>"

    def _map(self, number: int) -> Isomorphism:
        x, y = (self._labels.element(n) for n in divmod(number, self._labels.size))
        return Isomorphism(self.algebra, self.algebra, [self.algebra.one, x, y, x * y])

    @cached_property
    def _labels(self) -> LabelledAlgebra:
        labels = labelled(self.algebra)
        labels.check_size("automorphisms are found")
        return labels

    @cached_property
    def _group(self) -> FiniteGroup:
        """The group; an automorphism is the number ``x·|A| + y`` of the images x of i and y of j."""
        import numpy as np

        labels = self._labels
        size = labels.size
        i, j = (labels.number(q) for q in self.algebra.basis[1:3])

        def multiply(f: np.ndarray, g: np.ndarray) -> np.ndarray:
            x, y = (_apply(labels, f, part) for part in np.divmod(g, size))
            found: np.ndarray = x * size + y
            return found

        return FiniteGroup(np.array(_pairs(labels), dtype=np.int64), multiply, i * size + j)


def _apply(labels: LabelledAlgebra, f: np.ndarray, elements: np.ndarray) -> np.ndarray:
    """Return the numbers of the images of elements under automorphisms."""
    x, y = (labels.rows(part) for part in divmod(f, labels.size))
    w, *vector = labels.rows(elements)
    zero = w * 0
    total: Rows = (w, zero, zero, zero)
    for scalar, image in zip(vector, (x, y, labels.product(x, y)), strict=True):
        total = labels.sum(total, labels.product((scalar, zero, zero, zero), image))
    return labels.numbers(total)


def _pairs(labels: LabelledAlgebra) -> list[int]:
    """Return the automorphisms, as pairs of the indices of the images of i and j, ascending."""
    import numpy as np

    algebra = labels.algebra
    ring, (a, t, b) = algebra.ring, algebra.constants
    everything = labels.rows(np.arange(labels.size))
    numbers = labels.numbers(labels.product(everything, everything))
    fixed = [labels.label(x) for x in (a, t, b)]
    linear = labels.product(_scalar(fixed[1]), everything)
    shifted = labels.sum(linear, _scalar(fixed[0]))
    first = np.flatnonzero(numbers == labels.numbers(shifted))
    second = np.flatnonzero(numbers == fixed[2] * labels.q**3)
    if len(first) * len(second) > MAX_PAIRS:
        raise TooLargeError(
            f"the automorphisms of {algebra} are among {len(first) * len(second)} pairs of images, more than "
            f"the {MAX_PAIRS} that are tried"
        )
    units = np.array([ring.is_unit(x) for x in labels.tables.elements])
    y = labels.rows(second)
    found: list[int] = []
    for number in first:
        x = labels.rows(np.array([number]))
        xy, yx = labels.product(x, y), labels.product(y, x)
        fits = labels.numbers(labels.sum(xy, yx)) == labels.numbers(
            labels.product(_scalar(fixed[1]), y)
        )
        places = np.flatnonzero(fits)
        rows = [tuple(np.broadcast_to(c, len(second))[places] for c in u) for u in (x, y, xy)]
        good = units[labels.determinant([row[1:] for row in rows])]
        found += (int(number) * labels.size + second[places[good]]).tolist()
    return found


def _scalar(label: int) -> Rows:
    import numpy as np

    zero = np.zeros(1, dtype=np.int32)
    return (zero + label, zero, zero, zero)


def conjugation(u: Quaternion) -> Isomorphism:
    """Return the inner automorphism ``x ↦ u·x·u⁻¹``."""
    algebra, inverse = u.algebra, u.inverse()
    return Isomorphism(algebra, algebra, [u * x * inverse for x in algebra.basis])


def _is_identity(f: Isomorphism) -> bool:
    return tuple(f.images) == tuple(f.source.basis)
