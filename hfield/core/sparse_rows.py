"""Sparse matrices of natural numbers in compressed rows."""

from __future__ import annotations

from array import array
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, TypeVar, overload

from hfield.core.product import IntegerMultiple

if TYPE_CHECKING:
    import numpy as np

V = TypeVar("V", bound=IntegerMultiple)

MAX_ENTRY = 2**32 - 1


class SparseRows(Sequence[dict[int, int]]):
    """The rows of a matrix as dicts {column: entry} of nonzero entries, stored in 8 bytes per entry.

    It is a sequence that builds the dicts on access, with ascending columns, and equals a list of them.

    >>> rows = SparseRows([{1: 2, 0: 1}, {0: 3}])
    >>> rows[0], list(rows), rows == [{0: 1, 1: 2}, {0: 3}]
    ({0: 1, 1: 2}, [{0: 1, 1: 2}, {0: 3}], True)
    >>> rows.times([10, 1])
    [12, 30]
    """

    def __init__(self, rows: Sequence[Mapping[int, int]] = ()) -> None:
        self._starts, self._columns, self._entries = array("Q", [0]), array("I"), array("I")
        for row in rows:
            self.append(row)

    def append(self, row: Mapping[int, int]) -> None:
        """Append a row. Raises OverflowError for an entry that is negative or above MAX_ENTRY."""
        columns = sorted(n for n, entry in row.items() if entry)
        self._columns.extend(columns)
        self._entries.extend([row[n] for n in columns])
        self._starts.append(len(self._columns))

    def __len__(self) -> int:
        return len(self._starts) - 1

    @overload
    def __getitem__(self, n: int) -> dict[int, int]: ...
    @overload
    def __getitem__(self, n: slice) -> list[dict[int, int]]: ...
    def __getitem__(self, n: int | slice) -> dict[int, int] | list[dict[int, int]]:
        if isinstance(n, slice):
            return [self[k] for k in range(*n.indices(len(self)))]
        if not -len(self) <= n < len(self):
            raise IndexError(f"there are {len(self)} rows, numbered from 0: {n} is not one of them")
        n %= len(self)
        part = slice(self._starts[n], self._starts[n + 1])
        return dict(zip(self._columns[part], self._entries[part], strict=True))

    def __eq__(self, other: object) -> bool:
        if isinstance(other, SparseRows):
            mine = self._starts, self._columns, self._entries
            return mine == (other._starts, other._columns, other._entries)
        if isinstance(other, Sequence):
            return len(self) == len(other) and all(map(_equal, self, other))
        return NotImplemented

    __hash__ = None  # type: ignore[assignment]  # rows can be added

    def __repr__(self) -> str:
        return f"<{len(self)} rows, {len(self._columns)} entries that are not 0>"

    @property
    def arrays(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The starts of the rows, the columns and the entries, as in ``scipy.sparse.csr_array``.

        With ``starts, columns, entries = rows.arrays``, the scipy matrix is ``csr_array((entries, columns,
        starts))``.
        """
        import numpy as np

        found = self._starts, self._columns, self._entries
        starts, columns, entries = (np.array(x, dtype=np.int64) for x in found)
        return starts, columns, entries

    def times(self, values: Sequence[V]) -> list[V | int]:
        """Return the matrix times a column of values; an empty row gives the int 0."""
        columns, entries, ends = self._columns, self._entries, self._starts
        return [
            sum(values[columns[k]] * entries[k] for k in range(ends[n], ends[n + 1]))
            for n in range(len(self))
        ]


def _equal(row: Mapping[int, int], other: object) -> bool:
    return row == other
