"""Enumerate the invertible right ideal classes of an order in a totally definite algebra.

Classes are looked up by keys, which are lattices in the class (:mod:`hfield.orders.class_keys`), and not
compared in pairs. The enumeration starts from O and adds neighbours at primes until the masses of the classes
found add up to the mass of the order. Then no class is missing (M. Kirschmer and J. Voight, *SIAM J. Comput.*
39, 2010; J. Voight, *Quaternion Algebras*, main theorem 26.1.5). Neighbours at one prime do not reach all
classes if there are several narrow classes, or if not every local unit of the base is the norm of a local
unit.

In large sets the class of I·J, for a two-sided prime ideal J, is found together with the class of I. The
product with J permutes the classes, and this permutation turns the rows of neighbours of I into those of I·J.
So only half of the neighbours are looked up. Rows of Brandt matrices are stored by prime, and later calls
continue them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from typing import TYPE_CHECKING

from flint import fmpq

from hfield.algebra.quaternion import Parent
from hfield.core.executors import InProcess
from hfield.core.progress import report, track
from hfield.core.properties import cached_property
from hfield.core.sparse_rows import SparseRows
from hfield.errors import TooLargeError, shorten
from hfield.orders.base_values import BaseIdeal, BaseNumber, Prime
from hfield.orders.class_keys import Norm, Reduced, SublatticeKeys
from hfield.orders.class_store import ClassStore, Norms, PackedClass, pack_key
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
from hfield.orders.mass_formula import mass
from hfield.orders.neighbour_blocks import (
    BlockSearch,
    class_keys,
    found_class,
    neighbours_inside,
    partner_inside,
)
from hfield.orders.neighbours import Neighbours, generator_above, neighbours_at
from hfield.orders.standard_orders import eichler_order

if TYPE_CHECKING:
    from hfield.orders.class_file import ClassFile

MAX_CLASSES = 1_000_000
"""Sets of more classes than this are not enumerated; over ℚ they take five minutes and half a gigabyte."""
MIN_EXCHANGED_MASS = 1_000
"""From this mass on a class is followed by the one that a two-sided prime ideal makes of it."""
MAX_NEIGHBOURS = 500_000
"""The largest number of ideals of prime norm that are listed in one."""
MAX_LISTED_NEIGHBOURS = 20_000_000
"""The largest number of ideals of prime norm that are listed in all classes together, in about an hour."""


class Classes:
    """The classes as values: lattices, norms, units of left orders, and neighbours.

    Neighbours are computed here or by an executor. A file stores the results, so that an interrupted run can
    resume.
    """

    def __init__(
        self, order: LatticeValue, executor: Executor | None = None, file: ClassFile | None = None
    ) -> None:
        self.order, self.ambient = order, order.ambient
        self.mass = mass(order)
        if self.mass > MAX_CLASSES:
            raise TooLargeError(
                f"the mass is {shorten(self.mass)}, so there are more than {MAX_CLASSES} classes: too many "
                "to enumerate; over QQ A.class_number(N) counts those of Eichler orders by Eichler's formula"
            )
        self.keys = class_keys(order)
        self.store = ClassStore(self.ambient)
        self._rows: dict[Prime, SparseRows] = {}
        self._exchanged: dict[Prime, list[int]] = {}
        self._left = fmpq(self.mass.numerator, self.mass.denominator)
        """The mass of the classes that are not known yet."""
        self.exchange_prime = self._find_exchange_prime()
        """A prime whose two-sided ideal gives each class another one, in large sets; else None."""
        if self.exchange_prime is not None:
            self._exchanged[self.exchange_prime] = []
        self._file = file
        self._new: list[PackedClass] = []
        """The last classes, which are not in the file yet."""
        self._saved: dict[Prime, int] = {}
        """How many rows of a prime are in the file."""
        self.class_of(self.order)
        if file is not None:
            file.read(self)
            self._new.clear()
        self._enumerate(executor)

    def _enumerate(self, executor: Executor | None) -> None:
        whole = float(self.mass)
        for prime in good_primes(self.order):
            if not self._left:
                return
            self._expect_few_neighbours(1, prime)
            for _ in self._more_rows(prime, executor, lambda: bool(self._left)):
                report(whole - int(self._left.p) / int(self._left.q), whole, "the classes")

    def _find_exchange_prime(self) -> Prime | None:
        """Return a prime whose two-sided ideal, of this norm, acts as an involution on the classes."""
        base = self.ambient.base
        if self.mass < MIN_EXCHANGED_MASS or base.class_generators:
            return None
        factors = base.factorisation(discriminant(self.order))
        return next((P for P, e in factors if e == 1), None)

    def __len__(self) -> int:
        return len(self.store)

    @property
    def units(self) -> Sequence[int]:
        """The index [O_L(I)ˣ : Rˣ] for each class, where R is the ring of integers of the base."""
        return self.store.units

    @property
    def norms(self) -> Sequence[Norm]:
        """The norms of the representatives of the classes."""
        return Norms(self.store)

    def lattice(self, n: int) -> LatticeValue:
        """Return the lattice that represents class n; it contains the order."""
        record = self.store[n]
        return hermite_form(self.ambient, record.den, record.rows)

    # --- looking up --------------------------------------------------------------------------------

    def class_of(self, lattice: LatticeValue) -> int:
        """Return the number of the class of an invertible right ideal."""
        return self._class_of(lattice, self.keys.norm_of(lattice.norm))

    def _class_of(self, lattice: LatticeValue, norm: Norm) -> int:
        around = SublatticeKeys(self.keys, lattice.matrix, lattice.den, norm)
        return self._look_up(around, around.reduced(self.ambient.identity))

    def _look_up(self, around: SublatticeKeys, basis: Reduced) -> int:
        """Return the class number of a sublattice; the class may be new."""
        return self.number_of(
            pack_key(self.ambient, around.key(basis)),
            lambda _: found_class(self.keys, around, basis, self.exchange_prime),
        )

    def number_of(self, key: bytes, found: Callable[[bytes], Iterable[PackedClass]]) -> int:
        """Return the class number of a key; the class may be new.

        ``found`` yields the class of the key, then the class exchanged with it, if an exchange prime is used.
        """
        number = self.store.number(key)
        if number is None:
            several = iter(found(key))
            first = next(several)
            number = self.store.number(first.keys[0])  # if one key of a class is known, all are
            if number is None:
                number = self._add(first)
                for other in several:
                    known = self.store.number(other.keys[0])
                    self._set_exchanged(number, self._add(other) if known is None else known)
            self.store.add_key(key, number)
        return number

    def _add(self, found: PackedClass) -> int:
        """Add a new class, and return its number."""
        self._left -= fmpq(1, found.units)
        if self._left < 0:
            raise AssertionError("the classes found exceed the mass")
        if self._file is not None:
            self._new.append(found)
        return self.store.add(found)

    def _set_exchanged(self, n: int, m: int) -> None:
        """Record that two classes are exchanged."""
        moved = self._exchanged[self.exchange_prime]
        moved += [-1] * (len(self) - len(moved))
        moved[n], moved[m] = m, n

    # --- neighbours --------------------------------------------------------------------------------

    def _expect_few_neighbours(self, rows: int, prime: Prime) -> None:
        """Raise :class:`TooLargeError` before starting a list of neighbours that is too long."""
        base = self.ambient.base
        one = base.absolute_norm(base.prime_ideal(prime)) + 1
        for count, most in ((one, MAX_NEIGHBOURS), (rows * one, MAX_LISTED_NEIGHBOURS)):
            if count > most:
                raise TooLargeError(
                    f"{count} ideals of relative norm {prime} would be listed, and at most {most} are; "
                    "expected a smaller prime"
                )

    def _more_rows(
        self, prime: Prime, executor: Executor | None, wanted: Callable[[], bool]
    ) -> Iterator[int]:
        """Add rows of neighbours while they are wanted and incomplete; yield the number of known rows.

        An interrupted loop is continued.
        """
        rows = self._rows.setdefault(prime, SparseRows())
        if executor is None and self._file is None:
            while wanted() and len(rows) < len(self):
                n = len(rows)
                rows.append(self.exchanged_row(n, prime) or self.neighbours_of(n, prime))
                yield len(rows)
            return
        for done in BlockSearch(self, prime, executor or InProcess(), rows).blocks(wanted):
            if self._file is not None:
                self._save(self._file, prime)
            yield done

    def _save(self, file: ClassFile, prime: Prime) -> None:
        """Write those rows of a prime, and those classes, that are not in the file yet."""
        rows, first = self._rows[prime], self._saved.get(prime, 0)
        numbers = range(len(self) - len(self._new), len(self))
        new = list(zip(numbers, map(self._exchange_of, numbers), self._new, strict=True))
        file.append(self.ambient.base, prime, first, rows[first:], new)
        self._new.clear()
        self._saved[prime] = len(rows)

    def _exchange_of(self, n: int) -> int | None:
        """Return the class exchanged with class n, if an exchange prime is used."""
        return None if self.exchange_prime is None else self._exchanged[self.exchange_prime][n]

    def has_own_row(self, n: int, prime: Prime) -> bool:
        """Return whether the row of class n is computed directly, rather than from an earlier row."""
        other = self._exchange_of(n)
        return other is None or other >= n or prime == self.exchange_prime

    def exchanged_row(self, n: int, prime: Prime) -> Counter[int] | None:
        """Return the row of class n from that of its exchange partner, or None if the partner comes after n.

        The exchange commutes with the Brandt matrices of other primes.
        """
        if self.has_own_row(n, prime):
            return None
        moved = self._exchanged[self.exchange_prime]
        return Counter({moved[j]: times for j, times in self._rows[prime][moved[n]].items()})

    def restore_class(self, number: int, exchanged: int | None, found: PackedClass) -> None:
        """Add a class from a file, unless it is known. Raises ValueError if it is out of sequence."""
        if number < len(self):  # it was written twice, about an interrupt
            return
        if number > len(self) or self.store.number(found.keys[0]) is not None:
            raise ValueError(f"class {number} is out of order")
        if exchanged not in (
            (None,) if self.exchange_prime is None else range(number - 1, number + 2)
        ):
            raise ValueError(f"class {number} is not exchanged with class {exchanged}")
        self._add(found)
        if exchanged is not None and exchanged <= number:
            self._set_exchanged(number, exchanged)

    def restore_rows(self, prime: Prime, first: int, rows: Sequence[Mapping[int, int]]) -> None:
        """Add the rows that follow the known ones. Raises ValueError if they are not rows of neighbours."""
        found, count = self._rows.setdefault(prime, SparseRows()), len(self.at_prime(prime))
        if first > len(found):
            raise ValueError(f"row {first} of the prime {prime} follows row {len(found)}")
        if len(self._exchanged.get(self.exchange_prime, self.units)) != len(self):
            raise ValueError("an exchanged class is missing")
        for row in rows[len(found) - first :]:
            if sum(row.values()) != count or max(row) >= len(self):
                raise ValueError(
                    f"row {len(found)} of the prime {prime} is not a row of neighbours"
                )
            found.append(row)
        self._saved[prime] = len(found)

    def neighbours(self, prime: Prime, executor: Executor | None = None) -> SparseRows:
        """Return, for each class, the right ideals of relative norm P inside its representative, counted by
        their classes.

        Raises :class:`TooLargeError` if there are too many.
        """
        rows = self._rows.get(prime, SparseRows())
        if len(rows) < len(self):
            self._expect_few_neighbours(len(self) - len(rows), prime)
            for done in self._more_rows(prime, executor, lambda: True):
                report(done, len(self), "rows")
        return self._rows[prime]

    def has_rows(self, prime: Prime) -> bool:
        """Return whether all neighbours at a prime are known."""
        return len(self._rows.get(prime, ())) == len(self)

    def neighbours_of(self, n: int, prime: Prime) -> Counter[int]:
        """Return the numbers of ideals of relative norm P inside class n, by class."""
        self._expect_few_neighbours(1, prime)
        return Counter(self.classes_inside(n, prime))

    def classes_inside(self, n: int, prime: Prime) -> list[int]:
        """Return the classes of the ideals of relative norm P in class n, ordered as in :meth:`at_prime`."""
        return [self._look_up(around, basis) for around, basis in self.sublattices(n, prime)]

    def sublattices(self, n: int, prime: Prime) -> Iterator[tuple[SublatticeKeys, Reduced]]:
        """Yield the ideals of relative norm P in class n, by reduced bases."""
        return neighbours_inside(self.keys, self.store[n], prime)

    def class_keys(self, n: int) -> SublatticeKeys:
        """Return the keys for sublattices of class n with the norm of class n, that is, for the lattice
        itself.
        """
        record = self.store[n]
        return SublatticeKeys(self.keys, record.rows, record.den, record.norm)

    def at_prime(self, prime: Prime) -> Neighbours:
        """Return the right ideals of norm P."""
        return neighbours_at(self.order, prime)

    def local_norm(self, n: int, prime: Prime) -> BaseNumber:
        """Return N(x)/ν, where x generates a lattice of class n at the primes above the prime number below P,
        and the lattice has norm ν·a.
        """
        norm, base = self.norms[n], self.ambient.base
        x = generator_above(self.class_keys(n), base.place(prime).below, norm)
        return (base.field.one if x is None else x.norm) / norm.element

    # --- permutations ------------------------------------------------------------------------------

    def moved(self, by: Callable[[LatticeValue], LatticeValue], norm: BaseIdeal) -> list[int]:
        """Return the class that each class becomes when a change of lattices multiplies norms by an ideal."""
        return [self._moved(n, by, norm) for n in range(len(self))]

    def _moved(self, n: int, by: Callable[[LatticeValue], LatticeValue], norm: BaseIdeal) -> int:
        return self._class_of(by(self.lattice(n)), self.keys.multiplied(self.norms[n], norm))

    def multiplied(self, ideal: BaseIdeal) -> list[int]:
        """Return the permutation of the classes that multiplication by an ideal of the base induces."""
        if not self.ambient.base.class_generators:  # it is principal
            return list(range(len(self)))
        return self.moved(partial(times_ideal, ideal=ideal), ideal * ideal)

    @cached_property
    def central(self) -> list[list[int]]:
        """The permutations of the classes by ideals that generate the class group of the base."""
        return [self.multiplied(a) for a in self.ambient.base.class_generators]

    def exchanged(self, prime: Prime) -> list[int]:
        """Return the class that each class becomes by the two-sided prime ideal at a prime.

        Raises :class:`LatticeError` if the order is neither maximal nor Eichler there.
        """
        if prime not in self._exchanged:
            ideal = two_sided_prime(self.order, prime)
            is_short = ideal.norm == self.ambient.base.prime_ideal(prime)
            involution, found = not self.ambient.base.class_generators, [-1] * len(self)
            for n in track(range(len(self)), len(self), "types"):
                if found[n] < 0:
                    if is_short:
                        moved = self._look_up(*partner_inside(self.keys, self.store[n], prime))
                    else:
                        moved = self._moved(n, lambda x: product(x, ideal), ideal.norm)
                    found[n] = moved
                    if involution:  # the square of the ideal is generated by a number
                        found[moved] = n
            self._exchanged[prime] = found
        return self._exchanged[prime]

    @cached_property
    def types(self) -> list[int]:
        """The type of each class, as a number: classes with isomorphic left orders have the same type.

        Types are the orbits of the invertible two-sided ideals on the classes (Voight, section 18.5). These
        ideals are those of the base and, for maximal and Eichler orders, one at each prime of the
        discriminant. For other orders the left orders are compared.
        """
        base = self.ambient.base
        if is_eichler(self.order):
            primes = [P for P, _ in base.factorisation(discriminant(self.order))]
            return orbits(len(self), [*self.central, *map(self.exchanged, primes)])
        return types_by_isomorphism(self)


def types_by_isomorphism(classes: Classes) -> list[int]:
    """Return the type of each class, for any order, by comparing left orders in pairs."""
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
    """Return the orbit number of each of 0, …, size − 1 under permutations.

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
    """Renumber values from 0 in order of first occurrence."""
    numbers: dict[int, int] = {}
    return [numbers.setdefault(kind, len(numbers)) for kind in kinds]


class EichlerClasses:
    """The classes of Eichler orders of an algebra, by their levels."""

    def __init__(self, algebra: Parent) -> None:
        self.algebra = algebra
        self._found: dict[BaseIdeal, Classes] = {}

    def __call__(self, level: BaseIdeal) -> Classes:
        """Return the classes of an Eichler order of a level."""
        if level not in self._found:
            self._found[level] = Classes(eichler_order(self.algebra, level))
        return self._found[level]
