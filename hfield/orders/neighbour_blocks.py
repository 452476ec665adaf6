"""Compute the neighbours of many classes in blocks, on any executor.

A block is computed in two steps: first the keys of all neighbours of its classes, then the representatives of
the new classes among them. Both steps consist of independent tasks. New classes are numbered here, in the
order of the rows and of the neighbours in a row, so the numbers do not depend on the executor. The keys of
the next block are computed at the same time.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor, Future
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from hfield.core.packed_integers import pack, unpack
from hfield.core.sparse_rows import SparseRows
from hfield.orders.base_values import Prime
from hfield.orders.class_keys import ClassKeys, Reduced, SublatticeKeys
from hfield.orders.class_store import ClassRecord, PackedClass, pack_class, pack_key, unpack_record
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.neighbours import neighbours_at, two_sided_at

if TYPE_CHECKING:
    from hfield.orders.classes import Classes

ROWS_A_PIECE = 64
PIECES_A_BLOCK = 16
ROWS_A_BLOCK = ROWS_A_PIECE * PIECES_A_BLOCK


class Neighbour(NamedTuple):
    """A neighbour in the form sent between processes: its key, and coordinates of a reduced basis."""

    key: bytes
    coordinates: bytes


class Block(NamedTuple):
    """A block of rows of consecutive classes whose keys are being computed."""

    first: int
    stop: int
    keys: list[Future[list[tuple[int, list[Neighbour]]]]]


T = TypeVar("T")
Rows = tuple[LatticeValue, Prime, list[tuple[int, bytes]]]
"""A piece of the first step: an order, a prime, and numbers and records of classes."""
Unknown = tuple[LatticeValue, Prime, Prime, list[tuple[bytes, bytes]]]
"""A piece of the second step: an order, a prime, that of the exchange, records with coordinates."""


@lru_cache(maxsize=16)
def class_keys(order: LatticeValue) -> ClassKeys:
    """Return the data shared by the keys of right ideals of an order."""
    return ClassKeys(order)


def around(keys: ClassKeys, record: ClassRecord, prime: Prime) -> SublatticeKeys:
    """Return the keys of the right ideals of relative norm P in the representative of a class."""
    ideal = keys.ambient.base.prime_ideal(prime)
    return SublatticeKeys(keys, record.rows, record.den, keys.multiplied(record.norm, ideal))


def neighbours_inside(
    keys: ClassKeys, record: ClassRecord, prime: Prime
) -> Iterator[tuple[SublatticeKeys, Reduced]]:
    """Yield the right ideals of relative norm P in the representative of a class, by reduced bases."""
    whole = around(keys, record, prime)
    for coordinates in neighbours_at(keys.order, prime).inside(whole, record.norm):
        yield whole, whole.reduced(coordinates)


def keys_of_rows(task: Rows) -> list[tuple[int, list[Neighbour]]]:
    """Return the neighbours of classes, with the numbers of these classes."""
    order, prime, records = task
    keys, out = class_keys(order), []
    for n, data in records:
        record = unpack_record(keys.ambient, data)
        row = [
            Neighbour(
                pack_key(keys.ambient, whole.key(basis)),
                pack(list(map(keys.ambient.domain.code, basis.coordinates.entries()))),
            )
            for whole, basis in neighbours_inside(keys, record, prime)
        ]
        out.append((n, row))
    return out


def partner_inside(
    keys: ClassKeys, record: ClassRecord, prime: Prime
) -> tuple[SublatticeKeys, Reduced]:
    """Return the product of a representative with the two-sided ideal of norm P, by a reduced basis."""
    whole = around(keys, record, prime)
    coordinates = next(two_sided_at(keys.order, prime).inside(whole, record.norm))
    return whole, whole.reduced(coordinates)


def found_class(
    keys: ClassKeys, whole: SublatticeKeys, basis: Reduced, exchange: Prime
) -> Iterator[PackedClass]:
    """Yield the representative of a class and, if a prime is given, that of the class exchanged with it."""
    found = pack_class(keys.ambient, whole.representative(basis))
    yield found
    if exchange is not None:
        record = unpack_record(keys.ambient, found.record)
        other, exchanged = partner_inside(keys, record, exchange)
        yield pack_class(keys.ambient, other.representative(exchanged))


def representatives(task: Unknown) -> list[list[PackedClass]]:
    """Return the representatives of the classes of neighbours, as :func:`found_class` does."""
    order, prime, exchange, pairs = task
    keys, out = class_keys(order), []
    size = keys.ambient.size
    for data, coordinates in pairs:
        whole = around(keys, unpack_record(keys.ambient, data), prime)
        entries = list(map(keys.ambient.domain.decode, unpack(coordinates)))
        basis = whole.with_coordinates(keys.ambient.domain.matrix(size, size, entries))
        out.append(list(found_class(keys, whole, basis, exchange)))
    return out


class BlockSearch:
    """Adds rows of neighbours at a prime, in blocks that an executor computes."""

    def __init__(
        self, classes: Classes, prime: Prime, executor: Executor, rows: SparseRows
    ) -> None:
        self.classes, self.prime, self.executor, self.rows = classes, prime, executor, rows

    def blocks(self, wanted: Callable[[], bool]) -> Iterator[int]:
        """Add rows while they are wanted; yield the number of known rows after each block.

        New classes are added as they are found; their rows follow.
        """
        block = self._begin(len(self.rows))
        while block.stop > block.first:
            found = {n: row for future in block.keys for n, row in future.result()}
            unknown = self._unknown(found)
            futures = [
                self.executor.submit(
                    representatives,
                    (self.classes.order, self.prime, self.classes.exchange_prime, some),
                )
                for some in _pieces(list(unknown.values()), 1 + len(unknown) // PIECES_A_BLOCK)
            ]
            next_block = self._begin(block.stop)
            new = [some for future in futures for some in future.result()]
            known = dict(zip(unknown, new, strict=True))
            for n in range(block.first, block.stop):
                row = self.classes.exchanged_row(n, self.prime)
                if row is None:
                    numbers = (self.classes.number_of(x.key, known.__getitem__) for x in found[n])
                    row = Counter(numbers)
                self.rows.append(row)
            yield len(self.rows)
            if not wanted():
                for future in next_block.keys:
                    future.cancel()
                return
            block = next_block if next_block.stop > next_block.first else self._begin(block.stop)

    def _begin(self, first: int) -> Block:
        """Begin to compute the keys of a block of rows."""
        store = self.classes.store
        stop = min(first + ROWS_A_BLOCK, len(store))
        numbers = [n for n in range(first, stop) if self.classes.has_own_row(n, self.prime)]
        futures = [
            self.executor.submit(
                keys_of_rows, (self.classes.order, self.prime, [(n, store.packed[n]) for n in some])
            )
            for some in _pieces(numbers, ROWS_A_PIECE)
        ]
        return Block(first, stop, futures)

    def _unknown(self, rows: Mapping[int, list[Neighbour]]) -> dict[bytes, tuple[bytes, bytes]]:
        """Return the first neighbour with each new key, and the class that it is a neighbour of."""
        found: dict[bytes, tuple[bytes, bytes]] = {}
        store = self.classes.store
        for n, row in rows.items():
            for key, coordinates in row:
                if key not in found and store.number(key) is None:
                    found[key] = store.packed[n], coordinates
        return found


def _pieces(items: list[T], size: int) -> Iterator[list[T]]:
    """Yield the pieces of a list, of a given size."""
    return (items[n : n + size] for n in range(0, len(items), size))
