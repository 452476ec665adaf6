"""Neighbours of many classes at a time, in blocks that any executor computes.

A block is computed in two steps: keys of all neighbours of its classes, then the representatives of the
classes of those keys that are not known yet. Both are lists of independent pieces. New classes get their
numbers here, in the order of the rows and of the neighbours in a row, so that numbers do not depend on the
executor. The keys of the next block are computed meanwhile.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from flint import fmpz_mat

from hfield.core.packed_integers import pack, unpack
from hfield.orders.class_keys import ClassKeys, Reduced, SublatticeKeys
from hfield.orders.class_store import PackedClass, Record, pack_class, unpack_record
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.neighbours import neighbours_at

if TYPE_CHECKING:
    from hfield.orders.classes import Classes

ROWS_A_PIECE = 64
PIECES_A_BLOCK = 16
ROWS_A_BLOCK = ROWS_A_PIECE * PIECES_A_BLOCK


class Neighbour(NamedTuple):
    """A neighbour as it is sent between processes: a key of it, and coordinates of a reduced basis."""

    key: bytes
    coordinates: bytes


class Block(NamedTuple):
    """The rows of consecutive classes, from a first one, whose keys are being computed."""

    first: int
    records: list[bytes]
    keys: list[Future[list[list[Neighbour]]]]


Rows = tuple[LatticeValue, Any, list[bytes]]
"""A piece of the first step: an order, a prime, and records of classes."""
Unknown = tuple[LatticeValue, Any, list[tuple[bytes, bytes]]]
"""A piece of the second step: an order, a prime, and pairs of a record and coordinates of a neighbour."""


@lru_cache(maxsize=16)
def class_keys(order: LatticeValue) -> ClassKeys:
    """Return what the keys of right ideals of an order have in common."""
    return ClassKeys(order)


def around(keys: ClassKeys, record: Record, prime: Any) -> SublatticeKeys:
    """Return the keys of the right ideals of relative norm P in one that represents a class."""
    ideal = keys.ambient.base.prime_ideal(prime)
    return SublatticeKeys(keys, record.rows, record.den, keys.multiplied(record.norm, ideal))


def neighbours_inside(
    keys: ClassKeys, record: Record, prime: Any
) -> Iterator[tuple[SublatticeKeys, Reduced]]:
    """Yield the right ideals of relative norm P in one, by reduced bases."""
    whole = around(keys, record, prime)
    for coordinates in neighbours_at(keys.order, prime).inside(whole, record.norm):
        yield whole, whole.reduced(coordinates)


def keys_of_rows(task: Rows) -> list[list[Neighbour]]:
    """Return the neighbours of classes."""
    order, prime, records = task
    keys = class_keys(order)
    out = []
    for data in records:
        record = unpack_record(keys.ambient, data)
        out.append(
            [
                Neighbour(pack(whole.key(basis)), pack(list(map(int, basis.coordinates.entries()))))
                for whole, basis in neighbours_inside(keys, record, prime)
            ]
        )
    return out


def representatives(task: Unknown) -> list[PackedClass]:
    """Return the representatives of the classes of neighbours."""
    order, prime, pairs = task
    keys, out = class_keys(order), []
    size = keys.ambient.size
    for data, coordinates in pairs:
        whole = around(keys, unpack_record(keys.ambient, data), prime)
        basis = whole.with_coordinates(fmpz_mat(size, size, unpack(coordinates)))
        out.append(pack_class(keys.ambient, whole.representative(basis)))
    return out


def rows_in_blocks(
    classes: Classes, prime: Any, executor: Executor, first: int, wanted: Callable[[], bool]
) -> Iterator[list[Counter[int]]]:
    """Yield the rows of the classes from ``first`` on, a block at a time, as long as they are wanted.

    New classes are added to those given as they are found; their rows follow.
    """

    def begin(start: int) -> Block:
        records = classes.store.packed[start : start + ROWS_A_BLOCK]
        pieces = [(classes.order, prime, some) for some in _pieces(records, ROWS_A_PIECE)]
        return Block(start, records, [executor.submit(keys_of_rows, piece) for piece in pieces])

    block = begin(first)
    while block.records:
        rows = [row for future in block.keys for row in future.result()]
        found = _unknown(classes, block, rows)
        pieces = [
            (classes.order, prime, some)
            for some in _pieces(list(found.values()), 1 + len(found) // PIECES_A_BLOCK)
        ]
        futures = [executor.submit(representatives, piece) for piece in pieces]
        following = begin(block.first + len(rows))
        new = dict(
            zip(found, (some for future in futures for some in future.result()), strict=True)
        )
        yield [Counter(classes.number_of(x.key, new.__getitem__) for x in row) for row in rows]
        if not wanted():
            for future in following.keys:
                future.cancel()
            return
        block = following if following.records else begin(following.first)


def _unknown(
    classes: Classes, block: Block, rows: list[list[Neighbour]]
) -> dict[bytes, tuple[bytes, bytes]]:
    """Return the first neighbour with each key of no known class, and the class that it lies in."""
    found: dict[bytes, tuple[bytes, bytes]] = {}
    for record, row in zip(block.records, rows, strict=True):
        for key, coordinates in row:
            if key not in found and classes.store.number(key) is None:
                found[key] = record, coordinates
    return found


def _pieces(items: list[Any], size: int) -> Iterator[list[Any]]:
    """Yield a list in pieces of a size."""
    return (items[n : n + size] for n in range(0, len(items), size))
