"""Short sequences of integers as bytes, several times smaller than tuples of Python's integers."""

from __future__ import annotations

from array import array
from collections.abc import Sequence

CODES = "bhiq"
"""The types of :mod:`array` for integers of 1, 2, 4 and 8 bytes."""
LONG = b"x"
"""The first byte where an integer needs more than 8 bytes; the integers follow in hexadecimal digits."""


def pack(numbers: Sequence[int]) -> bytes:
    """Pack integers as bytes of the least common width. Equal sequences give equal bytes.

    >>> len(pack([1, -2, 300])), unpack(pack([1, -2, 300])), unpack(pack([2**70, -1]))
    (7, [1, -2, 300], [1180591620717411303424, -1])
    """
    for code in CODES:
        try:
            return code.encode() + array(code, numbers).tobytes()
        except OverflowError:
            continue
    return LONG + " ".join(map("{:x}".format, numbers)).encode()


def unpack(data: bytes) -> list[int]:
    """Return the integers packed by :func:`pack`."""
    if data[:1] == LONG:
        return [int(word, 16) for word in data[1:].split()]
    found = array(data[:1].decode())
    found.frombytes(data[1:])
    return found.tolist()
