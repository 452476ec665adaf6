"""Surveys of class sets over ranges of discriminants and levels: rows that are computed one by one, anywhere.

Rows are appended to a file of JSON lines as they come, whole pieces at a time; what a killed run has
left is read back, a torn last line dropped, and only what is missing is computed.
"""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Iterable, Iterator
from concurrent.futures import Executor
from math import gcd
from pathlib import Path
from typing import Any

from hfield.algebra import QuaternionAlgebra
from hfield.executors import unordered
from hfield.factorisation import factorise
from hfield.lattices import class_number

Pair = tuple[int, int]
PIECE = 8
"""Pairs that are computed at one place, one after the other."""


def definite_pairs(discriminants: Iterable[int], levels: Iterable[int]) -> list[Pair]:
    """Return the pairs (D, N) of a definite algebra and a level prime to its discriminant."""
    wanted = list(levels)
    found = []
    for d in discriminants:
        primes = factorise(d) if d > 1 else {}
        if len(primes) % 2 and max(primes.values()) == 1:
            found += [(d, n) for n in wanted if gcd(d, n) == 1]
    return found


def row(pair: Pair, most: int) -> dict[str, object]:
    """Return what is known of the classes of (D, N); they are enumerated if they are at most ``most``."""
    d, n = pair
    A = QuaternionAlgebra.from_ramification("QQ", sorted(factorise(d)))
    number = class_number.class_number(d, n)
    mass = class_number.eichler_mass(d, n)
    found: dict[str, Any] = {
        "discriminant": d,
        "level": n,
        "algebra": A.name,
        "class_number": number,
        "mass": str(mass),
        "type_number": None,
        "units": None,
    }
    if number <= most:
        C = A.eichler_order(n).class_set()
        if len(C) != number:
            raise AssertionError(
                f"{len(C)} classes were enumerated for {pair}, the formula says {number}"
            )
        found["type_number"] = C.type_number
        found["units"] = {str(u): m for u, m in sorted(Counter(C.unit_counts).items())}
    return found


def rows(task: tuple[list[Pair], int]) -> list[dict[str, object]]:
    """Return the rows of a piece."""
    pairs, most = task
    return [row(pair, most) for pair in pairs]


def run(
    executor: Executor, pairs: list[Pair], most: int, done: set[Pair]
) -> Iterator[list[dict[str, object]]]:
    """Yield the rows of the pairs that are not done, a piece at a time, as they are finished."""
    missing = [pair for pair in pairs if pair not in done]
    pieces = [(missing[n : n + PIECE], most) for n in range(0, len(missing), PIECE)]
    for _, found in unordered(executor, rows, pieces):
        yield found


class Journal:
    """A file of JSON lines that survives a kill: rows are appended, and read back whole."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def read(self) -> list[dict[str, object]]:
        """Return the rows, after cutting off a line that was torn."""
        if not self.path.exists():
            return []
        data = self.path.read_bytes()
        whole = data.rfind(b"\n") + 1
        if whole < len(data):
            with self.path.open("r+b") as file:
                file.truncate(whole)
        return [json.loads(line) for line in data[:whole].splitlines()]

    def append(self, found: list[dict[str, object]]) -> None:
        """Append rows in one write, and have them on the disk."""
        text = "".join(json.dumps(item) + "\n" for item in found)
        with self.path.open("ab") as file:
            file.write(text.encode())
            file.flush()
            os.fsync(file.fileno())
