"""Array addresses, and a pool that reuses the buffers of collected results.

The system provides large memory page by page, and clears each page on first touch, which takes about as long
as a typical product. So the memory of results that were collected is kept for later results of the same size,
up to `KEPT` bytes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from contextlib import suppress
from math import prod
from typing import TypeAlias
from weakref import finalize

import numpy as np

Array: TypeAlias = np.ndarray
Rows = tuple[Array, ...]

POOLED_BYTES = 1_000_000  # bytes; freed pieces are returned to the system
KEPT = 5 << 24
_kept: deque[Array] = deque()  # the last given back at the end


class _Lent:
    """The base of an array in a pooled buffer; it is collected when its last view is."""

    def __init__(self, memory: Array) -> None:
        self.__array_interface__ = memory.__array_interface__
        finalize(self, _give_back, memory).atexit = False


def block(shape: Sequence[int], dtype: str) -> tuple[Array, bool]:
    """Return an uninitialised array, and whether its memory has been used before."""
    size = prod(shape) * np.dtype(dtype).itemsize
    if not POOLED_BYTES <= size <= KEPT:
        return np.empty(shape, dtype), False
    used = _taken(size)
    memory = np.empty(size, np.uint8) if used is None else used
    return np.asarray(_Lent(memory))[:size].view(dtype).reshape(shape), used is not None


def _taken(size: int) -> Array | None:
    """Take a pooled buffer of at least that size, and not much more."""
    for _ in range(len(_kept)):
        try:
            memory = _kept.pop()
        except IndexError:  # another thread took it
            return None
        if size <= memory.nbytes <= size + size // 4:
            return memory
        _kept.appendleft(memory)
    return None


def _give_back(memory: Array) -> None:
    """Return a buffer to the pool, replacing the oldest one."""
    _kept.append(memory)
    # a copy, because another thread, or the garbage collector in between, may change the list
    while sum(m.nbytes for m in _kept.copy()) > KEPT:
        with suppress(IndexError):
            _kept.popleft()


def rows_of(block: Array) -> Rows:
    """Return the rows of an array as arrays, 0-dimensional if necessary."""
    return tuple(block[n, ...] for n in range(len(block)))


def in_one_piece(array: Array, shape: tuple[int, ...]) -> Array:
    """Return a C-contiguous array of this shape: the given one if possible, else a copy."""
    wide = array if array.shape == shape else np.broadcast_to(array, shape)
    straight = wide.flags.c_contiguous and wide.flags.aligned
    return wide if straight else np.require(wide, requirements=["C", "A"])


def address(array: Array) -> int:
    """Return the address of the first entry."""
    place: int = array.__array_interface__["data"][0]
    return place
