"""Store the representatives of ideal classes as packed rows of integers, and find their numbers by keys.

A class takes about 300 bytes over ℚ, so 10⁶ classes fit into memory. Matrices and norms are unpacked when
they are needed.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple, overload

from flint import fmpz_mat

from hfield.core.packed_integers import pack, unpack
from hfield.orders.class_keys import Key, Norm, Representative

if TYPE_CHECKING:
    from hfield.orders.basis import AlgebraBasis


class ClassRecord(NamedTuple):
    """The representative of a class: a reduced basis as rows over a denominator, and its norm."""

    rows: fmpz_mat
    den: int
    norm: Norm


class PackedClass(NamedTuple):
    """A class as bytes and integers, for storage and for other processes."""

    record: bytes
    units: int
    """[O_L(I)ˣ : Rˣ]; R are the integers of the base."""
    keys: tuple[bytes, ...]
    """Those of the shortest elements."""


class ClassStore:
    """Class records by number, units of left orders, and the class number for each key."""

    def __init__(self, ambient: AlgebraBasis) -> None:
        self._ambient = ambient
        self.packed: list[bytes] = []
        self.units = array("I")
        self._numbers: dict[bytes, int] = {}

    def __len__(self) -> int:
        return len(self.packed)

    def __getitem__(self, n: int) -> ClassRecord:
        return unpack_record(self._ambient, self.packed[n])

    def number(self, key: bytes) -> int | None:
        """Return the number of the class with a key, or None."""
        return self._numbers.get(key)

    def add(self, found: PackedClass) -> int:
        """Add a class, and return its number."""
        number = len(self)
        self.packed.append(found.record)
        self.units.append(found.units)
        for key in found.keys:
            self._numbers[key] = number
        return number

    def add_key(self, key: bytes, number: int) -> None:
        """Add one more key of a class."""
        self._numbers[key] = number


class Norms(Sequence[Norm]):
    """The norms of the representatives, read from a store."""

    def __init__(self, store: ClassStore) -> None:
        self._store = store

    def __len__(self) -> int:
        return len(self._store)

    @overload
    def __getitem__(self, n: int) -> Norm: ...
    @overload
    def __getitem__(self, n: slice) -> list[Norm]: ...
    def __getitem__(self, n: int | slice) -> Norm | list[Norm]:
        if isinstance(n, slice):
            return [self[k] for k in range(*n.indices(len(self)))]
        return self._store[n].norm

    def __iter__(self) -> Iterator[Norm]:
        return (self._store[n].norm for n in range(len(self)))


def pack_class(ambient: AlgebraBasis, found: Representative) -> PackedClass:
    """Return a representative, with its keys and its number of units, as bytes and integers."""
    number, below = ambient.base.coordinate_rows([found.norm.element]).numer_denom()
    numbers = [below, *number.entries(), found.den, *found.rows.entries()]
    record = pack([found.norm.number, *map(ambient.domain.code, numbers)])
    return PackedClass(record, found.units, tuple(pack_key(ambient, key) for key in found.keys))


def pack_key(ambient: AlgebraBasis, key: Key) -> bytes:
    """Return a key of a class as bytes."""
    return pack(list(map(ambient.domain.code, key)))


def unpack_record(ambient: AlgebraBasis, data: bytes) -> ClassRecord:
    """Return the lattice of a class packed by :func:`pack_class`."""
    domain, n, size = ambient.domain, ambient.degree, ambient.size
    number, *codes = unpack(data)
    below, *numbers = map(domain.decode, codes)
    element = ambient.base.element_of([domain.fraction(c, below) for c in numbers[:n]])
    rows = domain.matrix(size, size, numbers[n + 1 :])
    return ClassRecord(rows, numbers[n], Norm(number, element))
