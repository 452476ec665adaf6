"""The right ideal classes of an order in a definite algebra, and what acts on them.

A class is known by one lattice, so classes are looked up and not compared in pairs: of all ``x⁻¹·I``, for the
x of least norm in I, it is the one whose Hermite form comes first. Equivalent ideals have the same such
lattices, and the lattice lies in the class; as many of these x as the left order has units give the same
lattice.

Starting from O, neighbours at a prime are taken until the mass formula is used up: then no class is missing,
and as all are different none comes twice (Kirschmer and Voight, 2010; Voight, *Quaternion Algebras*, 26.1.5).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import fmpz_mat

from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime, primes
from hfield.core.progress import report, track
from hfield.errors import IndefiniteError, LatticeError, TooLargeError
from hfield.evidence import Certified, Claim
from hfield.orders import brandt, certificates, enumeration, hermite
from hfield.orders.class_number import mass
from hfield.orders.conjugators import conjugator
from hfield.orders.ideals_of_norm import (
    is_maximal_or_eichler,
    of_prime_power_norm,
    prime_to,
    right_subideals,
    two_sided_prime,
)
from hfield.orders.lattice_values import (
    LatticeValue,
    conjugate,
    meet,
    order_of,
    product,
    rows_json,
    scalars_into,
    scaled,
)
from hfield.orders.short_elements import theta_series
from hfield.orders.validation import positive, prime
from hfield.orders.z_order import ZOrder

Key = tuple[int, ...]
Row = tuple[int, ...]


def key_and_units(lattice: LatticeValue) -> tuple[Key, int]:
    """Return the lattice of a right ideal class as a key, and how many units the left order has."""
    quotients, _ = _quotients(lattice)
    key = min(quotients)
    return key, 2 * len(quotients[key])


def _quotients(
    lattice: LatticeValue,
) -> tuple[dict[Key, list[Row]], Callable[[Row, LatticeValue], Key]]:
    """Return the conj(x) that give each x⁻¹·I, for the x of least norm in I; and M ↦ x⁻¹·M, of conj(x)."""
    r, norm = lattice.ambient, lattice.norm
    rows, gram = lattice.reduced
    least, short = enumeration.least_vectors(gram)
    # N(x) = least/2·norm, and x is over the denominator of the lattice
    bars = fmpz_mat(short) * rows * r.conjugation
    up = 2 * norm.denominator
    den = lattice.den * r.conjugate_scale * r.scale * norm.numerator * least

    def quotient(bar: Row, other: LatticeValue) -> Key:
        found = hermite.hermite(den * other.den, other.matrix * (r.left_matrix(bar) * up))
        assert found is not None
        d, m = found
        return (d, *map(int, m.entries()))

    quotients: dict[Key, list[Row]] = {}
    for bar in hermite.tuples(bars):
        quotients.setdefault(quotient(bar, lattice), []).append(bar)
    return quotients, quotient


MOST_CLASSES = 200_000
"""More classes than this are counted by formula and not enumerated."""


MAX_NEIGHBOURS = 500_000
"""So many ideals of prime norm are listed at most, some ten thousand a second."""


def _expect_few_neighbours(count: int, p: int) -> None:
    """Raise :class:`TooLargeError` before a list of neighbours that is too long is begun."""
    if count > MAX_NEIGHBOURS:
        raise TooLargeError(
            f"{count} ideals of norm {p} times that of a class would be listed, and at most "
            f"{MAX_NEIGHBOURS} are; expected a smaller prime"
        )


class Classes(Certified):
    """The classes as values: their lattices, units and neighbours."""

    def __init__(self, ring: LatticeValue) -> None:
        if not ring.ambient.definite:
            raise IndefiniteError(
                f"{ring.algebra} is indefinite: by strong approximation an Eichler order has one right ideal "
                "class there; class_set() enumerates in definite algebras"
            )
        self.ring = ZOrder.of(ring)
        self.mass = mass(ring)
        if self.mass > MOST_CLASSES:
            raise TooLargeError(
                f"there are more than {MOST_CLASSES} classes; A.class_number(N) counts them by "
                "Eichler's formula"
            )
        self.unit_counts: list[int] = []
        """How many units the left orders of the classes have."""
        self._keys: dict[Key, int] = {}
        self._lattices: list[LatticeValue] = []
        self._exchanged: dict[int, list[int]] = {}
        self.rows: dict[int, list[Counter[int]]] = {}
        """What :meth:`neighbours` has found, by primes."""
        self._enumerate()

    def _enumerate(self) -> None:
        left = self.mass
        left -= self._add(*key_and_units(self.ring))
        discriminant = self.ring.discriminant
        for p in primes():
            if not left:  # the rows of an earlier prime lack the classes found since
                known = self.rows.items()
                self.rows = {p: rows for p, rows in known if len(rows) == len(self._lattices)}
                return
            if discriminant % p == 0:
                continue
            # where local units do not have all norms, neighbours at one prime reach a part of the classes
            rows: list[Counter[int]] = []
            back: dict[int, dict[Key, int]] = {}
            while len(rows) < len(self._lattices):
                row, left = self._row(len(rows), p, left, back)
                rows.append(row)
                # the classes known stand for the mass that is used up: so many rows there will be
                share = Fraction(len(rows), len(self._lattices)) * (self.mass - left)
                report(share, self.mass, "the classes")
            self.rows[p] = rows
            if left < 0:
                raise AssertionError("the classes found exceed the mass")

    def _row(
        self, n: int, p: int, left: Fraction, back: dict[int, dict[Key, int]]
    ) -> tuple[Counter[int], Fraction]:
        """Return the neighbours of class n, some of them new, and what is left of the mass.

        Neighbours go both ways: where x⁻¹·J stands for a class, J a neighbour of I, its neighbour p·x⁻¹·I is
        kept in ``back`` until its turn comes, and need not be looked up.
        """
        row: Counter[int] = Counter()
        lattice, known = self._lattices[n], back.pop(n, {})
        whole = scaled(lattice, p)
        for J in right_subideals(lattice, self.ring, p):
            m = known.get((J.den, *map(int, J.matrix.entries())))
            if m is None:
                quotients, quotient = _quotients(J)
                key = min(quotients)
                bars = quotients[key]
                if key not in self._keys:
                    left -= self._add(key, 2 * len(bars))
                m = self._keys[key]
                if m > n:
                    back.setdefault(m, {})[quotient(bars[0], whole)] = n
            row[m] += 1
        return row, left

    def _add(self, key: Key, units: int) -> Fraction:
        self._keys[key] = len(self._lattices)
        self._lattices.append(LatticeValue(self.ring.ambient, key[0], fmpz_mat(4, 4, key[1:])))
        self.unit_counts.append(units)
        return Fraction(2, units)

    def _neighbours(self, lattice: LatticeValue, p: int) -> Iterator[tuple[Key, int]]:
        return map(key_and_units, right_subideals(lattice, self.ring, p))

    # --- the classes -------------------------------------------------------------------------------

    def __len__(self) -> int:
        return len(self._lattices)

    def _representative(self, n: int) -> LatticeValue:
        """Return the lattice of class n, made integral and primitive."""
        found = self._lattices[n]
        return scaled(found, scalars_into(found, self.ring))

    def _index(self, lattice: LatticeValue) -> int:
        """Return the number of the class of an invertible right ideal."""
        return self._keys[key_and_units(lattice)[0]]

    @cached_property
    def types(self) -> list[int]:
        """The number of the type of each class: which left orders are isomorphic.

        For a maximal or an Eichler order they are the orbits of the two-sided ideals on the classes (Voight,
        *Quaternion Algebras*, section 17.4).
        """
        order = self.ring
        parts = factorise(order.discriminant).items()
        if not all(is_maximal_or_eichler(order, p, e) for p, e in parts):
            return types_by_isomorphism(self)
        moves = [self.exchanged_at(p) for p, _ in sorted(parts)]
        return orbits(len(self), moves)

    @cached_property
    def exchanged(self) -> list[int]:
        """Which class each becomes by the first two-sided prime ideal; itself where none is known.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(37).maximal_order().class_set().exchanged
        [0, 2, 1]
        """
        order = self.ring
        for p, e in sorted(factorise(order.discriminant).items()):
            if is_maximal_or_eichler(order, p, e):
                return self.exchanged_at(p)
        return list(range(len(self)))

    def exchanged_at(self, p: int) -> list[int]:
        """Return which class each becomes by the two-sided ideal at a prime. Raises :class:`LatticeError`.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(11).eichler_order(3).class_set().exchanged_at(3)
        [1, 0, 2, 3]
        """
        if p in self._exchanged:
            return self._exchanged[p]
        ideal, moved = two_sided_prime(self.ring, p), [-1] * len(self)
        for n, lattice in enumerate(track(self._lattices, len(self), "types")):
            if moved[n] < 0:  # the square of the ideal is a number, so this is an involution
                m = self._index(product(lattice, ideal))
                moved[n], moved[m] = m, n
        self._exchanged[p] = moved
        return moved

    @property
    def type_number(self) -> int:
        """How many isomorphism classes of orders there are in the genus."""
        return len(set(self.types))

    # --- Brandt matrices -----------------------------------------------------------------------------

    def neighbours(self, p: int) -> list[Counter[int]]:
        """Return for each class how many right ideals of relative norm p in it belong to which class.

        Raises :class:`LatticeError` for what is no prime, :class:`TooLargeError` where there are too many.
        """
        p = prime(p)
        if p not in self.rows:
            if self.ring.discriminant % p:
                _expect_few_neighbours(len(self) * (p + 1), p)
                self.rows[p] = [
                    self.neighbours_of(n, p) for n in track(range(len(self)), len(self), "rows")
                ]
            else:
                self.rows[p] = self.power_neighbours(p, 1)
        return self.rows[p]

    def neighbours_of(self, n: int, p: int) -> Counter[int]:
        """Return the same for class n alone, p off the discriminant.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(11).maximal_order().class_set().neighbours_of(0, 2)
        Counter({1: 2, 0: 1})
        """
        _expect_few_neighbours(p + 1, p)
        return Counter(self._keys[key] for key, _ in self._neighbours(self._lattices[n], p))

    def power_neighbours(self, p: int, e: int) -> list[Counter[int]]:
        """Return for each class how many right ideals of relative norm pᵉ in it belong to which class.

        In an ideal of a norm prime to p they are its intersections with those in the order.
        """
        local = of_prime_power_norm(self.ring, p, e)
        around = (prime_to(lattice, p) for lattice in self._lattices)
        return [
            Counter(self._index(meet(J, K)) for K in local)
            for J in track(around, len(self), "rows")
        ]

    def brandt_matrix(self, n: int) -> list[list[int]]:
        """Return the Brandt matrix: entry (i, j) counts the ideals of class j of relative norm n in I_i.

        Each row sums to the number of integral ideals of norm n; and entry (i, j) times the units of j is
        entry (j, i) times those of i (Pizer, 1980; Gross, 1987). Raises :class:`LatticeError`.
        """
        return brandt.brandt_matrix(self, positive(n, "index"))

    def hecke_polynomial(self, n: int) -> list[int]:
        """Return the characteristic polynomial of the Brandt matrix, low degree first."""
        return brandt.hecke_polynomial(self, positive(n, "index"))

    def hecke_operator(self, n: int, values: Sequence[Any]) -> list[Any]:
        """Return T_n(f) for a function f on the classes, given by its values: the Brandt matrix of n times f.

        Raises :class:`LatticeError` unless there is a value for each class.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra("QQ", -1, -11).maximal_order().class_set()
        >>> C.hecke_operator(2, [1, 1]), C.hecke_operator(2, [2, -3])
        ([3, 3], [-4, 6])
        """
        if len(values) != len(self):
            raise LatticeError(f"{len(values)} values were given for {len(self)} classes")
        if is_prime(positive(n, "index")):  # a row has few entries that are not 0
            rows = [list(row.items()) for row in self.neighbours(n)]
        else:
            rows = [list(enumerate(row)) for row in self.brandt_matrix(n)]
        return [sum(values[j] * times for j, times in row) for row in rows]

    def theta_series(self, i: int, j: int, n: int) -> list[int]:
        """Return the theta series, up to q^n, of the lattice between two classes.

        Its coefficient m, divided by the units of class j, is entry (i, j) of the Brandt matrix of m. Raises
        :class:`LatticeError` where there are fewer classes.
        """
        h = len(self)
        if not (-h <= i < h and -h <= j < h):
            raise LatticeError(
                f"there are {h} classes, numbered from 0: {i} and {j} are not both of them"
            )
        between = product(self._lattices[i], conjugate(self._lattices[j]))
        found: list[int] = theta_series(between, n)
        return found

    def edges(self, p: int) -> Iterator[tuple[int, int, dict[str, int]]]:
        """Yield the edges of the graph of p-neighbours, ``networkx.from_edgelist`` reads them.

        For a maximal order of prime discriminant it is the supersingular isogeny graph, up to Galois
        conjugation of the vertices (Deuring).
        """
        for i, row in enumerate(self.neighbours(p)):
            for j in sorted(row):
                yield i, j, {"weight": row[j]}

    @cached_property
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""
        return certificates.of_class_set(self.ring, self._lattices)

    @property
    def evidence(self) -> dict[str, object]:
        """What a program needs to check the class set: representatives, units, and the mass."""
        return {
            "kind": "class-set",
            "algebra": str(self.ring.algebra),
            "order": rows_json(self.ring),
            "discriminant": self.ring.discriminant,
            "mass": str(self.mass),
            "classes": [
                {**rows_json(self._representative(n)), "units": units}
                for n, units in enumerate(self.unit_counts)
            ],
        }


def types_by_isomorphism(classes: Classes) -> list[int]:
    """Return the number of the type of each class, of any order, found by comparing left orders in pairs."""
    found: list[ZOrder] = []
    kinds: list[int] = []
    for n in range(len(classes)):
        order = ZOrder.of(order_of(classes._representative(n), "left"))
        known = next(
            (n for n, other in enumerate(found) if conjugator(order, other)[0] is not None), None
        )
        if known is None:
            known = len(found)
            found.append(order)
        kinds.append(known)
    return kinds


def orbits(size: int, moves: list[list[int]]) -> list[int]:
    """Return the number of the orbit of each of some things under permutations, in order."""
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
